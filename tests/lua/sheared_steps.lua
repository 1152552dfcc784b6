-- A sheared sheet buckles, and buckles again in the shape that it has: the next pattern is the near one in steps of any size.
-- warns: the shape has become unstable
local fabric = require "fabric"
local mm = fabric.units.mm

local function sheared(card, size, way, step)
  local mesh = fabric.mesh.rectangle { width = size, height = size, nx = 8, ny = 8 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("bottom", "x y z rotation"):fix("top", "y z rotation"):move("top", { x = fabric.ramp(way, 1) })
  local a = fabric.static { model = m, duration = 1, step = step }:solve()
  local deflection = 0
  for i = 1, #mesh.nodes do deflection = math.max(deflection, math.abs(a:node(i).uz)) end
  return deflection / mm, a.energy.stored
end

for _, case in ipairs { { fabric.card("blend", { bending = "estimated" }), 180 * mm, 8 * mm }, { fabric.card "cloth060", 190 * mm, 9 * mm } } do
  local deflection, energy = sheared(case[1], case[2], case[3], 0.5)
  for _, step in ipairs { 0.2, 0.1 } do
    local w, e = sheared(case[1], case[2], case[3], step)
    fabric.expect {
      { ("%s, steps of %g: deflection, mm"):format(case[1].name, step), w, deflection, relative = 0.01 },
      { "stored energy, J", e, energy, relative = 0.002 },
    }
  end
end
