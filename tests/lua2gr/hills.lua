-- Hills by formula, and what stands on them: meshes from loops, from a module beside the scene, and from a file.
local stars = require('stars')

grass = gr.material({0.3, 0.6, 0.2}, {0.0, 0.0, 0.0}, 0)
gold = gr.material({0.5, 0.4, 0.1}, {0.5, 0.4, 0.2}, 60)
clay = gr.material({0.7, 0.4, 0.3}, {0.1, 0.1, 0.1}, 10)

local function height(x, z)
    return stars.rounded(0.8 * math.sin(x) * math.cos(z / 2))
end

-- A square from -3 to 3 of 6 x 6 fields, two triangles each.
local n = 6
local vertices, faces = {}, {}
for i = 0, n do
    for k = 0, n do
        local x, z = -3 + 6 * i / n, -3 + 6 * k / n
        table.insert(vertices, {x, height(x, z), z})
    end
end
for i = 0, n - 1 do
    for k = 0, n - 1 do
        local a = i * (n + 1) + k
        local b = a + n + 1
        table.insert(faces, {a, a + 1, b + 1})
        table.insert(faces, {a, b + 1, b})
    end
end

scene = gr.node('hills')
scene:rotate('y', 15)
ground = gr.mesh('ground', vertices, faces)
ground:set_material(grass)
scene:add_child(ground)

for i = 1, 4 do
    local x, z = -2.5 + i, (-1) ^ i
    local star = gr.mesh('star', stars.outline(4 + i))
    star:set_material(gold)
    star:scale(0.5, 0.5, 0.5)
    star:translate(x, height(x, z) + 0.7, z)
    scene:add_child(star)
end

for line in io.lines('tents.txt') do
    local x, z, angle = line:match('(%S+) (%S+) (%S+)')
    local tent = gr.mesh('tent', 'tent.obj')
    tent:set_material(clay)
    tent:rotate('y', angle)
    tent:translate(x, 0.4 + height(x, z), z)
    scene:add_child(tent)
end

l1 = gr.light({-10, 8, 6}, {0.7, 0.7, 0.6}, {1, 0, 0})
gr.render(scene, 'hills.png', 160, 120, {0, 4, 9}, {0, -4, -9}, {0, 1, 0}, 35, {0.3, 0.3, 0.4}, {l1})
