-- What gr.render asks for, as lines of a scene script.
local use = ...
local place, tcl, names = use("place"), use("tcl"), use("names")
local script = {}

local state

-- The absolute folders of the scene and of its script, and which of a node's transforms acts first.
function script.begin(sceneFolder, folder, firstActsFirst)
    state = {sceneFolder = sceneFolder, folder = folder, firstActsFirst = firstActsFirst, lines = {}, tree = "",
        renders = 0, count = 0, nodes = {}, rendered = {}, materials = {}, materialNames = {}, lights = {},
        lightNames = {}}
end

-- Every node that the scene makes is told here.
function script.note(node)
    table.insert(state.nodes, node)
    return node
end

-- A node that no picture shows is a slip more often than not.
function script.warnOfLeftOut()
    local left = {}
    for _, node in ipairs(state.nodes) do
        if not state.rendered[node] then table.insert(left, '"' .. node.name .. '"') end
    end
    if #left == 0 then return end
    local shown = table.concat(left, ", ", 1, math.min(#left, 5)) .. (#left > 5 and ", ..." or "")
    place.note("below no node that is rendered, and left out: " .. shown)
end

function script.renders() return state.renders end
function script.count() return state.count end
function script.text() return table.concat(state.lines, "\n") .. "\n" end

local function add(lines, ...) table.insert(lines, table.concat({...}, " ")) end

-- What stands behind a shape's name.
function script.shapeWords(at, ...)
    if not at then return "" end
    local words = {tcl.list(at)}
    for _, size in ipairs({...}) do table.insert(words, tcl.number(size)) end
    return table.concat(words, " ")
end

function script.polyhedronWords(vertices, faces)
    local lines = {"{"}
    for _, vertex in ipairs(vertices) do add(lines, "   ", tcl.list(vertex)) end
    add(lines, "} {")
    for _, face in ipairs(faces) do add(lines, "   ", tcl.list(face)) end
    add(lines, "}")
    return table.concat(lines, "\n")
end

-- The path of a file of the scene's folder, as seen from the script's.
function script.meshWords(file)
    if file:sub(1, 1) == "/" then return tcl.word(file) end
    return tcl.word(use("paths").relative(file, state.sceneFolder, state.folder))
end

-- Whether a transform leaves everything where it is.
local function isNothing(transform)
    local neutral = transform[1] == "scale" and 1 or 0
    for i = 2, #transform do
        if type(transform[i]) == "number" and transform[i] ~= neutral then return false end
    end
    return true
end

local function transformLine(path, transform)
    local name, x = transform[1], transform[2]
    local words = type(x) == "string" and x .. " " .. tcl.number(transform[3]) or tcl.list({table.unpack(transform, 2)})
    return "gr_" .. name .. " " .. path .. " " .. words
end

-- In a script the transform that is written last acts first.
local function addTransforms(lines, path, node)
    local count = #node.transforms
    for i = 1, count do
        local transform = node.transforms[state.firstActsFirst and count + 1 - i or i]
        if not isNothing(transform) then add(lines, transformLine(path, transform)) end
    end
    for _, transform in ipairs(node.turn) do
        if not isNothing(transform) then add(lines, transformLine(path, transform)) end
    end
end

-- The material's name; one that is new is added to the tree's materials.
local function materialName(tree, material)
    if not tree.materials[material] then
        tree.materials[material] = true
        local known = state.materials[material]
        if not known then
            known = names.new(state.materialNames, tree.variables[material] or "material", "material")
            state.materials[material] = known
        end
        add(tree.materialLines, "gr_material", known, tcl.list(material.kd), tcl.list(material.ks),
            tcl.number(material.exponent))
    end
    return state.materials[material]
end

local addNode

local function addShape(tree, parent, name, node)
    local words = node.words ~= "" and {node.words} or {}
    add(tree.lines, "gr_" .. node.shape, parent == "" and ":" or parent, name, table.unpack(words))
end

-- A node that is there already is placed once more; a shape that holds others is a node with them below it.
function addNode(tree, parent, taken, node)
    local name = names.new(taken, node.name, node.shape or "node")
    local path = parent .. ":" .. name
    local above = parent == "" and ":" or parent
    if tree.paths[node] then
        add(tree.lines, "gr_instance", above, name, tree.paths[node])
        return path
    end
    tree.paths[node] = path
    tree.count = tree.count + 1
    local isLeaf = node.shape and #node.children == 0
    if #node.children > 0 and tree.lines[#tree.lines] ~= "" then add(tree.lines) end
    if isLeaf then addShape(tree, parent, name, node) else add(tree.lines, "gr_transform", above, name) end
    addTransforms(tree.lines, path, node)
    local below, shape = {}, path
    if node.shape and not isLeaf then
        local own = names.new(below, node.shape, "shape")
        addShape(tree, path, own, node)
        shape = path .. ":" .. own
    end
    if node.material then add(tree.lines, "gr_surfaceproperty", shape, materialName(tree, node.material)) end
    for _, child in ipairs(node.children) do addNode(tree, path, below, child) end
    return path
end

-- Light lines, and the names of the lights. One that is listed twice shines twice.
local function addLights(lights, variables)
    local called, times = {}, {}
    for _, light in ipairs(lights) do
        times[light] = (times[light] or 0) + 1
        state.lights[light] = state.lights[light] or {}
        local name = state.lights[light][times[light]]
        if not name then
            name = names.new(state.lightNames, variables[light] or "light", "light")
            state.lights[light][times[light]] = name
            add(state.lines, "gr_light", name, tcl.list(light.position), tcl.list(light.colour),
                tcl.list(light.falloff))
        end
        table.insert(called, name)
    end
    return called
end

-- A picture's name as grsh takes it: the course's pictures are PNG, whatever they are called.
local function pictureName(file)
    if file:lower():find("%.png$") or file:lower():find("%.exr$") then return tcl.word(file) end
    place.warn('gr.render: "' .. file .. '" becomes "' .. file .. '.png"', "picture")
    return tcl.word(file .. ".png")
end

local function kindsWanted(value)
    local meta = type(value) == "table" and getmetatable(value)
    return meta and (meta.kind == "material" or meta.kind == "light")
end

-- The tree is written where it is another than for the picture before.
function script.render(root, file, width, height, eye, view, up, fov, ambient, lights)
    local tree = {lines = {}, materialLines = {}, materials = {}, paths = {}, count = 0,
        variables = names.ofVariables(kindsWanted)}
    local path = addNode(tree, "", {}, root)
    for node in pairs(tree.paths) do state.rendered[node] = true end
    local text = table.concat(tree.materialLines, "\n") .. "\n" .. table.concat(tree.lines, "\n")
    if text ~= state.tree then
        if state.renders > 0 then
            add(state.lines, "\ngr_reset")
            state.lights, state.lightNames = {}, {}
        end
        add(state.lines)
        table.insert(state.lines, (text:gsub("^\n+", "")))
        state.tree = text
        state.count = tree.count
    end
    add(state.lines)
    local called = addLights(lights, tree.variables)
    add(state.lines, "gr_render", path, pictureName(file), tcl.number(math.floor(width)),
        tcl.number(math.floor(height)), tcl.list(eye), tcl.list(view), tcl.list(up), tcl.number(fov), tcl.list(ambient),
        "{" .. table.concat(called, " ") .. "} \\\n    antialiasing on")
    state.renders = state.renders + 1
end

return script
