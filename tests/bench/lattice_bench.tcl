# Lattices of balls that fill the same part of the picture however many they are, with the grid and with Embree: the
# seconds of rendering on one thread, the least of some runs that take turns, and the bytes that each ball takes.

source [file join [file dirname [info script]] .. .. scenes lib performance.tcl]

set rounds 3
set picture [file join [expr {[info exists env(TMPDIR)] ? $env(TMPDIR) : "/tmp"}] lattice-bench-[pid].png]
foreach {shape n} {square 32  square 100  square 320  square 1000  cube 10  cube 30  cube 100} {
    gr_reset
    performance::scene $shape $n
    foreach accelerator {grid embree} {set best($accelerator) Inf}
    for {set round 0} {$round < $rounds} {incr round} {
        foreach accelerator {grid embree} {
            set result [performance::render $picture 300 accelerator $accelerator integrator report threads 1 samplesperpixel 16 \
                progress off]
            set best($accelerator) [expr {min($best($accelerator), [dict get $result rendering])}]
            set build($accelerator) [dict get $result build]
            set bytes($accelerator) [expr {double([dict get $result bytes] - [dict get $result memory picture])}]
        }
    }
    set balls [dict get [gr_stats] nodes spheres]
    puts [format "%-6s %7d  grid %.3f s, built in %.3f s, %.0f bytes a ball  embree %.3f s, %.3f s, %.0f  grid / embree %.2f" \
        $shape $balls $best(grid) $build(grid) [expr {$bytes(grid) / $balls}] $best(embree) $build(embree) \
        [expr {$bytes(embree) / $balls}] [expr {$best(grid) / $best(embree)}]]
}
file delete $picture
