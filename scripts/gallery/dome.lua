-- A square of the blend is pressed through a die by a double dome: its yarns shear most beside the domes.
--
--   fabricsh scripts/gallery/dome.lua [out] [elements along]      14; the picture in share/doc: 20
-- warns: carries without folding within it
-- warns: inertia is part of the forces
local fabric, out = require "fabric", arg[1] or "out/gallery"
local mm, cells = fabric.units.mm, tonumber(arg[2]) or 14
local formed = fabric.lab.form { card = fabric.card("blend", { bending = "estimated" }), blank = { 200 * mm, 160 * mm },
                                 punch = { shape = "double dome", radius = 32 * mm, length = 50 * mm, waist = 40 * mm },
                                 die = { edge = 12 * mm }, holder = { force = 100 }, stroke = 26 * mm, cells = cells, speed = 2.5 }
if fabric.checking() then return end
print(formed.report)
fabric.render { file = out .. "/dome.png", run = formed.analysis, field = "shear_angle", view = { 35, -40 }, width = 1200, height = 675, edges = true, bodies = "none" }
local place = formed.angles.place
fabric.expect { { "most shear lies off both axes of symmetry (1: yes)", math.abs(place.X) > 10 * mm and math.abs(place.Y) > 5 * mm and 1 or 0, 1, absolute = 0 },
                { "the ledger balances, of the work", formed.curve[#formed.curve].error, 0, absolute = 0.01 } }
