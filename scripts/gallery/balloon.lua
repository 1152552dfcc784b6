-- A round sheet of duck, its rim held, blown up: warp and weft carry unequal shares of the pressure.
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric, out = require "fabric", arg[1] or "out/gallery"
local mesh = fabric.mesh.disk { radius = 0.1, cells = tonumber(arg[2]) or 6 }
local card = fabric.card "duck"
local model = fabric.model { mesh = mesh, card = card, warp = 0 }
model:fix("boundary", "x y z"):pressure(fabric.ramp(20e3, 1))
local run = fabric.static { model = model, duration = 1, step = 0.25 }
run:solve()
if fabric.checking() then return end
local top = 0
for i = 1, #mesh.nodes do top = math.max(top, run:node(i).uz) end
local warp, weft = run:mean "tension_warp", run:mean "tension_weft"
print(("%.1f mm high; mean tension %.0f N/m in the warp, %.0f N/m in the weft"):format(top * 1e3, warp, weft))
fabric.render { file = out .. "/balloon.png", run = run, field = "tension_weft", view = { 30, 25 }, width = 1600, height = 900, smooth = true, edges = false }
-- Tension times curvature carries the pressure; a cap of this height has the curvature 2 h / a^2, were it a shallow sphere.
fabric.expect { { "tensions, N/m, against p a^2 / 2 h", warp + weft, 20e3 * 0.1 ^ 2 / (2 * top), relative = 0.05 } }
