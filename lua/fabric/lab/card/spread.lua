-- fabric.lab.spread: the differences between specimens, and the range of the next one.
local fabric = require "fabric"
local define = require "fabric.define"
local curve = require "fabric.lab.common.curve"
local check = require "fabric.lab.common.check"
local lists = require "fabric.lists"
local fail = define.fail

-- Mean stress of a specimen in each of n equal bins of strain up to `reach`; interpolated where a bin has no row.
local function binned(points, rising, reach, n)
  local sum, count, out = {}, {}, {}
  for i, E in ipairs(points.E) do
    local k = math.ceil(E / reach * n)
    if k >= 1 and k <= n then sum[k], count[k] = (sum[k] or 0) + points.S[i], (count[k] or 0) + 1 end
  end
  for k = 1, n do out[k] = count[k] and sum[k] / count[k] or curve.interpolate(rising.E, rising.S, (k - 0.5) * reach / n) end
  return out
end

-- Mean and standard deviation of the values at index k over the specimens (except `without`), and their number.
local function moments(values, k, without)
  local sum, n, squares = 0, 0, 0
  for i, list in ipairs(values) do
    if i ~= without and list[k] then sum, n = sum + list[k], n + 1 end
  end
  if n < 2 then return sum / n, 0, n end
  for i, list in ipairs(values) do
    if i ~= without and list[k] then squares = squares + (list[k] - sum / n) ^ 2 end
  end
  return sum / n, math.sqrt(squares / (n - 1)), n
end

-- Leaves out each specimen in turn: the share of its points within the prediction band of the others; and the specimen with the smallest share, with its points and that band.
local function left_out(values, n, level, reach)
  local out, worst = {}, nil
  for held = 1, #values do
    local inside, total, seen = 0, 0, { specimen = held, E = {}, S = {}, low = {}, high = {} }
    for k = 1, n do
      local mean, s, count = moments(values, k, held)
      local y = values[held][k]
      if y and count >= 2 then
        local half = fabric.lab.student(0.5 + level / 2, count - 1) * s * math.sqrt(1 + 1 / count)
        total = total + 1
        seen.E[total], seen.S[total], seen.low[total], seen.high[total] = (k - 0.5) * reach / n, y, mean - half, mean + half
        if math.abs(y - mean) <= half then inside = inside + 1 end
      end
    end
    out[held] = total > 0 and inside / total or 0 / 0
    if total > 0 and not (worst and out[held] >= out[worst.specimen]) then worst = seen end
  end
  return out, worst
end

-- The stress of each specimen over the mean, averaged over the bins in which the mean is a tenth of its largest at least.
local function levels(values, n)
  local out, means, most = {}, {}, 0
  for k = 1, n do
    means[k] = moments(values, k)
    most = math.max(most, means[k] == means[k] and means[k] or 0)
  end
  for i, list in ipairs(values) do
    local sum, count = 0, 0
    for k = 1, n do
      if list[k] and means[k] > 0.1 * most then sum, count = sum + list[k] / means[k], count + 1 end
    end
    out[i] = { sum / count }
  end
  return out
end

-- Specimens unlike the others: the level of each against those of the others by the studentised deviation, with the level of confidence for all
-- specimens together (Bonferroni) [cook1982]; less than a twentieth of the others' mean is not reported.
local function unlike(values, n, level)
  local out, level_of = {}, levels(values, n)
  for held = 1, #values do
    local mean, s, count = moments(level_of, 1, held)
    local t = (level_of[held][1] - mean) / (s * math.sqrt(1 + 1 / count))
    local limit = fabric.lab.student(1 - (1 - level) / (2 * #values), count - 1)
    if math.abs(t) > limit and math.abs(level_of[held][1] / mean - 1) > 0.05 then
      out[#out + 1] = { specimen = held, ratio = level_of[held][1] / mean, deviation = s / mean }
    end
  end
  return out
end

-- The virgin loading of a test relative to the first contact found by its fit.
local function taut_loading(t, i)
  local points = curve.loading(t.tests[i])
  local slack = t.fit and t.fit.specimens and t.fit.specimens[i].slack or 0
  if slack == 0 then return points end
  local out = { E = {}, S = {} }
  for k, E in ipairs(points.E) do
    local e, s = curve.from_contact(E, points.S[k], 1 + slack)
    if e >= 0 then out.E[#out.E + 1], out.S[#out.S + 1] = e, s end
  end
  return out
end

local function check_fit(t)
  local specimens = t.fit and t.fit.specimens
  if not specimens then return end
  if type(specimens) ~= "table" or #specimens ~= #t.tests then
    fail(("spread: field 'fit': expected the fit of these %d tests, got one of %s"):format(#t.tests, type(specimens) == "table" and #specimens or "none"))
  end
  for i, specimen in ipairs(specimens) do
    local slack = type(specimen) == "table" and specimen.slack
    if type(slack) ~= "number" or not (slack > -1 and slack < math.huge) then
      fail(("spread: field 'fit.specimens[%d].slack': expected a stretch, got %s"):format(i, tostring(slack)))
    end
  end
end

local function spread(t)
  if #t.tests < 3 then fail(("spread: field 'tests': expected at least 3 specimens, got %d"):format(#t.tests)) end
  local points, loadings, reach = {}, {}, math.huge
  check_fit(t)
  for i = 1, #t.tests do
    local test = t.tests[i]
    check.test("spread", i, test)
    loadings[i], points[i] = taut_loading(t, i), {}
    points[i].E, points[i].S = curve.envelope(loadings[i].E, loadings[i].S)
    reach = math.min(reach, points[i].E[#points[i].E] or 0)
  end
  if not (reach > 0) then fail "spread: field 'tests': expected specimens that were all stretched" end
  local values = lists.map(loadings, function(loading, i) return binned(loading, points[i], reach, t.points) end)
  local out = { E = {}, S = {}, deviation = {}, low = {}, high = {}, next_low = {}, next_high = {}, level = t.level, reach = reach, specimens = #t.tests }
  for k = 1, t.points do
    local mean, s, n = moments(values, k)
    if n >= 3 then
      local q, place = fabric.lab.student(0.5 + t.level / 2, n - 1), #out.E + 1
      out.E[place], out.S[place], out.deviation[place] = (k - 0.5) * reach / t.points, mean, s
      out.low[place], out.high[place] = mean - q * s / math.sqrt(n), mean + q * s / math.sqrt(n)
      out.next_low[place], out.next_high[place] = mean - q * s * math.sqrt(1 + 1 / n), mean + q * s * math.sqrt(1 + 1 / n)
    end
  end
  out.left_out, out.least_like = left_out(values, t.points, t.level, reach)
  local sum = lists.sum(out.left_out)
  out.coverage = sum / #out.left_out
  out.unlike = unlike(values, t.points, t.level)
  local last = #out.E
  out.text = ("%d specimens to E = %.3g: at the end %.4g MPa, one specimen differs by %.1f %% (deviation); %g %% of the next specimens lie within %.4g to %.4g "
    .. "MPa, the mean within %.4g to %.4g; a specimen left out lies in the band of the others with %.0f %% of its points"):format(#t.tests, reach,
    out.S[last] / 1e6, 100 * out.deviation[last] / out.S[last], 100 * t.level, out.next_low[last] / 1e6, out.next_high[last] / 1e6, out.low[last] / 1e6,
    out.high[last] / 1e6, 100 * out.coverage)
  for _, odd in ipairs(out.unlike) do
    out.text = out.text .. ("; specimen %d is unlike the others: %.0f %% of their stress, where they differ by %.1f %%"):format(odd.specimen, 100 * odd.ratio,
      100 * odd.deviation)
  end
  return out
end

define {
  name = "fabric.lab.spread",
  arguments = {
    { name = "tests", kind = "table", sentence = "three specimens and more: results of fabric.lab.tensile or shear_from_bias" },
    { name = "fit", kind = "table", optional = true, sentence = "result of fabric.lab.fit of these tests: strains count from the first contact that it found" },
    { name = "level", kind = "number", above = 0, high = 0.999, default = 0.95, sentence = "of confidence" },
    { name = "points", kind = "integer", low = 5, high = 1000, default = 50, sentence = "bins of strain, equally wide" },
  },
  sentence = "How specimens differ in virgin loading: E, S (mean), deviation (of one specimen), low and high (band of the mean), next_low and "
    .. "next_high (band in which the next specimen lies), left_out (of each specimen the part of its points in the band of the others), least_like (that with the smallest part: specimen, E, S, low and high of the others' band), coverage "
    .. "(their mean), unlike (specimens that the others do not explain: specimen, ratio to them, their deviation), reach, text.",
  example = "local tests = {}\nfor i, scale in ipairs{ 1, 1.1, 0.95, 1.02 } do\n  local E, S = {}, {}\n"
    .. "  for k = 1, 100 do E[k] = k/1000; S[k] = scale*1e7*E[k] end\n"
    .. "  tests[i] = { E=E, S=S, branches={ {kind='loading', first=1, last=100} } }\nend\n"
    .. "local s = require 'fabric'.lab.spread{ tests=tests }\n"
    .. "assert(s.next_low[20] < s.low[20] and s.low[20] < s.S[20] and s.coverage > 0.7)",
  run = spread,
}
