# No sample may be infinite or not a number: every scene of scenes/ by the path integrator, rendered in small, and how
# many samples were dropped. Exits with 1 if any was.
# Words: how many samples all scenes get together, 10^7 unless told otherwise; the names of scenes; none: all.
# Environment: OPTIONS, more options for gr_render, e.g. "lanes float".
# Seen to fail with the infinite density of camera rays weighed against a light's: infinity by infinity.

source [file join [file dirname [info script]] .. support render_words.tcl]
set folder [file normalize [file join [file dirname [info script]] .. .. scenes]]
set longerSide 256 ;# pixels, the longer one

set all [lassign $argv wanted]
if {$wanted eq {}} {set wanted 1e7}
if {![string is double -strict $wanted] || !($wanted >= 1 && $wanted < 1e15)} {
    puts stderr "samples must be a number from 1 to 1e15, not \"$wanted\""
    exit 1
}
set names [expr {[llength $all] > 0 ? $all : [lmap file [lsort [glob -directory $folder *.gr]] {file rootname [file tail $file]}]}]
foreach scene $names {
    if {![file exists [file join $folder $scene.gr]]} {puts stderr "no scene \"$scene\" in scenes/"; exit 1}
}

# What the scene's gr_render would render, with as many samples as are its share of those that are left.
rename gr_render renderWhole
proc gr_render {node file width height eye view up fov args} {
    lassign [renderWords $args] tail options
    set scale [expr {double($::longerSide) / max($width, $height)}]
    set size [list [expr {int($width * $scale)}] [expr {int($height * $scale)}]]
    set pixels [expr {[lindex $size 0] * [lindex $size 1]}]
    set share [expr {($::wanted - $::samples) / double($::left)}]
    foreach option {noise time layers startline stopline} {set options [dict remove $options $option]}
    set fixed [list integrator path antialiasing on accelerator auto progress off seed $::left \
        samplesperpixel [expr {max(1, int(ceil($share / $pixels)))}]]
    if {[info exists ::env(OPTIONS)]} {lappend fixed {*}$::env(OPTIONS)}
    set picture [file join [expr {[info exists ::env(TMPDIR)] ? $::env(TMPDIR) : "/tmp"}] finite-[pid].pfm]
    try {
        set result [renderWhole $node $picture {*}$size $eye $view $up $fov {*}$tail {*}[dict merge $options $fixed]]
    } finally {
        file delete $picture
    }
    set rays [tcl::mathop::+ {*}[dict values [dict get $result rays]]]
    puts [format "%-16s %11d samples  %12d rays  %d dropped" $::scene [dict get $result samples] $rays \
        [dict get $result dropped]]
    flush stdout
    incr ::samples [dict get $result samples]
    incr ::rays $rays
    incr ::dropped [dict get $result dropped]
    return $result
}

lassign {0 0 0} samples rays dropped
set left [llength $names]
foreach scene $names {
    gr_reset
    source [file join $folder $scene.gr]
    incr left -1
}
puts [format "%-16s %11d samples  %12d rays  %d dropped" {all scenes} $samples $rays $dropped]
exit [expr {$dropped > 0}]
