# Every scene of scenes/ with each accelerator: which is fastest, and how near `auto` comes to it. The times are those of
# rendering alone, the least of some runs that take turns; pictures are smaller than the scenes ask for.
# Words: the names of scenes; none: all.

source [file join [file dirname [info script]] .. support render_words.tcl]
set folder [file normalize [file join [file dirname [info script]] .. .. scenes]]
set accelerators {off grid embree auto}
set rounds 7

# What the scene's gr_render would render, rendered with each accelerator in turn.
rename gr_render renderWhole
proc gr_render {node file width height eye view up fov args} {
    lassign [renderWords $args] tail options
    set scale [expr {100. / max($width, $height)}]
    set size [list [expr {int($width * $scale)}] [expr {int($height * $scale)}]]
    set options [dict remove $options noise time]
    dict set options progress off
    dict set options threads 1
    dict set options samplesperpixel 2
    set picture [file join [expr {[info exists ::env(TMPDIR)] ? $::env(TMPDIR) : "/tmp"}] scenes-bench-[pid].png]
    foreach accelerator $::accelerators {set best($accelerator) Inf}
    for {set round 0} {$round < $::rounds} {incr round} {
        foreach accelerator $::accelerators {
            # One run is enough to see what is hopeless.
            if {$round > 0 && $best($accelerator) > 1} continue
            dict set options accelerator $accelerator
            set result [renderWhole $node $picture {*}$size $eye $view $up $fov {*}$tail {*}$options]
            set seconds [dict get $result rendering]
            set best($accelerator) [expr {min($best($accelerator), $seconds)}]
        }
    }
    file delete $picture
    set least [expr {min($best(off), $best(grid), $best(embree))}]
    puts [format "%-16s off %8.4f  grid %8.4f  embree %8.4f  auto / best %5.2f  %s" $::scene $best(off) $best(grid) \
        $best(embree) [expr {$best(auto) / $least}] [dict get $result accelerator]]
    return $result
}

set names [expr {$argc > 0 ? $argv : [lmap file [lsort [glob -directory $folder *.gr]] {file rootname [file tail $file]}]}]
foreach scene $names {
    gr_reset
    source [file join $folder $scene.gr]
}
