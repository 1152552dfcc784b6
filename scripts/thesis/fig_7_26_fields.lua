-- Fig. 7-26 of [williams2010]: the blend with its warp at 30 degrees from the pull is not strained alike everywhere, at the
-- beginning and near the largest displacement.
--
--   fabricsh scripts/thesis/fig_7_26_fields.lua
--
-- Ends free to contract: sliding ends can't hold back the shear that the slanted yarns cause, so the strip leans and the field
-- is not uniform, though nothing is clamped. Whether a field is a checkerboard is measured: its part along (-1)^(i+j).
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
chapter.begin("7-26", "fields of the strip at 30 degrees, blend", "fig_7_26")

local card = chapter.card "blend"
local test = fabric.lab.bias { card = card, angle = 30, cells = { 6, 18 }, unload = false, steps = 40, out = chapter.folder }
local function spread(name)
  local values, low, high = test.analysis:field(name), math.huge, -math.huge
  for _, v in ipairs(values) do low, high = math.min(low, v), math.max(high, v) end
  return low, high, chapter.checkerboard(values, 6)
end
local checks = {}
for _, name in ipairs { "E11", "E22", "E12", "S11", "S22", "S12" } do
  local low, high, board = spread(name)
  local unit = name:sub(1, 1) == "S" and MPa or 1
  chapter.row(name .. " at 20 mm: smallest, largest" .. (unit == MPa and ", MPa" or ""), "not uniform", ("%.3f, %.3f"):format(low / unit, high / unit))
  checks[#checks + 1] = { name .. ": checkerboard, part of the largest", board, 0, absolute = 0.03 } -- a checkerboard alternates by a good part of the field
end
chapter.mesh_rows("30 degrees, free, 20 mm", fabric.lab.bias { card = card, angle = 30, unload = false, steps = 20 }, { "S", "S_centre", "E12_centre", "E_centre" })
local begin = chapter.frame(chapter.folder .. "/strip", test, chapter.at_time(test.curve, 0.10))
local last = chapter.frame(chapter.folder .. "/strip", test, chapter.at_time(test.curve, 0.95))
for _, field in ipairs { "E11", "E12", "S11" } do
  chapter.render(field, field == "E12" and "The shear is largest in the middle and smooth from element to element." or
                   field == "E11" and "The warp is stretched along the diagonal that it spans from corner to corner." or
                   "The stress of the warp follows: a band along the diagonal, peaks at two corners.",
                 { vtu = { begin, last }, labels = { "(a) 2 mm", "(b) 19 mm" }, field = field })
end
chapter.plot("ways", "Force over area and the element average agree; the middle carries a tenth more.",
             { title = "blend, 30 degrees: stress three ways", xlabel = "Green-Lagrange strain of the grips", ylabel = "S, MPa",
               curves = { chapter.curve(test.curve, "force over area"), chapter.curve(test.curve, "average over elements", "points", "E", "S_average"),
                          chapter.curve(test.curve, "middle", "line", "E", "S_centre"),
                          chapter.line(function(E) return E > 0 and fabric.point(card):uniaxial(30, E).S or 0 end, test.peak.E, "material point") } })
local low, high = spread "E12"
checks[#checks + 1] = { "E12 is not uniform: spread over its mean above 5 % (1: yes)", (high - low) / test.peak.E12_average > 0.05 and 1 or 0, 1, relative = 1e-12 }
chapter.expect(checks)
