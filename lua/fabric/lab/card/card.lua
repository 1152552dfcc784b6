-- fabric.lab.card: a card from fits, with confidence bands and the origin of each number.
local fabric = require "fabric"
local define = require "fabric.define"
local filled = require "fabric.lab.card.filled"
local origin = require "fabric.lab.card.origin"
local loading = require "fabric.lab.common.loading"
local fail = define.fail

-- Assumptions for unmeasured values, with the range found for the four supplied cloths (card "blend" and so on).
local rule = {
  unloading = { warp = 4, weft = 4, shear = 3, -- times the steepest tangent of the loading
    range = { warp = "2.5 to 10", weft = "2.5 to 10", shear = "1.5 to 3.9" } },
  poisson = { value = 0.4, range = "0.12 to 2.04" },
  shear = { value = 0.09, range = "0.05 to 0.27" }, -- times the mean initial modulus of the yarns
  yarns = { value = 11, range = "4 to 20" },        -- times the initial modulus in shear, the same rule the other way round
  inextensible = 0.01,                             -- largest strain of the yarns in a bias test, which is evaluated as if they had none
  stable = 0.9,                                    -- of the largest ratio with which the law stays stable
}

local parts = { "warp", "weft", "shear" }
local other = { warp = "weft", weft = "warp" }

local function ratio_of(poisson) return type(poisson) == "table" and poisson.value or poisson end

-- The band of the loading, extended by that of the unloading. If not every specimen was unloaded, the latter is from those that
-- were; with a single one it has no width.
local function with_unloading(band, fit, unloading)
  local n, own = #band.value, fit.unloading_band or {}
  local out = { value = table.move(band.value, 1, n, 1, {}), low = table.move(band.low, 1, n, 1, {}), high = table.move(band.high, 1, n, 1, {}),
    covariance = {} }
  out.value[n + 1] = unloading
  out.low[n + 1], out.high[n + 1] = own.low and own.low[1] or unloading, own.high and own.high[1] or unloading
  for i = 1, n + 1 do
    for j = 1, n + 1 do out.covariance[(i - 1) * (n + 1) + j] = i <= n and j <= n and band.covariance[(i - 1) * n + j] or 0.0 end
  end
  if own.covariance then out.covariance[(n + 1) ^ 2 // 1 | 0] = own.covariance[1] end
  return out
end

-- The numbers of a loading curve that a band refers to: its coefficients, or the stresses of its points beyond zero strain.
local function count_of(loading)
  local n = #loading
  return type(loading[1]) == "table" and loading[1][1] == 0 and n - 1 or n
end

-- {low, high, covariance} of {loading..., unloading, poisson}; nil if the loading is not the result of a fit, or has no band. A
-- number without a band gets one of zero width.
local function band_of(fit, unloading, poisson)
  local band = fit.band
  if not band or not band.low or not origin.fitted(fit, "loading") then return end
  local degree = count_of(fit.loading)
  if #band.value == degree then
    band = with_unloading(band, origin.fitted(fit, "unloading") and fit or {}, unloading)
  elseif band.value[degree + 1] ~= unloading then -- changed by hand after the fit
    local loading = { value = {}, low = {}, high = {}, covariance = {} }
    for i = 1, degree do
      loading.value[i], loading.low[i], loading.high[i] = band.value[i], band.low[i], band.high[i]
      for j = 1, degree do loading.covariance[(i - 1) * degree + j] = band.covariance[(i - 1) * (degree + 1) + j] end
    end
    band = with_unloading(loading, {}, unloading)
  end
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

-- Largest tangent of a loading curve up to `tested`, the tangent at zero, and the smallest, Pa.
local function tangents(curve, tested)
  local steepest, least, first = loading.tangents(curve, tested or 0, 50)
  return steepest, first, least
end

-- The stress of a loading curve at `tested`, Pa.
local function stress_at(curve, tested)
  return type(curve[1]) == "table" and curve[#curve][2] or loading.stress(curve, tested or 0)
end

-- The modulus of yarns that no test has pulled, from the shear: that of the rule, but as stiff as the bias test took them to be. In a pull at
-- 45 degrees the stress along either yarn is the shear stress.
local function yarns_from_shear(shear)
  local _, first = tangents(shear.loading, shear.tested)
  local by_rule, stiff = rule.yarns.value * first, stress_at(shear.loading, shear.tested) / rule.inextensible
  if by_rule >= stiff then
    return by_rule, ("assumed: straight, %g times the initial modulus in shear (%s on the shipped cloths), since no pull was made along a yarn"):format(
      rule.yarns.value, rule.yarns.range), { 0.36, 1.8 } -- the range of the rule over its value
  end
  return stiff, ("assumed: straight, %.3g MPa, with which the yarns stretch by %g %% at the end of the bias test, whose evaluation takes them for inextensible, "
    .. "since no pull was made along a yarn"):format(stiff / 1e6, 100 * rule.inextensible)
end

-- The deck's value for a missing parameter (assume = { ["warp.unloading"]=... }); nil if the rule shall be used. An error if
-- nothing may be assumed. lacks: what no test has shown.
local function assumed(t, field, lacks)
  if t.assume == false then
    fail(("card: field '%s': %s; give assume=true to take it by rule (share/doc/laboratory.md), or assume={ ['%s']=... }"):format(
      field:match "^%w+", lacks, field))
  end
  return type(t.assume) == "table" and t.assume[field] or nil
end

local function check_assume(t)
  if type(t.assume) ~= "table" then return end
  for field, value in pairs(t.assume) do
    local part, name = tostring(field):match "^(%w+)%.(%w+)$"
    local known = (part == "warp" or part == "weft") and (name == "unloading" or name == "poisson" or name == "loading")
      or part == "shear" and (name == "unloading" or name == "loading") or field == "thickness" or field == "density"
    if not known then
      fail(("card: field 'assume': expected warp, weft or shear with .loading, .unloading or (yarns) .poisson, thickness or density, got '%s'"):format(
        tostring(field)))
    end
    local wanted = name == "loading" and "table" or "number"
    if (field == "thickness" or field == "density") and value ~= true or part and type(value) ~= wanted then
      fail(("card: field 'assume': expected a %s for '%s', got %s"):format(part and wanted or "true (the number itself is the argument)", field, tostring(value)))
    end
  end
end

-- Checks that a result of fabric.lab.fit, or a similar table, has valid numbers for a card.
local function check_part(fit, name)
  if type(fit.loading) ~= "table" then
    fail(("card: field '%s': expected a result of fabric.lab.fit, or {loading=, unloading=}, got a table without loading"):format(name))
  end
  if #fit.loading == 0 then fail(("card: field '%s.loading': expected moduli, or points {strain, stress}, got an empty list"):format(name)) end
  if type(fit.loading[1]) ~= "table" then return end
  if #fit.loading < 2 then
    fail(("card: field '%s.loading': expected two points {strain, stress} or more, got 1: its test has hardly any rows of loading"):format(name))
  end
  for i, p in ipairs(fit.loading) do
    if type(p) ~= "table" or type(p[1]) ~= "number" or type(p[2]) ~= "number" then
      fail(("card: field '%s.loading': expected points {strain, stress}, got something else at place %d"):format(name, i))
    end
  end
end

-- The assumed part for a direction without a test; nil if there was one.
local function missing_part(t, name, provenance, ranges)
  if t[name] then return t[name] end
  local given = assumed(t, name .. ".loading", "there is no test of it")
  if given then
    provenance[name .. ".loading"] = "assumed: given by the deck"
    return { loading = given }
  end
  local twin = other[name] and t[other[name]]
  if twin then
    provenance[name .. ".loading"] = "assumed: as the " .. other[name] .. "'s, since no test was made along it"
    ranges[name .. ".loading"] = { filled.other_yarn[1], filled.other_yarn[2] }
    return { loading = twin.loading, tested = twin.tested, unloading = twin.unloading, loop = twin.loop }
  end
  if other[name] then
    if not t.shear or type(t.shear.loading) ~= "table" then
      fail(("card: field '%s': expected a result of fabric.lab.fit for one direction, or of shear, at least"):format(name))
    end
    local modulus
    modulus, provenance[name .. ".loading"], ranges[name .. ".loading"] = yarns_from_shear(t.shear)
    return { loading = { modulus } }
  end
  local sum, n = 0, 0
  for _, yarn in ipairs { t.warp or false, t.weft or false } do
    if yarn then
      sum, n = sum + select(2, tangents(yarn.loading, yarn.tested)), n + 1
    end
  end
  provenance["shear.loading"] = ("assumed: straight, %g of the yarns' initial modulus (%s on the shipped cloths), since no bias test was made"):format(
    rule.shear.value, rule.shear.range)
  ranges["shear.loading"] = { 0.55, 3 } -- the range of the rule over its value
  return { loading = { rule.shear.value * sum / n } }
end

local function unloading_of(t, fit, name, provenance)
  local field = name .. ".unloading"
  if fit.unloading then
    provenance[field] = provenance[name .. ".loading"]:find "^assumed" and provenance[name .. ".loading"] or origin.words(fit, "unloading", name)
    return fit.unloading
  end
  local given = assumed(t, field, "expected a fit with an unloading modulus (a cyclic test), got one of loading alone")
  provenance[field] = given and "assumed: given by the deck"
    or ("assumed: %g times the steepest tangent of the loading (%s on the shipped cloths), since no test includes unloading"):format(rule.unloading[name],
      rule.unloading.range[name])
  return given or rule.unloading[name] * tangents(fit.loading, fit.tested)
end

local function poisson_of(t, name, provenance)
  local ratio, field = (t.poisson or {})[name], name .. ".poisson"
  if ratio then
    provenance[field] = type(ratio) == "table" and (origin.fitted(ratio, "value") or "typed") or "typed"
    return ratio
  end
  local given = assumed(t, field, "expected a ratio in poisson={ warp=, weft= }")
  if given then
    provenance[field] = "assumed: given by the deck"
    return given
  end
  -- The coupling goes by the initial modulus: a yarn that softens below it permits no more than so much (0.1 is taken at least).
  local most = 1
  for _, part in ipairs { "warp", "weft" } do
    local fit = t[part]
    if fit and type(fit.loading) == "table" then
      local _, first, least = tangents(fit.loading, fit.tested)
      most = math.min(most, least / first)
    end
  end
  local value = math.min(rule.poisson.value, math.max(0.1, rule.stable * most))
  provenance[field] = ("assumed: %.3g (%s on the shipped cloths), since no markers were tracked"):format(value, rule.poisson.range)
  if value < rule.poisson.value then provenance[field] = provenance[field] .. ("; not %g, since the yarn softens, and the law would be unstable"):format(rule.poisson.value) end
  return value
end

-- Shear that relaxes, where a test shows it; and the line of the card's source where the tests show none.
local function viscous_of(t, provenance, source)
  local v = t.viscous
  if not v then return end
  local made = v.viscous or (v.reason == nil and v or nil)
  if not made then
    source[#source + 1] = "viscous: none, " .. v.reason:gsub("^%u", string.lower):gsub("%..*$", "")
    return
  end
  local shear = made.shear
  if type(shear) ~= "table" or type(shear.modulus) ~= "number" or type(shear.time) ~= "number" then
    fail "card: field 'viscous': expected a result of fabric.lab.viscous, or { shear={ modulus=, time= } }"
  end
  provenance.viscous = origin.fitted(v, "viscous") or "typed"
  local engineering = t.shear and t.shear.measure == "engineering"
  return { shear = { modulus = engineering and shear.modulus / 2 or shear.modulus, time = shear.time } }
end

-- Bending as cards take it, and the band of a result of fabric.lab.twist.
local function bending_of(t, provenance, ranges, source)
  local b = t.bending
  if b and not b.bending then provenance.bending = "typed" end
  if not b or not b.bending then return b end
  if type(b.bending) ~= "table" or type(b.strips) ~= "table" then fail "card: field 'bending': expected bending as fabric.woven takes it, or a result of fabric.lab.twist" end
  local along = {}
  for _, name in ipairs { "warp", "weft", "bias" } do
    if b.strips[name] then along[#along + 1] = ("%d along the %s"):format(b.strips[name], name) end
  end
  provenance.bending = ("measured: cantilevers, %s%s"):format(table.concat(along, ", "), b.band and "; of the curvatures of these strips, how it changes with curvature is not in the band"
    or "; one strip does not show how others differ, so that there is no band")
  if b.reached == nil then
    provenance["bending.twist"], ranges["bending.twist"] = "assumed: half of the geometric mean of warp and weft, since no strip at 45 degrees was tested", { 0.05, 5 }
  elseif b.reached == false then
    provenance["bending.twist"] = "measured: the strips at 45 degrees show less than any positive twist permits, the least is taken"
  end
  source[#source + 1] = "bending: cantilevers"
  return b.bending, b.band and { low = b.band.low, high = b.band.high, covariance = b.band.covariance }, b.band and b.band.level
end

-- The line in the card's source that describes a part.
local function summary(words, name)
  return name .. ": " .. (words:match "^fitted to ([^;]*)" or words:match "^(assumed):" or words)
end

local function card(t)
  check_assume(t)
  local provenance, ranges, made, bands, source, tested = {}, {}, {}, {}, { t.source ~= "" and t.source or nil }, {}
  for _, name in ipairs(parts) do
    if t[name] then check_part(t[name], name) end
  end
  for _, name in ipairs(parts) do
    local fit = missing_part(t, name, provenance, ranges)
    check_part(fit, name)
    provenance[name .. ".loading"] = provenance[name .. ".loading"] or origin.words(fit, "loading", name)
    local poisson = name ~= "shear" and poisson_of(t, name, provenance) or nil
    made[name] = { loading = fit.loading, unloading = unloading_of(t, fit, name, provenance), poisson = poisson and ratio_of(poisson) }
    if name ~= "shear" and fit.loop then
      made[name].loop = fit.loop
      provenance[name .. ".loop"] = provenance[name .. ".loading"]:find "^assumed" and provenance[name .. ".loading"] or origin.words(fit, "loop", name)
    end
    tested[name] = fit.tested
    bands[name] = band_of(fit, made[name].unloading, poisson)
    bands.level = bands.level or bands[name] and fit.level
    source[#source + 1] = summary(provenance[name .. ".loading"], name)
  end
  for _, field in ipairs { "thickness", "density" } do
    if type(t.assume) == "table" and t.assume[field] then provenance[field] = "assumed: given by the deck" end
  end
  local viscous = viscous_of(t, provenance, source)
  local bending, band, level = bending_of(t, provenance, ranges, source)
  if band and bands.level and level ~= bands.level then fail(("card: field 'bending': expected a band of %g %%, as the fits have, got %g %%"):format(100 * bands.level, 100 * level)) end
  bands.bending, bands.level = band, bands.level or level
  made.shear.measure, made.shear.memory = t.shear and t.shear.measure or "tensor", t.shear and t.shear.memory
  return fabric.woven {
    name = t.name, source = table.concat(source, "; "), density = t.density, thickness = t.thickness,
    warp = made.warp, weft = made.weft, shear = made.shear, tested = tested,
    bands = bands.level and bands or nil, bending = bending, viscous = viscous, provenance = provenance, ranges = ranges,
  }
end

define {
  name = "fabric.lab.card",
  arguments = {
    { name = "name", kind = "text", sentence = "of the fabric" },
    { name = "source", kind = "text", default = "", sentence = "who measured, when; what was fitted is put behind it" },
    { name = "density", kind = "number", unit = "kg/m^3", above = 0, sentence = "as of fabric.lab.density" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "of the cloth" },
    { name = "warp", kind = "table", optional = true, sentence = "result of fabric.lab.fit, the warp of a card, or {loading=, unloading=}" },
    { name = "weft", kind = "table", optional = true, sentence = "likewise" },
    { name = "shear", kind = "table", optional = true, sentence = "result of fabric.lab.fit of shear tests (tensor measure), or likewise" },
    { name = "poisson", kind = "table", optional = true, sentence = "{warp=, weft=}: numbers, or results of fabric.lab.poisson" },
    { name = "assume", kind = "boolean|table", default = false,
      sentence = "true: values without a test follow a rule and are marked assumed in card.provenance; a table gives values, {['warp.unloading']=..., "
        .. "['weft.poisson']=...}, and {thickness=true} marks an argument; false: an error" },
    { name = "bending", kind = "table", optional = true, sentence = "as in fabric.woven, or a result of fabric.lab.twist, with its band" },
    { name = "viscous", kind = "table", optional = true,
      sentence = "result of fabric.lab.viscous (which may find none), or { shear={ modulus=, time= } } in S12 over E12; default: nothing relaxes" },
  },
  sentence = "A woven card from fits, with bands, tested ranges and, in provenance, where each number comes from: fitted, copied off a card, "
    .. "typed, or assumed; card:write keeps them.",
  example = "local fit = { loading={8e6, 8e8}, unloading=9e8, tested=0.2 }\n"
    .. "local card = require 'fabric'.lab.card{ name='mine', density=600, thickness=4e-4, warp=fit, weft=fit,\n"
    .. "  shear=require 'fabric'.card 'denim'.shear, poisson={ warp=0.2, weft=0.3 } }\n"
    .. "assert(card.provenance['warp.loading'] == 'typed' and card.provenance['shear.loading'] == \"copied from the card 'denim'\")",
  run = card,
}
