-- A sleeve of muslin, blown up a little and turned at one end by 20 degrees: its yarns along and around shear everywhere alike, and
-- the end has to be held by a moment.
local fabric, out = require "fabric", arg[1] or "out/gallery"
local mm, cells = fabric.units.mm, tonumber(arg[2]) or 12
local mesh = fabric.mesh.cylinder { radius = 40 * mm, length = 160 * mm, around = 2 * cells, along = cells }
local model = fabric.model { mesh = mesh, card = fabric.card "muslin", warp = { 0, 0, 1 } }
model:fix("bottom", "x y z rotation"):pressure(fabric.ramp(1e3, 0.2))
model:turn("top", { axis = { 0, 0, 1 }, angle = fabric.history { { 0, 0 }, { 0.2, 0 }, { 1, 20 } }, centre = { 0, 0, 160 * mm } })
local run = fabric.static { model = model, duration = 1, step = 0.1 }
run:solve()
if fabric.checking() then return end
local least, most = math.huge, 0
for _, angle in ipairs(run:field "shear_angle") do least, most = math.min(least, math.abs(angle)), math.max(most, math.abs(angle)) end
print(("shear angle %.1f to %.1f degrees"):format(least, most))
fabric.render { file = out .. "/sleeve.png", run = run, field = "tension_weft", view = { 30, 20 }, width = 1600, height = 900, smooth = true, edges = false }
-- Without the pressure the angle would be atan(r phi / l) everywhere.
local flat = math.deg(math.atan(40 * math.rad(20) / 160))
fabric.expect { { "mean shear angle, degrees", math.abs(run:mean "shear_angle"), flat, relative = 0.05 } }
