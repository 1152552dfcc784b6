-- Hinged cylindrical roof under a central force, thick and thin: problem 8 of [sze2004] (see problem.lua): R = 2540,
-- 508 long, opening 2 x 0.1 rad, h = 12.7 and 6.35, E = 3102.75, nu = 0.3, P = 3000; straight edges hinged, curved
-- edges free; a quarter with two symmetry planes, so 750. Published values: 16 x 16 elements of the quarter (S4R).
-- The thick roof snaps through: its centre is moved to the published places. The thin one also snaps back: it is
-- followed along the arc, and the published points are looked up on the path by their distance to it.
--
--   fabricsh scripts/verify/sze8_roof.lua [n ...]      n x n elements in the quarter, usually 8 16
local fabric = require "fabric"
local problem = dofile((arg[0]:gsub("[^/]*$", "problem.lua")))

-- P/Pmax, deflection of the centre
local thick = {
  { 0.0877, 0.693 }, { 0.1980, 1.638 }, { 0.3473, 3.087 }, { 0.4686, 4.477 }, { 0.5647, 5.802 }, { 0.6381, 7.057 },
  { 0.6908, 8.237 }, { 0.7246, 9.339 }, { 0.7412, 10.358 }, { 0.7421, 11.293 }, { 0.7286, 12.141 }, { 0.7023, 12.903 },
  { 0.6649, 13.583 }, { 0.6182, 14.188 }, { 0.5643, 14.728 }, { 0.5055, 15.217 }, { 0.4442, 15.676 }, { 0.3830, 16.125 },
  { 0.3245, 16.590 }, { 0.2717, 17.094 }, { 0.2272, 17.657 }, { 0.1940, 18.299 }, { 0.1750, 19.028 }, { 0.1729, 19.852 },
  { 0.1905, 20.771 }, { 0.2303, 21.780 }, { 0.2950, 22.875 }, { 0.3871, 24.049 }, { 0.4443, 24.663 }, { 0.5093, 25.293 },
  { 0.5826, 25.940 }, { 0.6644, 26.601 }, { 0.7551, 27.276 }, { 0.8549, 27.964 }, { 0.9643, 28.663 }, { 1.0835, 29.374 },
}
local thin = {
  { 0.0517, 1.846 }, { 0.1182, 5.271 }, { 0.1583, 8.257 }, { 0.1837, 10.799 }, { 0.1914, 11.904 }, { 0.1953, 12.892 },
  { 0.1950, 13.752 }, { 0.1901, 14.472 }, { 0.1806, 15.050 }, { 0.1671, 15.501 }, { 0.1323, 16.145 }, { 0.0923, 16.602 },
  { 0.0504, 16.915 }, { 0.0083, 17.008 }, { -0.0312, 16.697 }, { -0.0622, 15.780 }, { -0.0739, 15.206 },
  { -0.0861, 14.767 }, { -0.1001, 14.520 }, { -0.1142, 14.451 }, { -0.1247, 14.862 }, { -0.1288, 15.778 },
  { -0.1271, 16.961 }, { -0.1196, 18.320 }, { -0.1055, 19.817 }, { -0.0825, 21.420 }, { -0.0484, 23.100 },
  { -0.0006, 24.824 }, { 0.0626, 26.565 }, { 0.1427, 28.302 }, { 0.2403, 30.023 }, { 0.3559, 31.720 }, { 0.4898, 33.388 },
  { 0.6417, 35.024 }, { 0.8114, 36.626 }, { 1.0313, 38.450 },
}

-- A quarter of the roof; the node at its centre.
local function roof(n, h)
  local R = 2540
  local mesh = fabric.mesh.cylinder { radius = R, length = 254, around = n, along = n, angle = math.deg(0.1) }
  local m = fabric.model { mesh = mesh, card = problem.plate(3102.75, 0.3, h), warp = { 0, 0, 1 } }
  m:symmetry("start", "y"):fix("end", "x y z"):symmetry("bottom", "z")
  local centre = problem.node(mesh, R, 0, 0)
  mesh:set("centre", { centre })
  return m, centre
end

local function snap_through(n)
  local m = roof(n, 12.7)
  m:move("centre", { x = function(t) return -t end })
  local a = fabric.static { model = m, duration = 29.374, step = 1 }
  local worst, top = 0, 0
  for _, row in ipairs(thick) do
    a:advance(row[2])
    local load = -a:reaction "centre" / 750
    worst, top = math.max(worst, math.abs(load - row[1])), math.max(top, a.time < 15 and load or 0)
  end
  local steps, iterations = problem.work(a)
  local final = -a:reaction "centre" / 750
  print(("  h = 12.7, %2d x %-2d  P/Pmax at 29.374: %.4f (1.0835, %+.2f %%), worst row %.4f, top %.4f (0.7421), %d steps %d iterations"):format(
    n, n, final, 100 * (final / 1.0835 - 1), worst, top, steps, iterations))
  -- The path is steep at its end: the same difference as a deflection, by the slope of the published rows.
  local slope = (thick[#thick][1] - thick[#thick - 1][1]) / (thick[#thick][2] - thick[#thick - 1][2])
  return 29.374 - (final - thick[#thick][1]) / slope, worst
end

-- Distance of a point from the polygon through the path, both scaled to 1.
local function distance(path, p, w)
  local best = math.huge
  for i = 2, #path do
    local ax, ay, bx, by = path[i - 1][1], path[i - 1][2] / 38.45, path[i][1], path[i][2] / 38.45
    local dx, dy, px, py = bx - ax, by - ay, p - ax, w / 38.45 - ay
    local s = math.min(1, math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy)))
    best = math.min(best, math.sqrt((px - s * dx) ^ 2 + (py - s * dy) ^ 2))
  end
  return best
end

local function snap_back(n)
  local m, centre = roof(n, 6.35)
  -- The force falls below zero on the way: time 0 is a force of -0.2 P.
  m:force("centre", { x = fabric.history { { 0, 0.2 * 750 }, { 1.25, -1.05 * 750 } } })
  local a = fabric.static { model = m, duration = 1.25, step = 0.02, control = "arc" }
  local path = {}
  a:every("step", function(run) path[#path + 1] = { run.time - 0.2, -run:node(centre).ux } end)
  a:solve()
  local worst = 0
  for _, row in ipairs(thin) do worst = math.max(worst, distance(path, row[1], row[2])) end
  local steps, iterations, cuts = problem.work(a)
  print(("  h = 6.35, %2d x %-2d  largest distance of a published point from the path %.4f of the plot, %d steps %d iterations %d cuts"):format(
    n, n, worst, steps, iterations, cuts))
  return worst
end

local final, worst, off
print "Hinged roofs"
for _, n in ipairs(problem.sizes { 8, 16 }) do
  final, worst = snap_through(n)
  off = snap_back(n)
end
fabric.expect {
  { "thick: deflection at the last published force", final, 29.374, relative = 0.01 },
  { "thick: largest difference of P/Pmax", worst, 0, absolute = 0.015 },
  { "thin: largest distance from the path", off, 0, absolute = 0.01 },
}
