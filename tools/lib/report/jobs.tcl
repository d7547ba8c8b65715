# Rendering what is not done yet, a picture at a time, each by a grsh of its own: a scene that fails, or ends its
# program, stops no other.
namespace eval ::report {
    # Where another catalogue of pictures is, if not the report's own is rendered.
    variable catalogue {}

    # Returns the exit code of it all.
    proc run {quality folder names} {
        set pictures [file join $folder $quality]
        if {[catch {checkFolder $pictures} message]} {
            say "cannot write in $pictures: $message"
            return 1
        }
        set jobs {}
        foreach name [withPartners $names] {
            set isNext [expr {[sourcePicture $name] in $jobs}]
            if {$isNext || ![isDone $pictures $name $quality]} {lappend jobs $name}
        }
        set failures [renderAll $jobs $quality $pictures]
        set page [file join $folder index.html]
        if {[catch {writePage $page $quality $pictures $failures} written]} {
            dict set failures [file tail $page] $written
            set written {}
        }
        summary $page $written $jobs $failures
        return [expr {[dict size $failures] > 0}]
    }

    # The names in the order of the table, with what they are filtered from, and what is filtered from them.
    proc withPartners {names} {
        set all $names
        foreach name [names] {
            set from [sourcePicture $name]
            if {$from eq {}} continue
            if {$name in $names || $from in $names} {lappend all $name $from}
        }
        lmap name [names] {expr {$name in $all ? $name : [continue]}}
    }

    # What it is filtered from, or nothing.
    proc sourcePicture {name} {
        variable pictures
        expr {[dict exists $pictures $name from] ? [dict get $pictures $name from] : {}}
    }

    # A file can be made there.
    proc checkFolder {folder} {
        file mkdir $folder
        set probe [file join $folder probe.[pid]]
        close [open $probe w]
        file delete $probe
        # What a call that was killed has left half written.
        file delete -force {*}[glob -nocomplain -directory $folder figure5.1.*\[0-9\] *.record.* .grsh-* starter]
    }

    # Returns a dict of what failed and why.
    proc renderAll {jobs quality folder} {
        set failures {}
        startProgress $jobs $quality
        foreach name $jobs {
            startPicture $name
            lassign [try {renderOne $name $quality $folder} on error {message} {list 1 $message}] code output
            endPicture
            if {$code != 0 && $output eq {}} {set output "ended with $code"}
            if {$code == 0} {
                # Warnings: noise that was not reached, a picture that is black.
                if {$output ne {}} {say "$name: $output"}
                say "$name: [durationText [dict get [readRecord $folder $name] seconds]][leftText]"
            } else {
                dict set failures $name $output
                say "$name failed: $output"
            }
        }
        return $failures
    }

    # Returns its exit code, 0 for success, and what it printed. The child ends when we do.
    proc renderOne {name quality folder} {
        variable catalogue
        variable finished {}
        set channel [open |[list setpriv --pdeathsig KILL [info nameofexecutable] [starter $name $folder] $name \
            $quality $folder {*}$catalogue </dev/null 2>@1]]
        fconfigure $channel -blocking 0 -encoding utf-8
        set ::report::output {}
        fileevent $channel readable [list ::report::readOutput $channel]
        variable timer [after 500 ::report::tick]
        vwait ::report::finished
        after cancel $timer
        file delete -force [file join $folder starter]
        return $finished
    }

    # A picture tells the name of the script that grsh was given: so that it is the scene's, a file of that name begins.
    proc starter {name folder} {
        variable here
        set file [file join $folder starter $name.gr]
        file mkdir [file dirname $file]
        writeWhole $file [list source [file join $here render.tcl]]
        return $file
    }

    proc tick {} {
        draw
        set ::report::timer [after 500 ::report::tick]
    }

    proc readOutput {channel} {
        append ::report::output [read $channel]
        if {![eof $channel]} return
        fconfigure $channel -blocking 1
        set code 0
        try {
            close $channel
        } trap CHILDSTATUS {- options} {
            set code [lindex [dict get $options -errorcode] 2]
        } trap CHILDKILLED {- options} {
            set code [lindex [dict get $options -errorcode] 2]
        } on error {message} {
            set code $message
        }
        set ::report::finished [list $code [reason $::report::output]]
    }

    # What a picture's program printed, without what a reader cannot use: where the root is, and where in render.tcl.
    proc reason {output} {
        variable root
        regsub {^\S*tools/lib/report/render\.tcl:\d+: } [string map [list $root/ {}] [string trim $output]] {}
    }

    proc summary {page written jobs failures} {
        set made [llength [lmap name $jobs {expr {[dict exists $failures $name] ? [continue] : $name}}]]
        set what [expr {$jobs eq {} ? "nothing to render, all pictures are done" : "rendered $made of [llength $jobs]"}]
        set what [dict get [list {} $what 0 "$what; as it was: $page" 1 "$what; wrote $page"] $written]
        say $what
        dict for {name reason} $failures {say "failed: $name: $reason"}
    }
}
