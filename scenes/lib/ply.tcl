# Meshes of binary PLY files, as scripts see them.

namespace eval ply {
    # Makes a gr_polyhedron of a file as models/*.ply are: triangles, and a normal at each vertex. The normals are left
    # out, so that each triangle is flat, which with gr_mesh it is not. Returns the node's path.
    proc flat {parent name file} {
        set channel [open $file rb]
        while {[gets $channel line] > 0 && $line ne "end_header"} {
            if {[lindex $line 0] eq "element"} {set count([lindex $line 1]) [lindex $line 2]}
        }
        binary scan [read $channel [expr {24 * $count(vertex)}]] r* numbers
        set vertices [lmap {x y z nx ny nz} $numbers {list $x $y $z}]
        # A face is the number of its corners, in one byte, and the corners.
        for {set i 0} {$i < $count(face)} {incr i} {
            binary scan [read $channel 13] ci3 corners face
            lappend faces $face
        }
        close $channel
        gr_polyhedron $parent $name $vertices $faces
    }
}
