-- Cloth that tools press deep into the barrier of contact: its explicit steps stay as planned. A sheet between a floor and a plate that is driven to a
-- given height has the pressure of the law there; a ball stops; a blank whose elements are longer than the radius of a die's edge is drawn over it, under a holder in
-- a fixed gap of a ply, to the end of the stroke, squares and (less deep, since they resist the fold over the edge) triangles; and a restart in the middle has the same bits.
-- warns: guard
-- warns: a barrier keeps them apart
-- warns: cloth turns by
-- warns: of the kinetic energy is in rotary inertia
-- warns: its stiffness was assumed
-- warns: a ball or a rod
-- warns: its force on cloth that stays flat
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local mm = fabric.units.mm

-- --- pressed flat: the law of share/doc/contact.md
do
  local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.02, nx = 3, ny = 2 }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), points = 1, warp = 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, -0.2 * mm }, normal = { 0, 0, 1 }, name = "floor" }
  local plate = fabric.rigid.plane { point = { 0, 0, 0.3 * mm }, normal = { 0, 0, -1 }, name = "plate" }
  local down = 0.345 * mm
  m:contact { between = { floor, "all" } }:contact { between = { plate, "all" } }
  m:move(plate, { z = fabric.history { { 0, 0 }, { 5e-3, -down }, { 1, -down } } })
  local a = fabric.dynamic { model = m, duration = 7e-3, damping = { mass = 2000 } }
  local planned = a.step_size
  a:solve()
  local from, floor_at, stiffness = 0.19 * mm, 0.0747333 * mm, 2.28347e9
  local range = from - floor_at
  local quarter, depth = range / 4, from - (0.5 * mm - down) / 2
  local y = (range - depth) / quarter
  local pressure = stiffness * (depth - 0.1 * range) + stiffness * quarter * (1 - y) ^ 2 * (1 + 2 * y) / y ^ 2
  local _, _, up = a:reaction(plate)
  fabric.expect {
    { "pressure of the law at that height, N", math.abs(up), 0.03 * 0.02 * pressure, relative = 0.02 },
    { "steps", #a.steps, 7e-3 / planned, relative = 0.02 },
    { "ledger", a.energy.error, 0, absolute = 1e-3 },
  }
end

-- --- a ball that is driven in fast, stops and is drawn along: what meets the barrier goes along with it, so that the barrier's account is not below 0,
-- as no stored energy is, and no work of that inertia is lost as that of an impact (it was -9 uJ, with 22 uJ lost)
do
  local card = fabric.svk { density = 500, thickness = 0.5 * mm, warp = 40e6, weft = 25e6, shear = 9e6, poisson = { 0.25, 0.15625 }, bending = { warp = 4e-5, weft = 3e-5, twist = 2e-5 } }
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.06, nx = 8, ny = 8, origin = { -0.03, -0.03 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("boundary", "x y z")
  local ball = fabric.rigid.sphere { radius = 12 * mm, centre = { -2 * mm, 0, 12.3 * mm } }
  m:contact { between = { ball, "all" }, friction = 0.3 }
  m:move(ball, { x = fabric.history { { 0, 0 }, { 0.01, 0 }, { 0.03, 4 * mm } }, z = fabric.history { { 0, 0 }, { 0.01, -5 * mm } } })
  local a, least = fabric.dynamic { model = m, duration = 0.03, damping = { mass = 200 } }, 0
  for i = 1, 60 do
    a:advance(0.0005 * i)
    least = math.min(least, a.energy.guard)
  end
  fabric.expect {
    { "energy of the barrier, least, J", least, 0, absolute = 1e-9 },
    { "lost in impacts, uJ", 1e6 * a.energy.impact, 7, absolute = 3 },
    { "ledger", a.energy.error, 0, absolute = 1e-4 },
  }
end

-- --- pinched on a die's edge
local cells, duration = 10, 0.012
local function form(triangles)
  local n, R, hole, edge, side = cells, 26 * mm, 29 * mm, 6 * mm, 90 * mm
  local card = fabric.card("blend", { bending = "estimated" })
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n, origin = { -side / 2, -side / 2, 0 }, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0, points = 1 }
  local half = card.thickness / 2
  local punch = fabric.rigid.sphere { radius = R, centre = { 0, 0, R + half }, name = "punch" }
  local die = fabric.rigid.die { radius = hole, edge = edge, outer = 75 * mm, facing = "up", at = { 0, 0, -half }, name = "die" }
  local holder = fabric.rigid.die { radius = hole, edge = edge, outer = 75 * mm, facing = "down", at = { 0, 0, half }, name = "holder" }
  for _, tool in ipairs { die, holder, punch } do m:contact { between = { tool, "all" }, friction = 0.2, settle = tool ~= punch and duration / 20 or nil } end
  m:move(punch, { z = function(t)
    local s = math.max(0, t / duration - 0.05) / 0.95
    return -(triangles and 15 or 24) * mm * s * s * (3 - 2 * s)
  end })
  return fabric.dynamic { model = m, duration = duration, damping = { mass = 50 } }, punch
end

-- In the middle of the barrier a restart has the same bits.
local function restart(a, punch)
  a:advance(0.6 * duration)
  assert(a.energy.guard ~= 0 and a.time < 0.61 * duration)
  check.same_after_restore(a, (cells + 1) ^ 2, 0.62 * duration, function()
    return a.energy.guard, a.energy.friction, a.energy.external, a:reaction(punch)
  end)
end

for _, triangles in ipairs { false, true } do
  local a, punch = form(triangles)
  local planned = duration / a.step_size
  if not triangles then restart(a, punch) end
  a:solve()
  local _, _, force = a:reaction(punch)
  print(("%s: %d steps, planned %.0f, punch %.1f N, guard %.2g of %.3g J, ledger %.1g"):format(triangles and "triangles" or "squares", #a.steps, planned, -force, a.energy.guard, a.energy.external, a.energy.error))
  assert(#a.steps < 2 * planned, #a.steps / planned)
  assert(a.energy.error < 1e-2 and a:gap() > 0)
end
print "pinched ok"
