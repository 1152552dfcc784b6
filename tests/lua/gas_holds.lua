-- A mechanism that nothing but its gas holds, by steps in load and along the path; and runs with gas that are killed and restarted from their file.
local fabric = require "fabric"
local beside = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end

-- A tube of four stiff panels that turn about their edges, a rhombus of side s with the angle 60 degrees. Its roof is pushed along with
-- F = p L s cot(angle), where (p + p0) sin(angle) stays what it is.
local outside, s, L, start, want = 101325, 0.125, 0.08, math.rad(60), math.rad(52)
local function tube(triangles)
  local nodes, elements = {}, {}
  local x, y = s * math.cos(start), s * math.sin(start)
  for _, z in ipairs { 0, L } do
    for _, corner in ipairs { { 0, 0 }, { s, 0 }, { s + x, y }, { x, y } } do nodes[#nodes + 1] = { corner[1], corner[2], z } end
  end
  for i = 1, 4 do
    local j = i % 4 + 1
    if triangles then
      elements[#elements + 1], elements[#elements + 2] = { i, j, j + 4 }, { i, j + 4, i + 4 }
    else
      elements[#elements + 1] = { i, j, j + 4, i + 4 }
    end
  end
  local mesh = fabric.mesh { nodes = nodes, elements = elements }
  for name, set in pairs { low = { 1, 2, 3, 4 }, high = { 5, 6, 7, 8 }, floor = { 1, 2, 5, 6 }, roof = { 3, 4, 7, 8 }, right = { 3, 7 }, left = { 4, 8 } } do
    mesh:set(name, set)
  end
  local card = fabric.svk { young = 3e10, poisson = 0, density = 700, thickness = 0.5e-3 }
  local m = fabric.model { mesh = mesh, card = card, membrane = true, warp = { 0, 0, 1 } }
  m:fix("floor", "x y z"):fix("roof", "z"):tie("equal", "right", "x y"):tie("equal", "left", "x y")
  local g = m:gas { lids = { "low", "high" }, initial = 0 }
  local p = outside * (math.sin(start) / math.sin(want) - 1)
  m:force("roof", { x = fabric.ramp(p * L * s / math.tan(want), 1) })
  return m, g, p
end
for _, triangles in ipairs { false, true } do
  for name, way in pairs { auto = {}, newton = { method = "newton" }, unsymmetric = { linear = "unsymmetric" }, arc = { control = "arc" } } do
    local m, g, p = tube(triangles)
    way.model, way.duration, way.step = m, 1, 0.1
    local a = fabric.static(way):solve()
    local node = a:node(4)
    local of = (", %s%s"):format(name, triangles and ", triangles" or "")
    check("angle" .. of, math.atan(node.y, node.x), want, 1e-3)
    check("pressure" .. of, a:gas(g), p, 2e-3)
    check("held from the first step on" .. of, a.steps[1].stable and 1 or 0, 1, 0)
    check("its balance" .. of, 1 + a.energy.error, 1, 1e-3)
    if name == "arc" then assert(#a.steps == 10 and a.steps[1].iterations < 8, #a.steps) end
  end
end

-- Gas that flows goes by the time, and has no path.
do
  local mesh = fabric.mesh.cylinder { radius = 0.05, length = 0.2, around = 8, along = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = { 0, 0, 1 } }:fix("bottom", "x y z"):fix("top", "x y")
  m:gas { lids = { "bottom", "top" }, leakage = 0.01 }
  local done, message = pcall(fabric.static, { model = m, duration = 1, control = "arc" })
  assert(not done and message:find("field 'control': \"arc\" follows the path of the loads, not the time in which gas flows: expected \"load\", or gas "
    .. "without inflow, vents and leakage", 1, true), message)
end

-- Killed in the middle and restarted from the file: the same records.
fabric.write("bag.lua", [[
local fabric = require "fabric"
local scheme, steps = os.getenv "SCHEME", 0
local card = fabric.svk { young = 30e6, poisson = 0.25, density = 700, thickness = 0.3e-3, bending = { warp = 2e-5, weft = 2e-5, twist = 1e-5 } }
local mesh = fabric.mesh.cylinder { radius = 0.05, length = 0.2, around = 8, along = 3 }
local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 } }
m:fix("bottom", "x y z"):fix("top", "x y")
local T = scheme:find "static" and 1 or 2e-3
local given = { lids = { "bottom", "top" }, exponent = 1.3, inflow = { { 0, 0 }, { T, 1e-3 / T } }, vents = { { area = 1e-6, opens = 500 } }, leakage = 0.01 }
if scheme:find "arc" then
  given = { lids = { "bottom", "top" }, exponent = 1.3, initial = 800 }
  m:force("top", { z = fabric.ramp(5, T) })
end
local g = m:gas(given)
local a
if scheme:find "static" then
  a = fabric.static { model = m, duration = T, step = T / 8, control = scheme:match "arc" or "load" }
else
  a = fabric.dynamic { model = m, scheme = scheme, duration = T, step = scheme == "implicit" and T / 20 or "auto" }
end
a:every(T / 8, function()
  steps = steps + 1
  if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end
end)
a:record("work/bag.csv", { every = T / 8, columns = { p = function(run) return (run:gas(g)) end,
  mass = function(run) return (select(3, run:gas(g))) end, vents = function(run) return run.energy.vents or 0 end } })
a:checkpoint("work/run.ckpt", { every = T / 8 }):solve()
local p, V, mass, temperature = a:gas(g)
if scheme == "static" then -- a second run goes on; the reading of the first is one that a restart passes over
  a = fabric.dynamic { from = a, duration = 1e-3 }
  a:every(2e-4, function()
    steps = steps + 1
    if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end
  end)
  a:checkpoint("work/run.ckpt", { every = 2e-4 }):solve()
end
fabric.write("work/said.txt", ("%.17g %.17g %.17g %.17g %.17g"):format(p, V, mass, temperature, a.energy.gas))
]])
for _, scheme in ipairs { "explicit", "implicit", "static", "static by arc" } do
  local more = ("SCHEME='%s'"):format(scheme)
  local wanted = beside.whole("bag.lua", more)
  for _, kill in ipairs(scheme == "static" and { 5, 12 } or { 5 }) do
    local got = beside.restarted("bag.lua", kill, "run.ckpt", more)
    for _, file in ipairs { "bag.csv", "said.txt" } do
      check(("%s, %s, killed at %d"):format(file, scheme, kill), got[file] == wanted[file] and 1 or 0, 1, 0)
    end
  end
end
fabric.expect(checks)
