# What a script ends with: light, and the picture.

# A camera that looks at the box from the right, above, so that all of it is in the picture; and, if the model has no
# lamp, one above the camera's left.
proc obj2gr::viewLines {low high picture hasLamps} {
    set centre [times [plus $low $high] 0.5]
    set radius [expr {[size [minus $high $low]] / 2}]
    set fov 35
    set slope [expr {tan($fov * acos(-1) / 360)}]
    set back [unit {0.5 0.4 1}]
    set right [unit [cross {0 1 0} $back]]
    set up [cross $back $right]
    set distance 0
    foreach x [list [lindex $low 0] [lindex $high 0]] {
        foreach y [list [lindex $low 1] [lindex $high 1]] {
            foreach z [list [lindex $low 2] [lindex $high 2]] {
                set corner [minus [list $x $y $z] $centre]
                set aside [expr {max(abs([dot $corner $right]) * 3 / 4, abs([dot $corner $up])) / $slope}]
                set distance [expr {max($distance, $aside + [dot $corner $back])}]
            }
        }
    }
    set lines [list "" "# Light: the sky's, and that of the lamps."]
    if {!$hasLamps} {
        set at [plus $centre [times [unit {-0.3 1 0.6}] [expr {3 * $radius}]]]
        lappend lines "gr_als_planar :model lamp {7 7 6.5} {0 0 0} [format %.9g [expr {2 * $radius}]]" \
            "gr_translate :model:lamp {[shown $at]}" \
            "gr_rotate :model:lamp y [format %.9g [expr {atan2(-0.3, 0.6) * 180 / acos(-1)}]]" \
            "gr_rotate :model:lamp x [format %.9g [expr {atan2(hypot(0.3, 0.6), 1) * 180 / acos(-1)}]]" ""
    }
    set eye [plus $centre [times $back [expr {1.1 * $distance}]]]
    lappend lines "gr_render :model [list $picture] 640 480 \\" \
        "    {[shown $eye]} {[shown [times $back -1]]} {0 1 0} $fov \\" \
        "    globalillumination on antialiasing on pathlength 8 samplesperpixel 64 \\" \
        "    background {0.35 0.38 0.42}" ""
}
