-- Fig. 7-27 of [williams2010]: cyclic simple shear of nine elements of the blend.
--
--   fabricsh scripts/thesis/fig_7_27_shear_cycle.lua
--
-- gamma = 2 E12 goes to 0.4, -0.4 and 0.5. First leg: Pg(gamma). On each way back the Gu line down to zero stress; from there
-- a virgin branch the other way in the relative strain. Weft and warp are not stretched by the same: E22 = gamma^2 / 2.
-- warns: INSIDE the tested range
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
chapter.begin("7-27", "cyclic simple shear, blend", "fig_7_27")

local card = chapter.card "blend"
local path = { 0.8, -0.8, 1 }
local test = assert(chapter.square(card, path, { out = chapter.folder }))
local rules = chapter.square_by_rules(card, test)
local engineering = chapter.square(card:with { shear = { measure = "engineering" } }, path)
local function at(run, time, name) return chapter.value_at(run, time, name or "S12") end
local function Pg(gamma) return chapter.P(card.shear, gamma / 2) end
local Gu = card.shear.unloading / 2
local back = 0.8 - Pg(0.4) / Gu           -- from 0.4 to -0.4: reverse strain past zero stress
local third = 0.5 + 0.4 - Pg(back) / Gu   -- from -0.4 to 0.5 likewise
if fabric.checking() then return end -- what follows needs what was computed
for i, E12 in ipairs { 0.2, -0.2, 0.25 } do
  chapter.row(("S12 at E12 = %g, MPa; from the edges, average, centre"):format(E12), nil,
              ("%.4f %.4f %.4f"):format(at(test, i) / MPa, at(test, i, "S12_average") / MPa, at(test, i, "S12_centre") / MPa),
              at(rules, i) / MPa)
  chapter.row("  table 7.3 read as engineering shear", nil, engineering and at(engineering, i) / MPa or "no convergence")
end
chapter.row("force over area without its part gamma S22 off, at 0.2, MPa", nil, at(test, 1, "S_uncorrected") / MPa)
chapter.mesh_rows("one leg", fabric.lab.shear { card = card, E12 = 0.2, path = { 1 }, steps = 10 }, { "S12", "S12_centre" })
local curves = { chapter.curve(test.curve, "default law", "line", "E12", "S12") }
curves[2] = chapter.curve(rules.curve, "thesis' rules", "dashed", "E12", "S12")
chapter.plot("cycle", "Straight unloading to zero stress, then the same curved branch the other way, counted from there.",
             { title = "blend: cyclic simple shear, nine elements", xlabel = "E12 (tensor)", ylabel = "S12, MPa", curves = curves })
chapter.render("square", "Nine elements in simple shear to and fro: uniform.",
               { vtu = { chapter.frame(chapter.folder .. "/square", test, chapter.at_time(test.curve, 1)), chapter.frame(chapter.folder .. "/square", test, chapter.at_time(test.curve, 2)) }, labels = { "E12 = 0.2", "E12 = -0.2" },
                 field = "S12" })
chapter.expect {
  { "S12 at 0.2", at(test, 1), Pg(0.4), relative = 1e-9 },
  { "S12 at -0.2", at(test, 2), -Pg(back), relative = 1e-9 },
  { "S12 at 0.25", at(test, 3), Pg(third), relative = 1e-9 },
  { "edges against the average", at(test, 3) / at(test, 3, "S12_average"), 1, relative = 1e-8 },
  { "force over area is S12 + gamma S22", at(test, 1, "S_uncorrected"), Pg(0.4) + 0.4 * at(test, 1, "S22_average"), relative = 1e-9 },
}
