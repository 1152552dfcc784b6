-- Pictures of contact: a ball on four fabrics, and cloth over a rod.
--
--   fabricsh scripts/contact/pictures.lua [out] [elements along an edge]      6; the pictures in share/doc: 16
local fabric, out, cells = require "fabric", arg[1] or "out/contact", tonumber(arg[2] or 6)
local rows, mm = {}, fabric.units.mm

-- Four fabrics, 16 ms after the ball of 0.1 kg touched them with 1.4 m/s.
local runs, labels = {}, {}
for i, name in ipairs { "blend", "denim", "duck", "muslin" } do
  local card = fabric.card(name, { bending = "estimated" })
  local test = fabric.lab.ball_drop { card = card, mass = 0.1, height = 0.1, cells = cells, duration = 0.016, every = 0.004, out = out .. "/" .. name }
  runs[i] = test.analysis
  labels[i] = string.format("%s: %.1f mm deep, %.0f N", name, 1e3 * test.depth, test.force)
  rows[i] = { name .. ": nothing passes, the ledger is closed (1: yes)", test.gap > 0 and test.analysis.energy.error < 1e-2 and 1 or 0, 1, absolute = 0 }
end

-- A sheet of muslin is let down over a rod and hangs to both sides.
local side, radius, card = 0.2, 0.02, fabric.card("muslin", { bending = "estimated" })
local mesh = fabric.mesh.rectangle { width = side, height = side, nx = cells, ny = cells, origin = { -side / 2, -side / 2, 0 } }
local m = fabric.model { mesh = mesh, card = card, points = 1 }
local low = -radius - card.thickness / 2
local rod = fabric.rigid.cylinder { radius = radius, from = { -0.01, -0.6 * side, low }, to = { -0.01, 0.6 * side, low } }
m:contact { between = { rod, "all" }, friction = 0.6 }:contact { self = "all", friction = 0.4 }:gravity { 0, 0, -9.81 }
local a = fabric.dynamic { model = m, duration = 0.25, damping = { mass = 15 } }
a:solve()
rows[#rows + 1] = { "edge: the gap stays open, the ledger is closed (1: yes)", a:gap() > 0 and a.energy.error < 1e-2 and 1 or 0, 1, absolute = 0 }

if not fabric.checking() then
  fabric.render { file = out .. "/contact_ball_drop.png", run = runs, field = "uz", labels = labels, columns = 2, view = { 30, 25 },
                  size = { 120 * mm, 90 * mm }, dpi = 200, axes = false, edges = false, smooth = true }
  fabric.render { file = out .. "/contact_edge.png", run = a, field = "uz", view = { 30, 20 }, width = 1200, height = 825, smooth = true }
end
fabric.expect(rows)
