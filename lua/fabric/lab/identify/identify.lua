-- fabric.lab.identify: card parameters from measured curves by simulating the tests, for parameters without a formula.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local card_bands = require "fabric.lab.identify.card_bands"
local discrepancy = require "fabric.lab.identify.discrepancy"
local store, check, text_of = require "fabric.lab.identify.store", require "fabric.lab.identify.check", require "fabric.lab.identify.text"
local lists = require "fabric.lists"
local fail = define.fail

local function named(t, point)
  local p = {}
  for i, parameter in ipairs(t.parameters) do p[parameter.name] = point[i] end
  return p
end

local function point_text(t, point)
  local words = lists.map(t.parameters, function(parameter, i) return ("%s=%.6g"):format(parameter.name, point[i]) end)
  return table.concat(words, ", ")
end

local function largest_of(list)
  local largest = 0
  for _, y in ipairs(list) do largest = math.max(largest, math.abs(y)) end
  return largest
end

local function deviation_of(test, i)
  if type(test.noise) == "table" then return test.noise[i] end
  return test.noise or 0.01 * largest_of(test.measured)
end

-- The prediction of a test; a result other than finite numbers means that the simulation failed.
local function predicted_by(test, p, count)
  local values = test.predict(p)
  if type(values) ~= "table" then error(("test '%s': expected predict to return a list of numbers, got %s"):format(test.name, tostring(values)), 0) end
  if count and #values ~= count then error(("test '%s': expected %d predicted numbers, got %d"):format(test.name, count, #values), 0) end
  for i, y in ipairs(values) do
    if type(y) ~= "number" or y ~= y or math.abs(y) == math.huge then
      error(("test '%s': expected predict to return finite numbers, got %s at place %d"):format(test.name, tostring(y), i), 0)
    end
  end
  return values
end

-- The predictions of all tests at a point, one after the other.
local function predictions(t, point)
  local p, out = named(t, point), {}
  for _, test in ipairs(t.tests) do
    local values = predicted_by(test, p, #test.measured)
    table.move(values, 1, #values, #out + 1, out)
  end
  return out
end

-- Predictions less measured values over the deviations; large values for a failed simulation, so that the search avoids it.
-- t.whiten (of fabric.lab.pool) removes their correlation.
local function residuals(t, predicted)
  local out = {}
  for _, test in ipairs(t.tests) do
    for i, y in ipairs(test.measured) do
      local k = #out + 1
      out[k] = predicted.trouble and 1e3 or (predicted[k] - y) / deviation_of(test, i)
    end
  end
  return t.whiten and not predicted.trouble and t.whiten(out) or out
end

local function cut_short(answer) return answer.died or (answer.trouble or ""):find("not enough memory", 1, true) end

-- Evaluates points in parallel. If a process ends without an answer (killed, out of memory), nothing is known about its point,
-- and it is tried again alone.
local function simulate(t, points)
  local function run(list, how)
    how.count, how.work = #list, function(i) return predictions(t, list[i]) end
    return fabric.lab.parallel(how)
  end
  local answers = run(points, { processes = t.processes })
  for i, answer in ipairs(answers) do
    if answer.trouble == "stopped" or answer.trouble == "interrupted" then error("interrupted", 0) end
    if cut_short(answer) then answers[i] = run({ points[i] }, { processes = 1, isolated = true })[1] end
  end
  return answers
end

local function keep(t, cache, points, answers)
  local lost
  for i, answer in ipairs(answers) do
    if cut_short(answer) then
      lost = lost or i
    elseif answer.trouble and #cache.points == 0 then
      fail("identify: the start cannot be simulated: " .. answer.trouble)
    else
      if answer.trouble and t.progress then io.stderr:write("identify: a simulation failed: ", answer.trouble, "\n") end
      cache.add(points[i], answer)
    end
  end
  cache.save()
  if lost then
    fail(("identify: the simulation at %s ended twice without an answer: %s"):format(point_text(t, points[lost]), answers[lost].trouble))
  end
end

-- Evaluates a list of points; known ones are taken from the cache.
local function evaluator(t, cache)
  local function unknown(points)
    local missing, seen = {}, {}
    for _, point in ipairs(points) do
      local key = store.key_of(point)
      if not cache.values[key] and not seen[key] then
        missing[#missing + 1], seen[key] = point, true
      end
    end
    return missing
  end
  return function(points)
    local missing = unknown(points)
    if #missing > 0 then keep(t, cache, missing, simulate(t, missing)) end
    local out = lists.map(points, function(point) return residuals(t, cache.values[store.key_of(point)]) end)
    if #missing > 0 and t.progress then
      local sum = lists.sum(out[1], function(r) return r * r end)
      io.stderr:write(("identify: %d simulations, chi^2 per point %.4g at %s\n"):format(#cache.points, sum / #out[1], point_text(t, points[1])))
    end
    return out
  end
end

-- Stored results must equal those of the present simulation: one stored point is simulated again. Another number of threads may
-- change the last digits of a simulation, so they are not compared bit by bit.
local function check_stored(t, cache)
  local point, stored
  for _, p in ipairs(cache.points) do
    if not stored and not cache.values[store.key_of(p)].trouble then point, stored = p, cache.values[store.key_of(p)] end
  end
  if not stored then return end
  local function other(how, ...)
    fail(("identify: field 'checkpoint': '%s' is of another problem: at %s " .. how):format(t.checkpoint, point_text(t, point), ...))
  end
  local answer = simulate(t, { point })[1]
  if answer.trouble then other("the simulation fails now: %s", answer.trouble) end
  local k = 0
  for _, test in ipairs(t.tests) do
    local largest = largest_of(table.move(stored, k + 1, k + #test.measured, 1, {}))
    for i = 1, #test.measured do
      k = k + 1
      if math.abs(answer[k] - stored[k]) > 1e-4 * largest then
        other("number %d of test '%s' is %.6g now, %.6g in the file", i, test.name, answer[k], stored[k])
      end
    end
  end
end

local function column(t, name)
  return lists.map(t.parameters, function(parameter) return parameter[name] end)
end

local function widths(t)
  return lists.map(t.parameters, function(parameter) return parameter.high - parameter.low end)
end

-- Jacobian of a further test at the solution, by differences, in units of its deviation.
local function further_rows(t, test, x, scale)
  local base = predicted_by(test, named(t, x))
  local rows = lists.of(#base, function() return {} end)
  for i = 1, #x do
    local there = table.move(x, 1, #x, 1, {})
    local step = 1e-3 * scale[i] * (x[i] - t.parameters[i].low > scale[i] / 2 and -1 or 1)
    there[i] = x[i] + step
    local moved = predicted_by(test, named(t, there), #base)
    for k = 1, #base do rows[k][i] = (moved[k] - base[k]) / step / deviation_of({ noise = test.noise, measured = base }, k) end
  end
  local flat = {}
  for _, row in ipairs(rows) do table.move(row, 1, #row, #flat + 1, flat) end
  return flat
end

-- Sorts further tests by the deviation of the weakest combination that would remain with each of them.
local function rank_further(t, found, scale)
  local ranked = {}
  for i, test in ipairs(t.further or {}) do
    local jacobian = table.move(found.jacobian, 1, #found.jacobian, 1, {})
    local rows = further_rows(t, test, found.x, scale)
    table.move(rows, 1, #rows, #jacobian + 1, jacobian)
    local known = kernels.identifiability { jacobian = jacobian, scale = scale }
    for k, d in ipairs(known.deviation) do known.deviation[k] = math.min(d, scale[k]) end
    ranked[i] = { name = test.name, weakest_deviation = math.min(1, known.weakest_deviation), deviation = known.deviation }
  end
  table.sort(ranked, function(a, b) return a.weakest_deviation < b.weakest_deviation end)
  return ranked
end

-- For each test: root mean square and largest residual, relative to the largest measured value and in deviations.
local function misses(t, residual)
  local out, at = {}, 0
  for _, test in ipairs(t.tests) do
    local sum, worst, deviations, largest = 0, 0, 0, largest_of(test.measured)
    for i in ipairs(test.measured) do
      local miss = residual[at + i] * deviation_of(test, i)
      sum, worst, deviations = sum + miss * miss, math.max(worst, math.abs(miss)), math.max(deviations, math.abs(residual[at + i]))
    end
    out[test.name] = { rms = math.sqrt(sum / #test.measured) / largest, worst = worst / largest, deviations = deviations }
    at = at + #test.measured
  end
  return out
end

-- The bounds that limit the search, by parameter: the minimum of the sum of squares along the parameter is beyond the bound by
-- more than a tenth of a deviation, or the parameter has reached the bound.
local function on_bound(t, found, scale)
  local out, n = {}, #t.parameters
  for i, p in ipairs(t.parameters) do
    local slope, square = 0, 0
    for k, r in ipairs(found.residuals) do
      local d = found.jacobian[(k - 1) * n + i]
      slope, square = slope + d * r, square + d * d
    end
    local bound = slope > 0 and p.low or p.high
    local room, step = math.abs(found.x[i] - bound), square > 0 and math.abs(slope) / square or 0
    local held = step > room and step > 0.1 / math.sqrt(square) and room < 0.01 * scale[i]
    if held or room < 1e-6 * scale[i] then out[p.name] = bound end
  end
  return out
end

-- Deviations that hold scatter above the stated noise and smooth differences of the model from the data; a deviation is half a 95 % band over 1.96. They never exceed those that follow
-- from the bounds alone.
local function widen(t, out, found, scale)
  local n, C, counts = #t.parameters, {}, {}
  out.of_noise = { deviation = table.move(out.deviation, 1, n, 1, {}), correlation = table.move(out.correlation, 1, n * n, 1, {}) }
  for i = 1, n do
    C[i] = {}
    for j = 1, n do C[i][j] = out.deviation[i] * out.deviation[j] * out.correlation[(i - 1) * n + j] end
  end
  if not t.whiten then -- fabric.lab.pool learns what the model misses from several specimens
    for i, test in ipairs(t.tests) do counts[i] = #test.measured end
    local fixed = lists.of(n, function(i) return out.on_bound[t.parameters[i].name] ~= nil end)
    local missed = discrepancy.of(found.residuals, counts, found.jacobian, C, fixed)
    if missed.deviation > 0 then
      out.discrepancy = { deviation = missed.deviation, ratio = missed.ratio, told = missed.told }
      for i = 1, n do
        out.deviation[i] = missed.half_width[i] / fabric.lab.student(0.975, 1e6)
        for j = 1, n do out.correlation[(i - 1) * n + j] = missed.covariance[i][j] / math.sqrt(missed.covariance[i][i] * missed.covariance[j][j]) end
      end
    end
  end
  out.known = {}
  for i, d in ipairs(out.deviation) do
    local name = t.parameters[i].name
    out.deviation[i] = out.on_bound[name] and 0 / 0 or math.min(scale[i], d * (out.discrepancy and 1 or math.sqrt(math.max(1, out.chi2))))
    out.known[name] = out.deviation[i] < 0.25 * scale[i]
  end
  out.weakest_deviation = math.min(1, out.weakest_deviation)
end

-- found:card(make): the card of the parameters, with their 95 % bands propagated to its numbers; a parameter on a bound counts as known.
local function card_of(t, out, make)
  local covariance = {}
  for i in ipairs(t.parameters) do
    covariance[i] = {}
    for j in ipairs(t.parameters) do
      local C = out.deviation[i] * out.deviation[j] * out.correlation[(i - 1) * #t.parameters + j]
      covariance[i][j] = C == C and C or 0
    end
  end
  local missed = out.discrepancy
  return card_bands("identify", out.parameters, t.parameters, covariance, fabric.lab.student(0.975, 1e6), 0.95, make, missed and missed.told
    and ("the data contradict the model: they differ from it smoothly by about %.2g times the noise, which the band holds"):format(missed.deviation) or nil)
end

local function identify(t)
  check(t)
  local count = lists.sum(t.tests, function(test) return #test.measured end)
  local cache = store.open(t.checkpoint, store.signature(t), count)
  check_stored(t, cache)
  local scale = widths(t)
  local found = kernels.least_squares { start = column(t, "start"), low = column(t, "low"), high = column(t, "high"),
    evaluate = evaluator(t, cache), iterations = t.iterations, tolerance = t.tolerance, difference = t.difference, settle = t.settle }
  local out = kernels.identifiability { jacobian = found.jacobian, scale = scale }
  local squares = lists.sum(found.residuals, function(r) return r * r end)
  out.chi2, out.on_bound = squares / math.max(1, #found.residuals - #t.parameters), on_bound(t, found, scale)
  widen(t, out, found, scale)
  out.x, out.iterations, out.reason, out.converged, out.simulations = found.x, found.iterations, found.reason, found.converged, #cache.points
  out.parameters, out.misses = named(t, found.x), misses(t, found.residuals)
  out.further = rank_further(t, found, scale)
  out.text = text_of(t, out)
  out.card = function(_, make) return card_of(t, out, make) end
  return out
end

define {
  name = "fabric.lab.identify",
  arguments = {
    { name = "parameters", kind = "table", sentence = "{ {name=, start=, low=, high=}, ... }; a logarithm where the size is not known" },
    { name = "tests", kind = "table",
      sentence = "{ {name=, measured={numbers}, predict=function(p) return numbers end, noise=}, ... }; p by parameter name; noise: one standard "
        .. "deviation, or one per number; default 1 % of the largest" },
    { name = "further", kind = "table", optional = true, sentence = "tests that could be made: {name=, predict=, noise=}; ranked by what they would add" },
    { name = "processes", kind = "integer", low = 1, default = 2, sentence = "side by side, for the differences" },
    { name = "checkpoint", kind = "text", optional = true,
      sentence = "file of the simulations so far; used if it exists, after one of its points has been simulated again" },
    { name = "key", kind = "text|number", optional = true, sentence = "what predict depends on beside the parameters: a checkpoint of another key is refused" },
    { name = "iterations", kind = "integer", low = 1, default = 30, sentence = "at most" },
    { name = "tolerance", kind = "number", above = 0, default = 1e-6, sentence = "relative, of the sum of squares and of the parameters" },
    { name = "difference", kind = "number", above = 0, default = 1e-3, sentence = "step of the differences over high - low" },
    { name = "settle", kind = "integer", low = 0, default = 8,
      sentence = "rounds at the end, with central differences over a standard deviation along combinations of parameters" },
    { name = "progress", kind = "boolean", default = false, sentence = "prints the progress on stderr" },
  },
  sentence = "Card parameters by bounded least squares through simulation. Returns parameters (by name), deviation (nan on a bound), "
    .. "on_bound (the bound, by name), known (by name), correlation, weakest, misses (per test: rms and worst over the largest measured value, "
    .. "deviations), chi2 (per degree of freedom), discrepancy (nil, or what the model may miss smoothly: deviation over the noise, ratio of likelihoods, told), of_noise (deviation and correlation by the stated noise alone), further (ranked), simulations, text, card(self, function(p) return card end): the "
    .. "card with the parameters' 95 % bands propagated to its numbers, for card:sample.",
  example = "local function S(p) return { fabric.point(fabric.card 'blend':with{ shear={ unloading=p.Gu } }):path{ {0, 0, 0.2}, {0, 0, 0.19} }[2].S12 } end\n"
    .. "local f = fabric.lab.identify{ parameters={ {name='Gu', start=5e6, low=3e6, high=3e7} }, processes=1,\n"
    .. "  tests={ {name='shear', measured=S{Gu=12e6}, predict=S} } }\nassert(math.abs(f.parameters.Gu / 12e6 - 1) < 1e-4)",
  run = identify,
}

return identify
