-- Lua's values as words of Tcl.
local tcl = {}

-- As short as it can be while it is read as the very same number.
function tcl.number(x)
    if x == math.floor(x) and math.abs(x) < 1e15 then return string.format("%d", x) end
    for digits = 15, 17 do
        local text = string.format("%." .. digits .. "g", x)
        if tonumber(text) == x then return text end
    end
end

function tcl.list(numbers)
    local words = {}
    for i, x in ipairs(numbers) do words[i] = tcl.number(x) end
    return "{" .. table.concat(words, " ") .. "}"
end

-- A file's name as a word that stands for itself.
function tcl.word(text)
    if text:find("^[%w_./+%-\x80-\xff]+$") then return text end
    if not text:find("[{}\\]") then return "{" .. text .. "}" end
    return (text:gsub('[][{}\\"$;%s]', "\\%0"):gsub("\\\n", "\\n"))
end

return tcl
