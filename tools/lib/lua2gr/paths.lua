-- Paths of files as seen from other folders.
local paths = {}

local function parts(path)
    local list = {}
    for part in path:gmatch("[^/]+") do
        if part == ".." then
            table.remove(list)
        elseif part ~= "." then
            table.insert(list, part)
        end
    end
    return list
end

-- file, below the absolute folder "from" or found from there, as seen from the absolute folder "to".
function paths.relative(file, from, to)
    local there, here = parts(from .. "/" .. file), parts(to)
    local same = 0
    while same < #here and same < #there - 1 and here[same + 1] == there[same + 1] do same = same + 1 end
    return ("../"):rep(#here - same) .. table.concat(there, "/", same + 1)
end

return paths
