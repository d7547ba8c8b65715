-- A mobile of three arms, for hierarchy: nodes that are placed more than once, shapes that hold others, a joint, names
-- that are alike or that grsh could not have, and transforms whose order matters.
local wire = gr.material({0.3, 0.3, 0.35}, {0.4, 0.4, 0.4}, 40)
red = gr.material({0.8, 0.2, 0.1}, {0, 0, 0}, 1)
blue = gr.material({0.1, 0.3, 0.8}, {0.2, 0.2, 0.2}, 30)

-- A fish looks along +x: its body is a stretched ball, its tail a cone below it.
local fish = gr.sphere('fish: body')
fish:scale(1.0, 0.6, 0.3)
fish:set_material(red)
local tail = gr.cone('tail')
tail:scale(0.8, 0.9, 0.8)
tail:rotate('z', -90)
tail:translate(-1.6, 0, 0)
tail:set_material(blue)
fish:add_child(tail)

local function arm(angle)
    local turned = gr.node('arm')
    turned:translate(0, -1.2, 0)
    turned:rotate('X', 10)
    turned:rotate('Y', angle)

    local rod = gr.cylinder('')
    rod:scale(0.06, 3, 0.06)
    rod:rotate('Z', -90)
    rod:set_material(wire)
    turned:add_child(rod)

    local hanging = gr.node('hanging')
    hanging:scale(0.9, 0.9, 0.9)
    hanging:rotate('Z', 90)
    hanging:rotate('Y', 180 - angle / 2)
    hanging:translate(2.6, -1, 0)
    hanging:add_child(fish)
    turned:add_child(hanging)
    return turned
end

local root = gr.joint('the mobile', {-90, 12, 90}, {0, 20, 15})
root:translate(0, 2, 0)
for i = 0, 2 do root:add_child(arm(120 * i)) end

local hook = gr.cube('hook')
hook:translate(-0.5, 0, -0.5)
hook:scale(0.2, 0.8, 0.2)
hook:set_material(wire)
root:add_child(hook)

local sun = gr.light({20, 30, 40}, {0.9, 0.9, 0.8}, {1, 0, 0})
gr.render(root, 'mobile.png', 160, 120, {0, 0, 11}, {0, 0, -1}, {0, 1, 0}, 40, {0.2, 0.2, 0.25}, {sun})
