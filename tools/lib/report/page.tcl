# The page: page.html with its style, its script, and the rooms of plates.tcl put in. All pictures are in it, so that it
# is one file that needs nothing else.
foreach part {plates colours plate} {source [file join [file dirname [info script]] $part.tcl]}

namespace eval ::report {
    # Writes it, unless it is there and would become the same. Returns whether it was written.
    proc writePage {page quality folder failures} {
        set html [pageText $quality $folder $failures]
        if {[file exists $page] && [text $page] eq $html} {return 0}
        writeWhole $page $html
        return 1
    }

    # `failures` is a dict of pictures that could not be rendered, and why.
    proc pageText {quality folder failures} {
        variable here
        variable rooms
        variable shown [dict create quality $quality folder $folder failures $failures lib {}]
        set body [join [lmap room $rooms {roomText $room}] \n]
        set parts [list @STYLE@ [text [file join $here page.css]] @SCRIPT@ [text [file join $here page.js]] \
            @SUMMARY@ [summaryText $folder] @ROOMS@ $body @OBJECTIVES@ [objectivesText] @SHARED@ [sharedText]]
        string map $parts [text [file join $here page.html]]
    }

    # Links and code in a text of plates.tcl.
    proc marked {text} {
        set text [escape [regsub -all {\s+} [string trim $text] { }]]
        regsub -all {\[([^\s\]]+) ([^]]+)\]} $text {<a href="#\1">\2</a>} text
        regsub -all {`([^`]+)`} $text {<code>\1</code>} text
        return $text
    }

    proc roomText {room} {
        dict with room {
            set id [regsub -all {[^a-z]+} [string tolower $title] -]
            set html "<section aria-labelledby=\"$id\">\n<h2 id=\"$id\">[escape $title]</h2>\n"
            append html "<p class=\"intro\">[marked $intro]</p>\n"
            foreach plate $plates {append html [plateText $plate]}
            append html "</section>"
        }
    }

    proc summaryText {folder} {
        variable shown
        set seconds 0
        set count 0
        foreach name [names] {
            if {![isShown $name]} continue
            incr count
            set seconds [expr {$seconds + [dict get [readRecord $folder $name] seconds]}]
        }
        set quality "Quality “[dict get $shown quality]”"
        return "$quality: $count of [llength [names]] pictures, [durationText $seconds] in all."
    }

    proc objectivesText {} {
        variable objectives
        set html {}
        foreach objective $objectives {
            lassign $objective title words where
            incr number
            append html "<li id=\"objective-$number\">\n<h3>[escape $title]</h3>\n"
            append html "<blockquote>[marked $words]</blockquote>\n<p>[marked $where]</p>\n"
            append html "<p class=\"facts\"><code>tools/test -R objective_${number}_</code></p>\n</li>\n"
        }
        return $html
    }

    # The files that several scenes read.
    proc sharedText {} {
        variable root
        variable shown
        join [lmap file [lsort [dict keys [dict get $shown lib]]] {codeText $file [text [file join $root $file]]}] ""
    }
}
