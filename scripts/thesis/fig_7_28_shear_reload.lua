-- Fig. 7-28 of [williams2010]: simple shear of nine elements of the blend, let back a little and loaded again.
--
--   fabricsh scripts/thesis/fig_7_28_shear_reload.lua
--
-- The stress keeps its sign on the way back, so the square goes down and up one line of slope Gu and joins the curve again.
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
chapter.begin("7-28", "simple shear, unload and reload, blend", "fig_7_28")

local card = chapter.card "blend"
local path = { 0.8, 0.76, 1 }
local test = assert(chapter.square(card, path, { out = chapter.folder }))
local rules = chapter.square_by_rules(card, test)
local function at(run, time, name) return chapter.value_at(run, time, name or "S12") end
local function Pg(gamma) return chapter.P(card.shear, gamma / 2) end
if fabric.checking() then return end -- what follows needs what was computed
for i, E12 in ipairs { 0.20, 0.19, 0.25 } do
  chapter.row(("S12 at E12 = %g, MPa"):format(E12), nil, at(test, i) / MPa, at(rules, i) / MPa)
end
chapter.mesh_rows("one leg", fabric.lab.shear { card = card, E12 = 0.25, path = { 1 }, steps = 10 }, { "S12" })
local curves = { chapter.curve(test.curve, "default law", "line", "E12", "S12"),
                 chapter.line(function(E12) return Pg(2 * E12) end, 0.25, "loading curve of the card") }
curves[3] = chapter.curve(rules.curve, "thesis' rules", "points", "E12", "S12")
chapter.plot("reload", "Down and up one steep line, back onto the loading curve.",
             { title = "blend: simple shear, let back a little", xlabel = "E12 (tensor)", ylabel = "S12, MPa", curves = curves })
chapter.render("square", "Nine elements at E12 = 0.25.",
               { vtu = chapter.frame(chapter.folder .. "/square", test), field = "S12" })
chapter.expect {
  { "S12 at 0.20", at(test, 1), Pg(0.40), relative = 1e-9 },
  { "S12 let back to 0.19", at(test, 2), Pg(0.40) - card.shear.unloading / 2 * 0.02, relative = 1e-9 },
  { "S12 at 0.25", at(test, 3), Pg(0.50), relative = 1e-9 },
}
