# Vectors are lists of three numbers.
namespace eval obj2gr {
    proc plus {a b} {lmap x $a y $b {expr {$x + $y}}}
    proc minus {a b} {lmap x $a y $b {expr {$x - $y}}}
    proc times {a s} {lmap x $a {expr {$x * $s}}}
    proc dot {a b} {
        lassign $a ax ay az
        lassign $b bx by bz
        expr {$ax * $bx + $ay * $by + $az * $bz}
    }
    proc cross {a b} {
        lassign $a ax ay az
        lassign $b bx by bz
        list [expr {$ay * $bz - $az * $by}] [expr {$az * $bx - $ax * $bz}] [expr {$ax * $by - $ay * $bx}]
    }
    proc size {a} {expr {sqrt([dot $a $a])}}
    proc unit {a} {times $a [expr {1.0 / [size $a]}]}

    # As text, as exact as a float is.
    proc shown {numbers} {lmap x $numbers {format %.9g [expr {$x + 0.0}]}}
}
