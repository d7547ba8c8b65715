# Faces, as gr_polyhedron and PLY files have them.

# Twice the face's area along its normal.
proc obj2gr::normalOf {places} {
    set first [lindex $places 0]
    set sum {0 0 0}
    foreach a [lrange $places 1 end-1] b [lrange $places 2 end] {
        set sum [plus $sum [cross [minus $a $first] [minus $b $first]]]
    }
    return $sum
}

# Whether gr_polyhedron takes the face for sure: at no corner the outline turns back, and it goes round once.
proc obj2gr::isConvex {places} {
    if {[llength [lsort -unique $places]] < [llength $places]} {return 0}
    set normal [normalOf $places]
    set first [lindex $places 0]
    set before [lindex $places end]
    foreach place $places after [list {*}[lrange $places 1 end] $first] {
        if {[dot [cross [minus $place $before] [minus $after $place]] $normal] <= 0} {return 0}
        if {$place ne $first && $after ne $first
            && [dot [cross [minus $place $first] [minus $after $first]] $normal] <= 0} {return 0}
        set before $place
    }
    return 1
}

# Whether a part can be written as a gr_polyhedron: it is small, flat, and of convex faces.
proc obj2gr::isInline {faces vertices inline} {
    if {[llength $faces] > $inline} {return 0}
    foreach face $faces {
        if {[llength [lsort -unique [lmap corner $face {lindex $corner 1}]]] > 1} {return 0}
        if {![isConvex [lmap corner $face {lindex $vertices [lindex $corner 0]}]]} {return 0}
    }
    return 1
}

# Faces as numbers of corners, and the corners that they number: {corners faces}. Corners are alike if their words are.
proc obj2gr::numbered {faces} {
    set numbers {}
    set faces [lmap face $faces {
        lmap corner $face {
            if {![dict exists $numbers $corner]} {dict set numbers $corner [dict size $numbers]}
            dict get $numbers $corner
        }
    }]
    list [dict keys $numbers] $faces
}

proc obj2gr::polyhedronLines {name faces vertices} {
    lassign [numbered [lmap face $faces {lmap corner $face {lindex $corner 0}}]] corners faces
    set lines [list "gr_polyhedron :model $name \{"]
    foreach corner $corners {lappend lines "    {[shown [lindex $vertices $corner]]}"}
    lappend lines "\} \{"
    foreach face $faces {lappend lines "    {$face}"}
    lappend lines "\}"
}

proc obj2gr::ply {faces vertices normals} {
    lassign [numbered $faces] corners faces
    set isSmooth [expr {[lsearch -exact -index 1 $corners -1] < 0}]
    set lines [list ply "format binary_little_endian 1.0" "element vertex [llength $corners]"]
    foreach axis [expr {$isSmooth ? {x y z nx ny nz} : {x y z}}] {lappend lines "property float $axis"}
    lappend lines "element face [llength $faces]" "property list int int vertex_indices" end_header ""
    set bytes [encoding convertto utf-8 [join $lines \n]]
    foreach corner $corners {
        lassign $corner vertex normal
        append bytes [binary format r3 [lindex $vertices $vertex]]
        if {$isSmooth} {append bytes [binary format r3 [lindex $normals $normal]]}
    }
    foreach face $faces {append bytes [binary format ii* [llength $face] $face]}
    return $bytes
}

# Faces without area, of which grsh makes nothing, are left out.
proc obj2gr::withArea {part faces vertices} {
    set kept [lmap face $faces {
        if {[size [normalOf [lmap corner $face {lindex $vertices [lindex $corner 0]}]]] == 0} {continue}
        set face
    }]
    set count [expr {[llength $faces] - [llength $kept]}]
    if {$count > 0} {warn "part \"$part\": faces without area are left out: $count"}
    return $kept
}
