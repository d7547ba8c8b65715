# A library for line_source.gr.

# Makes a ball.
proc ball {name} {
    gr_sphere : $name
}
