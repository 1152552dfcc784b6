-- Fig. 7-18 of [williams2010]: the blend's warp pulled to 75 % of 18 mm, let back to 70 %, pulled to 100 %, let go.
--
--   fabricsh scripts/thesis/fig_7_18_reload.lua
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local MPa, mm = fabric.units.MPa, fabric.units.mm
chapter.begin("7-18", "unload and reload, blend, warp", "fig_7_18")

local card = chapter.card "blend"
local yarn, path = card.warp, { 0.75, 0.70, 1, 0 }
local function strip(with, grips, fields)
  fields = fields or {}
  fields.card, fields.grips, fields.path, fields.steps = with, grips, path, 160
  return chapter.try(fabric.lab.uniaxial, fields)
end
local free, clamped = strip(card, "free"), strip(card, "clamped", { out = chapter.folder })
local rules, why = strip(chapter.rules(card), "clamped", chapter.patient {})

local function at(test, time)
  for _, row in ipairs(test.curve) do
    if math.abs(row.time - time) < 1e-9 then return row end
  end
end
if fabric.checking() then return end -- what follows needs what was computed
for i, part in ipairs { 0.75, 0.70, 1 } do
  chapter.row(("S at %g %% of 18 mm, free and clamped ends, MPa"):format(100 * part), nil,
              ("%.3f, %.3f"):format(at(free, i).S / MPa, at(clamped, i).S / MPa), rules and at(rules, i).S / MPa or why)
end
chapter.mesh_rows("clamped, loading", fabric.lab.uniaxial { card = card, unload = false, steps = 20 }, { "S" })
local m, back, top = chapter.strain(13.5 * mm), chapter.strain(12.6 * mm), chapter.strain(18 * mm)
local curves = { chapter.curve(free.curve, "free ends"), chapter.curve(clamped.curve, "clamped ends", "points"),
                 chapter.line(function(E) return chapter.P(yarn, E) end, top, "P(E)") }
if rules then curves[#curves + 1] = chapter.curve(rules.curve, "thesis' rules", "dashed") end
chapter.plot("curves", "Let back a little and pulled again, the strip goes down and up one steep line and joins the backbone where it left it.",
             { title = "blend, warp: 75, 70, 100 % of 18 mm", curves = curves, xlabel = "Green-Lagrange strain E", ylabel = "S, MPa" })
chapter.render("peak", "At 100 % of 18 mm, clamped: even stress but for the corners.",
               { vtu = chapter.frame(chapter.folder .. "/strip", clamped, clamped.peak), field = "S11" })
chapter.expect {
  { "S at 75 %", at(free, 1).S, chapter.P(yarn, m), relative = 1e-9 },
  { "S let back to 70 %", at(free, 2).S, chapter.P(yarn, m) - yarn.unloading * (m - back), relative = 1e-9 },
  { "S reloaded to 100 %", at(free, 3).S, chapter.P(yarn, top), relative = 1e-9 },
  { "dissipated, J", free.analysis.energy.dissipated, free.volume * (chapter.U(yarn, top) - chapter.P(yarn, top) ^ 2 / (2 * yarn.unloading)), relative = 1e-8 },
  { "clamped over free at 100 %, up to 1 % more", at(clamped, 3).S / at(free, 3).S, 1.005, absolute = 0.005 },
}
