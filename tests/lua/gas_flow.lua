-- Gas that flows: through vents, faster and slower than sound, through cloth, and between two cells; and a drum that is pressed together. The
-- supports hold or move every node, so that the volumes are exact. Closed forms.
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local near = check.near

local molar, cp, outside, T0 = 0.028965, 1005, 101325, 293.15
local R = 8.314462618 / molar
local ratio = cp / (cp - R)
local rows = {}

local E, nu, t = 1e6, 0.25, 0.4e-3
local card = fabric.svk { young = E, poisson = nu, density = 900, thickness = t }
local function drum(triangles)
  local mesh = fabric.mesh.cylinder { radius = 0.06, length = 0.15, around = 12, along = 3 }
  if triangles then
    local nodes, halves = {}, {}
    for i = 1, #mesh.nodes do nodes[i] = { mesh.nodes[i][1], mesh.nodes[i][2], mesh.nodes[i][3] } end
    for i = 1, #mesh.elements do
      local e = mesh.elements[i]
      halves[#halves + 1], halves[#halves + 2] = { e[1], e[2], e[3] }, { e[1], e[3], e[4] }
    end
    mesh = fabric.mesh { nodes = nodes, elements = halves }
    mesh:set("bottom", function(_, _, z) return z < 1e-9 end)
    mesh:set("top", function(_, _, z) return z > 0.15 - 1e-9 end)
  end
  return fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, membrane = true }
end
local function held(given, duration, steps)
  local m = drum(false):fix("all", "x y z")
  given.lids = { "bottom", "top" }
  local g = m:gas(given)
  local a = fabric.static { model = m, duration = duration, step = duration / (steps or 20) }
  return a, g
end
local V = 12 / 2 * 0.06 ^ 2 * math.sin(2 * math.pi / 12) * 0.15 -- of the prism

-- Pressed together without loss of heat: the force is that of the gas on the lid and that of the cloth without gas.
for _, triangles in ipairs { false, true } do
  local m = drum(triangles):fix("all", "x y"):fix("bottom", "z"):move("top", { z = fabric.ramp(-0.045, 1) })
  local g = m:gas { lids = { "bottom", "top" }, exponent = 1.4, initial = 2000 }
  local a = fabric.static { model = m, duration = 1, step = 0.2 }
  local empty = drum(triangles):fix("all", "x y"):fix("bottom", "z"):move("top", { z = fabric.ramp(-0.045, 1) })
  local _, _, cloth = fabric.static { model = empty, duration = 1, step = 0.2 }:solve():reaction "top"
  a:solve()
  local p, volume, mass, T = a:gas(g)
  local s = 1 - 0.045 / 0.15
  near(volume, s * V, 1e-12, "volume")
  rows[#rows + 1] = { "pressed, p", p + outside, (outside + 2000) * s ^ -1.4, relative = 1e-12 }
  rows[#rows + 1] = { "pressed, T", T, T0 * s ^ -0.4, relative = 1e-12 }
  local _, _, z = a:reaction "top"
  rows[#rows + 1] = { "pressed, force", z, cloth - p * V / 0.15, relative = 1e-9 }
  assert(a.energy.error < 1e-6, a.energy.error)
  rows[#rows + 1] = { "mass", mass, (outside + 2000) * V / (R * T0), relative = 1e-12 }
end

-- Through a vent, choked, without loss of heat: p/p0 = (1 + (k - 1)/2 t/tau)^(-2 k/(k - 1)).
local choked = math.sqrt(ratio) * (2 / (ratio + 1)) ^ ((ratio + 1) / (2 * (ratio - 1)))
local A, c = 2e-5, 0.7
do
  local a, g = held({ initial = 400e3, exponent = ratio, vents = { { area = A, coefficient = c } } }, 0.1)
  a:solve()
  local p0, tau = outside + 400e3, V / (c * A * choked * math.sqrt(R * T0))
  local p, _, _, T = a:gas(g)
  assert(p > 0.9 * outside)
  rows[#rows + 1] = { "choked", p + outside, p0 * (1 + (ratio - 1) / 2 * 0.1 / tau) ^ (-2 * ratio / (ratio - 1)), relative = 1e-4 }
  rows[#rows + 1] = { "choked, T", T, T0 * ((p + outside) / p0) ^ ((ratio - 1) / ratio), relative = 1e-12 }
  assert(a.energy.vents > 0 and a.energy.error < 1e-6)
end
-- The same kept at its temperature: exponential. From a hole of a set, which counts by its area.
do
  local a, g = held({ initial = 400e3, vents = { { set = "all", coefficient = 5e-4 } } }, 0.1)
  a:solve()
  local round = 12 * 2 * 0.06 * math.sin(math.pi / 12)
  local tau = V / (5e-4 * round * 0.15 * choked * math.sqrt(R * T0))
  rows[#rows + 1] = { "choked, isothermal", a:gas(g) + outside, (outside + 400e3) * math.exp(-0.1 / tau), relative = 1e-4 }
end
-- Slower than sound: integrated here by the rule of Runge and Kutta.
do
  local a, g = held({ initial = 20e3, vents = { { area = A } } }, 0.2)
  a:solve()
  local function rate(m)
    local r = outside / (m * R * T0 / V)
    local k = ratio
    return -0.6 * A * outside / r * math.sqrt(2 * k / (k - 1) * (r ^ (2 / k) - r ^ ((k + 1) / k)) / (R * T0))
  end
  local m, h = (outside + 20e3) * V / (R * T0), 0.2 / 400
  for _ = 1, 400 do
    local k1 = rate(m)
    local k2 = rate(m + h / 2 * k1)
    local k3 = rate(m + h / 2 * k2)
    m = m + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(m + h * k3))
  end
  local _, _, mass = a:gas(g)
  rows[#rows + 1] = { "slower than sound", mass, m, relative = 1e-5 }
end
-- Emptied to the pressure outside, and from less than that filled: it stays there.
for _, initial in ipairs { 5e3, -5e3 } do
  local a, g = held({ initial = initial, vents = { { area = 1e-3 } } }, 1, 5)
  a:solve()
  near(a:gas(g) + outside, outside, 1e-9, "balanced")
end
-- Through the cloth in proportion to the pressure: (p - o)/p falls exponentially. In three ways of giving it.
for _, leakage in ipairs { 0.0004, { 0.004, 1000 }, function(p) return 0.0004 * p / 100 end } do
  local a, g = held({ initial = 10e3, leakage = leakage }, 0.1)
  a:solve()
  local area = 12 * 2 * 0.06 * math.sin(math.pi / 12) * 0.15
  local part = 10e3 / (outside + 10e3) * math.exp(-area * 0.0004 / 100 * outside * 0.1 / V)
  rows[#rows + 1] = { "leakage", a:gas(g), outside / (1 - part) - outside, relative = 1e-4 }
end
-- It opens at 5000 Pa, and not before.
do
  local a, g = held({ inflow = 1e-3, vents = { { area = 1e-3, opens = 5000 } } }, 0.2)
  local most = 0
  a:every("step", function() most = math.max(most, (a:gas(g))) end)
  a:solve()
  assert(most > 5000 and most < 6000 and a:gas(g) < 200, most)
end
-- Two cells: the pressures become equal, no gas is lost, and a restored state goes on with the same bits.
do
  local one = fabric.mesh.cylinder { radius = 0.05, length = 0.1, around = 8, along = 2 }
  local two = fabric.mesh.cylinder { radius = 0.04, length = 0.1, around = 8, along = 2 }:map(function(x, y, z) return x + 0.2, y, z end)
  local m = fabric.model { bodies = { { name = "one", mesh = one, card = card, warp = { 0, 0, 1 } }, { name = "two", mesh = two, card = card, warp = { 0, 0, 1 } } } }
  for _, name in ipairs { "one", "two" } do m:fix(name .. ".bottom", "x y z"):fix(name .. ".top", "x y z") end
  local first = m:gas { set = "one.all", lids = { "one.bottom", "one.top" } }
  local second = m:gas { set = "two.all", lids = { "two.bottom", "two.top" }, initial = 3000, vents = { { area = 1e-4, to = first } } }
  local a = fabric.static { model = m, duration = 0.1, step = 0.002 }
  local _, _, m1 = a:gas(first)
  local _, _, m2 = a:gas(second)
  a:advance(0.02)
  local middle = a:snapshot()
  a:solve()
  local p1, _, n1 = a:gas(first)
  local p2, _, n2 = a:gas(second)
  near(n1 + n2, m1 + m2, 1e-12, "mass of both")
  near(p1, p2, 1e-3, "pressures")
  assert(n1 > m1 and p1 > 20 and a.energy.vents > 0)
  a:restore(middle):solve()
  assert(p1 == a:gas(first) and p2 == a:gas(second), "the same bits")
end
fabric.expect(rows)
