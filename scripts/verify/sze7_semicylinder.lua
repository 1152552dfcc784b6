-- Half cylinder clamped at one end, pressed at the top of the other: problem 7 of [sze2004] (see problem.lua):
-- R = 101.6, L = 304.8, h = 3, E = 2068.5, nu = 0.3, P = 2000; along the straight edges the vertical displacement and
-- the rotation about the edge are held, as a plane of symmetry does; one half with a symmetry plane, so 1000. Published: deflection under the force.
--
--   fabricsh scripts/verify/sze7_semicylinder.lua [n ...]      n x n elements in the half, usually 16; the table on the last
local fabric = require "fabric"
local problem = dofile((arg[0]:gsub("[^/]*$", "problem.lua")))

local published = {
  { 0.05, 5.421 }, { 0.10, 16.100 }, { 0.125, 22.195 }, { 0.15, 27.657 }, { 0.175, 32.700 }, { 0.20, 37.582 },
  { 0.225, 42.633 }, { 0.25, 48.537 }, { 0.275, 56.355 }, { 0.30, 66.410 }, { 0.325, 79.810 }, { 0.35, 94.669 },
  { 0.40, 113.704 }, { 0.45, 124.751 }, { 0.50, 132.653 }, { 0.55, 138.920 }, { 0.60, 144.185 }, { 0.65, 148.770 },
  { 0.70, 152.863 }, { 0.75, 156.584 }, { 0.80, 160.015 }, { 0.85, 163.211 }, { 0.90, 166.200 }, { 0.95, 168.973 },
  { 1.00, 171.505 },
}

local function make(n, step)
  local R, L = 101.6, 304.8
  local mesh = fabric.mesh.cylinder { radius = R, length = L, around = n, along = n, angle = 90 }
  local m = fabric.model { mesh = mesh, card = problem.plate(2068.5, 0.3, 3), warp = { 0, 0, 1 } }
  m:symmetry("start", "y"):symmetry("end", "x"):fix("bottom", "x y z rotation")
  local A = problem.node(mesh, 0, R, L)
  mesh:set("A", { A })
  m:force("A", { y = fabric.ramp(-1000, 1) })
  return fabric.static { model = m, duration = 1, step = step }, function(a) return -a:node(A).uy end
end

local sizes = problem.sizes { 16 }
local finest = sizes[#sizes]
local a, read = make(finest, 0.05)
print(("Half cylinder: deflection under the force, %d x %d elements"):format(finest, finest))
local worst = problem.follow(a, read, published, { "-A" })
print "\nRefinement, steps chosen by the solver; 171.505 [sze2004]"
local last
for _, n in ipairs(sizes) do last = problem.solve(n .. " x " .. n, make, { 171.505 }, n, 0.1) end
local fine = finest >= 24
fabric.expect {
  -- Steepest near P/Pmax = 0.325, where a small shift of the load shows most.
  { "largest difference in the table, of the final value", worst, 0, absolute = fine and 0.02 or 0.06 },
  { "-A on the finest mesh", last.got[1], 171.505, relative = fine and 0.01 or 0.02 },
}
