-- Frequencies of cloth with rigid bodies that move freely: what hangs on it, lies on it, or closes its gas.
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local rows = {}
local function row(name, got, want, relative) rows[#rows + 1] = { name, got, want, relative = relative } end

-- A ball that hangs on a light strip: the strip is a string, and the ball turns, too. With the deflection u of the strip's end
-- and the turn t, u = x + a t: M x" = -T u/l, I t" = -T u a/l - T a t.
for _, triangles in ipairs { false, true } do
  local long, mass, r, g = 0.2, 0.1, 0.02, 9.81
  local card = fabric.svk { young = 100e6, poisson = 0, density = 30, thickness = 0.2e-3, bending = { warp = 1e-6, weft = 1e-6, twist = 1e-6 } }
  local mesh = fabric.mesh.rectangle { width = 0.01, height = long, nx = 1, ny = 8, triangles = triangles }:map(function(x, y) return x, 0, y end)
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 } }
  local ball = fabric.rigid.sphere { name = "ball", radius = r, centre = { 0.005, 0, -r - 1e-3 }, mass = mass }
  m:fix("top", "x y z"):fix("all", "x"):tie("rigid", "bottom", ball):contact { between = { ball, "all" } }
  m:fix(ball, "x"):gravity { 0, 0, fabric.ramp(-g, 1) }
  local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  local tension, arm, inertia = mass * g, r + 1e-3, 0.4 * mass * r ^ 2
  local l = a:node(mesh:set("top")[1]).z - a:node(mesh:set("bottom")[1]).z
  local A, B, C = tension / l / mass, tension * arm / l / mass, tension * arm / l / inertia
  local D = (tension * arm ^ 2 / l + tension * arm) / inertia
  local mean, root = (A + D) / 2, math.sqrt((A - D) ^ 2 / 4 + B * C)
  local modes = fabric.modes { from = a, count = 4 } -- among them that in which the ball twists the strip
  local swings = {}
  for _, mode in ipairs(modes) do
    if mode.mass.y > 1e-4 * mass then swings[#swings + 1] = mode.frequency end
  end
  row("pendulum", swings[1], math.sqrt(mean - root) / (2 * math.pi), 2e-3)
  row("pendulum, second", swings[2], math.sqrt(mean + root) / (2 * math.pi), 5e-3)
  row("pendulum, mass that swings", modes.mass.y, mass, 3e-2)
end

-- A heavy ball on a taut membrane: the root of stiffness over mass, where the stiffness is that of a slow push.
do
  local mass = 0.5
  local card = fabric.svk { young = 20e6, poisson = 0.3, density = 100, thickness = 0.3e-3 }
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 8, ny = 8, origin = { -0.1, -0.1, 0 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0, membrane = true, prestress = { warp = 200, weft = 200 } }
  local ball = fabric.rigid.sphere { radius = 0.03, centre = { 0, 0, 0.03 + 0.2e-3 }, mass = mass }
  m:fix("boundary", "x y z"):fix(ball, "x y rotation"):contact { between = { ball, "all" }, friction = 0, stiffness = 3e7 }
  m:force(ball, { z = fabric.history { { 0, 0 }, { 1, -4.95 }, { 2, -5 }, { 3, -5.05 } } })
  local a = fabric.static { model = m, duration = 3, step = 0.5 }
  local function height(time)
    a:advance(time)
    return (select(3, a:body(ball)))
  end
  local less = height(1)
  a:advance(2)
  local frequency = fabric.modes { from = a, count = 1 }[1].frequency
  local stiffness = 0.1 / (less - height(3))
  row("ball on a membrane", frequency, math.sqrt(stiffness / mass) / (2 * math.pi), 1e-2)
end

-- A piston on a closed tube, at rest in the model: gas and cloth are springs beside each other.
for _, triangles in ipairs { false, true } do
  local radius, long, mass, n, air, young, thickness, around = 0.05, 0.1, 0.4, 1.4, 101325, 30e6, 0.3e-3, 32
  local area, perimeter = around / 2 * radius ^ 2 * math.sin(2 * math.pi / around), 2 * around * radius * math.sin(math.pi / around)
  local mesh = fabric.mesh.cylinder { radius = radius, length = long, around = around, along = 2 }
  if triangles then mesh = check.in_triangles(mesh) end
  local card = fabric.svk { young = young, poisson = 0, density = 700, thickness = thickness }
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, membrane = true }
  local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  local plate = fabric.rigid.disc { radius = 0.07, edge = 1e-3, centre = { 0, 0, long + 1e-3 }, normal = { 0, 0, 1 }, name = "plate", mass = mass }
  m:fix("all", "x y"):fix("bottom", "z"):tie("rigid", "top", plate):fix(plate, "x y rotation")
  m:gas { lids = { floor, plate }, exponent = n }
  local stiffness = n * air * area ^ 2 / (area * long) + young * thickness * perimeter / long
  local heavy = mass + 700 * thickness * perimeter * long * 0.375
  row("piston", fabric.modes { model = m, count = 1 }[1].frequency, math.sqrt(stiffness / heavy) / (2 * math.pi), 1e-2)
end
fabric.expect(rows)
