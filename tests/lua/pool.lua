-- Several specimens in one identification: bands that hold the true value and the next specimen, the speed, the mesh, a model that the data contradict.
local fabric = require "fabric"
local lab = fabric.lab
local draw = require "fabric.lab.random" (7)

local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails

-- Pulls 8 E + 400 E^2, specimens off by 4 %, noise of 0.2 % of the peak.
local scatter, noise = 0.04, 0.03
local function curve(a, b)
  local y = {}
  for k = 1, 20 do y[k] = a * k / 100 + b * (k / 100) ^ 2 end
  return y
end
local function specimen(factor)
  local y = curve(8, 400)
  for k = 1, #y do y[k] = y[k] * factor + noise * draw.normal() end
  return y
end
local function predict(p) return curve(p.a, p.b) end
local parameters = { { name = "a", start = 10, low = 0, high = 100 }, { name = "b", start = 300, low = 0, high = 3000 } }
local function specimens(n)
  local tests = {}
  for i = 1, n do tests[i] = { name = "pull " .. i, measured = specimen(1 + scatter * draw.normal()), noise = noise, predict = predict } end
  return tests
end
local function pool(tests, more)
  local t = { parameters = parameters, tests = tests, processes = 1 }
  for k, v in pairs(more or {}) do t[k] = v end
  return lab.pool(t)
end

local trials = 100
local covered, alone, following, left, squares, of = 0, 0, 0, 0, 0, 0
for trial = 1, trials do
  local tests = specimens(5)
  local f = pool(tests)
  if f.low.b <= 400 and 400 <= f.high.b then covered = covered + 1 end
  if trial <= 25 then -- the same points taken for noise alone
    local g = lab.identify { parameters = parameters, tests = tests, processes = 1 }
    if math.abs(g.parameters.b - 400) <= 1.96 * g.deviation[2] / math.sqrt(g.chi2) then alone = alone + 1 end
  end
  local next_one = specimen(1 + scatter * draw.normal())
  for k, y in ipairs(next_one) do
    local test = f.tests["pull 1"]
    assert(test.next_low[k] < test.low[k] and test.low[k] < test.predicted[k] and test.high[k] < test.next_high[k])
    if test.next_low[k] <= y and y <= test.next_high[k] then following = following + 1 end
    of = of + 1
  end
  left, squares = left + f.coverage / trials, squares + f.between ^ 2 / trials
  assert(f.chi2 < 3, f.text)
end
assert(covered >= 89 and covered <= 100, covered) -- 95 +- 3 standard errors of a count
assert(alone <= 12, alone)                  -- what the stated noise alone would have said of it
assert(following / of > 0.88 and following / of < 0.995, following / of)
assert(left > 0.9 and left < 0.995, left)
assert(math.abs(math.sqrt(squares) / scatter - 1) < 0.1, math.sqrt(squares))

-- Specimens whose curves differ in shape too: what is left beside a factor hangs together along the curve, and is known from few. The band of the next
-- one holds as many of its points as it says, and not nearly all, that of a parameter the true value.
local function wavy()
  local y, own = curve(8, 400), 1 + scatter * draw.normal()
  local a, b = 0.02 * draw.normal(), 0.02 * draw.normal()
  for k, s in ipairs(y) do
    local x = (k - 0.5) / #y
    y[k] = s * (own + math.sqrt(2) * (a * math.cos(math.pi * x) + b * math.cos(2 * math.pi * x))) + 0.3 * noise * draw.normal()
  end
  return y
end
covered, left = 0, 0
for _ = 1, 60 do
  local tests = {}
  for i = 1, 5 do tests[i] = { name = "pull " .. i, measured = wavy(), noise = 0.3 * noise, predict = predict } end
  local g = pool(tests)
  left = left + g.coverage / 60
  if g.low.a <= 8 and 8 <= g.high.a then covered = covered + 1 end
end
assert(left > 0.9 and left < 0.985, left) -- 1.0 where what is left counts as known as well as noise
assert(covered >= 51, covered)              -- 57 less three standard errors of a count

-- a low specimen counts no more than a high one: the mean, not less
local three = {}
for i, factor in ipairs { 0.9, 1, 1.1 } do three[i] = { name = "p" .. i, measured = { 2 * factor, 4 * factor }, noise = 1e-3, predict = function(p) return { p.k, 2 * p.k } end } end
local f = pool(three, { parameters = { { name = "k", start = 1, low = 0, high = 10 } } })
assert(math.abs(f.parameters.k - 2) < 1e-5 and math.abs(f.between - 0.1) < 1e-3, f.text)
assert(math.abs(f.deviation[1] / 2 - 0.1 / math.sqrt(3)) < 1e-3) -- of the mean of three
assert(math.abs(f.left_out.p3.predicted[2] - 3.8) < 1e-3 and three[1].peak == nil)
-- one alone says nothing of the others, and says so
assert(pool({ three[1] }, { parameters = { { name = "k", start = 1, low = 0, high = 10 } } }).text:find "between specimens: unknown from so few")

-- Speeds 10, 100 and 500: force * (1 - 0.05 ln(v / 10)), which is -20 % at 500.
local function at_speed(v, i)
  local y = specimen((1 + 0.005 * draw.normal()) * (1 - 0.05 * math.log(v / 10)))
  return { name = ("%g, %d"):format(v, i), measured = y, noise = noise, predict = predict, rate = v }
end
local fast = {}
for _, v in ipairs { 10, 100, 500 } do
  for i = 1, 3 do fast[#fast + 1] = at_speed(v, i) end
end
f = pool(fast, { rate = { reference = 10 } })
assert(f.low.rate <= -0.05 and -0.05 <= f.high.rate and f.high.rate < -0.04 and f.low.rate > -0.06, f.text)
assert(f.low.b <= 400 and 400 <= f.high.b and f.between < 0.01 and f.text:find "speed: %-11", f.text)
f = pool(fast)
assert(f.between > 0.05, f.text) -- without the speed it passes for scatter

-- A mesh that makes all of it 8 % too stiff, and 2 % at half the size: the limit, and 2 % open.
local meshed = specimens(5)
for _, test in ipairs(meshed) do
  local function on(error) return function(p)
    local y = predict(p)
    for k = 1, #y do y[k] = y[k] * (1 + error) end
    return y
  end end
  test.predict, test.finer = on(0.08), on(0.02)
end
f = pool(meshed)
assert(math.abs(f.mesh - 0.02) < 1e-6, f.mesh)
local plain = specimens(0)
for i, test in ipairs(meshed) do plain[i] = { name = test.name, measured = test.measured, noise = noise, predict = predict } end
local exact = pool(plain)
assert(math.abs(f.parameters.b / exact.parameters.b - 1) < 1e-3 and f.deviation[2] > exact.deviation[2], f.text)
assert(math.abs(f.deviation[2] ^ 2 / (exact.deviation[2] ^ 2 + (0.02 * 400) ^ 2) - 1) < 0.1, f.deviation[2])
assert(f.text:find "mesh, once extrapolated: 2 %%")

-- Curves that the model has not: said first.
local cubic = {}
for i = 1, 4 do
  cubic[i] = { name = "c" .. i, noise = noise, predict = predict, measured = {} }
  for k = 1, 20 do cubic[i].measured[k] = (1 + 0.01 * i) * 3e4 * (k / 100) ^ 4 + noise * draw.normal() end
end
f = pool(cubic)
assert(f.chi2 > 4 and f.text:find "^The data contradict the model: the residuals are", f.text)
local told = lab.identify { parameters = parameters, tests = cubic, processes = 1 }
assert(told.text:find "^The data contradict the model: they differ by more than the noise", told.text)

local same = specimens(3)
for _, test in ipairs(same) do test.rate = 10 end
fails("pool: field 'rate': expected tests at two speeds or more, got 3 at one, 10", pool, same, { rate = { reference = 10 } })
local holed = specimens(2)
holed[2].measured[4] = nil
fails("pool: field 'tests[2].measured", pool, holed)
local shorter = specimens(2)
shorter[2].finer = function() return { 1, 2 } end
fails("pool: field 'tests[2].finer': expected 20 predicted numbers, one per measured one, got 2", pool, shorter)
fails("pool: field 'tests[1].rate': expected a positive number, since the speed plays a part, got nil", pool, specimens(2), { rate = { reference = 10 } })
fails("pool: field 'tests[1].finer': expected a function, got 3", pool, { { name = "x", measured = { 1 }, predict = predict, finer = 3 } })
fails("pool: unknown field 'tests[1].noize', did you mean 'tests[1].noise'?", pool, { { name = "x", measured = { 1 }, predict = predict, noize = 3 } })
fails("pool: field 'tests[1].measured': expected values that are not all zero", pool, { { name = "x", measured = { 0, 0 }, predict = predict } })
fails("pool: field 'tests': expected at least one, got 0", pool, {})
