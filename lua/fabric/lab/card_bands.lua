-- Bands of parameters propagated to the numbers of a card (fabric.lab.identify and fabric.lab.pool: found:card(make)).
local define = require "fabric.define"
local linear = require "fabric.lab.linear"
local fail = define.fail

local parts = { "warp", "weft", "shear" }

-- The numbers of a card's part to which its band refers: loading (of points: the stresses beyond zero strain), unloading, poisson.
local function numbers_of(part)
  local out = {}
  for _, d in ipairs(part.loading) do
    if type(d) ~= "table" then out[#out + 1] = d elseif d[1] ~= 0 then out[#out + 1] = d[2] end
  end
  out[#out + 1] = part.unloading
  out[#out + 1] = part.poisson
  return out
end

local function made(by, make, p)
  local card = make(p)
  if type(card) ~= "userdata" or card.kind ~= "woven" then fail(("%s: card: expected a function of the parameters that returns a woven card"):format(by)) end
  local out = {}
  for _, name in ipairs(parts) do out[name] = numbers_of(card[name]) end
  return card, out
end

-- Derivatives of a part's numbers by the parameters, by differences of a tenth of a deviation to both sides, within the bounds.
local function derivatives(by, found, parameters, deviation, make, base)
  local out = { warp = {}, weft = {}, shear = {} }
  for j, p in ipairs(parameters) do
    local low, high = {}, {}
    for name, x in pairs(found) do low[name], high[name] = x, x end
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
  for _, name in ipairs(parts) do
    if contradiction and band_of(base[name], slopes[name], covariance, quantile) then
      local own = card.provenance and card.provenance[name .. ".loading"]
      provenance[name .. ".loading"] = (own or "fitted: by fabric.lab." .. by) .. "; " .. contradiction
    end
  end
  for _, name in ipairs(parts) do bands[name] = band_of(base[name], slopes[name], covariance, quantile) or card.bands and card.bands[name] or nil end
  if not (bands.warp or bands.weft or bands.shear) then return card end
  return card:with { bands = bands, provenance = next(provenance) and provenance or nil }
end
