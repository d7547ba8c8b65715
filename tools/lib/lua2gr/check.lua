-- What the arguments of gr's functions must be. Each check returns the value as it is kept, or fails.
local use = ...
local place, tcl = use("place"), use("tcl")
local check = {kinds = {}}
local kinds = check.kinds

-- As a message has it; short lists of numbers as they are.
local function shown(value)
    if type(value) == "string" then return '"' .. value .. '"' end
    if type(value) == "number" then return value == value and tostring(value) or "nan" end
    local kind = check.kindOf(value)
    if kind == "table" and #value <= 4 then
        local words = {}
        for _, part in ipairs(value) do table.insert(words, type(part) == "table" and "{...}" or shown(part)) end
        return "{" .. table.concat(words, ", ") .. "}"
    end
    return kind == "nil" and "nil" or "a " .. kind
end

-- "node", "material", "light", or Lua's type.
function check.kindOf(value)
    local meta = getmetatable(value)
    return type(value) == "table" and meta and meta.kind or type(value)
end

local function must(holds, name, what, value)
    if not holds then place.fail(check.now .. ": " .. name .. " must be " .. what .. ", not " .. shown(value)) end
end

local function isFinite(x) return x and x == x and math.abs(x) < math.huge end

function kinds.number(name, value)
    local x = tonumber(value)
    must(isFinite(x), name, "a finite number", value)
    return x
end

local function numberWhere(what, holds)
    return function(name, value)
        local x = tonumber(value)
        must(isFinite(x) and holds(x), name, what, value)
        return x
    end
end
kinds.positive = numberWhere("a number greater than 0", function(x) return x > 0 end)
kinds.pixels = numberWhere("a number of pixels, at least 1", function(x) return x >= 1 end)
kinds.angle = numberWhere("an angle between 0 and 180 degrees", function(x) return x > 0 and x < 180 end)
kinds.factor = numberWhere("a number other than 0", function(x) return x ~= 0 end)

-- A number that is cut off at most, and at 0, with a warning that says why.
local function cutOff(most, why)
    return function(name, value)
        local x = kinds.number(name, value)
        local kept = math.min(math.max(x, 0), most)
        if kept ~= x then
            local message = check.now .. ": " .. name .. " " .. tcl.number(x) .. " becomes " .. tcl.number(kept)
            place.warn(message .. why, check.now .. name)
        end
        return kept
    end
end
kinds.exponent = cutOff(1e6, "")

-- Three numbers of one kind.
local function tripleOf(kind, what)
    return function(name, value)
        must(check.kindOf(value) == "table" and #value == 3, name, what, value)
        local kept = {}
        for i = 1, 3 do kept[i] = kind(name .. "[" .. i .. "]", value[i]) end
        return kept
    end
end
kinds.triple = tripleOf(kinds.number, "{x, y, z}")
local notNegative = numberWhere("a number, at least 0", function(x) return x >= 0 end)
kinds.light_colour = tripleOf(notNegative, "{r, g, b}")

kinds.reflectance = tripleOf(cutOff(1, ": a surface reflects 0 to 1"), "{r, g, b}")

local falloff = tripleOf(notNegative, "{c0, c1, c2}")
function kinds.falloff(name, value)
    local kept = falloff(name, value)
    must(kept[1] + kept[2] + kept[3] > 0, name, "other than all 0", value)
    return kept
end

function kinds.joint_range(name, value)
    local range = tripleOf(kinds.number, "{least, initial, most}")(name, value)
    return math.min(math.max(range[2], range[1]), range[3])
end

-- A node without a name gets one.
function kinds.name(name, value)
    must(value == nil or type(value) == "string" or type(value) == "number", name, "a string", value)
    return tostring(value or "")
end

function kinds.file(name, value)
    must(type(value) == "string" and value ~= "", name, "a file's name", value)
    return value
end

function kinds.axis(name, value)
    local axis = type(value) == "string" and value:lower() or ""
    must(axis == "x" or axis == "y" or axis == "z", name, "'x', 'y' or 'z'", value)
    return axis
end

for _, kind in ipairs({"node", "material", "light"}) do
    kinds[kind] = function(name, value)
        must(check.kindOf(value) == kind, name, "a " .. kind, value)
        return value
    end
end

local function listOf(kind, what)
    return function(name, value)
        must(check.kindOf(value) == "table", name, what, value)
        local kept = {}
        for i = 1, #value do kept[i] = kind(name .. "[" .. i .. "]", value[i]) end
        return kept
    end
end
kinds.lights = listOf(kinds.light, "a list of lights")
kinds.vertices = listOf(kinds.triple, "a list of {x, y, z}")

local function corner(name, value)
    local i = math.tointeger(tonumber(value))
    must(i and i >= 0, name, "a vertex's number, from 0", value)
    return i
end
kinds.faces = listOf(function(name, value)
    must(check.kindOf(value) == "table" and #value >= 3, name, "a list of 3 or more numbers of vertices", value)
    return listOf(corner)(name, value)
end, "a list of faces")

return check
