-- Capstan: a strip drawn over half a cylinder, T2 / T1 against e^(mu theta), with the second order of the facets.
--
--   fabricsh scripts/contact/capstan.lua          8, 16, 32 and 64 facets over half a turn
--
-- A facet that turns by d = theta/n lies on the cylinder with its middle. Where its normal force acts, the pulls at its two ends have no
-- moment, so the larger pull T(1 + mu d) has the smaller lever of angle: it stands mu d^2/4 nearer to the facet than half of d. With the
-- two balances of forces ln(T2/T1) = mu theta (1 - d^2 (1/4 - (1 + mu^2)/12)) to the second order. Were the corners what touches, it
-- would be n times ln((1 + mu tan(d/2))/(1 - mu tan(d/2))), from the other side, with the same limit.
local fabric = require "fabric"
local card = fabric.svk { young = 1e9, poisson = 0, density = 500, thickness = 0.4e-3, name = "tape", bending = { warp = 3e-6, weft = 3e-6, twist = 3e-6 } }
local mu, wrap = 0.3, 180
local theta = math.rad(wrap)
local thread = math.exp(mu * theta)

print("facets  T2/T1     off the thread    facets' closed form   corners' closed form")
local last
for _, n in ipairs { 8, 16, 32, 64 } do
  -- Leads of a quarter of the wrap: the pressing in turns them by little.
  local test = fabric.lab.capstan { card = card, around = n, friction = mu, wrap = wrap, draw = 0.0006, lead = n // 4, stiffness = 1e10 }
  local d = theta / n
  local off = fabric.checking() and 1 / n ^ 2 or test.ratio / thread - 1
  local facets = -mu * theta * d ^ 2 * (1 / 4 - (1 + mu ^ 2) / 12)
  local corners = ((1 + mu * math.tan(d / 2)) / (1 - mu * math.tan(d / 2))) ^ n / thread - 1
  print(string.format("%6d  %.5f   %+8.4f %%        %+8.4f %%           %+8.4f %%", n, test.ratio, 100 * off, 100 * facets, 100 * corners))
  local rows = { { n .. " facets: off the thread, over the closed form of facets", off / facets, 1, absolute = 0.15 } }
  if last then rows[2] = { n .. " facets: second order, a quarter of the error of half as many", last / off, 4, absolute = 0.3 } end
  fabric.expect(rows)
  last = off
end
