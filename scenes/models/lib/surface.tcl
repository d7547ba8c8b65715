# A mesh of the surface of clay.tcl's lumps, by surface nets: space is cut into cells, each cell that the surface goes
# through gets a vertex, and where an edge of cells goes through the surface the vertices of the four cells round it
# are a face. Then the vertices are spread evenly, and moved onto the surface.

namespace eval surface {
    variable cell                ;# side of a cell
    variable low                 ;# corner of the cube that all of it lies in
    variable across              ;# cells along a side of the cube
    variable corners             ;# distances at the cells' corners that were asked for; a number for each corner
    variable cells               ;# of a cell with vertices: the one for each of its edges, or -1
    variable vertices {}         ;# {x y z}
    variable owners {}           ;# of a vertex: the lumps that matter near it
    variable faces {}            ;# four vertices each

    # A cell's corners are numbered x + 2y + 4z. Here are the two ends of each of its edges, and the corners and edges
    # round each of its sides.
    variable edges {0 1 2 3 4 5 6 7  0 2 1 3 4 6 5 7  0 4 1 5 2 6 3 7}
    variable sides {
        {0 1 3 2} {0 5 1 4}  {4 5 7 6} {2 7 3 6}  {0 1 5 4} {0 9 2 8}
        {2 3 7 6} {1 11 3 10}  {0 2 6 4} {4 10 6 8}  {1 3 7 5} {5 11 7 9}
    }

    # Makes the faces. The cube from the place `lowest` with 2^levels cells along a side must hold all lumps.
    proc build {lumps lowest side levels} {
        variable low $lowest
        variable across [expr {1 << $levels}]
        variable cell [expr {double($side) / $across}]
        # A lump matters where the surface is nearer to it than what it, or a later one, is smoothed over.
        set later 0
        set reaching {}
        foreach lump [lreverse $lumps] {
            set smooth [lindex $lump 1]
            lappend reaching [list {*}$lump [expr {$smooth + $later}]]
            if {$smooth > $later} {set later $smooth}
        }
        descend [lreverse $reaching] 0 0 0 $across
        variable cells
        foreach key [lsort -integer [array names cells]] {facesAt $key}
    }

    # Looks for the surface in a cube of `size` cells.
    proc descend {lumps i j k size} {
        variable cell
        variable low
        lassign $low x y z
        set half [expr {$size / 2.}]
        set x [expr {$x + ($i + $half) * $cell}]
        set y [expr {$y + ($j + $half) * $cell}]
        set z [expr {$z + ($k + $half) * $cell}]
        # From the middle to a corner, and more, since distances are not quite right.
        set radius [expr {1.25 * sqrt(3) * $half * $cell}]
        if {abs([clay::distance $lumps $x $y $z]) > $radius} return
        if {$size == 1} {
            verticesIn $lumps $i $j $k
            return
        }
        if {$size >= 4} {
            set lumps [lmap lump $lumps {
                if {[[lindex $lump 0] $x $y $z] > $radius + [lindex $lump 3]} continue
                set lump
            }]
        }
        set half [expr {$size / 2}]
        foreach {di dj dk} {0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1} {
            descend $lumps [expr {$i + $di * $half}] [expr {$j + $dj * $half}] [expr {$k + $dk * $half}] $half
        }
    }

    # A number for each corner, or cell.
    proc key {i j k} {
        variable across
        expr {($k * ($across + 1) + $j) * ($across + 1) + $i}
    }

    proc cornerDistance {lumps i j k} {
        variable corners
        set key [key $i $j $k]
        if {![info exists corners($key)]} {
            variable low
            variable cell
            lassign $low x y z
            set corners($key) [clay::distance $lumps [expr {$x + $i * $cell}] [expr {$y + $j * $cell}] \
                [expr {$z + $k * $cell}]]
        }
        return $corners($key)
    }

    # If the surface goes through a cell: a vertex for each of its pieces there, the mean of where the piece meets the
    # cell's edges. With one vertex for two pieces, the surface would touch itself there.
    proc verticesIn {lumps i j k} {
        variable edges
        set d {}
        foreach {dx dy dz} {0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1} {
            lappend d [cornerDistance $lumps [expr {$i + $dx}] [expr {$j + $dy}] [expr {$k + $dz}]]
        }
        set pieces [pieces [lmap distance $d {expr {$distance < 0}}]]
        if {![llength $pieces]} return
        variable low
        variable cell
        variable cells
        variable vertices
        variable owners
        set of [lrepeat 12 -1]
        foreach piece $pieces {
            lassign {0 0 0} x y z
            foreach edge $piece {
                lset of $edge [llength $vertices]
                lassign [lrange $edges [expr {2 * $edge}] [expr {2 * $edge + 1}]] a b
                set t [expr {[lindex $d $a] / ([lindex $d $a] - [lindex $d $b])}]
                set x [expr {$x + ($a & 1) + $t * (($b & 1) - ($a & 1))}]
                set y [expr {$y + ($a >> 1 & 1) + $t * (($b >> 1 & 1) - ($a >> 1 & 1))}]
                set z [expr {$z + ($a >> 2) + $t * (($b >> 2) - ($a >> 2))}]
            }
            lappend vertices [lmap o $low c [list $i $j $k] sum [list $x $y $z] {
                expr {$o + ($c + $sum / [llength $piece]) * $cell}
            }]
            lappend owners $lumps
        }
        set cells([key $i $j $k]) $of
    }

    # The pieces of the surface in a cell, each a list of the edges that it meets. inside: of each corner, 1 or 0.
    proc pieces {inside} {
        variable sides
        set pieces {}
        foreach {corners around} $sides {
            # On a side of the cell the surface cuts off each run of corners that are inside.
            for {set c 0} {$c < 4} {incr c} {
                set before [expr {($c + 3) % 4}]
                if {![lindex $inside [lindex $corners $c]] || [lindex $inside [lindex $corners $before]]} continue
                set last $c
                while {[lindex $inside [lindex $corners [expr {($last + 1) % 4}]]]} {incr last}
                set joined [list [lindex $around $before] [lindex $around [expr {$last % 4}]]]
                set apart {}
                foreach piece $pieces {
                    if {[lindex $joined 0] in $piece || [lindex $joined 1] in $piece} {
                        lappend joined {*}$piece
                    } else {
                        lappend apart $piece
                    }
                }
                set pieces [list {*}$apart [lsort -integer -unique $joined]]
            }
        }
        return $pieces
    }

    # The faces round the three edges that begin at a cell's first corner, counter-clockwise seen from outside.
    proc facesAt {key} {
        variable across
        variable corners
        variable cells
        variable faces
        set x 1
        set y [expr {$across + 1}]
        set z [expr {$y * $y}]
        set inside [expr {$corners($key) < 0}]
        # Of each edge: the four cells round it, and which of their edges it is.
        foreach {along u v around} [list $x $y $z {3 2 0 1} $y $z $x {7 5 4 6} $z $x $y {11 10 8 9}] {
            if {($corners([expr {$key + $along}]) < 0) == $inside} continue
            set face {}
            foreach back [list [expr {$u + $v}] $v 0 $u] edge $around {
                lappend face [lindex $cells([expr {$key - $back}]) $edge]
            }
            lappend faces [expr {$inside ? $face : [lreverse $face]}]
        }
    }

    # Moves each vertex halfway to the middle of its neighbours, then onto the surface (a step of Newton's method).
    proc spread {} {
        variable vertices
        variable owners
        variable faces
        set count [llength $vertices]
        set sums [lrepeat $count {0 0 0 0}]
        foreach face $faces {
            set last [lindex $face end]
            foreach next $face {
                foreach {vertex neighbour} [list $last $next $next $last] {
                    lassign [lindex $sums $vertex] x y z n
                    lassign [lindex $vertices $neighbour] u v w
                    lset sums $vertex [list [expr {$x + $u}] [expr {$y + $v}] [expr {$z + $w}] [incr n]]
                }
                set last $next
            }
        }
        set vertices [lmap vertex $vertices sum $sums lumps $owners {
            set n [lindex $sum 3]
            clay::towards $lumps [lmap a $vertex b [lrange $sum 0 2] {expr {($a + $b / $n) / 2}}]
        }]
    }

    # Two triangles for each face, cut along the shorter of its diagonals.
    proc triangles {} {
        variable vertices
        variable faces
        set result {}
        foreach face $faces {
            lassign $face a b c d
            lassign [lmap v $face {lindex $vertices $v}] p q r s
            set first [clay::minus $p $r]
            set second [clay::minus $q $s]
            if {[clay::dot $first $first] < [clay::dot $second $second]} {
                lappend result [list $a $b $c] [list $a $c $d]
            } else {
                lappend result [list $a $b $d] [list $b $c $d]
            }
        }
        return $result
    }

    # Writes a binary PLY file with a normal at each vertex.
    proc write {file} {
        variable vertices
        variable owners
        set triangles [triangles]
        set header [list ply {format binary_little_endian 1.0} "element vertex [llength $vertices]"]
        foreach property {x y z nx ny nz} {lappend header "property float $property"}
        lappend header "element face [llength $triangles]" {property list uchar int vertex_indices} end_header
        set channel [open $file wb]
        puts $channel [join $header \n]
        foreach vertex $vertices lumps $owners {
            puts -nonewline $channel [binary format r6 [list {*}$vertex {*}[clay::unit [clay::slope $lumps $vertex]]]]
        }
        foreach triangle $triangles {puts -nonewline $channel [binary format ci3 3 $triangle]}
        close $channel
    }
}
