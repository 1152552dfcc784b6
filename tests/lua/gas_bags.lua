-- Closures of a volume besides cloth: seams, planes of symmetry, lids on free rims. And bags in motion.
local fabric = require "fabric"
local near = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).near
local card = fabric.svk { young = 30e6, poisson = 0.25, density = 700, thickness = 0.3e-3 }
local rows = {}

-- Two sheets 4 mm apart, sewn around, with other meshes; blown up. Both ways of looking: whole, and a quarter with planes of symmetry.
local side, gap = 0.2, 0.004
local function pillow(part, triangles)
  local n = part == 1 and 8 or 4
  local at = part == 1 and { -side / 2, -side / 2 } or { 0, 0 }
  local function sheet(z)
    return fabric.mesh.rectangle { width = side / part, height = side / part, nx = n, ny = n, triangles = triangles, origin = { at[1], at[2], 0 } }:map(function(x, y) return x, y, z end)
  end
  local m = fabric.model { bodies = { { name = "up", mesh = sheet(gap / 2), card = card, warp = 0 }, { name = "down", mesh = sheet(-gap / 2), card = card, warp = 0 } } }
  for _, edge in ipairs(part == 1 and { "left", "right", "bottom", "top" } or { "right", "top" }) do
    m:seam { "up." .. edge, "down." .. edge, over = 0.02, hinge = true }
  end
  local mesh = m.mesh
  if part == 2 then
    for _, name in ipairs { "up", "down" } do m:symmetry(name .. ".left", "x"):symmetry(name .. ".bottom", "y") end
  else
    mesh:set("centre", function(x, y, z) return x * x + y * y < 1e-12 and z < 0 end)
    mesh:set("beside", function(x, y, z) return x > 1e-9 and x < side / 6 and y * y < 1e-12 and z < 0 end)
    m:fix("centre", "x y"):fix("beside", "y")
  end
  mesh:set("foot", function(x, y, z) return x * x + y * y < 1e-12 and z < 0 end)
  m:fix("foot", "z")
  return m
end
for _, triangles in ipairs { false, true } do
  local found = {}
  for part = 1, 2 do
    local m = pillow(part, triangles)
    local g = m:gas { inflow = { { 0, 0 }, { 0.02, 0 }, { 0.04, 0.05 / part ^ 2 }, { 0.06, 0 } } }
    local a = fabric.dynamic { model = m, duration = 0.1, damping = { mass = 150 } }
    local _, V = a:gas(g)
    near(V, side * side * gap / part ^ 2, 1e-9, "volume at the start")
    a:solve()
    local p, volume, mass, T = a:gas(g)
    near((p + 101325) * volume, mass * T * 8.314462618 / 0.028965, 1e-12, "ideal gas")
    found[part] = volume * part ^ 2
  end
  if not triangles then rows[#rows + 1] = { "quarter and whole", found[2], found[1], relative = 1e-2 } end
end

-- A tube whose upper rim is free: a lid without weight draws it out. The gas pushes on both lids alike, so that the support has nothing to hold.
do
  local mesh = fabric.mesh.cylinder { radius = 0.05, length = 0.2, around = 16, along = 8 }
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 } }
  m:fix("bottom", "x y z"):tie("rigid", "top")
  m:gas { lids = { "bottom", "top" }, initial = 5000 }
  local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local _, _, z = a:reaction "bottom"
  rows[#rows + 1] = { "tube, force", z, 0, absolute = 1e-6 }
  assert(a:mean("z", "top") > 0.2 + 1e-6)
  assert(a.steps[1].iterations < 12 and a.steps[1].stable == true, a.steps[1].iterations)
end

-- The same tube moves; a run that is restored goes on with the same bits.
for _, scheme in ipairs { "explicit", "implicit" } do
  local mesh = fabric.mesh.cylinder { radius = 0.05, length = 0.2, around = 8, along = 4 }
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 } }
  m:fix("bottom", "x y z")
  local g = m:gas { lids = { "bottom", "top" }, exponent = 1.4, initial = 3000, vents = { { area = 1e-5 } }, leakage = 0.01 }
  local T = 0.004
  local a = fabric.dynamic { model = m, scheme = scheme, duration = T, step = scheme == "implicit" and T / 100 or nil }
  a:advance(T / 3)
  local middle = a:snapshot()
  a:solve()
  local p, V, mass = a:gas(g)
  assert(a.energy.error < 0.02, a.energy.error)
  a:restore(middle):solve()
  local q, W, left = a:gas(g)
  assert(p == q and V == W and mass == left, "the same bits")
end
fabric.expect(rows)
