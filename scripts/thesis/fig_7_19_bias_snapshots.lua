-- Fig. 7-19 of [williams2010]: the blend's bias strip at the start, at 20 mm, and let back until the grip lets go; the ends free
-- as in the thesis, and clamped as in a laboratory.
--
--   fabricsh scripts/thesis/fig_7_19_bias_snapshots.lua
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
chapter.begin("7-19", "snapshots of the bias test, blend", "fig_7_19")

local card = chapter.card "blend"
local widths, checks, curves = {}, {}, {}
for _, grips in ipairs { "free", "clamped" } do
  local folder = chapter.folder .. "/" .. grips
  local test = fabric.lab.bias { card = card, grips = grips, cells = { 6, 18 }, steps = 80, out = folder }
  local frames = {}
  for i, row in ipairs { test.curve[1], test.peak, test.curve[#test.curve] } do frames[i] = chapter.frame(folder .. "/strip", test, row) end
  chapter.render(grips, grips == "free" and "Free ends: the strip narrows as a whole and shears alike everywhere."
                   or "Clamped ends: the ends keep their width and stay nearly unsheared, the middle takes the shear.",
                 { vtu = frames, labels = { "(a) start", "(b) 20 mm", "(c) grip lets go" }, field = "E12" })
  chapter.row(("grip strain left where the grip lets go, ends %s"):format(grips), nil, test.curve[#test.curve].E)
  curves[#curves + 1] = chapter.curve(test.curve, "ends " .. grips, "line", "E_average", "E_lateral", 1)
  chapter.mesh_rows("20 mm, " .. grips, fabric.lab.bias { card = card, grips = grips, unload = false, steps = 20 }, { "E_lateral", "E12_centre" })
  widths[grips] = test.peak.E_lateral
  checks[#checks + 1] = { grips .. ": lets go (1: yes)", test.analysis.stopped == "the grip lets go" and 1 or 0, 1, relative = 1e-12 }
  checks[#checks + 1] = { grips .. ": checkerboard in E12, part of the largest", chapter.checkerboard(test.analysis:field "E12", 6), 0, absolute = 0.01 }
  local e = test.analysis.energy
  -- External work is summed by trapezoids over the steps: their square.
  checks[#checks + 1] = { grips .. ": stored and dissipated over the work done", e.internal / e.external, 1, relative = 5e-3 }
end
-- Uniaxial stress at 45 degrees of the material point.
local point = fabric.point(card):uniaxial(45, chapter.strain(0.020))
checks[#checks + 1] = { "free: strain across over that of the material point", widths.free / point.E_lateral, 1, relative = 0.01 } -- unequal yarns
curves[#curves + 1] = chapter.line(function(E) return E > 0 and fabric.point(card):uniaxial(45, E).E_lateral or 0 end, point.E, "material point", 1)
chapter.plot("curve", "Strain across against strain along: nearly as much across as along, the yarns turning like scissors.",
             { title = "blend, bias 45", xlabel = "strain along the pull", ylabel = "strain across", curves = curves })
chapter.expect(checks)
