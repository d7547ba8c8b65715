# grsh figure5.1.tcl SIDE...: measures the report's figure 5.1, and prints it as CSV. Each SIDE is a square of
# SIDE x SIDE balls, see scenes/lib/performance.tcl, rendered with each accelerator by one thread. Times are medians
# of several runs. The picture goes into the current folder.
source [file join [file dirname [info script]] .. .. scenes lib performance.tcl]

set accelerators {off grid embree}
# The figure's caption in tools/figure5.1 tells these, too.
set size 64
set options {samplesperpixel 4 threads 1}
set passes 5
set runs_each_pass 3
set enough_seconds 5

proc median {values} { lindex [lsort -real $values] [expr {[llength $values] / 2}] }

# Renders the scene that there is, with one accelerator after the other and then again from the first. What has taken
# long enough is not repeated. The results go to results(side,accelerator).
proc render {side} {
    global results spent
    for {set run 0} {$run < $::runs_each_pass} {incr run} {
        foreach accelerator $::accelerators {
            set key $side,$accelerator
            if {[info exists spent($key)] && $spent($key) > $::enough_seconds} continue
            set result [performance::render balls.png $::size accelerator $accelerator {*}$::options \
                integrator report progress off]
            lappend results($key) $result
            set spent($key) [expr {[dict get $result seconds] + ([info exists spent($key)] ? $spent($key) : 0)}]
        }
    }
}

# Only times of the same work can be compared.
proc check_rays {side} {
    set rays [lmap accelerator $::accelerators {dict get [lindex $::results($side,$accelerator) 0] rays}]
    if {[llength [lsort -unique $rays]] > 1} {
        error "$side x $side balls: not the same rays with each of $::accelerators: $rays"
    }
}

# One line of the CSV.
proc row {side accelerator} {
    set results $::results($side,$accelerator)
    foreach result $results {
        lappend build [dict get $result build]
        lappend render [dict get $result rendering]
    }
    set bytes [expr {[dict get $result memory scene] + [dict get $result memory accelerator]}]
    join [list [expr {$side * $side}] $accelerator [format %.3g [median $build]] [format %.3g [median $render]] \
        [llength $results] [tcl::mathop::+ {*}[dict values [dict get $result rays]]] \
        [format %.2f [dict get $result tests]] [format %.2f [dict get $result cells]] $bytes] ,
}

# In passes, so that what disturbs the machine for a while disturbs a few runs of everything, and no median.
for {set pass 1} {$pass <= $passes} {incr pass} {
    foreach side $argv {
        puts stderr "pass $pass of $passes: [expr {$side * $side}] spheres"
        gr_reset
        performance::scene square $side
        render $side
        check_rays $side
    }
}
puts spheres,accelerator,build_seconds,render_seconds,runs,rays,tests_per_ray,cells_per_ray,bytes
foreach side $argv {
    foreach accelerator $accelerators {puts [row $side $accelerator]}
}
