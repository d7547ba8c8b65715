# Many balls: the scenes that the report measured its acceleration with (figure 5.1). performance2x2.gr and its like show
# a square of n x n balls, which fills the same part of the picture whatever n is.

namespace eval performance {
    # n x n balls in the square from -1 to 1, which faces the camera.
    proc square {parent n} {
        set spacing [expr {2. / $n}]
        set radius [expr {0.4 * $spacing}]
        for {set row 0} {$row < $n} {incr row} {
            set y [expr {($row + 0.5) * $spacing - 1}]
            for {set column 0} {$column < $n} {incr column} {
                set x [expr {($column + 0.5) * $spacing - 1}]
                gr_sphere $parent ${row}x$column [list $x $y 0] $radius
            }
        }
    }

    # n x n x n balls in the cube from -1 to 1.
    proc cube {parent n} {
        set spacing [expr {2. / $n}]
        for {set layer 0} {$layer < $n} {incr layer} {
            set z [expr {($layer + 0.5) * $spacing - 1}]
            for {set row 0} {$row < $n} {incr row} {
                set y [expr {($row + 0.5) * $spacing - 1}]
                for {set column 0} {$column < $n} {incr column} {
                    set x [expr {($column + 0.5) * $spacing - 1}]
                    gr_sphere $parent ${layer}x${row}x$column [list $x $y $z] [expr {0.4 * $spacing}]
                }
            }
        }
    }

    # The balls of one of the two, and a lamp in front of them.
    proc scene {shape n} {
        gr_material ball shirley diffuse {0.5 0.2 0.12} specular {0.06 0.06 0.06} exp {200 200}
        gr_transform : balls
        gr_surfaceproperty :balls ball
        $shape :balls $n
        gr_als_planar : lamp {9 8.5 8} {-1.5 3 2.5} 1.5
    }

    # The picture of such a scene. Returns what gr_render does.
    proc render {file size args} {
        gr_render : $file $size $size {0 0 5} {0 0 -1} {0 1 0} 26 globalillumination on antialiasing on \
            background {0.3 0.35 0.45} {*}$args
    }

    # Both.
    proc picture {shape n file size args} {
        scene $shape $n
        render $file $size {*}$args
    }
}
