-- Figs. 7-29 and 7-30 of [williams2010]: equal biaxial strain of a 254 mm square by 30 mm, of one fabric: the default law, the
-- same with a biaxial spring fitted to the thesis' stiffening, and the thesis' law. A deck calls biaxial(figure, fabric).
--
-- Nobody measured these cloths in biaxial strain; the thesis shows what its law gives, and so do we. Closed forms at equal strain
-- E of virgin cloth: default S11 = P1 + c (1 + nu12) E; the thesis' moduli D1 (1 + nu21) / (1 - nu12 nu21), integrated exactly,
-- S11 = P1 (1 + nu21) / (1 - nu12 nu21).
local fabric = require "fabric"
local chapter = package.loaded["thesis.chapter"]

-- Spring T(y), y = E11 + alpha E22 - offset, that leaves uniaxial tests alone (both tested ends lie on y = 0) and adds to S11 at
-- equal strain E the stress `more`. Unloading: as the blend's, 111 on 294.
local function spring(card, E, more)
  local m1, m2 = card.tested.warp, card.tested.weft
  local nu12, nu21 = card.warp.poisson, card.weft.poisson
  local alpha = (m1 + nu21 * m2) / (m2 + nu12 * m1)
  local offset = m1 * (1 - alpha * nu12)
  local y = E * (1 + alpha) - offset
  assert(y > 0)
  local loading = 2 * more / y ^ 2
  return { alpha = alpha, offset = offset, loading = loading, unloading = loading * 111 / 294 }
end

return function(figure, name, folder)
  local card = chapter.card(name)
  chapter.begin(figure, name .. ", equal biaxial strain", folder)
  local e = 30 / 254
  local E = e + e * e / 2
  local nu12, nu21 = card.warp.poisson, card.weft.poisson
  local nn = nu12 * nu21
  local P1, P2 = chapter.P(card.warp, E), chapter.P(card.weft, E)
  local c = math.min(nu21 * card.warp.loading[1], nu12 * card.weft.loading[1]) / (1 - nn)
  local more = P1 * ((1 + nu21) / (1 - nn) - 1) - c * (1 + nu12) * E
  local fitted = card:with { biaxial = spring(card, E, more) }
  local runs = {
    { "default law", assert(chapter.try(fabric.lab.biaxial, { card = card, out = chapter.folder })) },
    { "with biaxial spring", assert(chapter.try(fabric.lab.biaxial, { card = fitted })) },
    { "incremental law", assert(chapter.try(fabric.lab.biaxial, { card = card:with { law = "incremental" } })) },
    { "thesis' rules", assert(chapter.try(fabric.lab.biaxial, { card = chapter.rules(card) })) },
  }
  local warp, weft = {}, {}
  for _, run in ipairs(runs) do
    local label, peak = run[1], run[2].peak
    warp[#warp + 1] = chapter.curve(run[2].curve, label, "line", "E11", "S11")
    weft[#weft + 1] = chapter.curve(run[2].curve, label, "line", "E22", "S22")
    chapter.row(label .. ": warp, weft over uniaxial at E = 0.125", "much stiffer",
                ("%s, %s"):format(chapter.percent(peak.S11 / P1 - 1), chapter.percent(peak.S22 / P2 - 1)))
  end
  warp[#warp + 1] = chapter.line(function(x) return chapter.P(card.warp, x) end, E, "uniaxial P(E)")
  weft[#weft + 1] = chapter.line(function(x) return chapter.P(card.weft, x) end, E, "uniaxial P(E)")
  chapter.mesh_rows("default law", runs[1][2], { "S11", "S22" })
  for direction, curves in pairs { warp = warp, weft = weft } do
    chapter.plot(direction, "The default law stiffens a little; the fitted spring and the thesis' law as much as its coupling says.",
                 { title = ("%s: %s in equal biaxial strain"):format(name, direction), xlabel = "Green-Lagrange strain", ylabel = "S, MPa", curves = curves })
  end
  chapter.render("square", "The square at 30 mm: uniform.", { vtu = chapter.frame(chapter.folder .. "/square", runs[1][2], runs[1][2].peak), field = "S11" })
  local potential, sprung, incremental, thesis = runs[1][2].peak, runs[2][2].peak, runs[3][2].peak, runs[4][2].peak
  return chapter.expect {
    { "default law, warp", potential.S11, P1 + c * (1 + nu12) * E, relative = 1e-9 },
    { "default law, weft", potential.S22, P2 + c * (1 + nu21) * E, relative = 1e-9 },
    { "spring, warp: as the incremental law", sprung.S11, P1 * (1 + nu21) / (1 - nn), relative = 1e-9 },
    { "incremental, warp", incremental.S11, P1 * (1 + nu21) / (1 - nn), relative = 1e-8 }, -- its switch lies inside the first step
    { "incremental, weft", incremental.S22, P2 * (1 + nu12) / (1 - nn), relative = 1e-8 },
    -- The endpoint rule takes each of 40 steps with the modulus at its end: D rises, so it lies above, by half a step's rise.
    { "thesis' rules over incremental, warp", thesis.S11 / incremental.S11, 1, absolute = 0.06 },
  }
end
