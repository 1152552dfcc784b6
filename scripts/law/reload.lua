-- One yarn at one material point: backbone, unloading, slack, reloading [williams2010, fig. 7-18].
--
--   fabricsh scripts/law/reload.lua [folder]
--
-- The warp of the blend is pulled to 75 % of 18 mm, let back to 70 %, pulled to 100 %, let go until slack and beyond.
local fabric = require "fabric"
local folder = arg[1] or "out/law"

local card = fabric.card "blend"
local yarn = card.warp
local function P(E) return yarn.loading[1] * E + yarn.loading[2] * E ^ 2 / 2 end
local function U(E) return yarn.loading[1] * E ^ 2 / 2 + yarn.loading[2] * E ^ 3 / 6 end
local function strain(part)
  local u = part * 18 / 76.2
  return u + u ^ 2 / 2
end

local function ramp(list, from, to, n)
  for i = 1, n do list[#list + 1] = from + (to - from) * i / n end
  return list
end

-- The same path in 4 steps and in 4,000: the law has no step-size error.
local m, back, top = strain(0.75), strain(0.70), strain(1)
local rest = top - P(top) / yarn.unloading
local slack = rest - 0.02
local function path(n)
  return ramp(ramp(ramp(ramp({}, 0, m, n), m, back, n), back, top, n), top, slack, n)
end
local fine = fabric.point(card):uniaxial("warp", path(1000))
local coarse = fabric.point(card):uniaxial("warp", path(1))

local backbone = {}
for i = 0, 100 do backbone[i + 1] = { E = top * i / 100, S = P(top * i / 100) } end
fabric.plot {
  file = folder .. "/law_reload.svg",
  xlabel = "Green-Lagrange strain E11",
  ylabel = "second Piola-Kirchhoff stress S11",
  yunit = "MPa",
  curves = {
    { rows = fine, x = "E", y = "S", label = "law" },
    { rows = backbone, x = "E", y = "S", label = "P(E) of the card", style = "dashed" },
  },
}

local rows = {}
local function check(name, got, want) rows[#rows + 1] = { name, got, want, relative = 1e-12 } end
-- Slack under uniaxial stress: S11 = H1 + c E22 with the weft, never stretched, slack from the start too. Both are linear, so
-- S11 = (h1 - c^2 / h2) (E11 - E_r) with h1 = c / nu21, h2 = c / nu12.
local nu12, nu21 = yarn.poisson, card.weft.poisson
local c = math.min(nu21 * yarn.loading[1], nu12 * card.weft.loading[1]) / (1 - nu12 * nu21)
for i, run in ipairs { fine, coarse } do
  local n = #run // 4
  local name = i == 1 and "1000 steps a leg: " or "1 step a leg: "
  check(name .. "S at 75 %", run[n].S, P(m))
  check(name .. "S let back to 70 %", run[2 * n].S, P(m) - yarn.unloading * (m - back))
  check(name .. "S reloaded to 100 %", run[3 * n].S, P(top))
  check(name .. "lateral ratio there", -run[3 * n].E_lateral / top, nu12)
  check(name .. "dissipated there", run[3 * n].dissipated, U(top) - P(top) ^ 2 / (2 * yarn.unloading))
  rows[#rows + 1] = { name .. "S slack", run[4 * n].S, (c / nu21 - c * nu12) * (slack - rest), relative = 1e-9 } -- rest: a difference of large numbers
end
fabric.expect(rows)
