-- fabric.lab.kilby: the constant shear modulus from a bias test, and the reverse [kilby1963; williams2010, eq. 3.4].
local define = require "fabric.define"

local function coupling(t)
  if t.reading == "printed" then return t.nu21 / t.warp + t.nu12 / t.weft end
  return t.nu12 / t.warp + t.nu21 / t.weft
end

define {
  name = "fabric.lab.kilby",
  arguments = {
    { name = "warp", kind = "number", unit = "Pa", above = 0, sentence = "E1" },
    { name = "weft", kind = "number", unit = "Pa", above = 0, sentence = "E2" },
    { name = "nu12", kind = "number", low = 0, sentence = "contraction along the weft when pulled along the warp" },
    { name = "nu21", kind = "number", low = 0, sentence = "the other way round" },
    { name = "bias", kind = "number", unit = "Pa", above = 0, optional = true, sentence = "E45; gives shear" },
    { name = "shear", kind = "number", unit = "Pa", above = 0, optional = true, sentence = "G12 (engineering), instead of bias" },
    { name = "reading", kind = "text", choices = { "definition", "printed" }, default = "definition",
      sentence = "nu12/E1 + nu21/E2 by the definition of the ratios, or nu21/E1 + nu12/E2 as eq. 3.4 is printed" },
  },
  sentence = "Kilby's relation G = 1/(4/E45 - 1/E1 - 1/E2 + coupling): returns shear and bias, one of which is given.",
  example = "local k = require 'fabric'.lab.kilby{ warp=8e6, weft=37e6, nu12=0.25, nu21=0.42, bias=3.93e6, reading='printed' }\n"
    .. "assert(math.abs(k.shear - 1.081e6) < 1e3)",
  run = function(t)
    local rest = 1 / t.warp + 1 / t.weft - coupling(t)
    if (t.bias == nil) == (t.shear == nil) then define.fail "kilby: field 'bias': expected either bias or shear" end
    if t.bias and 4 / t.bias <= rest then
      define.fail(("kilby: field 'bias': expected less than %.4g Pa, where the yarns alone would hold the strip, got %g"):format(4 / rest, t.bias))
    end
    if t.shear and 1 / t.shear + rest <= 0 then
      define.fail(("kilby: field 'nu12': with these moduli and shear %g Pa the ratios are too large for a bias modulus above zero"):format(t.shear))
    end
    return { shear = t.shear or 1 / (4 / t.bias - rest), bias = t.bias or 4 / (1 / t.shear + rest) }
  end,
}
