-- A square of the blend, held at its corners, falls under its weight for a quarter of a second; colours are the height.
--
--   fabricsh scripts/gallery/drape.lua [out] [elements along an edge]      12; the picture in share/doc: 20
local fabric, out = require "fabric", arg[1] or "out/gallery"
local card = fabric.card("blend"):with { bending = { warp = 15e-6, weft = 15e-6, twist = 7e-6 } }
local test = fabric.lab.drape { card = card, size = 0.5, cells = tonumber(arg[2]) or 12, duration = 0.25 }
if fabric.checking() then return end
local last = test.curve[#test.curve]
print(("the middle hangs %.0f mm down; the ledger's error is %.0e"):format(last.centre * 1e3, test.analysis.energy.error))
fabric.render { file = out .. "/drape.png", run = test.analysis, field = "uz", view = { 30, 25 }, width = 1600, height = 900, smooth = true, edges = false }
-- The balance of energies closes to the rounding of the trapezoidal rule over the steps.
fabric.expect { { "the ledger's error", test.analysis.energy.error, 0, absolute = 1e-4 } }
