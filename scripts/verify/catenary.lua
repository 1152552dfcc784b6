-- A strip hung from its two short edges, longer than the span: against the extensible catenary of the same law. With
-- the horizontal force H and the weight w per length of the unstretched strip, the force along it is
-- T = (H^2 + w^2 (s - L/2)^2)^(1/2), and T / b = E t lambda (lambda^2 - 1) / 2 (stress linear in Green-Lagrange
-- strain); H follows from the span, found here by bisection and Simpson's rule. Bending is next to nothing.
--
--   fabricsh scripts/verify/catenary.lua
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local L, span, width, thickness = 1.0, 0.9, 0.05, 0.4e-3
local areal, g, young = 0.2, 9.81, 2e5 -- soft, so that it stretches by about a per cent and a half
local w, stiffness = areal * g * width, young * thickness * width

-- Stretch under the force T: lambda (lambda^2 - 1) / 2 = T / (E t b), by Newton.
local function stretch(T)
  local x = 1 + T / stiffness
  for _ = 1, 30 do x = x - (x * (x * x - 1) / 2 - T / stiffness) / ((3 * x * x - 1) / 2) end
  return x
end

-- Span and sag of the half s = 0 .. L/2 from the lowest point.
local function hang(H)
  local n, x, y = 2000, 0, 0
  for i = 0, n do
    local s = L / 2 * i / n
    local T = math.sqrt(H * H + (w * s) ^ 2)
    local weight = (i == 0 or i == n) and 1 or (i % 2 == 1 and 4 or 2)
    x, y = x + weight * stretch(T) * H / T, y + weight * stretch(T) * w * s / T
  end
  return 2 * x * L / 2 / n / 3, y * L / 2 / n / 3
end
local low, high = 1e-4 * w, 100 * w
for _ = 1, 200 do
  local middle = (low + high) / 2
  if hang(middle) < span then low = middle else high = middle end
end
local H = low
local _, sag = hang(H)
local T = math.sqrt(H ^ 2 + (w * L / 2) ^ 2)
print(("catenary: H %.8f N, sag %.8f m, stretch %.5f to %.5f"):format(H, sag, stretch(H), stretch(T)))

-- The strip is born flat, stretched a little, loaded, and its right end is moved in to the span: taut all the way.
local function strip(n)
  local mesh = fabric.mesh.rectangle { width = L, height = width, nx = n, ny = 1 }
  local card = fabric.svk { name = "strip", young = young, poisson = 0, density = areal / thickness, thickness = thickness,
    bending = { warp = 1e-9, weft = 1e-9, twist = 1e-9 } }
  local m = fabric.model { mesh = mesh, card = card }
  m:fix("left", "x z"):fix("right", "z"):fix("all", "y rx rz")
  m:move("right", { x = fabric.history { { 0, 0 }, { 0.1, 0.02 }, { 0.3, 0.02 }, { 1, span - L } } })
  m:traction("all", { z = fabric.history { { 0, 0 }, { 0.1, 0 }, { 0.3, -areal * g } } })
  local run = fabric.static { model = m, duration = 1, step = 0.05 }:solve()
  local pull = -run:reaction "left"
  local iterations = 0
  for _, step in ipairs(run.steps) do iterations = iterations + step.iterations end
  return pull, -run:node(n // 2 + 1).z, #run.steps, iterations
end

print "  elements            H, N    error          sag, m    error  steps  iterations"
local last
for _, n in ipairs { 20, 40, 80, 160 } do
  local h, s, steps, iterations = strip(n)
  last = { h, s }
  print(("  %8d %15.8f %8.1e %15.8f %8.1e %6d %11d"):format(n, h, h / H - 1, s, s / sag - 1, steps, iterations))
end
if fabric.checking() then return end
fabric.expect {
  { "horizontal force, 160 elements", last[1], H, relative = 1e-4 },
  { "sag, 160 elements", last[2], sag, relative = 1e-4 },
}
