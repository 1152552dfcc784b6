-- Every function, method and property of the registry that is not written in Lua, with wrong values of every kind in every
-- place: an error or an answer, and the program lives. Usage: fabricsh --safe fuzz.lua <folder> [seed] [rounds] [tell]. The values hang on the
-- seed alone, so that a death can be repeated; each call is said before it is made where the fourth argument is tell.
local fabric = require "fabric"
local registry = require("fabric.define").registry
local folder, tell = (arg[1] or "out") .. "/fuzz", arg[4] == "tell"
local state = math.tointeger(tonumber(arg[2] or 1))
local function random(n)
  state = (state * 6364136223846793005 + 1442695040888963407) & 0x7fffffffffffffff
  return (state >> 33) % n + 1
end

local function model()
  local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
  return m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"), mesh
end
local make = {
  mesh = function() return (select(2, model())) end,
  model = function() return (model()) end,
  card = function() return fabric.card "blend" end,
  history = function() return fabric.ramp(1, 1) end,
  point = function() return fabric.point(fabric.card "blend") end,
  analysis = function()
    local m = model():move("top", { y = fabric.ramp(0.01, 1) })
    local kind = random(3)
    if kind == 1 then return fabric.static { model = m, duration = 1, step = 0.5 } end
    return fabric.dynamic { model = m, duration = 1e-4, scheme = kind == 2 and "explicit" or "implicit", step = kind == 3 and 5e-5 or "auto" }
  end,
}
make.snapshot = function() return make.analysis():snapshot() end

local function lie()
  local answers = random(3)
  return setmetatable({}, { __index = function(_, k) return answers == 1 and k or answers == 2 and {} or nil end, __len = function() return random(5) end,
                            __tostring = function() return answers end })
end
-- Values that anything may be given.
local plain = { 0, -1, 1, 2, 1.5, 1e300, -1e300, 1e-300, 0 / 0, 1 / 0, -1 / 0, math.mininteger, math.maxinteger, 1 << 31, "", "x", "all", "top", "a\0b",
                ("x"):rep(300), "step", "y", "E11", true, false, print, io.stdout, function() return 1 end, function() error {} end,
                function() return {} end, function() end, coroutine.create(print), folder .. "/a.csv", folder .. "/a.vtu", "1e9" }
local function value(depth)
  local kind = random(10)
  if kind <= 5 or depth > 3 then return plain[random(#plain)] end
  if kind == 6 then
    local names = { "mesh", "model", "card", "history", "point", "analysis" }
    return make[names[random(#names)]]()
  end
  if kind == 7 then return lie() end
  local t = {}
  for i = 1, random(4) - 1 do t[i] = value(depth + 1) end
  if kind == 8 then
    local keys = { "x", "y", "z", "E", "S", "warp", "mass", "name", 0, 2.5 }
    for _ = 1, random(3) do t[keys[random(#keys)]] = value(depth + 1) end
  end
  return t
end

-- A value that a row asks for, as a rule; counts stay small.
local function fitting(row)
  local kinds = {}
  for _, kind in ipairs(row.kinds) do kinds[#kinds + 1] = kind end
  local kind = kinds[random(#kinds)]
  if #row.choices > 0 then return row.choices[random(#row.choices)] end
  if kind == "number" or kind == "integer" then return math.max(row.low > -1e300 and row.low or 1, random(3)) end
  if kind == "text" then return plain[14 + random(8)] end
  if kind == "boolean" then return random(2) == 1 end
  if kind == "function" then return plain[26] or print end
  if kind == "numbers" then return { random(3), random(3) } end
  if kind == "object" and make[row.of] then return make[row.of]() end
  if kind == "fields" then
    local t = {}
    for _, inner in ipairs(row.rows) do if inner.required or random(2) == 1 then t[inner.name] = random(4) > 1 and fitting(inner) or value(1) end end
    return t
  end
  return value(1)
end

-- Functions that take long or end the program by their purpose, and those made of other functions in Lua.
local function left_out(entry)
  return entry.name:find "^fabric%.lab%.%l" and not (entry.name:find "least" or entry.name:find "ident" or entry.name:find "reduce" or entry.name:find "branches"
    or entry.name:find "marks" or entry.name:find "backbone" or entry.name:find "monotone" or entry.name:find "unloading" or entry.name:find "band"
    or entry.name:find "boxes" or entry.name:find "ratio" or entry.name:find "%.track$") or entry.name == "fabric.study" or entry.name == "fabric.budget" or entry.name == "fabric.render"
    or entry.name == "analysis:advance" or entry.name:find "^fabric%.help" or entry.name == "fabric.plot"
end

local function call(entry)
  local f, first = nil, nil
  if entry.owner ~= "" then
    if not make[entry.owner] then return end
    first = make[entry.owner]()
    local word = entry.name:match "[^.:]+$"
    if entry.style == "property" then return first[word] end
    f = first[word]
  else
    f = fabric
    for word in entry.name:gmatch "[^.]+" do if word ~= "fabric" then f = f[word] end end
  end
  local given, n = {}, 0
  for i, row in ipairs(entry.arguments) do
    local v
    if random(4) == 1 then v = value(1) elseif row.required or random(3) == 1 then v = fitting(row) end
    if entry.style == "fields" then given[row.name] = v else given[i], n = v, i end
  end
  if tell then io.stderr:write(entry.name, " ", tostring(given[1]), "\n") end
  local answer
  if entry.style == "fields" then
    if first then answer = f(first, given) else answer = f(random(20) == 1 and value(1) or given) end
  elseif first then
    answer = f(first, table.unpack(given, 1, n))
  else
    answer = f(table.unpack(given, 1, n))
  end
  registry.show(answer)
  if type(answer) == "userdata" and random(4) == 1 and pcall(function() return answer.time end) then answer:solve() end
end

local entries = {}
for _, entry in ipairs(registry.rows()) do
  if not left_out(entry) then entries[#entries + 1] = entry end
end
local calls, refused = 0, 0
for _ = 1, math.tointeger(tonumber(arg[3] or 20)) do
  for _, entry in ipairs(entries) do
    calls = calls + 1
    if not pcall(call, entry) then refused = refused + 1 end
  end
end
assert(refused > calls / 4 and refused < calls)
print(("%d calls of %d functions, %d refused"):format(calls, #entries, refused))
