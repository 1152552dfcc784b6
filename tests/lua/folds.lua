-- Folds within elements: a sheared panel, a pushed strip whose wave the mesh shows, a strip that is pulled, inflated film, every scheme, and what a
-- run says whose elements are compressed in the place of folds.
local fabric = require "fabric"
local mm, MPa = fabric.units.mm, fabric.units.MPa
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local near, fails = check.near, check.fails

local function film(E, nu, B)
  local yarn = { loading = { E }, unloading = E, poisson = nu }
  return fabric.woven { name = "film", density = 1200, thickness = 0.08 * mm, warp = yarn, weft = yarn,
    shear = { loading = { E / (1 + nu) }, unloading = E / (1 + nu) }, bending = { warp = B, weft = B, twist = B }, tested = { warp = 0.2, weft = 0.2, shear = 0.2 } }
end

-- A panel in a frame that is sheared by gamma: Wagner's web, in tension along its diagonal. Its Green strain there is the larger principal one, l, and
-- the energy E l^2 / 2 gives the force; E t gamma / 4 per width where gamma is small. The rigidity is next to nothing.
local E, nu, t, side, gamma = 600 * MPa, 0.25, 0.08 * mm, 80 * mm, 0.03
local function panel(n, triangles, folds)
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = film(E, nu, 1e-8), warp = 0, folds = folds }
  mesh:set("frame", function(x, y) return x < 1e-9 or x > side - 1e-9 or y < 1e-9 or y > side - 1e-9 end)
  m:fix("frame", "y z"):fix("bottom", "x")
  for k = 1, n do
    mesh:set("row " .. k, function(x, y) return math.abs(y - k * side / n) < 1e-9 and (x < 1e-9 or x > side - 1e-9 or k == n) end)
    m:move("row " .. k, { x = fabric.ramp(gamma * k * side / n, 1) })
  end
  local a = fabric.static { model = m, duration = 1, step = 0.2 }:solve()
  local force = 0
  for k = 1, n do force = force + a:reaction("row " .. k) * k / n end
  return a, force
end
local root = math.sqrt(gamma ^ 4 / 16 + gamma ^ 2 / 4)
local want = E * t * side * (gamma ^ 2 / 4 + root) * (gamma / 2 + (gamma ^ 3 / 4 + gamma / 2) / (2 * root))
for _, triangles in ipairs { false, true } do
  for _, n in ipairs { 4, 8 } do
    local a, force = panel(n, triangles, "within elements")
    near(force, want, 2e-3, ("a panel of %d elements, %s"):format(n, triangles and "triangles" or "quadrilaterals"))
    assert(a.energy.error < 1e-6 and a.warnings[1].code == "bending" and not a.warnings[2])
    for _, share in ipairs(a:field "folded") do assert(share > 0.5 and share <= 1) end
  end
end
local stiff = panel(4, false)
local said
for _, w in ipairs(stiff.warnings) do
  if w.code == "compressed" then said = w.serious and w.element and w.text:find("folds=\"within elements\"", 1, true) end
end
assert(said)

-- A strip that is pushed, hinged at its ends: four elements are half a wave, and buckle at Euler's load as without.
local function strip(folds, n)
  local yarn = { loading = { 2e7 }, unloading = 2e7, poisson = 0 }
  local card = fabric.woven { name = "strip", density = 300, thickness = 0.4 * mm, warp = yarn, weft = yarn, shear = { loading = { 1e6 }, unloading = 1e6 },
    bending = { warp = 2e-5, weft = 1e-5, twist = 1e-5 }, tested = { warp = 0.2, weft = 0.2, shear = 0.2 } }
  local mesh = fabric.mesh.rectangle { width = 80 * mm, height = 20 * mm, nx = n, ny = 1 }
  mesh:set("middle", function(x) return math.abs(x - 40 * mm) < 40 * mm / n + 1e-9 end)
  local m = fabric.model { mesh = mesh, card = card, warp = 0, folds = folds }
  m:fix("left", "x y z"):fix("right", "y z"):move("right", { x = fabric.ramp(-2 * mm, 1) }):force("middle", { z = 2e-5 })
  local a = fabric.static { model = m, duration = 1, step = 0.05 }:solve()
  return -a:reaction "right" / (20 * mm), math.max(table.unpack(a:field "folded")), a:node(mesh:set("middle")[1]).z
end
local plain, _, up = strip("resolved", 4)
local force, folded, high = strip("within elements", 4)
near(force, plain, 1e-8, "the load of a wave that the mesh shows")
near(high, up, 1e-8, "its height")
near(force, math.pi ^ 2 * 2e-5 / (80 * mm) ^ 2, 0.15, "Euler's load") -- four elements, 2.5 % shorter
assert(folded == 0)

-- A strip that is pulled contracts as it did, whatever carries the compression.
for _, warp in ipairs { 0, 90 } do
  local force, width
  for _, folds in ipairs { "resolved", "free" } do
    local mesh = fabric.mesh.rectangle { width = 60 * mm, height = 20 * mm, nx = 3, ny = 1 }
    mesh:set("corner", function(x, y) return x < 1e-9 and y < 1e-9 end)
    local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), warp = warp, folds = folds }
    m:fix("all", "z"):fix("left", "x"):fix("corner", "y"):move("right", { x = fabric.ramp(4 * mm, 1) })
    local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
    if force then
      near(a:reaction "right", force, 1e-9, "the force of a strip that is pulled")
      near(a:mean "E22", width, 1e-4, "its contraction") -- at the limit of folding, where it is soft across
    end
    force, width = a:reaction "right", a:mean "E22"
  end
end

-- In motion, explicit and implicit, and from a state that was kept.
for _, scheme in ipairs { "explicit", "implicit" } do
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = 4, ny = 4 }
  local m, T = fabric.model { mesh = mesh, card = film(E, nu, 1e-8), warp = 0, folds = "within elements" }, 0.02
  m:fix("bottom", "x y z"):fix("top", "y z"):move("top", { x = fabric.ramp(gamma * side, T) })
  local function analysis()
    return fabric.dynamic { model = m, duration = T, scheme = scheme, damping = { mass = 200 }, step = scheme == "implicit" and T / 40 or nil }
  end
  local whole = analysis()
  whole:advance(T / 2)
  whole:solve()
  assert(whole.energy.error < 1e-2, scheme)
  local parts = analysis()
  parts:advance(T / 2)
  local state = parts:snapshot()
  parts:advance(0.7 * T)
  parts:restore(state)
  parts:solve()
  local one, two = whole:field "folded", parts:field "folded"
  local most = 0
  for e, share in ipairs(one) do
    most = math.max(most, share)
    assert(share == two[e], "the state kept does not lead to the same folds")
  end
  assert(most > 0.3 and whole:reaction "top" == parts:reaction "top")
end

fails("model: field 'folds': expected 'resolved' or 'within elements' or 'free', got 'elements'", fabric.model, { mesh = fabric.mesh.rectangle { width = 1, height = 1, nx = 1, ny = 1 }, card = fabric.card "blend", folds = "elements" })
