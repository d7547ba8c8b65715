# What the tests of tools/report share: a catalogue of tiny scenes in a folder of its own.
source [file join [file dirname [info script]] .. support tcltest.tcl]
set root [file normalize [file join [file dirname [info script]] .. ..]]
set tool [file join $root tools lib report]
cd [temporaryDirectory]
set old 1000000000

# A folder with scenes of these pictures, and all.tcl, which renders them as tools/report does its own:
# grsh all.tcl QUALITY ?NAME ...?
proc catalogue {pictures} {
    file delete -force scenes out
    write catalogue.tcl [list namespace eval ::report \
        "variable root [list [pwd]]; variable pictures [list $pictures]; variable rooms {}"]
    write all.tcl "source [list [file join $::tool report.tcl]]
        source catalogue.tcl
        set ::report::catalogue [list [file normalize catalogue.tcl]]
        exit \[::report::run \[lindex \$argv 0] [list [file normalize out]] \
            \[expr {\$argc > 1 ? \[lrange \$argv 1 end] : \[::report::names]}]]"
}

proc scene {name {options {samplesperpixel 2}} {before ""} {size {12 9}}} {
    write scenes/$name.gr "$before
        gr_sphere : ball
        gr_render : $name.png $size {0 0 5} {0 0 -1} {0 1 0} 40 background {1 0.5 0.2} $options"
}

# Runs all.tcl. Returns the exit code and the last line of what it says, without the folder and the page.
proc all {args} {
    lassign [grsh [list all.tcl {*}$args]] code out err
    set last [lindex [split [string trim $out$err] \n] end]
    list $code [regsub {; (?:wrote|as it was:) .*} [string map {"tools/report: " {}} $last] {}]
}

# The pictures of out/draft. They are made old, to tell later which are new.
proc made {} {
    lmap file [lsort [glob -nocomplain -directory out/draft *.png]] {
        file mtime $file $::old
        file tail $file
    }
}

proc changed {} {
    lmap file [lsort [glob -directory out/draft *.png]] {
        expr {[file mtime $file] == $::old ? [continue] : [file tail $file]}
    }
}

proc record {quality name} {contents out/$quality/$name.record}
