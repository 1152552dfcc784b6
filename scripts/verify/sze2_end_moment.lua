-- Cantilever rolled up by an end moment, problem 2 of [sze2004] (see problem.lua): L = 12, b = 1, h = 0.1, E = 1.2e6,
-- nu = 0, M = 50 pi / 3: a full circle. The exact solution is the circle of curvature M / EI. Then the same strip with
-- its end turned by 360 degrees in place of the moment.
--
--   fabricsh scripts/verify/sze2_end_moment.lua
-- warns: is far from what cloth is
-- warns: is far from what cloth is
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local problem = dofile((arg[0]:gsub("[^/]*$", "problem.lua")))
local L, M = 12, 50 * math.pi / 3

local published = {
  { 0.05, 0.196, 1.870 }, { 0.10, 0.773, 3.648 }, { 0.15, 1.698, 5.249 }, { 0.20, 2.916, 6.600 },
  { 0.25, 4.357, 7.643 }, { 0.30, 5.942, 8.338 }, { 0.35, 7.582, 8.671 }, { 0.40, 9.191, 8.646 },
  { 0.45, 10.687, 8.291 }, { 0.50, 12.000, 7.652 }, { 0.55, 13.075, 6.788 }, { 0.60, 13.875, 5.772 },
  { 0.65, 14.384, 4.678 }, { 0.70, 14.603, 3.583 }, { 0.75, 14.556, 2.556 }, { 0.80, 14.280, 1.656 },
  { 0.85, 13.826, 0.931 }, { 0.90, 13.254, 0.407 }, { 0.95, 12.625, 0.099 }, { 1.00, 12.000, 0.000 },
}

local function strip(n)
  local mesh = fabric.mesh.rectangle { width = L, height = 1, nx = n, ny = 1 }
  return fabric.model { mesh = mesh, card = problem.plate(1.2e6, 0, 0.1) }:fix("left", "x y z rotation"), n + 1
end

local function make(n, step, moment)
  local m, tip = strip(n)
  m:moment("right", { y = fabric.ramp(-(moment or M), 1) })
  return fabric.static { model = m, duration = 1, step = step or 0.05 },
    function(a) return -a:node(tip).ux, a:node(tip).uz end
end

local a, read = make(64, 0.05)
print "Cantilever, end moment: -U and W of the tip, 64 x 1 elements"
local worst = problem.follow(a, read, published, { "-U", "W" })

-- A strip of finite thickness whose stress is linear in Green-Lagrange strain is softer in bending: with no force along
-- it, M = EI k (1 - 0.3 k^2 h^2) exactly. Under that moment at k = 2 pi / L the circle closes but for the elements.
local k, h = 2 * math.pi / L, 0.1
local closing = M * (1 - 0.3 * k ^ 2 * h ^ 2)
print "\nFull circle by the moment that closes it: distance of the tip from the root / L"
local gap = {}
for _, n in ipairs { 16, 32, 64, 128 } do
  local run = make(n, 0.05, closing):solve()
  local p = run:node(n + 1)
  gap[n] = math.sqrt(p.x ^ 2 + p.z ^ 2) / L
  local steps, iterations = problem.work(run)
  print(("  %4d elements %10.2e   angle of the end %9.4f deg  %3d steps %4d iterations"):format(
    n, gap[n], 360 + math.deg(math.atan(-p.nx, p.nz)), steps, iterations))
end

local m, tip = strip(32)
m:turn("right", { axis = { 0, 1, 0 }, angle = fabric.ramp(-360, 1) })
local turned = fabric.static { model = m, duration = 1, step = 0.05 }:solve()
local p = turned:node(tip)
local closes = math.sqrt(p.x ^ 2 + p.z ^ 2) / L
local steps, iterations = problem.work(turned)
print(("Full circle by turning the end, 32 elements: gap / L %.2e, %d steps, %d iterations"):format(closes, steps, iterations))

fabric.expect {
  { "largest difference in the table on 64 elements", worst, 0, absolute = 0.01 },
  { "turned by 360 degrees: gap / L, 32 elements", closes, 0, absolute = 1e-4 },
  { "moment: gap / L, 32 elements", gap[32], 0, absolute = 1e-4 },
  -- Directors' differences are lengthened to their arcs to three terms: the fourth is of sixth order.
  { "order of the gap, 16 to 64 elements", math.log(gap[16] / gap[64], 4), 6, absolute = 0.1 },
}
