-- Cloth that is pressed at rest has no velocity in any implicit scheme beside contact, and its kinetic energy is gone: for schemes that damp,
-- by gamma or hht, in quadrilaterals and triangles, by pressure, by weight and between two plates.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.svk { name = "felt", young = 2e6, poisson = 0.2, density = 300, thickness = 1.2 * mm, bending = { warp = 2e-5, weft = 2e-5, twist = 1e-5 } }
local half = card.thickness / 2

local function pressed(options)
  local mesh = fabric.mesh.rectangle { width = 45 * mm, height = 30 * mm, nx = 3, ny = 2, triangles = options.triangles, origin = { 0, 0, half } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:contact { between = { floor, "all" }, friction = options.friction }
  if options.weight then m:gravity { 0, 0, fabric.ramp(-options.weight, 0.02) } end
  if options.pressure then m:pressure(function(t) return -options.pressure * math.min(1, t / 0.02) end) end
  return fabric.dynamic { model = m, duration = 0.05, scheme = "implicit", step = options.step, gamma = options.gamma, hht = options.hht }
end

local checks = {}
for _, o in ipairs {
  { pressure = 220, step = 1e-3, gamma = 0.8 }, { pressure = 220, step = 2.5e-3, gamma = 1, triangles = true },
  { pressure = 900, step = 5e-4, gamma = 0.6 }, { pressure = 220, step = 1e-3, hht = -0.15 }, { pressure = 220, step = 1e-3, hht = -0.05, triangles = true },
  { weight = 400, step = 1e-3, gamma = 0.9, friction = 0.4 },
} do
  local a = pressed(o)
  a:solve()
  local fastest = 0
  for i = 1, #a.model.mesh.nodes do
    local q = a:node(i)
    fastest = math.max(fastest, math.sqrt(q.vx ^ 2 + q.vy ^ 2 + q.vz ^ 2))
  end
  local e = a.energy
  -- With the weight of contact that Newmark's formulas suggest it would be step * pressure * (beta/gamma - 1/2) / areal mass.
  local fault = o.step * (o.pressure or o.weight * card.density * card.thickness) / 16 / (card.density * card.thickness)
  print(("gamma %s, hht %s, step %g: %.1e m/s (a fault would have up to %.1e), kinetic %.1e of %.1e J, damping %.1e, error %.1e"):format(
    o.gamma, o.hht, o.step, fastest, fault, e.kinetic, e.external, e.damping, e.error))
  checks[#checks + 1] = { ("speed at rest, gamma %s, hht %s"):format(o.gamma, o.hht), fastest, 0, absolute = 2e-3 * fault }
  checks[#checks + 1] = { "damping takes energy", e.damping > -2e-3 * e.external and 1 or 0, 1, absolute = 0 }
  checks[#checks + 1] = { "the ledger closes", e.error, 0, absolute = 1e-2 }
end

-- A pressure that grows in long steps makes no velocity, in any scheme that damps, and the mean force of the floor over a window is that of the load.
for _, o in ipairs { {}, { spectral_radius = 0.8 }, { spectral_radius = 0.5, triangles = true }, { hht = -0.2 }, { slow = true }, { spectral_radius = 1 } } do
  local mesh = fabric.mesh.rectangle { width = 45 * mm, height = 30 * mm, nx = 3, ny = 2, triangles = o.triangles, origin = { 0, 0, half } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:contact { between = { floor, "all" } }:pressure(fabric.ramp(-500, 0.05)):gravity { 0, 0, -9.81 }
  local a = fabric.dynamic { model = m, duration = 0.05, scheme = "implicit", step = 1e-2, spectral_radius = o.spectral_radius, hht = o.hht, slow = o.slow }
  local fastest, damping, fell, mean = 0, 0, 0, nil
  a:every("step", function(r)
    for i = 1, r.time > 0.029 and #mesh.nodes or 0 do fastest = math.max(fastest, math.abs(r:node(i).vz)) end -- once it lies
    fell, damping = math.max(fell, damping - r.energy.damping), r.energy.damping
    local _, _, force = r:reaction(floor, { window = 0.03 })
    if r.time > 0.0499 then mean = force end
  end)
  a:solve()
  local name = ("grows, radius %s, hht %s, slow %s: "):format(o.spectral_radius, o.hht, o.slow)
  local area, weight = 45 * mm * 30 * mm, 9.81 * card.density * card.thickness
  checks[#checks + 1] = { name .. "largest speed, m/s", fastest, 0, absolute = 8e-3 } -- by alpha 0.1, 0.044 and 0.015
  checks[#checks + 1] = { name .. "damping falls by, J", fell, 0, absolute = 1e-12 }
  checks[#checks + 1] = { name .. "mean pressure from 20 to 50 ms, Pa", math.abs(mean) / area, 350 + weight, relative = 0.01 }
end

-- Yarns of woven cloth at rest are at the kink between slack and taut: steps of 5 ms hold, in some ten iterations.
for _, n in ipairs { 6, 16 } do
  local denim = fabric.card("denim", { bending = "estimated" })
  local mesh = fabric.mesh.rectangle { width = 60 * mm, height = 60 * mm, nx = n, ny = n }
  local m = fabric.model { mesh = mesh, card = denim, warp = 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, -denim.thickness / 2 }, normal = { 0, 0, 1 } }
  m:contact { between = { floor, "all" }, friction = 0.3 }:gravity { 0, 0, -9.81 }
  local a = fabric.dynamic { model = m, duration = 0.05, scheme = "implicit", step = 5e-3 }
  a:solve()
  local iterations = 0
  for i = 1, #a.steps do iterations = iterations + a.steps[i].iterations end
  print(("denim at rest, %d elements a side: %d steps, %d iterations"):format(n, #a.steps, iterations))
  checks[#checks + 1] = { "steps of denim at rest, at most 12", math.max(#a.steps, 12), 12, absolute = 0 }
  checks[#checks + 1] = { "iterations of denim at rest, at most 200", math.max(iterations, 200), 200, absolute = 0 }
  checks[#checks + 1] = { "the ledger of denim at rest", a.energy.error, 0, absolute = 1e-6 }
end

local ok, words = pcall(function()
  local mesh = fabric.mesh.rectangle { width = 45 * mm, height = 30 * mm, nx = 3, ny = 2, origin = { 0, 0, half } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:contact { between = { fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }, "all" } }
  return fabric.dynamic { model = m, duration = 0.05, scheme = "implicit", step = 1e-3, gamma = 0.9, beta = 0.6 }
end)
assert(not ok and tostring(words):find("field 'beta': expected none beside contact, or gamma/2 = 0.45, got 0.6", 1, true), words)
fabric.expect(checks)
