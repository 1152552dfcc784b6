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

-- The unloading modulus after the first reversal, seen from contact; nil when the test only loads.
local function unloading_of(test, slack, t)
  for _, branch in ipairs(test.branches) do
    if branch.kind == "unloading" then
      local E, S = {}, {}
      for i = branch.first, math.min(branch.last, branch.first + 250) do
        E[#E + 1] = ((1 + 2 * test.E[i]) / (1 + slack) ^ 2 - 1) / 2
        S[#S + 1] = test.S[i] * (1 + slack)
      end
      return fabric.lab.unloading { E = E, S = S, rule = t.rule, count = t.count, kept = t.kept }
    end
  end
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

local function with_points(out, curves)
  out.loading = fabric.lab.monotone { curves = curves }
  out.tested = out.loading[#out.loading][1]
end

local function fit(t)
  local curves, out = {}, { level = t.level, unloading_of = {} }
  for i, test in ipairs(t.tests) do curves[i] = loading_curve(test, t) end
  local chosen
  if t.degree ~= "monotone" then chosen, out.text = polynomial(t, curves) end
  for i, test in ipairs(t.tests) do
    out.unloading_of[i] = unloading_of(test, chosen and chosen.specimens[i].slack or 0, t)
  end
  local whole = #out.unloading_of == #t.tests
  out.unloading = known_mean(out.unloading_of, #t.tests)
  if not whole then out.unloading_of = {} end
  if chosen then with_polynomial(out, chosen, t) else with_points(out, curves) end
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
    .. "band {value, low, high, covariance} of {loading..., unloading}, text (the criterion's table), specimens.",
  example = "local E, S = {}, {}\nfor i = 0, 60 do E[i+1] = i/300; S[i+1] = 8e6*E[i+1] + 4e8*E[i+1]^2 end\n"
    .. "local test = { E=E, S=S, branches={ {kind='loading', first=1, last=61} } }\n"
    .. "local f = require 'fabric'.lab.fit{ tests={test}, degree=2 }\n"
    .. "assert(math.abs(f.loading[1] - 8e6) < 1 and math.abs(f.loading[2] - 8e8) < 10)",
  run = fit,
}
