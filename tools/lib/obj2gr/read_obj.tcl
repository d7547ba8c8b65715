# OBJ files, which grsh's own reader of them takes apart.

# Returns a dict:
#     vertices, normals   lists of {x y z}
#     parts               a dict of faces by {name material}; a face is a list of corners {vertex normal}, counted
#                         from 0, the normal being -1 where there is none
#     materials           what the MTL files hold
proc obj2gr::readObj {file} {
    if {![file isfile $file]} {fail "cannot read \"$file\": there is no such file"}
    set read [wordsOf $file]
    if {[llength [dict get $read parts]] == 0} {fail "$file: it has no faces"}
    set materials [materialsOf $file [dict get $read libraries] [dict get $read materials]]
    foreach {line key} [dict get $read leftOut] {warn "$file:$line: \"$key\" and others of its kind are left out"}
    set absent [lindex [dict get $read absent] 0]
    if {$absent > 0} {warn "$file: corners that name normals which are not there: $absent"}
    set parts {}
    foreach {name material faces} [dict get $read parts] {
        if {$name eq ""} {set name [file rootname [file tail $file]]}
        dict lappend parts [list $name $material] {*}$faces
    }
    dict create vertices [dict get $read vertices] normals [dict get $read normals] parts $parts materials $materials
}

# What grsh_import, which stands beside this program, makes of the file.
proc obj2gr::wordsOf {file} {
    set grsh [file dirname [file normalize [file join [info nameofexecutable] -]]]
    try {
        set channel [open |[list [file join [file dirname $grsh] grsh_import] --words $file 2>@1]]
        fconfigure $channel -encoding utf-8
        set words [read $channel]
        close $channel
    } on error {} {
        # What it has written is then the reason.
        set reason [string trim $words]
        if {![regsub {^line (\d+): } $reason "$file:\\1: " reason]} {set reason "$file: $reason"}
        fail $reason
    }
    return $words
}

# What the libraries hold, and warnings for the names that they do not. Both come with the lines that name them.
proc obj2gr::materialsOf {file libraries names} {
    set materials {}
    foreach {line words} $libraries {set materials [dict merge $materials [libraries $words $file $file:$line]]}
    foreach {line name} $names {
        if {[dict exists $materials $name]} {continue}
        warn "$file:$line: no such material \"$name\": it is grey"
        dict set materials $name {}
    }
    return $materials
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
