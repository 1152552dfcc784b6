-- Shared by the decks of this folder: following a table of published values, counting the solver's work, comparing
-- meshes. A deck says local problem = dofile(...) "problem.lua"; run by itself this file does nothing.
--
-- Tables of [sze2004]: K.Y. Sze, X.H. Liu, S.H. Lo, Popular benchmark problems for geometric nonlinear analysis of
-- shells, Finite Elements in Analysis and Design 40 (2004) 1551-1569, doi:10.1016/j.finel.2003.11.001, as copied in
-- MBDyn, tests/plates/sze2004/*_ref.dat (P. Masarati); the hemisphere's as copied in the test of Elmer's shell solver.
local fabric = require "fabric"
local problem = {}

-- The card of an isotropic plate in the units of a paper; mass plays no part unless it is given.
function problem.plate(young, poisson, thickness, more)
  local fields = { name = "plate", young = young, poisson = poisson, density = 1000, thickness = thickness }
  for key, value in pairs(more or {}) do fields[key] = value end
  return fabric.svk(fields)
end

-- Mesh sizes from the command line, or the usual ones.
function problem.sizes(usual)
  if #arg == 0 then return usual end
  local sizes = {}
  for i, word in ipairs(arg) do sizes[i] = math.tointeger(tonumber(word)) or error("expected mesh sizes, got " .. word, 0) end
  return sizes
end

-- The mesh with each quadrilateral cut in two: along one diagonal ("one way") or along both in turn ("both ways").
function problem.cut(mesh, how)
  if how == "whole" then return mesh end
  local nodes, elements = {}, {}
  for i = 1, #mesh.nodes do nodes[i] = mesh.nodes[i] end
  for i = 1, #mesh.elements do
    local a, b, c, d = table.unpack(mesh.elements[i])
    local first = how == "one way" or i % 2 == 0
    elements[#elements + 1] = first and { a, b, c } or { a, b, d }
    elements[#elements + 1] = first and { a, c, d } or { b, c, d }
  end
  local cut = fabric.mesh.of { nodes = nodes, elements = elements }
  for _, name in ipairs(mesh.sets) do cut:set(name, mesh:set(name)) end
  return cut
end

-- Number of the node nearest to a point.
function problem.node(mesh, x, y, z)
  local best, found = math.huge, nil
  for i = 1, #mesh.nodes do
    local p = mesh.nodes[i]
    local d = (p[1] - x) ^ 2 + (p[2] - y) ^ 2 + (p[3] - z) ^ 2
    if d < best then best, found = d, i end
  end
  return found
end

-- Steps, iterations (those of abandoned steps count) and cuts of a run.
function problem.work(a)
  local iterations, cuts = 0, 0
  for _, step in ipairs(a.steps) do
    iterations, cuts = iterations + step.iterations, cuts + step.cuts
  end
  return #a.steps, iterations, cuts
end

-- Runs `make(mesh size)`, which returns an analysis and a function that reads the numbers to compare, to the end;
-- prints a row and returns the numbers. The time is that of the processor, all threads.
function problem.solve(label, make, want, ...)
  local started = os.clock()
  local a, read = make(...)
  a:solve()
  local seconds, got, text = os.clock() - started, { read(a) }, ""
  local worst = 0
  for i, value in ipairs(got) do
    local miss = value / want[i] - 1
    worst = math.max(worst, math.abs(miss))
    text = text .. (" %10.4f %+7.2f %%"):format(value, 100 * miss)
  end
  local steps, iterations, cuts = problem.work(a)
  print(("  %-14s%s  %4d steps %4d iterations %3d cuts %7.2f s"):format(label, text, steps, iterations, cuts, seconds))
  return { got = got, worst = worst, steps = steps, iterations = iterations, seconds = seconds, a = a }
end

-- Follows the rows { {load fraction, values...}, ... } of a published table; prints them beside ours; returns the
-- largest difference, as a fraction of the largest tabulated value of its column.
function problem.follow(a, read, rows, names)
  local largest, worst = {}, 0
  for _, row in ipairs(rows) do
    for i = 2, #row do largest[i] = math.max(largest[i] or 0, math.abs(row[i])) end
  end
  local head = ("  %7s"):format "P/Pmax"
  for _, name in ipairs(names) do head = head .. (" %9s %9s %7s"):format(name, "published", "diff %") end
  print(head)
  for _, row in ipairs(rows) do
    a:advance(row[1] * a.duration)
    local got, line = { read(a) }, ("  %7.3f"):format(row[1])
    for i = 2, #row do
      local miss = (got[i - 1] - row[i]) / largest[i]
      worst = math.max(worst, math.abs(miss))
      line = line .. (" %9.3f %9.3f %+7.2f"):format(got[i - 1], row[i], 100 * miss)
    end
    print(line)
  end
  return worst
end

-- Distance of a point from the polygon through the path { {x, y}, ... }, y measured in `scale`.
function problem.distance(path, x, y, scale)
  local best = math.huge
  for i = 2, #path do
    local ax, ay, bx, by = path[i - 1][1], path[i - 1][2] / scale, path[i][1], path[i][2] / scale
    local dx, dy, px, py = bx - ax, by - ay, x - ax, y / scale - ay
    local s = math.min(1, math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy)))
    best = math.min(best, math.sqrt((px - s * dx) ^ 2 + (py - s * dy) ^ 2))
  end
  return best
end

-- Three plies of a third of the thickness of a fibre-reinforced card, their fibres at the angles given from the model's
-- warp; transversely isotropic about the fibre.
function problem.laminate(fibre, across, shear, poisson, thickness, angles)
  local card = fabric.svk { name = "ply", warp = fibre, weft = across, shear = shear, density = 1000,
    thickness = thickness / 3, poisson = { poisson, poisson * across / fibre },
    transverse = { shear, across / (2 * (1 + poisson)) } }
  local layers = {}
  for i, angle in ipairs(angles) do layers[i] = { card = card, warp = angle, thickness = thickness / 3 } end
  return layers
end

return problem
