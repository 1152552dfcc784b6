-- The balance of static runs whose supports turn and whose bodies move: closed forms of their work, and what is said where it is uncertain.
-- warns: more energy than what moves can have given it
-- warns: contact follows the bodies that turn
-- warns: relaxation has taken
local fabric = require "fabric"
local mm = fabric.units.mm
local L, w, B = 0.1, 0.02, 5e-6
local sheet = fabric.svk { young = 5e6, poisson = 0, density = 600, thickness = 0.4 * mm, name = "sheet", bending = { warp = B, weft = B, twist = B } }

-- A strip whose end is turned and free to move: M = B w angle / L, work B w angle^2 / (2 L), at any steps.
for _, triangles in ipairs { false, true } do
  for _, step in ipairs { 1, 0.25, 0.05 } do
    local mesh = fabric.mesh.rectangle { width = L, height = w, nx = 10, ny = 2, triangles = triangles }
    local m = fabric.model { mesh = mesh, card = sheet, warp = 0 }
    m:fix("left", "x y z rotation"):turn("right", { axis = { 0, 1, 0 }, angle = fabric.ramp(90, 1) })
    local a = fabric.static { model = m, duration = 1, step = step }:solve()
    local name = ("%s, steps of %g: "):format(triangles and "triangles" or "quadrilaterals", step)
    fabric.expect {
      { name .. "work, J", a.energy.external, B * w * (math.pi / 2) ^ 2 / (2 * L), relative = triangles and 5e-3 or 2e-6 },
      { name .. "made from nothing", a.energy.error, 0, absolute = 0 },
    }
  end
end

-- Its end goes around a centre on the strip, which bends and pulls: the forces turn with it. In one step of 20 degrees as in fifty.
local function around(step)
  local mesh = fabric.mesh.rectangle { width = L, height = w, nx = 10, ny = 1 }
  local m = fabric.model { mesh = mesh, card = sheet, warp = 0 }
  m:fix("left", "x y z rotation"):turn("right", { axis = { 0, 1, 0 }, angle = fabric.ramp(-40, 1), centre = { 0.02, 0, 0 } })
  return fabric.static { model = m, duration = 1, step = step }:solve()
end
for _, step in ipairs { 0.5, 0.02 } do
  local a = around(step)
  fabric.expect { { ("around a centre, steps of %g: work, J"):format(step), a.energy.external, a.energy.stored, relative = 2e-3 } }
end

-- A sheet that turns as a whole does no work, unloaded or blown up: the pressure's work is that of the sheet that stands.
local function turned(step, degrees, pressure)
  local mesh = fabric.mesh.rectangle { width = L, height = 0.06, nx = 8, ny = 4 }
  local m = fabric.model { mesh = mesh, card = sheet, warp = 0 }
  m:turn("boundary", { axis = { 0, 1, 0 }, angle = fabric.history { { 0, 0 }, { 1, 0 }, { 2, degrees } }, centre = { 0.3, 0, 0 } })
  if pressure > 0 then m:pressure(fabric.history { { 0, 0 }, { 1, pressure }, { 2, pressure } }) end
  return fabric.static { model = m, duration = 2, step = step }:solve()
end
for _, step in ipairs { 1, 0.25, 0.1 } do
  local still, moved, bare = turned(step, 0, 100), turned(step, 85, 100), turned(step, 85, 0)
  fabric.expect {
    { ("turned by 85 degrees, steps of %g: work, J"):format(step), moved.energy.external, still.energy.external, relative = 1e-6 },
    { "energy stored, J", moved.energy.stored, still.energy.stored, relative = 1e-9 },
    { "work without pressure, J", bare.energy.external, 0, absolute = 1e-12 },
  }
  assert(#bare.warnings == 0)
end

-- A ball that is pressed into a sheet, and then turns or slides. Without friction a ball that turns does nothing.
local function pressed(step, friction, method, motion)
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 8, ny = 8 }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), warp = 0 }
  local ball = fabric.rigid.sphere { radius = 15 * mm, centre = { 50 * mm, 50 * mm, 15.6 * mm }, name = "ball" }
  motion.z = fabric.history { { 0, 0 }, { 0.5, -8 * mm }, { 1, -8 * mm } }
  m:fix("boundary", "x y z"):contact { between = { ball, "all" }, friction = friction }:move(ball, motion)
  local a = fabric.static { model = m, duration = 1, step = step, method = method }
  a:advance(0.5)
  local first = a.energy.stored
  a:solve()
  return a, first, select(3, a:reaction(ball))
end
local function spin() return { turn = { axis = { 0, 0, 1 }, angle = fabric.history { { 0, 0 }, { 0.5, 0 }, { 1, 60 } } } } end
for _, method in ipairs { "newton", "either", "relaxation" } do
  local a, first = pressed(0.1, 0, method, spin())
  fabric.expect { { method .. ": energy stored under a ball that turns without friction, J", a.energy.stored, first, relative = 1e-6 } }
end
local least, most = math.huge, 0
for _, step in ipairs { 0.5, 0.1, 0.05 } do
  local a = pressed(step, 0.4, nil, spin())
  least, most = math.min(least, a.energy.friction), math.max(most, a.energy.friction)
  assert(a.energy.error < 1e-9, a.energy.error)
end
fabric.expect { { "what friction takes from a ball that turns, largest over smallest of three steps", most / least, 1, relative = 1e-3 } }

-- The sideways force on a ball that slides rises and falls within a long step: its work is said to be uncertain, and is not in short ones.
local function slide() return { x = fabric.history { { 0, 0 }, { 0.5, 0 }, { 1, 15 * mm } } } end
local function says(a)
  for _, warning in ipairs(a.warnings) do
    if warning.code == "ledger" then return warning.text end
  end
end
local long, _, force = pressed(0.5, 0, nil, slide())
local short, _, right = pressed(0.05, 0, nil, slide())
assert(says(long) and says(long):find("more energy than what moves can have given it", 1, true), says(long))
assert(not says(short), says(short))
assert(long.energy.error > 0.05 and short.energy.error < 0.01)
fabric.expect { { "force on a ball that slides in two steps, N", force, right, relative = 0.01 } }

-- Yarns that are pulled, let go and pulled again within a few long steps: what supports work is what the cloth stores and
-- loses, as in short ones.
local function reversed(step)
  local mesh = fabric.mesh.rectangle { width = 30 * mm, height = 60 * mm, nx = 1, ny = 2 }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), warp = 90 }
  local way = { { 0, 0 }, { 0.2, 6 }, { 0.33, 3.5 }, { 0.47, 7.5 }, { 0.61, 1 }, { 0.83, 8 }, { 1, 6.5 } }
  for _, p in ipairs(way) do p[2] = p[2] * mm end
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.history(way) })
  return fabric.static { model = m, duration = 1, step = step }:solve().energy
end
local few, many = reversed(0.1), reversed(0.002)
fabric.expect {
  { "work over reversals in long steps, J", few.external, many.external, relative = 5e-3 },
  { "work over reversals, of what is stored and lost", few.external / (few.stored + few.dissipated), 1, absolute = 1e-9 },
  { "in short steps", many.external / (many.stored + many.dissipated), 1, absolute = 1e-9 },
}
