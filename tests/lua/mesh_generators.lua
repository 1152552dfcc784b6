-- The generators from a deck's side: sets, wrong fields, and a disk that needs no warp direction.
local fabric = require "fabric"

local function refused(part, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(part, 1, true), tostring(why))
end

local disk = fabric.mesh.disk{ radius = 0.05, cells = 4 }
assert(#disk.nodes == 25 + 2 * 16 and #disk:set "centre" == 1)
local x = disk.nodes[disk:set("centre")[1]]
assert(math.abs(x[1]) < 1e-15 and math.abs(x[2]) < 1e-15 and x[3] == 0)
fabric.model{ mesh = disk, card = fabric.card "blend" }

local cut = fabric.mesh.rectangle{ width = 0.1, height = 0.1, nx = 2, ny = 2, triangles = true }
assert(#cut.elements == 8 and #cut.elements[1] == 3 and #cut:set "left" == 3)

local held = fabric.model{ mesh = cut, card = fabric.card "blend" }
held:fix("left", "x y z rotation")
cut:set("late", { 5 })
fabric.static{ model = held, duration = 1 }
cut:set("later", { 5 })
refused("compiled model", cut.set, cut, "late", { 4 })
refused("compiled model", cut.map, cut, function(x, y, z) return x, y, z end)

local sleeve = fabric.mesh.cylinder{ radius = 0.04, length = 0.2, around = 12, along = 4 }
assert(#sleeve:set "bottom" == 12 and #sleeve:set "seam" == 5)
refused("warp", fabric.model, { mesh = sleeve, card = fabric.card "blend" })

local shell = fabric.mesh.hemisphere{ radius = 10, hole = 18, around = 4, along = 4 }
assert(#shell:set "start" == 5 and #shell:set "end" == 5)
assert(#fabric.mesh.annulus{ inner = 1, outer = 2, around = 8, across = 2, angle = 180 }:set "inner" == 9)

refused("unknown field 'radios', did you mean 'radius'?", fabric.mesh.disk, { radios = 1, cells = 2 })
refused("disk: field 'rings': expected an integer of at least 1, got 0", fabric.mesh.disk, { radius = 1, cells = 2, rings = 0 })
refused("annulus: field 'outer'", fabric.mesh.annulus, { inner = 1, outer = 1, around = 3, across = 1 })
refused("hemisphere: field 'hole': expected a number above 0 to below 90 in degrees, got 90", fabric.mesh.hemisphere,
  { radius = 1, hole = 90, around = 3, along = 1 })
refused("cylinder: field 'angle'", fabric.mesh.cylinder, { radius = 1, length = 1, around = 3, along = 1, angle = 0 })

-- A hole along the grid: a staircase about a circle. Elements, nodes and sets go on with the rest; so does a second hole that meets the edge.
do
  local mesh = fabric.mesh.rectangle { width = 1, height = 1, nx = 10, ny = 10 }
  mesh:set("middle", function(x, y) return math.abs(x - 0.5) < 0.01 and math.abs(y - 0.5) < 0.01 end)
  assert(mesh:hole(function(x, y) return (x - 0.5) ^ 2 + (y - 0.5) ^ 2 < 0.2 ^ 2 end, "rim") == mesh)
  -- Of the 16 cells about the centre the four at the corners have their middle at 0.212, so that twelve go, with the five nodes within.
  assert(#mesh.elements == 100 - 12 and #mesh.nodes == 121 - 5 and #mesh:set "rim" == 16 and #mesh:set "boundary" == 40 + 16 and not pcall(mesh.set, mesh, "middle"))
  for _, n in ipairs(mesh:set "rim") do
    local p = mesh.nodes[n]
    local away = math.max(math.abs(p[1] - 0.5), math.abs(p[2] - 0.5))
    assert(away > 0.09 and away < 0.21)
  end
  for e = 1, #mesh.elements do
    local ids = mesh.elements[e]
    local a, c = mesh.nodes[ids[1]], mesh.nodes[ids[3]]
    assert(math.abs(c[1] - a[1] - 0.1) < 1e-12 and math.abs(c[2] - a[2] - 0.1) < 1e-12)
  end
  mesh:hole(function(x, y) return x < 0.1 and y < 0.1 end)
  assert(#mesh.elements == 87 and #mesh:set "left" == 10 and #mesh:set "boundary" == 56)
  refused("hole: every element has its middle inside", mesh.hole, mesh, function() return true end)
end

-- Lines of nodes where they are given, and a slit whose sides have names.
local graded = fabric.mesh.rectangle{ width = 0.1, height = 0.06, ny = 3, grading = { x = { 0, 0.04, 0.05, 0.06, 0.1 } } }
assert(#graded.nodes == 20 and graded.nodes[7][1] == 0.04 and math.abs(graded.nodes[7][2] - 0.02) < 1e-15)
local function rectangle(more)
  local t = { width = 0.1, height = 0.06, nx = 4, ny = 3 }
  for k, v in pairs(more) do t[k] = v or nil end
  return fabric.mesh.rectangle(t)
end
refused("rectangle: field 'nx': expected 4, one less than the lines of grading, got 3", rectangle, { nx = 3, grading = { x = { 0, 0.04, 0.05, 0.06, 0.1 } } })
refused("rectangle: field 'nx': expected an integer of at least 1, or grading, got neither", rectangle, { nx = false })
refused("rectangle: field 'grading': expected x, y or both, got neither", rectangle, { grading = {} })
refused("got 0 to 0.05 m", rectangle, { ny = false, grading = { y = { 0, 0.05 } } })
assert(graded:slit{ from = { 0.05, 0.06 }, to = { 0.05, 0.02 }, left = "east", right = "west" } == graded)
assert(#graded.nodes == 22 and #graded:set "east" == 3 and #graded:set "west" == 3 and #graded:set "top" == 6)
refused("slit: the line from (0.05, 0, 0) to (0.05, 0.01, 0) m has no edge", graded.slit, graded, { from = { 0.05, 0 }, to = { 0.05, 0.01 } })
refused("slit: field 'from': expected {x, y} or {x, y, z}, got 1 number", graded.slit, graded, { from = { 0.05 }, to = { 0.05, 0.01 } })
