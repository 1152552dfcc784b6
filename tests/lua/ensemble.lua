-- The ensemble sampler on densities that are known in closed form, on identify's likelihood, and what it refuses.
local fabric = require "fabric"
local lab = fabric.lab

local function near(got, want, absolute, what) assert(math.abs(got - want) <= absolute, ("%s: %g, want %g +- %g"):format(what, got, want, absolute)) end
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails
local function allowed(e, deviation) return 4 * deviation / math.sqrt(e.independent) end -- four standard errors

-- A normal density of two parameters of sizes 1 and 1000 that hang together by 0.95
local r = 0.95
local function normal(p)
  local x, y = p.x - 3, (p.y + 2000) / 1000
  return -(x * x - 2 * r * x * y + y * y) / (2 * (1 - r * r))
end
local two = { { name = "x", start = 0, low = -100, high = 100 }, { name = "y", start = 0, low = -1e5, high = 1e5 } }
local e = lab.ensemble { parameters = two, log = normal, steps = 1500, seed = 4 }
assert(e.independent > 500 and e.taken > 0.5 and e.failed == 0, e.text)
near(e.mean.x, 3, allowed(e, 1), "mean x")
near(e.mean.y, -2000, allowed(e, 1000), "mean y")
near(e.deviation[1], 1, allowed(e, 1), "deviation x")
near(e.deviation[2], 1000, allowed(e, 1000), "deviation y")
near(e.correlation[2], r, 0.02, "correlation")
near(e.low.x, 3 - 1.96, 3 * allowed(e, 1), "2.5 %")
near(e.high.x, 3 + 1.96, 3 * allowed(e, 1), "97.5 %")
assert(#e.samples.x == 1500 * 20 and e.best.x and e.log > -0.01)
-- the same again, draw for draw
assert(lab.ensemble({ parameters = two, log = normal, steps = 20, seed = 4 }).samples.y[400]
  == lab.ensemble({ parameters = two, log = normal, steps = 20, seed = 4, processes = 2 }).samples.y[400])

-- A banana: x normal of deviation 1, y normal of deviation 0.5 about x^2. Then E[y] = 1, var y = 2 + 0.25, E[x^2 y] = 3, cov(x, y) = 0.
local function banana(p) return -p.x ^ 2 / 2 - 2 * (p.y - p.x ^ 2) ^ 2 end
e = lab.ensemble { parameters = { { name = "x", start = 0, low = -20, high = 20 }, { name = "y", start = 1, low = -20, high = 100 } }, log = banana,
  steps = 4000, walkers = 40, seed = 5 }
near(e.mean.x, 0, allowed(e, 1), "banana: mean x")
near(e.deviation[1], 1, allowed(e, 1), "banana: deviation x")
near(e.mean.y, 1, allowed(e, 1.5), "banana: mean y")
near(e.deviation[2], 1.5, 2 * allowed(e, 1.5), "banana: deviation y")
near(e.correlation[2], 0, allowed(e, 1) * 2, "banana: correlation")
local third = 0
for k, x in ipairs(e.samples.x) do third = third + x ^ 2 * e.samples.y[k] / #e.samples.x end
near(third, 3, allowed(e, 7), "banana: E[x^2 y]")
assert(e.high.y - e.median.y > 2 * (e.median.y - e.low.y)) -- skew

-- Bounds hold: an exponential density from zero on has mean and deviation 1, and nothing below.
e = lab.ensemble { parameters = { { name = "x", start = 1, low = 0, high = 60 } }, log = function(p) return -p.x end, steps = 2000, seed = 6 }
near(e.mean.x, 1, allowed(e, 1), "exponential: mean")
near(e.low.x, -math.log(0.975), allowed(e, 1), "exponential: 2.5 %")
for _, x in ipairs(e.samples.x) do assert(x >= 0) end

-- The likelihood of identify: a straight line, whose posterior is normal with the deviations that identify says of the noise alone; smooth differences of the model are not in this likelihood.
local draw = require "fabric.lab.random" (3)
local measured = {}
for i = 1, 30 do measured[i] = 2 + 0.5 * i + 0.3 * draw.normal() end
local function line(p)
  local out = {}
  for i = 1, 30 do out[i] = p.a + p.b * i end
  return out
end
local problem = { parameters = { { name = "a", start = 1, low = -20, high = 20 }, { name = "b", start = 1, low = -5, high = 5 } },
  tests = { { name = "line", measured = measured, predict = line, noise = 0.3 } }, processes = 1 }
local found = lab.identify(problem)
problem.found, problem.steps = found, 1500
e = lab.ensemble(problem)
for i, name in ipairs { "a", "b" } do
  local deviation = found.of_noise.deviation[i]
  assert(deviation < found.deviation[i] and found.deviation[i] < 4 * deviation)
  near(e.mean[name], found.parameters[name], allowed(e, deviation), "line: " .. name)
  near(e.deviation[i], deviation, 1.5 * allowed(e, deviation), "line: deviation of " .. name)
end
near(e.correlation[2], found.of_noise.correlation[2], 0.03, "line: correlation")
assert(problem.parameters[1].start == 1) -- the deck's own table is left as it was

-- A failed evaluation counts as impossible and is reported; a chain that is too short says so first.
local function half(p)
  if p.x < 0 then error("no such cloth", 0) end
  return -p.x ^ 2 / 2
end
local one = { { name = "x", start = 1, low = -9, high = 9 } }
e = lab.ensemble { parameters = one, log = half, steps = 100, seed = 2 }
assert(e.failed > 0 and e.low.x >= 0 and e.text:find "simulations failed and count as impossible; the last: no such cloth", e.text)
assert(lab.ensemble({ parameters = two, log = normal, steps = 20 }).text:find "^too short a chain: 20 steps are", "too short")
fails("expected either tests or log", lab.ensemble, { parameters = one })
fails("ensemble: field 'parameters[1].start': expected a number, got nil", lab.ensemble, { parameters = { { name = "x", low = 0, high = 1 } }, log = half })
fails("ensemble: field 'walkers': expected an even number of at least 6 for 2 parameters, got 5", lab.ensemble, { parameters = two, log = normal, walkers = 5 })
fails("20 of 20 walkers have none: always", lab.ensemble, { parameters = one, log = function() error("always", 0) end })
fails("field 'found': expected a result of fabric.lab.identify with parameter 'x'", lab.ensemble, { parameters = one, log = half, found = { parameters = {} } })
