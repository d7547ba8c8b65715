-- Words that are almost spelled like others.
local spelling = {}

-- How many letters must be put in, left out or replaced to make one word of the other (Levenshtein 1966).
local function distance(a, b)
    local row = {}
    for j = 0, #b do row[j] = j end
    for i = 1, #a do
        local diagonal = row[0]
        row[0] = i
        for j = 1, #b do
            local replaced = diagonal + (a:byte(i) == b:byte(j) and 0 or 1)
            diagonal = row[j]
            row[j] = math.min(row[j] + 1, row[j - 1] + 1, replaced)
        end
    end
    return row[#b]
end

-- "known are a, b, c (did you mean "b"?)"
function spelling.known(word, words)
    table.sort(words)
    local text = "known are " .. table.concat(words, ", ")
    local best, least
    for _, known in ipairs(words) do
        local far = distance(word:lower(), known)
        if far <= math.max(1, #known // 3) and (not least or far < least) then best, least = known, far end
    end
    return best and text .. ' (did you mean "' .. best .. '"?)' or text
end

return spelling
