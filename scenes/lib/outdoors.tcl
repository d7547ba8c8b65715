# What stands round a house, and the sun: used by house.gr. Lengths are in metres. What makes nodes takes the path of
# their parent.

namespace eval outdoors {
    # A row of roof tiles along y, each a cone that is a little wider at its far end, where it lies on the next. By
    # `more` each is wider than the one before. Their materials are drawn from a list.
    proc tiles {parent count radius more materials} {
        for {set i 0} {$i < $count} {incr i} {
            set tile [gr_cone $parent tile$i [list 0 [expr {0.4 * $i}] 0] $radius 0.44 [expr {$radius + 0.027}]]
            gr_surfaceproperty $tile [lindex $materials [expr {int([llength $materials] * rand())}]]
            set radius [expr {$radius + $more}]
        }
    }

    # A bush or a cypress: small balls of about `size` round a large one. From each to the next they turn by the golden
    # angle, which spreads them evenly.
    proc plant {parent radius height count size} {
        gr_sphere $parent core
        gr_translate $parent:core [list 0 [expr {0.5 * $height}] 0]
        gr_scale $parent:core [list [expr {0.75 * $radius}] [expr {0.47 * $height}] [expr {0.75 * $radius}]]
        for {set i 0} {$i < $count} {incr i} {
            set y [expr {2 * ($i + 0.5) / $count - 1}]
            set r [expr {$radius * sqrt(1 - $y * $y) * (1 - 0.3 * $y) * (0.8 + 0.3 * rand())}]
            gr_sphere $parent leaf$i [list [expr {$r * cos(2.4 * $i)}] [expr {0.5 * $height * (1 + $y)}] \
                [expr {$r * sin(2.4 * $i)}]] [expr {$size * (0.6 + 0.8 * rand())}]
        }
    }

    # A lounger along z, whose head is at -z.
    proc lounger {parent wood cushion} {
        gr_surfaceproperty [gr_box $parent frame {-0.33 0.2 -1} {0.66 0.08 2}] $wood
        foreach x {-0.33 0.26} {
            foreach z {-0.95 0.88} {
                gr_surfaceproperty [gr_box $parent #auto [list $x 0 $z] {0.07 0.2 0.07}] $wood
            }
        }
        gr_surfaceproperty [gr_box $parent seat {-0.28 0.28 -0.45} {0.56 0.1 1.43}] $cushion
        gr_surfaceproperty [gr_box $parent back {-0.28 0 -0.75} {0.56 0.1 0.75}] $cushion
        gr_translate $parent:back {0 0.28 -0.4}
        gr_rotate $parent:back x 35
    }

    # The sun: point lights on a disc across the way to x y z, for shadows that are a little soft. So would a lamp's be,
    # but now and then a path would meet it by way of water, and leave a bright speck. Returns the lights' names.
    proc sun {x y z radius colour} {
        set count 20
        set level [expr {hypot($x, $z)}]
        foreach part $colour {lappend each [expr {double($part) / $count}]}
        for {set i 0} {$i < $count} {incr i} {
            set r [expr {$radius * sqrt(($i + 0.5) / $count)}]
            set aside [expr {$r * cos(2.4 * $i)}]
            lappend lights [gr_light #auto [list [expr {$x + $aside * $z / $level}] [expr {$y + $r * sin(2.4 * $i)}] \
                [expr {$z - $aside * $x / $level}]] $each {1 0 0}]
        }
        return $lights
    }
}
