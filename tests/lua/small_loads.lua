-- However small a load is beside the rounding of forces, the sheet goes with it: the deflection of a clamped plate over its pressure is the same from a
-- hundredth of the thickness down to a thousand-millionth of it, in one step and in four.
local fabric = require "fabric"
local highest = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).highest
local side, t, E = 0.2, 0.25e-3, 4e8
local function softness(triangles, pressure, step)
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = 32, ny = 32, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = fabric.svk { young = E, poisson = 0.3, density = 500, thickness = t, name = "plate" }, warp = 0, points = 2 }
  m:fix("boundary", "x y z rotation"):pressure(fabric.ramp(pressure, 1))
  local a = fabric.static { model = m, duration = 1, step = step }:solve()
  return highest(a) / pressure
end
local checks = {}
for _, triangles in ipairs { false, true } do
  local want = softness(triangles, 7e-4, 1)
  for _, pressure in ipairs { 7e-6, 7e-8, 7e-11 } do
    for _, step in ipairs { 1, 0.25 } do
      checks[#checks + 1] = { ("%s, %g Pa, step %g"):format(triangles and "triangles" or "quadrilaterals", pressure, step), softness(triangles, pressure, step), want, relative = 1e-3 }
    end
  end
end
fabric.expect(checks)
