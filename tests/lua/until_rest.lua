-- A run that ends by itself where all rests: the strip of cloth that falls onto a floor, and a cuff that is sewn around an arm. The same bits after a
-- restart; solve() goes on; what does not rest in its time is said. The short form has the strip that swings in implicit steps alone.
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local mm = fabric.units.mm
local card = fabric.card("blend", { bending = "estimated" })

local function sheet(duration, rest)
  local mesh = fabric.mesh.rectangle { width = 0.07, height = 0.05, nx = 5, ny = 4, origin = { 0, 0, 3 * mm } }
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0.1, 0, 1 } }
  m:contact { between = { floor, "all" }, friction = 0.5 }:gravity { 0, 0, -9.81 }
  return fabric.dynamic { model = m, duration = duration, damping = { mass = 150 }, until_rest = rest }
end

local function said(a, code)
  for _, w in ipairs(a.warnings) do if w.code == code then return w.text end end
end

-- As a child: the state where it rests, whole or taken up on the way.
if arg[1] then
  local a = sheet(2, { calm = 0.05, window = 0.03 })
  a:checkpoint("rest.ckpt", { every = 0.04 })
  if arg[1] == "half" then return a:advance(0.21) end
  a:solve()
  assert(a.stopped == "at rest")
  local rows = { ("%a %a"):format(a.time, a.energy.kinetic) }
  for i, u in ipairs(a:field "displacement") do rows[i + 1] = ("%a %a %a"):format(u[1], u[2], u[3]) end
  return print(table.concat(rows, "\n"))
end

local a = sheet(2, { calm = 0.05, window = 0.03 })
a:solve()
print(("at rest at %.4g s, kinetic over stored %.3g"):format(a.time, a.energy.kinetic / a.energy.stored))
assert(a.stopped == "at rest" and a.time > 0.03 and a.time < 0.5)
assert(a.energy.kinetic <= 0.05 * a.energy.stored and a.energy.damping > 0 and a.energy.error < 1e-2)
assert(not said(a, "rest"))
-- It ends there once; what is left is run when it is asked for.
local t = a.time
a:advance(t + 0.05)
assert(not a.stopped and math.abs(a.time - t - 0.05) < 1e-12)

-- Nothing rests while it falls.
local short = sheet(0.02, { window = 0.01 })
short:solve()
assert(not short.stopped and short.time == 0.02)
print(said(short, "rest"))
assert(said(short, "rest"):find("not at rest at the end, 0.02 s: the kinetic energy is", 1, true))

local one = check.child("--threads 1", "whole")
check.child("--threads 1", "half")
assert(#one > 500 and one == check.child("--threads 2 --restart rest.ckpt", "whole"), "bits after a restart")

-- A cuff that is drawn together around an arm does not rest before it is sewn, however calm it is. fabric.lab.dress ends with the run.
local function cuff()
  local r = 30 * mm
  local arm = fabric.rigid.limb { upper = 0.09, lower = 0.09, radii = { 26 * mm, 26 * mm, 25 * mm }, around = 20, from = { -0.09, 0, 0 }, axis = { 1, 0, 0 }, towards = { 0, 0, 1 }, name = "arm" }
  local wide = 2 * math.pi * r - 7 * mm
  local panel = fabric.mesh.panel { size = 14 * mm, grain = 90, outline = { { 0, 0 }, { wide, 0 }, { wide, 56 * mm, name = "right" }, { 0, 56 * mm }, { name = "left" } } }
  panel:wrap { cylinder = { radius = r, axis = { 1, 0, 0 }, from = { -28 * mm, 0, 0 }, towards = { 0, 0, -1 } } }
  local m = fabric.model { mesh = panel, card = card, points = 1 }
  m:gravity { 0, 0, -9.81 }:seam { "left", "right", over = 0.03, hinge = true }:contact { between = { arm, "all" }, friction = 0.3 }
  return fabric.dynamic { model = m, duration = 0.5, damping = { mass = 100 }, until_rest = { calm = 0.9, window = 5e-3, still = 50 * mm } }
end
local b = cuff()
local dressed = fabric.lab.dress { analysis = b, at = 0.4 }
print(("sewn at %.4g s"):format(dressed.time))
assert(dressed.at_rest and dressed.open == 0 and dressed.time == b.time and dressed.stopped == "at rest")
assert(b.time >= 0.035 * (1 - 1e-9) and b.time < 0.1)

-- A strip that swings beside another one, which stores so much that the swing is nothing: it hangs still before that is called rest, and goes on by less than a
-- hundredth of its size. It is not at rest where it turns around, nor while heavy damping lets it creep.
local function swing(mass, rest, scheme)
  local taut = fabric.mesh.rectangle { width = 0.06, height = 0.02, nx = 3, ny = 1, origin = { 0, 0.1, 0 } }
  local hung = fabric.mesh.rectangle { width = 0.1, height = 0.02, nx = 5, ny = 1 }
  local m = fabric.model { bodies = { { name = "taut", mesh = taut, card = card }, { name = "hung", mesh = hung, card = card } }, points = 1 }
  m:fix("taut.all", "y z rotation"):fix("taut.left", "x"):move("taut.right", { x = fabric.history { { 0, 0 }, { 0.02, 3 * mm } } })
  m:fix("hung.left", "x y z"):gravity { 9.81 * math.cos(0.5), 0, -9.81 * math.sin(0.5) }
  local implicit = scheme == "implicit"
  return fabric.dynamic { model = m, duration = 3, scheme = scheme, slow = implicit or nil, step = implicit and 5e-3 or nil, damping = { mass = mass }, until_rest = rest }, hung.nodes, #taut.nodes
end
for _, scheme in ipairs(os.getenv "FABRICSH_TEST_LONG" and { "implicit", "explicit" } or { "implicit" }) do
  local run, nodes, before = swing(10, {}, scheme)
  run:solve()
  assert(run.stopped == "at rest" and run.time > 1 and run.time < 2.2, run.time)
  local was, most = {}, 0
  for i = 1, #nodes do was[i] = run:node(before + i) end
  run:every(0.02, function(a)
    for i, p in ipairs(was) do
      local q = a:node(before + i)
      most = math.max(most, math.sqrt((q.x - p.x) ^ 2 + (q.y - p.y) ^ 2 + (q.z - p.z) ^ 2))
    end
  end)
  local rested = run.time
  run:advance(rested + 0.6)
  print(("%s: at rest at %.4g s, goes on by %.3g mm"):format(scheme, rested, 1e3 * most))
  assert(most < 1e-3)
end
local creeping = swing(300, {}, "implicit"):solve()
assert(not creeping.stopped and said(creeping, "rest"):find("no node has moved by more than 0.00015", 1, true))
local loose = swing(10, { still = 50 * mm }, "implicit"):solve()
assert(loose.stopped == "at rest" and loose.time < 0.1)

-- Cloth that is pulled or turned slowly has next to no kinetic energy, and does not rest before it stands; a load that comes later is not waited for.
for _, scheme in ipairs { "implicit", "explicit" } do
  local soft = fabric.svk { young = 20e6, poisson = 0, density = 600, thickness = 0.4 * mm, bending = { warp = 2e-5, weft = 2e-5, twist = 1e-5 } }
  local function pulled(history)
    local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.02, nx = 3, ny = 2 }
    local m = fabric.model { mesh = mesh, card = soft, warp = 0 }
    m:fix("left", "x y z rotation"):fix("right", "y z"):move("right", { x = history })
    return fabric.dynamic { model = m, duration = 0.4, scheme = scheme, step = scheme == "implicit" and 4e-3 or nil, damping = { mass = 100 }, until_rest = { window = 0.02 } }
  end
  for _, history in ipairs { fabric.ramp(1.5 * mm, 0.2), function(t) return 1.5 * mm * math.min(1, t / 0.2) end } do
    local run = pulled(history):solve()
    local node = run.model.mesh:set("right")[1]
    assert(run.stopped == "at rest" and run.time > 0.2195 and run.time < 0.25, run.time)
    assert(math.abs(run:node(node).ux - 1.5 * mm) < 1e-12)
  end
  local still = pulled(fabric.ramp(1.5 * mm, 0.5)):solve()
  assert(not still.stopped and said(still, "rest"):find("loads or motions still change", 1, true))
  local later = pulled(fabric.history { { 0, 0 }, { 0.1, mm }, { 0.3, mm }, { 0.35, 2 * mm } }):solve()
  assert(later.stopped == "at rest" and later.time > 0.1195 and later.time < 0.15, later.time)
end
