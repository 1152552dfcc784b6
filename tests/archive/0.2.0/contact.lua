-- A sheet on an incline: it sticks up to tan(angle) = friction, and slides with g (sin - friction cos) beyond.
local fabric = require "fabric"
local mu, g, thickness, density = 0.3, 9.81, 0.4e-3, 600
local stiffness = 4e8
-- How deep its weight presses it: stiffness comes up over a fifth of the way from half the thickness to the floor.
local onset = 0.2 * (thickness / 2 - thickness * density / 1500 / 2)
local card = fabric.svk { young = 1e7, poisson = 0, density = density, thickness = thickness, name = "sheet" }

print("angle  slid/mm     closed form")
for _, degrees in ipairs { 10, 16, 20, 30, 45 } do
  local angle = math.rad(degrees)
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.05, height = 0.05, nx = 5, ny = 5 }, card = card }
  -- Gravity is tilted in place of the plane.
  local depth = math.sqrt(2 * onset * thickness * density * g * math.cos(angle) / stiffness)
  m:gravity { g * math.sin(angle), 0, -g * math.cos(angle) }
  m:contact { between = { fabric.rigid.plane { point = { 0, 0, depth - thickness / 2 }, normal = { 0, 0, 1 } }, "all" }, friction = mu, stiffness = stiffness }
  local a = fabric.dynamic { model = m, duration = 0.02 }
  a:solve()
  local want = math.max(0, math.sin(angle) - mu * math.cos(angle)) * g * a.time ^ 2 / 2
  local slid = a:node(15).ux
  print(string.format("%5d  %9.5f  %9.5f", degrees, 1e3 * slid, 1e3 * want))
  fabric.expect { { degrees .. " degrees: slid", slid, want, absolute = 5e-6 + 2e-3 * want },
                  { degrees .. " degrees: ledger", a.energy.error, 0, absolute = 1e-2 } }
end
