-- Made families of specimens: how many points of a specimen left out, and of the next one, lie in the bands of fabric.lab.spread and fabric.lab.pool?
--
--   fabricsh scripts/long/lab_next_specimen.lua [families] [specimens of each]      200 5
--
-- Specimens differ by a factor (deviation 7 %), by curves of their own of three waves (none, 1.5 or 3 % each), and by noise of 1 % of single points. The
-- points of a specimen hang together, so a single family tells little: what is expected is the mean over the families, and printed beside it is where nine
-- in ten of the families lie, and of pairs of them.
local fabric = require "fabric"
local lab = fabric.lab
local draw = require "fabric.lab.random" (5)

local families, specimens = math.tointeger(tonumber(arg[1] or 200)), math.tointeger(tonumber(arg[2] or 5))
if not families or families < 20 or not specimens or specimens < 3 then
  error("usage: fabricsh lab_next_specimen.lua [families >= 20] [specimens >= 3]", 0)
end
if fabric.checking() then return end

local points, reference = 20, { a = 0.1, b = 0.05, c = -0.3, d = 0.5 }
local function predict(p)
  local y = {}
  for k = 1, points do
    local x = (k - 0.5) / points
    y[k] = p.a * x + p.b * x ^ 2 + p.c * x ^ 3 + p.d * x ^ 4
  end
  return y
end
local clean = predict(reference)
local function specimen(name, wave)
  local own, heights, t = 1 + 0.07 * draw.normal(), {}, { name = name, measured = {}, noise = {}, predict = predict }
  for m = 1, 3 do heights[m] = math.sqrt(2) * wave * draw.normal() end
  for k, y in ipairs(clean) do
    local scale, shape = 0.02 + y, 0
    for m, height in ipairs(heights) do shape = shape + height * math.cos(m * math.pi * (k - 0.5) / points) end
    t.noise[k] = 0.01 * scale
    t.measured[k] = y * own + scale * shape + t.noise[k] * draw.normal()
  end
  return t
end
-- The same as a test for fabric.lab.spread.
local function pulled(t)
  local test = { E = {}, S = t.measured, branches = { { kind = "loading", first = 1, last = points } } }
  for k = 1, points do test.E[k] = (k - 0.5) / points end
  return test
end
local function mean(list)
  local sum = 0
  for _, x in ipairs(list) do sum = sum + x end
  return sum / #list
end
local function told(words, shares)
  local pairs_of = {}
  for i = 1, 2000 do pairs_of[i] = (shares[1 + math.floor(#shares * draw.uniform())] + shares[1 + math.floor(#shares * draw.uniform())]) / 2 end
  table.sort(shares)
  table.sort(pairs_of)
  local function at(list, part) return 100 * list[math.max(1, math.ceil(part * #list))] end
  print(("  %-46s %5.1f %%; nine families in ten %3.0f to %3.0f %%, nine pairs %3.0f to %3.0f %%"):format(words, 100 * mean(shares), at(shares, 0.05), at(shares, 0.95),
    at(pairs_of, 0.05), at(pairs_of, 0.95)))
  return mean(shares)
end

local parameters, rows = {}, {}
for i, name in ipairs { "a", "b", "c", "d" } do parameters[i] = { name = name, start = 0.1, low = -5, high = 5 } end
for _, wave in ipairs { 0, 0.015, 0.03 } do
  local spread, left, next_one, inside = {}, {}, {}, { a = 0, b = 0, c = 0, d = 0 }
  for f = 1, families do
    local tests, pulls = {}, {}
    for i = 1, specimens do tests[i] = specimen("pull " .. i, wave) end
    for i, t in ipairs(tests) do pulls[i] = pulled(t) end
    spread[f] = lab.spread({ tests = pulls, points = points }).coverage
    local pool = lab.pool { parameters = parameters, tests = tests, processes = 1 }
    left[f] = pool.coverage or 0 / 0
    local other, band, held = specimen("next", wave), pool.tests["pull 1"], 0
    for k, y in ipairs(other.measured) do held = held + (band.next_low[k] <= y and y <= band.next_high[k] and 1 or 0) end
    next_one[f] = held / points
    for name, value in pairs(reference) do inside[name] = inside[name] + (pool.low[name] <= value and value <= pool.high[name] and 1 or 0) / families end
  end
  print(("factors of 7 %%, waves of %g %% each:"):format(100 * wave))
  local of_spread = told("left out, in the band of the others (spread)", spread)
  local of_pool, of_next = told("left out, in the band of the others (pool)", left), told("the next, in its band (pool)", next_one)
  print(("  parameters inside of their bands (pool): %.1f, %.1f, %.1f, %.1f %%"):format(100 * inside.a, 100 * inside.b, 100 * inside.c, 100 * inside.d))
  -- A family's share scatters by some 0.08.
  local allowed = 0.03 + 2.5 * 0.08 / math.sqrt(families)
  rows[#rows + 1] = { ("waves %g: left out (spread)"):format(wave), of_spread, 0.95, absolute = 2.5 * 0.08 / math.sqrt(families) }
  rows[#rows + 1] = { ("waves %g: left out (pool)"):format(wave), of_pool, 0.95, absolute = allowed }
  rows[#rows + 1] = { ("waves %g: the next (pool)"):format(wave), of_next, 0.95, absolute = allowed }
end
fabric.expect(rows)
