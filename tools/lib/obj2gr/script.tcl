# The script, and the mesh files beside it.
namespace eval obj2gr {
    proc largest {numbers} {lindex [lsort -real $numbers] end}
}

# A name that a node or a material may have, and that is not taken.
proc obj2gr::newName {takenName wish} {
    upvar $takenName taken
    regsub -all {[^\w.-]+} $wish _ plain
    set plain [string trim $plain _.-]
    if {$plain eq ""} {set plain part}
    set name $plain
    # In lower case: file systems may not tell capitals from others.
    for {set i 2} {[dict exists $taken [string tolower $name]]} {incr i} {set name ${plain}_$i}
    dict set taken [string tolower $name] 1
    return $name
}

# {low high} of all places that faces have.
proc obj2gr::boxOf {faces vertices} {
    set used {}
    foreach face $faces {
        foreach corner $face {dict set used [lindex $corner 0] 1}
    }
    foreach axis {0 1 2} {
        set coordinates [lsort -real [lmap i [dict keys $used] {lindex $vertices $i $axis}]]
        lappend low [lindex $coordinates 0]
        lappend high [lindex $coordinates end]
    }
    list $low $high
}

# Lamps of a part that shines, if it is one: returns whether all of it became lamps.
proc obj2gr::addLamps {buildName wish shine faces vertices} {
    upvar $buildName build
    if {[largest $shine] <= 0} {return 0}
    set lamps [lampsOf $faces $vertices]
    foreach places $lamps {lappend build(model) {*}[lampLines [newName build(nodes) $wish] $shine $places]}
    if {[llength $lamps] > 0} {set build(hasLamps) 1}
    expr {[llength $lamps] > 0}
}

# The node of a part, in the script or in a file of its own. Returns its name.
proc obj2gr::addMesh {buildName wish faces read out inline} {
    upvar $buildName build
    set vertices [dict get $read vertices]
    set name [newName build(nodes) $wish]
    if {[isInline $faces $vertices $inline]} {
        lappend build(model) {*}[polyhedronLines $name $faces $vertices]
    } else {
        set file [file rootname $out]-$name.ply
        dict set build(files) $file [ply $faces $vertices [dict get $read normals]]
        lappend build(model) "gr_mesh :model $name [list [file tail $file]]"
    }
    return $name
}

# The name of a material, which is made where it is used first.
proc obj2gr::addMaterial {buildName material words faces vertices} {
    upvar $buildName build
    if {![dict exists $build(given) $material]} {
        lassign [boxOf $faces $vertices] low high
        set thickness [expr {max([::tcl::mathop::+ {*}[minus $high $low]] / 3, 1e-9)}]
        dict set build(given) $material [newName build(materialNames) $material]
        lappend build(materials) \
            "gr_material [dict get $build(given) $material] [materialWords $material $words $thickness]"
    }
    dict get $build(given) $material
}

# A dict of the files by name, the script last.
proc obj2gr::scriptFiles {read model out inline} {
    dict with read {}
    array set build {files {} nodes {lamp 1} materialNames {} given {} materials {} model {} hasLamps 0}
    set all {}
    dict for {key faces} $parts {
        lassign $key wish material
        set faces [withArea $wish $faces $vertices]
        if {[llength $faces] == 0} {continue}
        lappend all {*}$faces
        set words [expr {[dict exists $materials $material] ? [dict get $materials $material] : {}}]
        if {[addLamps build $wish [dict get [dict merge {Ke {0 0 0}} $words] Ke] $faces $vertices]} {continue}
        set name [addMesh build $wish $faces $read $out $inline]
        if {$material ne ""} {
            lappend build(model) "gr_surfaceproperty :model:$name [addMaterial build $material $words $faces $vertices]"
        }
    }
    if {[llength $all] == 0} {fail "$model: none of its faces has an area"}
    set title "# [file tail $model], by tools/obj2gr. Coordinates are the model's own; y is taken to point up."
    set picture [file rootname [file tail $out]].png
    set lines [list $title "" {*}$build(materials) "" "gr_transform : model" {*}$build(model) \
        {*}[viewLines {*}[boxOf $all $vertices] $picture $build(hasLamps)]]
    dict set build(files) $out [encoding convertto utf-8 [join $lines \n]]
}
