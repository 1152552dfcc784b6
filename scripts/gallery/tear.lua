-- A trouser test: the legs of a cut specimen are pulled apart, and it tears on between them. Legs that hardly stretch tear at half of the energy
-- that breaking the yarns costs per metre.
-- warns: the strength is lowered
-- warns: of the work, expected at most 1 % together
local fabric, out = require "fabric", arg[1] or "out/gallery"
local mm = fabric.units.mm
local energy = 20 -- J/m; a typical value, not measured on a cloth
local card = fabric.svk { name = "sheet", warp = 1e8, weft = 6e7, shear = 3e7, poisson = { 0, 0 }, density = 500, thickness = 0.5 * mm, through_thickness = true }
local test = fabric.lab.tear { card = card:with { rupture = { weft = { strength = 15e3, energy = energy } } }, h = 2 * mm, width = 30 * mm, leg = 24 * mm, tear = 32 * mm, speed = 0.8 }
if fabric.checking() then return end
print(("mean force %.2f N, half of the energy %.2f N; mean of peaks %.2f N"):format(test.mean, energy / 2, test.mean_of_peaks))
fabric.render { file = out .. "/tear.png", run = test.analysis, field = "rupture_weft", view = { -60, 15 }, width = 1600, height = 1200 }
fabric.expect { { "mean force of the tear, N", test.mean, energy / 2, relative = 0.03 } }
