# Modelling in clay: lumps that are smoothed into each other or pressed out of each other. surface.tcl makes a mesh of
# them.
#
# A place is {x y z}. The last word of most commands is how far the new lump is smoothed into what is there before it.

source [file join [file dirname [info script]] vectors.tcl]
source [file join [file dirname [info script]] shapes.tcl]

namespace eval clay {
    # Of each its shape (see shapes.tcl), how far it is smoothed, and 1 if it is added or -1 if it is pressed out.
    variable lumps {}
    variable sign 1
    variable sides {1}    ;# the sign of x for each copy of what is made
    variable frame {{1 0 0} {0 1 0} {0 0 1}}
    variable pivot {0 0 0}

    # What the script makes is there twice: as it says, and mirrored in the plane x = 0.
    proc both {script} {
        variable sides {1 -1}
        uplevel 1 $script
        set sides {1}
    }

    # What the script makes is pressed out instead of added.
    proc pressed {script} {
        variable sign -1
        uplevel 1 $script
        set sign 1
    }

    # What the script makes is turned about a place: nodded about x, then turned about y, then tilted about z.
    proc turned {about nod turn tilt script} {
        variable pivot $about
        variable frame
        set before $frame
        set frame [axes $nod $turn $tilt]
        uplevel 1 $script
        set frame $before
    }

    # Where a place comes to lie: first by `both`, then by `turned`.
    proc place {point side} {
        variable frame
        variable pivot
        lassign $point x y z
        plus $pivot 1 [along $frame {*}[minus [list [expr {$side * $x}] $y $z] $pivot]]
    }

    proc add {shape smooth} {
        variable lumps
        variable sign
        lappend lumps [list $shape $smooth $sign]
    }

    # A bone: all balls on the way from one to another, each {x y z radius}.
    proc bone {from to smooth} {
        variable sides
        foreach side $sides {
            add [boneShape {*}[placeBalls [list $from $to] $side]] $smooth
        }
    }

    proc placeBalls {balls side} {lmap ball $balls {list {*}[place [lrange $ball 0 2] $side] [lindex $ball 3]}}

    # More balls on a smooth curve through balls: a Catmull-Rom spline, each way between two of them cut in `cuts`.
    proc curve {balls cuts} {
        set ends [list [lindex $balls 0] {*}$balls [lindex $balls end]]
        set result [list [lindex $balls 0]]
        for {set i 1} {$i < [llength $balls]} {incr i} {
            lassign [lrange $ends $i-1 $i+2] p q r s
            for {set k 1} {$k <= $cuts} {incr k} {
                set t [expr {double($k) / $cuts}]
                lappend result [lmap a $p b $q c $r d $s {
                    set square [expr {2 * $a - 5 * $b + 4 * $c - $d}]
                    set cube [expr {3 * ($b - $c) + $d - $a}]
                    expr {$b + $t * ($c - $a + $t * ($square + $t * $cube)) / 2}
                }]
            }
        }
        return $result
    }

    # Bones along a curve.
    proc limb {balls cuts smooth} {
        variable sides
        foreach side $sides {add [chain [placeBalls [curve $balls $cuts] $side]] $smooth}
    }

    proc chain {balls} {
        set bones [lmap from [lrange $balls 0 end-1] to [lrange $balls 1 end] {
            # Enough that no joint shows, and not so much that thin ones swell.
            set radius [lindex $from 3]
            set between [minus $to $from]
            list [boneShape $from $to] [expr {min(0.4 * $radius, [dot $between $between] / (2 * $radius))}] 1
        }]
        shape {distance @bones $x $y $z} [list @bones [list $bones]]
    }

    # A furrow along a curve, as wide as its balls, whose centres are moved onto the surface of what is there.
    proc furrow {balls cuts smooth} {
        variable sides
        variable lumps
        set there $lumps
        foreach side $sides {
            set path [lmap ball [placeBalls [curve $balls $cuts] $side] {
                list {*}[onto $there [lrange $ball 0 2]] [lindex $ball 3]
            }]
            pressed {add [chain $path] $smooth}
        }
    }

    # Thorns in a row on the surface of what is there, near each ball but the first and the last, and as high as that
    # ball's radius. They lean towards the next one.
    proc thorns {balls thickness lean smooth} {
        variable lumps
        set there $lumps
        set balls [placeBalls $balls 1]
        foreach before [lrange $balls 0 end-2] ball [lrange $balls 1 end-1] after [lrange $balls 2 end] {
            set height [lindex $ball 3]
            set root [onto $there [lrange $ball 0 2]]
            set up [unit [slope $there $root]]
            # Along the surface.
            set on [minus [lrange $after 0 2] [lrange $before 0 2]]
            set on [unit [plus $on [expr {-[dot $on $up]}] $up]]
            set root [plus $root [expr {-$thickness}] $up]
            set half [expr {0.55 * $height}]
            set tip [plus [plus $root $height $up] [expr {$lean * $height}] $on]
            add [webShape [plus $root [expr {-$half}] $on] [plus $root $half $on] $tip $thickness] $smooth
        }
    }

    # An egg: an ellipsoid of three radii, nodded, turned and tilted by degrees.
    proc egg {centre radii turns smooth} {
        variable sides
        variable frame
        foreach side $sides {
            set axes [lmap axis [axes {*}$turns] {
                lassign $axis x y z
                along $frame [expr {$side * $x}] $y $z
            }]
            add [eggShape [place $centre $side] $axes $radii] $smooth
        }
    }

    # A web: a triangle, made thick by a radius.
    proc web {p q r radius smooth} {
        variable sides
        foreach side $sides {add [webShape [place $p $side] [place $q $side] [place $r $side] $radius] $smooth}
    }

    # How far a place is from the surface of some of the lumps together. Where two are about as near, the surface runs
    # in a smooth curve from one to the other.
    proc distance {lumps x y z} {
        set far 1e3
        foreach lump $lumps {
            lassign $lump name smooth sign
            set near [$name $x $y $z]
            if {$sign > 0} {
                set overlap [expr {$smooth - abs($far - $near)}]
                if {$near < $far} {set far $near}
                if {$overlap > 0} {set far [expr {$far - $overlap * $overlap / (4 * $smooth)}]}
            } else {
                set overlap [expr {$smooth - abs($far + $near)}]
                if {-$near > $far} {set far [expr {-$near}]}
                if {$overlap > 0} {set far [expr {$far + $overlap * $overlap / (4 * $smooth)}]}
            }
        }
        return $far
    }

    # The direction in which that distance grows, of about length 1.
    proc slope {lumps point} {
        lassign $point x y z
        set h 0.005
        set result {}
        foreach {dx dy dz} [list $h 0 0  0 $h 0  0 0 $h] {
            set beyond [distance $lumps [expr {$x + $dx}] [expr {$y + $dy}] [expr {$z + $dz}]]
            set before [distance $lumps [expr {$x - $dx}] [expr {$y - $dy}] [expr {$z - $dz}]]
            lappend result [expr {($beyond - $before) / (2 * $h)}]
        }
        return $result
    }

    # A step of Newton's method from a place to the surface.
    proc towards {lumps point} {
        set slope [slope $lumps $point]
        plus $point [expr {-[distance $lumps {*}$point] / ([dot $slope $slope] + 1e-9)}] $slope
    }

    # A place of the surface near a place.
    proc onto {lumps point} {
        for {set i 0} {$i < 8} {incr i} {set point [towards $lumps $point]}
        return $point
    }
}
