-- fabric.lab.identify with a model that is a little wrong: its error bars hold the true value, and it says that the data contradict the model.
-- The short form has fewer records.
local fabric = require "fabric"
local lab = fabric.lab
local draw = require "fabric.lab.random"(31)

local n, noise = 50, 0.02
local function model(p)
  local y = {}
  for k = 1, n do
    local x = k / n
    y[k] = p.a * x + p.b * x ^ 3
  end
  return y
end
local reference = { a = 1.3, b = 0.8 }

-- Fits records that differ from the model by `size` times the noise, smoothly; the parts of the true values within 1.96 deviations, of records that are said to contradict, and the mean deviation of a.
local function fitted(size, sets)
  local inside, told, width = 0, 0, 0
  for _ = 1, sets do
    local y, phase, waves = model(reference), 2 * math.pi * draw.uniform(), 0.5 + draw.uniform()
    for k = 1, n do y[k] = y[k] + noise * (size * math.sqrt(2) * math.cos(2 * math.pi * waves * k / n + phase) + draw.normal()) end
    local f = lab.identify { parameters = { { name = "a", start = 1, low = -5, high = 5 }, { name = "b", start = 1, low = -5, high = 5 } },
      tests = { { name = "curve", measured = y, noise = noise, predict = model } }, processes = 1 }
    for i, name in ipairs { "a", "b" } do inside = inside + (math.abs(f.parameters[name] - reference[name]) <= 1.96 * f.deviation[i] and 0.5 or 0) / sets end
    told, width = told + (f.text:find("The data contradict the model: they differ by more than the noise", 1, true) and 1 or 0) / sets, width + f.deviation[1] / sets
  end
  return inside, told, width
end

local more = os.getenv "FABRICSH_TEST_LONG" and 1 or 0.4
local inside, told, plain = fitted(0, 40 * more // 1)
assert(inside >= 0.9 and told <= 0.1, ("%g %g"):format(inside, told))
local width
inside, told, width = fitted(1, 120 * more // 1)
assert(inside >= 0.85 and told >= 0.4, ("%g %g"):format(inside, told)) -- long waves are taken up by the parameters: nothing shows them
assert(width < 5.3 * plain, width / plain) -- 8.4 times the bars of the noise alone
inside, told = fitted(3, 20 * more // 1)
assert(inside >= 0.85 and told >= 0.9, ("%g %g"):format(inside, told))

-- --- a model that is right: bars are not much wider than the noise makes them, and a wave of a third of the noise is held too; other curves, fewer and more points
do
  local count
  local function saturating(p)
    local y = {}
    for k = 1, count do y[k] = p.a * (1 - math.exp(-3 * k / count)) + p.b * (k / count) ^ 2 end
    return y
  end
  local true_values, sets = { a = 2, b = -0.6 }, 50 * more // 1
  for _, case in ipairs { { points = 24, size = 0 }, { points = 120, size = 0 }, { points = 120, size = 0.3 } } do
    count = case.points
    local held, wider = 0, 0
    for _ = 1, sets do
      local y, phase, waves = saturating(true_values), 2 * math.pi * draw.uniform(), 0.5 + draw.uniform()
      for k = 1, count do y[k] = y[k] + noise * (case.size * math.sqrt(2) * math.cos(2 * math.pi * waves * k / count + phase) + draw.normal()) end
      local f = lab.identify { parameters = { { name = "a", start = 1, low = -9, high = 9 }, { name = "b", start = 1, low = -9, high = 9 } },
        tests = { { name = "curve", measured = y, noise = noise, predict = saturating } }, processes = 1 }
      for i, name in ipairs { "a", "b" } do
        held = held + (math.abs(f.parameters[name] - true_values[name]) <= 1.96 * f.deviation[i] and 0.5 or 0) / sets
        wider = wider + f.deviation[i] / f.of_noise.deviation[i] / 2 / sets
      end
    end
    assert(held >= 0.9 and (case.size > 0 or wider < 2), ("%g %g"):format(held, wider))
  end
end

-- --- a parameter that the data push beyond its bound, and long records: the difference that is told has the size of the residuals and of what the other parameters take up
local long = 400
local function curved(p)
  local y = {}
  for k = 1, long do
    local x = k / long
    y[k] = p.a * x + p.b * x ^ 2 + p.c * x ^ 5
  end
  return y
end
local parameters = { { name = "a", start = 1, low = -5, high = 5 }, { name = "b", start = 1, low = -5, high = 5 }, { name = "c", start = 0.2, low = 0, high = 5 } }
for _, c in ipairs { -0.5, -2 } do
  local y = curved { a = 2, b = 1, c = c }
  for k = 1, long do y[k] = y[k] + noise * draw.normal() end
  local f = lab.identify { parameters = parameters, tests = { { name = "curve", measured = y, noise = noise, predict = curved } }, processes = 1 }
  assert(f.on_bound.c == 0 and f.deviation[3] ~= f.deviation[3] and f.discrepancy.told, f.text)
  assert(f.discrepancy.deviation < 4 * math.sqrt(f.chi2) and f.discrepancy.deviation > 0.3 * math.sqrt(f.chi2), f.discrepancy.deviation .. " " .. math.sqrt(f.chi2))
  assert(f.known.a and f.known.b, f.text)
end
local nothing = {}
for k = 1, long do nothing[k] = 0 end
local f = lab.identify { parameters = { parameters[1] }, tests = { { name = "none", measured = nothing, noise = noise, predict = function(p) return curved { a = p.a, b = 0, c = 0 } end } }, processes = 1 }
assert(f.text:find("none: largest miss of values that are all zero, ", 1, true), f.text)
