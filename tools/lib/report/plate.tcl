# A plate of the page: its picture or pictures, its words, what each picture took, and the script that made it.
namespace eval ::report {
    proc plateText {plate} {
        dict with plate {
            set names [dict keys $pictures]
            set html "<article class=\"plate $shape\" id=\"$id\">\n<figure>\n[${shape}Text $plate]\n<figcaption>\n"
            append html "<p class=\"label\">[escape $label]</p>\n<h3>[escape $title]</h3>\n<p>[marked $text]</p>\n"
            foreach name $names {append html [factsText $name [expr {[llength $names] > 1}]]}
            append html "</figcaption>\n</figure>\n"
            foreach name $names {append html [scriptText $name]}
            append html "</article>\n"
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
        if {![isShown $first] || ![isShown $second]} {return [rowText $plate]}
        lassign [lmap side [dict get $plate sides] {escape $side}] left right
        set crisp [expr {[dict exists $plate crisp] ? " crisp" : ""}]
        return "<div class=\"slider$crisp\">
[imageText $second $secondAlt]
[imageText $first $firstAlt over]
<span class=\"side left\">$left</span><span class=\"side right\">$right</span>
<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"how much is seen of: $left, not: $right\" />
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

    # What it took.
    proc factsText {name isNamed} {
        variable shown
        if {![isShown $name]} return
        set record [readRecord [dict get $shown folder] $name]
        set facts {}
        dict with record {
            if {[info exists width]} {lappend facts "$width × $height"}
            if {[info exists samplesperpixel]} {lappend facts "$samplesperpixel samples per pixel"}
            if {[info exists noise] && $noise ne {}} {lappend facts "noise [percentText $noise]"}
            lappend facts [durationText $seconds]
            foreach file [dict keys $sources scenes/lib/*] {dict set shown lib $file 1}
        }
        # A line ends between two facts, not within one.
        set facts [join [lmap fact $facts {string map [list { } \u00a0] $fact}] { · }]
        set title [expr {$isNamed ? "<b>[escape $name]</b> " : ""}]
        return "<p class=\"facts\">$title[escape $facts]</p>\n"
    }

    # Two digits, at least.
    proc percentText {part} {
        set percent [expr {100. * $part}]
        format [expr {$percent < 0.995 ? "%.2f %%" : $percent < 9.95 ? "%.1f %%" : "%.0f %%"}] $percent
    }

    # What made it.
    proc scriptText {name} {
        variable root
        variable pictures
        if {![isShown $name]} return
        set picture [dict get $pictures $name]
        if {[dict get $picture kind] eq "median"} {
            return [codeText gr_median "gr_median [dict get $picture from].png $name.png [dict get $picture n]"]
        }
        codeText [scriptOf $name] [text [file join $root [scriptOf $name]]]
    }

    proc codeText {title script} {
        set code "<pre tabindex=\"0\"><code>[coloured $script]</code></pre>"
        return "<details><summary>[escape $title]</summary>\n$code\n</details>\n"
    }
}
