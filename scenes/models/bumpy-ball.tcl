# A ball of clay with bumps all over it: sourced, it gives a mesh of as many triangles as one likes, which is made so
# soon that no file of it is kept.

namespace eval bumpy {
    # A unit ball's vertices and faces, for gr_polyhedron. It has 8 n^2 triangles: from pole to equator n rings, of
    # which the k-th has 4 k vertices, at such a height that all triangles would be as large if there were no bumps.
    proc ball {n} {
        set vertices {}
        set faces {}
        for {set ring 0} {$ring <= 2 * $n} {incr ring} {
            set k [expr {min($ring, 2 * $n - $ring)}]
            set y [expr {1 - double($k) ** 2 / $n ** 2}]
            set width [expr {sqrt(max(0, 1 - $y * $y))}]
            if {$ring > $n} {set y [expr {-$y}]}
            set first [llength $vertices]
            set count [expr {max(1, 4 * $k)}]
            for {set i 0} {$i < $count} {incr i} {
                set angle [expr {2 * acos(-1) * $i / $count}]
                lappend vertices [bulge [expr {$width * cos($angle)}] $y [expr {$width * sin($angle)}]]
            }
            if {$ring > $n} {
                stitch faces $k $first $count [expr {$k + 1}] $before $countBefore 1
            } elseif {$ring > 0} {
                stitch faces [expr {$k - 1}] $before $countBefore $k $first $count 0
            }
            set before $first
            set countBefore $count
        }
        list $vertices $faces
    }

    # The triangles between a ring of 4 k vertices and the next one, towards the equator, of 4 (k + 1). Each quarter of
    # the wider ring has one triangle more. Where the pole is below, they are turned round.
    proc stitch {faces k inner innerCount outerK outer outerCount below} {
        upvar 1 $faces result
        for {set quarter 0} {$quarter < 4} {incr quarter} {
            for {set i 0} {$i <= $k} {incr i} {
                set a [expr {$inner + ($quarter * $k + $i) % $innerCount}]
                set p [expr {$outer + $quarter * $outerK + $i}]
                set q [expr {$outer + ($quarter * $outerK + $i + 1) % $outerCount}]
                lappend result [expr {$below ? [list $a $p $q] : [list $a $q $p]}]
                if {$i == $k} continue
                set b [expr {$inner + ($quarter * $k + $i + 1) % $innerCount}]
                lappend result [expr {$below ? [list $a $q $b] : [list $a $b $q]}]
            }
        }
    }

    # Moves a place on the unit sphere out or in: large bumps, and small ones on them.
    proc bulge {x y z} {
        set large [expr {sin(7 * $x + 1) * sin(7 * $y + 2) * sin(7 * $z)}]
        set small [expr {sin(31 * $x) * sin(31 * $y + 1) * sin(31 * $z + 2)}]
        set r [expr {1 + 0.14 * $large + 0.025 * $small}]
        list [expr {$r * $x}] [expr {$r * $y}] [expr {$r * $z}]
    }
}
