-- What tools/lua2gr runs, in the scene's folder:
--     main.lua SCENE FOLDER NAME OUT OUTFOLDER PART ORDER
-- SCENE is the scene as it was named, NAME its name in FOLDER, OUT the script to make, in OUTFOLDER; it is written to
-- PART. Folders are absolute. ORDER is which of a node's transforms acts first, first or last; empty: not told.
local folder = arg[0]:match("^(.*/)") or "./"

-- Scenes have modules of their own: these are no modules that require() knows.
local loaded = {}
function loaded.use(name)
    loaded[name] = loaded[name] or assert(loadfile(folder .. name .. ".lua"))(loaded.use)
    return loaded[name]
end

local place, commands, older = loaded.use("place"), loaded.use("commands"), loaded.use("older")
local script = loaded.use("script")
place.setOwnFolder(folder)

if arg[1] == "--help" then
    io.write(loaded.use("help"), commands.usage(), "\n")
    return
end
local scene, sceneFolder, name, out, outFolder, part, order = table.unpack(arg)

local exit = os.exit

local function fail(message)
    io.stdout:flush()
    io.stderr:write("lua2gr: ", message, "\n")
    exit(1)
end

-- The scene as a function, whose errors name it as the caller did. A line that the shell reads is no Lua.
local function program()
    local file = assert(io.open(name, "rb"))
    local text = file:read("a"):gsub("^\u{FEFF}", ""):gsub("^#[^\n]*", "")
    file:close()
    return load(text, "@" .. scene, "t")
end

-- Runs the scene, until its end or its os.exit().
local function run(body)
    local ended = {}
    function os.exit(code)
        if code == nil or code == true or code == 0 then error(ended) end
        error(scene .. " ends with code " .. tostring(code), 0)
    end
    script.begin(sceneFolder, outFolder, order ~= "last")
    older.install(order == "")
    -- The same scene makes the same script each time.
    math.randomseed(1)
    arg = {[0] = scene}
    gr = commands.table
    local done, message = pcall(body)
    if done or message == ended then return end
    fail(type(message) == "string" and message or scene .. " fails with " .. tostring(message))
end

local body, problem = program()
if not body then fail(problem) end
run(body)
if script.renders() == 0 then
    fail(scene .. ": gr.render is never called, so there is no picture to make a script of")
end
script.warnOfLeftOut()

local file, done
file, problem = io.open(part, "wb")
if file then done, problem = file:write("# " .. name:gsub("%c", "?") .. ", by tools/lua2gr.\n" .. script.text()) end
if done then done, problem = file:close() end
if not done then fail('cannot write "' .. out .. '": ' .. problem) end
print("lua2gr: " .. out .. ", of " .. script.count() .. " nodes")
