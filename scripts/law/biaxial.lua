-- Equal biaxial strain at one material point: the default law, the fitted biaxial spring, and the thesis' own law
-- [williams2010, section 7.3.1].
--
--   fabricsh scripts/law/biaxial.lua [folder]
local fabric = require "fabric"
local MPa = fabric.units.MPa
local folder = arg[1] or "out/law"

local card = fabric.card "blend"
-- Fitted so that the warp comes out 59 % over its uniaxial stress at E = 0.125, and nothing uniaxial changes.
local spring = { alpha = 1.568, offset = 0.1606, loading = 294 * MPa, unloading = 111 * MPa }
local laws = {
  { "potential", card },
  { "potential with biaxial spring", card:with { biaxial = spring } },
  { "incremental", card:with { law = "incremental" } },
}

local strains = {}
for i = 1, 100 do strains[i] = 0.125 * i / 100 end
local alone = fabric.point(card):uniaxial("warp", strains)
local curves = { { x = {}, y = {}, label = "uniaxial", style = "dashed" } }
for i, r in ipairs(alone) do curves[1].x[i], curves[1].y[i] = r.E, r.S / MPa end

print(("%-32s %10s %10s"):format("1:1, E = 0.125", "warp, %", "weft, %"))
local weft = fabric.point(card):uniaxial("weft", strains)
local over = {}
for k, law in ipairs(laws) do
  local run = fabric.point(law[2]):biaxial(1, strains)
  local curve = { x = {}, y = {}, label = law[1] }
  for i, r in ipairs(run) do curve.x[i], curve.y[i] = r.E11, r.S11 / MPa end
  curves[#curves + 1] = curve
  over[k] = { run[100].S11 / alone[100].S - 1, run[100].S22 / weft[100].S - 1 }
  print(("%-32s %+10.1f %+10.1f"):format(law[1], 100 * over[k][1], 100 * over[k][2]))
end
fabric.plot {
  file = folder .. "/law_biaxial.svg",
  xlabel = "Green-Lagrange strain E11 = E22",
  ylabel = "second Piola-Kirchhoff stress S11, MPa",
  curves = curves,
}

-- Closed forms of the potential law at E11 = E22 = e, both virgin: S11 = P1 + c (nu12 + 1) e.
local e = 0.125
local nu12, nu21 = card.warp.poisson, card.weft.poisson
local function P(yarn) return yarn.loading[1] * e + yarn.loading[2] * e ^ 2 / 2 end
local c = math.min(nu21 * card.warp.loading[1], nu12 * card.weft.loading[1]) / (1 - nu12 * nu21)
local y = math.max(e + spring.alpha * e - spring.offset, 0)
local T = spring.loading * y ^ 2 / 2
fabric.expect {
  { "potential, warp over uniaxial", over[1][1], c * (nu12 + 1) * e / P(card.warp), relative = 1e-10 },
  { "potential, weft over uniaxial", over[1][2], c * (nu21 + 1) * e / P(card.weft), relative = 1e-10 },
  { "spring, warp over uniaxial", over[2][1], (c * (nu12 + 1) * e + T) / P(card.warp), relative = 1e-10 },
  { "spring, weft over uniaxial", over[2][2], (c * (nu21 + 1) * e + spring.alpha * T) / P(card.weft), relative = 1e-10 },
}
