-- Sheets of yarns that slide on each other take many iterations in a step of any size: implicit steps stay as long as asked for, but for those
-- that fail. The upper one slides down the lower one, which rests: v = g (sin - mu cos) t.
local fabric = require "fabric"
local mm = fabric.units.mm
local angle, mu, duration, step = math.rad(30), 0.2, 0.05, 5e-3
local rows = {}
for _, name in ipairs { "denim", "muslin" } do
  local card = fabric.card(name, { bending = "estimated" })
  local function sheet(size, n, x, y, z) return fabric.mesh.rectangle { width = size, height = size, nx = n, ny = n, origin = { x, y, z } } end
  local lower, upper = sheet(0.1, 8, 0, 0, card.thickness / 2), sheet(0.07, 7, 13 * mm, 11 * mm, 1.5 * card.thickness)
  local m = fabric.model { bodies = { { name = "lower", mesh = lower, card = card, warp = 0 }, { name = "upper", mesh = upper, card = card, warp = 0 } } }
  local plane = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:contact { between = { "lower", "upper" }, friction = mu }:contact { between = { plane, "lower" }, friction = 0.6 }
  m:gravity { 9.81 * math.sin(angle), 0, -9.81 * math.cos(angle) }
  local a = fabric.dynamic { model = m, duration = duration, scheme = "implicit", step = step }:solve()
  local v, speed, first = a:field "velocity", 0, #lower.nodes
  for i = 1, #upper.nodes do speed = speed + v[first + i][1] / #upper.nodes end
  print(("%s: %d steps, %.5f m/s"):format(name, #a.steps, speed))
  rows[#rows + 1] = { name .. ": speed", speed, 9.81 * (math.sin(angle) - mu * math.cos(angle)) * duration, relative = 5e-3 }
  rows[#rows + 1] = { name .. ": steps over those asked for, at most", math.max(#a.steps / (duration / step), 2), 2, absolute = 0 }
end
fabric.expect(rows)
