-- fabric.lab.fit: loading curve and unloading modulus of replicate specimens, with confidence bands.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local check = require "fabric.lab.common.check"
local curve = require "fabric.lab.common.curve"
local loading = require "fabric.lab.common.loading"
local origin = require "fabric.lab.card.origin"
local averaged = require "fabric.lab.card.averaged_fit"
local fail = define.fail

-- The first unloading from a load. An unloading before the pull (the grip lowered on slack cloth) is ignored.
local loaded = 0.1 -- of the largest stress
local function first_unloading(test)
  local peak = 0
  for _, S in ipairs(test.S) do peak = math.max(peak, S) end
  for _, branch in ipairs(test.branches) do
    if branch.kind == "unloading" and test.S[branch.first] > loaded * peak and not (test.failure and branch.first > test.failure) then return branch end
  end
end

-- The unloading modulus after the first reversal, relative to first contact; nil if the test has only loading.
local function unloading_of(test, slack, t)
  local branch = first_unloading(test)
  if not branch then return end
  local E, S = {}, {}
  for i = branch.first, math.min(branch.last, branch.first + 250) do
    E[#E + 1], S[#S + 1] = curve.from_contact(test.E[i], test.S[i], 1 + slack)
  end
  return fabric.lab.unloading { E = E, S = S, rule = t.rule, count = t.count, kept = t.kept }
end

local function criterion_text(candidates)
  local lines = { ("%6s %14s %14s %14s  %s"):format("degree", "criterion", "D(0), MPa", "least D, MPa", "") }
  for i, c in ipairs(candidates) do
    local verdict = i == candidates.chosen and "chosen" or not c.admissible and "refused: tangent not positive" or ""
    lines[#lines + 1] = ("%6d %14.1f %14.4g %14.4g  %s"):format(c.degree, c.criterion, c.initial / 1e6, c.least / 1e6, verdict)
  end
  return table.concat(lines, "\n")
end

-- Mean over the specimens that have an unloading branch.
local function known_mean(values, n)
  local sum, count = 0, 0
  for i = 1, n do
    if values[i] then sum, count = sum + values[i], count + 1 end
  end
  if count > 0 then return sum / count end
end

local function polynomial(t, curves, find_slack)
  local degrees = type(t.degree) == "number" and { t.degree } or nil
  local least = (degrees and t.degree or 4) + 2 -- of degree 2 and 4 the higher
  for i, c in ipairs(curves) do
    local file = t.tests[i].file
    if #c.E < least then fail(("fit: expected at least %d loading points of every specimen, got %d of specimen %d%s"):format(least, #c.E, i, file and " (" .. file .. ")" or "")) end
  end
  local candidates = fabric.lab.backbone { curves = curves, degrees = degrees, find_slack = find_slack }
  local chosen = candidates[candidates.chosen or 0]
  local text = criterion_text(candidates)
  if not chosen then
    if t.degree == "auto" then return nil, text .. "\nno polynomial with a positive tangent: a monotone curve instead" end
    fail("fit: expected a positive tangent from zero to the end of the test\n" .. text)
  end
  return chosen, text
end

-- A parameter with a relative uncertainty above this is reported.
local loose = 0.3
local function looseness(out)
  local band = out.band
  if not band or not band.low then return end
  local half = math.max(band.high[1] - band.value[1], band.value[1] - band.low[1])
  if half > loose * math.abs(band.value[1]) then
    out.loose = ("D(0) is loosely determined: %.3g MPa, %.3g to %.3g"):format(band.value[1] / 1e6, band.low[1] / 1e6, band.high[1] / 1e6)
    out.text = (out.text and out.text .. "\n" or "") .. out.loose .. "; so is the coupling of the yarns, which depends on it"
  end
end

-- Parameters of every specimen, {loading..., unloading}; with unloading only if all have it.
local function parameter_lists(chosen, unloading)
  local lists = {}
  for i, specimen in ipairs(chosen.specimens) do
    lists[i] = table.move(specimen.loading, 1, #specimen.loading, 1, {})
    lists[i][#lists[i] + 1] = unloading[i]
  end
  return lists
end

local function band_of(lists, t)
  local common = {}
  for i = 1, #lists[1] do common[i] = t.common end
  return fabric.lab.band { specimens = lists, level = t.level, seed = t.seed, draws = t.draws, common = common }
end

local function with_polynomial(out, chosen, t)
  local lists = parameter_lists(chosen, out.unloading_of)
  local band = band_of(lists, t)
  out.loading = table.move(band.value, 1, chosen.degree, 1, {})
  out.degree, out.band, out.specimens = chosen.degree, band, chosen.specimens
  out.tested = math.huge
  for _, specimen in ipairs(chosen.specimens) do out.tested = math.min(out.tested, specimen.reach) end
end

-- A curve relative to first contact: the specimen is longer by its slack (a stretch), as for the polynomials.
local contact = 0.01 -- of the largest stress
local function from_contact(points)
  local peak, first = 0, nil
  for _, S in ipairs(points.S) do peak = math.max(peak, S) end
  for i = #points.S, 1, -1 do
    if points.S[i] <= contact * peak then
      first = i
      break
    end
  end
  if not first then return points, 0 end
  local stretch, out = math.sqrt(1 + 2 * points.E[first]), { E = {}, S = {} }
  for i = first, #points.E do
    out.E[#out.E + 1], out.S[#out.S + 1] = curve.from_contact(points.E[i], points.S[i], stretch)
  end
  return out, stretch - 1
end

-- The band of a curve of points: the stresses of the specimens at its strains, where every specimen reaches the last; with their unloading, as of a polynomial.
local function band_of_points(out, curves, t)
  local lists = {}
  for i, points in ipairs(curves) do
    local E, S = curve.envelope(points.E, points.S)
    table.insert(E, 1, 0.0)
    table.insert(S, 1, 0.0)
    lists[i] = {}
    for _, point in ipairs(out.loading) do
      if point[1] > 0 then lists[i][#lists[i] + 1] = curve.interpolate(E, S, point[1]) or curve.interpolate(E, S, math.min(point[1], E[#E])) end
    end
  end
  local band = band_of(lists, t)
  local place = 0
  for _, point in ipairs(out.loading) do
    if point[1] > 0 then
      place = place + 1
      local moved = point[2] - band.value[place]
      band.value[place] = point[2]
      if band.low then band.low[place], band.high[place] = band.low[place] + moved, band.high[place] + moved end
    end
  end
  out.band = band
end

local function with_points(out, curves, t)
  if t.find_slack == true then
    local taut = {}
    out.specimens = {}
    for i, points in ipairs(curves) do
      local slack
      taut[i], slack = from_contact(points)
      out.specimens[i] = { slack = slack }
    end
    curves = taut
    out.text = (out.text and out.text .. "\n" or "") .. ("slack up to where the stress leaves %g %% of its largest value"):format(100 * contact)
  end
  out.loading = kernels.monotone { curves = curves }
  out.tested = out.loading[#out.loading][1]
  if #curves > 1 then band_of_points(out, curves, t) end
end

-- Cloth unloads more steeply than it loads; a flatter unloading indicates noise, or a hold in the record.
local function check_unloading(out)
  if not out.unloading or not out.degree then return end
  local steepest = loading.tangents(out.loading, out.tested, 50)
  if out.unloading < steepest then
    fabric.warn(("fit: the unloading modulus found, %.4g MPa, is below the loading tangent, %.4g MPa: check the reversal (a hold? noise? rule=\"robust\")"):format(
      out.unloading / 1e6, steepest / 1e6))
  end
end

local function counted(n) return n == 1 and "1 specimen" or n .. " specimens" end

-- Records for the card which parameters were fitted, and from how many specimens.
local function remember(out, known, t)
  local how = out.degree and ("polynomial of degree %d"):format(out.degree) or "monotone curve"
  origin.remember(out, {
    loading = ("fitted to %s, %s%s"):format(counted(out.tests), how,
      out.loose and "; " .. out.loose or "") .. (out.tests == 1 and out.band and out.band.low and "; that specimens differ by 5 % (deviation) is a guess, one does not show it" or out.tests == 1 and "; no band, since one specimen does not show how others differ" or "")
      .. (out.not_in_band and "; " .. out.not_in_band or ""),
    unloading = ("fitted to %s%s, rule '%s'"):format(known < out.tests and known .. " of " or "", counted(out.tests), t.rule),
  })
end

-- A part of the band of few specimens in which no cloth lies: cards are drawn beside it, and hold less than the band says.
local function cut_of(out)
  local band, count = out.band, out.degree and 1 or out.loading and #out.loading - 1 or 0
  if not band or not band.low then return end
  local below = 0
  for k = 1, count do below = below + (band.low[k] <= 0 and 1 or 0) end
  if below == 0 then return end
  return ("the band of %s reaches below zero in %s: cards that are drawn from it (card:sample, fabric.budget) leave this out and may hold less than %g %%; a further specimen narrows it"):format(
    counted(out.tests), out.degree and "D(0)" or ("%d of %d points"):format(below, count), 100 * out.level)
end

-- An error that no record of a pull shows, and the band therefore does not hold: the give of machine and jaws, where none was taken off.
local give = 1e-7 -- m/N
local function not_in_band(t)
  local most, seen = 0, false
  for i = 1, #t.tests do
    local test = t.tests[i]
    local peak, reach = 0, 0
    for k, F in ipairs(test.force or {}) do peak, reach = math.max(peak, F), math.max(reach, (test.displacement or {})[k] or 0) end
    if test.force and test.compliance == 0 and test.slip == 0 and reach > 0 then most = math.max(most, give * peak / reach) end
    for _, sign in ipairs(test.warnings or {}) do seen = seen or sign.code == "slip" end
  end
  local lines = {}
  if most > 0 then lines[1] = ("not in the band: machine and jaws, of which no give was taken off (each %g m/N make the strains at the end %.2g %% too large)"):format(give, 100 * most) end
  if seen then lines[#lines + 1] = "not in the band: slip in the jaws, which was seen in a record and stays in the curve" end
  return #lines > 0 and table.concat(lines, "; ") or nil
end

-- Warns of specimens that the others do not explain. Where a specimen was hardly stretched, nothing can be said.
local function warn_of_unlike(out, t)
  if #t.tests < 3 then return end
  local compared, spread = pcall(fabric.lab.spread, { tests = t.tests, fit = out.specimens and out or nil })
  for _, odd in ipairs(compared and spread.unlike or {}) do
    local file = t.tests[odd.specimen].file
    local text = ("specimen %d%s is unlike the others: %.0f %% of their stress, where they differ by %.1f %%"):format(odd.specimen,
      file and " (" .. file:match "[^/]*$" .. ")" or "", 100 * odd.ratio, 100 * odd.deviation)
    out.warnings = out.warnings or {}
    table.insert(out.warnings, { code = "unlike", specimen = odd.specimen, text = text })
    fabric.warn("fit: " .. text)
  end
end

-- The stretch at the first row of a test whose contact was found by a threshold of the force, less one: contact may have begun since then. 0 of others.
local function earliest_of(tests)
  local least = 0
  for i = 1, #tests do
    if tests[i].contact_found then least = math.min(least, math.sqrt(1 + 2 * math.max(-0.37, tests[i].E[1])) - 1) end
  end
  return least
end

local function fit(t)
  local curves, out = {}, { level = t.level, unloading_of = {} }
  check.tests("fit", t.tests)
  for i = 1, #t.tests do
    local test = t.tests[i]
    check.test("fit", i, test)
    curves[i] = curve.loading(test, t.upto)
  end
  local earliest = earliest_of(t.tests)
  local open = t.find_slack ~= false or earliest < 0
  for _, points in ipairs(curves) do open = open and #points.E >= 6 end
  local whole, chosen = open and averaged.of(t, curves, earliest) or nil, nil
  if not whole then
    if t.degree ~= "monotone" then chosen, out.text = polynomial(t, curves, t.find_slack ~= false) end
    if not chosen then with_points(out, curves, t) end
  else
    out.text, out.degree, out.specimens, out.tested = whole.text, whole.degree, whole.specimens, whole.tested
  end
  local specimens = chosen and chosen.specimens or out.specimens or {}
  for i, test in ipairs(t.tests) do
    out.unloading_of[i] = unloading_of(test, specimens[i] and specimens[i].slack or 0, t)
  end
  out.tests, out.unloading = #t.tests, known_mean(out.unloading_of, #t.tests)
  local known = {}
  for i = 1, #t.tests do known[#known + 1] = out.unloading_of[i] and { out.unloading_of[i] } end
  if #known < #t.tests then
    out.unloading_of = {}
    if #known > 1 then
      out.unloading_band = band_of(known, t)
    end
  end
  if chosen then with_polynomial(out, chosen, t) end
  if whole then out.loading, out.band = whole.complete(out.unloading_of) end
  local cut = cut_of(out)
  out.not_in_band = not_in_band(t)
  out.not_in_band = cut and out.not_in_band and out.not_in_band .. "; " .. cut or cut or out.not_in_band
  looseness(out)
  if out.not_in_band then out.text = (out.text and out.text .. "\n" or "") .. out.not_in_band end
  check_unloading(out)
  remember(out, #known, t)
  warn_of_unlike(out, t)
  return out
end

define {
  name = "fabric.lab.fit",
  arguments = {
    { name = "tests", kind = "table", sentence = "replicates: results of fabric.lab.tensile or shear_from_bias" },
    { name = "degree", kind = "integer|text", low = 1, high = 8, choices = { "auto", "monotone" }, default = "auto",
      sentence = "of the stress polynomial; auto: 2 or 4 by the criterion; monotone: points of a rising curve" },
    { name = "find_slack", kind = "boolean|text", choices = { "either" }, default = false,
      sentence = "first contact is uncertain: curve and band are averaged over where it may be and over laws; true: there was slack; either: slack or none. The loading (auto) is the polynomial of degree 2, 4 or 6 that describes the average, else points" },
    { name = "upto", kind = "text", choices = { "failure", "yield" }, default = "failure", sentence = "rows used" },
    { name = "rule", kind = "text", choices = { "first", "robust" }, default = "first", sentence = "of the unloading modulus" },
    { name = "count", kind = "integer", low = 2, default = 3, sentence = "first points of the unloading" },
    { name = "kept", kind = "number", above = 0, high = 1, default = 0.7, sentence = "robust: part of the stress" },
    { name = "level", kind = "number", above = 0, high = 1, default = 0.95, sentence = "of confidence" },
    { name = "draws", kind = "integer", low = 100, high = 1000000, default = 2000, sentence = "of the bootstrap" },
    { name = "seed", kind = "integer", low = 0, default = 1, sentence = "of the bootstrap" },
    { name = "common", kind = "number", low = 0, default = 0,
      sentence = "relative standard uncertainty of all moduli together: load cell, thickness, width" },
  },
  sentence = "A backbone from replicate specimens: loading (tangent coefficients in Pa, or points), unloading, tested (reach of all), "
    .. "band {value, low, high, covariance} of {loading..., unloading} (without unloading where not every specimen unloads: then unloading_band is "
    .. "that of those that do), text (the criterion's table), specimens, tests (how many), warnings (specimens unlike the others, as fabric.lab.spread finds them).",
  example = "local E, S = {}, {}\nfor i = 0, 60 do E[i+1] = i/300; S[i+1] = 8e6*E[i+1] + 4e8*E[i+1]^2 end\n"
    .. "local test = { E=E, S=S, branches={ {kind='loading', first=1, last=61} } }\n"
    .. "local f = require 'fabric'.lab.fit{ tests={test}, degree=2 }\n"
    .. "assert(math.abs(f.loading[1] - 8e6) < 1 and math.abs(f.loading[2] - 8e8) < 10)",
  run = fit,
}
