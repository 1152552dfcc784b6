-- A result does not depend on where cloth lies: a ball drawn over a sheet that is turned in space has the same force, and a flat sheet beyond its
-- buckling load is told `unstable`, also turned and far from the origin. Nor is a turn lost that a step would make by more than half a circle.
local fabric = require "fabric"
local function card(extra)
  return fabric.svk { density = 500, thickness = 0.5e-3, warp = 40e6, weft = 25e6, shear = 9e6, poisson = 0, bending = extra or { warp = 4e-5, weft = 3e-5, twist = 2e-5 } }
end

-- By 137 degrees about an axis along no edge of space.
local function turned(v)
  local n, angle = { 1, 2, -0.7 }, math.rad(137)
  local size = math.sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2)
  for i = 1, 3 do n[i] = n[i] / size end
  local c, s = math.cos(angle), math.sin(angle)
  local along = (1 - c) * (n[1] * v[1] + n[2] * v[2] + n[3] * v[3])
  return { c * v[1] + s * (n[2] * v[3] - n[3] * v[2]) + along * n[1], c * v[2] + s * (n[3] * v[1] - n[1] * v[3]) + along * n[2],
           c * v[3] + s * (n[1] * v[2] - n[2] * v[1]) + along * n[3] }
end
local function as_it_is(v) return v end
local function place(how, far) return function(x, y, z) local p = how { x, y, z } return p[1] + far[1], p[2] + far[2], p[3] + far[3] end end

local function drawn_over(how)
  local side = 0.05
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = 6, ny = 6, origin = { -side / 2, -side / 2, 0 } }
  mesh:map(place(how, { 0, 0, 0 }))
  local m = fabric.model { mesh = mesh, card = card(), warp = how { 1, 0, 0 } }:fix("boundary", "x y z")
  local ball = fabric.rigid.sphere { radius = 0.012, centre = how { 0, 0, 0.0123 }, name = "ball" }
  m:contact { between = { ball, "all" }, friction = 0.3 }
  local v = how { 0.002, 0, -0.005 }
  m:move(ball, { x = fabric.ramp(v[1], 1), y = fabric.ramp(v[2], 1), z = fabric.ramp(v[3], 1) })
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local F, axes = { a:reaction(ball) }, { how { 1, 0, 0 }, how { 0, 1, 0 }, how { 0, 0, 1 } }
  local out = {}
  for i, e in ipairs(axes) do out[i] = F[1] * e[1] + F[2] * e[2] + F[3] * e[3] end
  return out
end
local here, there = drawn_over(as_it_is), drawn_over(turned)
for i = 1, 3 do assert(math.abs(here[i] - there[i]) < 1e-5 * math.abs(here[3]), ("%d: %g %g"):format(i, here[i], there[i])) end
assert(math.abs(there[2]) < 1e-5 * math.abs(there[3]), "across the line of symmetry")

local L, wide = 0.06, 0.012
for _, triangles in ipairs { false, true } do
  local mesh = fabric.mesh.rectangle { width = L, height = wide, nx = 12, ny = 2, triangles = triangles }
  mesh:map(place(turned, { 100, -70, 50 }))
  local m = fabric.model { mesh = mesh, card = card(), warp = turned { 1, 0, 0 } }:fix("left", "x y z rotation")
  local v = turned { -5 * math.pi ^ 2 * 4e-5 * wide / (4 * L ^ 2), 0, 0 }
  m:force("right", { x = fabric.ramp(v[1], 0.05), y = fabric.ramp(v[2], 0.05), z = fabric.ramp(v[3], 0.05) })
  local a = fabric.dynamic { model = m, duration = 0.1, scheme = "implicit", step = 2e-3, damping = { mass = 50 } }
  a:solve()
  local told = false
  for _, w in ipairs(a.warnings) do told = told or w.code == "unstable" end
  assert(told, "unstable is not told")
end

-- Cloth at rest on a floor is pressed by its weight everywhere, however its quadrilaterals are cut.
do
  local sheet = fabric.svk { young = 1e8, poisson = 0, density = 500, thickness = 0.4e-3 }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.03, height = 0.02, nx = 6, ny = 4 }, card = sheet, warp = 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, -0.19e-3 }, normal = { 0, 0, 1 } }
  m:contact { between = { floor, "all" }, friction = 0.3 }:gravity { 0, 0, fabric.ramp(-9.81, 0.5) }
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  for _, p in ipairs(a:field "contact_pressure") do assert(math.abs(p - 1.962) < 1e-4, p) end
end

-- Twisted by more than a turn in what was asked to be one step.
local function twisted(degrees, step)
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.01, nx = 20, ny = 2, origin = { 0, -0.005 } }
  local soft = fabric.svk { warp = 1e7, weft = 1e7, shear = 5e6, poisson = 0, density = 500, thickness = 0.5e-3, bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6 } }
  local m = fabric.model { mesh = mesh, card = soft, warp = 0 }:fix("left", "x y z rotation")
  m:turn("right", { axis = { 1, 0, 0 }, angle = type(degrees) == "number" and fabric.ramp(degrees, 1) or degrees, centre = { 0.1, 0, 0 } })
  return fabric.static { model = m, duration = 1, step = step }:solve().energy.stored
end
local slowly = twisted(360, 0.125)
for _, angle in ipairs { 360, function(t) return 360 * t end } do
  local once = twisted(angle, 1)
  assert(math.abs(once / slowly - 1) < 1e-6, ("%g %g"):format(once, slowly))
end
