-- Figs. 7-14 to 7-17 of [williams2010]: strain across the pull against strain along it, warp and weft, of one fabric.
-- A deck calls lateral(figure, fabric); run by itself this file does nothing.
--
-- With free ends the ratio is the card's own, nu12 or nu21, at every strain, loading and unloading. Clamped ends hold the
-- width back: the average over the strip is smaller and the middle still shows the card's ratio. Cutting the ratios to 0.40
-- cuts the contraction with them, which is what the thesis saw for duck and muslin.
local fabric = require "fabric"
local chapter = package.loaded["thesis.chapter"]

local function ratio(row, name) return -row[name] / row[name == "E_lateral" and "E_average" or "E_centre"] end

return function(figure, name, folder)
  local card = chapter.card(name)
  chapter.begin(figure, name .. ", strain across the pull", folder)
  local checks, curves, frames = {}, {}, {}
  for _, direction in ipairs { "warp", "weft" } do
    local nu = card[direction].poisson
    local function pull(with, grips, cells)
      return fabric.lab.uniaxial { card = with, direction = direction, grips = grips, cells = cells, steps = 60,
                                   out = grips == "clamped" and not cells and chapter.folder .. "/" .. direction or nil }
    end
    local free, clamped, cut = pull(card, "free"), pull(card, "clamped"), pull(chapter.cut(card), "free")
    frames[#frames + 1] = chapter.frame(("%s/%s/strip"):format(chapter.folder, direction), clamped, clamped.peak)
    curves[#curves + 1] = chapter.curve(free.curve, direction .. ", free ends", "line", "E", "E_lateral", 1)
    curves[#curves + 1] = chapter.curve(clamped.curve, direction .. ", clamped, average", "line_points", "E", "E_lateral", 1)
    if nu > 0.40 then curves[#curves + 1] = chapter.curve(cut.curve, direction .. ", ratios 0.40", "dashed", "E", "E_lateral", 1) end
    local off = 0
    for _, row in ipairs(free.curve) do
      if row.E > 0 then off = math.max(off, math.abs(ratio(row, "E_lateral") / nu - 1)) end
    end
    chapter.row(direction .. ": ratio, free ends", "measured " .. nu, ratio(free.peak, "E_lateral"), ("%.2f (cut to 0.40)"):format(ratio(cut.peak, "E_lateral")))
    chapter.row(direction .. ": ratio, clamped, average over the strip", nil, ratio(clamped.peak, "E_lateral"))
    chapter.mesh_rows(direction .. ", clamped", fabric.lab.uniaxial { card = card, direction = direction, unload = false, steps = 20 }, { "E_lateral", "E_centre" })
    checks[#checks + 1] = { direction .. ", free: ratio over the card's, worst step", off, 0, absolute = 1e-7 } -- of the first step's small strain
    local least = math.min(nu, 0.40)
    checks[#checks + 1] = { direction .. ", ratios cut: ratio over the cut one", ratio(cut.peak, "E_lateral") / least, 1, relative = 1e-8 }
    -- The ends keep their width: the average lies below the card's ratio, above half of it on a strip three times as long as wide.
    checks[#checks + 1] = { direction .. ", clamped: average over the card's", ratio(clamped.peak, "E_lateral") / nu, 0.75, absolute = 0.25 }
  end
  chapter.plot("curves", "Straight lines of the card's ratios; clamped ends contract less on the average, and ratios cut to 0.40 miss the measured ones.",
               { title = name .. ": strain across the pull", xlabel = "strain along the pull", ylabel = "strain across", curves = curves })
  chapter.render("across", "Clamped warp and weft at their largest displacement: no contraction at the ends.",
                 { vtu = frames, labels = { "warp", "weft" },
                   field = "ux" })
  return chapter.expect(checks)
end
