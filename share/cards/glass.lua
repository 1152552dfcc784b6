-- Plain weave of glass and polypropylene, a reinforcement before it is pressed: two bias pulls, nothing else. check() warns
-- that no tested strain of the yarns is stated: none was tested.
local fabric = require "fabric"
local u = fabric.units

-- Monotone curve through both records (150 x 450 mm and 115 x 230 mm, two laboratories), as scripts/lab/real/glass.lua finds it
-- for a thickness of 1 mm: rms 2.1 and 3.5 % of the peak force. E12 (tensor), S12 in kPa.
local shear = {
  { 0.0041, 1.80 }, { 0.0202, 3.04 }, { 0.0313, 3.98 }, { 0.0425, 4.81 }, { 0.0538, 5.27 }, { 0.0768, 5.81 }, { 0.1002, 6.05 }, { 0.1121, 6.23 },
  { 0.1242, 6.59 }, { 0.1345, 7.28 }, { 0.1497, 7.87 }, { 0.1609, 8.32 }, { 0.1735, 8.74 }, { 0.1860, 9.59 }, { 0.1988, 10.41 }, { 0.2116, 11.54 },
  { 0.2222, 12.27 }, { 0.2359, 13.53 },
}
local points = { { 0, 0 } }
for i, p in ipairs(shear) do points[i + 1] = { p[1], p[2] * 1e3 } end
local steepest = points[2][2] / points[2][1]

local mass, thickness = 0.74, 1 * u.mm
local B = mass * 9.80665 * 0.0221 ^ 3
local yarn = { loading = { 50e3 / thickness }, unloading = 200e3 / thickness, poisson = 0 }
local loading, unloading = "assumed: straight, 50 kN/m", "assumed: 4 times the tangent, the rule of fabric.lab.card"
local poisson = "assumed: 0, yarns that hardly stretch"
return fabric.woven {
  name = "glass",
  source = "Cao et al. 2008, Composites A 39, 1037-1053 [cao2008], fig. 38 and the record of guzmalalo/bias_test",
  density = mass / thickness, thickness = thickness,
  warp = yarn, weft = yarn,
  shear = { loading = points, unloading = 3 * steepest, measure = "tensor" },
  tested = { shear = 0.2359 },
  bending = { warp = B, weft = B, twist = B / 2 },
  provenance = {
    ["warp.loading"] = loading, ["weft.loading"] = loading, ["warp.unloading"] = unloading, ["weft.unloading"] = unloading,
    ["warp.poisson"] = poisson, ["weft.poisson"] = poisson,
    ["shear.loading"] = "fitted to 2 specimens, monotone curve",
    ["shear.unloading"] = "assumed: 3 times the steepest tangent, the rule of fabric.lab.card",
    bending = "assumed: bending length 22.1 mm, the median of 15 fabrics above 500 g/m2 [feng2022]", ["bending.twist"] = "assumed: half of it",
    thickness = "assumed: 1 mm, over which the force per width was divided", density = "assumed: 740 g/m2 over the thickness",
  },
}
