-- Nylon strips at 0, 45 and 90 degrees, monotone pulls without markers and without unloading (bertoldi-collab/aerodynamic-textile-metamaterials,
-- MIT): a card of the three, what it assumes, and what it says for pulls at 15 and 75 degrees, with a band.
--
--   fabricsh scripts/lab/real/nylon.lua [out]
--
-- The records are not part of the program: they lie in ../shared/data beside this checkout, or the deck says SKIPPED.
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units
local mm = u.mm

local place = (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/nylon-strips/"
local out = arg[1] or "out/nylon"
if not io.open(place .. "strip-00.csv") then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
if fabric.checking() then return end

-- Twelve strips of 2.25 mm side by side; the thickness was not told.
local size = { gauge_length = 97 * mm, width = 12 * 2.25 * mm, thickness = 0.1 * mm, plies = 1 }
local function pull(angle)
  local t = { file = place .. "strip-" .. angle .. ".csv", columns = { displacement = 1, force = 2 }, units = { displacement = "mm", force = "N" }, zero = true }
  for name, value in pairs(size) do t[name] = value end
  return lab.tensile(t)
end
local tests = { warp = pull "00", bias = pull "45", weft = pull "90" }
local warp, weft = lab.fit { tests = { tests.warp }, find_slack = "either" }, lab.fit { tests = { tests.weft }, find_slack = "either" }
print(warp.text)
print(weft.text)

-- The shear follows from the pull at 45 degrees: the modulus scale of a straight backbone with which a strip with free ends carries the
-- measured force, by least squares over the pull.
local function card_with(G0, G1)
  return lab.card { name = "nylon", source = "bertoldi-collab, nylon strips", density = 500, thickness = size.thickness, warp = warp, weft = weft,
    assume = { ["shear.loading"] = { G0, G1 }, thickness = true, density = true } }
end
local function at(card, angle, strains) return fabric.point(card):uniaxial(angle, strains, { "S" }).S end
local function thinned(test)
  local E, S = {}, {}
  for i = 2, #test.E, 4 do E[#E + 1], S[#S + 1] = test.E[i], test.S[i] end
  return E, S
end
local E45, S45 = thinned(tests.bias)
local found = lab.identify {
  parameters = { { name = "G0", start = 7.5, low = 6, high = 9 }, { name = "G1", start = 0, low = -20, high = 30 } },
  tests = { { name = "45 degrees", measured = S45, noise = 0.01 * S45[#S45],
    predict = function(p) return at(card_with(10 ^ p.G0, 10 ^ p.G0 * p.G1), 45, E45) end } },
}
local p = found.parameters
local card = card_with(10 ^ p.G0, 10 ^ p.G0 * p.G1)
print(found.text)

-- The yarns' own pulls count from the first contact that their fits found.
local rows, names = {}, { [0] = { tests.warp, warp.specimens[1].slack }, [45] = { tests.bias, 0 }, [90] = { tests.weft, weft.specimens[1].slack } }
for _, angle in ipairs { 0, 45, 90 } do
  local test, slack = table.unpack(names[angle])
  local E, S = thinned(test)
  local c = lab.compare({ E = E, S = S }, { E = E, S = at(card, angle, E) }, { slack = slack,
    file = ("%s/nylon-%02d.svg"):format(out, angle), title = "nylon, " .. angle })
  print(("%d degrees: %s"):format(angle, c.text))
  rows[#rows + 1] = { angle .. " degrees: rms over the peak", c.rms, 0, absolute = 0.03 }
end

-- 15 and 75 degrees with a band: cards drawn with the toe of either fit, the shear within its own band, and the ratios that nobody measured
-- across those of the shipped cloths.
local low, high = {}, {}
local function note(angle, S)
  low[angle], high[angle] = math.min(low[angle] or S, S), math.max(high[angle] or S, S)
end
local reach = 0.03
for _, ratio in ipairs { 0.12, 0.4, 0.9 } do
  for _, toe in ipairs { "low", "high" } do
    local function yarn(fit)
      local loading = table.move(fit.loading, 1, #fit.loading, 1, {})
      if fit.band and fit.band.low then loading[1] = fit.band[toe][1] end
      return { loading = loading, unloading = card.warp.unloading, poisson = ratio }
    end
    local drawn = card:with { warp = yarn(warp), weft = yarn(weft) }
    for _, angle in ipairs { 15, 75 } do note(angle, at(drawn, angle, { reach })[1]) end
  end
end
for _, angle in ipairs { 15, 75 } do
  local S = at(card, angle, { reach })[1]
  print(("%d degrees at E = %g: %.3g MPa, %.3g to %.3g"):format(angle, reach, S / u.MPa, low[angle] / u.MPa, high[angle] / u.MPa))
  rows[#rows + 1] = { angle .. " degrees lies in its band", S >= low[angle] and S <= high[angle] and 1 or 0, 1, absolute = 0 }
end
card:write(out .. "/card.lua")
print(card)
fabric.expect(rows)
