-- fabric.lab.fast and fast_card: the numbers of FAST [deboos1994] from curves, and a card from the numbers.
local fabric = require "fabric"
local define = require "fabric.define"

local g = 9.80665
-- FAST pulls with 5, 20 and 100 gf per cm of width: 4.903, 19.61 and 98.07 N/m. This agrees with its constants: 14.7 = 19.6 - 4.9
-- and 123 = 4.9 100/4.
local gf_per_cm = g * 1e-3 / 1e-2
local E5, E20, E100 = 5 * gf_per_cm, 20 * gf_per_cm, 100 * gf_per_cm

-- Stretch at which a curve first exceeds a force; nil if it does not.
local function stretch_at(curve, force)
  for i = 2, #curve.force do
    local a, b = curve.force[i - 1], curve.force[i]
    if a <= force and b >= force and b > a then
      return curve.stretch[i - 1] + (curve.stretch[i] - curve.stretch[i - 1]) * (force - a) / (b - a)
    end
  end
end

local function extension(curve, force, what)
  if #curve.stretch ~= #curve.force then
    define.fail(("fast: field '%s.force': expected %d numbers, one per stretch, got %d"):format(what, #curve.stretch, #curve.force))
  end
  local e = stretch_at(curve, force)
  if not e then define.fail(("fast: field '%s': expected a curve that passes %.4g N/m"):format(what, force)) end
  return 100 * e
end

local curve_rows = {
  { name = "stretch", kind = "numbers", sentence = "elongation over length" },
  { name = "force", kind = "numbers", unit = "N/m", sentence = "per width" },
}

define {
  name = "fabric.lab.fast",
  arguments = {
    { name = "along", kind = "fields", rows = curve_rows, sentence = "pull along a yarn" },
    { name = "bias", kind = "fields", rows = curve_rows, optional = true, sentence = "pull at 45 degrees" },
    { name = "bending_length", kind = "number", unit = "m", above = 0, optional = true, sentence = "C, by the cantilever" },
    { name = "mass_per_area", kind = "number", unit = "kg/m^2", above = 0, optional = true, sentence = "W" },
  },
  sentence = "E5, E20, E100 (per cent at 5, 20, 100 gf/cm: 4.90, 19.6, 98.1 N/m), EB5, G = 123/EB5 (N/m; FAST counts what the yarns stretch as shear), "
    .. "B = W g C^3 (uN.m), F = (E20 - E5) B / 14.7 (mm^2).",
  example = "local f = require 'fabric'.lab.fast{ along={ stretch={0, 0.02}, force={0, 98.0665} }, bending_length=0.02, mass_per_area=0.2 }\n"
    .. "assert(math.abs(f.E20 - 0.4) < 1e-12 and math.abs(f.B - 0.2*9.80665*8) < 1e-9)",
  run = function(t)
    local out = { E5 = extension(t.along, E5, "along"), E20 = extension(t.along, E20, "along"), E100 = extension(t.along, E100, "along") }
    if t.bias then
      out.EB5 = extension(t.bias, E5, "bias")
      out.G = 123 / out.EB5
    end
    if t.bending_length and t.mass_per_area then
      out.B = t.mass_per_area * g * t.bending_length ^ 3 * 1e6
      out.F = (out.E20 - out.E5) * out.B / 14.7
    end
    return out
  end,
}

-- S = d0 E + d1 E^2/2 through the extensions at 20 and 100 gf/cm.
local function yarn_of(f, thickness, ratio, poisson, name)
  if f.E20 >= f.E100 then define.fail(("fast_card: field '%s.E20': expected less than E100 (%g), got %g"):format(name, f.E100, f.E20)) end
  local function point(percent, force)
    local e = percent / 100
    return e + e * e / 2, force / (thickness * (1 + e))
  end
  local e1, S1 = point(f.E20, E20)
  local e2, S2 = point(f.E100, E100)
  local d1 = 2 * (S2 / e2 - S1 / e1) / (e2 - e1)
  local d0 = S1 / e1 - d1 * e1 / 2
  if d0 <= 0 then define.fail(("fast_card: field '%s': the curve through E20 and E100 starts downwards; expected E20 below about a fifth of E100"):format(name)) end
  return { loading = { d0, d1 }, unloading = ratio * (d0 + math.max(0, d1) * e2), poisson = poisson }, e2
end

-- The shear modulus (dS12/dE12) for which a strip of the card card_of(modulus), cut at 45 degrees, stretches by EB5 under 5 gf/cm,
-- from the yarns and shear together.
local function shear_of(card_of, EB5, thickness)
  local e = EB5 / 100
  local S = E5 / (thickness * (1 + e))
  local function stress(modulus) return fabric.point(card_of(modulus)):uniaxial(45, { e + e * e / 2 }, { "S" }).S[1] end
  local rigid = 2 * 123 / EB5 / thickness -- for inextensible yarns
  local low
  local high = rigid / 2
  repeat
    low, high = high, 4 * high
    if high > 1e3 * rigid then
      define.fail(("fast_card: field 'EB5': expected more: the yarns alone stretch a bias strip further than %g per cent"):format(EB5))
    end
  until stress(high) > S
  while stress(low) > S do low = low / 2 end
  while high / low - 1 > 1e-14 do
    local middle = math.sqrt(low * high)
    if middle <= low or middle >= high then break end
    if stress(middle) > S then high = middle else low = middle end
  end
  return high
end

local function percent(name, sentence) return { name = name, kind = "number", unit = "per cent", above = 0, sentence = sentence } end
local direction_rows = { percent("E20", "extension at 20 gf/cm"), percent("E100", "extension at 100 gf/cm"),
  { name = "B", kind = "number", unit = "uN.m", above = 0, sentence = "bending rigidity" } }

define {
  name = "fabric.lab.fast_card",
  arguments = {
    { name = "name", kind = "text", sentence = "of the fabric" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "T2, of the cloth" },
    { name = "density", kind = "number", unit = "kg/m^3", above = 0, sentence = "mass over volume" },
    { name = "warp", kind = "fields", rows = direction_rows, sentence = "FAST's numbers along the warp" },
    { name = "weft", kind = "fields", rows = direction_rows, sentence = "along the weft" },
    percent("EB5", "bias extension"),
    { name = "poisson", kind = "fields", sentence = "FAST does not measure them",
      rows = { { name = "warp", kind = "number", sentence = "as in fabric.woven" }, { name = "weft", kind = "number", sentence = "as in fabric.woven" } } },
    { name = "unloading_ratio", kind = "number", low = 1, default = 2, sentence = "unloading modulus over the largest tangent: FAST does not measure it" },
  },
  sentence = "A card that reproduces the given FAST numbers; the part of EB5 that comes from the yarns is not taken for shear. Unloading is assumed by its ratio; twist is half "
    .. "of the mean bending rigidity.",
  example = "local c = require 'fabric'.lab.fast_card{ name='suit', thickness=5e-4, density=400, warp={E20=0.9, E100=2.5, B=8}, weft={E20=1.2, E100=4, B=6},\n"
    .. "  EB5=4, poisson={warp=0.2, weft=0.2} }\nassert(c:check().ok and c.bending.warp == 8e-6)",
  run = function(t)
    local warp, warp_reach = yarn_of(t.warp, t.thickness, t.unloading_ratio, t.poisson.warp, "warp")
    local weft, weft_reach = yarn_of(t.weft, t.thickness, t.unloading_ratio, t.poisson.weft, "weft")
    local function card_of(shear)
      return fabric.woven { name = t.name, source = "from FAST numbers; Poisson ratios and unloading assumed", density = t.density, thickness = t.thickness,
        warp = warp, weft = weft, shear = { loading = { shear }, unloading = t.unloading_ratio * shear, measure = "tensor" },
        tested = { warp = warp_reach, weft = weft_reach, shear = 0.1 },
        bending = { warp = t.warp.B * 1e-6, weft = t.weft.B * 1e-6, twist = math.sqrt(t.warp.B * t.weft.B) * 1e-6 / 2 } }
    end
    return card_of(shear_of(card_of, t.EB5, t.thickness))
  end,
}
