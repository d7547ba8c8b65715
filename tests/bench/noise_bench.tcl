# Every scene of scenes/, rendered in small: the relative error that gr_render estimates, beside the true one, which is
# measured against a picture with many more samples and another seed. Both are roots of means over some seeds.
# Words: the names of scenes; none: all. Environment: OPTIONS, more options for gr_render, e.g. "integrator path".

source [file join [file dirname [info script]] .. support render_words.tcl]
source [file join [file dirname [info script]] .. support relative_error.tcl]
set folder [file normalize [file join [file dirname [info script]] .. .. scenes]]
set longerSide 48 ;# pixels, the longer one
set reference 2048 ;# samples per pixel
set requests {{samplesperpixel 16} {samplesperpixel 64} {samplesperpixel 100} {noise 0.1 samplesperpixel 256}}
set seeds {1 2 3 4}

rename gr_render renderWhole
proc gr_render {node file width height eye view up fov args} {
    lassign [renderWords $args] tail options
    set scale [expr {double($::longerSide) / max($width, $height)}]
    set size [list [expr {int($width * $scale)}] [expr {int($height * $scale)}]]
    set name [file join [expr {[info exists ::env(TMPDIR)] ? $::env(TMPDIR) : "/tmp"}] noise-bench-[pid]]
    foreach option {samplesperpixel noise time layers} {set options [dict remove $options $option]}
    set fixed [list accelerator auto progress off]
    if {[info exists ::env(OPTIONS)]} {lappend fixed {*}$::env(OPTIONS)}
    set options [dict merge $options $fixed]
    set command [list renderWhole $node $name.pfm {*}$size $eye $view $up $fov {*}$tail]
    {*}$command {*}[dict merge $options [list samplesperpixel $::reference seed 999]]
    set converged [radiances $name.pfm]
    foreach request $::requests {
        set trueSum 0.
        set estimatedSum 0.
        set ratios {}
        foreach seed $::seeds {
            set result [{*}$command {*}[dict merge $options $request [list seed $seed]]]
            set true [relativeError [radiances $name.pfm] $converged]
            set estimated [dict get $result noise]
            set trueSum [expr {$trueSum + $true ** 2}]
            set estimatedSum [expr {$estimatedSum + $estimated ** 2}]
            lappend ratios [expr {$estimated / $true}]
        }
        set count [llength $::seeds]
        puts [format "%-16s %-31s %3d samples  true %7.4f  estimated %7.4f  ratio %5.2f  (%.2f to %.2f)" $::scene $request \
            [dict get $result samplesperpixel] [expr {sqrt($trueSum / $count)}] [expr {sqrt($estimatedSum / $count)}] \
            [expr {sqrt($estimatedSum / $trueSum)}] [tcl::mathfunc::min {*}$ratios] [tcl::mathfunc::max {*}$ratios]]
        flush stdout
    }
    file delete $name.pfm
    return $result
}

set names [expr {$argc > 0 ? $argv : [lmap file [lsort [glob -directory $folder *.gr]] {file rootname [file tail $file]}]}]
foreach scene $names {
    gr_reset
    source [file join $folder $scene.gr]
}
