# A photographer's studio: a chequered floor under a large lamp, in a grey room that has no walls. The scenes that show
# single materials share it: shirley.gr, dielectric.gr, reflective.gr, refractive.gr and importance.gr.

namespace eval studio {
    gr_material light diffuse diffuse {0.75 0.72 0.66}
    gr_material dark  diffuse diffuse {0.16 0.19 0.24}

    # Square tiles, of side 1.6, in two meshes: one of the light tiles and one of the dark ones.
    proc floor {parent} {
        set count 12
        set half [expr {$count / 2}]
        for {set i 0} {$i <= $count} {incr i} {
            for {set k 0} {$k <= $count} {incr k} {
                lappend corners [list [expr {1.6 * ($k - $half)}] 0 [expr {1.6 * ($i - $half)}]]
            }
        }
        for {set i 0} {$i < $count} {incr i} {
            for {set k 0} {$k < $count} {incr k} {
                set a [expr {$i * ($count + 1) + $k}]
                set b [expr {$a + $count + 1}]
                lappend tiles([expr {($i + $k) % 2}]) [list $a $b [expr {$b + 1}] [expr {$a + 1}]]
            }
        }
        gr_surfaceproperty [gr_polyhedron $parent lightTiles $corners $tiles(0)] light
        gr_surfaceproperty [gr_polyhedron $parent darkTiles $corners $tiles(1)] dark
    }

    # A ball of radius 1 that stands on the floor.
    proc ball {parent name x material} {
        set ball [gr_sphere $parent $name [list $x 1 0] 1]
        gr_surfaceproperty $ball $material
        return $ball
    }

    # The floor, and a lamp above it on the left, before the balls.
    proc build {parent} {
        floor $parent
        gr_als_planar $parent lamp {6 5.6 5} {-3 6 2} 4
    }

    # Renders everything, seen from a little above. Large lamps and a grey sky leave little noise.
    proc render {file width height fov args} {
        gr_render : $file $width $height {0 3.4 9} {0 -0.28 -1} {0 1 0} $fov globalillumination on antialiasing on \
            pathlength 8 background {0.35 0.38 0.42} {*}$args
    }
}
