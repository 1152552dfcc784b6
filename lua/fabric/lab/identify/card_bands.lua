-- Bands of parameters propagated to the numbers of a card (fabric.lab.identify and fabric.lab.pool: found:card(make)).
local define = require "fabric.define"
local linear = require "fabric.lab.common.linear"
local fabric = require "fabric"
local lists = require "fabric.lists"
local fail = define.fail

local parts = { "warp", "weft", "shear", "bending", "biaxial" }
local of_yarn, of_friction = { "loading", "unloading", "poisson" }, { "moment", "curvature" }
-- The fields of a part to which its band refers, in the order of the card's rows.
local fields = { warp = of_yarn, weft = of_yarn, shear = of_yarn, biaxial = { "alpha", "offset", "loading", "unloading" },
  bending = { "warp", "weft", "twist", friction_warp = of_friction, friction_weft = of_friction } }
local names = {} -- of numbers that bands hold, as "bending.friction_warp.moment"

-- The numbers of a card's part to which its band refers: of curves the coefficients, or the ordinates of their points beyond zero.
local function numbers_of(part, list, out)
  for _, field in ipairs(list) do
    local value = part[field]
    for _, d in ipairs(type(value) == "table" and value or { value }) do
      if type(d) ~= "table" then out[#out + 1] = d elseif d[1] ~= 0 then out[#out + 1] = d[2] end
    end
  end
  for _, group in ipairs { "friction_warp", "friction_weft" } do
    if list[group] and part[group] then numbers_of(part[group], list[group], out) end
  end
  return out
end
local function listed(list, prefix)
  for key, value in pairs(list) do
    if type(value) == "table" then listed(value, prefix .. key .. ".") else names[prefix .. value] = true end
  end
end
for part, list in pairs(fields) do listed(list, part .. ".") end

local function made(by, make, p)
  local card = make(p)
  if type(card) ~= "userdata" or card.kind ~= "woven" then fail(("%s: card: expected a function of the parameters that returns a woven card"):format(by)) end
  local out = {}
  for _, name in ipairs(parts) do out[name] = card[name] and numbers_of(card[name], fields[name], {}) or {} end
  return card, out
end

-- Derivatives of a part's numbers by the parameters, by differences of a tenth of a deviation to both sides, within the bounds.
local function derivatives(by, found, parameters, deviation, make, base)
  local out = { warp = {}, weft = {}, shear = {}, bending = {}, biaxial = {} }
  for j, p in ipairs(parameters) do
    local low, high = lists.copy(found), lists.copy(found)
    low[p.name], high[p.name] = math.max(p.low, found[p.name] - 0.1 * deviation[j]), math.min(p.high, found[p.name] + 0.1 * deviation[j])
    local apart = high[p.name] - low[p.name]
    local _, a = made(by, make, low)
    local _, b = made(by, make, high)
    for _, name in ipairs(parts) do
      if #a[name] ~= #base[name] or #b[name] ~= #base[name] then fail(("%s: card: expected as many numbers of %s for all parameters"):format(by, name)) end
      for i in ipairs(base[name]) do
        out[name][i] = out[name][i] or {}
        out[name][i][j] = apart > 0 and (b[name][i] - a[name][i]) / apart or 0
      end
    end
  end
  return out
end

local function band_of(values, slopes, covariance, quantile)
  local out, uncertain = { low = {}, high = {}, covariance = {} }, false
  for i, x in ipairs(values) do
    local half = quantile * math.sqrt(math.max(0, linear.quadratic(covariance, slopes[i])))
    out.low[i], out.high[i], uncertain = x - half, x + half, uncertain or half > 0
    for j in ipairs(values) do
      local sum = 0
      for k, a in ipairs(slopes[i]) do
        for l, b in ipairs(slopes[j]) do sum = sum + a * covariance[k][l] * b end
      end
      out.covariance[(i - 1) * #values + j] = sum
    end
  end
  return uncertain and out or nil
end

-- The numbers of a card that no band of it holds, by names such as "shear.friction.stress"; of lists with a place.
local function others_of(card)
  local out = {}
  local function walk(name, value)
    if names[name] then return end
    if type(value) == "number" then out[name] = value end
    if type(value) ~= "table" then return end
    for key, inner in pairs(value) do walk(name .. "." .. tostring(key), inner) end
  end
  for _, name in ipairs { "warp", "weft", "shear", "bending", "biaxial", "viscous", "density", "thickness" } do walk(name, card[name]) end
  for name in pairs(out) do
    if name:find "%.tested$" then out[name] = nil end
  end
  return out
end

-- The 95 % intervals of such numbers that depend on the parameters, as words by the field of provenance that speaks of them, and all of them as a list.
local function unheld(found, parameters, covariance, quantile, make, card)
  local slopes, base = {}, others_of(card)
  for j, p in ipairs(parameters) do
    local ends = {}
    for side, sign in ipairs { -1, 1 } do
      local at = lists.copy(found)
      at[p.name] = math.max(p.low, math.min(p.high, found[p.name] + sign * 0.1 * math.sqrt(covariance[j][j])))
      ends[side] = { at = at[p.name], values = others_of(make(at)) }
    end
    local apart = ends[2].at - ends[1].at
    for name in pairs(base) do
      slopes[name] = slopes[name] or {}
      slopes[name][j] = apart > 0 and ((ends[2].values[name] or base[name]) - (ends[1].values[name] or base[name])) / apart or 0
    end
  end
  local by_field, list = {}, {}
  for _, name in ipairs(lists.keys(base)) do
    local half = quantile * math.sqrt(math.max(0, linear.quadratic(covariance, slopes[name])))
    if half > 1e-9 * math.abs(base[name]) then
      local first, second = name:match "^([^.]+)%.?([^.]*)"
      local field = second == "loop" and first .. ".loop" or (first == "viscous" or second == "") and first
      list[#list + 1] = ("%s from %.3g to %.3g"):format(name, base[name] - half, base[name] + half)
      if field then by_field[field] = (by_field[field] and by_field[field] .. ", " or "") .. list[#list] end
    end
  end
  return by_field, list
end

-- by: the caller's name; found: parameters by name; covariance: of them, a matrix (a parameter on a bound: zeros); quantile: half of a band over
-- its deviation; contradiction: nil, or words on how the data contradict the model, which go with the card (fabric.budget repeats them). Returns make(found) with bands on the parts that depend
-- on the parameters.
return function(by, found, parameters, covariance, quantile, level, make, contradiction)
  if type(make) ~= "function" then fail(("%s: card: expected a function of the parameters that returns a card, got %s"):format(by, tostring(make))) end
  local card, base = made(by, make, found)
  local deviation = {}
  for j in ipairs(parameters) do deviation[j] = math.sqrt(covariance[j][j]) end
  local slopes = derivatives(by, found, parameters, deviation, make, base)
  local bands, provenance = { level = level }, {}
  local function own(field) -- make changes a card by card:with
    local words = card.provenance and card.provenance[field]
    return words and not words:find "^typed: changed by" and not words:find "^assumed" and words or "fitted: by fabric.lab." .. by
  end
  for _, name in ipairs(parts) do
    local band, field = band_of(base[name], slopes[name], covariance, quantile), (name == "bending" or name == "biaxial") and name or name .. ".loading"
    bands[name] = band or card.bands and card.bands[name] or nil
    if band and (contradiction or field == name) then provenance[field] = own(field) .. (contradiction and "; " .. contradiction or "") end
  end
  -- A twist with an origin of its own, assumed otherwise, is fitted where a parameter moves it.
  local twist = card.bending and slopes.bending[#numbers_of(card.bending, { "warp", "weft", "twist" }, {})]
  if twist and card.provenance and card.provenance["bending.twist"] and linear.quadratic(covariance, twist) > 0 then provenance["bending.twist"] = "fitted: by fabric.lab." .. by end
  local by_field, list = unheld(found, parameters, covariance, quantile, make, card)
  for field, words in pairs(by_field) do
    provenance[field] = ("%s; interval of %.3g %%: %s; no band of a card holds it"):format(own(field), 100 * level, words)
  end
  if #list > 0 then
    fabric.warn(("%s: card: no band of a card holds %s (%.3g %%): card:sample keeps it as it is, and so does fabric.budget unless its field 'assumed' and run(p) vary it"):format(by, table.concat(list, ", "), 100 * level))
  end
  local any = false
  for _, name in ipairs(parts) do any = any or bands[name] ~= nil end
  if not any and not next(provenance) then return card end
  return card:with { bands = any and bands or nil, provenance = next(provenance) and provenance or nil }
end
