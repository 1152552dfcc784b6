-- Cantilever under an end shear force, problem 1 of [sze2004] (see problem.lua): L = 10, b = 1, h = 0.1, E = 1.2e6,
-- nu = 0, P = 4. Published values: 16 x 1 elements (S4R).
--
--   fabricsh scripts/verify/sze1_end_shear.lua
-- warns: is far from what cloth is
-- warns: is far from what cloth is
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local problem = dofile((arg[0]:gsub("[^/]*$", "problem.lua")))

local published = {
  { 0.05, 0.026, 0.663 }, { 0.10, 0.103, 1.309 }, { 0.15, 0.224, 1.922 }, { 0.20, 0.381, 2.493 },
  { 0.25, 0.563, 3.015 }, { 0.30, 0.763, 3.488 }, { 0.35, 0.971, 3.912 }, { 0.40, 1.184, 4.292 },
  { 0.45, 1.396, 4.631 }, { 0.50, 1.604, 4.933 }, { 0.55, 1.807, 5.202 }, { 0.60, 2.002, 5.444 },
  { 0.65, 2.190, 5.660 }, { 0.70, 2.370, 5.855 }, { 0.75, 2.541, 6.031 }, { 0.80, 2.705, 6.190 },
  { 0.85, 2.861, 6.335 }, { 0.90, 3.010, 6.467 }, { 0.95, 3.151, 6.588 }, { 1.00, 3.286, 6.698 },
}

local function make(n, step)
  local mesh = fabric.mesh.rectangle { width = 10, height = 1, nx = n, ny = 1 }
  local m = fabric.model { mesh = mesh, card = problem.plate(1.2e6, 0, 0.1) }
  m:fix("left", "x y z rotation"):force("right", { z = fabric.ramp(4, 1) })
  local tip = n + 1
  return fabric.static { model = m, duration = 1, step = step }, function(a) return -a:node(tip).ux, a:node(tip).uz end
end

local a, read = make(16, 0.05)
print "Cantilever, end shear: -U and W of the tip, 16 x 1 elements"
local worst = problem.follow(a, read, published, { "-U", "W" })
print "\nRefinement, steps chosen by the solver, half the load at most; 3.286, 6.698 [sze2004]"
local final
for _, n in ipairs { 8, 16, 32, 64 } do final = problem.solve(n .. " x 1", make, { 3.286, 6.698 }, n, 0.5) end
fabric.expect {
  -- A straight-sided element of angle a bends by sin(a) / a of its curvature: 0.2 % on 16 elements.
  { "largest difference in the table, of the final value", worst, 0, absolute = 0.01 },
  { "-U on 64 elements", final.got[1], 3.286, relative = 0.002 },
  { "W on 64 elements", final.got[2], 6.698, relative = 0.001 },
}
