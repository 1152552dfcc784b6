-- Attacks on the boundary between Lua and C++: each is refused with an error, or does no harm. A program that reads or
-- writes where it must not dies here, under the sanitizers at the latest. Usage: fabricsh [--safe] boundary.lua <folder>
-- that it may write into. Run twice: under --safe, and with all of Lua (finalisers).
local fabric = require "fabric"
local kernels = require "fabric.kernels"
local define = require "fabric.define"
local folder = (arg[1] or "out") .. "/boundary"
local safe = getmetatable "" == false
local count, missed = 0, {}

-- A strip of three elements, pulled in four steps.
local function strip(kind)
  local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x")
  return mesh, m
end
local function pulled(history)
  local mesh, m = strip()
  m:move("top", { y = history or fabric.ramp(0.018, 1) })
  return fabric.static { model = m, duration = 1, step = 0.25 }, m, mesh
end

-- f is refused with these words (a pattern), or, where there are none, only survived.
local function attack(name, words, f)
  count = count + 1
  local good, trouble = pcall(f)
  if words == nil and not (type(trouble) == "string" and trouble:find "assertion failed") then return end
  local said = good and "nothing" or type(trouble) == "string" and trouble or select(2, pcall(tostring, trouble))
  if good or not said:find(words or "survived") then missed[#missed + 1] = ("%s: expected words '%s', got '%s'"):format(name, words, said) end
end

-- A table that shows `first` when a field is asked for the first time, and `later` ever after.
local function liar(first, later)
  local asked = {}
  return setmetatable({}, { __index = function(_, key)
    if asked[key] then return later[key] end
    asked[key] = true
    return first[key]
  end })
end

-- Functions of the library that were written in C by hand.
local registry = define.registry
local function squares(answer) return kernels.least_squares { start = { 0.5 }, low = { 0 }, high = { 3 }, evaluate = answer } end
for _, answer in ipairs { 0x4242424242, "text", true, print } do
  attack("residuals that are no table", "evaluate: expected a table, got", function() squares(function() return answer end) end)
end
attack("residuals that are nothing", "evaluate: expected a table, got nil", function() squares(function() end) end)
attack("residuals of no points", "evaluate: expected a list of numbers, got nil", function() squares(function() return {} end) end)
attack("residuals that are lists of texts", "evaluate", function() squares(function() return { { "x" } } end) end)
attack("residuals of another length later", "evaluate: expected as many residuals at every point %(2%), got 40", function()
  local calls = 0
  squares(function(points)
    calls = calls + 1
    local out = {}
    for i = 1, #points do
      out[i] = {}
      for k = 1, calls == 1 and 2 or 40 do out[i][k] = k + points[i][1] end
    end
    return out
  end)
end)
attack("residuals that are fewer later", "evaluate: expected as many residuals", function()
  local calls = 0
  squares(function(points)
    calls = calls + 1
    local out = {}
    for i = 1, #points do out[i] = calls == 1 and { 1, 2, points[i][1] } or { points[i][1] } end
    return out
  end)
end)
attack("an error that cannot say itself", nil, function()
  squares(function() error(setmetatable({}, { __tostring = function() error "again" end })) end)
end)
for _, value in ipairs { 5, "x", true, print, io.stdout } do
  attack("nearest of no list", "table expected", function() registry.nearest("x", value) end)
end
attack("nearest without a list", "table expected", function() registry.nearest "x" end)
attack("nearest among numbers", "expected a list of names", function() registry.nearest("x", { 1, 2 }) end)
attack("nearest among tables", "expected a list of names", function() registry.nearest("x", { {}, {} }) end)
attack("nearest of nothing", "string expected", function() registry.nearest(nil, { "x" }) end)
attack("nearest of a table", "string expected", function() registry.nearest({}, { "x" }) end)
attack("nearest of a list that lies about its length", nil, function() registry.nearest("x", setmetatable({}, { __len = function() return 1e9 end })) end)
attack("show of nothing", "value expected", function() registry.show() end)
attack("show of what changes while it is shown", nil, function()
  local t = {}
  for i = 1, 30 do t["k" .. i] = setmetatable({}, { __tostring = function() for k in pairs(t) do t[k] = nil end return "x" end }) end
  registry.show(t)
end)
attack("show of what grows while it is shown", nil, function()
  local t, n = {}, 0
  t[1] = setmetatable({}, { __tostring = function() for _ = 1, 100 do n = n + 1 t["more" .. n] = n end return "x" end })
  t[2], t.a, t.b = t[1], t[1], t[1]
  registry.show(t)
end)
attack("show of a table in itself", nil, function() local t = {} t.t = t t[1] = t registry.show(t) end)
attack("name_of nothing", "value expected", function() registry.name_of() end)
attack("class_of nothing", nil, function() registry.class_of() end)
attack("class_of a file", nil, function() registry.class_of(io.stdout) end)
attack("fail with a table", "string expected", function() define.fail {} end)

-- Rows of one's own.
local function new(fields) return function() define(fields) end end
local function many(n)
  local rows = {}
  for i = 1, n do rows[i] = { name = "a" .. i, sentence = "x", kind = "any", optional = true } end
  return rows
end
local function row(fields) fields.name = fields.name or "fabric.attack.row" fields.run = fields.run or function() end return fields end
attack("400 arguments", nil, function()
  define(row { name = "fabric.attack.many", positional = true, arguments = many(400) })
  fabric.attack.many()
  fabric.attack.many(table.unpack({}, 1, 400))
end)
attack("100,000 named arguments", nil, function()
  define(row { name = "fabric.attack.named", arguments = many(1e4) })
  fabric.attack.named {}
end)
attack("rows that hold themselves", "deep in one another", function()
  local rows = {}
  rows[1] = { name = "a", kind = "fields", rows = rows }
  define(row { arguments = rows })
end)
attack("a row that is a number", "expected a table", new(row { arguments = { 5 } }))
attack("a row without a name", "field 'name'", new(row { arguments = { {} } }))
attack("a function without a name", "field 'name'", new { run = print })
attack("a name without a module", "field 'name'", new { name = "attack", run = print })
attack("a name that ends in a full stop", "field 'name'", new { name = "fabric.", run = print })
attack("a name of nothing", "field 'name'", new { name = "", run = print })
attack("a name with two colons", "field 'name'", new { name = "mesh:a:b", run = print })
attack("nothing to run", "field 'run'", new { name = "fabric.attack.none" })
attack("a kind that there is not", "unknown kind", new(row { arguments = { { name = "a", kind = "pointer" } } }))
attack("define without anything", "table expected", function() define() end)
attack("a default of another kind", nil, function()
  define(row { name = "fabric.attack.default", arguments = { { name = "n", kind = "integer", default = "x" }, { name = "m", kind = "integer", default = 1e300 } } })
  fabric.attack.default {}
end)
attack("a method in place of the mesh's own", nil, function()
  define { name = "mesh:attack", positional = true, arguments = {}, run = function() end }
  strip():attack()
end)

-- Tables of the library, and metatables of what it returns.
attack("units that are a number", "fabric.units: expected a table, got 5", function()
  local units = fabric.units
  fabric.units = 5
  local good, trouble = pcall(fabric.globals)
  local drawn, words = pcall(fabric.plot, { curves = { { x = { 1, 2 }, y = { 1, 2 } } }, xunit = "mm" })
  fabric.units = units
  assert(not drawn and words:find "fabric.units: expected a table")
  if not good then error(trouble, 0) end
end)
attack("units that lie", nil, function()
  local units = fabric.units
  fabric.units = setmetatable({}, { __index = function() error "no" end, __pairs = error })
  local _, trouble = pcall(fabric.globals), pcall(fabric.who)
  fabric.units = units
end)
attack("a module in place of a function", nil, function()
  local before = fabric.lab
  fabric.lab = 7
  pcall(define, row { name = "fabric.lab.attack" })
  fabric.lab = before
end)
local function closed(name, value)
  attack("the metatable of " .. name, nil, function() assert(getmetatable(value) == false, name) end)
  attack("another metatable for " .. name, "protected metatable", function() setmetatable(value, {}) end)
end
local numbers = folder .. "/numbers.csv"
fabric.write(numbers, "a,b\n1,2\n")
local failed = select(2, pcall(function()
  local _, m = strip()
  m:move("top", { y = -0.07 })
  fabric.static { model = m, duration = 1, step = 1, max_cuts = 0, max_iterations = 4 }:solve()
end))
assert(failed.kind == "numerical")
closed("fabric", fabric)
closed("fabric.lab", fabric.lab)
closed("fabric.mesh", fabric.mesh)
closed("define", define)
closed("a table", fabric.table { file = numbers })
closed("who", fabric.who())
closed("a card's report", fabric.card "blend":check())
closed("a mesh's report", strip():check())
closed("a failure", failed)
for _, value in ipairs { failed, fabric.table { file = numbers }, fabric.who(), fabric.card "blend":check(), strip():check() } do
  attack("a result that was emptied", nil, function()
    for k in pairs(value) do value[k] = nil end
    tostring(value)
  end)
  attack("a result with other things in it", nil, function()
    for _, k in ipairs { "text", "where", "message", "file", 1, 2 } do value[k] = k == 2 and {} or print end
    tostring(value)
  end)
end
for name, value in pairs { mesh = strip(), card = fabric.card "blend", analysis = pulled(), history = fabric.ramp(1, 1), nodes = strip().nodes } do
  attack("the metatable of the object " .. name, nil, function() assert(type(getmetatable(value)) ~= "table") end)
  attack("a field of the object " .. name, name == "nodes" and "." or "cannot be assigned", function() value.x = 1 end)
end
attack("a method with another object", "called without its mesh", function() strip().map(fabric.card "blend", print) end)
attack("a method with a number", "called without its analysis", function() pulled().solve(5) end)
attack("a method with a file", "called without its model", function() local _, m = strip() m.fix(io.stdout, "all", "x") end)
attack("a list of nodes called", nil, function() strip().elements(1, 2, 3) end)
attack("a node of every name", nil, function()
  local nodes = strip().nodes
  for _, key in ipairs { 0, -1, 1e300, 0 / 0 ~= 0 and 2.5, "x", {}, print, math.mininteger, math.maxinteger } do local _ = nodes[key] end
end)

-- Tables that change their answers between the check and the use.
attack("a mesh that is none the second time", nil, function()
  local mesh = strip()
  fabric.model(liar({ mesh = mesh, card = fabric.card "blend", points = 3 }, { mesh = 5, card = "x" }))
end)
attack("a model that is none the second time", nil, function()
  local _, m = strip()
  fabric.static(liar({ model = m, duration = 1 }, { duration = "x" }))
end)
attack("a model in motion that is none the second time", nil, function()
  local _, m = strip()
  fabric.dynamic(liar({ model = m, duration = 1e-3, damping = liar({ mass = 1 }, { mass = {} }) }, { damping = 5 }))
end)
attack("a card of lies", nil, function()
  local yarn = liar({ loading = { 1e6 }, unloading = 2e6, poisson = 0.1 }, { loading = 5, unloading = {}, poisson = print })
  fabric.woven(liar({ density = 500, thickness = 1e-3, warp = yarn, weft = yarn, shear = liar({ loading = { 1e5 }, unloading = 1e5 }, {}) }, { warp = 5 }))
end)
attack("jacobians that are gone the second time", nil, function()
  kernels.identifiability(liar({ jacobian = { 1, 0, 0, 1 }, scale = { 1, 1 } }, { scale = {}, jacobian = {} }))
end)
attack("a scale that is emptied by the jacobian", nil, function()
  local scale = { 1, 1 }
  kernels.identifiability(setmetatable({ scale = scale }, { __index = function(_, k)
    if k == "jacobian" then scale[1], scale[2] = nil, nil return { 1, 0, 0, 1 } end
  end }))
end)
attack("layers that change", nil, function()
  local layers = {}
  layers[1] = setmetatable({}, { __index = function(_, k)
    layers[1], layers[2] = nil, 7
    if k == "card" then return fabric.card "blend" end
  end })
  fabric.model { mesh = strip(), layers = layers }
end)
attack("curves of lies", nil, function()
  fabric.plot { curves = { liar({ x = { 1, 2, 3 }, y = { 1, 2, 3 } }, { x = 5, y = {} }) } }
end)
attack("curves that turn into texts and files", nil, function()
  pcall(fabric.plot, { curves = { liar({ x = { 1, 2 }, y = { 1, 2 } }, { x = io.stdout, y = 7 }) } })
  fabric.plot { curves = { liar({ x = { 1, 2 }, y = { 1, 2 } }, { x = "abcdef", y = "abcdef" }) } }
end)
attack("rows of a curve that change", nil, function()
  local rows = {}
  rows[1] = setmetatable({}, { __index = function() rows[1], rows[2] = 5, 6 return 1 end })
  rows[2] = {}
  fabric.plot { curves = { { rows = rows, x = "E", y = "S" } } }
end)
attack("components of lies", nil, function() local _, m = strip() m:force("top", liar({ x = fabric.ramp(1, 1) }, { x = io.stdout })) end)
attack("a stiffness of lies", nil, function() local _, m = strip() m:spring("top", liar({ x = 1 }, { x = {} })) end)
attack("a velocity of lies", nil, function() local _, m = strip() m:velocity("top", liar({ spin = { 1, 2, 3 } }, { spin = { 1 } })) end)
attack("a turn of lies", nil, function() local _, m = strip() m:turn("top", liar({ axis = { 1, 0, 0 }, angle = 1 }, { axis = {}, angle = io.stdout })) end)
attack("columns of lies", nil, function()
  local a = pulled()
  a:record(folder .. "/lies.csv", liar({ columns = { x = function() return 1 end } }, { columns = 5, every = {} }))
  a:solve()
end)
attack("columns that change while they are read", nil, function()
  local a, columns = pulled(), nil
  columns = setmetatable({ x = function() return 1 end }, { __index = function() columns.x = nil end })
  a:record(folder .. "/change.csv", { columns = columns, order = { "x", "y" } })
end)
attack("a card's changes that hold themselves", nil, function()
  local t = {}
  t.warp = t
  fabric.card "blend":with(t)
end)
attack("a card's changes that lie", nil, function() fabric.card "blend":with(liar({ warp = { poisson = 0.1 } }, { warp = 5 })) end)
attack("strains of lies", nil, function() fabric.point(fabric.card "blend"):path(setmetatable({}, { __len = function() return 1e9 end, __index = function() return { 0, 0, 0 } end })) end)
attack("tracks whose numbers of markers overflow", "expected at least two frames", function()
  kernels.boxes { rows = 1 << 32, columns = 1 << 32, x = { 1 }, y = { 1 } }
end)
attack("degrees below zero", "whole numbers from 1 to 20", function() fabric.lab.backbone { curves = { { E = { 0.1, 0.2 }, S = { 1, 2 } } }, degrees = { -1e300 } } end)
attack("degrees beyond all", "whole numbers from 1 to 20", function() fabric.lab.backbone { curves = { { E = { 0.1, 0.2 }, S = { 1, 2 } } }, degrees = { 1e9 } } end)

-- Counts.
attack("iterations beyond an int", "at most 2147483647", function() local _, m = strip() fabric.static { model = m, duration = 1, max_iterations = 1 << 40 } end)
attack("a node beyond all", "expected a smaller integer", function() pulled():node(math.maxinteger) end)
attack("a node in pieces", "an integer", function() pulled():node(1.5) end)
attack("an element below all", "of at least 1", function() pulled():element(math.mininteger) end)
attack("a set of node 1e300", "expected node numbers", function() strip():set("s", { 1e300 }) end)
attack("a mesh beyond memory", nil, function() fabric.mesh.rectangle { width = 1, height = 1, nx = math.maxinteger, ny = math.maxinteger } end)
attack("a photograph beyond memory", "30000", function() fabric.lab.photograph { file = folder .. "/x.png", rows = 2, columns = 2, pitch = 4, radius = 1, width = 1 << 31, height = 1 << 31 } end)
attack("a million million items", "from 1 to 1e%+07", function() fabric.lab.parallel { count = 10 ^ 12, work = function() return { 1 } end } end)
attack("a step without end", "expected at least 1e%-10 s", function() local _, m = strip() fabric.static { model = m, duration = 1, step = 1e-300 } end)
attack("a step in motion without end", "expected at least 1e%-10 s", function() local _, m = strip() fabric.dynamic { model = m, duration = 1, step = 1e-300, scheme = "implicit" } end)
attack("an explicit step without end", "expected at least 1e%-10 s", function() local _, m = strip() fabric.dynamic { model = m, duration = 1, step = 1e-300 } end)
attack("a step set without end", "expected at least 1e%-10 s", function() pulled():set { step = 1e-300 } end)
attack("a time without end", "advance: expected a time up to 2.5e%+09 s %(1e%+10 steps of 0.25 s from here%), got 1e%+300 s", function() pulled():advance(1e300) end)
attack("hooks without end", "every: expected at least 1e%-10 s", function() pulled():every(1e-300, print) end)
attack("rows without end", "expected at least 1e%-10 s", function() pulled():record(folder .. "/end.csv", { every = 1e-300, columns = { x = function() return 1 end } }) end)
attack("damping without end", "damping.stiffness': 1e%+10 s brings the stable step from", function()
  local _, m = strip()
  fabric.dynamic { model = m, duration = 1, damping = { stiffness = 1e10 } }
end)
attack("a motion without end", "field 'duration': the stable step", function()
  local _, m = strip()
  fabric.dynamic { model = m, duration = 1e300 }
end)

-- Functions of the deck's that are called back, and change what is under way.
local still = "may not change while it asks a function for a value"
attack("a map that maps its mesh", still, function() local mesh = strip() mesh:map(function(x, y, z) mesh:map(function() return x, y, z end) return x, y, z end) end)
attack("a set that maps its mesh", still, function() local mesh = strip() mesh:set("s", function() mesh:map(function(x, y, z) return x, y, z end) return true end) end)
attack("a set that sets itself", still, function() local mesh = strip() mesh:set("s", function() mesh:set("s", { 1 }) return true end) end)
attack("a map that turns its mesh", still, function() local mesh = strip() mesh:map(function(x, y, z) mesh:orient() return x, y, z end) end)
attack("a direction that maps the mesh", still, function()
  local mesh = strip()
  local m
  m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = function() mesh:map(function(x, y, z) return x, y, z end) return 90 end }
  m:fix("all", "x y z rotation")
  fabric.static { model = m, duration = 1 }:solve()
end)
attack("a direction that changes the model", still, function()
  local m
  m = fabric.model { mesh = strip(), card = fabric.card "blend", warp = function() if m then m:fix("all", "z") end return 90 end }
  m:fix("all", "x y z rotation")
  fabric.static { model = m, duration = 1 }:solve()
end)
attack("a history that moves the model", "in use by an analysis", function()
  local a, m
  a, m = pulled(function(t) if m then for _ = 1, 100 do m:move("top", { z = 1 }) end end return 0.001 * t end)
  a:solve()
end)
local function from_history(call)
  return function()
    local a
    a = pulled(function(t) if a then call(a) end return 0.001 * t end)
    a:solve()
  end
end
for name, call in pairs {
  every = function(a) for _ = 1, 100 do a:every("step", print) end end, event = function(a) a:event { value = function() return 1 end } end,
  record = function(a) a:record(folder .. "/h.csv", { columns = { x = function() return 1 end } }) end, solve = function(a) a:solve() end,
  step = function(a) a:step() end, advance = function(a) a:advance(0.5) end, snapshot = function(a) a:snapshot() end,
  set = function(a) a:set { step = 0.1 } end, vtk = function(a) a:vtk(folder .. "/h") end, checkpoint = function(a) a:checkpoint(folder .. "/h.ckpt") end,
} do
  attack("a history that calls " .. name, still, from_history(call))
  attack("a value of an event that calls " .. name, still, function()
    local a = pulled()
    a:event { value = function(run) if run.time > 0 then call(run) end return run.time - 0.6 end }
    a:solve()
  end)
  attack("a column that calls " .. name, still, function()
    local a = pulled()
    a:record(("%s/column_%s.csv"):format(folder, name), { columns = { x = function(run) call(run) return 1 end } })
    a:solve()
  end)
  attack("a column of the last frame that calls " .. name, still, function()
    local a = pulled()
    a:record(("%s/last_%s.csv"):format(folder, name), { every = 0.3, columns = { x = function(run) if run.time == 1 then call(run) end return 1 end } })
    a:solve()
  end)
end
attack("an event's first value that adds an event", still, function()
  local a = pulled()
  a:event { value = function(run) for _ = 1, 20 do run:event { value = function() return 1 end } end return 1 end }
  a:solve()
end)
attack("a column that records on its own path", still, function()
  local a, path = pulled(), folder .. "/own.csv"
  a:record(path, { columns = { x = function(run) run:record(path, { columns = { y = function() return 1 end } }) return 1 end } })
  a:solve()
end)
attack("a hook that drives its run", "solve: not from a hook of the same run", function() local a = pulled() a:every("step", function(run) run:solve() end) a:solve() end)
attack("a hook that goes back", "restore: not from a hook of the same run", function()
  local a = pulled()
  local s = a:snapshot()
  a:every("step", function(run) run:restore(s) end)
  a:solve()
end)
attack("a hook that drives its run and carries on", nil, function()
  local a, n = pulled(), 0
  a:every("step", function(run) n = n + 1 assert(not pcall(run.step, run)) end)
  a:solve()
  assert(n == 5 and a.time == 1 and #a.steps == 4)
end)
attack("a hook that adds hooks, events and outputs", nil, function()
  local a, n = pulled(), 0
  a:every("step", function(run)
    n = n + 1
    run:every("step", function() end):event { value = function() return 1 end, action = print }
    run:record(("%s/added_%d.csv"):format(folder, n), { columns = { x = function() return 1 end } })
  end)
  a:solve()
  assert(n == 5)
end)
attack("an event whose action adds events", nil, function()
  local a, n = pulled(), 0
  a:event { value = function(run) return run.time - 0.6 end, action = function(run)
    n = n + 1
    for _ = 1, 50 do run:event { value = function() return 1 end } end
  end }
  a:solve()
  assert(n == 1)
end)
attack("columns that all fail", "first", function()
  local a = pulled()
  for i, words in ipairs { "first", "second", "third" } do
    a:record(("%s/fail_%d.csv"):format(folder, i), { every = 0.7, columns = { x = function(run) if run.time == 1 then error(words) end return 1 end } })
  end
  a:solve()
end)
attack("columns that fail with what is no text", nil, function()
  local a = pulled()
  a:record(folder .. "/nil.csv", { every = 0.7, columns = { x = function(run) if run.time == 1 then error() end return 1 end } })
  a:record(folder .. "/table.csv", { every = 0.7, columns = { x = function(run) if run.time == 1 then error {} end return 1 end } })
  a:solve()
end)
attack("a kept table whose key changes it", "can't be kept as a key", function()
  local a, kept = pulled(), {}
  kept[setmetatable({}, { __tostring = function() a:checkpoint(folder .. "/more.ckpt") kept.x = 1 return "x" end })] = 1
  a:checkpoint(folder .. "/kept.ckpt", { keep = kept })
end)
attack("a kept table in itself", nil, function()
  local a, kept = pulled(), {}
  kept.kept = kept
  a:checkpoint(folder .. "/self.ckpt", { every = "step", keep = kept })
  a:solve()
end)
attack("a kept table that is changed by a hook for the worse", "can't be kept|can be kept" and "kept", function()
  local a, kept = pulled(), {}
  a:checkpoint(folder .. "/worse.ckpt", { every = "step", keep = kept })
  a:every("step", function() kept.x = print end)
  a:solve()
end)
attack("processes that start others in what is done", nil, function()
  fabric.lab.parallel { count = 2, processes = 2, work = function() return { 1 } end, done = function() error "done" end }
end)
attack("work that returns what is no list", nil, function()
  local r = fabric.lab.parallel { count = 3, processes = 1, work = function(i) return ({ 5, "x", { {} } })[i] end }
  assert(r[1].trouble and r[2].trouble and r[3].trouble)
end)

-- Coroutines and errors on their way through C++.
attack("a hook that yields", "yield", function()
  local a = pulled()
  a:every("step", coroutine.yield)
  local good, trouble = coroutine.resume(coroutine.create(function() a:solve() end))
  if not good then error(trouble, 0) end
end)
attack("a run in a coroutine, its hooks in others", nil, function()
  local a, n = pulled(), 0
  a:every("step", function(run) coroutine.wrap(function() n = n + run.time coroutine.yield() end)() end)
  coroutine.wrap(function() a:solve() end)()
  assert(n == 2.5)
end)
attack("a run that a dead coroutine began", nil, function()
  local a = pulled()
  a:every("step", function(run) if run.time == 0.5 then error "dead" end end)
  local c = coroutine.create(function() a:solve() end)
  assert(not coroutine.resume(c))
  c = nil
  collectgarbage()
  a:solve()
  assert(a.time == 1)
end)
attack("a coroutine closed within a hook", nil, function()
  local a = pulled()
  local c
  a:every("step", function() pcall(coroutine.close, c) end)
  c = coroutine.create(function() a:solve() end)
  assert(coroutine.resume(c))
end)
for _, value in ipairs { "text", 5, {}, print, false } do
  attack("a hook that raises " .. type(value), nil, function()
    local a = pulled()
    a:every("step", function(run) if run.time == 0.5 then error(value) end end)
    local good, trouble = pcall(a.solve, a)
    assert(not good and (type(value) == "string" or trouble == value))
    assert(a:solve().time == 1)
  end)
end
attack("runs within hooks of runs", nil, function()
  local function deeper(n)
    local a = pulled()
    a:every("step", function(run) if run.time == 0.25 and n > 0 then deeper(n - 1) end end)
    a:solve()
  end
  deeper(60)
end)
attack("functions within functions without end", nil, function()
  local mesh
  local function again() strip():map(again) return 0, 0, 0 end
  mesh = strip()
  mesh:map(again)
end)
attack("an __index without end", nil, function()
  local t = setmetatable({}, {})
  getmetatable(t).__index = function(s, k) return fabric.mesh.rectangle(s)[k] end
  fabric.mesh.rectangle(t)
end)
attack("a comparison that raises while sorting", nil, function()
  local list = {}
  for i = 1, 50 do list[i] = fabric.ramp(i, 1) end
  table.sort(list, function(a, b) return a:value(1) < (b:value(2) > 25 and error "stop" or b:value(1)) end)
end)

-- Finalisers, which --safe has none of.
if not safe then
  attack("a finaliser with a mesh that is gone", nil, function()
    for _ = 1, 20 do
      local keep = setmetatable({}, { __gc = function(t) pcall(function() return #t.mesh.nodes, t.mesh:set "all" end) pcall(tostring, t.mesh) end })
      keep.mesh = strip()
    end
    collectgarbage()
  end)
  attack("a finaliser that drives a run that is gone", nil, function()
    for _ = 1, 5 do
      local keep = setmetatable({}, { __gc = function(t) pcall(t.a.solve, t.a) pcall(t.a.every, t.a, "step", print) pcall(tostring, t.a) end })
      keep.a = pulled()
      keep.a:every("step", function() end):record(folder .. "/gc.csv", { columns = { x = function() return 1 end } })
    end
    collectgarbage()
    collectgarbage()
  end)
  attack("a finaliser that collects", nil, function()
    local a = pulled()
    a:every("step", function() setmetatable({}, { __gc = function() collectgarbage() error "in a finaliser" end }) collectgarbage() end)
    a:solve()
  end)
  -- At the end of the program.
  Kept = setmetatable({}, { __gc = function(t) pcall(t.a.solve, t.a) pcall(t.m.fix, t.m, "all", "x") end })
  Kept.a, Kept.m = pulled()
end

assert(count >= 100)
if #missed > 0 then error(table.concat(missed, "\n"), 0) end
print(("%d attacks, all withstood"):format(count))
