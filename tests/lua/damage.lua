-- Yarns that soften and break: a strip in every scheme, on quadrilaterals and triangles, three meshes; weaker elements; snapshots; names of what is lost.
local fabric = require "fabric"
local mm = 1e-3
local D, t, energy, width, length, begin = 50e6, 4e-4, 2, 10 * mm, 8 * mm, 0.06
local strength = t * D * begin * math.sqrt(1 + 2 * begin) -- N/m: a linear yarn breaks at the strain 0.06
local yarn = { loading = { D }, unloading = 1.001 * D, poisson = 0 }
local card = fabric.woven { name = "linear", density = 500, thickness = t, through_thickness = true, warp = yarn, weft = yarn,
  shear = { loading = { 2e6 }, unloading = 4e6 }, tested = { warp = 0.1, weft = 0.1, shear = 0.3 },
  damage = { warp = { strength = strength, energy = energy } } }
assert(card.damage.warp.energy == energy and card.damage.weft == nil)
assert(tostring(card):find "damage" and card:with { damage = false }.damage == nil)

local function near(what, got, wanted, tolerance)
  assert(math.abs(got / wanted - 1) < tolerance, ("%s: got %.9g, expected %.9g"):format(what, got, wanted))
end

-- The strip is pulled along the warp; the row of elements in the middle is a little weaker, and breaks.
local function model(n, triangles)
  local mesh = fabric.mesh.rectangle { width = width, height = length, nx = 2, ny = n, triangles = triangles }
  local h = length / n
  mesh:set("weak", function(x, y) return math.abs(y - h * (n // 2 + 0.5)) < 0.51 * h end)
  local m = fabric.model { mesh = mesh, card = card, warp = 90, points = 1, membrane = true }
  m:fix("all", "x z"):fix("bottom", "y"):strength { set = "weak", factor = 0.98 }
  m:move("top", { y = fabric.ramp(6 * mm, 1) })
  return m
end

local function broken(what, a, most, share)
  local e = a.energy
  print(what, most, e.dissipated_damage, e.relaxed, e.damping, e.error)
  near(what .. ": taken by the break", e.dissipated_damage, energy * width, 1e-6)
  near(what .. ": peak", most, share * strength * width, 0.02)
  near(what .. ": the sum of what is lost", e.dissipated_warp + e.dissipated_weft + e.dissipated_shear + e.dissipated_damage, e.dissipated, 1e-12)
  local elements = 0
  for _, x in ipairs(a:field "dissipated_damage") do elements = elements + (x > 1e-9 and 1 or 0) end
  assert(elements == 2 or elements == 4, elements) -- the weak row alone
end

for _, case in ipairs { { 4, false }, { 8, false }, { 8, true } } do
  local a, most = fabric.static { model = model(case[1], case[2]), duration = 1, step = 0.01 }, 0
  a:every(0.01, function(run) most = math.max(most, select(2, run:reaction "top")) end)
  a:solve()
  broken(("static, %d, %s"):format(case[1], case[2] and "triangles" or "quadrilaterals"), a, most, 0.98)
end

-- In motion, explicit and implicit; a state that is restored in the middle of the break goes on with the same bits.
for _, scheme in ipairs { "explicit", "implicit" } do
  local mesh = fabric.mesh.rectangle { width = width, height = length, nx = 2, ny = 4 }
  mesh:set("weak", function(_, y) return y > 3.9 * mm and y < 6.1 * mm end)
  local m = fabric.model { mesh = mesh, card = card, warp = 90, points = 1, membrane = true }
  local duration = scheme == "explicit" and 16e-3 or 0.2
  m:fix("all", "x z"):fix("bottom", "y"):strength { set = "weak", factor = 0.9 }
  m:move("top", { y = fabric.ramp(6 * mm, duration) })
  local a, most = fabric.dynamic { model = m, duration = duration, scheme = scheme, step = scheme == "implicit" and 1e-3 or nil }, 0
  a:every(duration / 200, function(run) most = math.max(most, select(2, run:reaction "top")) end)
  a:advance(0.2 * duration)
  while a.energy.dissipated_damage < 0.3 * energy * width do a:step() end
  local there = a:snapshot()
  a:solve()
  local lost, ux = a.energy.dissipated_damage, a:field "position"
  assert(a.energy.error < 1e-3, a.energy.error)
  broken(scheme, a, most, 0.9)
  a:restore(there)
  a:solve()
  assert(a.energy.dissipated_damage == lost)
  for i, x in ipairs(a:field "position") do assert(x[2] == ux[i][2]) end
end

-- Weaker elements scatter by their seed; a mesh that is too coarse for the energy is refused with the size that is needed.
local function scattered(seed)
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = width, height = length, nx = 2, ny = 4 }, card = card, warp = 90, points = 1, membrane = true }
  m:fix("all", "x z"):fix("bottom", "y"):strength { modulus = 10, seed = seed }:move("top", { y = fabric.ramp(1 * mm, 1) })
  local a, most = fabric.static { model = m, duration = 1, step = 0.02 }, 0
  a:every(0.02, function(run) most = math.max(most, select(2, run:reaction "top")) end)
  a:solve()
  return most
end
local first = scattered(1)
assert(first == scattered(1) and first ~= scattered(2) and first < strength * width)
local ok, refusal = pcall(function()
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.2, height = 0.4, nx = 1, ny = 2 }, card = card, warp = 90, points = 1, membrane = true }
  m:fix("bottom", "x y z"):fix("top", "x z"):move("top", { y = fabric.ramp(0.01, 1) })
  fabric.static { model = m, duration = 1 }:solve()
end)
assert(not ok and tostring(refusal):find("element 1: field 'damage.warp': expected at most", 1, true), refusal)

-- A point stands for a length of cloth, or holds.
local function at(size, E)
  local p = fabric.point(card, size)
  p:strain { E11 = E, over = 0 }
  return p:state()
end
near("a point that holds", fabric.point(card):strain { E11 = 0.2 }.S11, D * 0.2, 1e-12)
local long = at(2 * mm, 4)
near("what a point loses", long.dissipated_damage, energy / (t * 2 * mm), 1e-9)
assert(long.S11 == 0 and fabric.point(card, 1 * mm):path({ E11 = { 0.1, 0.2 } }, { "dissipated_damage" }).dissipated_damage[2] > 0)
