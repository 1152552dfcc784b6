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
