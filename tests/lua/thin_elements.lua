-- Nodes at the thin elements of a rim take mass from those about them for the step of explicit motion: the step is nearly that of squares, weight and
-- free fall stay, and motion is hardly another.
local fabric = require "fabric"
local mm = fabric.units.mm
local rows = {}
local function like(name, got, want, part) rows[#rows + 1] = { name, got, want, relative = part } end

local card = fabric.card("blend", { bending = "estimated" })
local bodice = fabric.mesh.panel { size = 15 * mm, grain = 30, outline = {
  { -0.2, 0 }, { 0.2, 0 }, { 0.22, 0.2 }, { spline = { { 0.17, 0.27 }, { 0.18, 0.38 } } }, { 0.08, 0.42 },
  { arc = { through = { 0, 0.36 }, to = { -0.08, 0.42 } }, name = "top" }, { -0.18, 0.38 }, { spline = { { -0.17, 0.27 }, { -0.22, 0.2 } } } } }

local function run(options, build)
  local m = fabric.model { mesh = bodice, card = card, points = 1 }
  m:gravity { 0, 0, -9.81 }
  build(m)
  options.model = m
  local a = fabric.dynamic(options)
  return a
end

-- The step, over that of a square of the same size.
local square = fabric.dynamic { model = fabric.model { mesh = fabric.mesh.rectangle { width = 30 * mm, height = 30 * mm, nx = 2, ny = 2 }, card = card, points = 1 }, duration = 1e-3 }
local fall = run({ duration = 0.01 }, function() end)
print(("step %.3g s, of squares %.3g s"):format(fall.step_size, square.step_size))
rows[#rows + 1] = { "step of a bodice over that of squares", fall.step_size / square.step_size, 1, absolute = 0.2 }

-- It falls freely.
fall:solve()
local least, highest = math.huge, -math.huge
for n = 1, #bodice.nodes do
  local z = fall:node(n).uz
  least, highest = math.min(least, z), math.max(highest, z)
end
print(("falls by %.4f to %.4f mm, free %.4f; error %.2g "):format(-highest / mm, -least / mm, 9.81 / 2 * fall.time ^ 2 / mm, fall.energy.error))
like("free fall, least", highest, -9.81 / 2 * fall.time ^ 2, 1e-4)
like("free fall, most", least, -9.81 / 2 * fall.time ^ 2, 1e-4)

-- It swings from the horizontal about one edge.
local function swing(inertia)
  local a = run({ duration = 0.06, inertia = inertia }, function(m) m:fix("top", "x y z") end)
  a:solve()
  local at = {}
  for n = 1, #bodice.nodes do at[n] = a:node(n) end
  print(("inertia %s: hem at %.2f %.2f %.2f mm, %.4g J, error %.2g, step %.3g s"):format(inertia or "scaled", at[1].x / mm, at[1].y / mm, at[1].z / mm, a.energy.kinetic, a.energy.error, a.step_size))
  return at
end
local own, moved, far, apart = swing "true", swing(), 0, 0
for n = 1, #own do
  far = math.max(far, math.sqrt((own[n].x - own[n].X) ^ 2 + (own[n].y - own[n].Y) ^ 2 + (own[n].z - own[n].Z) ^ 2))
  apart = math.max(apart, math.sqrt((own[n].x - moved[n].x) ^ 2 + (own[n].y - moved[n].y) ^ 2 + (own[n].z - moved[n].z) ^ 2))
end
print(("moves by %.3f mm, apart by up to %.3f mm"):format(far / mm, apart / mm))
rows[#rows + 1] = { "what moved mass changes of a swing", apart / far, 0, absolute = 0.02 }

-- A panel that hangs at rest in statics goes on at rest: its masses stay.
local hung = fabric.model { mesh = bodice, card = card, points = 1 }
hung:gravity { 0, fabric.ramp(-9.81, 1), 0 }:fix("top", "x y z"):fix("all", "z")
local static = fabric.static { model = hung, duration = 1, step = 0.25 }
static:solve()
local on = fabric.dynamic { from = static, duration = 5e-3 }
local kinetic = 0
on:every(1e-3, function() kinetic = math.max(kinetic, on.energy.kinetic) end)
on:solve()
print(("goes on at %.3g s a step, kinetic up to %.2g of %.3g J"):format(on.step_size, kinetic, on.energy.stored))
rows[#rows + 1] = { "motion of what hung at rest", kinetic / on.energy.stored, 0, absolute = 1e-12 }
fabric.expect(rows)
