# The radiances in a .pfm file, as a flat list.
proc radiances {file} {
    set channel [open $file rb]
    set bytes [read $channel]
    close $channel
    regexp -indices {^PF\n\d+ \d+\n\S+\n} $bytes header
    binary scan $bytes @[expr {[lindex $header 1] + 1}]r* numbers
    return $numbers
}

# The root of the mean of (x - ref)^2/(ref^2 + 0.01) over pixels and channels.
proc relativeError {picture converged} {
    set sum 0.
    foreach x $picture ref $converged {set sum [expr {$sum + ($x - $ref) ** 2 / ($ref ** 2 + 0.01)}]}
    expr {sqrt($sum / [llength $converged])}
}
