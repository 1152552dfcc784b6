-- fabric.lab.fit: loading curve and unloading modulus of replicate specimens, with confidence bands.
local fabric = require "fabric"
local define = require "fabric.define"
local check = require "fabric.lab.check"
local curve = require "fabric.lab.curve"
local origin = require "fabric.lab.origin"
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
  local candidates = fabric.lab.backbone { curves = curves, degrees = degrees, find_slack = find_slack }
  local chosen = candidates[candidates.chosen or 0]
  local text = criterion_text(candidates)
  if not chosen then
    if t.degree == "auto" then return nil, text .. "\nno polynomial with a positive tangent: a monotone curve instead" end
    fail("fit: expected a positive tangent from zero to the end of the test\n" .. text)
  end
  return chosen, text
end

-- Root mean square of the residuals of all specimens, Pa.
local function residual_of(chosen)
  local sum = 0
  for _, specimen in ipairs(chosen.specimens) do sum = sum + specimen.residual ^ 2 end
  return math.sqrt(sum / #chosen.specimens)
end

local function mean_loading(chosen)
  local out = {}
  for k = 1, chosen.degree do
    out[k] = 0
    for _, specimen in ipairs(chosen.specimens) do out[k] = out[k] + specimen.loading[k] / #chosen.specimens end
  end
  return out
end

-- Residuals of a specimen's polynomial along its loading: strain and stress from contact, and measured less fitted stress.
local function residuals(points, specimen)
  local out = { E = {}, S = {}, rest = {} }
  for k, E in ipairs(points.E) do
    local e, s = curve.from_contact(E, points.S[k], 1 + specimen.slack)
    if e > 0 then
      local model = 0
      for power, d in ipairs(specimen.loading) do model = model + d * e ^ power / power end
      out.E[#out.E + 1], out.S[#out.S + 1], out.rest[#out.rest + 1] = e, s, s - model
    end
  end
  return out
end

-- Correlation of neighbouring residuals, from 0 (noise) to 1 (a systematic deviation from the polynomial).
local function likeness(chosen, curves)
  local together, squares = 0, 0
  for i, points in ipairs(curves) do
    local rest = residuals(points, chosen.specimens[i]).rest
    for k = 2, #rest do together, squares = together + rest[k] * rest[k - 1], squares + rest[k] ^ 2 end
  end
  return squares > 0 and together / squares or 0
end

-- Chooses between the fits with and without slack: the one whose residual is smaller by a tenth. If neither is, or if the residuals are not
-- noise, so that the polynomial does not describe the curve anyway, the data do not determine the toe: the coefficients (means) of the other
-- fit are then returned besides.
local decides, systematic = 0.9, 0.5
local alike = 0.02 -- of D(0): two answers that are the same
local function either(t, curves)
  local with, with_text = polynomial(t, curves, true)
  local without, text = polynomial(t, curves, false)
  if not with then return without, text end
  if not without then return with, with_text .. "\nthere was slack: without it no polynomial has a positive tangent" end
  local r1, r0 = residual_of(with), residual_of(without)
  local same = with.degree == without.degree and math.abs(mean_loading(with)[1] - mean_loading(without)[1]) <= alike * mean_loading(without)[1]
  if same and (r1 >= decides * r0 or #curves == 1) then
    return r1 < decides * r0 and with or without, text .. ("\nwith slack or without, D(0) is the same within %g %% (residual %.3g kPa)"):format(100 * alike, r0 / 1e3)
  end
  local best, other = without, with
  if r1 < decides * r0 then best, other, text = with, without, with_text end
  local doubt = math.min(r1, r0) >= decides * math.max(r1, r0) or likeness(best, curves) > systematic
  local line = ("\nresidual %.3g kPa with slack, %.3g without; D(0) %.4g and %.4g MPa: "):format(r1 / 1e3, r0 / 1e3, mean_loading(with)[1] / 1e6,
    mean_loading(without)[1] / 1e6)
  if not doubt then return best, text .. line .. (best == with and "there was slack" or "there was none") end
  local beside = best.degree == other.degree and mean_loading(other) or nil
  return best, text .. line .. "the data do not decide which is right" .. (beside and ", the band holds both" or ""), beside
end

-- The misfit of a polynomial in the toe (the first fifth of the strain) as a share of the stress, if it exceeds a seventh and the noise,
-- estimated from neighbouring residuals: the polynomial then does not describe the toe. Otherwise nil.
local toe, missed = 0.2, 0.15
local function misses_toe(chosen, curves)
  local worst = 0
  for i, points in ipairs(curves) do
    local specimen = chosen.specimens[i]
    local seen = residuals(points, specimen)
    local squares, steps, level, n = 0, 0, 0, 0
    for k, e in ipairs(seen.E) do
      if e < toe * specimen.reach then
        squares, level, n = squares + seen.rest[k] ^ 2, level + seen.S[k], n + 1
        steps = steps + (k > 1 and (seen.rest[k] - seen.rest[k - 1]) ^ 2 / 2 or 0)
      end
    end
    if n >= 5 and squares > 2 * steps then -- the systematic part exceeds the noise
      worst = math.max(worst, math.sqrt((squares - steps) / n) * n / math.abs(level))
    end
  end
  return worst > missed and worst or nil
end

-- The polynomial chosen by the criterion, with `find_slack` applied to the toe; nil if a monotone curve is better.
local function loading_of(t, curves)
  if t.find_slack ~= "either" then return polynomial(t, curves, t.find_slack) end
  local chosen, text, other = either(t, curves)
  local miss = chosen and t.degree == "auto" and misses_toe(chosen, curves)
  if miss then return nil, text .. ("\nthe polynomial misses the toe by %.0f %% of the stress there: a monotone curve instead"):format(100 * miss) end
  return chosen, text, other
end

-- A band widened to include a second answer that the data support equally.
local function widened(band, other)
  if not other then return end
  local n = #band.value
  local delta = {}
  for i = 1, n do delta[i] = other[i] and other[i] - band.value[i] or 0 end
  if not band.low then
    band.low, band.high, band.covariance = table.move(band.value, 1, n, 1, {}), table.move(band.value, 1, n, 1, {}), {}
    for i = 1, n * n do band.covariance[i] = 0.0 end
  end
  for i = 1, n do
    band.low[i], band.high[i] = math.min(band.low[i], band.low[i] + delta[i]), math.max(band.high[i], band.high[i] + delta[i])
    for j = 1, n do band.covariance[(i - 1) * n + j] = band.covariance[(i - 1) * n + j] + delta[i] * delta[j] / 2 end
  end
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

local function with_polynomial(out, chosen, t, other)
  local lists = parameter_lists(chosen, out.unloading_of)
  local common = {}
  for i = 1, #lists[1] do common[i] = t.common end
  local band = fabric.lab.band { specimens = lists, level = t.level, seed = t.seed, draws = t.draws, common = common }
  widened(band, other)
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
  local lists, common = {}, {}
  for i, points in ipairs(curves) do
    local E, S = curve.envelope(points.E, points.S)
    table.insert(E, 1, 0.0)
    table.insert(S, 1, 0.0)
    lists[i] = {}
    for _, point in ipairs(out.loading) do
      if point[1] > 0 then lists[i][#lists[i] + 1] = curve.interpolate(E, S, point[1]) or curve.interpolate(E, S, math.min(point[1], E[#E])) end
    end
  end
  for i = 1, #lists[1] do common[i] = t.common end
  local band = fabric.lab.band { specimens = lists, level = t.level, seed = t.seed, draws = t.draws, common = common }
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
  out.loading = fabric.lab.monotone { curves = curves }
  out.tested = out.loading[#out.loading][1]
  if #curves > 1 then band_of_points(out, curves, t) end
end

-- Cloth unloads more steeply than it loads; a flatter unloading indicates noise, or a hold in the record.
local function check_unloading(out)
  if not out.unloading or not out.degree then return end
  local steepest = 0
  for i = 0, 50 do
    local D = 0
    for k, d in ipairs(out.loading) do D = D + d * (out.tested * i / 50) ^ (k - 1) end
    steepest = math.max(steepest, D)
  end
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
      out.loose and "; " .. out.loose or "") .. (out.tests == 1 and out.band and out.band.low and "; the band is that of the toe, one specimen does not show how others differ" or ""),
    unloading = ("fitted to %s%s, rule '%s'"):format(known < out.tests and known .. " of " or "", counted(out.tests), t.rule),
  })
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

local function fit(t)
  local curves, out = {}, { level = t.level, unloading_of = {} }
  check.tests("fit", t.tests)
  for i = 1, #t.tests do
    local test = t.tests[i]
    check.test("fit", i, test)
    curves[i] = curve.loading(test, t.upto)
  end
  local chosen, other
  if t.degree ~= "monotone" then chosen, out.text, other = loading_of(t, curves) end
  if not chosen then with_points(out, curves, t) end
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
      out.unloading_band = fabric.lab.band { specimens = known, level = t.level, seed = t.seed, draws = t.draws, common = { t.common } }
    end
  end
  if chosen then with_polynomial(out, chosen, t, other) end
  looseness(out)
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
      sentence = "first contact is fitted with the curve; either: only if that fits better by a tenth; if undecided, the band covers both, and a polynomial (auto) that misses the toe is replaced by a monotone curve" },
    { name = "upto", kind = "text", choices = { "failure", "yield" }, default = "failure", sentence = "rows used" },
    { name = "rule", kind = "text", choices = { "first", "robust" }, default = "first", sentence = "of the unloading modulus" },
    { name = "count", kind = "integer", low = 2, default = 3, sentence = "first points of the unloading" },
    { name = "kept", kind = "number", above = 0, high = 1, default = 0.7, sentence = "robust: part of the stress" },
    { name = "level", kind = "number", above = 0, high = 1, default = 0.95, sentence = "of confidence" },
    { name = "draws", kind = "integer", low = 100, default = 2000, sentence = "of the bootstrap" },
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
