-- Table 7.4 of [williams2010]: how large the ratios of duck and muslin may be before the thesis' law over-predicts, clamped ends,
-- 27 elements.
--
--   fabricsh scripts/thesis/table_7_4_ratios.lua
--
-- Both ratios of a fabric are scaled together, from nothing to the measured ones. The default law stays near P(E) all the way,
-- for its coupling never exceeds what the ratios and the softer initial modulus allow; the thesis' coupling C12 ~ nu21 D1 grows with the
-- stiffening yarn, and what clamped ends hold back comes out as stress along the pull.
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
chapter.begin("Table 7.4", "bounds of the ratios, duck and muslin", "table_7_4")

local function over(card, direction)
  local fields = { card = card, direction = direction, unload = false, steps = 40 }
  if card.law ~= "potential" then chapter.patient(fields) end
  local test, why = chapter.try(fabric.lab.uniaxial, fields)
  if not test then return nil, why end
  return test.peak.S / chapter.P(card[direction], test.peak.E) - 1
end

local function with_ratios(card, part, law)
  return card:with { law = law, warp = { poisson = part * card.warp.poisson }, weft = { poisson = part * card.weft.poisson } }
end

local checks = {}
for _, name in ipairs { "duck", "muslin" } do
  local card = chapter.card(name)
  for _, direction in ipairs { "warp", "weft" } do
    local curves, last = {}, {}
    for _, law in ipairs { "potential", "incremental", "thesis" } do
      local curve = { x = {}, y = {}, label = law .. (law == "potential" and " (default)" or ""), style = "line_points" }
      for _, part in ipairs { 0.1, 0.25, 0.5, 0.75, 1 } do
        local value = over(with_ratios(card, part, law), direction)
        curve.x[#curve.x + 1], curve.y[#curve.y + 1] = part, value and 100 * value or 0 / 0
        last[law] = value
      end
      curves[#curves + 1] = curve
    end
    local cut = chapter.cut(card)
    local default_cut, thesis_cut = over(cut, direction), over(chapter.rules(card), direction)
    chapter.row(("%s %s, measured ratios: peak S over P(E)"):format(name, direction), "over-estimates or fails",
                chapter.percent(last.potential), last.thesis and chapter.percent(last.thesis) or "no convergence")
    chapter.row(("%s %s, ratios 0.40: peak S over P(E)"):format(name, direction), "bound 0.40", chapter.percent(default_cut), thesis_cut and chapter.percent(thesis_cut) or "no convergence")
    if direction == "warp" then
      chapter.plot(name .. "_" .. direction, "The thesis' law leaves P(E) as the ratios grow; the default law stays within 5 %.",
                   { curves = curves, xlabel = "ratios, as parts of the measured ones", ylabel = "peak stress above P(E), %" })
    end
    checks[#checks + 1] = { ("%s %s: default law with measured ratios, 0 to 5 %% over"):format(name, direction), last.potential, 0.025, absolute = 0.025 }
    checks[#checks + 1] = { ("%s %s: the thesis' law lies higher (1: yes)"):format(name, direction), (not last.thesis or last.thesis > 3 * last.potential) and 1 or 0, 1, relative = 1e-12 }
  end
  local clamped = fabric.lab.uniaxial { card = card, unload = false, steps = 20 }
  chapter.mesh_rows(name .. " warp, clamped", clamped, { "S" })
  chapter.render(name, "Clamped warp strip at its largest displacement, measured ratios: the middle narrows as the ratio says.",
                 { run = clamped.analysis, field = "E22" })
end
return chapter.expect(checks)
