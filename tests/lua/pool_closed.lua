-- Four specimens that differ in noise and number of points, in closed form: their common value, the scatter between them, bands, each predicted by the others.
--
-- Specimen i shows s_i f, f the model's values for k = 1, so that its own value of k is s_i with the relative variance v_i = 1 / sum (k f / noise_i)^2. The weights
-- are w_i = 1 / (v_i + t^2), k = sum w s / sum w, and t is such that sum w (s / k - 1 - mean)^2 is the degrees of freedom, 3 [paule1982].
local fabric = require "fabric"
local checks = {}
local function check(name, got, want, relative) checks[#checks + 1] = { name, got, want, relative = relative } end

local own = { 1.9, 2.15, 2.02, 1.84 }
local noise = { 0.02, 0.35, 0.1, 0.25 }
local points = { 3, 5, 4, 2 }
local tests = {}
local function values(k, n)
  local y = {}
  for i = 1, n do y[i] = k * i end
  return y
end
for i, s in ipairs(own) do
  tests[i] = { name = "p" .. i, measured = values(s, points[i]), noise = noise[i], predict = function(p) return values(p.k, points[i]) end }
end
local f = fabric.lab.pool { parameters = { { name = "k", start = 1, low = 0, high = 50 } }, tests = tests, processes = 1 }

local function variance(i, k)
  local sum = 0
  for _, y in ipairs(values(k, points[i])) do sum = sum + (y / noise[i]) ^ 2 end
  return 1 / sum
end

-- The scatter of the factors s / k - 1 of some specimens, with so many degrees of freedom.
local function scatter(list, k, freedom)
  local function excess(t2)
    local weight, mean, sum = 0, 0, 0
    for _, i in ipairs(list) do weight, mean = weight + 1 / (variance(i, k) + t2), mean + (own[i] / k - 1) / (variance(i, k) + t2) end
    for _, i in ipairs(list) do sum = sum + (own[i] / k - 1 - mean / weight) ^ 2 / (variance(i, k) + t2) end
    return sum - freedom
  end
  if excess(0) <= 0 then return 0 end
  local low, high = 0, 1
  for _ = 1, 200 do
    local middle = (low + high) / 2
    if excess(middle) > 0 then low = middle else high = middle end
  end
  return math.sqrt(low)
end
local function common_value(list, k, t)
  local weight, sum = 0, 0
  for _, i in ipairs(list) do
    local w = 1 / (variance(i, k) + t * t)
    weight, sum = weight + w, sum + w * own[i]
  end
  return sum / weight, weight
end

local all, k = { 1, 2, 3, 4 }, f.parameters.k
check("between", f.between, scatter(all, k, 3), 1e-6)
local value, weight = common_value(all, k, f.between)
check("the common value", k, value, 1e-3) -- `between` of the round before differs by 2 % at most
check("its deviation", f.deviation[1], k / math.sqrt(weight), 5e-3) -- noise that was stated, not found: no residual but the factors
local plain = (own[1] + own[2] + own[3] + own[4]) / 4
assert(math.abs(value - plain) > 0.003 * plain, "weights matter")
for i = 1, 4 do
  check(("specimen %d: factor"):format(i), f.tests["p" .. i].factor, own[i] / k, 1e-9)
  check(("specimen %d: rms of its peak"):format(i), f.tests["p" .. i].rms * own[i] * points[i], math.abs(own[i] - k)
    * math.sqrt((points[i] + 1) * (2 * points[i] + 1) / 6), 1e-9)
  local others = {}
  for j = 1, 4 do
    if j ~= i then others[#others + 1] = j end
  end
  local left = common_value(others, k, scatter(others, k, 2))
  local got = f.left_out["p" .. i]
  check(("specimen %d: predicted by the others"):format(i), got.predicted[1], left, 1e-4)
  check(("specimen %d: missed at its end, of its peak"):format(i), got.at_end, (left - own[i]) / own[i], 1e-2)
end
-- Bands: of the mean, and wider by the scatter and the noise of a specimen; they hold together with Student's factor.
for i = 1, 4 do
  local test = f.tests["p" .. i]
  for j, y in ipairs(test.predicted) do
    local mean, next_one = test.high[j] - y, test.next_high[j] - y
    checks[#checks + 1] = { ("specimen %d, point %d: the band of a mean"):format(i, j), mean / y, (f.high.k - k) / k, relative = 1e-3 }
    local wider = (next_one / mean) ^ 2
    local least = 1 + (f.between ^ 2) * weight
    assert(wider > 0.5 * least and wider < 3 * (least + noise[i] ^ 2 * weight / y ^ 2), wider)
  end
end

-- Hardly any noise: the common value is the mean, its band t(0.975, 3) between / sqrt 4 wide to either side; the next specimen's t sqrt(1 + 1/4) between. Left out, a
-- specimen is predicted by three, with two degrees of freedom and the scatter of those three. Student's quantiles from his tables: 3.18245 and 4.30265.
do
  local exact = {}
  for i, s in ipairs(own) do
    exact[i] = { name = "p" .. i, measured = values(s, points[i]), noise = 1e-5, predict = function(p) return values(p.k, points[i]) end }
  end
  local g = fabric.lab.pool { parameters = { { name = "k", start = 1, low = 0, high = 50 } }, tests = exact, processes = 1 }
  local function spread(list)
    local mean, sum = 0, 0
    for _, i in ipairs(list) do mean = mean + own[i] / #list end
    for _, i in ipairs(list) do sum = sum + (own[i] - mean) ^ 2 end
    return mean, math.sqrt(sum / (#list - 1))
  end
  local mean, deviation = spread(all)
  check("without noise: the mean", g.parameters.k, mean, 1e-6)
  check("without noise: between", g.between, deviation / mean, 1e-4)
  check("without noise: band", g.high.k - g.parameters.k, 3.18245 * deviation / 2, 1e-3)
  check("without noise: the next one's band", g.tests.p2.next_high[2] - g.tests.p2.predicted[2], 3.18245 * deviation * math.sqrt(1.25) * 2, 1e-3)
  for i = 1, 4 do
    local others = {}
    for j = 1, 4 do
      if j ~= i then others[#others + 1] = j end
    end
    local left, of_three = spread(others)
    local held = g.left_out["p" .. i]
    -- The scatter is taken relative to the mean of all, and applied to what the others predict.
    check(("without noise, %d left out: band of the others"):format(i), held.high[1] - held.predicted[1], 4.30265 * of_three * math.sqrt((left / mean) ^ 2 + 1 / 3), 2e-3)
  end
end
fabric.expect(checks)
