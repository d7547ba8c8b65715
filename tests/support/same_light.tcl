# grsh same_light.tcl SCENE FACTOR: whether the path integrator and the report's, which is the oracle, find the same light
# in a scene: prints what differs, and a line for each picture with samples dropped. FACTOR: times so many samples.
source [file join [file dirname [info script]] render_words.tcl]
lassign $argv scene factor

# Samples of one seed are spread evenly on purpose: how much they vary only other seeds' pictures tell.
set pictures 32
# Beyond so many standard errors, with 31 degrees of freedom, lies a number once in 579,000 times: there are 576 in a
# picture of 16 x 12. The three means over it lie beyond the second once in 6000 times each.
set farForPixel 5.9
set farForMean 4.3

# The numbers of a PFM file.
proc numbers {file} {
    set channel [open $file rb]
    for {set line 0} {$line < 3} {incr line} {gets $channel}
    set bytes [read $channel]
    close $channel
    binary scan $bytes r* numbers
    return $numbers
}

# The mean of each channel over the picture.
proc channelMeans {numbers} {
    set r 0.
    set g 0.
    set b 0.
    foreach {x y z} $numbers {
        set r [expr {$r + $x}]
        set g [expr {$g + $y}]
        set b [expr {$b + $z}]
    }
    set pixels [expr {[llength $numbers] / 3.}]
    list [expr {$r / $pixels}] [expr {$g / $pixels}] [expr {$b / $pixels}]
}

# Mean and square of the standard error of each column of some rows.
proc statistics {rows} {
    set n [llength $rows]
    set first [lindex $rows 0]
    set sums [lrepeat [llength $first] 0.]
    set squares $sums
    # From the first row's number, so that little cancels.
    foreach row $rows {
        set newSums {}
        set newSquares {}
        foreach x $row origin $first sum $sums square $squares {
            set d [expr {$x - $origin}]
            lappend newSums [expr {$sum + $d}]
            lappend newSquares [expr {$square + $d * $d}]
        }
        set sums $newSums
        set squares $newSquares
    }
    set result {}
    foreach origin $first sum $sums square $squares {
        set variance [expr {max(0., $square - $sum * $sum / $n) / ($n - 1)}]
        lappend result [expr {$origin + $sum / $n}] [expr {$variance / $n}]
    }
    return $result
}

# What of a and b, as statistics gives them, is further apart than `far` standard errors.
proc apart {what far a b} {
    set worst 0
    set text ""
    set i 0
    foreach {mean error2} $a {otherMean otherError2} $b {
        # Rounding leaves a millionth where there is no noise.
        set error [expr {max(sqrt($error2 + $otherError2), 1e-6 * abs($otherMean))}]
        set z [expr {$error > 0 ? abs($mean - $otherMean) / $error : $mean == $otherMean ? 0. : Inf}]
        if {$z > $worst} {
            set worst $z
            set text "$what $i: path $mean, report $otherMean, [format %.1f $z] standard errors"
        }
        incr i
    }
    expr {$worst > $far ? [list $text] : {}}
}

# Renders as many pictures as there are to be, and gives the statistics of their pixels and of their means.
proc measure {integrator samples firstSeed words} {
    set rows {}
    set means {}
    for {set i 0} {$i < $::pictures} {incr i} {
        set options [dict merge [lindex $words 1] [list seed [expr {$firstSeed + $i}] samplesperpixel $samples]]
        dict set options integrator $integrator
        # The report's own, which tests every object, would take minutes for a city.
        dict set options accelerator auto
        dict set options progress off
        set result [renderWhole {*}[lindex $words 0] {*}$options]
        if {[dict get $result dropped] != 0} {puts "$integrator: [dict get $result dropped] samples dropped"}
        set row [numbers [dict get $result file]]
        lappend rows $row
        lappend means [channelMeans $row]
    }
    list [statistics $rows] [statistics $means]
}

proc differences {words samples firstSeed} {
    lassign [measure path $samples $firstSeed $words] path pathMeans
    lassign [measure report [expr {2 * $samples}] $firstSeed $words] report reportMeans
    list {*}[apart number $::farForPixel $path $report] {*}[apart channel $::farForMean $pathMeans $reportMeans]
}

# Where a highlight is very narrow, few of the report's samples find a light in it, and those count for so much that
# their mean is not normal for a long time: here no highlight is narrower than this one. A sky fills the whole half
# space, of which a highlight is a smaller part than of a lamp.
set channel [open $scene]
set steepest [expr {[regexp {\menvironment\M} [read $channel]] ? 30 : 300}]
close $channel
rename gr_material materialAsIs
proc gr_material {args} {
    set at [lsearch $args exp]
    if {$at >= 0} {lset args $at+1 [lmap n [lindex $args $at+1] {expr {min($n, $::steepest)}}]}
    materialAsIs {*}$args
}

rename gr_render renderWhole
proc gr_render {node file width height eye view up fov args} {
    lassign [renderWords $args] tail options
    set options [dict remove $options noise time]
    set words [list [list $node same_light.pfm 16 12 $eye $view $up $fov {*}$tail] $options]
    # What differs is looked at again, with more samples of other seeds.
    if {[differences $words [expr {32 * $::factor}] 1] eq ""} return
    foreach difference [differences $words [expr {128 * $::factor}] 1001] {puts $difference}
}
source $scene
