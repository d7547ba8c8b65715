# Faces that shine. A flat rectangle is a gr_als_planar: it shines from the side that it is counter-clockwise seen from.

# The corners of a part's faces; of two triangles with a common edge those of the four-sided face that they make.
proc obj2gr::wholeFaces {faces} {
    set whole {}
    foreach face $faces {
        set corners [lmap corner $face {lindex $corner 0}]
        set joined [joined [lindex $whole end] $corners]
        if {$joined eq ""} {lappend whole $corners} else {lset whole end $joined}
    }
    return $whole
}

proc obj2gr::joined {a b} {
    if {[llength $a] != 3 || [llength $b] != 3} {return ""}
    set other [lmap corner $b {if {$corner in $a} {continue}; set corner}]
    if {[llength $other] != 1} {return ""}
    foreach turn {{0 1 2} {1 2 0} {2 0 1}} {
        lassign [lmap i $turn {lindex $a $i}] p q r
        if {$p ni $b} {return [list $p $q {*}$other $r]}
    }
}

# Whether four places are a rectangle, but for roundings.
proc obj2gr::isRectangle {places} {
    if {[llength $places] != 4} {return 0}
    lassign $places a b c d
    set u [minus $b $a]
    set v [minus $d $a]
    set length [expr {max([size $u], [size $v])}]
    expr {min([size $u], [size $v]) > 1e-6 * $length && [size [minus [plus $a $c] [plus $b $d]]] < 1e-4 * $length
        && abs([dot $u $v]) < 1e-4 * [size $u] * [size $v]}
}

# The lamps of a part, a list of the places of each one's corners; none if any of its faces is no rectangle.
proc obj2gr::lampsOf {faces vertices} {
    set lamps {}
    foreach corners [wholeFaces $faces] {
        set places [lmap corner $corners {lindex $vertices $corner}]
        if {![isRectangle $places]} {return {}}
        lappend lamps $places
    }
    return $lamps
}

# gr_als_planar lies in the x-z plane and shines along -y.
proc obj2gr::lampLines {name radiance places} {
    lassign $places a b c d
    set u [minus $b $a]
    set v [minus $d $a]
    set x [unit $u]
    set y [unit [cross $v $u]]
    set z [cross $x $y]
    set node :model:$name
    set lines [list "gr_als_planar :model $name {[shown $radiance]} {0 0 0} 1" \
        "gr_translate $node {[shown [times [plus $a $c] 0.5]]}"]
    lassign [turns $x $y $z] turn(x) turn(y) turn(z)
    foreach axis {y x z} {
        if {$turn($axis) != 0} {lappend lines "gr_rotate $node $axis $turn($axis)"}
    }
    lappend lines "gr_scale $node {[shown [list [size $u] 1 [size $v]]]}"
}

# Degrees about x, y and z that turn the axes to x, y and z: about z first, about y last.
proc obj2gr::turns {x y z} {
    set sine [expr {max(-1.0, min(1.0, -[lindex $z 1]))}]
    if {abs($sine) > 1 - 1e-9} {
        # Looking along y, turns about y and z do the same.
        set angles [list [expr {asin($sine)}] [expr {atan2(-[lindex $x 2], [lindex $x 0])}] 0]
    } else {
        set angles [list [expr {asin($sine)}] [expr {atan2([lindex $z 0], [lindex $z 2])}] \
            [expr {atan2([lindex $x 1], [lindex $y 1])}]]
    }
    shown [lmap angle $angles {expr {$angle * 180 / acos(-1)}}]
}
