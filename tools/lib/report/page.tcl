# The page: page.html with its style, its script, and the rooms of plates.tcl put in. All pictures are in it, so that it
# is one file that needs nothing else.
foreach part {plates colours} {source [file join [file dirname [info script]] $part.tcl]}

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

    proc idOf {title} {regsub -all {[^a-z]+} [string tolower $title] -}

    proc roomText {room} {
        dict with room {
            set html "<section aria-labelledby=\"[idOf $title]\">\n<h2 id=\"[idOf $title]\">[escape $title]</h2>\n"
            append html "<p class=\"intro\">[marked $intro]</p>\n"
            foreach plate $plates {append html [plateText $plate]}
            append html "</section>"
        }
    }

    proc plateText {plate} {
        dict with plate {
            set names [dict keys $pictures]
            set html "<figure class=\"plate $shape\" id=\"$id\">\n[${shape}Text $plate]\n<figcaption>\n"
            append html "<p class=\"label\">[escape $label]</p>\n<h3>[escape $title]</h3>\n<p>[marked $text]</p>\n"
            foreach name $names {append html [factsText $name [expr {[llength $names] > 1}]]}
            append html "</figcaption>\n</figure>\n"
        }
    }

    proc oneText {plate} {
        imageText {*}[dict get $plate pictures]
    }

    proc rowText {plate} {
        set images [lmap {name alt} [dict get $plate pictures] {imageText $name $alt}]
        return "<div class=\"images\">\n[join $images \n]\n</div>"
    }

    proc plotText {plate} {
        variable shown
        lassign [dict get $plate pictures] name alt
        if {![isShown $name]} {return [missingText $name]}
        set svg [text [pictureFile [dict get $shown folder] $name]]
        regsub {^.*?<svg[^>]*viewBox="([^"]*)"[^>]*>} $svg {<svg viewBox="\1" role="img" aria-label="ALT">} svg
        # Its ink becomes the page's, which may be light on dark.
        set svg [string map [list ALT [escape $alt] "color=\"black\"" "" 'black' 'currentColor' "\"black\"" \
            "\"currentColor\"" "fill=\"#ffffff\"" "fill=\"none\""] $svg]
        return "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"plot\">\n[string trim $svg]\n</div>"
    }

    # The first picture lies over the second, cut off where the slider stands.
    proc pairText {plate} {
        lassign [dict get $plate pictures] first firstAlt second secondAlt
        lassign [dict get $plate sides] left right
        if {![isShown $first] || ![isShown $second]} {
            return "<div class=\"images\">\n[imageText $first $firstAlt]\n[imageText $second $secondAlt]\n</div>"
        }
        set crisp [expr {[dict exists $plate crisp] ? " crisp" : ""}]
        return "<div class=\"slider$crisp\">
[imageText $second $secondAlt]
[imageText $first $firstAlt over]
<span class=\"side left\">[escape $left]</span><span class=\"side right\">[escape $right]</span>
<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"how much is seen of: [escape $left], not: [escape $right]\" />
</div>"
    }

    proc isShown {name} {
        variable shown
        isDone [dict get $shown folder] $name [dict get $shown quality]
    }

    proc imageText {name alt {class ""}} {
        variable shown
        if {![isShown $name]} {return [missingText $name]}
        set bytes [contents [pictureFile [dict get $shown folder] $name]]
        # Of a PNG file's first chunk, IHDR.
        binary scan $bytes @16IuIu width height
        set class [expr {$class eq "" ? "" : " class=\"$class\""}]
        return "<img$class width=\"$width\" height=\"$height\" style=\"--width:$width\" alt=\"[escape $alt]\"\
            loading=\"lazy\" decoding=\"async\" src=\"data:image/png;base64,[binary encode base64 $bytes]\" />"
    }

    proc missingText {name} {
        variable shown
        set failures [dict get $shown failures]
        set why [expr {[dict exists $failures $name] ? "could not be rendered: [dict get $failures $name]"
            : "has not been rendered"}]
        return "<p class=\"missing\">[escape "$name $why"]</p>"
    }

    # What it took, and the script that made it.
    proc factsText {name isNamed} {
        variable shown
        if {![isShown $name]} return
        set record [readRecord [dict get $shown folder] $name]
        set facts {}
        dict with record {
            if {[info exists width]} {lappend facts "$width × $height pixels"}
            if {[info exists samplesperpixel]} {lappend facts "$samplesperpixel samples per pixel"}
            if {[info exists noise] && $noise ne {}} {lappend facts "noise [percentText $noise]"}
            lappend facts [durationText $seconds]
            foreach file [dict keys $sources scenes/lib/*] {dict set shown lib $file 1}
        }
        set title [expr {$isNamed ? "<b>[escape $name]</b> " : ""}]
        return "<p class=\"facts\">$title[escape [join [lmap fact $facts {string map [list { } \u00a0] $fact}] { · }]]</p>\n[codeText {*}[sourceOf $name]]"
    }

    # Two digits, at least.
    proc percentText {part} {
        set percent [expr {100. * $part}]
        format [expr {$percent < 0.995 ? "%.2f %%" : $percent < 9.95 ? "%.1f %%" : "%.0f %%"}] $percent
    }

    # A title and the text of what made it.
    proc sourceOf {name} {
        variable root
        variable pictures
        set picture [dict get $pictures $name]
        if {[dict get $picture kind] eq "median"} {
            return [list gr_median "gr_median [dict get $picture from].png $name.png [dict get $picture n]"]
        }
        list [scriptOf $name] [text [file join $root [scriptOf $name]]]
    }

    proc codeText {title script} {
        return "<details><summary>[escape $title]</summary>\n<pre tabindex=\"0\"><code>[coloured $script]</code></pre>\n</details>\n"
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
        return "Quality “[dict get $shown quality]”: $count of [llength [names]] pictures, [durationText $seconds] in all."
    }

    proc objectivesText {} {
        variable objectives
        set html {}
        foreach objective $objectives {
            lassign $objective title words where
            incr number
            append html "<li id=\"objective-$number\">\n<h3>[escape $title]</h3>\n<blockquote>[marked $words]</blockquote>\n"
            append html "<p>[marked $where]</p>\n<p class=\"facts\"><code>tools/test -R objective_${number}_</code></p>\n</li>\n"
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
