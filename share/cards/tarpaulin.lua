-- Coated polyester of 1050 g/m2 for membrane structures, yarns of 1300 dtex, weave P 2/2. check() warns of its bending, above
-- 100 uN.m: the number is assumed. It warns as well that no tested strain is stated for the shear: it
-- was not tested.
local fabric = require "fabric"
local u = fabric.units

local thickness = 0.82 * u.mm
local warp, weft = 1520 * u.MPa, 1290 * u.MPa
local B = 1.05 * 9.80665 * 0.0221 ^ 3
local unloading = "assumed: 4 times the tangent, the rule of fabric.lab.card"
local poisson = "assumed: 0.4, the rule of fabric.lab.card"
return fabric.woven {
  name = "tarpaulin",
  source = "Adv. Mater. Sci. Eng. 2015, 387153 (impact vibration of a pretensioned rectangular membrane), table 3: the Xing Yida membrane",
  density = 1.05 / thickness, thickness = thickness,
  -- Straight to the tensile strength, 5500 and 5000 N over 5 cm: the table does not say at which stretch the moduli were read.
  warp = { loading = { warp }, unloading = 4 * warp, poisson = 0.4 },
  weft = { loading = { weft }, unloading = 4 * weft, poisson = 0.4 },
  shear = { loading = { 0.09 * (warp + weft) / 2 }, unloading = 3 * 0.09 * (warp + weft) / 2, measure = "tensor" },
  tested = { warp = 110e3 / thickness / warp, weft = 100e3 / thickness / weft },
  bending = { warp = B, weft = B, twist = B / 2 },
  provenance = {
    ["warp.loading"] = "measured: modulus of elasticity along the warp", ["weft.loading"] = "measured: modulus of elasticity along the weft",
    ["shear.loading"] = "assumed: straight, 0.09 of the yarns' mean modulus, the rule of fabric.lab.card",
    ["warp.unloading"] = unloading, ["weft.unloading"] = unloading,
    ["shear.unloading"] = "assumed: 3 times the tangent, the rule of fabric.lab.card",
    ["warp.poisson"] = poisson, ["weft.poisson"] = poisson,
    bending = "assumed: bending length 22.1 mm, the median of 15 fabrics above 500 g/m2 [feng2022]", ["bending.twist"] = "assumed: half of it",
    thickness = "measured: 0.82 mm", density = "measured: 1050 g/m2 over the thickness",
  },
  ranges = { ["shear.loading"] = { 0.55, 3 } }, -- that of the rule over its value
}
