-- Pressed cloth, in statics by the default method and from flat or round, against closed forms without friction:
--
--   fabricsh scripts/contact/press.lua             a fold and a tube between two plates, a ball on a flat disc
--   fabricsh scripts/contact/press.lua explicit    the same in slow explicit motion, and what time that takes; likewise implicit, relaxation
--
-- A fold of a strip with the bending rigidity B between plates at the distance D (of midsurfaces) pushes with F = 2.8711 B / D^2 per width; its
-- greatest curvature is 2.3963 / D. The strip stands flat between the plates at first.
--
-- A tube of the radius R is a ring, with B (theta'' ) = (F/2) cos(theta) along its quarters, F the force per width: theta' = sqrt(k^2 + F sin(theta) / B)
-- with the curvature k where a plate touches it. Its quarter has the length pi R / 2, which gives k; from k = 0 on it lies flat there, and F D^2 / B is
-- that of two folds.
--
-- A disc clamped flat and free of tension takes a ball of the radius R as a membrane with small slopes (Foeppl): below the contact's edge c the tension is
-- N = C - E t r^2 / (16 R^2), beyond it N_xx + 2 N_x = -E t w'^2 / 2 with x = ln r and w' = F / (2 pi r N); F = 2 pi c^2 N(c) / R; at the rim
-- N_x + (1 - nu) N = 0.
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local mm = fabric.units.mm
local scheme = arg[1] or "static"
local moves = scheme == "explicit" or scheme == "implicit"
local B, width, t = 1e-5, 1 * mm, 0.3 * mm
local strip = fabric.svk { young = 50e6, poisson = 0, density = 500, thickness = t, name = "strip", bending = { warp = B, weft = B, twist = B / 2 } }

-- Runs to the given shares of the duration and calls look(run) at each; returns the run and its processor time.
local function press(m, step, duration, shares, look)
  local run = moves and fabric.dynamic { model = m, duration = duration, scheme = scheme, step = scheme == "implicit" and 1e-3 or nil, damping = { mass = 60 } }
    or fabric.static { model = m, duration = duration, step = step * duration, method = scheme == "relaxation" and scheme or nil }
  local begun = os.clock()
  for _, share in ipairs(shares) do
    run:advance(share * duration)
    look(run)
  end
  return run, os.clock() - begun
end

-- Two plates that close over a mesh of the height 2 * half about z = 0, until its midsurfaces are at the distance D. Returns the upper one.
local function plates(m, half, D, duration)
  local from = half + t / 2 - 1e-7 -- pressed from the start, so that they hold what nothing else holds
  local upper = fabric.rigid.plane { point = { 0, 0, from }, normal = { 0, 0, -1 }, name = "upper plate" }
  local lower = fabric.rigid.plane { point = { 0, 0, -from }, normal = { 0, 0, 1 }, name = "lower plate" }
  m:contact { between = { upper, "all" } }:contact { between = { lower, "all" } }
  local way = half - D / 2
  m:move(upper, { z = fabric.ramp(-way, duration) }):move(lower, { z = fabric.ramp(way, duration) })
  return upper
end
local function height_and_force(run, plate)
  local low, high = math.huge, -math.huge
  for _, z in ipairs(run:field "z") do low, high = math.min(low, z), math.max(high, z) end
  return high - low, math.abs((select(3, run:reaction(plate)))) / width
end

local function fold(n, step, triangles)
  local half, D, T = 14 * mm, 10 * mm, moves and 0.4 or 1
  local mesh = fabric.mesh.rectangle { width = width, height = 2 * half, nx = 1, ny = n, triangles = triangles }
  mesh:map(function(x, y) return 0.1 * mm * (1 - (y / half - 1) ^ 2), x, y - half end) -- a little to one side
  mesh:set("middle", function(_, _, z) return math.abs(z) < 1e-9 end)
  local m = fabric.model { mesh = mesh, card = strip, warp = { 0, 0, 1 } }
  m:fix("middle", "x y z rotation"):fix("all", "y")
  local upper, force, curvature = plates(m, half, D, T), 0, 0
  local _, took = press(m, step, T, { 1 }, function(run)
    local d, f = height_and_force(run, upper)
    local a, b, c = run:node(n - 1), run:node(n + 1), run:node(n + 3)
    local function length(p, q) return math.sqrt((q.x - p.x) ^ 2 + (q.z - p.z) ^ 2) end
    local turn = math.abs((b.x - a.x) * (c.z - b.z) - (b.z - a.z) * (c.x - b.x))
    force, curvature = f * d ^ 2 / B, 2 * turn / (length(a, b) * length(b, c) * length(c, a)) * d
  end)
  return force / 2.8711, curvature / 2.3963, took
end

-- Length and height of a quarter of the ring; theta = q^2 takes away the root at k = 0.
local function quarter(F, k)
  local n, length, high = 400, 0, 0
  local most = math.sqrt(math.pi / 2)
  for i = 1, n do
    local q = (i - 0.5) / n * most
    local s = math.sin(q * q)
    local ds = 2 * q * most / n / math.sqrt(k * k + F * s / B)
    length, high = length + ds, high + s * ds
  end
  return length, high
end
local function bisect(low, high, below)
  for _ = 1, 45 do
    local middle = (low + high) / 2
    if below(middle) then low = middle else high = middle end
  end
  return low
end
local function ring_force(D, R)
  local function height(F)
    local k = quarter(F, 0) <= math.pi * R / 2 and 0 or bisect(0, 1 / R, function(k) return quarter(F, k) > math.pi * R / 2 end)
    return 2 * select(2, quarter(F, k))
  end
  return bisect(0, 16 * B / D ^ 2, function(F) return height(F) > D end)
end

local function tube(n, step)
  local R, D, T = 10 * mm, 8 * mm, moves and 0.4 or 1
  local mesh = fabric.mesh.cylinder { radius = R, length = width, around = n, along = 1 }:map(function(x, y, z) return x, z, y end)
  for name, sign in pairs { low = -1, high = 1 } do mesh:set(name, function(_, _, z) return sign * z > R * (1 - 1e-9) end) end
  local m = fabric.model { mesh = mesh, card = strip, warp = { 0, 1, 0 } }
  m:fix("all", "y"):fix("low", "x"):fix("high", "x")
  local upper, ratios = plates(m, R, D, T), {}
  local _, took = press(m, step, T, { 0.25, 0.6, 1 }, function(run)
    local d, f = height_and_force(run, upper)
    ratios[#ratios + 1] = f / ring_force(d, R)
  end)
  return ratios, took
end

local young, thick, nu, a, R = 1e7, 0.2 * mm, 0.3, 50 * mm, 400 * mm
local stiff = young * thick
-- With the contact's edge at c and the tension C in the middle: what the rim's condition lacks, the force, and the depth.
local function membrane(c, C)
  local N, v = C - stiff * c * c / (16 * R * R), -stiff * c * c / (8 * R * R)
  local F, n, w = 2 * math.pi * c * N * c / R, 200, 0
  local x, h = math.log(c), math.log(a / c) / n
  local function rates(x, N, v)
    local slope = F / (2 * math.pi * math.exp(x) * N)
    return v, -stiff * slope ^ 2 / 2 - 2 * v, slope * math.exp(x)
  end
  for _ = 1, n do
    local n1, v1, w1 = rates(x, N, v)
    local n2, v2, w2 = rates(x + h / 2, N + h / 2 * n1, v + h / 2 * v1)
    local n3, v3, w3 = rates(x + h / 2, N + h / 2 * n2, v + h / 2 * v2)
    local n4, v4, w4 = rates(x + h, N + h * n3, v + h * v3)
    N, v, w, x = N + h / 6 * (n1 + 2 * n2 + 2 * n3 + n4), v + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), w + h / 6 * (w1 + 2 * w2 + 2 * w3 + w4), x + h
    if not (N > 0) then return -1 end
  end
  return v + (1 - nu) * N, F, w + c * c / (2 * R)
end
local function with_edge(c)
  local C = bisect(0, 10 * stiff * (a / R) ^ 2, function(C) return membrane(c, C) < 0 end)
  return select(2, membrane(c, C * (1 + 1e-9)))
end
local function ball_force(depth)
  return (with_edge(bisect(0.01 * a, 0.9 * a, function(c) return select(2, with_edge(c)) < depth end)))
end

local function disc(cells, step)
  local depth, T, thin, clear = 2 * mm, moves and 0.2 or 1, 0.1 * mm, 1e-6
  local card = fabric.svk { young = young, poisson = nu, density = 500, thickness = thick, bending = { warp = 1e-8, weft = 1e-8, twist = 1e-8 }, name = "membrane" }
  local m = fabric.model { mesh = fabric.mesh.disk { radius = a, cells = cells }, card = card, points = 1, warp = 0 }
  m:fix("boundary", "x y z")
  local ball = fabric.rigid.sphere { radius = R - thin / 2, centre = { 0, 0, R + clear }, name = "ball" }
  m:contact { between = { ball, "all" }, thickness = thin }:move(ball, { z = fabric.ramp(-depth - clear, T) })
  local ratio
  local _, took = press(m, step, T, { 1 }, function(run) ratio = -select(3, run:reaction(ball)) / ball_force(depth) end)
  return ratio, took
end

local rows = {}
local function tell(words, took, list)
  local text = {}
  for _, row in ipairs(list) do
    text[#text + 1] = ("%s %.4f"):format(row[1], row[2])
    if not moves then rows[#rows + 1] = { words .. ": " .. row[1], row[2], 1, absolute = row[3] } end
  end
  print(("%-44s over the closed form: %s   %.2f s"):format(words, table.concat(text, ", "), took))
end
local as_slow = ("of %s motion"):format(scheme)
for _, case in ipairs(moves and { { 56 } } or { { 56, 0.2 }, { 56, 0.04 }, { 56, 0.01 }, { 56, 0.04, true }, { 28, 0.04 } }) do
  local force, curvature, took = fold(case[1], case[2], case[3])
  local words = ("fold, %d %s, step %s"):format(case[1], case[3] and "triangles" or "quadrilaterals", case[2] or as_slow)
  tell(words, took, { { "force", force, 0.01 }, { "curvature", curvature, 0.01 } })
end
for _, case in ipairs(moves and { { 64 } } or { { 64, 0.2 }, { 64, 0.04 }, { 64, 0.01 } }) do
  local ratios, took = tube(case[1], case[2])
  tell(("tube, %d around, step %s"):format(case[1], case[2] or as_slow), took, { { "round", ratios[1], 0.015 }, { "less", ratios[2], 0.015 }, { "flat", ratios[3], 0.02 } })
end
for _, case in ipairs(moves and { { 8 } } or { { 8, 0.5 }, { 8, 0.1 } }) do
  local ratio, took = disc(case[1], case[2])
  tell(("ball on a disc, %d cells, step %s"):format(case[1], case[2] or as_slow), took, { { "force", ratio, 0.05 } })
end
if not moves then fabric.expect(rows) end
