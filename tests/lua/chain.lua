-- Steps that follow each other by fabric.lab.chain: cycles against one run, killed and restarted; a first run that goes on after the second has
-- begun; and an arch that is pressed and let go, at rest and in motion.
local fabric = require "fabric"
local beside = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end

-- Pulled, held, and pulled back, three times and each time as far: as one run along the same history.
do
  local reach, back = 0.005, 0.003
  for _, tri in ipairs { false, true } do
    local mesh = fabric.mesh.rectangle { width = 0.024, height = 0.045, nx = 2, ny = 3, triangles = tri }
    local tip = mesh:set("top")[1]
    local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x")
    local function to(y)
      return function(model, begins, before)
        model:move("top", { y = fabric.history { { begins, before and before:node(tip).uy or 0 }, { begins + 1, y } } })
      end
    end
    local chain = fabric.lab.chain { model = m, cycles = 3, steps = {
      { name = "load", duration = 1, loads = to(reach), options = { step = 0.125 } },
      { name = "hold", duration = 1, loads = to(reach), options = { step = 0.5 } },
      { name = "unload", duration = 1, loads = to(back), options = { step = 0.125 } } },
      columns = { force = function(a) return select(2, a:reaction "top") end, stretch = function(a) return a:mean "E11" end } }
    assert(#chain.rows == 9 and chain.rows[6].name == "unload" and chain.rows[6].cycle == 2 and chain.analysis.time == 9)
    local points, whole = { { 0, 0 } }, {}
    for cycle = 0, 2 do
      for i, y in ipairs { reach, reach, back } do points[#points + 1] = { 3 * cycle + i, y } end
    end
    m:move("top", { y = fabric.history(points) })
    local one = fabric.static { model = m, duration = 9, step = 0.125 }
    for i, row in ipairs(chain.rows) do
      one:advance(i)
      local of = (" after step %d%s"):format(i, tri and ", triangles" or "")
      check("time" .. of, row.time, i, 1e-12)
      check("force" .. of, row.force, select(2, one:reaction "top"), 1e-7)
      check("stretch" .. of, row.stretch, one:mean "E11", 1e-7)
      check("stored" .. of, row.stored, one.energy.stored, 1e-7)
      check("dissipated" .. of, row.dissipated, one.energy.dissipated, 1e-7)
      whole[i] = one.energy.external
      if i > 1 and row.name ~= "hold" then check("work" .. of, row.work, whole[i] - whole[i - 1], 1e-6) end
    end
  end
end

-- Killed in any step and restarted, with a step in motion: the same table.
fabric.write("cycles.lua", [[
local fabric = require "fabric"
local steps = 0
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.05, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x")
local chain = fabric.lab.chain { model = m, cycles = 2, checkpoint = "work/chain.ckpt", steps = {
  { name = "pull", duration = 1, options = { step = 0.25 }, loads = function(model, t, before)
    model:move("top", { y = fabric.history { { t, before and before:node(mesh:set("top")[1]).uy or 0 }, { t + 1, 0.006 } } })
  end },
  { name = "let go", duration = 1, release = 0.5, options = { step = 0.25 } },
  { name = "swing", scheme = "explicit", duration = 1e-4 },
  { name = "rest", duration = 1, options = { step = 0.5 } } },
  columns = { left = function(a) return a:node(mesh:set("top")[1]).uy end },
  watch = function(a, name, cycle)
    a:every(name == "swing" and 5e-5 or "step", function()
      steps = steps + 1
      if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end
    end)
    a:record(("work/%s%d.csv"):format(name:gsub(" ", "_"), cycle), { columns = { e = function(run) return run.energy.stored end } })
  end }
local lines = {}
for _, row in ipairs(chain.rows) do
  lines[#lines + 1] = ("%s %d %.17g %.17g %.17g %.17g %.17g"):format(row.name, row.cycle, row.time, row.left, row.stored, row.dissipated, row.work)
end
fabric.write("work/table.txt", table.concat(lines, "\n"))
]])
local wanted = beside.whole "cycles.lua"
assert(wanted["table.txt"]:find "rest 2")
for _, kill in ipairs { 3, 8, 12, 18, 23, 27 } do
  local got = beside.restarted("cycles.lua", kill, "chain.ckpt")
  for file, bytes in pairs(wanted) do
    if not file:find "ckpt" and not file:find "json" then check(("%s, killed at %d"):format(file, kill), got[file] == bytes and 1 or 0, 1, 0) end
  end
end

-- A first run that goes on after another has begun from it is not what the other began from: a restart says so, and how to avoid it.
fabric.write("both.lua", [[
local fabric = require "fabric"
local steps = 0
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.05, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x")
m:move("top", { y = fabric.ramp(0.006, 1) })
local function watched(a)
  a:every("step", function()
    steps = steps + 1
    if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end
  end)
  return a:checkpoint("work/run.ckpt", { every = "step" })
end
local a = watched(fabric.static { model = m, duration = 1, step = 0.125 }):advance(0.5)
local b = watched(fabric.static { from = a, model = m:copy { without = "move" }, duration = 1, step = 0.25, release = 1 })
a:solve()
b:solve()
fabric.write("work/said.txt", ("%.17g %.17g"):format(a.energy.stored, b.energy.stored))
]])
local whole = beside.whole("both.lua")["said.txt"]
for kill, refused in pairs { [3] = false, [8] = true, [12] = true } do
  os.execute "rm -rf work; mkdir work"
  local code, talk = beside.program("both.lua", kill)
  assert(code == 9, talk)
  code, talk = beside.program "--restart work/run.ckpt both.lua"
  if refused then
    assert(code ~= 0 and talk:find("begins from the state after call 1 of analysis 1, which went on after that", 1, true)
      and talk:find("Let a run from which others begin end before", 1, true), talk)
  else
    assert(code == 0 and beside.contents("work")["said.txt"] == whole, talk)
  end
end

-- An arch between two clamps is pressed flat by a plate, and the plate is taken away: slowly at rest, at once in motion with damping.
do
  local L, B = 0.1, 2e-5
  local card = fabric.svk { density = 500, thickness = 0.5e-3, warp = 8e5, weft = 8e5, shear = 3e5, poisson = 0,
    bending = { warp = B, weft = B, twist = B / 2 } }
  for _, tri in ipairs { false, true } do
    local of = tri and ", triangles" or ", quadrilaterals"
    local mesh = fabric.mesh.rectangle { width = L, height = 0.02, nx = 16, ny = 1, triangles = tri }:map(function(x, y)
      return x, y, 1e-4 * math.sin(math.pi * x / L)
    end)
    mesh:set("middle", function(x) return math.abs(x - L / 2) < 1e-6 end)
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("left", "x y z rotation"):fix("right", "y z rotation")
    m:move("right", { x = fabric.ramp(-0.015, 1) })
    local arch = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
    local top = mesh:set("middle")[1]
    local high = arch:node(top).z
    check("an arch" .. of, high > 0.015 and 1 or 0, 1, 0)
    local held = m:copy { without = "move" }:fix("right", "x y z rotation")
    local plate = fabric.rigid.plane { point = { 0, 0, high + 1e-3 }, normal = { 0, 0, -1 }, name = "plate" }
    local pressing = held:copy()
    pressing:contact { between = { plate, "all" }, thickness = 0.5e-3 }
    pressing:move(plate, { z = fabric.history { { 1, 0 }, { 2, -0.3 * high - 1e-3 } } })
    local pressed = fabric.static { from = arch, model = pressing, duration = 1, step = 0.05 }:solve()
    assert(pressed:node(top).z < 0.75 * high, "pressed")
    local slow = fabric.static { from = pressed, model = held, duration = 1.5, release = 1, step = 0.1 }:solve()
    local quick = fabric.dynamic { from = pressed, model = held, duration = 0.25, damping = { mass = 60 } }:solve()
    check("let go slowly" .. of, slow:node(top).z, high, 1e-4)
    check("let go at once" .. of, quick:node(top).z, slow:node(top).z, 2e-3)
    for _, id in ipairs { 5, 9, 13 } do check(("node %d"):format(id) .. of, 1 + quick:node(id).ux / L, 1 + slow:node(id).ux / L, 1e-3) end
    check("energy of both" .. of, quick.energy.stored, slow.energy.stored, 2e-3)
  end
end

fabric.expect(checks)
