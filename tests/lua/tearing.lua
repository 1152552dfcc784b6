-- Breaking yarns from the side of a deck: the card's fields, options, the ledger, and a restart within a tear.
local fabric = require "fabric"
local mm = fabric.units.mm
local plain = fabric.svk { young = 1e8, poisson = 0, density = 500, thickness = 0.5 * mm }
local card = plain:with { rupture = { weft = { strength = 4e3, energy = 2.5, scatter = { modulus = 8, length = 0.1 } } } }
assert(card.rupture.weft.strength == 4e3 and card.rupture.weft.scatter.length == 0.1 and card.rupture.warp == nil)
assert(not pcall(plain.with, plain, { rupture = { weft = { strength = -1, energy = 2 } } }))
assert(not pcall(plain.with, plain, { rupture = { weft = { strength = 1e3 } } }))

local function strip(options)
  local mesh = fabric.mesh.rectangle { width = 40 * mm, height = 40 * mm, nx = 10, ny = 10 }
  local m = fabric.model { mesh = mesh, card = card }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(3 * mm, 6e-3) })
  m:tearable("all", options)
  return m
end
local function run(options)
  local a = fabric.dynamic { model = strip(options), duration = 6e-3, ledger_limit = 1 }
  a:cut { line = { { 0, 20 * mm, 0 }, { 16 * mm, 20 * mm, 0 } } }
  return a
end
local a = run()
local cut = a.joints.open
while a.energy.fracture == 0 do a:step() end
local there = a:snapshot()
a:solve()
assert(a.joints.open > cut and a.energy.fracture > 0 and a.energy.error < 1e-2)
assert(a.energy.fracture <= 2.5 * 40 * mm * 9)
local ends = a:field "uy"
a:restore(there):solve()
for i, uy in ipairs(a:field "uy") do assert(uy == ends[i]) end
local broken = 0
for _, share in ipairs(a:field "rupture_weft") do broken = broken + (share == 1 and 1 or 0) end
assert(broken > 0)
for _, share in ipairs(a:field "rupture_warp") do assert(share == 0) end
-- Another seed, another tear; and meshes that are off the yarns or too coarse are refused.
local b = run { seed = 2 }
b:solve()
local differs = false
for i, uy in ipairs(b:field "uy") do differs = differs or uy ~= ends[i] end
assert(differs)
local ok, why = pcall(run, { coarse = "refuse" })
assert(not ok and tostring(why):find("coarse for tears across the weft", 1, true), tostring(why))
local m = fabric.model { mesh = fabric.mesh.rectangle { width = 40 * mm, height = 40 * mm, nx = 4, ny = 4 }, card = card, warp = 10 }
m:tearable "all"
ok, why = pcall(fabric.dynamic, { model = m, duration = 1e-3 })
assert(not ok and tostring(why):find("element 1 has an edge 10 degrees off the yarns", 1, true), tostring(why))

-- A strip that touches itself breaks in one column of yarns after the other, and columns that have begun to open close again as others go on: crack faces that were
-- hardly apart do not touch, and the tear goes on.
do
  local young, t = 1e7, 0.3e-3
  local breaks = { strength = 0.03 * young * t, energy = 6e-3 * young * t * 0.03 ^ 2 }
  local card = fabric.svk { young = young, poisson = 0, density = 500, thickness = t, through_thickness = true }:with { rupture = { warp = breaks, weft = breaks } }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.03, height = 0.02, nx = 10, ny = 7 }, card = card, points = 2 }
  m:tearable("all", { coarse = "keep" }):contact { self = "all", thickness = 1e-3 }
  m:fix("left", "x y z"):fix("right", "y z"):move("right", { x = fabric.history { { 0, 0 }, { 1e-3, 2e-3 }, { 2e-3, 2e-3 } } })
  local a = fabric.dynamic { model = m, duration = 2e-3 }
  a:solve()
  assert(a.joints.open > 20 and a.energy.fracture > 6 * 0.02 * breaks.energy / 10 and a.energy.error < 1e-2)
end
