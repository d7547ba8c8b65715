# The shapes of clay.tcl's lumps. Each is a proc that tells how far a place x y z is from the shape's surface, negative
# inside.

namespace eval clay {
    variable count 0    ;# of shapes so far

    # Makes such a proc. In its body words that begin with @ stand for numbers.
    proc shape {body numbers} {
        variable count
        set name ::clay::shape[incr count]
        proc $name {x y z} [string map $numbers $body]
        return $name
    }

    # All balls on the way from one to another, each {x y z radius}.
    proc boneShape {from to} {
        lassign $from ax ay az radius
        lassign $to bx by bz thin
        set length [expr {sqrt(($bx - $ax) ** 2 + ($by - $ay) ** 2 + ($bz - $az) ** 2)}]
        # The surface leans towards the thinner end: its normal has this sine against the bone.
        set sine [expr {($radius - $thin) / $length}]
        if {abs($sine) > 0.99} {error "one end of the bone {$from} {$to} lies in the other"}
        shape {
            set x [expr {$x - @ax}]; set y [expr {$y - @ay}]; set z [expr {$z - @az}]
            set t [expr {@ux * $x + @uy * $y + @uz * $z}]
            set across2 [expr {$x * $x + $y * $y + $z * $z - $t * $t}]
            set across [expr {$across2 > 0 ? sqrt($across2) : 0.}]
            # The ball that is nearest, and how far its centre is.
            set s [expr {$t - $across * @slope}]
            if {$s < 0} {set s 0.} elseif {$s > @length} {set s @length}
            expr {hypot($across, $t - $s) - @radius + @sine * $s}
        } [list @ax $ax @ay $ay @az $az @ux [expr {($bx - $ax) / $length}] @uy [expr {($by - $ay) / $length}] \
            @uz [expr {($bz - $az) / $length}] @length $length @radius $radius @sine $sine \
            @slope [expr {$sine / sqrt(1 - $sine * $sine)}]]
    }

    # An ellipsoid. The distance is nearly right near the surface, which is where it counts.
    proc eggShape {centre axes radii} {
        set numbers {}
        foreach axis {x y z} number $centre {lappend numbers @o$axis $number}
        foreach name {u v w} axis $axes radius $radii {
            lassign $axis x y z
            lappend numbers @${name}x [expr {$x / $radius}] @${name}y [expr {$y / $radius}] \
                @${name}z [expr {$z / $radius}] @${name}r $radius
        }
        shape {
            set x [expr {$x - @ox}]; set y [expr {$y - @oy}]; set z [expr {$z - @oz}]
            # The place, were the ellipsoid a ball of radius 1; and how much faster distances grow there.
            set u [expr {@ux * $x + @uy * $y + @uz * $z}]
            set v [expr {@vx * $x + @vy * $y + @vz * $z}]
            set w [expr {@wx * $x + @wy * $y + @wz * $z}]
            set away [expr {sqrt($u * $u + $v * $v + $w * $w)}]
            set growth [expr {sqrt(($u / @ur) ** 2 + ($v / @vr) ** 2 + ($w / @wr) ** 2)}]
            expr {$away * ($away - 1) / ($growth + 1e-9)}
        } $numbers
    }

    # A triangle, made thick by a radius.
    proc webShape {p q r radius} {
        # In the triangle's own frame its corners are {0 0}, {qu 0} and {cu cv}.
        set u [unit [minus $q $p]]
        set c [minus $r $p]
        set w [unit [cross $u $c]]
        set v [cross $w $u]
        shape {
            set x [expr {$x - @ox}]; set y [expr {$y - @oy}]; set z [expr {$z - @oz}]
            set u [expr {@ux * $x + @uy * $y + @uz * $z}]
            set v [expr {@vx * $x + @vy * $y + @vz * $z}]
            set w [expr {@wx * $x + @wy * $y + @wz * $z}]
            if {$v >= 0 && $u * @cv >= $v * @cu && ($u - @qu) * @cv <= $v * @bu} {
                # Right above or below the triangle.
                expr {abs($w) - @radius}
            } else {
                set nearest 1e3
                foreach {from du dv length} {0 1 0 @qu 0 @cx @cy @cl @qu @bx @by @bl} {
                    set e [expr {$u - $from}]
                    set s [expr {$e * $du + $v * $dv}]
                    if {$s < 0} {set s 0.} elseif {$s > $length} {set s $length}
                    set away [expr {hypot($e - $s * $du, $v - $s * $dv)}]
                    if {$away < $nearest} {set nearest $away}
                }
                expr {hypot($nearest, $w) - @radius}
            }
        } [webNumbers $p $u $v $w [dot $u [minus $q $p]] [dot $u $c] [dot $v $c] $radius]
    }

    proc webNumbers {a u v w qu cu cv radius} {
        set bu [expr {$cu - $qu}]
        set cl [expr {hypot($cu, $cv)}]
        set bl [expr {hypot($bu, $cv)}]
        set numbers [list @radius $radius @qu $qu @cu $cu @cv $cv @bu $bu @cl $cl @bl $bl \
            @cx [expr {$cu / $cl}] @cy [expr {$cv / $cl}] @bx [expr {$bu / $bl}] @by [expr {$cv / $bl}]]
        foreach name {o u v w} vector [list $a $u $v $w] {
            foreach axis {x y z} number $vector {lappend numbers @$name$axis $number}
        }
        return $numbers
    }
}
