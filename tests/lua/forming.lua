-- Forming: tools of a few lengths, a holder with a force, and what fabric.lab.form returns.
local fabric = require "fabric"
local mm = fabric.units.mm

local function near(name, got, want, relative)
  assert(math.abs(got - want) <= relative * math.abs(want), string.format("%s: expected %.9g, got %.9g", name, want, got))
end

-- Tools of all shapes are closed, so that they can have a mass.
for _, shape in ipairs { { radius = 30 * mm }, { shape = "box", size = { 60 * mm, 40 * mm }, corner = 20 * mm, edge = 5 * mm }, { shape = "box", size = { 40 * mm, 40 * mm }, corner = 20 * mm, edge = 20 * mm },
                         { shape = "double dome", radius = 30 * mm, length = 60 * mm, waist = 20 * mm } } do
  shape.mass = 0.3
  assert(fabric.rigid.punch(shape))
  shape.edge, shape.outer = 5 * mm, 100 * mm
  for _, facing in ipairs { "up", "down" } do
    shape.facing = facing
    assert(fabric.rigid.die(shape))
  end
end
assert(tostring(fabric.rigid.dome { radius = 30 * mm }):find "cylinder")

-- A strip between a plane and a plate with a force N is drawn by 2 mu N.
do
  local card = fabric.svk { young = 5e7, poisson = 0, density = 800, thickness = 0.5e-3 }
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.02, nx = 6, ny = 2 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, -0.25e-3 }, normal = { 0, 0, 1 }, name = "floor" }
  local plate = fabric.rigid.disc { radius = 0.1, centre = { 0.03, 0.01, 2.25e-3 }, normal = { 0, 0, 1 }, edge = 2e-3, mass = 0.02, name = "plate" }
  local mu, N = 0.3, 12
  m:contact { between = { floor, "all" }, friction = mu }:contact { between = { plate, "all" }, friction = mu }
  m:fix(plate, "x y rotation"):force(plate, { z = fabric.ramp(-N, 1e-3) }):damper(plate, { z = 40 })
  m:move("right", { x = fabric.history { { 0, 0 }, { 1e-3, 0 }, { 5e-3, 1.2e-3 } } })
  local a = fabric.dynamic { model = m, duration = 5e-3, damping = { mass = 500 } }
  local sum, count = 0, 0
  a:every(5e-5, function(r) if r.time > 3.5e-3 then sum, count = sum + r:reaction "right", count + 1 end end)
  a:solve()
  near("drag of a strip under a holder", sum / count, 2 * mu * N, 0.03)
  assert(a.energy.error < 5e-3, a.energy.error)
end

-- A quarter between planes of symmetry stands for the whole.
local function form(more)
  local t = { card = fabric.card("blend", { bending = "estimated" }), blank = 60 * mm, punch = { radius = 12 * mm }, die = { radius = 15 * mm, edge = 5 * mm }, holder = { force = 20 },
              stroke = 3 * mm, cells = 12, speed = 8, rows = 8 }
  for k, v in pairs(more or {}) do t[k] = v end
  return fabric.lab.form(t)
end
local whole, part = form(), form { quarter = true, cells = 6 }
near("shear of a quarter", part.angles.max, whole.angles.max, 0.02)
near("draw-in of a quarter", part.draw_in.max, whole.draw_in.max, 0.1)
near("work of a quarter", part.curve[#part.curve].external, whole.curve[#whole.curve].external, 0.05)
assert(#whole.angles == 144 and whole.draw_in.max > 0 and whole.wrinkles.height >= 0 and whole.report:find "shear angle" and not whole.trouble)

-- Plies, springs and gaps.
local stack = form { stack = { 0, 90 }, holder = { springs = 1e5 }, quarter = true, cells = 5, stroke = 1.5 * mm }
assert(stack.angles[#stack.angles].ply == 2 and not stack.trouble and stack.curve[#stack.curve].error < 0.01)
local gap = form { holder = { gap = 0.3 * mm }, quarter = true, cells = 5, stroke = 1.5 * mm }
assert(gap.curve[#gap.curve].holder > 0 and not gap.trouble)

-- Fields that a die does not give follow from the punch; the deck's own tables stay as they are.
do
  local punch, die = { radius = 12 * mm }, {}
  local least = form { punch = punch, die = die, quarter = true, cells = 8, stroke = 1 * mm }
  near("contact on the default edge, ten plies thick", least.contact, 2 * 0.38 * mm, 1e-9)
  assert(not least.trouble and next(die) == nil and punch.shape == nil)
  local box = form { blank = 80 * mm, punch = { shape = "box", size = { 30 * mm, 24 * mm }, corner = 8 * mm, edge = 6 * mm }, die = {}, quarter = true, cells = 8, stroke = 0.2 * mm,
                     prepare = function(a) a:every(1e-6, function() a:stop() end) end }
  near("contact on the default edge of a box", box.contact, 24 * mm / 6 / 5, 1e-9)
end

-- A double dome with its default rim, to the end. It is drawn in most along the yarns that cross the domes, and shears most
-- at a dome's corner; the corners of the blank hardly move.
do
  local dome = fabric.lab.form { card = fabric.card("blend", { bending = "estimated" }), blank = { 170 * mm, 126 * mm },
                                 punch = { shape = "double dome", radius = 30 * mm, length = 60 * mm, waist = 45 * mm }, holder = { force = 60 }, stroke = 16 * mm, quarter = true, cells = 12, speed = 6, rows = 8 }
  assert(not dome.trouble and math.abs(dome.stroke - 16 * mm) < 1e-9 and dome.curve[#dome.curve].error < 2e-3)
  near("default rim of a double dome", dome.contact, 30 * mm / 6 / 5, 1e-9)
  local most
  for _, row in ipairs(dome.draw_in) do
    if not most or row.draw_in > most.draw_in then most = row end
  end
  assert(most.edge == "top" and math.abs(most.X - 30 * mm) < 10 * mm, ("%s at %.3g m"):format(most.edge, most.X))
  local place = dome.angles.place
  assert(place.X > 35 * mm and place.Y > 15 * mm, ("most shear at %.3g, %.3g m"):format(place.X, place.Y))
end
