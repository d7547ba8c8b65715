# For a test file that grsh itself runs: source this first, write tests, end with "finish".
# What tests write goes into a folder of its own, [temporaryDirectory], which "finish" removes.
package require tcltest 2.3
namespace import ::tcltest::*

set folder [expr {[info exists env(TMPDIR)] ? $env(TMPDIR) : "/tmp"}]
configure -singleproc 1 -tmpdir [file join $folder grsh-test-[pid]] {*}$argv

# Runs grsh with these words. Returns {exit code, or the signal's name} {standard output} {standard error}.
proc grsh {words {input ""}} {
    set code 0
    set out [file join [temporaryDirectory] out.txt]
    set err [file join [temporaryDirectory] err.txt]
    set command [list [info nameofexecutable] {*}$words << $input > $out 2> $err]
    try {
        exec {*}$command
    } trap CHILDSTATUS {- options} {
        set code [lindex [dict get $options -errorcode] 2]
    } trap CHILDKILLED {- options} {
        set code [lindex [dict get $options -errorcode] 2]
    }
    list $code [contents $out] [contents $err]
}

proc contents {file} {
    set channel [open $file]
    try {
        read $channel
    } finally {
        close $channel
    }
}

# Writes a file just as given; makeFile would add a line.
proc write {file text} {
    file mkdir [file dirname $file]
    set channel [open $file w]
    puts -nonewline $channel $text
    close $channel
}

# Prints the counts and exits 1 if a test failed.
proc finish {} {
    set failed $::tcltest::numTests(Failed)
    set folder [temporaryDirectory]
    cd /
    file delete -force $folder
    file mkdir $folder
    cleanupTests
    file delete -force $folder
    exit [expr {$failed > 0}]
}
