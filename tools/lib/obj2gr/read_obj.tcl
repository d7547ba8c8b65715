# OBJ files.

# What else OBJ files have: lines, points, curves, and what only other renderers know of.
namespace eval obj2gr {
    variable statements {
        l p vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con mg bevel c_interp d_interp lod
        shadow_obj trace_obj ctech stech maplib usemap call csh
    }
}

# Returns a dict:
#     vertices, normals   lists of {x y z}
#     parts               a dict of faces by {name material}; a face is a list of corners {vertex normal}, counted
#                         from 0, the normal being -1 where there is none
#     materials           what the MTL files hold
proc obj2gr::readObj {file} {
    if {![file isfile $file]} {fail "cannot read \"$file\": there is no such file"}
    foreach key {v vt vn} {set lists($key) {}}
    set parts {}
    set materials {}
    set name [file rootname [file tail $file]]
    set material ""
    set left {}
    foreach {line words} [linesOf $file] {
        set place $file:$line
        set words [lassign $words key]
        switch -- $key {
            v - vn {lappend lists($key) [numbersOf $words 3 $place]}
            vt {lappend lists(vt) {}}
            f {
                if {[llength $words] < 3} {fail "$place: a face needs 3 corners at least, not [llength $words]"}
                dict lappend parts [list $name $material] [corners $words lists $place]
            }
            o - g {if {[llength $words] > 0} {set name [join $words]}}
            usemtl {
                set material [join $words]
                if {![dict exists $materials $material]} {
                    warn "$place: no such material \"$material\": it is grey"
                    dict set materials $material {}
                }
            }
            mtllib {set materials [dict merge $materials [libraries $words $file $place]]}
            s {}
            default {
                if {$key ni $::obj2gr::statements} {
                    regsub -all {[^ -~]} [string range $key 0 20] ? shown
                    fail "$place: \"$shown\" is nothing that an OBJ file has"
                }
                if {$key ni $left} {warn "$place: \"$key\" and others of its kind are left out"}
                lappend left $key
            }
        }
    }
    if {[dict size $parts] == 0} {fail "$file: it has no faces"}
    dict create vertices $lists(v) normals $lists(vn) parts $parts materials $materials
}

# A face's corners, written as v, v/vt, v//vn or v/vt/vn.
proc obj2gr::corners {words listsName place} {
    upvar $listsName lists
    lmap word $words {
        if {![regexp {^(-?\d+)(?:/(-?\d+)?(?:/(-?\d+))?)?$} $word - v vt vn]} {
            fail "$place: \"$word\" is not a corner: it must be v, v/vt, v//vn or v/vt/vn"
        }
        if {$vt ne ""} {index $vt [llength $lists(vt)] "texture vertex" $place}
        list [index $v [llength $lists(v)] vertex $place] \
            [expr {$vn eq "" ? -1 : [index $vn [llength $lists(vn)] normal $place]}]
    }
}

# From 0. In the file they count from 1, or backwards from -1, the last one so far.
proc obj2gr::index {word count what place} {
    scan $word %lld number
    if {$number == 0 || abs($number) > $count} {fail "$place: a face names $what $word of $count"}
    expr {$number > 0 ? $number - 1 : $count + $number}
}

# mtllib names one file, which may have blanks in its name, or several.
proc obj2gr::libraries {words file place} {
    set folder [file dirname $file]
    if {[file isfile [file join $folder [join $words]]]} {set words [list [join $words]]}
    set materials {}
    foreach word $words {
        set library [file join $folder $word]
        if {[file isfile $library]} {
            set materials [dict merge $materials [readMtl $library]]
        } else {
            warn "$place: there is no file \"$word\": its materials are grey"
        }
    }
    return $materials
}
