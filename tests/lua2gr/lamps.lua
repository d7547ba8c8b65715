-- A room with lamps of each falloff, by shapes that are placed as they are made, a model of another file that is read by
-- dofile, and a picture for each lamp and one of all.
white = gr.material({0.8, 0.8, 0.8}, {0, 0, 0}, 0)
shiny = gr.material({0.2, 0.5, 0.4}, {0.6, 0.6, 0.6}, 100)

room = gr.node('room')
for i, at in ipairs({{-5, -11, -5}, {-5, -1, -15}, {-15, -1, -5}}) do
    local wall = gr.nh_box('wall ' .. i, at, 10)
    wall:set_material(white)
    room:add_child(wall)
end

dofile('table.lua')
room:add_child(round_table(1, 1.5))
room:add_child(round_table(-2.5, 0))

local ball = gr.nh_sphere('ball', {1.2, 0.7, 1.7}, 0.4)
ball:set_material(shiny)
room:add_child(ball)
local roof = gr.nh_cone('roof', {-2.5, 0.3, 0}, 0.5, 0.9)
roof:set_material(white)
room:add_child(roof)

local all = {
    gr.light({3, 6, 3}, {0.4, 0.4, 0.3}, {1, 0, 0}),
    gr.light({-3, 4, 2}, {1.5, 0.3, 0.3}, {0, 1, 0}),
    gr.light({3, 3, -3}, {2, 2, 8}, {0.5, 0.25, 1}),
}

local function render(name, lights)
    print('the picture ' .. name)
    gr.render(room, name, 80, 60, {9, 7, 11}, {-9, -6.5, -11}, {0, 1, 0}, 38, {0.05, 0.05, 0.05}, lights)
end
for i, light in ipairs(all) do render('lamp' .. i .. '.png', {light}) end
render('lamps.png', all)
