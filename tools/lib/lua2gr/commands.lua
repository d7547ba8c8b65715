-- The functions of the table gr, and the methods of nodes: a row each.
local use = ...
local place, check, spelling, script = use("place"), use("check"), use("spelling"), use("script")
local commands = {}

local Material, Light, Node = {kind = "material"}, {kind = "light"}, {kind = "node"}

-- shape is the kind of shape, and words what stands behind its name in the script; a node without only holds others.
local function node(name, shape, words)
    return script.note(setmetatable({name = name, shape = shape or false, words = words or false, children = {},
        isParentOf = {}, transforms = {}, turn = {}, material = false}, Node))
end

local function shape(kind)
    return function(name, ...)
        return node(name, kind, script.shapeWords(...))
    end
end

local function mesh(name, vertices, faces)
    for f, face in ipairs(faces) do
        for _, i in ipairs(face) do
            if i >= #vertices then
                place.fail("gr.mesh: faces[" .. f .. "] names vertex " .. i .. " of 0 to " .. #vertices - 1)
            end
        end
    end
    if #vertices == 0 or #faces == 0 then place.fail("gr.mesh: a mesh must have vertices and faces") end
    return node(name, "polyhedron", script.polyhedronWords(vertices, faces))
end

local function meshFile(name, file)
    local opened, problem = io.open(file, "rb")
    if not opened or not opened:read(0) then place.fail("gr.mesh: cannot read " .. (problem or '"' .. file .. '"')) end
    opened:close()
    return node(name, "mesh", script.meshWords(file))
end

-- In a row: the function, what must be given to it as {name, kind}, and what it does.
local functions = {
    node = {function(name) return node(name) end, {"name", "name"}},
    joint = {function(name, x, y)
        local made = node(name)
        made.turn = {{"rotate", "x", x}, {"rotate", "y", y}}
        return made
    end, {"name", "name"}, {"x", "joint_range"}, {"y", "joint_range"}},
    sphere = {shape("sphere"), {"name", "name"}},
    cube = {shape("box"), {"name", "name"}},
    cylinder = {shape("cylinder"), {"name", "name"}},
    cone = {shape("cone"), {"name", "name"}},
    nh_sphere = {shape("sphere"), {"name", "name"}, {"centre", "triple"}, {"radius", "positive"}},
    nh_box = {shape("box"), {"name", "name"}, {"corner", "triple"}, {"size", "positive"}},
    nh_cylinder = {shape("cylinder"), {"name", "name"}, {"foot", "triple"}, {"radius", "positive"},
        {"height", "positive"}},
    nh_cone = {shape("cone"), {"name", "name"}, {"foot", "triple"}, {"radius", "positive"}, {"height", "positive"}},
    mesh = {mesh, {"name", "name"}, {"vertices", "vertices"}, {"faces", "faces"}},
    meshFile = {meshFile, {"name", "name"}, {"file", "file"}},
    material = {function(kd, ks, exponent)
        return setmetatable({kd = kd, ks = ks, exponent = exponent}, Material)
    end, {"kd", "reflectance"}, {"ks", "reflectance"}, {"shininess", "exponent"}},
    light = {function(position, colour, falloff)
        return setmetatable({position = position, colour = colour, falloff = falloff}, Light)
    end, {"position", "triple"}, {"colour", "light_colour"}, {"falloff", "falloff"}},
    render = {script.render, {"root", "node"}, {"file", "file"}, {"width", "pixels"}, {"height", "pixels"},
        {"eye", "triple"}, {"view", "triple"}, {"up", "triple"}, {"fov", "angle"}, {"ambient", "light_colour"},
        {"lights", "lights"}},
}

local function transform(...)
    local words = {...}
    return function(self, ...)
        table.insert(self.transforms, {table.unpack(words), ...})
    end
end

-- Whether a node is below another, or the same.
local function isBelow(wanted, start, seen)
    if wanted == start then return true end
    seen[start] = true
    for _, child in ipairs(start.children) do
        if not seen[child] and isBelow(wanted, child, seen) then return true end
    end
end

local methods = {
    add_child = {function(self, child)
        if isBelow(self, child, {}) then
            place.fail('add_child: node "' .. self.name .. '" would contain itself')
        end
        if self.isParentOf[child] then
            place.warn('add_child: "' .. child.name .. '" is a child of "' .. self.name .. '" already', child)
            return
        end
        self.isParentOf[child] = true
        table.insert(self.children, child)
    end, {"child", "node"}},
    set_material = {function(self, material) self.material = material end, {"material", "material"}},
    translate = {transform("translate"), {"x", "number"}, {"y", "number"}, {"z", "number"}},
    scale = {transform("scale"), {"x", "factor"}, {"y", "factor"}, {"z", "factor"}},
    rotate = {transform("rotate"), {"axis", "axis"}, {"degrees", "number"}},
}

-- A function that checks its arguments by their row.
local function checked(name, row, first)
    local action = row[1]
    return function(...)
        check.now = name
        local kept = {}
        if first then kept[1] = check.kinds.node('what stands before "' .. name .. '(" with a colon', (...)) end
        local given, taken = select("#", ...), #row - 1 + #kept
        for i = 2, #row do
            table.insert(kept, check.kinds[row[i][2]](row[i][1], (select(#kept + 1, ...))))
        end
        if given > taken then
            place.warn(name .. ": " .. given - taken .. " more arguments than are known: left out", name)
        end
        return action(table.unpack(kept, 1, taken))
    end
end

local made = {}
for name, row in pairs(functions) do made[name] = checked("gr." .. name, row) end
local fromLists, fromFile = made.mesh, checked("gr.mesh", functions.meshFile)
made.meshFile = nil
function made.mesh(...)
    if type((select(2, ...))) == "string" then return fromFile(...) end
    return fromLists(...)
end

local ofNode = {}
for name, row in pairs(methods) do ofNode[name] = checked(name, row, true) end

local function namesOf(list)
    local names = {}
    for name in pairs(list) do table.insert(names, name) end
    return names
end

function Node.__index(_, key)
    if ofNode[key] then return ofNode[key] end
    place.fail('a node has no "' .. tostring(key) .. '": ' .. spelling.known(tostring(key), namesOf(methods)))
end

-- "gr.sphere(name)" and the like, a line for each.
function commands.usage()
    local lines = {}
    local function add(list, prefix)
        for name, row in pairs(list) do
            local words = {}
            for i = 2, #row do words[i - 1] = row[i][1] end
            local called = prefix .. name:gsub("^meshFile$", "mesh")
            table.insert(lines, "    " .. called .. "(" .. table.concat(words, ", ") .. ")")
        end
    end
    add(functions, "gr.")
    add(methods, "node:")
    table.sort(lines)
    return table.concat(lines, "\n")
end

commands.table = setmetatable({}, {__index = function(_, key)
    if made[key] then return made[key] end
    place.fail("no such function gr." .. tostring(key) .. ": " .. spelling.known(tostring(key), namesOf(made)))
end})

return commands
