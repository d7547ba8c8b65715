# Vectors {x y z} for clay.tcl, and rotations of them.

namespace eval clay {
    proc minus {a b} {lmap p $a q $b {expr {$p - $q}}}
    # a + factor * b
    proc plus {a factor b} {lmap p $a q $b {expr {$p + $factor * $q}}}
    proc dot {a b} {
        lassign $a x y z
        lassign $b u v w
        expr {$x * $u + $y * $v + $z * $w}
    }
    proc cross {a b} {
        lassign $a x y z
        lassign $b u v w
        list [expr {$y * $w - $z * $v}] [expr {$z * $u - $x * $w}] [expr {$x * $v - $y * $u}]
    }
    proc unit {a} {
        set length [expr {sqrt([dot $a $a])}]
        lmap p $a {expr {$p / $length}}
    }

    # What x, y and z become, for angles in degrees.
    proc axes {nod turn tilt} {
        set result {}
        foreach axis {{1 0 0} {0 1 0} {0 0 1}} {
            lassign $axis x y z
            lassign [spin $nod $y $z] y z
            lassign [spin $turn $z $x] z x
            lassign [spin $tilt $x $y] x y
            lappend result [list $x $y $z]
        }
        return $result
    }

    proc spin {degrees a b} {
        set angle [expr {$degrees * acos(-1) / 180}]
        list [expr {cos($angle) * $a - sin($angle) * $b}] [expr {sin($angle) * $a + cos($angle) * $b}]
    }

    # x, y and z times the three axes of a frame.
    proc along {frame x y z} {
        lassign $frame u v w
        lmap a $u b $v c $w {expr {$a * $x + $b * $y + $c * $z}}
    }
}
