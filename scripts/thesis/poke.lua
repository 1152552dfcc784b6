-- Figs. 7-32 to 7-37 of [williams2010]: a sheet of 2 x 2 m, its rim held, is poked from below and let down. Shear hysteresis on.
--
--   fabricsh scripts/thesis/poke.lua [card]
--
-- Beside the default law: St. Venant-Kirchhoff, which comes back as it was, and the thesis' own set-up with shear hysteresis on
-- and off, which makes energy. Elements 207 and 271 stand one away from the punch along warp and weft. The thesis states no ramp,
-- gravity or punch rotations: the punch is at 0.4 (1 - cos 4 pi t) / 2 m until 0.5 s and rests at 0 until 1 s.
-- Elements of 100 mm are far wider than the folds of this cloth.
-- warns: what its cloth carries without folding within it
-- warns: nine measured cloths in ten have 1 to 70 uN.m
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
-- warns: the card was tested to
-- warns: turned inside out
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local ledger = dofile(here .. "ledger.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
local card = chapter.card(arg[1] or "blend")
chapter.begin("7-33..36", "poke, " .. card.name, "poke")

local function poke(with, fields)
  fields = fields or {}
  fields.card, fields.duration = with, fields.duration or 1
  return fabric.lab.poke(fields)
end
local function sag(test, time) return chapter.at_time(test.curve, time).lowest * 1e3 end
local test = poke(card, { out = chapter.folder, every = 10e-3 })
local svk = poke(chapter.svk(card))
if fabric.checking() then return end
local peak = { ledger.largest(test.curve, "S11") / MPa, ledger.largest(test.curve, "S22") / MPa }
chapter.row("peak S11 in element 207 and S22 in element 271, MPa: fabric", "fabric above SVK", ("%.3g %.3g"):format(peak[1], peak[2]))
chapter.row("  SVK", nil, ("%.3g %.3g"):format(ledger.largest(svk.curve, "S11") / MPa, ledger.largest(svk.curve, "S22") / MPa))
chapter.row("lowest node below the rim at 0.5 s and 1 s, mm: fabric", "stays stretched, wrinkles", ("%.0f %.0f"):format(sag(test, 0.5), sag(test, 1)))
chapter.row("  SVK", "recovers", ("%.0f %.0f"):format(sag(svk, 0.5), sag(svk, 1)))
ledger.row("poke", test.curve, "shear hysteresis off")
ledger.plot("ledger", card.name .. ": poke", test.curve)

-- The thesis' own set-up: its ledger as law="thesis" keeps it, every fall of dissipation summed as created.
local curves = {}
for i, on in ipairs { true, false } do
  local own = poke(card:with { law = "thesis", transverse = "follow", shear_hysteresis = on },
                   { duration = 0.5, step = 1e-5, ledger_limit = 1e9, strict = false })
  local last = own.curve[#own.curve]
  chapter.row("energy made by the thesis' rules, shear hysteresis " .. (on and "on" or "off") .. ", J", on and "unstable" or "as published", nil,
              ("%.3g, external work %.3g"):format(last.created, last.external))
  curves[i] = { x = {}, y = {}, label = "shear hysteresis " .. (on and "on" or "off"), style = "line" }
  for k, r in ipairs(own.curve) do curves[i].x[k], curves[i].y[k] = r.time, math.log(math.max(r.created, 1e-6), 10) end
end
chapter.plot("created", "Energy that the thesis' rules make out of nothing, by powers of ten; the external work is of the order of 100 J.",
             { title = card.name .. ": poke with the thesis' rules", xlabel = "t, s", ylabel = "log10 of energy made, J", curves = curves })
for name, pair in pairs { element_207 = { "E11", "S11" }, element_271 = { "E22", "S22" } } do
  chapter.plot(name, "Stress against strain beside the punch: the fabric stiffens and unloads steeply, SVK is a line.",
               { title = card.name .. ": " .. name:gsub("_", " "), xlabel = pair[1], ylabel = pair[2] .. ", MPa",
                 curves = { chapter.curve(test.curve, "fabric", "line", pair[1], pair[2]), chapter.curve(svk.curve, "SVK", "dashed", pair[1], pair[2]) } })
end
local frames, labels = {}, {}
for k, time in ipairs { 0, 0.15, 0.25, 0.35, 0.5, 1 } do
  local row = chapter.at_time(test.curve, time)
  frames[k], labels[k] = chapter.frame(chapter.folder .. "/poke", test, row), ("%.2f s"):format(row.time)
end
chapter.render("frames", "Poked up, let down: what was stretched hangs in folds about the punch.",
               { vtu = frames, labels = labels, field = "E22", view = { 30, 25 }, columns = 3, edges = false })
local top, last = chapter.at_time(test.curve, 0.25), test.curve[#test.curve]
chapter.expect {
  { "the punch is at the top at 0.25 s, m", top.height, 0.4, absolute = 1e-12 },
  { "the punch is back, m", last.height, 0, absolute = 1e-12 },
  { "the ledger's error", last.error, 0, absolute = 1e-5 },
  { "SVK dissipates nothing, J", svk.curve[#svk.curve].dissipated, 0, absolute = 0 },
  { "SVK's ledger", svk.curve[#svk.curve].error, 0, absolute = 1e-3 },  -- fast vibrations that nothing damps, at 0.7 of the stable step
  { "the fabric hangs lower than SVK at the end", sag(test, 1) > 1.5 * sag(svk, 1) and 1 or 0, 1, absolute = 0 },
}
