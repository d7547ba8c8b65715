# What tools/obj2gr runs: reads its words, and the model, and writes the files.
namespace eval obj2gr {}
foreach file {vectors read_mtl read_obj materials lamps faces view script} {
    source [file join [file dirname [info script]] $file.tcl]
}

proc obj2gr::warn {message} {
    puts stderr "obj2gr: warning: $message"
}

# Ends the run with a message for whoever called it.
proc obj2gr::fail {message} {
    return -code error -errorcode OBJ2GR $message
}

# {force inline model out}
proc obj2gr::words {words} {
    set usage "usage: tools/obj2gr ?--force? ?--inline n? model.obj ?out.gr?"
    set force 0
    set inline 200
    set names {}
    while {[llength $words] > 0} {
        set words [lassign $words word]
        switch -glob -- $word {
            --force {set force 1}
            --inline {
                set words [lassign $words inline]
                if {![regexp {^\d{1,9}$} $inline]} {fail "--inline must be a number of faces, not \"$inline\""}
                scan $inline %d inline
            }
            -* {fail "no such option \"$word\": must be --force or --inline"}
            default {lappend names $word}
        }
    }
    if {[llength $names] ni {1 2}} {fail $usage}
    lassign $names model out
    if {$out eq ""} {set out [file rootname [file tail $model]].gr}
    if {[file extension $out] ne ".gr"} {fail "the script's name must end in .gr, not \"$out\""}
    list $force $inline $model $out
}

# All of the files, a dict of their names, or none; the last one last.
proc obj2gr::writeFiles {files force} {
    dict for {file -} $files {
        if {[file isdirectory $file]} {fail "cannot write \"$file\": it is a folder"}
        if {!$force && [file exists $file]} {fail "\"$file\" is there already; --force replaces it"}
    }
    set unfinished {}
    try {
        dict for {file bytes} $files {
            set part [file join [file dirname $file] .[file tail $file].[pid]]
            set channel [open $part {WRONLY CREAT EXCL BINARY}]
            lappend unfinished $part
            puts -nonewline $channel $bytes
            close $channel
        }
        foreach part $unfinished file [dict keys $files] {file rename -force $part $file}
    } on error {message} {
        fail "cannot write: $message"
    } finally {
        file delete {*}$unfinished
    }
}

proc obj2gr::run {words} {
    lassign [words $words] force inline model out
    set read [readObj $model]
    writeFiles [scriptFiles $read $model $out $inline] $force
    puts "obj2gr: $out, of [dict size [dict get $read parts]] parts"
}

try {
    obj2gr::run $argv
} trap OBJ2GR {message} {
    puts stderr "obj2gr: $message"
    exit 1
}
