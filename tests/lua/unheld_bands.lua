-- Fitted numbers that no band of a card holds, of bending and of the biaxial spring, are said with their intervals: by a warning, in the card's provenance and by fabric.budget.
local fabric = require "fabric"
local lab = fabric.lab
local warned = {}
fabric.warn = function(text) warned[#warned + 1] = text end

-- A line whose slope and end are the parameters: their deviations are known in closed form.
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
local duck = fabric.card "duck"
local function close(a, b, tolerance) assert(math.abs(a / b - 1) < tolerance, a .. " for " .. b) end

-- bending alone: no part has a band, and the card says what it cannot carry
local function bent(p) return duck:with { bending = { warp = 1e-6 * p.B, weft = 2e-6 * p.B, twist = 1e-6 } } end
local card = found:card(bent)
assert(not card.bands and #warned == 1 and warned[1]:find("identify: card: no band of a card holds bending.warp from ", 1, true) and warned[1]:find(", bending.weft from ", 1, true), warned[1])
assert(not warned[1]:find("twist", 1, true) and not warned[1]:find("warp.loading", 1, true), warned[1])
local low, high = card.provenance.bending:match "bending%.warp from (%S+) to ([^ ,;]+)"
close(tonumber(low), 1e-6 * (found.parameters.B - 1.96 * found.deviation[1]), 1e-2)
close(tonumber(high), 1e-6 * (found.parameters.B + 1.96 * found.deviation[1]), 1e-2)
assert(card.provenance.bending:find "^fitted: by fabric.lab.identify; interval of 95 %%: " and not card.provenance["bending.twist"])

-- beside a band of the warp; the budget says what it leaves as it is
warned = {}
local function both(p)
  return duck:with { warp = { loading = { p.D * 1e6, 5e8 }, unloading = 900e6 }, bending = { warp = 4e-6, weft = 4e-6, twist = 0.5e-6 * p.B } }
end
card = found:card(both)
assert(card.bands.warp and not card.bands.weft and card.provenance["bending.twist"] and not (card.provenance.bending or ""):find "interval" and #warned == 1, warned[1])
local b = fabric.budget { card = card, samples = 8, shares = false, print = false, processes = 1, run = function(p) return { d = p.card.warp.loading[1] } end }
assert(#b.not_varied == 1 and b.not_varied[1] == "bending.twist", table.concat(b.not_varied, " "))
assert(b.text:find("not varied: bending.twist, which no band of the card holds: interval of 95 %: bending.twist from ", 1, true), b.text)

-- what depends on no parameter is not spoken of
warned = {}
card = found:card(function(p) return duck:with { warp = { loading = { p.D * 1e6, 5e8 }, unloading = 900e6 } } end)
assert(card.bands.warp and #warned == 0, warned[1])

-- the biaxial spring
local function sprung(p)
  return duck:with { biaxial = { alpha = 0.5, offset = 0.01, loading = 1e6 * p.D, unloading = 1e8 } }
end
card = found:card(sprung)
assert(#warned == 1 and warned[1]:find("biaxial.loading", 1, true) and card.provenance.biaxial:find("biaxial.loading", 1, true), warned[1])
