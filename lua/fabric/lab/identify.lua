-- fabric.lab.identify: card parameters from measured curves by running the tests in simulation: for what no formula gives.
local fabric = require "fabric"
local define = require "fabric.define"
local fail = define.fail

local function key_of(point)
  local words = {}
  for i, x in ipairs(point) do words[i] = ("%.17g"):format(x) end
  return table.concat(words, " ")
end

-- What was evaluated so far, by point. Kept in a file so that a run that was interrupted goes on where it stopped: the search
-- takes the same way again, and every step that is known costs nothing.
local function open_cache(path, signature)
  local cache = { values = {}, order = {} }
  local f = path and io.open(path)
  if f then
    if f:read "l" ~= signature then
      f:close()
      fail(("identify: field 'checkpoint': '%s' is of another problem (other parameters, tests or data)"):format(path))
    end
    for line in f:lines() do
      local point, values = line:match "^(.-) : (.*)$"
      local list = {}
      for word in (values or ""):gmatch "%S+" do list[#list + 1] = tonumber(word) end
      if point then cache.values[point], cache.order[#cache.order + 1] = list, point end
    end
    f:close()
  end
  function cache.save()
    if not path then return end
    local lines = { signature }
    for _, point in ipairs(cache.order) do lines[#lines + 1] = point .. " : " .. key_of(cache.values[point]) end
    fabric.write(path, table.concat(lines, "\n") .. "\n")
  end
  return cache
end

local function named(t, point)
  local p = {}
  for i, parameter in ipairs(t.parameters) do p[parameter.name] = point[i] end
  return p
end

local function deviation_of(test, i)
  if type(test.noise) == "table" then return test.noise[i] end
  if test.noise then return test.noise end
  local largest = 0
  for _, y in ipairs(test.measured) do largest = math.max(largest, math.abs(y)) end
  return 0.01 * largest
end

-- Residuals of all tests at a point, over their deviations.
local function residuals(t, point)
  local p, out = named(t, point), {}
  for _, test in ipairs(t.tests) do
    local predicted = test.predict(p)
    if #predicted ~= #test.measured then
      error(("test '%s': expected %d predicted numbers, got %d"):format(test.name, #test.measured, #predicted), 0)
    end
    for i, y in ipairs(test.measured) do out[#out + 1] = (predicted[i] - y) / deviation_of(test, i) end
  end
  return out
end

-- Evaluates a list of points side by side, those that are known from memory. Where a simulation fails the residuals are large,
-- so that the search turns away; at the very first point it is an error.
local function evaluator(t, cache)
  local count = 0
  for _, test in ipairs(t.tests) do count = count + #test.measured end
  local function say(text)
    if t.progress then io.stderr:write("identify: ", text, "\n") end
  end
  local function unknown(points)
    local missing, seen = {}, {}
    for _, point in ipairs(points) do
      local key = key_of(point)
      if not cache.values[key] and not seen[key] then
        missing[#missing + 1], seen[key] = point, true
      end
    end
    return missing
  end
  local function keep(point, answer)
    if answer.trouble then
      if #cache.order == 0 then fail("identify: the start cannot be simulated: " .. answer.trouble) end
      say("a simulation failed: " .. answer.trouble)
      for i = 1, count do answer[i] = 1e3 end
    end
    local key = key_of(point)
    cache.values[key], cache.order[#cache.order + 1] = table.move(answer, 1, #answer, 1, {}), key
  end
  return function(points)
    local missing = unknown(points)
    if #missing > 0 then
      local answers = fabric.lab.parallel { count = #missing, processes = t.processes, work = function(i) return residuals(t, missing[i]) end }
      for i, answer in ipairs(answers) do keep(missing[i], answer) end
      cache.save()
      local sum = 0
      for _, r in ipairs(cache.values[key_of(points[1])]) do sum = sum + r * r end
      say(("%d simulations, chi^2 per point %.4g at %s"):format(#cache.order, sum / count, key_of(points[1])))
    end
    local out = {}
    for i, point in ipairs(points) do out[i] = cache.values[key_of(point)] end
    return out
  end
end

local function column(t, name)
  local out = {}
  for i, parameter in ipairs(t.parameters) do
    if type(parameter[name]) ~= "number" then
      fail(("identify: field 'parameters[%d].%s': expected a number, got %s"):format(i, name, tostring(parameter[name])))
    end
    out[i] = parameter[name]
  end
  return out
end

local function widths(t)
  local out = {}
  for i, parameter in ipairs(t.parameters) do out[i] = parameter.high - parameter.low end
  return out
end

-- Jacobian of a further test at the solution, by differences, in units of its deviation.
local function further_rows(t, test, x, scale)
  local base = test.predict(named(t, x))
  local rows = {}
  for k = 1, #base do rows[k] = {} end
  for i = 1, #x do
    local there = table.move(x, 1, #x, 1, {})
    local step = 1e-3 * scale[i] * (x[i] - t.parameters[i].low > scale[i] / 2 and -1 or 1)
    there[i] = x[i] + step
    local moved = test.predict(named(t, there))
    for k = 1, #base do rows[k][i] = (moved[k] - base[k]) / step / deviation_of({ noise = test.noise, measured = base }, k) end
  end
  local flat = {}
  for _, row in ipairs(rows) do table.move(row, 1, #row, #flat + 1, flat) end
  return flat
end

-- Further tests by what they would leave of the weakest combination's deviation.
local function rank_further(t, found, scale)
  local ranked = {}
  for i, test in ipairs(t.further or {}) do
    local jacobian = table.move(found.jacobian, 1, #found.jacobian, 1, {})
    local rows = further_rows(t, test, found.x, scale)
    table.move(rows, 1, #rows, #jacobian + 1, jacobian)
    local known = fabric.lab.identifiability { jacobian = jacobian, scale = scale }
    ranked[i] = { name = test.name, weakest_deviation = known.weakest_deviation, deviation = known.deviation }
  end
  table.sort(ranked, function(a, b) return a.weakest_deviation < b.weakest_deviation end)
  return ranked
end

local function text_of(t, out)
  local lines, n = {}, #t.parameters
  for i, parameter in ipairs(t.parameters) do
    local known = out.deviation[i] < 0.25 * (parameter.high - parameter.low)
    lines[i] = ("%-16s %12.6g %s"):format(parameter.name, out.x[i],
      known and ("+- %.3g"):format(out.deviation[i]) or "   not known: the data leave it within its bounds")
  end
  for i = 1, n do
    for j = i + 1, n do
      local c = out.correlation[(i - 1) * n + j]
      if math.abs(c) > 0.95 then
        lines[#lines + 1] = ("%s and %s cannot be told apart (correlation %.3f)"):format(t.parameters[i].name, t.parameters[j].name, c)
      end
    end
  end
  for _, test in ipairs(out.further) do
    lines[#lines + 1] = ("with %s the weakest combination would be known to %.3g instead of %.3g"):format(test.name, test.weakest_deviation,
      out.weakest_deviation)
  end
  lines[#lines + 1] = ("%s after %d iterations and %d simulations"):format(out.reason, out.iterations, out.simulations)
  return table.concat(lines, "\n")
end

-- Per test: root of the mean squared residual and the largest, over the largest measured value.
local function misses(t, residual)
  local out, at = {}, 0
  for _, test in ipairs(t.tests) do
    local sum, worst, largest = 0, 0, 0
    for i, y in ipairs(test.measured) do
      local miss = residual[at + i] * deviation_of(test, i)
      sum, worst, largest = sum + miss * miss, math.max(worst, math.abs(miss)), math.max(largest, math.abs(y))
    end
    out[test.name] = { rms = math.sqrt(sum / #test.measured) / largest, worst = worst / largest }
    at = at + #test.measured
  end
  return out
end

local function signature(t)
  local words = {}
  for _, p in ipairs(t.parameters) do words[#words + 1] = ("%s %.17g %.17g"):format(p.name, p.low, p.high) end
  for _, test in ipairs(t.tests) do words[#words + 1] = test.name .. " " .. key_of(test.measured) end
  return "identify: " .. table.concat(words, "; ")
end

local function identify(t)
  local start, low, high = column(t, "start"), column(t, "low"), column(t, "high")
  local cache = open_cache(t.checkpoint, signature(t))
  local evaluate, scale = evaluator(t, cache), widths(t)
  local found = fabric.lab.least_squares { start = start, low = low, high = high, evaluate = evaluate, iterations = t.iterations, tolerance = t.tolerance,
    difference = t.difference, settle = t.settle }
  local out = fabric.lab.identifiability { jacobian = found.jacobian, scale = scale }
  local squares = 0
  for _, r in ipairs(found.residuals) do squares = squares + r * r end
  out.chi2 = squares / math.max(1, #found.residuals - #t.parameters)
  -- Scatter beyond the stated noise widens what is claimed.
  for i, d in ipairs(out.deviation) do out.deviation[i] = d * math.sqrt(math.max(1, out.chi2)) end
  out.x, out.iterations, out.reason, out.converged, out.simulations = found.x, found.iterations, found.reason, found.converged, #cache.order
  out.parameters, out.misses = named(t, found.x), misses(t, found.residuals)
  out.further = rank_further(t, found, scale)
  out.text = text_of(t, out)
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
    { name = "checkpoint", kind = "text", optional = true, sentence = "file of what was simulated so far; taken up when it is there" },
    { name = "iterations", kind = "integer", low = 1, default = 30, sentence = "at most" },
    { name = "tolerance", kind = "number", above = 0, default = 1e-6, sentence = "relative, of the sum of squares and of the parameters" },
    { name = "difference", kind = "number", above = 0, default = 1e-3, sentence = "step of the differences over high - low" },
    { name = "settle", kind = "integer", low = 0, default = 8,
      sentence = "rounds at the end, with differences over a standard deviation to both sides along combinations of parameters" },
    { name = "progress", kind = "boolean", default = false, sentence = "says on stderr how far it is" },
  },
  sentence = "Card parameters by bounded least squares through simulation. Returns parameters (by name), deviation, correlation, weakest, misses (per "
    .. "test: rms and worst over the largest measured value), chi2, further (ranked), simulations, text.",
  example = "local fabric = require 'fabric'\n"
    .. "local function S(p) return { fabric.point(fabric.card 'blend':with{ shear={ unloading=p.Gu } }):path{ {0, 0, 0.2}, {0, 0, 0.19} }[2].S12 } end\n"
    .. "local f = fabric.lab.identify{ parameters={ {name='Gu', start=5e6, low=3e6, high=3e7} }, processes=1,\n"
    .. "  tests={ {name='shear', measured=S{Gu=12e6}, predict=S} } }\nassert(math.abs(f.parameters.Gu / 12e6 - 1) < 1e-4)",
  run = identify,
}
