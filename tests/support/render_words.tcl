# What stands behind fov in a gr_render command: {ambient and lights, or ambient, or nothing} {option value ...}.
# Options come in pairs.
proc renderWords {words} {
    set options [expr {[llength [lindex $words 0]] == 3 ? 2 - [llength $words] % 2 : 0}]
    list [lrange $words 0 $options-1] [lrange $words $options end]
}
