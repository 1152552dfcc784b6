-- The loading and unloading curves of a woven card in the measures of strain and stress that a target uses.
local sampled = require "fabric.export.sampled"
local curves = {}

local n = 64

-- Measures: convert points of uniaxial tension (E, S) -> x, y and of shear (E12, S12) at lambda1 = lambda2 = 1 -> x, y. Stresses stay in Pa.
curves.measures = {
  -- Green-Lagrange strain and second Piola-Kirchhoff stress; 2 E12 and S12
  green = {
    words = "second Piola-Kirchhoff stress over Green-Lagrange strain; shear: S12 over 2 E12",
    axis = function(E, S) return E, S end, shear = function(E12, S12) return 2 * E12, S12 end,
    axis_back = function(x, y) return x, y end, shear_back = function(x, y) return x / 2, y end,
  },
  -- force over initial section, elongation over initial length; S12 over the shear angle in degrees, sin = 2 E12
  nominal_degrees = {
    words = "nominal stress over engineering strain; shear: stress over the shear angle in degrees",
    axis = function(E, S) local l = math.sqrt(1 + 2 * E) return l - 1, l * S end,
    shear = function(E12, S12) return math.deg(math.asin(2 * E12)), S12 end,
    axis_back = function(x, y) return x + x * x / 2, y / (1 + x) end,
    shear_back = function(x, y) return math.sin(math.rad(x)) / 2, y end,
  },
  -- the same; shear stress conjugate to the change of the yarns' angle in radians: T12 = cos(angle) S12
  nominal_radians = {
    words = "nominal stress over nominal strain; shear: nominal stress over the change of the yarns' angle in radians",
    axis = function(E, S) local l = math.sqrt(1 + 2 * E) return l - 1, l * S end,
    shear = function(E12, S12) local g = math.asin(2 * E12) return g, math.cos(g) * S12 end,
    axis_back = function(x, y) return x + x * x / 2, y / (1 + x) end,
    shear_back = function(x, y) return math.sin(x) / 2, y / math.cos(x) end,
  },
}

local function mapped(measure, E, S)
  local out = { x = {}, y = {} }
  for i = 1, #E do out.x[i], out.y[i] = measure(E[i], S[i]) end
  return out
end

-- Continues a curve beyond its last point with the slope of the last segment, over the same range of strain again.
local function beyond(curve, x)
  local k = #curve.x
  local slope = (curve.y[k] - curve.y[k - 1]) / (curve.x[k] - curve.x[k - 1])
  curve.x[k + 1], curve.y[k + 1] = x, curve.y[k] + slope * (x - curve.x[k])
end

-- Beyond the tested strain the card is an extrapolation: if the curve stops rising there, its last slope is continued.
local function trim(curve, tested)
  for i = 3, #curve.x do
    if curve.x[i] > tested and curve.y[i] <= curve.y[i - 1] then
      local last = curve.x[#curve.x]
      for k = #curve.x, i, -1 do curve.x[k], curve.y[k] = nil, nil end
      return beyond(curve, last)
    end
  end
end

-- One part of a card: {loading={x, y}, unloading={x, y}, meet={x, y}, residual=}.
--   style "scaled": unloading rises from {0, 0}, hardly below the residual strain, meets the loading curve at the tested strain, and continues
--   style "shifted": unloading with the residual strain as its origin
local function part_of(card, name, measure, style)
  local tested = sampled.tested(card)[name]
  local shear = name == "shear"
  local reach = shear and math.min(1.3 * tested, (tested + 0.49) / 2) or 1.3 * tested
  local convert = shear and measure.shear or measure.axis
  local E, S
  if shear then E, S = sampled.shear(card, reach, n) else E, S = sampled.uniaxial(card, name, reach, n) end
  local loading = mapped(convert, E, S)
  local Eu, Su, residual = sampled.unloading(card, name, tested, 24)
  local down = mapped(convert, Eu, Su)
  local unloading, meet = { x = {}, y = {} }, { down.x[1], down.y[1] }
  local origin = down.x[#down.x]
  trim(loading, meet[1])
  if style == "scaled" then unloading.x[1], unloading.y[1] = 0, 0 end
  for i = #down.x, 1, -1 do
    local x, y = down.x[i], down.y[i]
    if style == "shifted" then x = x - origin elseif i == #down.x then y = 1e-3 * meet[2] end
    if not (style == "scaled" and i == #down.x and x <= 1e-6 * meet[1]) then -- without a residual strain that point is {0, 0} again
      unloading.x[#unloading.x + 1], unloading.y[#unloading.y + 1] = x, y
    end
  end
  beyond(unloading, unloading.x[#unloading.x] + loading.x[#loading.x] - meet[1])
  return { loading = loading, unloading = unloading, meet = meet, residual = residual, slope = loading.y[2] / loading.x[2] }
end

-- Name of the first part one of whose curves, loading or unloading, decreases somewhere, which the targets refuse; or nil.
function curves.falling(parts, written)
  for _, name in ipairs { "warp", "weft", "shear" } do
    for _, what in ipairs(written) do
      local c = parts[name][what]
      for i = 2, #c.x do
        if not (c.x[i] > c.x[i - 1] and c.y[i] > c.y[i - 1]) then return name, what, c.x[i] end
      end
    end
  end
end

function curves.of(card, measure_name, style)
  local measure = curves.measures[measure_name]
  local out = { words = measure.words }
  for _, name in ipairs { "warp", "weft", "shear" } do out[name] = part_of(card, name, measure, style) end
  return out
end

return curves
