# MTL files: readMtl returns a dict of materials by name; each is a dict of its lines' words.
namespace eval obj2gr {
    variable isNumber {^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$}
}

# The lines of a file, continued ones joined and comments taken off: {number {word word ...} number ...}.
proc obj2gr::linesOf {file} {
    if {[catch {open $file} channel]} {fail "cannot read \"$file\": [lindex [split $::errorCode] 1]"}
    fconfigure $channel -encoding utf-8
    try {
        set text [read $channel]
    } on error {} {
        fail "cannot read \"$file\""
    } finally {
        close $channel
    }
    set lines {}
    set number 0
    set begun ""
    foreach line [split $text \n] {
        incr number
        if {$begun eq ""} {set first $number}
        if {[string index $line end] eq "\\"} {
            append begun [string range $line 0 end-1] " "
            {continue}
        }
        append begun $line
        regsub {(^|\s)#.*} $begun {} begun
        if {[string trim $begun] ne ""} {lappend lines $first [regexp -all -inline {\S+} $begun]}
        set begun ""
    }
    if {[string trim $begun] ne ""} {lappend lines $first [regexp -all -inline {\S+} $begun]}
    return $lines
}

# Some words as numbers; there may be others behind them.
proc obj2gr::numbersOf {words count place} {
    variable isNumber
    if {[llength $words] < $count} {fail "$place: $count numbers are needed, not [llength $words]"}
    lmap word [lrange $words 0 $count-1] {
        if {![regexp $isNumber $word] || abs([scan $word %f]) > 1e18} {fail "$place: \"$word\" is not a number"}
        scan $word %f
    }
}

proc obj2gr::readMtl {file} {
    set materials {}
    set name ""
    foreach {line words} [linesOf $file] {
        set place $file:$line
        set words [lassign $words key]
        if {$key eq "newmtl"} {
            if {[llength $words] == 0} {fail "$place: newmtl needs a name"}
            set name [join $words]
            dict set materials $name {}
            {continue}
        }
        if {$name eq ""} {fail "$place: \"$key\" stands before the first newmtl"}
        switch -- $key {
            Kd - Ks - Ke - Tf {
                if {[lindex $words 0] in {spectral xyz}} {
                    warn "$place: $key [lindex $words 0] of \"$name\" is left out"
                } else {
                    # A single number is a grey.
                    if {[llength $words] == 1} {set words [lrepeat 3 [lindex $words 0]]}
                    dict set materials $name $key [limited [numbersOf $words 3 $place] $key $name $place]
                }
            }
            Ns - Ni {dict set materials $name $key [numbersOf $words 1 $place]}
            illum {dict set materials $name illum [expr {int([numbersOf $words 1 $place])}]}
            d {
                if {[lindex $words 0] eq "-halo"} {
                    warn "$place: -halo of \"$name\" is left out"
                    set words [lrange $words 1 end]
                }
                dict set materials $name d [numbersOf $words 1 $place]
            }
            Tr {dict set materials $name d [expr {1 - [numbersOf $words 1 $place]}]}
            Ka - sharpness {}
            default {warn "$place: $key of \"$name\" is left out: grsh has nothing like it"}
        }
    }
    return $materials
}

proc obj2gr::limited {colour key name place} {
    foreach part $colour {
        if {$part < 0} {fail "$place: $key of \"$name\" is less than 0"}
    }
    # Only light has no upper limit.
    set limited [lmap part $colour {expr {$key eq "Ke" ? $part : min($part, 1)}}]
    if {$limited ne $colour} {warn "$place: $key of \"$name\" is more than 1: cut off there"}
    return $limited
}
