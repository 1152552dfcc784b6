-- A strip of blend cut at 45 degrees, clamped and pulled by 20 mm: the angle between the yarns changes most in the middle, little at the
-- clamps.
-- warns: the card was tested to
local fabric, out = require "fabric", arg[1] or "out/gallery"
local test = fabric.lab.bias { card = fabric.card "blend", grips = "clamped", unload = false, steps = 10, cells = { 10, 30 } }
if fabric.checking() then return end
local near, between, middle = test:zone_mean "shear_angle"
print(("shear angle, degrees: %.1f at the clamps, %.1f between, %.1f in the middle"):format(near, between, middle))
fabric.render { file = out .. "/bias.png", run = test.analysis, field = "shear_angle", width = 1600, height = 900, smooth = true, edges = false }
fabric.expect { { "the middle shears most, then between (1: yes)", near < between and between < middle and 1 or 0, 1, absolute = 0 } }
