-- Figs. 7-24 and 7-25 of [williams2010]: strips whose warp stands 30 and 60 degrees from the pull, of one fabric.
-- A deck calls off_axis(figure, fabric); run by itself this file does nothing.
--
-- The stroke is not stated; 20 mm as for 45 degrees. Section 7.2.2 blames the difference from the measurement on stresses other
-- than that along the pull, so the stress is read three ways: force over area as the test machine does, averaged over the
-- elements, and in the middle.
local fabric = require "fabric"
local chapter = package.loaded["thesis.chapter"]
local MPa = fabric.units.MPa

-- The card with warp and weft exchanged.
local function exchanged(card)
  return card:with { warp = card.weft, weft = card.warp, tested = { warp = card.tested.weft, weft = card.tested.warp } }
end

return function(figure, name, folder)
  local card = chapter.card(name)
  chapter.begin(figure, name .. ", warp at 30 and 60 degrees from the pull", folder)
  local checks, curves, frames = {}, {}, {}
  for _, angle in ipairs { 30, 60 } do
    local function strip(with, grips, at, fields)
      fields = fields or {}
      fields.card, fields.angle, fields.grips, fields.steps = with, at, grips, 80
      return chapter.try(fabric.lab.bias, fields)
    end
    local out = ("%s/%d"):format(chapter.folder, angle)
    local free, clamped = assert(strip(card, "free", angle)), assert(strip(card, "clamped", angle))
    frames[#frames + 1] = chapter.frame(out .. "/strip", assert(strip(card, "clamped", angle, { out = out, cells = { 6, 18 }, unload = false })))
    local rules, why = strip(chapter.rules(card), "free", angle, chapter.patient {})
    local point = fabric.point(card):uniaxial(angle, free.peak.E).S
    local what = ("%d degrees, 20 mm: S by force / area, average, centre, "):format(angle)
    local function three(row) return ("%.3f %.3f %.3f"):format(row.S / MPa, row.S_average / MPa, row.S_centre / MPa) end
    chapter.row(what .. "free, MPa", nil, three(free.peak), rules and three(rules.peak) or why)
    chapter.row(what .. "clamped, MPa", nil, three(clamped.peak))
    chapter.row(("%d degrees: S of the material point, MPa"):format(angle), nil, point / MPa)
    chapter.mesh_rows(("%d degrees, free"):format(angle), fabric.lab.bias { card = card, angle = angle, unload = false, steps = 20 }, { "S", "S_average", "S_centre" })
    chapter.mesh_rows(("%d degrees, clamped"):format(angle), fabric.lab.bias { card = card, angle = angle, grips = "clamped", unload = false, steps = 20 }, { "S", "S_centre" })
    curves[#curves + 1] = chapter.curve(free.curve, angle .. " degrees, force over area, free")
    curves[#curves + 1] = chapter.curve(free.curve, angle .. " degrees, centre, free", "dashed", "E", "S_centre")
    curves[#curves + 1] = chapter.curve(clamped.curve, angle .. " degrees, force over area, clamped", "points")
    -- Warp and weft exchanged and the angle complemented, it is the mirror image of the same strip.
    local mirror = assert(strip(exchanged(card), "free", 90 - angle))
    checks[#checks + 1] = { angle .. " degrees: mirror image, S", mirror.peak.S, free.peak.S, relative = 1e-7 } -- tolerance of the solver over the small first forces
    checks[#checks + 1] = { angle .. " degrees, free: force over area against the average", free.peak.S / free.peak.S_average, 1, relative = 0.03 } -- both are means of one field; lambda differs along it
    local e = free.analysis.energy
    checks[#checks + 1] = { angle .. " degrees, free: stored and dissipated over the work", e.internal / e.external, 1, relative = 5e-3 } -- trapezoids over 80 steps
  end
  chapter.plot("curves", "Nearer to the stiffer yarn the strip is stiffer; the middle carries another stress than force over area says.",
               { title = name .. ": off the yarns, 20 mm", curves = curves, xlabel = "Green-Lagrange strain of the grips", ylabel = "S, MPa" })
  chapter.render("sheets", "Clamped at 20 mm: the strips lean into an S, as one yarn carries and the other doesn't.",
                 { vtu = frames, labels = { "30 degrees", "60 degrees" }, field = "S11" })
  return chapter.expect(checks)
end
