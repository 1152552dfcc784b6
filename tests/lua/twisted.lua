-- Cloth that presses itself deep into the barrier of contact: its explicit steps stay as planned. Two sheets that a pressure holds together in flight
-- have the gap of the law and keep their momentum, also where their meshes are out of line; a strip that is twisted by more than a turn goes through
-- its barrier in squares and triangles, with nothing through; and a restart there has the same bits.
-- warns: guard
-- warns: a barrier keeps them apart
-- warns: cloth turns by
-- warns: turned inside out
-- warns: is turned over: it is more than 90 degrees
-- warns: the guard of the directors has
local fabric = require "fabric"
local brute = dofile((arg[0]:gsub("[^/]*$", "../../scripts/contact/brute.lua")))
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local mm = fabric.units.mm
local card = fabric.card("blend", { bending = "estimated" })

-- --- two sheets that only move along z: the law of share/doc/contact.md
local function pressed(pressure, shift, triangles)
  local function sheet(z, by)
    return fabric.mesh.rectangle { width = 0.03, height = 0.02, nx = 3, ny = 2, origin = { by - 0.015, by / 2 - 0.01, z }, triangles = triangles }
  end
  local low, high = sheet(0, 0), sheet(0.37 * mm, shift)
  local m = fabric.model { bodies = { { name = "low", mesh = low, card = card, warp = 0 }, { name = "high", mesh = high, card = card, warp = 0 } }, points = 1 }
  m:contact { between = { "low", "high" }, friction = 0.3 }
  local function rising(way) return fabric.history { { 0, 0 }, { 3e-3, way * pressure }, { 1, way * pressure } } end
  m:pressure(rising(1), "low.all"):pressure(rising(-1), "high.all")
  for _, set in ipairs { "low.all", "high.all" } do m:fix(set, "x y rotation"):velocity(set, { z = 5 }) end
  local a = fabric.dynamic { model = m, duration = 6e-3 }
  a:solve()
  local mass, nodes = {}, 0
  for _, mesh in ipairs { low, high } do
    for _, e in ipairs(mesh.elements) do
      for _, i in ipairs(e) do mass[nodes + i] = (mass[nodes + i] or 0) + (triangles and 1 / 6 or 1 / 4) end
    end
    nodes = nodes + #mesh.nodes
  end
  local sum, momentum = 0, 0
  for i, v in ipairs(a:field "velocity") do
    sum = sum + mass[i]
    momentum = momentum + mass[i] * v[3]
  end
  print(("two sheets, %g Pa: %d steps, planned %.0f, guard %.2g J, ledger %.1g"):format(pressure, #a.steps, 6e-3 / a.step_size, a.energy.guard, a.energy.error))
  fabric.expect {
    { "speed of the centre, m/s", momentum / sum, 5, relative = 1e-11 },
    { "ledger", a.energy.error, 0, absolute = 1e-4 },
  }
  assert(a.energy.guard > 1e-5 and #a.steps < 2 * 6e-3 / a.step_size, #a.steps)
  return a
end

do
  local a = pressed(7e5, 0)
  local from, floor, stiffness = 0.38 * mm, 0.149466667 * mm, 2.28347e9
  local range = from - floor
  local y = a:gap() / (range / 4)
  local pressure = stiffness * (0.9 * range - a:gap()) + stiffness * range / 4 * (1 - y) ^ 2 * (1 + 2 * y) / y ^ 2
  fabric.expect { { "pressure of the law at the smallest gap, Pa", pressure, 7e5, relative = 0.01 } }
end
pressed(5e5, 2.5 * mm)
pressed(5e5, 3.5 * mm, true)

-- --- a twisted strip
local long, wide, duration, turns = 0.1, 0.04, 0.03, 1
local function twist(triangles)
  local mesh = fabric.mesh.rectangle { width = long, height = wide, nx = 14, ny = 6, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  m:fix("left", "x y z")
  m:turn("right", { axis = { 1, 0, 0 }, centre = { long, wide / 2, 0 }, angle = function(t)
    local s = math.min(1, t / duration)
    return 360 * turns * s * s * (3 - 2 * s)
  end })
  m:contact { self = "all", friction = 0.3 }
  return fabric.dynamic { model = m, duration = duration, damping = { mass = 60 } }, mesh
end

-- In the barrier a restart has the same bits.
local function restart(a, mesh)
  assert(a.energy.guard > 0 and a.time < 0.81 * duration)
  check.same_after_restore(a, #mesh.nodes, 0.82 * duration, function()
    return a.energy.guard, a.energy.friction, a.energy.external, a.energy.impact
  end)
end

for _, triangles in ipairs { false, true } do
  local a, mesh = twist(triangles)
  local planned = duration / a.step_size
  local look, through = brute.watch(mesh), 0
  a:every(duration / 50, function(run) through = through + #look(run) end)
  a:advance(0.8 * duration)
  if not triangles then restart(a, mesh) end
  a:solve()
  print(("twisted, %s: %d steps, planned %.0f, guard %.2g of %.3g J, ledger %.1g"):format(triangles and "triangles" or "squares", #a.steps, planned, a.energy.guard, a.energy.external, a.energy.error))
  assert(#a.steps < 1.6 * planned, #a.steps / planned)
  assert(through == 0 and a:gap() > 0 and a.energy.guard > 1e-5 and a.energy.error < 1e-3)
end
