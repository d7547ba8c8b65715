-- Where the scene is, and what is told of it there.
local place = {}
local own
local seen = {}

function place.setOwnFolder(folder)
    own = "@" .. folder
end

-- The innermost function of the scene's own, as debug.getinfo tells of it; and its level, as the caller counts.
function place.frame()
    for level = 2, math.huge do
        local info = debug.getinfo(level, "Sl")
        if not info then return nil end
        if info.what ~= "C" and info.source:sub(1, #own) ~= own then return info, level - 1 end
    end
end

-- "scene.lua:12: ", or nothing where no scene is running.
function place.text()
    local info = place.frame()
    return info and info.short_src .. ":" .. info.currentline .. ": " or ""
end

function place.fail(message)
    error(place.text() .. message, 0)
end

function place.note(message)
    io.stdout:flush()
    io.stderr:write("lua2gr: warning: ", message, "\n")
end

-- Each kind of warning is told once, where it comes up first.
function place.warn(message, kind)
    if seen[kind] then return end
    seen[kind] = true
    place.note(place.text() .. message)
end

return place
