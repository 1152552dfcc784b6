-- A sheet is let down over a cylinder and hangs to both sides of it.
--
--   fabricsh scripts/contact/edge.lua            8 x 8 elements
--   fabricsh scripts/contact/edge.lua 30 out     30 x 30, with a series for ParaView in out
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local cells, out = tonumber(arg[1] or 8), arg[2]
local side, radius, card = 0.2, 0.02, fabric.card "blend"
local mesh = fabric.mesh.rectangle { width = side, height = side, nx = cells, ny = cells, origin = { -side / 2, -side / 2, 0 } }
local m = fabric.model { mesh = mesh, card = card }
local rod = fabric.rigid.cylinder { radius = radius, from = { 0, -side, -radius - card.thickness / 2 }, to = { 0, side, -radius - card.thickness / 2 } }
m:contact { between = { rod, "all" }, friction = 0.4 }:contact { self = "all", friction = 0.4 }:gravity { 0, 0, -9.81 }
local a = fabric.dynamic { model = m, duration = 0.03, damping = { mass = 10 } }
if out then a:vtk(out .. "/edge", { every = 2e-3 }) end
local gap = math.huge
a:every(1e-3, function(run) gap = math.min(gap, (run:gap())) end)
a:solve()
local _, _, lift = a:reaction(rod)
local weight = side ^ 2 * card.thickness * card.density * 9.81
local left, right, middle = a:node(1), a:node(cells + 1), a:node(cells // 2 + 1)
print(string.format("the rod carries %.3g of %.3g N; the edges hang %.2f and %.2f mm down, the middle %.3f mm", lift, weight, -1e3 * left.uz, -1e3 * right.uz, -1e3 * middle.uz))
fabric.expect {
  { "the gap stays open", gap > 0 and 1 or 0, 1, absolute = 0 },
  { "the middle stays on the rod", middle.uz, 0, absolute = card.thickness },
  { "both sides fall alike", left.uz, right.uz, relative = 1e-3 },
  { "they fall no faster than free", -left.uz < 9.81 * a.time ^ 2 / 2 and 1 or 0, 1, absolute = 0 },
  { "the ledger is closed", a.energy.error, 0, absolute = 1e-2 },
}
