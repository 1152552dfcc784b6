-- fabric.lab.loops: how far unloading and reloading are from the law's straight line, and the curved loop (loop of a yarn) that follows them.
--
-- Between the residual strain (x = 0) and the peak (x = 1) of the unloading, and over the peak's stress, the law is an elastic part and strands
-- that slip (share/doc/law.md, Loops). The peak's stress is the one that was measured there, so that only the shape of the way back counts.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local check = require "fabric.lab.common.check"
local curve = require "fabric.lab.common.curve"
local linear = require "fabric.lab.common.linear"
local origin = require "fabric.lab.card.origin"
local loading = require "fabric.lab.common.loading"
local lists = require "fabric.lists"
local fail = define.fail

local strands = 6
local most_rows, least_rows = 150, 8
local taut = 0.01 -- of the peak stress: rows below it are slack, or nearly
local near_peak = 0.85 -- of the largest strain: rows from there on determine the stress at it
local least_way = 0.05 -- of the peak stress by which an unloading must lower the stress to count

-- --- the law ---

-- Reach (of the way) and stiffness of each strand.
local function bundle(p)
  local reach, stiffness = {}, {}
  for j = 1, strands do
    reach[j], stiffness[j] = p.reach * j / strands, (j == strands and 1 or 2) * p.friction / (strands * p.reach)
  end
  return reach, stiffness
end

-- Calls visit(leg, row, stress) for the rows of all legs in their order.
local function along(legs, p, visit)
  local reach, stiffness = bundle(p)
  local slack, peak = {}, nil
  local unloading, elastic, curve = p.unloading, 1 - p.friction, p.curve
  for _, leg in ipairs(legs) do
    local m, P = leg.m, leg.P
    if m ~= peak then
      for j = 1, strands do slack[j] = 1 - reach[j] end
      peak = m
    end
    local function stress(E)
      local x = 1 - (m - E) * unloading / P
      if x < 0 then x = 0 elseif x > 1 then x = 1 end
      local share = elastic * x * (1 - curve + curve * x)
      for j = 1, strands do
        local u, most = x - slack[j], reach[j]
        if u < 0 then u = 0 elseif u > most then u = most end
        slack[j], share = x - u, share + stiffness[j] * u
      end
      return P * share
    end
    for k, E in ipairs(leg.E) do visit(leg, k, stress(E)) end
    stress(leg.turn)
  end
end

-- --- the record ---

-- The stress at the largest strain so far and its deviation: the fitted curve, times what the last rows of virgin loading are of it.
local function peak_of(E, S, card_curve)
  local n, first = #E, #E
  while first > 1 and (n - first < 4 or E[first - 1] > near_peak * E[n]) do first = first - 1 end
  local both, squares = 0, 0
  for k = first, n do
    local P = loading.stress(card_curve, E[k])
    both, squares = both + S[k] * P, squares + P * P
  end
  local ratio, rest = both / squares, 0
  for k = first, n do rest = rest + (S[k] - ratio * loading.stress(card_curve, E[k])) ^ 2 end
  local P = loading.stress(card_curve, E[n])
  return ratio * P, P * math.sqrt(rest / math.max(n - first, 1) / squares)
end

-- Rows that go one way (noise may turn a reading), without those where the cloth is slack; at most so many, as means.
local function rows_of(E, S, sign, P)
  local kept, extreme, way = { E = {}, S = {} }, nil, {}
  for k, e in ipairs(E) do
    extreme = extreme and (sign > 0 and math.max(extreme, e) or math.min(extreme, e)) or e
    way[k] = extreme
  end
  local first, last = 1, #E
  for k = 1, #E do
    if S[k] <= taut * P then
      if sign > 0 then first = k + 1 else last = math.min(last, k - 1) end
    end
  end
  for k = first, last do kept.E[#kept.E + 1], kept.S[#kept.S + 1] = way[k], S[k] end
  local block, out = math.max(1, math.ceil(#kept.E / most_rows)), { E = {}, S = {}, turn = extreme } -- none are kept of a way on which the cloth is slack
  for from = 1, #kept.E, block do
    local to, e, s = math.min(from + block - 1, #kept.E), 0, 0
    for k = from, to do e, s = e + kept.E[k], s + kept.S[k] end
    out.E[#out.E + 1], out.S[#out.S + 1] = e / (to - from + 1), s / (to - from + 1)
  end
  return out
end

-- The ways back and up again of a test, in their order; nil if there are none.
local function legs_of(test, slack, card_curve)
  local stretch, legs, virgin, m, P, deviation = 1 + slack, {}, { E = {}, S = {} }, nil, nil, nil
  local stop = test.failure or #test.E
  local rows, peak, unloads = 0, 0, false
  for _, branch in ipairs(test.branches) do
    if branch.first > stop then break end
    local E, S = {}, {}
    for k = branch.first, math.min(branch.last, stop) do E[#E + 1], S[#S + 1] = curve.from_contact(test.E[k], test.S[k], stretch) end
    if branch.kind == "loading" then
      for k, e in ipairs(E) do
        if e > (virgin.E[#virgin.E] or -math.huge) then virgin.E[#virgin.E + 1], virgin.S[#virgin.S + 1] = e, S[k] end
      end
      m, P = nil, nil
    elseif branch.kind ~= "hold" and #virgin.E >= 3 and #E > 0 then
      if not m then
        m = virgin.E[#virgin.E]
        P, deviation = peak_of(virgin.E, virgin.S, card_curve)
      end
      if m > 0 and P > 0 then
        local down = branch.kind == "unloading"
        local leg = rows_of(E, S, down and -1 or 1, P)
        leg.m, leg.P, leg.deviation, leg.down = m, P, deviation, down
        legs[#legs + 1] = leg
        rows, peak = rows + #leg.E, math.max(peak, P)
        if down and #leg.S > 0 and leg.S[#leg.S] < (1 - least_way) * P then unloads = true end
      end
    end
  end
  if unloads and rows >= least_rows then return { legs = legs, rows = rows, peak = peak } end
end

-- The secant from the peak towards zero stress, Pa: over the way back that goes deepest.
local function secant(specimen)
  local best, deepest = nil, 1
  for _, leg in ipairs(specimen.legs) do
    local last = #leg.S
    if leg.down and last > 1 and leg.S[last] / leg.P < deepest and leg.m > leg.E[last] then
      best, deepest = (leg.P - leg.S[last]) / (leg.m - leg.E[last]), leg.S[last] / leg.P
    end
  end
  return best
end

-- --- fits ---

local straight = { friction = 0, reach = 0.5, curve = 0 }

-- Measured less computed stress of every row, over the largest peak.
local function residuals(specimen, p)
  local out = {}
  along(specimen.legs, p, function(leg, k, S) out[#out + 1] = (leg.S[k] - S) / specimen.peak end)
  return out
end

local function squares(list) return lists.dot(list, list) end

-- Root mean squares {all, unloading}, of the largest peak.
local function rms_of(specimen, p)
  local sum, n, down, downs = 0, 0, 0, 0
  along(specimen.legs, p, function(leg, k, S)
    local r = ((leg.S[k] - S) / specimen.peak) ^ 2
    sum, n = sum + r, n + 1
    if leg.down then down, downs = down + r, downs + 1 end
  end)
  return { all = math.sqrt(sum / n), unloading = math.sqrt(down / math.max(downs, 1)) }
end

local function with_unloading(p, unloading)
  return { friction = p.friction, reach = p.reach, curve = p.curve, unloading = unloading }
end

-- The straight law that fits best: its unloading modulus alone is free.
local function best_line(specimen, start, least)
  local found = kernels.least_squares {
    start = { math.max(1, least / start) }, low = { math.max(0.2, least / start) }, high = { math.max(10, 2 * least / start) },
    evaluate = function(points)
      return lists.map(points, function(p) return residuals(specimen, with_unloading(straight, p[1] * start)) end)
    end,
  }
  return with_unloading(straight, found.x[1] * start)
end

-- Parameters of the law from the free ones. The last is the share of the largest curve at which the tail is not softer than slack cloth.
local function parameters(x, start, initial)
  local p = { unloading = x[1] * start, friction = x[2], reach = x[3] }
  p.curve = x[4] * math.max(0, 1 - initial / (p.unloading * (1 - p.friction)))
  return p
end

local function best_loop(specimen, start, least, initial)
  local best
  local low, high = { math.max(0.2, least / start), 0, 0.05, 0 }, { math.max(10, 2 * least / start), 0.9, 1, 1 }
  local function try(x)
    for i = 1, 4 do x[i] = math.min(math.max(x[i], low[i] + 1e-3 * (high[i] - low[i])), high[i] - 1e-3 * (high[i] - low[i])) end
    local found = kernels.least_squares {
      start = x, low = low, high = high,
      evaluate = function(points)
        return lists.map(points, function(y) return residuals(specimen, parameters(y, start, initial)) end)
      end,
    }
    local chi2 = squares(found.residuals)
    if not best or chi2 < best.chi2 then best = { chi2 = chi2, x = found.x } end
  end
  for _, reach in ipairs { 0.3, 0.8 } do
    for _, bend in ipairs { 0.2, 0.7 } do try { 1, 0.2, reach, bend } end
  end
  -- The sum of squares has a bend wherever the end of a strand passes a row: once more from both sides.
  for _, part in ipairs { 0.9, 1.1 } do try { best.x[1], part * best.x[2], part * best.x[3], best.x[4] } end
  local p = parameters(best.x, start, initial)
  p.chi2, p.at_reach = best.chi2, function(reach, x)
    local found = kernels.least_squares {
      start = { x[1], x[2], x[4] }, low = { low[1], low[2], low[4] }, high = { high[1], high[2], high[4] },
      evaluate = function(points)
        return lists.map(points, function(y) return residuals(specimen, parameters({ y[1], y[2], reach, y[3] }, start, initial)) end)
      end,
    }
    local y = found.x
    local all = { y[1], y[2], reach, y[3] }
    return squares(found.residuals), parameters(all, start, initial), all
  end
  p.x, p.low_reach, p.high_reach = best.x, low[3], high[3]
  p.bound = {}
  for i, name in ipairs { "unloading", "friction", "reach", "curve" } do
    local width = high[i] - low[i]
    p.bound[name] = best.x[i] < low[i] + 1e-3 * width or best.x[i] > high[i] - 1e-3 * width
  end
  return p
end

local names = { "unloading", "friction", "reach", "curve" }

-- Of neighbouring residuals, from 0 (noise) to nearly 1.
local function likeness(rest)
  local together = 0
  for k = 2, #rest do together = together + rest[k] * rest[k - 1] end
  return math.min(math.max(together / squares(rest), 0), 0.98)
end

-- How the residuals change with the stress at each peak, per its deviation: one list for every peak.
local function by_peak(specimen, p)
  local out, legs = {}, specimen.legs
  for i, leg in ipairs(legs) do
    if (i == 1 or legs[i - 1].m ~= leg.m) and leg.deviation > 0 then
      local function with(part)
        local changed = { legs = {}, peak = specimen.peak }
        for k, l in ipairs(legs) do
          changed.legs[k] = l.m == leg.m and setmetatable({ P = l.P + part * leg.deviation }, { __index = l }) or l
        end
        return residuals(changed, p)
      end
      local up, down, column = with(0.1), with(-0.1), {}
      for k = 1, #up do column[k] = (up[k] - down[k]) / 0.2 end
      out[#out + 1] = column
    end
  end
  return out
end

-- Covariance of one specimen's parameters by linearisation, with the noise of the rows (those whose neighbours deviate alike count as fewer) and
-- of the peaks that they are scaled to; and the part of the peaks. A parameter on a bound is taken as known.
local function covariance(specimen, p)
  local rest, free, columns = residuals(specimen, p), {}, {}
  for _, name in ipairs(names) do
    if not p.bound[name] then
      local h = 1e-4 * (name == "unloading" and p.unloading or 1)
      local above, below = with_unloading(p, p.unloading), with_unloading(p, p.unloading)
      above[name], below[name] = p[name] + h, p[name] - h
      local up, down, column = residuals(specimen, above), residuals(specimen, below), {}
      for k = 1, #rest do column[k] = (up[k] - down[k]) / (2 * h) end
      free[#free + 1], columns[#columns + 1] = name, column
    end
  end
  local out, of_peaks = {}, {}
  for _, a in ipairs(names) do
    out[a], of_peaks[a] = {}, {}
    for _, b in ipairs(names) do out[a][b], of_peaks[a][b] = 0.0, 0.0 end
  end
  if #free == 0 then return out, of_peaks end
  local normal = linear.zeros(#free)
  for i = 1, #free do
    for j = 1, #free do
      normal[i][j] = lists.dot(columns[i], columns[j])
    end
  end
  local alike = likeness(rest)
  local variance = squares(rest) / math.max(#rest - #free, 1) * (1 + alike) / (1 - alike)
  local inverse = linear.inverse(normal)
  for i, a in ipairs(free) do
    for j, b in ipairs(free) do out[a][b] = variance * inverse[i][j] end
  end
  for _, peak in ipairs(by_peak(specimen, p)) do
    local shift = linear.solve(normal, lists.map(columns, function(column) return lists.dot(column, peak) end))
    for i, a in ipairs(free) do
      for j, b in ipairs(free) do
        out[a][b], of_peaks[a][b] = out[a][b] + shift[i] * shift[j], of_peaks[a][b] + shift[i] * shift[j]
      end
    end
  end
  return out, of_peaks
end

-- Friction and reach are correlated along a curved valley: their bands, and with them the others', hold every reach whose best fit is
-- not worse than noise explains. Visits the parameters along it, up to its ends.
local function along_valley(specimen, p, deviation, quantile, visit)
  if p.bound.reach or not (deviation > 0) then return end
  local alike = likeness(residuals(specimen, p))
  local allowed = p.chi2 + quantile ^ 2 * p.chi2 / math.max(specimen.rows - 4, 1) * (1 + alike) / (1 - alike)
  for _, way in ipairs { -1, 1 } do
    local x, reach, step, ended = p.x, p.reach, deviation / 2, false
    for _ = 1, 20 do
      local next_reach = math.min(math.max(reach + way * step, p.low_reach), p.high_reach)
      if next_reach == reach then break end
      local chi2, at, next_x = p.at_reach(next_reach, x)
      ended = ended or chi2 > allowed
      if chi2 <= allowed then
        visit(at)
        x, reach = next_x, next_reach
      end
      if ended then step = step / 2 end
      if step < deviation / 50 then break end
    end
  end
end

-- Whether three more numbers are worth it, by Schwarz's criterion with the rows counted as in covariance().
local function pays(specimen, line, loop)
  local rest, plain = residuals(specimen, loop), residuals(specimen, line)
  local alike = likeness(rest)
  local n = math.max(#rest * (1 - alike) / (1 + alike), 5)
  return n * math.log(squares(plain) / squares(rest)) > 3 * math.log(n)
end

-- Steepest tangent of the loading curve up to the tested strain, and the one at zero, Pa.
local function tangents(card_curve, tested)
  local steepest, _, initial = loading.tangents(card_curve, tested, 100)
  return (type(card_curve[1]) == "table" and 1.05 or 1) * steepest, initial -- between points the curve is a little steeper than their secant
end

-- --- the answer ---

-- Values and bands of all four numbers: over specimens, or of a single one by its noise.
local function banded(out, found, t)
  local numbers = lists.map(found, function(f) return { f.loop.unloading, f.loop.friction, f.loop.reach, f.loop.curve } end)
  out.low, out.high = {}, {}
  if #found > 1 then
    local band = fabric.lab.band { specimens = numbers, level = t.level, seed = t.seed }
    for i, name in ipairs(names) do
      out.values[name], out.low[name], out.high[name] = band.value[i], band.low[i], band.high[i]
    end
    out.variance = band.covariance[1]
  else
    local cov, of_peaks = covariance(found[1].specimen, found[1].loop)
    local quantile = fabric.lab.student(0.5 + t.level / 2, math.max(found[1].specimen.rows - 4, 1))
    for i, name in ipairs(names) do
      local half = quantile * math.sqrt(cov[name][name])
      out.values[name], out.low[name], out.high[name] = numbers[1][i], numbers[1][i] - half, numbers[1][i] + half
    end
    along_valley(found[1].specimen, found[1].loop, math.sqrt(cov.reach.reach), quantile, function(at)
      for i, name in ipairs(names) do
        local way = at[name] - numbers[1][i]
        local far = numbers[1][i] + (way < 0 and -1 or 1) * math.sqrt(way ^ 2 + quantile ^ 2 * of_peaks[name][name])
        out.low[name], out.high[name] = math.min(out.low[name], far), math.max(out.high[name], far)
      end
    end)
    out.variance = cov.unloading.unloading
  end
  for _, name in ipairs { "friction", "reach", "curve" } do
    out.low[name], out.high[name] = math.max(out.low[name], 0), math.min(out.high[name], 1)
  end
end

local function percent(x) return ("%.2g %%"):format(100 * x) end

local function words_of(out, t, found, bound)
  local n = #found == 1 and "1 specimen" or #found .. " specimens"
  local lines = {}
  local rms = out.rms
  lines[1] = ("unloading of %s: the straight law misses it by rms %s of the peak at best (modulus %.4g MPa), by %s with the modulus of its first rows (%.4g MPa); a curved loop by %s"):format(
    n, percent(rms.straight.unloading), out.line / 1e6, percent(rms.rule.unloading), out.rule / 1e6, percent(rms.curved.unloading))
  lines[2] = ("unloading and reloading together: straight %s, curved %s"):format(percent(rms.straight.all), percent(rms.curved.all))
  if not out.loop then
    lines[3] = rms.straight.all <= t.enough and ("The straight law is good enough: it misses by no more than %s of the peak"):format(percent(t.enough))
      or "The straight law is good enough: three more numbers do not make the misfit smaller by more than noise does"
    return table.concat(lines, "\n")
  end
  lines[3] = ("The records show loops that are not straight. unloading %.4g MPa (%.4g to %.4g), the secant from the peak to zero stress"):format(
    out.unloading / 1e6, out.low.unloading / 1e6, out.high.unloading / 1e6)
  for _, name in ipairs { "friction", "reach", "curve" } do
    lines[#lines + 1] = ("  %-9s %.3g (%.3g to %.3g)%s"):format(name, out.loop[name], out.low[name], out.high[name], bound[name] and ", on its bound: no band" or "")
  end
  return table.concat(lines, "\n")
end

-- Measured and computed stress along the ways back and up, for figures.
local function curves_of(found)
  local out = {}
  for i, f in ipairs(found) do
    local c = { E = {}, S = {}, straight = {}, curved = {} }
    along(f.specimen.legs, f.loop, function(leg, k, S)
      c.E[#c.E + 1], c.S[#c.S + 1], c.curved[#c.curved + 1] = leg.E[k], leg.S[k], S
    end)
    along(f.specimen.legs, f.line, function(_, _, S) c.straight[#c.straight + 1] = S end)
    out[i] = c
  end
  return out
end

-- The fit's band with another unloading modulus.
local function band_with(fit, out)
  local band = fit.band
  if not band or not band.low then return end
  local wide = #band.value
  local n = fit.degree or #fit.loading - (fit.loading[1][1] == 0 and 1 or 0)
  local made = { value = {}, low = {}, high = {}, covariance = {} }
  for i = 1, n + 1 do
    local own = i > n
    made.value[i] = own and out.unloading or band.value[i]
    made.low[i], made.high[i] = own and out.low.unloading or band.low[i], own and out.high.unloading or band.high[i]
    for j = 1, n + 1 do
      made.covariance[(i - 1) * (n + 1) + j] = i <= n and j <= n and band.covariance[(i - 1) * wide + j] or i == j and out.variance or 0.0
    end
  end
  return made
end

local function nothing_let_go(n)
  fail(("loops: field 'tests': expected a test that lets go of at least %g %% of its peak stress, got %d of loading alone"):format(100 * least_way, n))
end

local function lets_go(tests)
  for _, test in ipairs(tests) do
    for _, branch in ipairs(test.branches) do
      if branch.kind == "unloading" and branch.last > branch.first then return true end
    end
  end
end

local function check_stress(i, test)
  local low, high = math.huge, -math.huge
  for _, S in ipairs(test.S) do low, high = math.min(low, S), math.max(high, S) end
  if high <= 0 or -low > 2 * high then
    fail(("loops: field 'tests[%d].S': stress runs from %.4g to %.4g Pa: expected a pull, which counts positive; change the sign of the record"):format(i, low, high + 0.0))
  end
end

local function check_fit(fit)
  if type(fit.loading) ~= "table" or type(fit.tested) ~= "number" then
    fail "loops: field 'fit': expected a result of fabric.lab.fit of the same tests, got a table without loading or tested"
  end
  if #fit.loading == 0 or type(fit.loading[1]) == "table" and #fit.loading < 2 then
    fail(("loops: field 'fit.loading': expected moduli, or two points {strain, stress} and more, got %d"):format(#fit.loading))
  end
end

-- The evidence of a test, and the secant of its unloading; nil if it unloads too little.
local function specimen_of(test, i, fit)
  local specimen = legs_of(test, (fit.specimens or {})[i] and fit.specimens[i].slack or 0, fit.loading)
  local start = specimen and secant(specimen)
  if start then return specimen, start end
end

-- Whether any of the tests shows loops.
local function ready(tests, fit)
  for i, test in ipairs(tests) do
    if specimen_of(test, i, fit) then return true end
  end
  return false
end

local function loops(t)
  local tests = t.tests
  check.tests("loops", tests)
  for i = 1, #tests do
    check.test("loops", i, tests[i])
    check_stress(i, tests[i])
  end
  if not lets_go(tests) then nothing_let_go(#tests) end
  local fit = t.fit or fabric.lab.fit { tests = tests, find_slack = "either", rule = "robust", level = t.level, seed = t.seed }
  check_fit(fit)
  local least, initial = tangents(fit.loading, fit.tested)
  local found, bound, rms = {}, {}, { straight = {}, rule = {}, curved = {} }
  local worth = 0
  for i, test in ipairs(tests) do
    local specimen, start = specimen_of(test, i, fit)
    if specimen then
      local f = { specimen = specimen, line = best_line(specimen, start, least), loop = best_loop(specimen, start, least, initial) }
      f.rms = { straight = rms_of(specimen, f.line), curved = rms_of(specimen, f.loop), rule = rms_of(specimen, with_unloading(straight, fit.unloading or f.line.unloading)) }
      for _, name in ipairs(names) do bound[name] = bound[name] or f.loop.bound[name] end
      if pays(specimen, f.line, f.loop) then worth = worth + 1 end
      found[#found + 1] = f
    end
  end
  if #found == 0 then nothing_let_go(#tests) end
  for kind in pairs(rms) do
    for _, part in ipairs { "all", "unloading" } do
      local sum = lists.sum(found, function(f) return f.rms[kind][part] ^ 2 / #found end)
      rms[kind][part] = math.sqrt(sum)
    end
  end
  local out = { values = {}, rms = rms, tests = #tests, specimens = fit.specimens, loading = fit.loading, degree = fit.degree, tested = fit.tested,
    level = t.level, rule = fit.unloading, curves = curves_of(found) }
  local lines = lists.map(found, function(f) return f.line.unloading end)
  out.line = lists.mean(lines)
  out.rule = out.rule or out.line
  banded(out, found, t)
  out.curved = worth > #found / 2 and rms.straight.all > t.enough
  local values = out.values
  if out.curved then
    out.unloading, out.loop = values.unloading, { friction = values.friction, reach = values.reach, curve = values.curve }
    out.band = band_with(fit, out)
  else
    out.unloading, out.band, out.unloading_of = fit.unloading or out.line, fit.band, fit.unloading_of
  end
  out.text = words_of(out, t, found, bound)
  local counted = #found == 1 and "1 specimen" or #found .. " specimens"
  local words = { loading = origin.fitted(fit, "loading"), unloading = origin.fitted(fit, "unloading") }
  if out.curved then
    words.unloading = ("fitted to %s, secant of curved loops"):format(counted)
    words.loop = ("fitted to %s: friction %.3g (%.3g to %.3g), reach %.3g (%.3g to %.3g), curve %.3g (%.3g to %.3g)"):format(counted, values.friction, out.low.friction,
      out.high.friction, values.reach, out.low.reach, out.high.reach, values.curve, out.low.curve, out.high.curve)
    if #found == 1 then words.loop = words.loop .. "; that is the noise of its record, and the card has no band of it: one specimen does not show how others differ" end
  end
  origin.remember(out, words)
  return out
end

define {
  name = "fabric.lab.loops",
  arguments = {
    { name = "tests", kind = "table", sentence = "results of fabric.lab.tensile along one yarn with unloading and, better, reloading" },
    { name = "fit", kind = "table", optional = true, sentence = "result of fabric.lab.fit of the same tests; default: made here, with find_slack='either', rule='robust'" },
    { name = "enough", kind = "number", low = 0, high = 1, default = 0.01,
      sentence = "a straight law that misses by no more than this share of the peak stress (rms) is good enough" },
    { name = "level", kind = "number", above = 0, high = 0.999, default = 0.95, sentence = "of confidence" },
    { name = "seed", kind = "integer", low = 0, default = 1, sentence = "of the bootstrap" },
  },
  sentence = "How far unloading and reloading are from the law's straight line, and the curved loop that follows them: a part for fabric.lab.card (loading, "
    .. "unloading, tested, band and, where the records ask for it, loop {friction, reach, curve}); rms {straight, rule, curved} {all, unloading} as shares of "
    .. "the peak stress (rule: with the modulus of the first rows), low and high of each number, curved, curves {E, S, straight, curved} per test, text.",
  example = "local E, S = {}, {}\nfor i = 0, 60 do E[i+1] = i/600; S[i+1] = 8e6*E[i+1] + 4e8*E[i+1]^2 end\n"
    .. "local P, Du = S[61], 9e8\nfor i = 1, 40 do E[61+i] = 0.1 - i/40*P/Du; S[61+i] = P*(1 - i/40)^2 end\n"
    .. "local test = { E=E, S=S, branches={ {kind='loading', first=1, last=61}, {kind='unloading', first=62, last=101} } }\n"
    .. "local l = require 'fabric'.lab.loops{ tests={test} }\nassert(l.curved and l.rms.straight.unloading > 5 * l.rms.curved.unloading)",
  run = loops,
}

return { ready = ready }
