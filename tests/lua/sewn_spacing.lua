-- Edges that lie on each other are one from the start, whatever the spacing of their nodes: a strip across the seam carries what it does without it.
-- Nodes along a curve part by the height of the arc over its chord; the error says so.
local fabric = require "fabric"
local mm = fabric.units.mm
local near = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).near
local card = fabric.svk { young = 1e6, poisson = 0, density = 500, thickness = 0.5 * mm }
local L = 100 * mm

-- Two pieces, na and nb elements along the seam. The inner nodes of the second are moved along it by up to `shift`; both are bent along it to an arc.
local function strip(scheme, na, nb, shift, o)
  o = o or {}
  local a = fabric.mesh.rectangle { width = L, height = L, nx = 2, ny = na, triangles = o.triangles }
  local b = fabric.mesh.rectangle { width = L, height = L, nx = 2, ny = nb, origin = { L + (o.gap or 0), 0, 0 }, triangles = o.triangles }
  b:map(function(x, y) return x, y + shift * math.sin(math.pi * y / L), 0 end)
  if o.radius then
    for _, mesh in ipairs { a, b } do mesh:map(function(x, y) return x, o.radius * math.sin(y / o.radius), o.radius * math.cos(y / o.radius) end) end
  end
  local m = fabric.model { bodies = { { name = "a", mesh = a, card = card, warp = { 1, 0, 0 } }, { name = "b", mesh = b, card = card, warp = { 1, 0, 0 } } } }
  if not o.radius then m:fix("a.all", "z rotation"):fix("b.all", "z rotation") end
  m:seam { "a.right", "b.left", hinge = o.hinge, over = o.over }
  m:fix("a.left", "x y z"):fix("b.right", "y z"):move("b.right", { x = fabric.ramp(2 * mm, 0.5) })
  if scheme == "static" then return fabric.static { model = m, duration = 0.5, step = 0.25 } end
  return fabric.dynamic { model = m, duration = 0.6, scheme = scheme, step = scheme == "implicit" and 5e-3 or nil, damping = { mass = 100 }, ledger_limit = 1 }
end

-- The whole strip: F = E t L lambda (lambda^2 - 1)/2. The error is that of stress beside a seam between different spacings.
local lambda = 1 + 2 * mm / (2 * L)
local F = 1e6 * 0.5 * mm * L * lambda * (lambda ^ 2 - 1) / 2
local function carries(scheme, na, nb, shift, o)
  local a = strip(scheme, na, nb, shift, o):solve()
  local what = ("%s, %d on %d elements, %g m off%s"):format(scheme, na, nb, shift, o and o.triangles and ", triangles" or "")
  local force = a:reaction "b.right"
  near(force, F, (scheme == "static" and 2e-9 or 1e-3) + (na ~= nb and 2e-4 or 2e-5 * (shift / mm) ^ 2), what)
  assert(a.joints.closed == a.joints.stitches and a.joints.stitches == math.max(na, nb) + 1, what)
end
for _, shift in ipairs { 0, 1e-8, 1e-6, 1.5e-6, 2e-6, 1e-5, 2e-5, 0.1 * mm, 1 * mm, 2 * mm, 5 * mm } do
  for _, n in ipairs { 6, 7 } do
    carries("static", 6, n, shift)
    carries("static", n, 6, shift, { hinge = true })
  end
end
for _, shift in ipairs { 0.1 * mm, 2 * mm } do
  carries("static", 6, 6, shift, { triangles = true })
  for _, scheme in ipairs { "explicit", "implicit" } do
    carries(scheme, 6, 6, shift)
    carries(scheme, 6, 7, shift, { triangles = true, hinge = true })
  end
end

-- Along an arc: the nodes on each other, or so near that the place between two nodes is as near as that; else the distance is that from the chord.
local R = 0.2
local function refused(words, ...)
  local ok, why = pcall(strip, ...)
  assert(not ok and tostring(why):find(words, 1, true), "expected " .. words .. ", got " .. tostring(why))
  return tonumber(tostring(why):match "is (%S+) m from")
end
for _, hinge in ipairs { true, false } do
  for _, shift in ipairs { 0, 1e-6, 2e-5 } do assert(strip("static", 6, 6, shift, { radius = R, hinge = hinge }).joints.closed == 7) end
end
local curved = "which edges along a curve do where they have the same places of nodes"
local h = L / 6
local far = refused(curved, "static", 6, 6, 5 * mm, { radius = R })
assert(far > 0.3 * h ^ 2 / 8 / R and far < 2 * h ^ 2 / 8 / R)
far = refused(curved, "static", 6, 7, 0, { radius = R })
assert(far > 0.3 * h ^ 2 / 8 / R and far < 2 * h ^ 2 / 8 / R)
do
  local a = strip("explicit", 6, 7, 0, { radius = R, over = 0.01 })
  a:advance(0.015)
  assert(a.joints.closed == 8)
end

-- Straight edges that do not lie on each other: the distance is that between them, whatever the spacing.
for _, n in ipairs { 6, 7 } do
  assert(refused("expected edges that lie on each other, or a time", "static", 6, n, 2 * mm, { gap = 0.1 * mm }) == 1e-4)
end

-- Rings: two sheets on each other, with nodes in other places along all four edges.
for _, n in ipairs { 4, 5 } do
  local low, high = fabric.mesh.rectangle { width = L, height = L, nx = 4, ny = 4 }, fabric.mesh.rectangle { width = L, height = L, nx = n, ny = n }
  high:map(function(x, y) return x + 2 * mm * math.sin(math.pi * x / L), y - 1 * mm * math.sin(math.pi * y / L), 0 end)
  local m = fabric.model { bodies = { { name = "low", mesh = low, card = card, warp = 0 }, { name = "high", mesh = high, card = card, warp = 0 } } }
  local a = fabric.static { model = m:fix("low.all", "z"):fix("high.all", "z"):seam { "low.boundary", "high.boundary", hinge = true }, duration = 1 }
  assert(a.joints.closed == 4 * n)
end
