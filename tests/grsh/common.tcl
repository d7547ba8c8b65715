# What the tests of the gr_* commands share; each of them sources this first.
source [file join [file dirname [info script]] .. support tcltest.tcl]
cd [temporaryDirectory]

# The message and the errorCode with which a script fails in an empty scene.
proc errorOf {script} {
    gr_reset
    if {![catch {uplevel #0 $script} message options]} {error "no error, but the result \"$message\""}
    list $message [dict get $options -errorcode]
}

# One test for each row {script message errorCode}.
proc testErrors {group rows} {
    foreach {script message code} $rows {
        test $group.[incr number] $script -body [list errorOf $script] -result [list $message $code]
    }
}

set wrongWords {TCL WRONGARGS}

# 0 to count - 1.
proc range {count} {
    set numbers {}
    for {set i 0} {$i < $count} {incr i} {lappend numbers $i}
    return $numbers
}

proc clean {} {
    gr_reset
    file delete -- {*}[glob -nocomplain *.png]
}

# An 8 x 8 picture of the scene, seen from {0 0 -5} along +z. Lines, samples and the like are in tail.
proc render {args} {
    gr_render : picture.png 8 8 {0 0 -5} {0 0 1} {0 1 0} 40 {*}$args progress off
}

# A PNG file of 8 bit RGB: its lines, each a list of its bytes.
proc pixels {file} {
    set channel [open $file rb]
    set bytes [read $channel]
    close $channel
    set data ""
    for {set at 8} {$at < [string length $bytes]} {incr at [expr {$length + 12}]} {
        binary scan $bytes @${at}Iua4 length type
        set chunk [string range $bytes $at+8 [expr {$at + 7 + $length}]]
        if {$type eq "IHDR"} {binary scan $chunk IuIu width height}
        if {$type eq "IDAT"} {append data $chunk}
    }
    set data [zlib decompress $data]
    set above [lrepeat [expr {3 * $width}] 0]
    set lines {}
    for {set y 0} {$y < $height} {incr y} {
        set start [expr {$y * (3 * $width + 1)}]
        binary scan $data @${start}cucu[expr {3 * $width}] filter line
        lappend lines [set above [unfilter $filter $line $above]]
    }
    return $lines
}

# A line without PNG's filter (PNG specification, 9.2).
proc unfilter {filter line above} {
    set plain {}
    for {set i 0} {$i < [llength $line]} {incr i} {
        set a [expr {$i < 3 ? 0 : [lindex $plain $i-3]}]
        set b [lindex $above $i]
        set c [expr {$i < 3 ? 0 : [lindex $above $i-3]}]
        switch $filter {
            0 {set predicted 0}
            1 {set predicted $a}
            2 {set predicted $b}
            3 {set predicted [expr {($a + $b) / 2}]}
            4 {set predicted [paeth $a $b $c]}
        }
        lappend plain [expr {([lindex $line $i] + $predicted) & 255}]
    }
    return $plain
}

proc paeth {a b c} {
    set p [expr {$a + $b - $c}]
    set pa [expr {abs($p - $a)}]
    set pb [expr {abs($p - $b)}]
    set pc [expr {abs($p - $c)}]
    if {$pa <= $pb && $pa <= $pc} {return $a}
    return [expr {$pb <= $pc ? $b : $c}]
}

# The bytes that are in a picture.
proc bytes {file} {lsort -integer -unique [concat {*}[pixels $file]]}
