-- Beside contact the rule of a deck that chooses none damps a little. A first error of a thousandth in the ledger, as of a sheet that swings, changes
-- nothing: a weight falls as deep as in explicit steps, and what touches nothing keeps its swing and its turning.
-- warns: the ledger's error is
-- warns: the time scheme has taken
local fabric = require "fabric"
local mm = fabric.units.mm
local rows = {}
local function most(name, got, want, part) rows[#rows + 1] = { name, got, want, relative = part } end

-- A ball of 20 g falls by 30 mm onto a held sheet, which has swung by itself before.
local blend = fabric.card("blend", { bending = "estimated" })
local function depth(options, triangles)
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 8, ny = 8, origin = { -0.1, -0.1, 0 }, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = blend, warp = 0 }
  local start = 20 * mm + blend.thickness / 2 + 30 * mm
  local ball = fabric.rigid.sphere { radius = 20 * mm, centre = { 0, 0, start }, mass = 0.02 }
  m:fix("boundary", "x y z"):gravity({ 0, 0, -9.81 }):contact { between = { ball, "all" }, friction = 0.3 }
  options.model, options.duration, options.damping = m, 0.13, { mass = 30 }
  local a, lowest = fabric.dynamic(options), start
  a:every("step", function() lowest = math.min(lowest, (select(3, a:body(ball)))) end)
  a:solve()
  return 20 * mm + blend.thickness / 2 - lowest, a
end
for _, triangles in ipairs { false, true } do
  local truth = depth({}, triangles)
  for _, step in ipairs { 5e-3, 1e-2 } do
    local got, a = depth({ scheme = "implicit", step = step }, triangles)
    print(("%s, %g ms: %.2f mm, explicit %.2f, damping %.3g of %.3g J"):format(triangles and "triangles" or "quadrilaterals", step * 1e3, got / mm, truth / mm, a.energy.damping, a.energy.external))
    most(("depth of a ball, %s, %g ms"):format(triangles and "triangles" or "quadrilaterals", step * 1e3), got, truth, step * 8)
  end
end

-- A cloth that hangs at its top swings from 30 degrees, 0.6 m above a floor: 53 steps to a period, or what an error asks for.
for _, o in ipairs { { step = 1e-2 }, { error = 1e-3 } } do
  local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.1, nx = 2, ny = 8 }
  local angle = math.rad(30)
  mesh:map(function(x, y) return x, -(0.1 - y) * math.cos(angle), (0.1 - y) * math.sin(angle) end)
  local card = fabric.svk { young = 5e7, poisson = 0, density = 500, thickness = 0.4 * mm, bending = { warp = 6e-5, weft = 6e-5, twist = 3e-5 } }
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 1, 0 } }
  m:fix("top", "x y z"):gravity { 0, -9.81, 0 }
  m:contact { between = { fabric.rigid.plane { point = { 0, -0.7, 0 }, normal = { 0, 1, 0 } }, "all" }, friction = 0.2 }
  local a = fabric.dynamic { model = m, duration = 1.8, scheme = "implicit", step = o.step, error = o.error }
  local peaks, z, rises = {}, a:node(1).z, false
  a:every("step", function()
    local now = a:node(1).z
    if rises and now < z then peaks[#peaks + 1] = z end
    rises, z = now > z, now
  end)
  a:solve()
  for _, peak in ipairs(peaks) do print(("swing, %s: %.1f mm"):format(o.step and "10 ms" or "error=", peak / mm)) end
  most("the third swing of a pendulum, " .. (o.step and "10 ms" or "error="), peaks[3], 0.05, 0.08)
end

-- A free sheet turns twice in a second, 100 steps to a turn.
do
  local w = 0.1
  local card = fabric.svk { young = 2e7, poisson = 0.2, density = 500, thickness = 0.4 * mm, bending = { warp = 2e-5, weft = 2e-5, twist = 1e-5 } }
  local mesh = fabric.mesh.rectangle { width = w, height = w, nx = 4, ny = 4, origin = { -w / 2, -w / 2, 0 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:velocity("all", { spin = { 0, 0, 720 } }):contact { between = { fabric.rigid.plane { point = { 0, 0, -0.2 }, normal = { 0, 0, 1 } }, "all" } }
  local a, first = fabric.dynamic { model = m, duration = 1, scheme = "implicit", step = 5e-3 }, nil
  a:every("step", function() first = first or a.energy.kinetic end)
  a:solve()
  print(("spin: %.3f of the energy"):format(a.energy.kinetic / first))
  most("energy of a turning", a.energy.kinetic / first, 1, 0.1)
end
fabric.expect(rows)
