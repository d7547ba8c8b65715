# A script as HTML, its comments, commands, variables and numbers marked.
namespace eval ::report {
    proc escape {text} {string map {& &amp; < &lt; > &gt; \" &quot;} $text}

    proc coloured {script} {
        join [lmap line [split [string trimright $script] \n] {colouredLine $line}] \n
    }

    proc colouredLine {line} {
        if {[regexp {^\s*#} $line]} {return "<i>[escape $line]</i>"}
        set html {}
        set at 0
        # gr_* commands, Tcl's words, variables, numbers: whichever comes first, then the next behind it.
        set words {\mgr_\w+|\m(?:source|set|proc|foreach|for|if|while|expr|list|lassign|lappend|return|namespace eval)\M}
        append words {|\$[\w:]+|-?\m\d+(?:\.\d*)?(?:e-?\d+)?\M}
        foreach range [regexp -all -inline -indices $words $line] {
            lassign $range first last
            set word [string range $line $first $last]
            append html [escape [string range $line $at $first-1]]
            switch -glob $word {
                {$*} {set tag var}
                {[-0-9]*} {set tag u}
                default {set tag b}
            }
            append html "<$tag>[escape $word]</$tag>"
            set at [expr {$last + 1}]
        }
        append html [escape [string range $line $at end]]
    }
}
