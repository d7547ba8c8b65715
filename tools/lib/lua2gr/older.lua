-- What Lua 5.1 had and later ones have not, for the scenes of that time.
local use = ...
local place = use("place")
local older = {}

local functions = {
    {_G, "", "unpack", table.unpack},
    {_G, "", "loadstring", load},
    {table, "table.", "getn", function(list) return #list end},
    {string, "string.", "gfind", string.gmatch},
    {math, "math.", "mod", math.fmod},
    {math, "math.", "pow", function(x, y) return x ^ y end},
}

-- They tell the age of a scene, and so which of its transforms acts first: worth a word where that was not told.
function older.install(isToBeTold)
    for _, row in ipairs(functions) do
        local list, prefix, name, action = table.unpack(row)
        list[name] = function(...)
            if isToBeTold then
                place.warn(prefix .. name .. " is Lua 5.1's, and so old are the scenes whose transforms act from the " ..
                    "last to the first: if this is one, --order last; --order first says that it is not", "order")
            end
            return action(...)
        end
    end
end

return older
