-- Runs that begin from the state of other runs: pulled, then moved; pressed, then released; energies and times; supports, loads and
-- contacts that come and go; and a chain that is killed and restarted. The short form has explicit swings on quadrilaterals alone.
local fabric = require "fabric"
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end
local beside = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))

-- A strip that is bent by a support and let go: slowly it comes back to where a strip with the fading force is, at once it swings
-- about its rest, from where it was, with the energy that it had.
local B = 2e-5
local card = fabric.svk { density = 500, thickness = 0.5e-3, warp = 8e6, weft = 8e6, shear = 3e6, poisson = 0,
  bending = { warp = B, weft = B, twist = B / 2 } }
local function strip(tri)
  local mesh = fabric.mesh.rectangle { width = 0.15, height = 0.02, nx = 12, ny = 2, triangles = tri }
  return fabric.model { mesh = mesh, card = card, warp = 0 }:fix("left", "x y z rotation")
end
for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  local m = strip(tri):move("right", { z = fabric.ramp(0.012, 1) })
  local bent = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local tip = m.mesh:set("right")[1]
  local _, _, force = bent:reaction "right"
  local free = m:copy { without = "move" }
  local slow = fabric.static { from = bent, model = free, release = 1, duration = 2, step = 0.25 }
  check("it begins where the other is" .. of, slow:node(tip).z, 0.012, 1e-12)
  check("at its time" .. of, slow.time, 1, 0)
  check("with its energy" .. of, slow.energy.stored, bent.energy.stored, 1e-9)
  slow:advance(1.5)
  local half = strip(tri):force("right", { z = fabric.ramp(force / 2, 1) })
  local pulled = fabric.static { model = half, duration = 1, step = 0.5 }:solve()
  check("half let go" .. of, slow:node(tip).z, pulled:node(tip).z, 2e-3)
  slow:solve()
  check("let go" .. of, 1 + slow:node(tip).z, 1, 1e-6)
  check("its work" .. of, slow.energy.external, -bent.energy.stored, 0.02)
  check("its end" .. of, slow.time, 3, 1e-12)
  check("its duration" .. of, slow.duration, 2, 0)

  local period = 1 / fabric.modes { from = slow, count = 1 }[1].frequency
  local ends = {}
  for _, scheme in ipairs((not tri or os.getenv "FABRICSH_TEST_LONG") and { "implicit", "explicit" } or { "implicit" }) do
    local swing = fabric.dynamic { from = bent, model = free, duration = 1.2 * period, scheme = scheme,
      step = scheme == "implicit" and period / 400 or "auto" }
    local least = 1
    swing:every("step", function(a) least = math.min(least, a:node(tip).z) end)
    swing:advance(1 + period / 2):solve()
    check("work of a free swing, " .. scheme .. of, 1 + swing.energy.external, 1, 1e-12)
    check("energy of a free swing, " .. scheme .. of, swing.energy.kinetic + swing.energy.stored, bent.energy.stored, 0.01)
    -- It comes back on the other side, but for what its higher modes have taken.
    check("other side, " .. scheme .. of, least, -0.012, 0.15)
    ends[scheme] = swing:node(tip).z
  end
  if ends.explicit then check("explicit as implicit" .. of, ends.explicit / 0.012, ends.implicit / 0.012, 0.1) end
end

-- The same loads go on: a run in two parts is the run in one, also where yarns have dissipated.
do
  local function pull()
    local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.05, nx = 2, ny = 4 }
    local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
    return m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x")
      :move("top", { y = fabric.history { { 0, 0 }, { 1, 0.008 }, { 2, 0.004 } } })
  end
  local whole = fabric.static { model = pull(), duration = 2, step = 0.25 }:solve()
  local m = pull()
  local first = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local second = fabric.static { from = first, duration = 1, step = 0.25 }:solve()
  check("unloading from a state", select(2, second:reaction "top"), select(2, whole:reaction "top"), 1e-8)
  check("its dissipation", second.energy.dissipated, whole.energy.dissipated, 1e-8)
  check("the work of both", first.energy.external + second.energy.external, whole.energy.external, 1e-6)
  check("the model of the other run", second.model == m and 1 or 0, 1, 0)

  -- With an end that is held instead of moved the cloth stays where it is, and carries what it carried.
  local held = m:copy { without = { "move top" } }:fix("top", "y")
  local stays = fabric.static { from = first, model = held, duration = 1, step = 0.5 }:solve()
  check("held where it is", select(2, stays:reaction "top"), select(2, first:reaction "top"), 1e-6)
  check("and there", stays:node(m.mesh:set("top")[1]).uy, 0.008, 1e-12)
end

-- Contact is added to a state: a sheet that hangs over a plane is let down on it.
do
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 6, ny = 6 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("boundary", "z"):fix("left", "x"):fix("bottom", "y")
  m:gravity { 0, 0, fabric.ramp(-9.81, 1) }
  local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  local floor = fabric.rigid.plane { point = { 0, 0, -0.02 }, normal = { 0, 0, 1 } }
  local on = m:copy { without = "fix boundary" }
  on:contact { between = { floor, "all" }, friction = 0.2, thickness = 0.5e-3 }
  local b = fabric.dynamic { from = a, model = on, duration = 0.15, damping = { mass = 40 } }:solve()
  local lowest = math.huge
  for i = 1, #mesh.nodes do lowest = math.min(lowest, b:node(i).z) end
  check("on the plane", lowest, -0.02, 0.05)
  local weight = 500 * 0.5e-3 * 0.01 * 9.81
  -- and from there statics, beside the same contact
  local c = fabric.static { from = b, duration = 0.1, step = 0.1 }:solve()
  check("at rest on it", select(3, c:reaction(floor)), weight, 1e-3)
end

-- A chain of three runs that is killed in each of them and restarted writes the same.
local deck = [[
local fabric = require "fabric"
local steps, lines = 0, {}
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.05, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.006, 1) })
local function watched(a, name)
  a:every("step", function()
    steps = steps + 1
    if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end
  end)
  a:record("work/" .. name .. ".csv", { columns = { y = function(run) return run:node(mesh:set("top")[1]).y end,
    e = function(run) return run.energy.stored end } })
  return a:checkpoint("work/run.ckpt", { every = "step" })
end
local a = watched(fabric.static { model = m, duration = 1, step = 0.25 }, "pull"):solve()
local free = m:copy { without = { "move top", "fix top" } }
local b = watched(fabric.static { from = a, model = free, duration = 1, step = 0.25, release = 0.5 }, "release"):solve()
local c = watched(fabric.dynamic { from = b, duration = 2e-4 }, "swing"):solve()
fabric.write("work/said.txt", ("%.17g %.17g"):format(c.energy.stored, c.time))
]]
fabric.write("chain.lua", deck)
local wanted = beside.whole "chain.lua"
for _, kill in ipairs { 3, 8, 14 } do
  local got = beside.restarted("chain.lua", kill, "run.ckpt")
  for _, file in ipairs { "pull.csv", "release.csv", "swing.csv", "said.txt" } do
    check(("%s, killed at step %d"):format(file, kill), got[file] == wanted[file] and 1 or 0, 1, 0)
  end
end

fabric.expect(checks)
