-- fabric.lab.pool: parameters from several specimens, sizes, laboratories and speeds together.
--
-- Specimen i shows (1 + b_i) times the model's values, where b_i has the standard deviation `between`, plus the noise of its points; the error
-- of the mesh is common to all simulated tests. So the covariance of the measured values is
--
--     C = N + between^2 sum_i f_i f_i^T + mesh^2 f f^T
--
-- (N: noise, diagonal; f_i: the model's values at the points of one specimen; f: of all that were simulated on a mesh), and the parameters
-- follow from least squares with it. `between` is chosen so that it explains the scatter of the specimens' own factors [paule1982]; the part of
-- the mesh is the uncertainty that remains after extrapolation from two meshes. If everything were taken as noise, a hundred points of one
-- specimen would count as a hundred specimens.
local fabric = require "fabric"
local define = require "fabric.define"
local card_bands = require "fabric.lab.identify.card_bands"
local check = require "fabric.lab.identify.check"
local numbers = require("fabric.lab.common.check").numbers
local effects = require "fabric.lab.card.effects"
local identify = require "fabric.lab.identify.identify"
local linear = require "fabric.lab.common.linear"
local shape = require "fabric.lab.identify.shape"
local lists = require "fabric.lists"
local dot, fail = lists.dot, define.fail

local rounds, settled = 6, 0.02 -- rounds of fitting and estimating the differences of specimens; relative change of `between` that ends them

local function largest_of(list)
  local largest = 0
  for _, y in ipairs(list) do largest = math.max(largest, math.abs(y)) end
  return largest
end

local function noise_of(test, k) return type(test.noise) == "table" and test.noise[k] or test.noise or 0.01 * test.peak end

-- For each test, the model's values (of the round before) over the noise. With measured values instead, a low specimen would appear more
-- certain, and all fitted values would be too low.
local function directions(t, predicted)
  local out = {}
  for i, test in ipairs(t.tests) do
    out[i] = {}
    for k, y in ipairs(predicted and predicted[i] or test.measured) do out[i][k] = y / noise_of(test, k) end
  end
  return out
end

-- Transforms residuals (over their noise, all tests one after the other) to independent ones of deviation 1.
local function whitener(t, predicted, between, mesh)
  local own, along = directions(t, predicted), {}
  for i, test in ipairs(t.tests) do
    local u = linear.whitened(own[i], own[i], between ^ 2)
    for k = 1, #u do along[#along + 1] = test.finer and u[k] or 0 end
  end
  return function(residuals)
    local out, at = {}, 0
    for i in ipairs(t.tests) do
      local part = linear.whitened(table.move(residuals, at + 1, at + #own[i], 1, {}), own[i], between ^ 2)
      table.move(part, 1, #part, at + 1, out)
      at = at + #part
    end
    return linear.whitened(out, along, mesh ^ 2)
  end
end

-- The tests in the form for fabric.lab.identify: with the effect of the speed in the predictions, and the known effect of the mesh.
local function for_identify(t, factors)
  local out = {}
  for i, test in ipairs(t.tests) do
    out[i] = { name = test.name, measured = test.measured, noise = test.noise, predict = function(p)
      local values = t.predicted(i, p)
      if not factors[i] then return values end
      return lists.map(values, function(y, k) return y * (factors[i][k] or 1) end)
    end }
  end
  return out
end

-- Prediction of a test with the effect of the speed: force * (1 + p.rate ln(rate / reference)).
local function with_rate(t, test, p, predict)
  local out = {}
  local factor = t.rate and 1 + p.rate * math.log(test.rate / t.rate.reference) or 1
  local values = (predict or test.predict)(p)
  if type(values) ~= "table" or #values ~= #test.measured then
    error(("test '%s': expected %d predicted numbers, got %s"):format(test.name, #test.measured, type(values) == "table" and #values or tostring(values)), 0)
  end
  for k, y in ipairs(values) do out[k] = y * factor end
  return out
end

-- The same on the finer mesh; wrong numbers are reported at the deck's line.
local function of_finer(t, i, p)
  local field, count = ("tests[%d].finer"):format(i), #t.tests[i].measured
  return with_rate(t, t.tests[i], p, function(own)
    local values = t.tests[i].finer(own)
    local got = type(values) == "table" and #values or tostring(values)
    if got ~= count then fail(("pool: field '%s': expected %d predicted numbers, one per measured one, got %s"):format(field, count, got)) end
    numbers("pool", field, values)
    return values
  end)
end

-- From a finer mesh: the ratio of limit to coarse value for every point, and the uncertainty of the limit.
local function mesh_of(t, p)
  local factors, open, whole = {}, 0, 0
  for i, test in ipairs(t.tests) do
    if test.finer then
      local coarse, fine = t.predicted(i, p), of_finer(t, i, p)
      local peak = largest_of(coarse)
      factors[i] = {}
      for k, f in ipairs(fine) do
        local limit = f + (f - coarse[k]) / 3 -- the error falls with the square of the size
        factors[i][k] = math.abs(coarse[k]) > 1e-6 * peak and limit / coarse[k] or 1
        open, whole = open + (limit - f) ^ 2, whole + limit ^ 2
      end
    end
  end
  return factors, whole > 0 and math.sqrt(open / whole) or 0
end

-- The scatter of the specimens' factors beyond their noise: factors b with variances v; `spent` is the number of fitted parameters. None where the
-- model's error has a scale of its own: tests are then not replicates that differ by a factor, and how they differ is learned after the fit.
local function scatter_of(t, b, v)
  local freedom = #b - t.spent
  if freedom < 1 or t.scaled then return 0 end
  local function excess(tau2)
    local weight, mean, sum = 0, 0, 0
    for i, x in ipairs(b) do weight, mean = weight + 1 / (v[i] + tau2), mean + x / (v[i] + tau2) end
    for i, x in ipairs(b) do sum = sum + (x - mean / weight) ^ 2 / (v[i] + tau2) end
    return sum - freedom
  end
  if excess(0) <= 0 then return 0 end
  local low, high = 0, 1e-8
  while excess(high) > 0 do high = 4 * high end
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if excess(middle) > 0 then low = middle else high = middle end
  end
  return math.sqrt(high)
end

-- The factor of each specimen relative to the model, and its variance from noise.
local function own_factors(t, predicted)
  local b, v = {}, {}
  for i, test in ipairs(t.tests) do
    local square, along = 0, 0
    for k, y in ipairs(test.measured) do
      local s = noise_of(test, k)
      square, along = square + (predicted[i][k] / s) ^ 2, along + (y - predicted[i][k]) * predicted[i][k] / s ^ 2
    end
    b[i], v[i] = along / square, 1 / square
  end
  return b, v
end

local function without(list, place)
  return lists.collect(list, function(x, i) if i ~= place then return x end end)
end

-- Derivatives of all predictions by the parameters, by differences of a tenth of a deviation to both sides.
local function derivatives(t, tests, found)
  local out = {}
  for i in ipairs(tests) do out[i] = {} end
  for j, p in ipairs(t.parameters) do
    local width = p.high - p.low
    local d = found.deviation[j]
    local step = math.min(1e-2 * width, math.max(1e-6 * width, 0.1 * (d == d and d or 0)))
    local low, high = lists.copy(found.parameters), lists.copy(found.parameters)
    low[p.name], high[p.name] = math.max(p.low, low[p.name] - step), math.min(p.high, high[p.name] + step)
    for i, test in ipairs(tests) do
      local a, b = test.predict(low), test.predict(high)
      for k = 1, #a do
        out[i][k] = out[i][k] or {}
        out[i][k][j] = (b[k] - a[k]) / (high[p.name] - low[p.name])
      end
    end
  end
  return out
end

-- Normal equations for some specimens: the matrix (with the bounds as prior information), the right side, and for each specimen the slopes and
-- the direction of its factor, both over the noise and multiplied by the inverse covariance.
local function normal_equations(t, state, between, leave)
  local slopes, rest = state.slopes, state.rest
  local n, own = #t.parameters, directions(t, state.predicted)
  local A, b, weighted = linear.zeros(n), {}, {}
  for j, p in ipairs(t.parameters) do A[j][j], b[j] = 1 / (p.high - p.low) ^ 2, 0 end
  for i, test in ipairs(t.tests) do
    if i ~= leave then
      local columns = {}
      for j = 1, n do
        columns[j] = {}
        for k = 1, #test.measured do columns[j][k] = slopes[i][k][j] / noise_of(test, k) end
        columns[j] = linear.whitened(columns[j], own[i], between ^ 2)
      end
      local r = lists.of(#test.measured, function(k) return rest[i][k] / noise_of(test, k) end)
      r = linear.whitened(r, own[i], between ^ 2)
      weighted[i] = { factor = own[i] }
      for j = 1, n do
        b[j] = b[j] + dot(columns[j], r)
        for l = 1, n do A[j][l] = A[j][l] + dot(columns[j], columns[l]) end
        weighted[i][j] = linear.whitened(columns[j], own[i], between ^ 2)
      end
    end
  end
  return A, b, weighted
end

-- The two parts of the variance of x . parameters; single points' noise is the least of the second.
local function parts_of(covariance, x)
  return { factors = linear.quadratic(covariance.factors, x), others = math.max(linear.quadratic(covariance.others, x), linear.quadratic(covariance.noise, x)) }
end

-- The differences of specimens beyond their factors, from all but one of them.
local function shape_of(t, state, leave)
  local own, residuals, along = directions(t, state.predicted), {}, {}
  for i, test in ipairs(t.tests) do
    if i ~= leave then
      local r = lists.of(#test.measured, function(k) return state.rest[i][k] / noise_of(test, k) end)
      residuals[#residuals + 1], along[#along + 1] = r, own[i]
    end
  end
  local out = shape.of(residuals, along, #t.parameters)
  out.variance = math.max(1, out.variance) -- the stated noise at least
  return out
end

-- A^-1 M A^-1
local function enclosed(inverse, M) return linear.product(linear.product(inverse, M), inverse) end

-- Covariance of the parameters in two parts: by the specimens' factors, and by what they differ by besides (which is correlated along a curve).
local function covariances(t, A, weighted, between, rest)
  local n, factors, others, noise = #t.parameters, linear.zeros(#t.parameters), linear.zeros(#t.parameters), linear.zeros(#t.parameters)
  for i = 1, #t.tests do
    local columns, correlated = weighted[i] or {}, {}
    for j = 1, weighted[i] and n or 0 do correlated[j] = shape.times(rest.correlation, columns[j]) end
    for j = 1, weighted[i] and n or 0 do
      local along = dot(columns[j], columns.factor)
      for l = 1, n do
        factors[j][l] = factors[j][l] + between ^ 2 * along * dot(columns[l], columns.factor)
        others[j][l] = others[j][l] + rest.variance * dot(columns[j], correlated[l])
        noise[j][l] = noise[j][l] + dot(columns[j], columns[l])
      end
    end
  end
  for j, p in ipairs(t.parameters) do others[j][j] = others[j][j] + 1 / (p.high - p.low) ^ 2 end
  local inverse = linear.inverse(A)
  return { factors = enclosed(inverse, factors), others = enclosed(inverse, others), noise = enclosed(inverse, noise), stated = inverse }
end

-- Half the width of a band: the deviation times Student's quantile for the degrees of freedom that its parts have together.
local function half_width(t, parts, freedom, rest, known)
  local variance = parts.factors + parts.others + (known or 0)
  if variance <= 0 then return 0 end
  local together = variance ^ 2 / (parts.factors ^ 2 / math.max(1, freedom) + parts.others ^ 2 / rest.freedom)
  return math.sqrt(variance) * fabric.lab.student(0.5 + t.level / 2, math.min(1e6, together))
end

-- Half widths of the bands of a test's predictions: of the mean, and of the next specimen.
local function half_widths(t, test, slopes, predicted, covariance, between, freedom, rest, mesh)
  local mean, next_one = {}, {}
  for k, f in ipairs(predicted) do
    local parts = parts_of(covariance, slopes[k])
    local known = test.finer and (mesh * f) ^ 2 or 0
    mean[k] = half_width(t, parts, freedom, rest, known)
    parts.factors, parts.others = parts.factors + (between * f) ^ 2, parts.others + rest.variance * noise_of(test, k) ^ 2
    next_one[k] = half_width(t, parts, freedom, rest, known)
  end
  return mean, next_one
end

local function edges(values, half)
  local low, high = {}, {}
  for k, y in ipairs(values) do low[k], high[k] = y - half[k], y + half[k] end
  return low, high
end

-- How far a prediction is from what was measured: rms and error at the end over the peak, share of the points in the band (nil without one).
local function compared(measured, predicted, peak)
  local squares, inside, n = 0, 0, #measured
  for k, y in ipairs(measured) do
    squares = squares + (y - predicted.predicted[k]) ^ 2
    if predicted.low and predicted.low[k] <= y and y <= predicted.high[k] then inside = inside + 1 end
  end
  return { inside = predicted.low and inside / n or nil, points = n, rms = math.sqrt(squares / n) / peak,
    at_end = (predicted.predicted[n] - measured[n]) / peak, predicted = predicted.predicted, low = predicted.low, high = predicted.high, reason = predicted.reason }
end

-- Predicts a left-out specimen from the others: one Gauss-Newton step from the fit of all, then the simulation itself.
local function left_out(t, tests, state, i)
  local between = scatter_of(t, without(state.factors, i), without(state.variances, i))
  local A, b, weighted = normal_equations(t, state, between, i)
  local rest = shape_of(t, state, i)
  local step, p = linear.solve(A, b), {}
  for j, parameter in ipairs(t.parameters) do
    p[parameter.name] = math.max(parameter.low, math.min(parameter.high, state.found.parameters[parameter.name] + step[j]))
  end
  local test, predicted = t.tests[i], tests[i].predict(p)
  local _, half = half_widths(t, test, state.slopes[i], predicted, covariances(t, A, weighted, between, rest), between, #tests - 1 - t.spent, rest, state.mesh)
  local low, high = edges(predicted, half)
  return compared(test.measured, { predicted = predicted, low = low, high = high }, test.peak)
end

-- The effect of the speed takes two speeds at least.
local function check_speeds(t)
  local slow, fast = math.huge, 0
  for _, test in ipairs(t.tests) do slow, fast = math.min(slow, test.rate), math.max(fast, test.rate) end
  if fast < 1.01 * slow then
    fail(("pool: field 'rate': expected tests at two speeds or more, got %d at one, %g, from which the effect of speed cannot be determined"):format(#t.tests, slow))
  end
end

-- The fields of a test that fabric.lab.identify knows, with the deck's model as its prediction.
local function plain_test(t, test, known)
  local out = {}
  for key, value in pairs(test) do
    if not known[key] and not t.model then out[key] = value end
  end
  for _, name in ipairs { "name", "measured", "predict", "noise" } do out[name] = test[name] end
  if t.model and test.predict == nil then out.predict = function(p) return t.model(p, test) end end
  return out
end

local function check_labels(t, i, test)
  for _, name in ipairs(t.groups) do
    if type(test[name]) ~= "string" and type(test[name]) ~= "number" then
      fail(("pool: field 'tests[%d].%s': expected a name or a number, since specimens are grouped by it, got %s"):format(i, name, tostring(test[name])))
    end
  end
  for _, name in ipairs { "x", "scale" } do
    if test[name] ~= nil and numbers("pool", ("tests[%d].%s"):format(i, name), test[name]) ~= #test.measured then
      fail(("pool: field 'tests[%d].%s': expected %d numbers, one per measured one, got %d"):format(i, name, #test.measured, #test[name]))
    end
  end
end

local function check_arguments(t)
  local plain, known = {}, { rate = true, finer = true, x = true, scale = true }
  for i = 1, #t.groups do
    if type(t.groups[i]) ~= "string" then fail(("pool: field 'groups[%d]': expected the name of a field of the tests, got %s"):format(i, tostring(t.groups[i]))) end
    known[t.groups[i]] = true
  end
  for i = 1, #t.tests do
    local test = t.tests[i]
    plain[i] = test
    if type(test) == "table" then
      plain[i] = plain_test(t, test, known)
      if test.finer ~= nil and type(test.finer) ~= "function" then
        fail(("pool: field 'tests[%d].finer': expected a function, got %s"):format(i, tostring(test.finer)))
      end
      if t.rate and not (type(test.rate) == "number" and test.rate > 0 and test.rate < math.huge) then
        fail(("pool: field 'tests[%d].rate': expected a positive number, since the speed plays a part, got %s"):format(i, tostring(test.rate)))
      end
    end
  end
  local parameters = table.move(t.parameters, 1, #t.parameters, 1, {})
  if t.rate then parameters[#parameters + 1] = { name = "rate", start = 0, low = -(t.rate.most or 0.2), high = t.rate.most or 0.2 } end
  check({ parameters = parameters, tests = plain }, "pool")
  for i, test in ipairs(t.tests) do check_labels(t, i, test) end
  if t.rate then check_speeds(t) end
  return parameters, plain
end

-- --- what the model misses, and specimens that were not tested ---

-- A test or an asked-for specimen as fabric.lab.effects takes it: abscissa, scale, columns and labels.
local function for_effects(t, test, predicted, slopes)
  local out = { x = test.x, scale = test.scale or predicted, columns = {}, labels = {} }
  for j = 1, #t.parameters do
    out.columns[j] = {}
    for k = 1, #predicted do out.columns[j][k] = slopes[k][j] end
  end
  for _, name in ipairs(t.groups) do out.labels[name] = test[name] end
  return out
end

local function learn(t, state)
  local tests = {}
  for i, test in ipairs(t.tests) do
    tests[i] = for_effects(t, test, state.predicted[i], state.slopes[i])
    tests[i].rest = state.rest[i]
  end
  return effects.learn(tests, t.groups, t.level)
end

-- The ratio by which a finer mesh changes the predictions, of the tests that have one.
local function mean_correction(state)
  local sum, n = 0, 0
  for _, list in pairs(state.correction) do
    for _, factor in ipairs(list) do sum, n = sum + factor, n + 1 end
  end
  return n > 0 and sum / n or 1
end

-- A specimen by the model, what it misses, and the band.
local function predict_specimen(t, state, specimen, predict)
  local correction = mean_correction(state)
  local function values(p)
    local out = with_rate(t, { name = specimen.name or "asked for", measured = specimen.x, rate = specimen.rate, predict = predict }, p)
    for k, y in ipairs(out) do out[k] = y * correction end
    return out
  end
  local predicted = values(state.found.parameters)
  local slopes = derivatives(t, { { predict = values } }, state.found)[1]
  local learned, reason = state.effects:predict(for_effects(t, specimen, predicted, slopes))
  local out = { x = specimen.x, predicted = predicted, band = learned and "learned" or nil, reason = reason }
  if learned then
    local half = {}
    for k, y in ipairs(predicted) do
      predicted[k] = y + learned.shift[k]
      half[k] = math.sqrt((state.widen * learned.half[k]) ^ 2 + (fabric.lab.student(0.5 + t.level / 2, 1e6) * state.mesh * y) ^ 2)
    end
    out.low, out.high = edges(predicted, half)
  end
  return out
end

local function text_of(t, out)
  local lines = {}
  if out.chi2 > 4 then
    lines[1] = ("The data contradict the model: the residuals are %.3g times the stated noise, beyond the scatter of specimens; bands are widened by this factor, and may mean little."):format(math.sqrt(out.chi2))
  end
  for _, p in ipairs(t.parameters) do
    lines[#lines + 1] = ("%-16s %12.6g   %g %%: %.6g to %.6g"):format(p.name, out.parameters[p.name], 100 * t.level, out.low[p.name], out.high[p.name])
  end
  if t.rate then
    lines[#lines + 1] = ("speed: %+.3g %% a decade, %.3g to %.3g"):format(100 * out.parameters.rate * math.log(10), 100 * out.low.rate * math.log(10),
      100 * out.high.rate * math.log(10))
  end
  lines[#lines + 1] = not t.scaled and (#t.tests - t.spent >= 1 and ("between specimens: %.3g %% (deviation of %d)"):format(100 * out.between, #t.tests)
    or "between specimens: unknown from so few; these bands are of the noise of the records alone") or nil
  if out.mesh > 0 then lines[#lines + 1] = ("mesh, once extrapolated: %.3g %%"):format(100 * out.mesh) end
  for _, test in ipairs(t.tests) do
    local held = out.left_out and out.left_out[test.name]
    lines[#lines + 1] = ("%s: rms %.3g %% of the peak%s"):format(test.name, 100 * out.tests[test.name].rms, held
      and ("; left out %.3g %%, at the end %+.3g %%, %.0f %% of its points in the band of the others"):format(100 * held.rms, 100 * held.at_end,
        100 * held.inside) or "")
  end
  for _, name in ipairs(t.groups) do
    for _, held in ipairs(out.left_out_by and out.left_out_by[name] or {}) do
      lines[#lines + 1] = ("%s %s from the others: rms %.3g %% of the peak, %s"):format(name, held.label, 100 * held.rms, held.inside
        and ("%.0f %% of %d points in the band"):format(100 * held.inside, held.points) or "no band: " .. held.reason)
    end
  end
  lines[#lines + 1] = effects.text(out.effects) .. (out.widen > 1 and ("; bands %.3g times as wide, so that they hold labels left out"):format(out.widen) or "")
  return table.concat(lines, "\n")
end

-- Fits, estimates the differences of specimens and meshes, and repeats until they are constant.
local function iterate(t)
  local state = { between = 0, mesh = 0, correction = {} }
  local tests, found, predicted
  local parameters = t.parameters
  for round = 1, rounds do
    tests = for_identify(t, state.correction)
    found = identify { parameters = parameters, tests = tests, processes = t.processes, iterations = t.iterations, tolerance = 1e-6,
      difference = 1e-3, settle = 8, progress = t.progress, whiten = whitener(t, predicted, state.between, state.mesh) }
    predicted = {}
    for i, test in ipairs(tests) do predicted[i] = test.predict(found.parameters) end
    state.factors, state.variances = own_factors(t, predicted)
    local between = scatter_of(t, state.factors, state.variances)
    local correction, mesh = mesh_of(t, found.parameters)
    local same = math.abs(between - state.between) <= settled * between and math.abs(mesh - state.mesh) <= settled * mesh
    state.between, state.mesh, state.correction = between, mesh, correction
    if same and round > 1 then break end
    parameters = {}
    for i, p in ipairs(t.parameters) do parameters[i] = { name = p.name, start = found.parameters[p.name], low = p.low, high = p.high } end
  end
  state.found, state.predicted, state.rest = found, predicted, {}
  for i, test in ipairs(t.tests) do
    state.rest[i] = {}
    for k, y in ipairs(test.measured) do state.rest[i][k] = y - predicted[i][k] end
  end
  return state, tests
end

-- Fits and learns what the model misses.
local function fitted(t)
  local state, tests = iterate(t)
  state.slopes, state.widen = derivatives(t, tests, state.found), 1
  state.effects = learn(t, state)
  return state, tests
end

local function labels_of(t, group)
  local labels, seen = {}, {}
  for _, test in ipairs(t.tests) do
    if not seen[test[group]] then labels[#labels + 1], seen[test[group]] = test[group], true end
  end
  return labels
end

-- The tests without those of a label, and these.
local function split(t, group, label)
  local part, held = setmetatable({ tests = {} }, { __index = t }), {}
  for _, test in ipairs(t.tests) do table.insert(test[group] == label and held or part.tests, test) end
  part.predicted = function(i, p) return with_rate(t, part.tests[i], p) end
  return part, held
end

-- Calls visit(label, test, comparison) for the tests of each label of a group, predicted by a fit to the others; prepare(part, state) may change that fit's answer.
local function without_labels(t, group, prepare, visit)
  local labels = labels_of(t, group)
  for _, label in ipairs(#labels > 1 and labels or {}) do
    local part, held = split(t, group, label)
    local state = fitted(part)
    prepare(part, state)
    for _, test in ipairs(held) do visit(label, test, compared(test.measured, predict_specimen(part, state, test.asked, test.predict), test.peak)) end
  end
end

-- The factor on the bands with which they hold the stated share of the points of labels left out, at least 1: how far a model that is not linear is off where
-- it was not fitted, its derivatives do not show it. Only where tests are not replicates.
local function widening(t)
  local ratios = {}
  for _, group in ipairs(t.scaled and t.leave and t.groups or {}) do
    without_labels(t, group, function() end, function(_, test, own)
      for k, y in ipairs(own.low and test.measured or {}) do
        ratios[#ratios + 1] = math.abs(y - own.predicted[k]) / math.max(1e-300, (own.high[k] - own.low[k]) / 2)
      end
    end)
  end
  table.sort(ratios)
  return math.max(1, ratios[math.ceil(t.level * #ratios)] or 1)
end

-- How well the tests of each label of a group are predicted from those of the other labels.
local function leave_labels_out(t, group)
  local out, by = {}, {}
  without_labels(t, group, function(part, state) state.widen = widening(part) end, function(label, test, own)
    local held = by[label]
    if not held then
      held = { label = tostring(label), points = 0, rms = 0, inside = 0, tests = {} }
      out[#out + 1], by[label] = held, held
    end
    held.tests[test.name], held.reason = own, own.reason or held.reason
    held.points, held.rms, held.inside = held.points + own.points, held.rms + own.rms ^ 2 * own.points, held.inside + (own.inside or 0) * own.points
  end)
  for _, held in ipairs(out) do
    held.rms, held.inside = math.sqrt(held.rms / held.points), not held.reason and held.inside / held.points or nil
  end
  return out
end

-- pool:predict: the deck's model for a specimen that was not tested.
local function predict_of(t, state, specimen)
  if not t.model then fail "pool: predict: expected pool{ model=function(p, specimen) return numbers end }, got tests with predictions of their own" end
  if type(specimen) ~= "table" or type(specimen.x) ~= "table" or #specimen.x == 0 then
    fail "pool: predict: expected { x={numbers}, ... } with the fields that the model and the groups need"
  end
  numbers("pool", "x", specimen.x)
  if t.rate and not (type(specimen.rate) == "number" and specimen.rate > 0) then
    fail(("pool: predict: field 'rate': expected a positive number, since the speed plays a part, got %s"):format(tostring(specimen.rate)))
  end
  return predict_specimen(t, state, specimen, function(p) return t.model(p, specimen) end)
end

local function places(n)
  return lists.of(n, function(k) return k / n end)
end

local function pool(t)
  local plain
  t.groups = t.groups or {}
  t.parameters, plain = check_arguments(t)
  t.tests = table.move(t.tests, 1, #t.tests, 1, {})
  for i, test in ipairs(t.tests) do
    local own = { peak = largest_of(test.measured) }
    for key, value in pairs(test) do own[key] = value end
    own.x = own.x or places(#own.measured)
    own.predict, own.asked = plain[i].predict, setmetatable({ x = own.x }, { __index = test })
    t.tests[i] = own
    if own.peak == 0 then fail(("pool: field 'tests[%d].measured': expected values that are not all zero"):format(i)) end
  end
  t.spent = t.rate and 2 or 1
  for _, test in ipairs(t.tests) do t.scaled = t.scaled or test.scale ~= nil end
  t.predicted = function(i, p) return with_rate(t, t.tests[i], p) end
  local state, tests = fitted(t)
  local A, _, weighted = normal_equations(t, state, state.between)
  local rest, freedom = shape_of(t, state), #t.tests - t.spent
  local covariance = covariances(t, A, weighted, state.between, rest)
  local out = { parameters = state.found.parameters, on_bound = state.found.on_bound, chi2 = state.found.chi2, between = state.between, mesh = state.mesh,
    deviation = {}, low = {}, high = {}, covariance = {}, tests = {}, level = t.level, simulations = state.found.simulations }
  for j, p in ipairs(t.parameters) do
    local unit = lists.of(#t.parameters, function(l) return l == j and 1 or 0 end)
    local parts = parts_of(covariance, unit)
    -- The mesh's error is common to all specimens: the fit's own deviation has it.
    local with_mesh = state.mesh > 0 and state.found.deviation[j] or 0
    local known = math.max(0, (with_mesh == with_mesh and with_mesh or 0) ^ 2 / math.max(1, state.found.chi2) - covariance.stated[j][j])
    out.deviation[j] = math.min(p.high - p.low, math.sqrt(parts.factors + parts.others + known))
    local half = half_width(t, parts, freedom, rest, known)
    out.low[p.name] = math.max(p.low, out.parameters[p.name] - half)
    out.high[p.name] = math.min(p.high, out.parameters[p.name] + half)
    for l = 1, #t.parameters do out.covariance[(j - 1) * #t.parameters + l] = covariance.factors[j][l] + covariance.others[j][l] end
  end
  for i, test in ipairs(t.tests) do
    local mean, next_one = half_widths(t, test, state.slopes[i], state.predicted[i], covariance, state.between, freedom, rest, state.mesh)
    local own = { predicted = state.predicted[i], factor = 1 + state.factors[i] }
    own.low, own.high = edges(own.predicted, mean)
    own.next_low, own.next_high = edges(own.predicted, next_one)
    own.rms = math.sqrt(dot(state.rest[i], state.rest[i]) / #own.predicted) / test.peak
    out.tests[test.name] = own
  end
  if freedom >= 2 and not t.scaled then
    out.left_out, out.coverage = {}, 0
    for i, test in ipairs(t.tests) do
      out.left_out[test.name] = left_out(t, tests, state, i)
      out.coverage = out.coverage + out.left_out[test.name].inside / #t.tests
    end
  end
  out.effects = state.effects
  if t.leave and #t.groups > 0 then
    out.left_out_by = {}
    for _, name in ipairs(t.groups) do out.left_out_by[name] = leave_labels_out(t, name) end
    state.widen = widening(t)
  end
  out.widen = state.widen
  out.card = function(_, make)
    local C, n = {}, #t.parameters
    for i = 1, n do C[i] = table.move(out.covariance, (i - 1) * n + 1, i * n, 1, {}) end
    return card_bands("pool", out.parameters, t.parameters, C, fabric.lab.student(0.5 + t.level / 2, math.max(1, freedom)), t.level, make, out.chi2 > 4
      and ("the data contradict the model: the residuals are %.3g times the stated noise, by which the band is widened"):format(math.sqrt(out.chi2)) or nil)
  end
  out.predict = function(_, specimen) return predict_of(t, state, specimen) end
  out.text = text_of(t, out)
  return out
end

define {
  name = "fabric.lab.pool",
  arguments = {
    { name = "parameters", kind = "table", sentence = "{ {name=, start=, low=, high=}, ... } as of fabric.lab.identify" },
    { name = "tests", kind = "table", sentence = "one for each specimen, as of fabric.lab.identify: { {name=, measured=, predict=, noise=, rate=, finer=, x=, scale=}, "
      .. "... }; rate: speed of the test; finer(p): predict on a mesh of half the size, when the simulation has one; x: abscissa of the numbers (strain, angle), "
      .. "of one meaning in all tests (default: the place in the list); scale: what the model's error is relative to, where it is not the predicted numbers: the fit then has no factor of specimens" },
    { name = "model", kind = "function", optional = true,
      sentence = "function(p, test) return numbers end, in place of `predict` of each test; it reads the test's further fields (width=, angle= ...), and takes what `predict` is asked for" },
    { name = "groups", kind = "table", optional = true, sentence = "names of fields of the tests by which they belong together: {'laboratory', 'size'}; "
      .. "each has a deviation of its own, and each label is predicted from the others" },
    { name = "leave", kind = "boolean", default = true, sentence = "predicts each label of each group by a fit to the others" },
    { name = "rate", kind = "fields", optional = true, sentence = "accounts for the speed: predictions times 1 + p.rate ln(rate / reference)", rows = {
      { name = "reference", kind = "number", above = 0, sentence = "speed at which the parameters hold, in the unit of the tests' rate" },
      { name = "most", kind = "number", above = 0, high = 1, optional = true, sentence = "largest part for a factor e in the speed, either way; default 0.2" },
    } },
    { name = "level", kind = "number", above = 0, high = 0.999, default = 0.95, sentence = "of confidence" },
    { name = "processes", kind = "integer", low = 1, default = 2, sentence = "side by side, for the differences" },
    { name = "iterations", kind = "integer", low = 1, default = 30, sentence = "at most, of each fit" },
    { name = "progress", kind = "boolean", default = false, sentence = "prints the progress on stderr" },
  },
  sentence = "Parameters from several specimens, sizes, laboratories and speeds at once, with the scatter between specimens and the mesh's error beside the "
    .. "noise: parameters, low, high (by name), deviation, covariance, between (relative deviation of specimens), mesh (relative), chi2 (of what is left, "
    .. "per degree of freedom), tests (by name: predicted, low, high: band of the mean, next_low, next_high: of the next specimen, rms, factor: of this "
    .. "specimen), left_out (by name: inside, rms, at_end, predicted, low, high, from the others), coverage, left_out_by (by group a list {label, inside, points, rms, tests}), effects "
    .. "(what the model misses: freedom, deviation, shares), predict(self, {x=, ...}) -> {predicted, low, high, band, reason}: a specimen that was not tested; band is nil "
    .. "and reason says why where the tests do not show how wrong the model is; card(self, function(p) return card end): the card with the parameters' bands propagated to its numbers; text.",
  example = "local tests = {}\nfor i, scale in ipairs{ 0.96, 1, 1.05, 0.99 } do\n"
    .. "  tests[i] = { name='pull '..i, measured={ 2*scale, 4*scale, 6*scale }, noise=0.02, predict=function(p) return { p.k, 2*p.k, 3*p.k } end }\nend\n"
    .. "local f = require 'fabric'.lab.pool{ parameters={ {name='k', start=1, low=0.1, high=10} }, tests=tests, processes=1 }\n"
    .. "assert(math.abs(f.parameters.k - 2) < 0.01 and math.abs(f.between - 0.037) < 0.005 and f.low.k < 1.95)",
  retired = { "order", "tolerance" },
  run = pool,
}
