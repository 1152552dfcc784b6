-- Slit annular plate lifted by a line force along one face of the slit, the other clamped: problem 3 of [sze2004] (see
-- problem.lua): radii 6 and 10, h = 0.03, E = 21e6, nu = 0, 0.8 per length. Published values: 10 x 80 elements (S4R);
-- A and B are the ends of the lifted face on the inner and the outer circle.
--
--   fabricsh scripts/verify/sze3_slit_annulus.lua [k ...]      4 k x 30 k elements, usually k = 1; the table on the last
-- warns: is far from what cloth is
-- warns: is far from what cloth is
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local problem = dofile((arg[0]:gsub("[^/]*$", "problem.lua")))

local published = {
  { 0.025, 1.305, 1.789 }, { 0.05, 2.455, 3.370 }, { 0.075, 3.435, 4.720 }, { 0.10, 4.277, 5.876 },
  { 0.125, 5.007, 6.872 }, { 0.15, 5.649, 7.736 }, { 0.20, 6.725, 9.160 }, { 0.25, 7.602, 10.288 },
  { 0.30, 8.340, 11.213 }, { 0.35, 8.974, 11.992 }, { 0.40, 9.529, 12.661 }, { 0.45, 10.023, 13.247 },
  { 0.50, 10.468, 13.768 }, { 0.55, 10.876, 14.240 }, { 0.60, 11.257, 14.674 }, { 0.65, 11.620, 15.081 },
  { 0.70, 11.970, 15.469 }, { 0.75, 12.310, 15.842 }, { 0.80, 12.642, 16.202 }, { 0.85, 12.966, 16.550 },
  { 0.90, 13.282, 16.886 }, { 0.95, 13.590, 17.212 }, { 1.00, 13.891, 17.528 },
}

local function make(across, around, step)
  local mesh = fabric.mesh.annulus { inner = 6, outer = 10, around = around, across = across, slit = true }
  local m = fabric.model { mesh = mesh, card = problem.plate(21e6, 0, 0.03) }
  m:fix("start", "x y z rotation"):traction("end", { z = fabric.ramp(0.8, 1) })
  local edge = mesh:set "end"
  local A, B = edge[1], edge[#edge]
  return fabric.static { model = m, duration = 1, step = step }, function(a) return a:node(A).uz, a:node(B).uz end
end

local sizes = problem.sizes { 1 }
local finest = sizes[#sizes]
local a, read = make(4 * finest, 30 * finest, 0.1)
print(("Slit annular plate: deflections at A and B, %d x %d elements"):format(4 * finest, 30 * finest))
local worst = problem.follow(a, read, published, { "A", "B" })
print "\nRefinement, steps chosen by the solver; 13.891, 17.528 [sze2004]"
local last
for _, k in ipairs(sizes) do
  last = problem.solve(("%d x %d"):format(4 * k, 30 * k), make, { 13.891, 17.528 }, 4 * k, 30 * k, 0.25)
end
-- 1 % takes 12 x 90 elements: in-plane bending of the ring's trapezoids.
local allowed = ({ 0.035, 0.015 })[finest] or 0.01
fabric.expect {
  { "largest difference in the table, of the final value", worst, 0, absolute = allowed },
  { "A on the finest mesh", last.got[1], 13.891, relative = allowed },
  { "B on the finest mesh", last.got[2], 17.528, relative = allowed },
}
