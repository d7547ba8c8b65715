# A library for line_source_top.gr.
gr_material clay diffuse
gr_material clay diffuse diffuse {0.1 0.2 0.3}
