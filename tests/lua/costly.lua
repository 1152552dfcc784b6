-- An explicit run whose step contact keeps far below the planned one says once, after a thousand such steps, how many are left: a sheet between a floor and
-- a plate of a mass that a force presses down until the barrier of contact is as stiff as that. Its stiffness grows with the inverse cube of the height above the smallest
-- distance, and the step with the root of its inverse.
-- warns: guard
-- warns: a barrier keeps them apart
-- warns: times as short as planned
local fabric = require "fabric"
local mm = fabric.units.mm

local function pressed(force)
  local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 2, ny = 2 }
  local nodes = {}
  for _, z in ipairs { 0.3 * mm, 10 * mm } do
    for _, at in ipairs { { -0.02, -0.02 }, { 0.04, -0.02 }, { 0.04, 0.04 }, { -0.02, 0.04 } } do nodes[#nodes + 1] = { at[1], at[2], z } end
  end
  local box = fabric.mesh { nodes = nodes, elements = { { 1, 4, 3, 2 }, { 5, 6, 7, 8 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 4, 8, 7 }, { 4, 1, 5, 8 } } }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), points = 1, warp = 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, -0.2 * mm }, normal = { 0, 0, 1 }, name = "floor" }
  local plate = fabric.rigid.surface { mesh = box, name = "plate", mass = 1 }
  m:contact { between = { floor, "all" } }:contact { between = { plate, "all" } }
  m:fix(plate, "x y rotation"):damper(plate, { z = 2e4 }):force(plate, { z = fabric.history { { 0, 0 }, { 5e-3, -force }, { 1, -force } } })
  local a = fabric.dynamic { model = m, duration = 0.5, ledger_limit = 100 }
  a:advance(5.3e-3)
  return a
end

local said, lines = 0, {}
local a = pressed(8000)
for _, warning in ipairs(a.warnings) do
  lines[#lines + 1] = warning.text
  local step, times, time, left, more = warning.text:match "kept the step at (%S+) s, (%d+) times as short as planned, for 1000 steps by time (%S+) s .* the (%S+) s that are left take (%S+) more"
  if step then
    said = said + 1
    fabric.expect {
      { "the step over the planned one", a.step_size / tonumber(times), tonumber(step), relative = 1e-4 },
      { "what is left, s", 0.5 - tonumber(time), tonumber(left), relative = 1e-4 },
      { "steps that are left", tonumber(left) / tonumber(step), tonumber(more), relative = 0.05 },
    }
    assert(tonumber(times) >= 32)
    -- The stiffness rises over the first fifth of the range, and the barrier begins three quarters down.
    local stiffness, shorter, pressure, carried = warning.text:match "stiffness=(%S+) in m:contact, with steps of (%S+) s: these nodes are pressed with (%S+) Pa, and contact as it is carries (%S+) Pa"
    local law, range = 2.28347e9, 0.19 * mm - 0.0747333 * mm
    fabric.expect {
      { "pressure before the barrier, Pa", law * range * (0.75 - 0.1), tonumber(carried), relative = 0.05 },
      { "stiffness that is proposed, Pa/m", 2 * law * tonumber(pressure) / tonumber(carried), tonumber(stiffness), relative = 0.08 },
      { "steps with it, s", a.step_size * math.sqrt(law / tonumber(stiffness)), tonumber(shorter), relative = 0.05 },
    }
    assert(warning.text:find("fixed gap", 1, true) and tonumber(shorter) > tonumber(step))
  end
end
assert(said == 1, table.concat(lines, "\n"))
for _, warning in ipairs(pressed(40).warnings) do assert(not warning.text:find("as short as planned", 1, true), warning.text) end
