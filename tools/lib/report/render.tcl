# grsh render.tcl NAME QUALITY FOLDER [CATALOGUE]: renders one picture of the report into the folder, and then writes
# its record. CATALOGUE is a file with other pictures than the report's, as its tests have.
#
# A scene is run as it is. Only gr_render is another: it puts the picture where we want it, at the quality asked for.
namespace eval ::report {
    variable here [file dirname [file normalize [info script]]]
    variable root [file normalize [file join $here .. .. ..]]
    source [file join $here pictures.tcl]
    source [file join $here record.tcl]
    source [file join $root tests support render_words.tcl]
    if {$argc > 3} {source [lindex $argv 3]}

    lassign $argv name quality folder
    variable picture [dict get $pictures $name]
    variable target [pictureFile $folder $name]
    variable sources {}
    variable result {}

    # Pixels along x and y, no edge longer than the quality allows.
    proc sizeAt {row width height} {
        set most [dict get $row size]
        set scale [expr {$most > 0 ? min(1., double($most) / max($width, $height)) : 1.}]
        list [expr {max(1, round($scale * $width))}] [expr {max(1, round($scale * $height))}]
    }

    # The scene's options, the most samples being the quality's.
    proc optionsAt {row words} {
        set options [concat {*}[lmap {name value} $words {list [string tolower [string trimleft $name -]] $value}]]
        if {[dict get $row samples] > 0} {
            # gr_render's own number, which there is not with noise or time.
            set samples [expr {[saysWhen $options] ? [dict get $row samples] : 16}]
            if {[dict exists $options samplesperpixel]} {set samples [dict get $options samplesperpixel]}
            set options [dict remove $options noise time]
            dict set options samplesperpixel [expr {min($samples, [dict get $row samples])}]
        }
        dict set options progress off
    }

    # The scene itself says how good its picture is to be.
    proc saysWhen {options} {
        expr {[dict exists $options noise] || [dict exists $options time]}
    }

    # The options for another go where the picture has more noise than the quality allows, else nothing.
    proc finer {row options keep noise} {
        set most [dict get $row noise]
        if {$most == 0 || $keep || [saysWhen $options] || ($noise ne {} && $noise <= $most)} return
        dict merge $options [dict create noise $most samplesperpixel [dict get $row atMost]]
    }

    # Notes every file that the scene is made of, as it is read.
    proc noteSource {command args} {lappend ::report::sources [file normalize [lindex $command end]]}
    proc noteMesh {command args} {
        lappend ::report::sources [file normalize [file join [file dirname [info script]] [lindex $command end]]]
    }
    proc noteOpen {command args} {
        lassign $command - file access
        if {$access in {{} r rb RDONLY} && [file isfile $file]} {lappend ::report::sources [file normalize $file]}
    }

    proc renderScene {node file width height eye view up fov words} {
        variable result
        variable picture
        variable target
        variable quality
        variable qualityTable
        if {[file rootname [file tail $file]] ne $::report::name} {
            error "the scene renders \"$file\", not \"$::report::name.png\""
        }
        set row [dict get $qualityTable $quality]
        lassign [renderWords $words] tail options
        set options [optionsAt $row [concat [gr_default] $options]]
        lassign [sizeAt $row $width $height] width height
        set words [list $node $target $width $height $eye {*}$view $up $fov {*}$tail]
        set result [renderAsAsked {*}$words {*}$options]
        set finer [finer $row $options [dict exists $picture keep] [dict get $result noise]]
        if {$finer ne {}} {
            set options $finer
            set result [renderAsAsked {*}$words {*}$options]
        }
        dict set result width $width
        dict set result height $height
        dict set result options [dict remove $options progress]
        return $result
    }

    proc scene {} {
        variable root
        variable result
        set script [file join $root [scriptOf $::report::name]]
        if {![file isfile $script]} {error "there is no [scriptOf $::report::name]"}
        rename ::gr_render ::report::renderAsAsked
        proc ::gr_render {node file width height eye view args} {
            # lookat {x y z} may stand in place of the view.
            if {$view eq "lookat"} {set args [lassign $args point]; lappend view $point} else {set view [list $view]}
            set args [lassign $args up fov]
            ::report::renderScene $node $file $width $height $eye $view $up $fov $args
        }
        trace add execution source enter ::report::noteSource
        trace add execution gr_mesh enter ::report::noteMesh
        trace add execution open enter ::report::noteOpen
        uplevel #0 [list source $script]
        foreach {command note} {source noteSource gr_mesh noteMesh open noteOpen} {
            trace remove execution $command enter ::report::$note
        }
        if {$result eq {}} {error "[scriptOf $::report::name] renders nothing"}
    }

    proc median {} {
        variable result
        variable picture
        variable target
        variable folder
        set from [pictureFile $folder [dict get $picture from]]
        # A picture without a record is an older one.
        if {![file isfile $from] || [readRecord $folder [dict get $picture from]] eq {}} {
            error "there is no [file tail $from] to be filtered"
        }
        set n [dict get $picture n]
        set seconds [expr {[lindex [time {gr_median $from $target $n}] 0] * 1e-6}]
        # Its size is that of the picture that was filtered.
        set size [dict filter [readRecord $folder [dict get $picture from]] key width height]
        set result [dict merge $size [dict create seconds $seconds options [list n $n]]]
        set ::report::sources [list $from]
    }

    # Draft and normal stop at 3969 spheres: a million take minutes.
    proc plot {} {
        variable result
        variable root
        set words [expr {$::report::quality eq "final" ? {} : "--draft"}]
        set work [file join $::report::folder figure5.1.[pid]]
        file mkdir $work
        try {
            set seconds [lindex [time {exec [file join $root tools figure5.1] {*}$words --folder $work 2>@1}] 0]
            file rename -force [file join $work figure5.1.svg] $::report::target
        } finally {
            file delete -force $work
        }
        set result [dict create seconds [expr {$seconds * 1e-6}] options $words]
        foreach file {
            tools/figure5.1 tests/bench/figure5.1.tcl tests/bench/figure5.1.gnuplot scenes/lib/performance.tcl
        } {
            lappend ::report::sources [file join $root $file]
        }
    }

    # A record of another picture must not outlive it.
    file delete [recordFile $folder $name]
    [dict get $picture kind]
    set record [dict filter $result key seconds samples samplesperpixel noise stopped width height options threads]
    dict set record script [scriptOf $name]
    dict set record recipe [recipe $name $quality]
    dict set record sources [checksums $sources]
    dict set record picture [checksum $target]
    writeWhole [recordFile $folder $name] $record
}
