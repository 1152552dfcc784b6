-- Two sheets, sewn together, are pressed between plates. A hook at every step only looks: steps that contact has shortened grow
-- again as without it. Where a seam is opened and the sheets come through each other beside it, the run says so.
local fabric = require "fabric"

local card = fabric.svk { young = 3e6, poisson = 0.2, density = 500, thickness = 4e-4, bending = { warp = 3e-6, weft = 3e-6, twist = 1e-6 } }
local function sheet(z)
  return fabric.mesh.rectangle { width = 0.05, height = 0.03, nx = 10, ny = 6, origin = { -0.025, -0.015 }, triangles = true }:map(function(x, y)
    return x, y, z * (1.2 - (x / 0.025) ^ 2) + 0.012 + 8e-4 * math.sin(300 * x + 200 * y)
  end)
end
local function plate(z, up)
  local mesh = fabric.mesh.rectangle { width = 0.09, height = 0.06, nx = 7, ny = 5, origin = { -0.045, -0.03 } }:map(function(x, y)
    return x, y, z + 1.5e-3 * math.sin(130 * x) * math.cos(110 * y)
  end)
  if not up then mesh:orient { 0, 0, -1 } end
  return mesh
end

local function pressed(closing, hook, cut)
  local m = fabric.model { bodies = { { name = "a", mesh = sheet(0.006), card = card, warp = 0 }, { name = "b", mesh = sheet(-0.006), card = card, warp = 0 } } }
  m:seam { "a.left", "b.left", over = 0.004, ease = 0.2 }:seam { "a.right", "b.right", over = 0.004, ease = 0.2 }
  local floor = fabric.rigid.surface { mesh = plate(-5e-4, true), name = "floor" }
  local press = fabric.rigid.motion {
    meshes = { plate(0.026), plate(0.026), plate(0.003), plate(0.003), plate(0.02) }, times = { 0, 0.004, 0.004 + closing, 0.004 + 1.15 * closing, 0.03 + closing }, name = "press",
  }
  m:contact { between = { floor, "all" }, friction = 0.3 }:contact { between = { press, "all" }, friction = 0.3 }:contact { self = "all", friction = 0.3 }
  m:gravity { 0, 0, -9.81 }
  local a = fabric.dynamic { model = m, duration = 0.08, damping = { mass = 50 } }
  if hook then a:every("step", function() end) end
  a:advance(0.06)
  if cut then a:cut { set = "a.left" } end
  a:solve()
  local text
  for _, warning in ipairs(a.warnings) do
    if warning.code == "crossing" then text = warning.text end
  end
  return text, #a.steps, a.duration / a.step_size
end

local told, steps, planned = pressed(0.04, false)
local _, hooked = pressed(0.04, true)
assert(not told and steps > 1.2 * planned and math.abs(hooked - steps) < 0.3 * steps)
told = pressed(0.1, false, true)
assert(told:find "edges pass through facets")
