-- card:sample fills the bands as they are stated: a value at the end of its band is drawn on the band's side, and drawn values that make no card are counted.
local fabric = require "fabric"
local define = require "fabric.define"

local function counted(cards, value, low, high)
  local inside, below = 0, 0
  for _, c in ipairs(cards) do
    local v = value(c)
    if v >= low and v <= high then inside = inside + 1 end
    if v < low then below = below + 1 end
  end
  return inside / #cards, below
end
local function initial(c) return c.warp.loading[1] end

-- of blend the warp's d0 = 8 MPa is the upper end of its band, d1 the lower end of its own; both go together
local n, C = 500, {}
for i = 1, 16 do C[i] = 0 end
C[1], C[2], C[5], C[6] = 4e11, -2e13, -2e13, 1e15
local card = fabric.card("blend"):with { bands = { warp = { low = { 6e6, 826e6, 864e6, 0.25 }, high = { 8e6, 926e6, 864e6, 0.25 }, covariance = C } } }
local cards = card:sample(n, 4)
local inside = counted(cards, initial, 6e6, 8e6 * (1 + 1e-12))
assert(math.abs(inside - 0.95) < 0.03 and cards.refused == 0, inside) -- three deviations of the count
local slope, above = counted(cards, function(c) return c.warp.loading[2] end, 826e6 * (1 - 1e-12), 926e6)
assert(math.abs(slope - 0.95) < 0.03 and above == 0, slope)
for _, c in ipairs(cards) do assert(math.abs((8e6 - c.warp.loading[1]) / 2e6 - (c.warp.loading[2] - 826e6) / 100e6) < 1e-6) end

-- a band that reaches below zero: a modulus of nothing is no card
C = {}
for i = 1, 16 do C[i] = 0 end
C[1] = 1e13
local wide = fabric.card("blend"):with { bands = { warp = { low = { -1e6, 826e6, 864e6, 0.25 }, high = { 17e6, 826e6, 864e6, 0.25 }, covariance = C } } }
local before = define.log_end()
cards = wide:sample(200, 2)
local said = define.warnings(before)
assert(#said == 1 and said[1].text:find "cards drawn from the bands %([%d.]+ %%%) make no card and were drawn again", said[1] and said[1].text)
assert(cards.refused > 2 and cards.refused < 30, cards.refused) -- P(z < -8 / 9 * 1.96) = 0.041, and what is too soft to be stable
for _, c in ipairs(cards) do assert(c:check().ok) end

-- points of a soft toe, whose first stresses have a band that reaches below zero: draws are made to rise, so that the toe takes nothing away from the end, where the band is filled
local S, more = { 0.1e6, 0.25e6, 1.5e6, 4e6 }, { deviation = { 0.12e6, 0.2e6, 0.2e6, 0.5e6 } }
local E = { 0.02, 0.04, 0.08, 0.12 }
local points, band = { { 0.0, 0.0 } }, { low = {}, high = {}, covariance = {} }
for i = 1, 6 do
  local value, d = S[i] or ({ 120e6, 0.05 })[i - 4], more.deviation[i] or 0
  if S[i] then points[i + 1] = { E[i], S[i] } end
  band.low[i], band.high[i] = value - 1.96 * d, value + 1.96 * d
  for j = 1, 6 do band.covariance[(i - 1) * 6 + j] = i == j and d * d or 0 end
end
local toe = fabric.card("blend"):with { warp = { loading = points, unloading = 120e6, poisson = 0.05 }, weft = { poisson = 0.05 }, tested = { warp = 0.12 }, bands = { warp = band } }
before = define.log_end()
cards = toe:sample(500, 7)
local function fill(place) return counted(cards, function(c) return c.warp.loading[place + 1][2] end, band.low[place], band.high[place]) end
assert(math.abs(fill(4) - 0.95) < 0.03 and math.abs(fill(3) - 0.95) < 0.03, fill(4))
local lowest, flat = math.huge, 0
for _, c in ipairs(cards) do
  local loading = c.warp.loading
  lowest = math.min(lowest, loading[2][2])
  for k = 2, 5 do assert(loading[k][2] > loading[k - 1][2]) end
  for k = 2, 5 do flat = flat + (loading[k][2] - loading[k - 1][2] < 1e3 and 0.25 / #cards or 0) end
  assert((loading[5][2] - loading[4][2]) / 0.04 < c.warp.unloading)
end
assert(lowest > 0 and flat > 0.02 and cards.refused < 200, ("%g %g %d"):format(lowest, flat, cards.refused))
