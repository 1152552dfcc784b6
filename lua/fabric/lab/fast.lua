-- fabric.lab.fast and fast_card: the numbers of FAST [deboos1994] from curves, and a card from the numbers.
local fabric = require "fabric"
local define = require "fabric.define"

local g = 9.80665

-- Stretch at which a curve first reaches a force; nil when it does not.
local function stretch_at(curve, force)
  for i = 2, #curve.force do
    local a, b = curve.force[i - 1], curve.force[i]
    if a <= force and b >= force and b > a then
      return curve.stretch[i - 1] + (curve.stretch[i] - curve.stretch[i - 1]) * (force - a) / (b - a)
    end
  end
end

local function extension(curve, force, what)
  local e = stretch_at(curve, force)
  if not e then define.fail(("fast: field '%s': expected a curve that reaches %g N/m"):format(what, force)) end
  return 100 * e
end

define {
  name = "fabric.lab.fast",
  arguments = {
    { name = "along", kind = "table", sentence = "{stretch=, force=} of a pull along a yarn; force in N/m of width" },
    { name = "bias", kind = "table", optional = true, sentence = "{stretch=, force=} of a pull at 45 degrees" },
    { name = "bending_length", kind = "number", unit = "m", above = 0, optional = true, sentence = "C, by the cantilever" },
    { name = "mass_per_area", kind = "number", unit = "kg/m^2", above = 0, optional = true, sentence = "W" },
  },
  sentence = "E5, E20, E100 (per cent at 5, 20, 100 N/m), EB5, G = 123/EB5 (N/m), B = W g C^3 (uN.m), F = (E20 - E5) B / 14.7 (mm^2).",
  example = "local f = require 'fabric'.lab.fast{ along={ stretch={0, 0.02}, force={0, 100} }, bending_length=0.02, mass_per_area=0.2 }\n"
    .. "assert(math.abs(f.E20 - 0.4) < 1e-12 and math.abs(f.B - 0.2*9.80665*8) < 1e-9)",
  run = function(t)
    local out = {}
    for _, n in ipairs { 5, 20, 100 } do out["E" .. n] = extension(t.along, n, "along") end
    if t.bias then
      out.EB5 = extension(t.bias, 5, "bias")
      out.G = 123 / out.EB5
    end
    if t.bending_length and t.mass_per_area then
      out.B = t.mass_per_area * g * t.bending_length ^ 3 * 1e6
      out.F = (out.E20 - out.E5) * out.B / 14.7
    end
    return out
  end,
}

-- S = d0 E + d1 E^2/2 through the extensions at 20 and 100 N/m.
local function yarn_of(f, thickness, ratio, poisson, name)
  local function point(percent, force)
    local e = percent / 100
    return e + e * e / 2, force / (thickness * (1 + e))
  end
  local E1, S1 = point(f.E20, 20)
  local E2, S2 = point(f.E100, 100)
  local d1 = 2 * (S2 / E2 - S1 / E1) / (E2 - E1)
  local d0 = S1 / E1 - d1 * E1 / 2
  if d0 <= 0 then define.fail(("fast_card: field '%s': the curve through E20 and E100 starts downwards; expected E20 below E100/5 or so"):format(name)) end
  return { loading = { d0, d1 }, unloading = ratio * (d0 + math.max(0, d1) * E2), poisson = poisson }, E2
end

define {
  name = "fabric.lab.fast_card",
  arguments = {
    { name = "name", kind = "text", sentence = "of the fabric" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "T2, of the cloth" },
    { name = "density", kind = "number", unit = "kg/m^3", above = 0, sentence = "mass over volume" },
    { name = "warp", kind = "table", sentence = "{E20=, E100=, B=}: per cent, uN.m" },
    { name = "weft", kind = "table", sentence = "{E20=, E100=, B=}" },
    { name = "EB5", kind = "number", above = 0, sentence = "bias extension, per cent" },
    { name = "poisson", kind = "table", sentence = "{warp=, weft=}: FAST does not measure them" },
    { name = "unloading_ratio", kind = "number", low = 1, default = 2, sentence = "unloading modulus over the largest tangent: FAST does not measure it" },
  },
  sentence = "A card that shows the given FAST numbers. Unloading is assumed by its ratio; twist is half of the mean bending rigidity.",
  example = "local c = require 'fabric'.lab.fast_card{ name='suit', thickness=5e-4, density=400, warp={E20=0.9, E100=2.5, B=8}, weft={E20=1.2, E100=4, B=6},\n"
    .. "  EB5=4, poisson={warp=0.2, weft=0.2} }\nassert(c:check().ok and c.bending.warp == 8e-6)",
  run = function(t)
    local warp, warp_reach = yarn_of(t.warp, t.thickness, t.unloading_ratio, t.poisson.warp, "warp")
    local weft, weft_reach = yarn_of(t.weft, t.thickness, t.unloading_ratio, t.poisson.weft, "weft")
    local shear = 2 * 123 / t.EB5 / t.thickness -- dS12/dE12 = 2 G / t
    return fabric.woven { name = t.name, source = "from FAST numbers; Poisson ratios and unloading assumed", density = t.density, thickness = t.thickness,
      warp = warp, weft = weft, shear = { loading = { shear }, unloading = t.unloading_ratio * shear, measure = "tensor" },
      tested = { warp = warp_reach, weft = weft_reach, shear = 0.1 },
      bending = { warp = t.warp.B * 1e-6, weft = t.weft.B * 1e-6, twist = math.sqrt(t.warp.B * t.weft.B) * 1e-6 / 2 } }
  end,
}
