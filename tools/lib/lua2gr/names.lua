-- Names of nodes, materials and lights.
local use = ...
local place = use("place")
local names = {}

-- Without what no name of grsh's may have, and what Tcl would make something else of.
local function plain(wish)
    local kept = utf8.len(wish) and "[^%w_.%-\x80-\xff]+" or "[^%w_.%-]+"
    return (wish:gsub(kept, "_"):gsub("^[_.%-]+", ""):gsub("[_.%-]+$", ""))
end

-- A name that is not in taken, and is then: with the last number that was put behind it.
function names.new(taken, wish, otherwise)
    local wished = plain(wish)
    if wished == "" then wished = otherwise end
    local name, count = wished, taken[wished] or 1
    while taken[name] do
        count = count + 1
        name = wished .. "_" .. count
    end
    taken[wished] = count
    taken[name] = taken[name] or 1
    return name
end

-- Lua's materials and lights have no names: they are called by the variables that hold them. A table of names by value:
-- of local variables of the functions that are running, outer ones rather than inner ones, and rather global ones.
function names.ofVariables(isWanted)
    local found = {}
    local function add(name, value)
        if isWanted(value) and type(name) == "string" then found[value] = name end
    end
    local _, level = place.frame()
    while level and debug.getinfo(level, "l") do
        local i = 1
        while debug.getlocal(level, i) do
            add(debug.getlocal(level, i))
            i = i + 1
        end
        level = level + 1
    end

    -- Of several names the first one in the alphabet, so that it is the same each time.
    local globals = {}
    for name in pairs(_G) do
        if type(name) == "string" then table.insert(globals, name) end
    end
    table.sort(globals, function(a, b) return a > b end)
    for _, name in ipairs(globals) do add(name, rawget(_G, name)) end
    return found
end

return names
