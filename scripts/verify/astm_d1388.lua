-- A strip that overhangs an edge and bends under its own weight (ASTM D1388, cantilever): the bending length
-- c = (B / w)^(1/3), B the rigidity and w the weight, per width. Strips of length 2 c, whose chord hangs at about 41.5
-- degrees, and of 3 c, with c of 10, 20 and 40 mm, against the elastica B theta'' = -w (l - s) cos theta, theta(0) = 0,
-- theta'(l) = 0, found here by shooting.
--
--   fabricsh scripts/verify/astm_d1388.lua
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local mm = fabric.units.mm
local g, areal = 9.81, 0.2 -- m/s^2, kg/m^2
local thickness = 0.4 * mm

-- Fourth-order Runge-Kutta in 2000 steps for the curvature k0 at the edge; lengths in c. Returns the end's curvature, x,
-- y and angle.
local function hang(l, k0)
  local h, angle, k, x, y = l / 2000, 0, k0, 0, 0
  local function rate(s, a, b) return b, -(l - s) * math.cos(a), math.cos(a), -math.sin(a) end
  for i = 0, 1999 do
    local s = i * h
    local a1, b1, x1, y1 = rate(s, angle, k)
    local a2, b2, x2, y2 = rate(s + h / 2, angle + h / 2 * a1, k + h / 2 * b1)
    local a3, b3, x3, y3 = rate(s + h / 2, angle + h / 2 * a2, k + h / 2 * b2)
    local a4, b4, x4, y4 = rate(s + h, angle + h * a3, k + h * b3)
    angle, k = angle + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), k + h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)
    x, y = x + h / 6 * (x1 + 2 * x2 + 2 * x3 + x4), y + h / 6 * (y1 + 2 * y2 + 2 * y3 + y4)
  end
  return k, x, y, angle
end

-- The elastica of length l (in c): tip and the residual curvature there.
local function elastica(l)
  local low, high = 0, l * l
  for _ = 1, 80 do
    local middle = (low + high) / 2
    if hang(l, middle) > 0 then high = middle else low = middle end
  end
  local k, x, y = hang(l, low)
  return x, y, math.abs(k)
end

local function strip(c, l, n)
  local B = areal * g * c ^ 3
  local card = fabric.svk { name = "strip", young = 50e6, poisson = 0, density = areal / thickness, thickness = thickness,
    bending = { warp = B, weft = B, twist = B } }
  local mesh = fabric.mesh.rectangle { width = l * c, height = 25 * mm, nx = n, ny = 1 }
  local m = fabric.model { mesh = mesh, card = card }
  m:fix("left", "x y z rotation")
  -- Gravity is there from the start; the longer strip gets its weight as a load that grows.
  if l > 2 then m:traction("all", { z = fabric.ramp(-areal * g, 1) }) else m:gravity { 0, 0, -g } end
  local a = fabric.static { model = m, duration = 1, step = l > 2 and 0.2 or 1 }:solve()
  local tip, iterations = a:node(n + 1), 0
  for _, step in ipairs(a.steps) do iterations = iterations + step.iterations end
  return tip.x / c, tip.z / c, #a.steps, iterations
end

local checks = {}
print "       c mm   l / c  elements        x / c  (elastica)        y / c  (elastica)      error / l  steps  iterations"
for _, l in ipairs { 2, 3 } do
  local X, Y, residual = elastica(l)
  checks[#checks + 1] = { ("elastica of %d c: curvature left at the tip"):format(l), residual, 0, absolute = 1e-8 }
  for _, c in ipairs { 10, 20, 40 } do
    local miss
    for _, n in ipairs { 10, 20, 40 } do
      local x, y, steps, iterations = strip(c * mm, l, n)
      miss = math.sqrt((x - X) ^ 2 + (y - Y) ^ 2) / l
      print(("  %9g %7g %9d %12.7f %11.7f %12.7f %11.7f %14.2e %6d %11d"):format(c, l, n, x, X, y, Y, miss, steps, iterations))
    end
    checks[#checks + 1] = { ("tip, c = %d mm, l = %d c, 40 elements: error / l"):format(c, l), miss, 0, absolute = 1e-3 }
  end
  print(("  chord of %d c hangs at %.3f degrees"):format(l, math.deg(math.atan(-Y, X))))
end
if fabric.checking() then return end
fabric.expect(checks)
