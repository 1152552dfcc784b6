-- Bands of bending and of the biaxial spring: cards carry them, from cantilevers (fabric.lab.twist, fabric.lab.card) and from fits (found:card), write and read them, draw from
-- them, and fabric.budget varies them. A value that no band can hold is reported with its interval.
local fabric = require "fabric"
local lab = fabric.lab
local warned = {}
fabric.warn = function(text) warned[#warned + 1] = text end
local function close(a, b, tolerance) assert(math.abs(a / b - 1) < tolerance, a .. " for " .. b) end
local function mean(list)
  local sum = 0
  for _, x in ipairs(list) do sum = sum + x / #list end
  return sum
end
local function refused(words, call, ...)
  local ok, message = pcall(call, ...)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end
local place = os.tmpname()

-- --- cantilevers: a band by Student's t, twist from the differences
local strips = { warp = { 12e-6, 13e-6, 14e-6 }, weft = { 8e-6, 8.4e-6 }, bias = { 9e-6, 9.5e-6, 9.2e-6, 9.3e-6 } }
local t = lab.twist { warp = strips.warp, weft = strips.weft, bias = strips.bias }
close(t.bending.warp, 13e-6, 1e-12)
close(t.band.high[1] - t.bending.warp, lab.student(0.975, 2) * 1e-6 / math.sqrt(3), 1e-9)
close(t.bending.weft - t.band.low[2], lab.student(0.975, 1) * math.sqrt(0.08e-12 / 2), 1e-9)
close(t.bending.twist, mean(strips.bias) - (13e-6 + 8.2e-6) / 4, 1e-9)
assert(t.band.low[3] > 0 and t.band.high[3] > t.bending.twist and t.band.covariance[3] < 0 and t.band.covariance[3] == t.band.covariance[7])
-- bending lengths; what all strips have in common
local c = lab.twist { warp = { 0.02, 0.021 }, weft = { 0.018, 0.0183 }, bias = { 0.019, 0.0196 }, areal_mass = 0.15, common = 0.02 }
close(c.bending.weft, 9.80665 * 0.15 * mean { 0.018 ^ 3, 0.0183 ^ 3 }, 1e-12)
local plain = lab.twist { warp = { 0.02, 0.021 }, weft = { 0.018, 0.0183 }, bias = { 0.019, 0.0196 }, areal_mass = 0.15 }
close((c.band.high[2] - c.bending.weft) ^ 2, (plain.band.high[2] - c.bending.weft) ^ 2 + (lab.normal(0.975) * 0.02 * c.bending.weft) ^ 2, 1e-9)
assert(not lab.twist({ warp = 1e-5, weft = { 1e-5, 2e-5 }, bias = { 1e-5, 2e-5 } }).band) -- one strip
refused("field 'bias': expected a strip at 45 degrees", lab.twist, { warp = 1e-5, weft = 1e-5, simulate = true })

-- --- into a card, which is written, read, printed and drawn from
local duck = fabric.card "duck"
local function card_with(bending)
  return lab.card { name = "strips", density = 500, thickness = 4e-4, warp = duck.warp, weft = duck.weft, shear = duck.shear, poisson = { warp = 0.2, weft = 0.2 }, bending = bending }
end
local card = card_with(t)
assert(card.provenance.bending == "measured: cantilevers, 3 along the warp, 2 along the weft, 4 along the bias; of the curvatures of these strips, how it changes with curvature is not in the band" and card.bands.level == 0.95)
assert(tostring(card):find("none on warp, weft, shear", 1, true) and tostring(card):find("of 95 %% confidence on bending"), tostring(card))
card:write(place .. ".lua")
local again = fabric.card(place .. ".lua")
for i = 1, 3 do assert(again.bands.bending.low[i] == t.band.low[i] and again.bands.bending.high[i] == t.band.high[i]) end
assert(again.bands.bending.covariance[3] == t.band.covariance[3])
local inside, values = 0, {}
for i, drawn in ipairs(again:sample(2000, 3)) do
  values[i] = drawn.bending.warp
  inside = inside + (drawn.bending.warp >= t.band.low[1] and drawn.bending.warp <= t.band.high[1] and 1 or 0) / 2000
  assert(drawn.warp.loading[1] == duck.warp.loading[1] and not drawn.bands)
end
assert(math.abs(inside - 0.95) < 0.015, inside)
close(mean(values), 13e-6, 0.01)
local e = fabric.export.card { card = again, to = "ls-dyna" }
local found_loss = false
for _, line in ipairs(e.notes or e.lost or {}) do found_loss = found_loss or tostring(line):find("bands of bending: the values alone are written", 1, true) end
assert(found_loss or (e.text or ""):find("bands of bending: the values alone are written", 1, true), e.text)

-- a band goes with its part, and must fit it
assert(not card:with { bending = false }.bands.bending)
refused("field 'bands.bending': expected a card with bending of its own, got one without", duck.with, duck, { bending = false, bands = { bending = { low = { 1 }, high = { 1 }, covariance = { 1 } } } })
refused("field 'bands.bending.low': expected 3 numbers, got 1", card.with, card, { bands = { bending = { low = { 1e-6 }, high = { 2e-6 }, covariance = { 0 } } } })
do
  local own = card:with { bending = { warp = 7e-6, weft = 5e-6, twist = 3e-6 } }
  local low, high, none = { 6e-6, 4e-6, 2e-6 }, { 8e-6, 6e-6, 4e-6 }, { 1e-12, 0, 0, 0, 1e-12, 0, 0, 0, 1e-12 }
  assert(own:with { bands = { bending = { low = low, high = high, covariance = none } } }.bands.bending)
  refused("field 'bands.bending.high': expected at least 8e-06, that of low, got 6e-06 at place 1", own.with, own, { bands = { bending = { low = high, high = low, covariance = none } } })
  for _, c in ipairs { { 1e-12, 0, 0, 0, -1e-12, 0, 0, 0, 1e-12 }, { 1e-12, 5e-13, 0, 0, 1e-12, 0, 0, 0, 1e-12 }, { 1e-12, 0, 3e-12, 0, 1e-12, 0, 3e-12, 0, 1e-12 } } do
    refused("field 'bands.bending.covariance': expected that of real numbers", own.with, own, { bands = { bending = { low = low, high = high, covariance = c } } })
  end
  -- A band beside the card's own value is of another card; one that ends at it is not.
  local value = own.bending.weft
  for _, t in ipairs { { 1.2, 1.5, true }, { 0.5, 0.9, true }, { 1, 1.4, false } } do
    local band = { low = { own.bending.warp / 2, value * t[1], own.bending.twist / 2 }, high = { own.bending.warp * 2, value * t[2], own.bending.twist * 2 }, covariance = none }
    local found
    for _, item in ipairs(own:with({ bands = { bending = band } }):check().items) do if item.key == "band.bending" then found = item end end
    assert((found ~= nil) == t[3] and (not found or found.severity == "warning" and found.text:find("does not hold the card's own value of number 2", 1, true)))
  end
end

-- without strips at 45 degrees the twist is assumed, with a range, and not in the band
local two = lab.twist { warp = strips.warp, weft = strips.weft }
close(two.bending.twist, math.sqrt(13 * 8.2) / 2 * 1e-6, 1e-12)
local half = card_with(two)
assert(half.provenance["bending.twist"]:find "^assumed: half of the geometric mean" and half.ranges["bending.twist"][2] == 5 and half.bands.bending.low[3] == half.bands.bending.high[3])

-- --- the budget varies what the band holds; friction that is drawn unchanged is no reason to warn
local rubbing = card:with { bending = { friction_warp = { moment = 2e-4, curvature = 10 } }, bands = { bending = { low = { 10e-6, 7e-6, 3e-6, 1e-4, 10 }, high = { 16e-6, 9e-6, 5e-6, 3e-4, 10 },
  covariance = { 2.3e-12, 0, 0, 0, 0, 0, 2.6e-13, 0, 0, 0, 0, 0, 2.6e-13, 0, 0, 0, 0, 0, 2.6e-9, 0, 0, 0, 0, 0, 0 } } } }
local b = fabric.budget { card = rubbing, samples = 128, shares = false, print = false, processes = 1, run = function(p) return { M = 1e6 * p.card.bending.warp, f = 1e4 * p.card.bending.friction_warp.moment } end }
assert(#b.not_varied == 0 and #b.sample_warnings == 0 and b.contributions.M[1].source == "card.bending", b.text)
assert(math.abs(b.band.M.low - 10) < 0.8 and math.abs(b.band.M.high - 16) < 0.8 and math.abs(b.band.f.low - 1) < 0.3 and math.abs(b.band.f.high - 3) < 0.3, b.text)

-- --- fits: a line whose slope and end are the parameters, of which the deviations are known in closed form
local function fitted(noise)
  local measured, n = {}, 20
  local function predict(p)
    local y = {}
    for k = 1, n do y[k] = p.B * (k / n) + p.D * (1 - k / n) end
    return y
  end
  for k, y in ipairs(predict { B = 3, D = 40 }) do measured[k] = y + noise * (k % 2 == 0 and 1 or -1) end
  return lab.identify { parameters = { { name = "B", start = 2, low = 0.1, high = 20 }, { name = "D", start = 30, low = 1, high = 100 } }, processes = 1,
    tests = { { name = "line", measured = measured, noise = noise, predict = predict } } }
end
local found = fitted(0.2)
local function half_of(i) return 1.96 * found.deviation[i] end

-- bending, beside friction and a curve of rigidity that nothing moves
warned = {}
card = found:card(function(p)
  return duck:with { bending = { warp = 1e-6 * p.B, weft = { 2e-6 * p.B, -1e-9 }, twist = 1e-6, friction_warp = { moment = 1e-5 * p.D, curvature = 12 } } }
end)
local band = card.bands.bending
assert(#warned == 0 and not card.bands.warp and #band.low == 6 and card.provenance.bending == "fitted: by fabric.lab.identify")
for i, expected in ipairs { { 1e-6 * found.parameters.B, 1e-6 * half_of(1) }, { 2e-6 * found.parameters.B, 2e-6 * half_of(1) }, { -1e-9, 0 }, { 1e-6, 0 }, { 1e-5 * found.parameters.D, 1e-5 * half_of(2) }, { 12, 0 } } do
  assert(math.abs((band.low[i] + band.high[i]) / 2 - expected[1]) < 1e-6 * math.abs(expected[1]), i)
  assert(math.abs((band.high[i] - band.low[i]) / 2 - expected[2]) < 2e-3 * math.abs(expected[2]) + 1e-15, i)
end
for _, drawn in ipairs(card:sample(20)) do close(drawn.bending.weft[1], 2 * drawn.bending.warp, 1e-9) end -- as one parameter makes both

-- the biaxial spring, drawn too
card = found:card(function(p) return duck:with { biaxial = { alpha = 0.5, offset = 0.01, loading = 1e6 * p.D, unloading = 1e8 } } end)
close(card.bands.biaxial.high[3] - card.bands.biaxial.low[3], 2e6 * half_of(2), 2e-3)
b = fabric.budget { card = card, samples = 64, shares = false, print = false, processes = 1, run = function(p) return { q = p.card.biaxial.loading / 1e6 } end }
assert(b.contributions.q[1].source == "card.biaxial" and b.contributions.q[1].deviation > 0, b.text)
close(b.band.q.high - b.band.q.low, 2 * half_of(2), 0.2)
assert(#warned == 0, warned[1])

-- parameters that no band holds: the friction of shear gives a warning, density is in the provenance, which the budget repeats
card = found:card(function(p) return duck:with { density = 100 * p.B, warp = { loading = { p.D * 1e6, 5e8 }, unloading = 900e6 } } end)
assert(card.bands.warp and #warned == 1 and warned[1]:find("identify: card: no band of a card holds density from ", 1, true), warned[1])
b = fabric.budget { card = card, samples = 8, shares = false, print = false, processes = 1, run = function(p) return { d = p.card.warp.loading[1] } end }
assert(b.not_varied[#b.not_varied] == "density" and b.text:find("not varied: density, which no band of the card holds: interval of 95 %: density from ", 1, true), b.text)
