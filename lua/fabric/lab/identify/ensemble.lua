-- fabric.lab.ensemble: samples of the posterior distribution of parameters, for cases that a value with a standard deviation does not
-- describe: wide, skewed or curved distributions, or those limited by a bound.
--
-- The sampler is the affine-invariant one of [goodman2010]: a walker moves along the line through itself and a walker of the other half,
-- by a stretch z drawn with density 1/sqrt(z) between 1/a and a, and the move is accepted with probability min(1, z^(n-1) times the ratio
-- of the densities). Correlated parameters do not slow it down, because a linear map of the parameters does not change its moves, and
-- there is no step size to tune. It is implemented here because it is short, existing libraries depend on Python arrays, and the density
-- is a simulation by the deck in processes that this program starts.
local fabric = require "fabric"
local define = require "fabric.define"
local check = require "fabric.lab.identify.check"
local random = require "fabric.lab.random"
local lists = require "fabric.lists"
local fail = define.fail

local stretch = 2 -- a in the paper
local window = 5  -- number of autocorrelation times over which the autocorrelation is summed [sokal1997]
local enough = 50 -- autocorrelation times in a chain for a reliable estimate

local function named(t, x)
  local p = {}
  for i, parameter in ipairs(t.parameters) do p[parameter.name] = x[i] end
  return p
end

-- The log-likelihood that fabric.lab.identify maximises: minus half the sum of squares over the noise.
local function of_tests(t)
  return function(p)
    local sum = 0
    for _, test in ipairs(t.tests) do
      local predicted, largest = test.predict(p), 0
      for _, y in ipairs(test.measured) do largest = math.max(largest, math.abs(y)) end
      if type(predicted) ~= "table" or #predicted ~= #test.measured then
        error(("test '%s': expected %d predicted numbers, got %s"):format(test.name, #test.measured,
          type(predicted) == "table" and #predicted or tostring(predicted)), 0)
      end
      for i, y in ipairs(test.measured) do
        local noise = type(test.noise) == "table" and test.noise[i] or test.noise or 0.01 * largest
        sum = sum + ((predicted[i] - y) / noise) ^ 2
      end
    end
    return -sum / 2
  end
end

local function within(t, x)
  for i, p in ipairs(t.parameters) do
    if not (x[i] >= p.low and x[i] <= p.high) then return false end
  end
  return true
end

-- Answers in order. With one process this process does the work, to avoid the cost of another for a cheap density.
local function answers_of(t, count, work)
  if t.processes > 1 then return fabric.lab.parallel { count = count, processes = t.processes, work = work } end
  local out = {}
  for i = 1, count do
    local ok, answer = pcall(work, i)
    out[i] = ok and answer or { trouble = tostring(answer) }
  end
  return out
end

-- Log densities at several points, in parallel: minus infinity outside the bounds and where a simulation fails.
local function densities(t, log, points, failures)
  local out, work = {}, {}
  for k, x in ipairs(points) do
    out[k] = -math.huge
    if within(t, x) then work[#work + 1] = k end
  end
  if #work == 0 then return out end
  for i, answer in ipairs(answers_of(t, #work, function(i) return { log(named(t, points[work[i]])) } end)) do
    if answer.trouble == "stopped" or (answer.trouble or ""):find("interrupted", 1, true) then error("interrupted", 0) end
    local value = answer[1]
    if answer.trouble or type(value) ~= "number" or value ~= value or value == math.huge then
      failures.failed, failures.trouble = failures.failed + 1, answer.trouble or ("expected a finite number, got " .. tostring(value))
    else
      out[work[i]] = value
    end
  end
  return out
end

-- Initial walkers: around the start, with the width that `found` states or a twentieth of the bounds.
local function begin(t, draw)
  local out = {}
  for k = 1, t.walkers do
    out[k] = {}
    for i, p in ipairs(t.parameters) do
      local x
      local width = (p.high - p.low) / 20
      local known = t.found and t.found.deviation and t.found.deviation[i]
      if known and known == known and known > 0 then width = math.min(width, known) end
      repeat x = p.start + width * draw.normal() until x >= p.low and x <= p.high
      out[k][i] = x
    end
  end
  return out
end

-- Moves one half, each walker along the line through a walker of the other half; returns the number of accepted moves.
local function move_half(t, log, walkers, values, half, draw, failures)
  local n, count = #t.parameters, t.walkers // 2
  local first, other = half * count, (1 - half) * count
  local points, factors = {}, {}
  for k = 1, count do
    local z = ((stretch - 1) * draw.uniform() + 1) ^ 2 / stretch
    local partner, x = walkers[other + 1 + math.floor(draw.uniform() * count)], walkers[first + k]
    points[k], factors[k] = {}, (n - 1) * math.log(z)
    for i = 1, n do points[k][i] = partner[i] + z * (x[i] - partner[i]) end
  end
  local new, went = densities(t, log, points, failures), 0
  for k = 1, count do
    if math.log(draw.uniform()) < factors[k] + new[k] - values[first + k] then
      walkers[first + k], values[first + k], went = points[k], new[k], went + 1
    end
  end
  return went
end

-- Integrated autocorrelation time of the walkers' mean, in steps.
local function time_of(means)
  local n, mean = #means, 0
  for _, m in ipairs(means) do mean = mean + m / n end
  local function covariance(lag)
    local sum = 0
    for i = 1, n - lag do sum = sum + (means[i] - mean) * (means[i + lag] - mean) end
    return sum / n
  end
  local variance, tau = covariance(0), 1
  if not (variance > 0) then return n end
  for lag = 1, n - 1 do
    tau = tau + 2 * covariance(lag) / variance
    if lag >= window * tau then break end
  end
  return math.max(1, tau)
end

-- Mean, standard deviation, band and samples of every parameter, and their correlations.
local function summarise(t, out, draws)
  local n, means = #t.parameters, {}
  out.samples, out.mean, out.deviation, out.median, out.low, out.high, out.correlation = {}, {}, {}, {}, {}, {}, {}
  for i, p in ipairs(t.parameters) do
    local list, sum, squares = {}, 0, 0
    for k, x in ipairs(draws) do list[k], sum = x[i], sum + x[i] end
    means[i] = sum / #list
    for _, x in ipairs(list) do squares = squares + (x - means[i]) ^ 2 end
    out.samples[p.name], out.mean[p.name], out.deviation[i] = list, means[i], math.sqrt(squares / (#list - 1))
    local sorted = table.move(list, 1, #list, 1, {})
    table.sort(sorted)
    out.median[p.name] = lists.quantile(sorted, 0.5)
    out.low[p.name], out.high[p.name] = lists.quantile(sorted, (1 - t.level) / 2), lists.quantile(sorted, (1 + t.level) / 2)
  end
  for i = 1, n do
    for j = 1, n do
      local sum = lists.sum(draws, function(x) return (x[i] - means[i]) * (x[j] - means[j]) end)
      out.correlation[(i - 1) * n + j] = sum / (#draws - 1) / (out.deviation[i] * out.deviation[j])
    end
  end
end

local function text_of(t, out, failures)
  local lines = {}
  if out.steps < enough * out.time then
    lines[1] = ("too short a chain: %d steps are %.0f autocorrelation times, at least %d are wanted: give steps=%d"):format(out.steps, out.steps / out.time,
      enough, math.ceil(enough * out.time / 100) * 100)
  end
  for i, p in ipairs(t.parameters) do
    lines[#lines + 1] = ("%-16s %12.6g   %g %%: %.6g to %.6g (mean %.6g, deviation %.3g)"):format(p.name, out.median[p.name], 100 * t.level, out.low[p.name],
      out.high[p.name], out.mean[p.name], out.deviation[i])
  end
  lines[#lines + 1] = ("%d walkers, %d steps, %.0f %% of the moves accepted, autocorrelation time %.1f steps: worth %.0f independent draws"):format(t.walkers,
    out.steps, 100 * out.taken, out.time, out.independent)
  if failures.failed > 0 then lines[#lines + 1] = ("%d simulations failed and count as impossible; the last: %s"):format(failures.failed, failures.trouble) end
  return table.concat(lines, "\n")
end

local function check_arguments(t)
  if (t.tests == nil) == (t.log == nil) then fail "ensemble: field 'tests': expected either tests or log" end
  check({ parameters = t.parameters, tests = t.tests or { { name = "log", measured = { 0 }, predict = t.log } } }, "ensemble")
  local n = #t.parameters
  t.walkers = t.walkers or math.max(20, 4 * n)
  if t.walkers % 2 == 1 or t.walkers < 2 * n + 2 then
    fail(("ensemble: field 'walkers': expected an even number of at least %d for %d parameters, got %d"):format(2 * n + 2, n, t.walkers))
  end
  if t.found and type(t.found.parameters) == "table" then
    for i, p in ipairs(t.parameters) do
      local start = t.found.parameters[p.name]
      if type(start) ~= "number" then fail(("ensemble: field 'found': expected a result of fabric.lab.identify with parameter '%s'"):format(p.name)) end
      t.parameters[i] = { name = p.name, start = math.max(p.low, math.min(p.high, start)), low = p.low, high = p.high }
    end
  elseif t.found then
    fail "ensemble: field 'found': expected a result of fabric.lab.identify"
  end
end

local function ensemble(t)
  t.parameters = table.move(t.parameters, 1, #t.parameters, 1, {})
  check_arguments(t)
  local log, draw, failures = t.log or of_tests(t), random(t.seed), { failed = 0 }
  local walkers = begin(t, draw)
  local values = densities(t, log, walkers, failures)
  local possible = lists.sum(values, function(v) return (v > -math.huge and 1 or 0) end)
  if possible < t.walkers / 2 then
    fail(("ensemble: expected a start around which the density is known, %d of %d walkers have none: %s"):format(t.walkers - possible, t.walkers,
      failures.trouble or "it is zero there"))
  end
  local discard = t.steps // 4
  local draws, went, means, best = {}, 0, {}, nil
  for i = 1, #t.parameters do means[i] = {} end
  for step = 1, discard + t.steps do
    local taken = move_half(t, log, walkers, values, 0, draw, failures) + move_half(t, log, walkers, values, 1, draw, failures)
    if step > discard then
      went = went + taken
      for i in ipairs(means) do
        local sum = lists.sum(walkers, function(x) return x[i] end)
        means[i][step - discard] = sum / t.walkers
      end
      for k, x in ipairs(walkers) do
        draws[#draws + 1] = x
        if not best or values[k] > best.log then best = { log = values[k], x = x } end
      end
    end
  end
  local out = { steps = t.steps, walkers = t.walkers, taken = went / (t.steps * t.walkers), failed = failures.failed, level = t.level, time = 1 }
  for _, list in ipairs(means) do out.time = math.max(out.time, time_of(list)) end
  out.independent = t.steps * t.walkers / out.time
  out.best, out.log = named(t, best.x), best.log
  summarise(t, out, draws)
  out.text = text_of(t, out, failures)
  return out
end

define {
  name = "fabric.lab.ensemble",
  arguments = {
    { name = "parameters", kind = "table", sentence = "{ {name=, start=, low=, high=}, ... } as of fabric.lab.identify; any value between the bounds is as "
      .. "likely before the data" },
    { name = "tests", kind = "table", optional = true, sentence = "as of fabric.lab.identify: the same likelihood, exp(-chi^2/2)" },
    { name = "log", kind = "function", optional = true, sentence = "instead: function(p) that returns the logarithm of a density, up to a constant" },
    { name = "found", kind = "table", optional = true, sentence = "result of fabric.lab.identify: the walkers begin around it" },
    { name = "walkers", kind = "integer", low = 4, optional = true, sentence = "even; default: four a parameter, 20 at least" },
    { name = "steps", kind = "integer", low = 10, default = 1000, sentence = "that are kept, of every walker; each costs a simulation" },
    { name = "level", kind = "number", above = 0, high = 0.999, default = 0.95, sentence = "of the band from low to high" },
    { name = "processes", kind = "integer", low = 1, default = 1, sentence = "side by side" },
    { name = "seed", kind = "integer", low = 0, default = 1, sentence = "of all that is random" },
  },
  sentence = "Samples of the parameters' probability density given the data, for bands that are wide, skew or curved, by the ensemble sampler of Goodman and Weare: samples "
    .. "(lists by name), mean, median, low, high (by name), deviation, correlation, best (the likeliest draw, by name), log (of the density there), taken, time (autocorrelation, steps), independent (number of independent draws they are worth), failed, text.",
  example = "local e = require 'fabric'.lab.ensemble{ parameters={ {name='x', start=0, low=-9, high=9} }, steps=400,\n"
    .. "  log=function(p) return -p.x^2/2 end }\nassert(math.abs(e.deviation[1] - 1) < 0.15 and math.abs(e.mean.x) < 0.15)",
  retired = { "discard" },
  run = ensemble,
}
