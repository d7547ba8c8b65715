-- A round table that stands on y = -1, its middle at x, z.
function round_table(x, z)
    local whole = gr.node('table')
    local leg = gr.nh_cylinder('leg', {x, -1, z}, 0.2, 1.2)
    leg:set_material(shiny)
    whole:add_child(leg)
    local top = gr.nh_cylinder('top', {x, 0.2, z}, 1, 0.1)
    top:set_material(white)
    whole:add_child(top)
    return whole
end
