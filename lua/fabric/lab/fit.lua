-- fabric.lab.fit: loading curve and unloading modulus of replicate specimens, with bands.
local fabric = require "fabric"
local define = require "fabric.define"
local fail = define.fail

-- Rows of a test that belong to virgin loading: the branches of that kind, up to yield or failure if wanted.
local function loading_curve(test, t)
  local stop = t.upto == "yield" and (test.yield or test.failure) or test.failure
  local E, S = {}, {}
  for _, branch in ipairs(test.branches) do
    if branch.kind == "loading" then
      for i = branch.first, math.min(branch.last, stop or branch.last) do
        E[#E + 1], S[#S + 1] = test.E[i], test.S[i]
      end
    end
    if stop and branch.last >= stop then break end
  end
  return { E = E, S = S }
end

-- The first unloading that begins under load: what comes before a pull begins (the grip let down on slack cloth) is none.
local loaded = 0.1 -- of the largest stress
local function first_unloading(test)
  local peak = 0
  for _, S in ipairs(test.S) do peak = math.max(peak, S) end
  for _, branch in ipairs(test.branches) do
    if branch.kind == "unloading" and test.S[branch.first] > loaded * peak and not (test.failure and branch.first > test.failure) then return branch end
  end
end

-- The unloading modulus after the first reversal, seen from contact; nil when the test only loads.
local function unloading_of(test, slack, t)
  local branch = first_unloading(test)
  if not branch then return end
  local E, S = {}, {}
  for i = branch.first, math.min(branch.last, branch.first + 250) do
    E[#E + 1] = ((1 + 2 * test.E[i]) / (1 + slack) ^ 2 - 1) / 2
    S[#S + 1] = test.S[i] * (1 + slack)
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

-- Mean over those specimens that have an unloading branch.
local function known_mean(values, n)
  local sum, count = 0, 0
  for i = 1, n do
    if values[i] then sum, count = sum + values[i], count + 1 end
  end
  if count > 0 then return sum / count end
end

local function polynomial(t, curves)
  local degrees = type(t.degree) == "number" and { t.degree } or nil
  local candidates = fabric.lab.backbone { curves = curves, degrees = degrees, find_slack = t.find_slack }
  local chosen = candidates[candidates.chosen or 0]
  local text = criterion_text(candidates)
  if not chosen then
    if t.degree == "auto" then return nil, text .. "\nno polynomial with a positive tangent: a monotone curve instead" end
    fail("fit: expected a positive tangent from zero to the end of the test\n" .. text)
  end
  return chosen, text
end

-- Parameters of every specimen, {loading..., unloading}; unloading where all have it.
local function parameter_lists(chosen, unloading)
  local lists = {}
  for i, specimen in ipairs(chosen.specimens) do
    lists[i] = table.move(specimen.loading, 1, #specimen.loading, 1, {})
    lists[i][#lists[i] + 1] = unloading[i]
  end
  return lists
end

local function with_polynomial(out, chosen, t)
  local lists = parameter_lists(chosen, out.unloading_of)
  local common = {}
  for i = 1, #lists[1] do common[i] = t.common end
  local band = fabric.lab.band { specimens = lists, level = t.level, seed = t.seed, draws = t.draws, common = common }
  out.loading = table.move(band.value, 1, chosen.degree, 1, {})
  out.degree, out.band, out.specimens = chosen.degree, band, chosen.specimens
  out.tested = math.huge
  for _, specimen in ipairs(chosen.specimens) do out.tested = math.min(out.tested, specimen.reach) end
end

-- A curve seen from first contact: the specimen is longer by its slack (a stretch), as for the polynomials.
local contact = 0.01 -- of the largest stress
local function from_contact(curve)
  local peak, first = 0, nil
  for _, S in ipairs(curve.S) do peak = math.max(peak, S) end
  for i = #curve.S, 1, -1 do
    if curve.S[i] <= contact * peak then
      first = i
      break
    end
  end
  if not first then return curve, 0 end
  local stretch, out = math.sqrt(1 + 2 * curve.E[first]), { E = {}, S = {} }
  for i = first, #curve.E do
    out.E[#out.E + 1], out.S[#out.S + 1] = ((1 + 2 * curve.E[i]) / stretch ^ 2 - 1) / 2, curve.S[i] * stretch
  end
  return out, stretch - 1
end

local function with_points(out, curves, t)
  if t.find_slack then
    local taut = {}
    out.specimens = {}
    for i, curve in ipairs(curves) do
      local slack
      taut[i], slack = from_contact(curve)
      out.specimens[i] = { slack = slack }
    end
    curves = taut
    out.text = (out.text and out.text .. "\n" or "") .. ("slack up to where the stress leaves %g %% of its largest value"):format(100 * contact)
  end
  out.loading = fabric.lab.monotone { curves = curves }
  out.tested = out.loading[#out.loading][1]
end

-- Cloth unloads along a line steeper than any way up; a flatter one tells of noise, or of a hold in the record.
local function check_unloading(out)
  if not out.unloading or not out.degree then return end
  local steepest = 0
  for i = 0, 50 do
    local D = 0
    for k, d in ipairs(out.loading) do D = D + d * (out.tested * i / 50) ^ (k - 1) end
    steepest = math.max(steepest, D)
  end
  if out.unloading < steepest then
    fabric.warn(("fit: the unloading modulus found, %.4g MPa, is below the loading tangent, %.4g MPa: look at the reversal (a hold? noise? rule=\"robust\")"):format(
      out.unloading / 1e6, steepest / 1e6))
  end
end

local function fit(t)
  local curves, out = {}, { level = t.level, unloading_of = {} }
  for i, test in ipairs(t.tests) do curves[i] = loading_curve(test, t) end
  local chosen
  if t.degree ~= "monotone" then chosen, out.text = polynomial(t, curves) end
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
  if chosen then with_polynomial(out, chosen, t) end
  check_unloading(out)
  return out
end

define {
  name = "fabric.lab.fit",
  arguments = {
    { name = "tests", kind = "table", sentence = "replicates: results of fabric.lab.tensile or shear_from_bias" },
    { name = "degree", kind = "integer|text", low = 1, high = 8, choices = { "auto", "monotone" }, default = "auto",
      sentence = "of the stress polynomial; auto: 2 or 4 by the criterion; monotone: points of a rising curve" },
    { name = "find_slack", kind = "boolean", default = false, sentence = "first contact is found with the curve" },
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
    .. "that of those that do), text (the criterion's table), specimens, tests (how many).",
  example = "local E, S = {}, {}\nfor i = 0, 60 do E[i+1] = i/300; S[i+1] = 8e6*E[i+1] + 4e8*E[i+1]^2 end\n"
    .. "local test = { E=E, S=S, branches={ {kind='loading', first=1, last=61} } }\n"
    .. "local f = require 'fabric'.lab.fit{ tests={test}, degree=2 }\n"
    .. "assert(math.abs(f.loading[1] - 8e6) < 1 and math.abs(f.loading[2] - 8e8) < 10)",
  run = fit,
}
