-- fabric.lab.card: a card out of fits, with its bands and where they come from.
local fabric = require "fabric"
local define = require "fabric.define"

local function ratio_of(poisson)
  return type(poisson) == "table" and poisson.value or poisson
end

-- A band of the loading with that of the unloading behind it, where not every specimen unloads: that of the specimens that do,
-- no wider than its value when it is only one.
local function with_unloading(band, fit)
  local n, own = #band.value, fit.unloading_band or {}
  local out = { value = table.move(band.value, 1, n, 1, {}), low = table.move(band.low, 1, n, 1, {}), high = table.move(band.high, 1, n, 1, {}),
    covariance = {} }
  out.value[n + 1] = fit.unloading
  out.low[n + 1], out.high[n + 1] = own.low and own.low[1] or fit.unloading, own.high and own.high[1] or fit.unloading
  for i = 1, n + 1 do
    for j = 1, n + 1 do out.covariance[(i - 1) * (n + 1) + j] = i <= n and j <= n and band.covariance[(i - 1) * n + j] or 0.0 end
  end
  if own.covariance then out.covariance[(n + 1) ^ 2 // 1 | 0] = own.covariance[1] end
  return out
end

-- {low, high, covariance} of {loading..., unloading, poisson}; nil where a fit has none.
local function band_of(fit, poisson)
  local band = fit.band
  if not band or not band.low or not fit.degree or not fit.unloading then return end
  if #band.value == fit.degree then band = with_unloading(band, fit) end
  if poisson == nil then return { low = band.low, high = band.high, covariance = band.covariance } end
  local n, ratio = #band.value, ratio_of(poisson)
  local known = type(poisson) == "table" and poisson.low
  local out = { low = table.move(band.low, 1, n, 1, {}), high = table.move(band.high, 1, n, 1, {}), covariance = {} }
  out.low[n + 1], out.high[n + 1] = known and poisson.low or ratio, known and poisson.high or ratio
  for i = 1, (n + 1) ^ 2 do out.covariance[i] = 0.0 end
  for i = 1, n do
    for j = 1, n do out.covariance[(i - 1) * (n + 1) + j] = band.covariance[(i - 1) * n + j] end
  end
  out.covariance[(n + 1) ^ 2 // 1 | 0] = known and poisson.variance or 0
  return out
end

local function part_of(fit, poisson, what)
  if not fit.unloading then
    define.fail(("card: field '%s': expected a fit with an unloading modulus (a cyclic test), got one of loading alone"):format(what))
  end
  return { loading = fit.loading, unloading = fit.unloading, poisson = poisson and ratio_of(poisson) }
end

local function origin(fit, what)
  local how = fit.degree and ("polynomial of degree %d"):format(fit.degree) or "monotone curve"
  return ("%s: %d specimens, %s"):format(what, fit.tests or fit.specimens and #fit.specimens or 1, how)
end

local function card(t)
  local level
  local bands = {}
  for _, part in ipairs { "warp", "weft", "shear" } do
    bands[part] = band_of(t[part], t.poisson[part])
    level = level or bands[part] and t[part].level
  end
  bands.level = level
  local source = {}
  if t.source ~= "" then source[1] = t.source end
  for _, part in ipairs { "warp", "weft", "shear" } do source[#source + 1] = origin(t[part], part) end
  local shear = part_of(t.shear, nil, "shear")
  shear.measure = "tensor"
  return fabric.woven {
    name = t.name, source = table.concat(source, "; "), density = t.density, thickness = t.thickness,
    warp = part_of(t.warp, t.poisson.warp, "warp"), weft = part_of(t.weft, t.poisson.weft, "weft"), shear = shear,
    tested = { warp = t.warp.tested, weft = t.weft.tested, shear = t.shear.tested },
    bands = level and bands or nil, bending = t.bending,
  }
end

define {
  name = "fabric.lab.card",
  arguments = {
    { name = "name", kind = "text", sentence = "of the fabric" },
    { name = "source", kind = "text", default = "", sentence = "who measured, when; what was fitted is put behind it" },
    { name = "density", kind = "number", unit = "kg/m^3", above = 0, sentence = "as of fabric.lab.density" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "of the cloth" },
    { name = "warp", kind = "table", sentence = "result of fabric.lab.fit" },
    { name = "weft", kind = "table", sentence = "result of fabric.lab.fit" },
    { name = "shear", kind = "table", sentence = "result of fabric.lab.fit of shear tests (tensor measure)" },
    { name = "poisson", kind = "table", sentence = "{warp=, weft=}: numbers, or results of fabric.lab.poisson" },
    { name = "bending", kind = "table", optional = true, sentence = "as in fabric.woven" },
  },
  sentence = "A woven card from fits, with bands, tested ranges and provenance; card:write keeps them.",
  example = "local fit = { loading={8e6, 8e8}, unloading=9e8, tested=0.2 }\n"
    .. "local card = require 'fabric'.lab.card{ name='mine', density=600, thickness=4e-4, warp=fit, weft=fit,\n"
    .. "  shear={ loading={2e6}, unloading=12e6, tested=0.3 }, poisson={ warp=0.2, weft=0.3 } }\n"
    .. "assert(card.weft.poisson == 0.3)",
  run = card,
}
