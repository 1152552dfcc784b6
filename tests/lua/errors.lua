-- Wrong calls and the whole message each must give, deck and line included. The cases are in tests/lua/errors/*.lua, one file
-- per room: wrong("fabric.ramp", chunk, message). A chunk runs as the deck deck.lua with the objects below at hand.
-- Then the registry is gone through: a row that takes arguments needs
--   a case for each kind of argument it has (wrong type, wrong choice, wrong class of object),
--   a number out of range where there is a range, a missing argument where one is required, an unknown field where fields are named.
local fabric = require "fabric"
local registry = require "fabric.define".registry
local folder = arg[0]:gsub("%.lua$", "")

-- Objects that a chunk may use; made anew for each.
local makers = {
  mesh = function() return fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 } end,
  card = function() return fabric.card "blend" end,
  model = function(at) return fabric.model { mesh = at.mesh, card = at.card, warp = 90 } end,
  held = function(at) return at.model:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x") end,
  run = function(at)
    return fabric.static { model = at.held:move("top", { y = fabric.ramp(0.018, 1) }), duration = 1, step = 0.25 }
  end,
  snapshot = function(at) return at.run:snapshot() end,
  point = function(at) return fabric.point(at.card) end,
  history = function() return fabric.ramp(1, 1) end,
}

local function place()
  return setmetatable({ fabric = fabric }, {
    __index = function(at, name)
      local make = makers[name]
      if not make then return _G[name] end
      local value = make(at)
      rawset(at, name, value)
      return value
    end,
  })
end

local missed, count = 0, 0
local function miss(...)
  missed = missed + 1
  io.stderr:write(string.format(...), "\n")
end

local messages = {} -- by the row's name
local chunks = {}
local function wrong(name, chunk, message)
  count = count + 1
  chunks[#chunks + 1] = { chunk, message }
  messages[name] = messages[name] or {}
  table.insert(messages[name], message)
  local at = place()
  for _, object in ipairs { "run", "point" } do local _ = chunk:find(object, 1, true) and at[object] end
  local ok, got = pcall(assert(load(chunk, "=deck.lua", "t", at)))
  if ok then
    miss("%s: no error from\n  %s", name, chunk)
  elseif tostring(got) ~= message then
    miss("%s: %s\n  got:  %s\n  want: %s", name, chunk, tostring(got), message)
  end
end

-- Each file of cases gets wrong(); and so does each test beside this one that has its own, "local wrong = ...".
for _, file in ipairs(fabric.folder(folder)) do
  if file:find "%.lua$" then assert(loadfile(folder .. "/" .. file, "t", setmetatable({ wrong = wrong }, { __index = _G })))() end
end
local tests = folder:match "(.*)/"
for _, file in ipairs(fabric.folder(tests)) do
  local source <close> = file:find "%.lua$" and assert(io.open(tests .. "/" .. file)) or nil
  local text = source and source:read "a" or ""
  if text:find "\nlocal wrong = %.%.%." then assert(load(text, "@" .. file, "t"))(wrong) end
end

-- --- the same at the prompt: the session survives every one, and says as much ---

local function at_the_prompt()
  local path = os.tmpname()
  local file = assert(io.open(path, "w"))
  file:write "function fresh() mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3 } card = fabric.card 'blend' "
  file:write "model = fabric.model{ mesh=mesh, card=card, warp=90 } held = model:fix('all', 'z rotation'):fix('bottom', 'x y'):fix('top', 'x') "
  file:write "run = nil point = fabric.point(card) history = fabric.ramp(1, 1) end\n"
  file:write "function start() fresh() run = fabric.static{ model=held:move('top', { y=fabric.ramp(0.018, 1) }), duration=1, step=0.25 } "
  file:write "snapshot = run:snapshot() end\n"
  for _, case in ipairs(chunks) do
    local uses_run, used = case[1]:find("run", 1, true) or case[1]:find("snapshot", 1, true), false
    for name in pairs(makers) do used = used or case[1]:find(name, 1, true) end
    file:write(uses_run and "start() " or used and "fresh() " or "", case[1], "\n")
  end
  file:write "'still alive'\n"
  file:close()
  local pipe = assert(io.popen(("'%s' < '%s' 2>&1"):format(arg[-1], path)))
  local talk = pipe:read "a"
  pipe:close()
  os.remove(path)
  if not talk:find("still alive", 1, true) then miss("the session did not survive:\n%s", talk:sub(-2000)) end
  for _, case in ipairs(chunks) do
    local message = case[2]:gsub("^deck.lua:1:", "prompt:1:")
    if message ~= "nil" and not talk:find(message, 1, true) then miss("at the prompt, from %s: no '%s'", case[1], message) end
  end
end
at_the_prompt()

-- --- what is covered ---

local function find(arguments, path)
  for _, argument in ipairs(arguments) do
    if path == argument.name then return argument end
    local rest = path:match("^" .. argument.name .. "%.(.+)$")
    if rest then return find(argument.rows, rest) end
  end
end

local function signature(argument)
  return table.concat(argument.kinds, "|") .. (#argument.choices > 0 and " of choices" or "") .. (argument.of ~= "" and " " .. argument.of or "")
end

local function ranged(argument) return argument.low > -math.huge or argument.high < math.huge end

-- The coverage of a row by its messages: signatures of arguments, and the words range, missing, unknown.
local function covered(row)
  local seen = {}
  for _, message in ipairs(messages[row.name] or {}) do
    -- Where the nearest of many names is known, what came is told first.
    local path = message:match "field '([%w_.]+)': [eg][xo]" or message:match "argument '([%w_.]+)': [eg][xo]"
    local argument = path and find(row.arguments, path)
    local got = message:match ", got (.+)$" or message:match "': got (.+)$"
    if argument and got then
      if got:find "^nil" then seen.missing = true else seen[signature(argument)] = true end
      if ranged(argument) and tonumber((got:match "^%S+")) then seen.range = true end
    end
    if message:find("unknown field", 1, true) then seen.unknown = true end
  end
  return seen
end

local function needed(arguments, need)
  for _, argument in ipairs(arguments) do
    if argument.kinds[1] ~= "any" then need[signature(argument)] = argument.name end
    if argument.required and argument.kinds[1] ~= "any" then need.missing = argument.name end
    if ranged(argument) then need.range = argument.name end
    needed(argument.rows, need)
  end
  return need
end

local rows, there = 0, {}
for _, row in ipairs(registry.rows()) do
  there[row.name] = true
  local need = needed(row.arguments, row.style == "fields" and { unknown = "any" } or {})
  local seen = covered(row)
  if #row.arguments > 0 then rows = rows + 1 end
  for what, name in pairs(need) do
    if not seen[what] then miss("%s: no case for %s (as of '%s')", row.name, what, name) end
  end
end
for name in pairs(messages) do
  if not (there[name] or name:find "^lua" or name:find "^object") then miss("a case for '%s', which is not there", name) end
end

-- The names in a message are in one order from one start of the program to the next, which Lua's own order of a table is not.
do
  local ok, message = pcall(fabric.mesh.rectangle, { width = 1, zebra = 1, apple = 1, mango = 1 })
  if ok or not tostring(message):find("'apple'", 1, true) then miss("of several unknown fields not the first in the alphabet: %s", message) end
  ok, message = pcall(function() return fabric.mesh.rectangle { width = 1, height = 1, nx = 1, ny = 1 }.xylophone end)
  local before
  for name in tostring(message):match "known: (.*)%)":gmatch "%S+" do
    if before and name < before then miss("'%s' is listed after '%s'", name, before) end
    before = name
  end
  assert(not ok and before)
end

assert(missed == 0, missed .. " missed")
print(count .. " wrong calls, " .. rows .. " functions with arguments")
