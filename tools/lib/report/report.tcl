# grsh report.tcl WORD...: what tools/report does, once grsh is built. Here are its words; the other files do the work.
namespace eval ::report {
    variable here [file dirname [file normalize [info script]]]
    variable root [file normalize [file join $here .. .. ..]]
    foreach part {pictures plates record progress jobs colours page} {source [file join $here $part.tcl]}

    variable help {usage: tools/report [--quality draft|normal|final] [--folder path] [picture...]
       tools/report --check [--folder path]

Renders the pictures of the report of 2001 and writes a page that shows them, docs/report/index.html. Without names it
renders all. What is done and has not changed since is kept.

  --quality draft   at most 480 pixels wide and high, at most 64 samples per pixel
  --quality normal  as the scenes say: the default
  --quality final   where there is more than 1 % noise, until there is not, or each pixel has 8192 samples; not for
                    scenes that say how much noise there may be, or show what a number of samples leaves
  --folder path     put pictures and page there
  --check           look at the page in headless Chromium: its links, its sliders, its widths
  --help            show this text

Exits 1 when a picture fails; the others are made all the same.}

    proc usageError {message} {
        puts stderr "tools/report: $message\ntools/report --help says more"
        exit 2
    }

    # An unknown word, what is allowed, and what may be meant.
    proc unknown {what word allowed} {
        set nearest [nearest $word $allowed]
        usageError "unknown $what \"$word\"[expr {$nearest eq {} ? {} : " (did you mean \"$nearest\"?)"}]: must be\
            [join [lrange $allowed 0 end-1] {, }] or [lindex $allowed end]"
    }

    # The allowed word that is at most a third of its letters away, or nothing.
    proc nearest {word allowed} {
        set best {}
        set least [expr {max([string length $word], 3) / 3 + 1}]
        foreach candidate $allowed {
            set away [distance $word $candidate]
            if {$away < $least} {
                set least $away
                set best $candidate
            }
        }
        return $best
    }

    # Letters to change, add or take away (Levenshtein).
    proc distance {a b} {
        for {set i 0} {$i <= [string length $b]} {incr i} {lappend row $i}
        foreach x [split $a {}] {
            set above $row
            set row [list [expr {[lindex $above 0] + 1}]]
            set k 0
            foreach y [split $b {}] {
                lappend row [expr {min([lindex $above $k] + ($x ne $y), [lindex $above $k+1] + 1, [lindex $row $k] + 1)}]
                incr k
            }
        }
        lindex $row end
    }

    # A dict of the words: quality, folder, names.
    proc readWords {words} {
        variable root
        set given [dict create quality normal folder [file join $root docs report] names {}]
        while {[llength $words] > 0} {
            set words [lassign $words word]
            if {$word eq "--help"} {
                puts $::report::help
                exit 0
            }
            if {![string match -* $word]} {
                if {$word ni [names]} {unknown picture $word [names]}
                dict lappend given names $word
                continue
            }
            if {$word ni {--quality --folder}} {unknown option $word {--quality --folder --check --help}}
            if {[llength $words] == 0} {usageError "$word needs a word behind it"}
            set words [lassign $words value]
            if {$word eq "--quality" && $value ni [qualities]} {unknown quality $value [qualities]}
            if {$word eq "--folder"} {set value [file normalize $value]}
            dict set given [string range $word 2 end] $value
        }
        if {[dict get $given names] eq {}} {dict set given names [names]}
        return $given
    }
}

if {[file normalize $argv0] eq [file normalize [info script]]} {
    exit [::report::run {*}[dict values [::report::readWords $argv]]]
}
