-- The membrane part of the element: what in-plane bending costs, on regular and on distorted meshes, and a wavy plate.
--
-- The slender beam of R.H. MacNeal and R.L. Harder, A proposed standard set of problems to test finite element accuracy,
-- Finite Elements in Analysis and Design 1 (1985) 3-20: 6 x 0.2 x 0.1, E = 1e7, nu = 0.3, unit force at the tip in its
-- plane; beam theory gives 0.1081. Rectangles, parallelograms and trapezoids (edges tilted by 45 degrees); the load is a
-- hundredth, so that displacements stay small. Then a plate with a wave of two thicknesses in two directions, stretched
-- and sheared in its plane: its force over that of the finest mesh.
--
--   fabricsh scripts/verify/membrane.lua
-- warns: is far from what cloth is
-- warns: is far from what cloth is
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"

local function plate(young, nu, thickness)
  return fabric.svk { name = "plate", young = young, poisson = nu, density = 1000, thickness = thickness }
end

-- Tip displacement over 0.1081 per unit force.
local function beam(shape, nx, ny)
  local mesh = fabric.mesh.rectangle { width = 6, height = 0.2, nx = nx, ny = ny }
  local h, tilt = 6 / nx, 0.1 * math.min(1, 6 / nx)
  mesh:map(function(x, y, z)
    local i = math.floor(x / h + 0.5)
    if i == 0 or i == nx then return x, y, z end
    local lean = shape == "parallelograms" and 1 or shape == "trapezoids" and (i % 2 == 0 and 1 or -1) or 0
    return x + lean * tilt * (y - 0.1) / 0.1, y, z
  end)
  local m = fabric.model { mesh = mesh, card = plate(1e7, 0.3, 0.1), warp = 0 }
  m:fix("all", "z rotation"):fix("left", "x y"):force("right", { y = 0.01 })
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  return run:node((ny + 1) * (nx + 1)).uy / 0.01 / 0.1081
end

print "In-plane bending of the slender beam, tip displacement over beam theory"
print(("  %-16s %9s %9s %9s"):format("", "6 x 1", "12 x 2", "24 x 4"))
local ratio = {}
for _, shape in ipairs { "rectangles", "parallelograms", "trapezoids" } do
  ratio[shape] = { beam(shape, 6, 1), beam(shape, 12, 2), beam(shape, 24, 4) }
  print(("  %-16s %9.4f %9.4f %9.4f"):format(shape, table.unpack(ratio[shape])))
end

-- Force of a wavy plate that is stretched or sheared by a thousandth; the waves of the elements are warped.
local function wavy(n, way)
  local mesh = fabric.mesh.rectangle { width = 1, height = 1, nx = n, ny = n }
  mesh:map(function(x, y) return x, y, 0.02 * math.sin(2 * math.pi * x) * math.sin(2 * math.pi * y) end)
  local m = fabric.model { mesh = mesh, card = plate(1e7, 0.3, 0.01), warp = { 1, 0, 0 } }
  m:fix("left", "x y z rotation"):fix("right", (way == "x" and "y" or "x") .. " z rotation")
  m:move("right", { [way] = fabric.ramp(1e-3, 1) })
  local run = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  local x, y = run:reaction "right"
  return way == "x" and x or y
end

print "\nWavy plate, force over that of 48 x 48 elements"
local force = {}
for _, way in ipairs { "x", "y" } do
  force[way] = {}
  for _, n in ipairs { 8, 16, 24, 48 } do force[way][n] = wavy(n, way) end
  local f = force[way]
  print(("  %-10s %2d: %.4f  %2d: %.4f  %2d: %.4f  (48: %.3f N)"):format(way == "x" and "stretched" or "sheared",
    8, f[8] / f[48], 16, f[16] / f[48], 24, f[24] / f[48], f[48]))
end
if fabric.checking() then return end
fabric.expect {
  -- The 6 x 1 elements of T.H.H. Pian and K. Sumihara, International Journal for Numerical Methods in Engineering 20
  -- (1984) 1685-1695, give 0.993, 0.632 and 0.052.
  { "rectangles, 6 x 1", ratio.rectangles[1], 0.993, absolute = 0.001 },
  { "parallelograms, 6 x 1", ratio.parallelograms[1], 0.632, absolute = 0.001 },
  { "trapezoids, 6 x 1", ratio.trapezoids[1], 0.052, absolute = 0.001 },
  { "parallelograms, 24 x 4", ratio.parallelograms[3], 1, absolute = 0.01 },
  { "wavy plate stretched, 16 x 16", force.x[16] / force.x[48], 1, absolute = 0.05 },
  { "wavy plate sheared, 24 x 24", force.y[24] / force.y[48], 1, absolute = 0.03 },
}
