# What the shell itself costs: starting, beside tclsh, and a million nodes made in a loop.

proc median {values} { lindex [lsort -real $values] [expr {[llength $values] / 2}] }

# Starts both on an empty script, in turn, and compares the medians.
set empty [file join [file dirname [info nameofexecutable]] empty.gr]
close [open $empty w]
foreach round [lrepeat 41 0] {
    foreach program [list [info nameofexecutable] tclsh] {
        lappend times($program) [lindex [time {exec $program $empty}] 0]
    }
}
file delete $empty
foreach program [array names times] {
    puts [format "start/%-38s %8.2f ms" [file tail $program] [expr {[median $times($program)] / 1000.}]]
}

# Memory that is in use, in bytes.
proc resident {} {
    set file [open /proc/self/statm]
    set pages [lindex [read $file] 1]
    close $file
    expr {$pages * 4096}
}

# The command is written out: what Tcl itself keeps for it is the same for each node.
set before [resident]
set last 0
foreach target {250000 500000 750000 1000000} {
    set start [clock microseconds]
    for {set i $last} {$i < $target} {incr i} { gr_sphere : s$i [list $i 0 0] 0.5 }
    set each [expr {([clock microseconds] - $start) / double($target - $last)}]
    puts [format "spheres/%-36s %8.2f us each, %.0f bytes each" "$last to $target" $each \
        [expr {([resident] - $before) / double($target)}]]
    set last $target
}
set start [clock milliseconds]
gr_print
puts [format "spheres/%-36s %8.2f s" "print 1000000" [expr {([clock milliseconds] - $start) / 1000.}]]
set start [clock milliseconds]
gr_reset
puts [format "spheres/%-36s %8.2f s" "reset 1000000" [expr {([clock milliseconds] - $start) / 1000.}]]
