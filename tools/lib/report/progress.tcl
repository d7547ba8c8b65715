# How far it is and how long it still takes, on standard error: a line that is drawn again and again where that is a
# terminal, else a line for each picture.
namespace eval ::report {
    proc say {message} {
        clearLine
        puts stderr "tools/report: $message"
    }

    proc durationText {seconds} {
        set whole [expr {int(ceil($seconds))}]
        if {$seconds < 9.95} {return [format "%.1f s" $seconds]}
        if {$whole < 60} {return "$whole s"}
        if {$whole < 3600} {return [format "%d min %02d s" [expr {$whole / 60}] [expr {$whole % 60}]]}
        format "%d h %02d min" [expr {$whole / 3600}] [expr {$whole % 3600 / 60}]
    }

    # `jobs` are the names still to do, in their order.
    proc startProgress {jobs quality} {
        variable progress
        set expected [dict create]
        foreach name $jobs {dict set expected $name [cost $name $quality]}
        set progress [dict create expected $expected passed 0. done 0. count 0 of [llength $jobs] \
            terminal [expr {![catch {exec test -t 2 2>@stderr}]}]]
    }

    proc startPicture {name} {
        variable progress
        dict set progress name $name
        dict set progress start [clock milliseconds]
        dict incr progress count
        draw
    }

    proc endPicture {} {
        variable progress
        dict with progress {
            set passed [expr {$passed + ([clock milliseconds] - $start) * 1e-3}]
            set done [expr {$done + [dict get $expected $name]}]
            dict unset expected $name
        }
        dict unset progress name
    }

    # Behind a picture that is done.
    proc leftText {} {
        variable progress
        if {[dict size [dict get $progress expected]] == 0} return
        set left [durationText [lindex [estimate] 0]]
        return " ([dict get $progress count] of [dict get $progress of], $left left)"
    }

    # Seconds that are left, and the part that is done. This machine's speed shows in what is done; some seconds at the
    # costs' own speed keep the first pictures from saying too much.
    proc estimate {} {
        variable progress
        dict with progress {
            set speed [expr {($passed + 3) / ($done + 3)}]
            set left [expr {$speed * [tcl::mathop::+ {*}[dict values $expected]]}]
            set now 0
            if {[info exists name]} {
                set now [expr {([clock milliseconds] - $start) * 1e-3}]
                set left [expr {$left - min($now, $speed * [dict get $expected $name])}]
            }
            list $left [expr {($passed + $now) / max($passed + $now + $left, 1e-9)}]
        }
    }

    proc draw {} {
        variable progress
        if {![dict get $progress terminal]} return
        lassign [estimate] left part
        set bar [string repeat # [expr {int(16 * $part)}]]
        puts -nonewline stderr [format "\r%d of %d  \[%-16s\] %2d %%  %s left  %s\033\[K" [dict get $progress count] \
            [dict get $progress of] [string map {{ } .} [format %-16s $bar]] [expr {min(99, int(100 * $part))}] \
            [durationText $left] [dict get $progress name]]
        flush stderr
    }

    proc clearLine {} {
        variable progress
        if {[info exists progress] && [dict get $progress terminal]} {puts -nonewline stderr "\r\033\[K"}
    }
}
