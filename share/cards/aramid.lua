-- Plain-woven Kevlar 49, uncoated, as it stops fragments of an engine: pulls along warp and fill, nothing else.
-- check() warns that no tested strain of the shear is stated: it was not tested.
local fabric = require "fabric"
local u = fabric.units

-- Crimp is pulled straight by a strain of 0.0065 (warp) and 0.0025 (fill); then the modulus is 120 GPa of fibre section (pulls of
-- 25 mm at 30 per second, largest strain 0.0292; slower pulls were measured too, their modulus was not to be had).
local mass, thickness = 0.2, 0.25 * u.mm
local fibre = mass / 2 / 1450 / thickness -- fibre section that runs along one direction, over the card's section
local modulus, reach = 120e9 * fibre, 0.0292
local function yarn(crimp)
  local points, soft = { { 0, 0 } }, modulus / 10
  for i, e in ipairs { crimp, reach } do
    local S = soft * math.min(e, crimp) + modulus * math.max(0, e - crimp)
    points[i + 1] = { e + e * e / 2, S / (1 + e) }
  end
  return { loading = points, unloading = 2 * modulus, poisson = 0.4 }
end

local B = mass * 9.80665 * 0.0186 ^ 3
local shear = 0.09 * modulus / 10
local loading = "measured: crimp, modulus and largest strain; assumed: a tenth of the modulus within the crimp"
local unloading, poisson = "assumed: 2 times the modulus", "assumed: 0.4, the rule of fabric.lab.card"
return fabric.woven {
  name = "aramid",
  source = "Kevlar 49 fabric and single yarn, 13th Int. Conf. on Fracture, Beijing 2013, pages 4 and 7 of the paper (icfweb.org ICF13B 386, 389)",
  density = mass / thickness, thickness = thickness,
  warp = yarn(0.0065), weft = yarn(0.0025),
  shear = { loading = { shear }, unloading = 3 * shear, measure = "tensor" },
  tested = { warp = reach + reach ^ 2 / 2, weft = reach + reach ^ 2 / 2 },
  bending = { warp = B, weft = B, twist = B / 2 },
  provenance = {
    ["warp.loading"] = loading, ["weft.loading"] = loading, ["warp.unloading"] = unloading, ["weft.unloading"] = unloading,
    ["warp.poisson"] = poisson, ["weft.poisson"] = poisson,
    ["shear.loading"] = "assumed: straight, 0.09 of the yarns' initial modulus, the rule of fabric.lab.card",
    ["shear.unloading"] = "assumed: 3 times the tangent, the rule of fabric.lab.card",
    bending = "assumed: bending length 18.6 mm, the median of 100 fabrics of 100 to 225 g/m2 [feng2022]", ["bending.twist"] = "assumed: half of it",
    thickness = "assumed: 0.25 mm", density = "assumed: 200 g/m2 over the thickness, half of it fibres of 1450 kg/m3 each way",
  },
  ranges = { ["shear.loading"] = { 0.55, 3 } }, -- that of the rule over its value
}
