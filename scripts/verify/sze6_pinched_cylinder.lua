-- Cylinder on rigid diaphragms, pinched by two forces at half its length: problem 6 of [sze2004] (see problem.lua): R = 100,
-- L = 200, h = 1, E = 30e3, nu = 0.3, P = 12000; an eighth with three symmetry planes, so 3000. Published values: 48 x 48
-- elements of the eighth (S4R), -A the way of the force, B the way of the side, outwards. The shell snaps near P/Pmax =
-- 0.15, so that A is moved to the published places, a few more between them, and the force read.
--
--   fabricsh scripts/verify/sze6_pinched_cylinder.lua [n ...]      n x n elements of the eighth, usually 16
local fabric = require "fabric"
local problem = dofile((arg[0]:gsub("[^/]*$", "problem.lua")))

-- P/Pmax, -A, B
local published = {
  { 0.05, 9.561, -0.233 }, { 0.075, 15.648, -0.922 }, { 0.10, 23.164, -2.391 }, { 0.125, 29.375, -3.872 },
  { 0.15, 36.208, -2.154 }, { 0.175, 51.499, 6.792 }, { 0.20, 56.373, 10.448 }, { 0.25, 61.877, 14.905 },
  { 0.30, 65.498, 17.979 }, { 0.35, 68.229, 20.365 }, { 0.40, 70.424, 22.321 }, { 0.45, 72.204, 23.916 },
  { 0.50, 73.790, 25.381 }, { 0.55, 75.139, 26.631 }, { 0.60, 76.331, 27.735 }, { 0.65, 77.472, 28.843 },
  { 0.70, 78.451, 29.772 }, { 0.75, 79.339, 30.604 }, { 0.80, 80.218, 31.471 }, { 0.85, 81.045, 32.299 },
  { 0.90, 81.766, 32.989 }, { 0.95, 82.435, 33.619 }, { 1.00, 83.102, 34.272 },
}
local before = 5 -- rows up to the snap

local function pinch(n)
  local started, R = os.clock(), 100
  local mesh = fabric.mesh.cylinder { radius = R, length = 100, around = n, along = n, angle = 90 }
  local m = fabric.model { mesh = mesh, card = problem.plate(30e3, 0.3, 1), warp = { 0, 0, 1 } }
  m:symmetry("start", "y"):symmetry("end", "x"):symmetry("bottom", "z"):fix("top", "x y")
  local B = problem.node(mesh, R, 0, 0)
  mesh:set("A", { problem.node(mesh, 0, R, 0) })
  m:move("A", { y = function(t) return -t end })
  local a = fabric.static { model = m, duration = 90, step = 2, max_iterations = 40 }
  local function load()
    local _, y = a:reaction "A"
    return -y / 3000
  end
  print(("%d x %d elements of the eighth"):format(n, n))
  print("      -A   P/Pmax  published       B  published")
  local worst, side, all = 0, 0, 0
  for i, row in ipairs(published) do
    a:advance(row[2])
    local p, b = load(), a:node(B).ux
    if i <= before then
      worst, side = math.max(worst, math.abs(p - row[1])), math.max(side, math.abs(b - row[3]))
    end
    all = math.max(all, math.abs(p - row[1]))
    print(("  %7.3f  %7.4f  %7.3f   %8.3f  %8.3f"):format(row[2], p, row[1], b, row[3]))
  end
  -- On to the published end of the load.
  while load() < 1 and a.time < 88 do a:advance(a.time + 0.2) end
  local p1 = load()
  a:event { value = function() return load() - 1 end, tolerance = 1e-6, stop = true }
  local steps, iterations, cuts = problem.work(a)
  print(("  up to the snap: P/Pmax within %.4f, B within %.4f; all rows: P/Pmax within %.4f; P/Pmax %.4f at -A = %.3f, B = %.3f; %d steps %d iterations %d cuts %.1f s"):format(
    worst, side, all, p1, a.time, a:node(B).ux, steps, iterations, cuts, os.clock() - started))
  return worst, side, a.time, a:node(B).ux
end

local worst, side, A, B
for _, n in ipairs(problem.sizes { 16 }) do worst, side, A, B = pinch(n) end
