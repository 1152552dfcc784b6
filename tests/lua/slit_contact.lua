-- Sheets with a slit and self-contact: both sides lie at the same place, where rounding does not make neighbours of them.
local fabric = require "fabric"

local function pulled(far, triangles, scheme, opens)
  local mesh = fabric.mesh.rectangle { width = 0.08, height = 0.04, nx = 16, ny = 8, triangles = triangles }
  mesh:slit { from = { 0.04, 0 }, to = { 0.04, far } }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), warp = 0 }
  m:contact { self = "all", friction = 0.3 }:fix("left", "x y z rotation"):fix("right", "y z rotation")
  m:move("right", { x = function(t) return opens * (1 - math.cos(100 * math.pi * t)) / 2 end })
  return fabric.dynamic { model = m, duration = 0.01, scheme = scheme, step = scheme == "implicit" and 1e-3 or nil, damping = { mass = 50 } }
end

for _, far in ipairs { 0.02, 0.035, 0.04 } do
  for _, triangles in ipairs { false, true } do
    for _, scheme in ipairs { "explicit", "implicit" } do
      local a = pulled(far, triangles, scheme, 0.5e-3):solve()
      assert(a.time == a.duration and a.energy.error < 1e-2, scheme)
      assert(scheme ~= "explicit" or #a.steps < 1.2 * a.duration / a.step_size)
    end
  end
end
