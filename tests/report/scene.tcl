# What the tests of the report's objectives share; each of them sources this first.
# A scene of scenes/ is built, and rendered as a test wants it; what it shows is measured in the .pfm, in radiance.
set here [file normalize [file dirname [info script]]]
source [file join $here .. support tcltest.tcl]
source [file join $here .. support render_words.tcl]
set scenes [file normalize [file join $here .. .. scenes]]
source [file join $scenes models lib vectors.tcl]
namespace path clay
cd [temporaryDirectory]

# In place of the commands of these names, which go on under others: a scene's options are kept, not carried out, but
# for `accelerator`, which changes no picture.
rename gr_render renderNow
rename gr_material makeMaterial
proc gr_render {node file width height eye view up fov args} {
    lassign [renderWords $args] tail options
    lassign $tail ambient lights
    set ::asked [dict merge $options [list node $node width $width height $height eye $eye view $view up $up fov $fov \
        ambient [expr {$ambient eq "" ? {0 0 0} : $ambient}] lights $lights progress off accelerator auto]]
}
proc gr_material {name type args} {
    set changes [expr {[dict exists $::materialChanges $name] ? [dict get $::materialChanges $name] : {}}]
    makeMaterial $name $type {*}[dict merge $args $changes]
}

# Builds a scene anew, its variables being global, and returns the words and options that it renders with, as a dict.
# changes: options of its materials that are to be others, {material {option value ...} ...}.
proc build {name {changes {}}} {
    set ::materialChanges $changes
    gr_reset
    uplevel #0 [list source [file join $::scenes $name.gr]]
    return $::asked
}

# Renders the scene that is built, some words or options changed. Returns what gr_render does.
proc shoot {asked file args} {
    set asked [dict merge $asked $args]
    foreach word {node width height eye view up fov ambient lights} {
        set $word [dict get $asked $word]
        dict unset asked $word
    }
    renderNow $node $file $width $height $eye $view $up $fov $ambient $lights {*}$asked
}

# The same, and returns the picture: its lines from the top, each a list of pixels {r g b}.
proc picture {asked args} {
    set file [dict get [shoot $asked picture.pfm {*}$args] file]
    set channel [open $file rb]
    for {set line 0} {$line < 3} {incr line} {lappend header [gets $channel]}
    set bytes [read $channel]
    close $channel
    lassign [lindex $header 1] width height
    set lines {}
    for {set y [expr {$height - 1}]} {$y >= 0} {incr y -1} {
        binary scan $bytes @[expr {12 * $width * $y}]r[expr {3 * $width}] numbers
        lappend lines [lmap {r g b} $numbers {list $r $g $b}]
    }
    return $lines
}

# One channel, 0 to 2, of a picture's pixels.
proc channel {number picture} {lmap line $picture {lmap pixel $line {lindex $pixel $number}}}

# The camera's axes: right, up and forward, each of length 1.
proc cameraAxes {asked} {
    set forward [unit [dict get $asked view]]
    set right [unit [cross $forward [dict get $asked up]]]
    list $right [cross $right $forward] $forward
}

# A pixel's size at distance 1.
proc pixelSize {asked} {expr {2 * tan([dict get $asked fov] * acos(-1) / 360) / [dict get $asked height]}}

# Where a point is seen: {x y} in pixels from the picture's upper left corner.
proc pixelOf {asked point} {
    set size [pixelSize $asked]
    lassign [lmap axis [cameraAxes $asked] {dot $axis [minus $point [dict get $asked eye]]}] x y z
    list [expr {[dict get $asked width] / 2. + $x / $z / $size}] \
        [expr {[dict get $asked height] / 2. - $y / $z / $size}]
}

# The direction in which the place {x y} of the picture is seen, of length 1.
proc directionOf {asked x y} {
    set size [pixelSize $asked]
    lassign [cameraAxes $asked] right up forward
    set across [plus $forward [expr {($x - [dict get $asked width] / 2.) * $size}] $right]
    unit [plus $across [expr {([dict get $asked height] / 2. - $y) * $size}] $up]
}

# Mean and variance of numbers, each with its weight.
proc moments {numbers weights} {
    set sum 0.
    set mean 0.
    foreach x $numbers w $weights {
        set sum [expr {$sum + $w}]
        set mean [expr {$mean + $w * $x}]
    }
    set mean [expr {$mean / $sum}]
    set variance 0.
    foreach x $numbers w $weights {set variance [expr {$variance + $w * ($x - $mean) ** 2}]}
    list $mean [expr {$variance / $sum}]
}

# The whole numbers from one to another.
proc range {from to} {
    set numbers {}
    for {set i $from} {$i <= $to} {incr i} {lappend numbers $i}
    return $numbers
}

# The mean of numbers.
proc mean {numbers} {expr {[tcl::mathop::+ {*}$numbers] / double([llength $numbers])}}

# Where a profile across an edge, from one level to another, has its edge, and how wide that is: mean and variance of
# its steps, taken as a distribution over the places between the pixels' middles.
proc edgeMoments {places profile} {
    set at {}
    set steps {}
    foreach a [lrange $places 0 end-1] b [lrange $places 1 end] p [lrange $profile 0 end-1] q [lrange $profile 1 end] {
        lappend at [expr {($a + $b) / 2.}]
        lappend steps [expr {$q - $p}]
    }
    moments $at $steps
}

# What of {name value least most ...} is not between its bounds: an empty list where all is well.
# With GRSH_TEST_FIGURES in the environment all are printed.
proc outside {rows} {
    set wrong {}
    foreach {name value least most} $rows {
        if {[info exists ::env(GRSH_TEST_FIGURES)]} {puts "$name: $value, $least to $most"}
        if {!($value >= $least && $value <= $most)} {lappend wrong "$name: $value, not $least to $most"}
    }
    return $wrong
}
