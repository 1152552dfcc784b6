-- A strip one element wide hangs from a horizontal clamp under its weight. Its directors could lean across the
-- fold at the clamp, to opposite sides at its two edges, where the shear of the elements does not see them, and
-- take its stiffness away. The shape is that of the heavy elastica, whatever the rigidity across the strip:
--   B theta'' = -w (L - s) cos theta,   theta(0) = 0,   theta'(L) = 0.
local fabric = require "fabric"

local length, width = 0.11, 0.008
local B = 11e-6
local card = fabric.card "denim":with { bending = { warp = B, weft = B / 10, twist = 4e-6 } }
local weight = card.density * card.thickness * 9.81 -- N/m2

-- From the free end, which is `short` of vertical: the angle at the clamp, and the end from there.
local function from_end(short)
  local n = 4000
  local h, theta, slope, x, z = length / n, math.pi / 2 - short, 0, 0, 0
  local function bend(r, angle) return -weight * r / B * math.cos(angle) end -- r: from the end
  for i = 0, n - 1 do -- Runge and Kutta's method backwards
    local r = i * h
    local k1, m1 = slope, bend(r, theta)
    local k2, m2 = slope - h / 2 * m1, bend(r + h / 2, theta - h / 2 * k1)
    local k3, m3 = slope - h / 2 * m2, bend(r + h / 2, theta - h / 2 * k2)
    local k4, m4 = slope - h * m3, bend(r + h, theta - h * k3)
    local before = theta
    theta = theta - h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    slope = slope - h / 6 * (m1 + 2 * m2 + 2 * m3 + m4)
    local middle = (before + theta) / 2 + h / 8 * (k4 - k1)
    x = x + h / 6 * (math.cos(before) + 4 * math.cos(middle) + math.cos(theta))
    z = z + h / 6 * (math.sin(before) + 4 * math.sin(middle) + math.sin(theta))
  end
  return theta, x, z
end

local low, high = math.log(1e-12), math.log(1)
for _ = 1, 60 do
  local middle = (low + high) / 2
  if from_end(math.exp(middle)) > 0 then low = middle else high = middle end
end
local _, reach, drop = from_end(math.exp(low))

-- The error of the end's reach falls with the square of the elements' length; triangles begin with twice that
-- of quadrilaterals. No direction of the directors across the strip is left, and their guard stores nothing.
local checks = {}
for _, shape in ipairs { { triangles = false, coarse = 0.01, guard = 1e-4 }, { triangles = true, coarse = 0.02, guard = 2e-4 } } do
  for _, cells in ipairs { 30, 60 } do
    local mesh = fabric.mesh.rectangle { width = length, height = width, nx = cells, ny = 1, triangles = shape.triangles }
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }
    m:fix("left", "x y z rotation"):gravity { 0, 0, fabric.ramp(-9.81, 1) }
    local a = fabric.static { model = m, duration = 1, step = 0.1, method = "relaxation" }
    a:solve()
    local p = a:node(mesh:set "right"[1])
    local across = 0
    for _, d in ipairs(a:field "director") do across = math.max(across, math.abs(d[2])) end
    local name = ("%d %s: "):format(cells, shape.triangles and "cells of two triangles" or "quadrilaterals")
    local within = shape.coarse * (30 / cells) ^ 2
    checks[#checks + 1] = { name .. "reach of the end", p.x, reach, relative = within }
    checks[#checks + 1] = { name .. "drop of the end", -p.z, drop, relative = within / 5 }
    checks[#checks + 1] = { name .. "directors across", across, 0, absolute = 0.02 }
    checks[#checks + 1] = { name .. "guard of the directors", a.energy.directors, 0, absolute = shape.guard * a.energy.stored }
  end
end
fabric.expect(checks)
