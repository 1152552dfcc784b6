-- Makes the meshes that come with fabricsh, each as Gmsh .msh and as .vtu, and reads them back.
--
--   fabricsh scripts/meshes/make.lua [folder]      default: meshes
--
-- strip  the tensile strip of the thesis, 25.4 x 76.2 mm, 3 x 9 elements [williams2010, section 7.2]
-- disc   radius 100 mm, a square core of 8 x 8 elements and 4 rings
-- sleeve radius 50 mm, 200 mm long, 24 x 12 elements, closed
-- wavy   a plate of 200 x 200 mm with two waves of 5 mm each way: every element is warped
local fabric = require "fabric"
local mm = fabric.units.mm
local sin, cos, pi = math.sin, math.cos, math.pi

if #arg > 1 then error("make: expected at most 1 argument (the folder), got " .. #arg, 0) end
local folder = arg[1] or "meshes"

local side, waves, height = 200 * mm, 2, 5 * mm
local k = 2 * pi * waves / side
local function wave(x, y) return height * sin(k * x) * sin(k * y) end

local meshes = {
  strip = fabric.mesh.rectangle { width = 25.4 * mm, height = 76.2 * mm, nx = 3, ny = 9 },
  disc = fabric.mesh.disk { radius = 100 * mm, cells = 8 },
  sleeve = fabric.mesh.cylinder { radius = 50 * mm, length = 200 * mm, around = 24, along = 12 },
  wavy = fabric.mesh.rectangle { width = side, height = side, nx = 20, ny = 20 }
    :map(function(x, y) return x, y, wave(x, y) end),
}

-- Area of the wavy surface: the mean of sqrt(1 + |grad z|^2), by the midpoint rule over a quarter of one wave.
local function wavy_area()
  local n, sum = 200, 0
  for i = 1, n do
    for j = 1, n do
      local x, y = (i - 0.5) / n * pi / 2, (j - 0.5) / n * pi / 2
      local p, q = cos(x) * sin(y), sin(x) * cos(y)
      sum = sum + (1 + (height * k) ^ 2 * (p * p + q * q)) ^ 0.5
    end
  end
  return side ^ 2 * sum / n ^ 2
end

-- Nodes, elements, border lines and area. Circles are polygons of as many corners as the mesh has nodes on them.
local wanted = {
  strip = { 40, 27, 1, 25.4 * mm * 76.2 * mm, relative = 1e-13 },
  disc = { 81 + 4 * 32, 64 + 4 * 32, 1, 16 * sin(2 * pi / 32) * (100 * mm) ^ 2, relative = 1e-13 },
  sleeve = { 24 * 13, 24 * 12, 2, 24 * 2 * 50 * mm * sin(pi / 24) * 200 * mm, relative = 1e-13 },
  -- The mesh's own error: flat elements over a wave, second order in their size.
  wavy = { 21 * 21, 400, 1, wavy_area(), relative = 3e-3 },
}

local rows = {}
local function expect(label, got, want, limit)
  rows[#rows + 1] = { label, got, want, [limit and "relative" or "absolute"] = limit or 0 }
end

local function compare(name, mesh, file)
  local report, want = mesh:check(), wanted[name]
  assert(report.ok, file .. ": " .. report.text)
  expect(file .. ": nodes", #mesh.nodes, want[1])
  expect(file .. ": elements", #mesh.elements, want[2])
  expect(file .. ": border lines", report.borders, want[3])
  expect(file .. ": area, m2", report.area, want[4], want.relative)
  local moved = 0
  for i = 1, #mesh.nodes do
    for axis = 1, 3 do moved = math.max(moved, math.abs(mesh.nodes[i][axis] - meshes[name].nodes[i][axis])) end
  end
  expect(file .. ": largest difference of a coordinate", moved, 0)
  local sets = 0
  for _, set in ipairs(meshes[name].sets) do
    sets = sets + (table.concat(mesh:set(set), " ") == table.concat(meshes[name]:set(set), " ") and 1 or 0)
  end
  expect(file .. ": sets alike", sets, #meshes[name].sets)
end

for _, name in ipairs { "strip", "disc", "sleeve", "wavy" } do
  print(meshes[name])
  for _, ending in ipairs { ".msh", ".vtu" } do
    local file = folder .. "/" .. name .. ending
    meshes[name]:write(file)
    if not fabric.checking() then compare(name, fabric.mesh.read(file), file) end
  end
end

fabric.expect(rows)
