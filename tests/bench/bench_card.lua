-- Reading a card's field, ns: fabricsh tests/bench/bench_card.lua. A field is to cost less than 200 ns, whatever else the card holds.
local fabric = require "fabric"
local points = {}
for i = 1, 2000 do points[i] = { (i - 1) * 1e-4, (i - 1) * 1e3 + (i - 1) ^ 2 } end
local blend = fabric.card "blend"
local measured = blend:with { name = "2,000 points", warp = { loading = points, unloading = 1e9 } }
local plain = { density = 590, warp = { poisson = 0.25, loading = {} } }

local n = 1e6
local function empty() end
local function ns(read)
  local best = math.huge
  for _ = 1, 5 do
    local start = os.clock()
    for _ = 1, n do read() end
    best = math.min(best, os.clock() - start)
  end
  return 1e9 * best / n
end
local call = ns(empty)
print(("%-16s %10s %14s %14s %10s"):format("", "density", "warp.poisson", "warp.loading", "bending"))
for _, card in ipairs { plain, blend, measured } do
  print(("%-16s %7.0f ns %11.0f ns %11.0f ns %7.0f ns"):format(card.name or "plain table", ns(function() return card.density end) - call,
    ns(function() return card.warp.poisson end) - call, ns(function() return card.warp.loading end) - call, ns(function() return card.bending end) - call))
end
