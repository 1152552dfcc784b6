-- Wool of 150 g/m2 whose weft stretches and whose warp hardly does.
local fabric = require "fabric"
local u = fabric.units

-- Forces per width (N/m) at stretches of 0.4 % (weft) and 0.05 % (warp) a row. The source keeps F/(1+e); what stands here is that
-- times 1+e, which gives round numbers in every row.
local weft = { 1.5, 3.5, 10, 15, 25, 30, 40, 50, 60, 70, 85, 100, 125, 155, 195, 225, 255, 295, 340, 395, 470, 555, 635, 720, 835, 940,
  1060, 1170 }
local warp = { 8, 16, 20, 34, 42, 50, 60, 80, 100, 120, 160, 200, 260, 360, 420, 480, 620, 740, 920, 1080, 1210, 1420, 1620, 1920,
  2160, 2420, 2760, 3040 }
-- Shear force per width (N/m) at 0.01, 0.02 ... 0.14, the reach of KES' 8 degrees: taken as the engineering shear (the source does
-- not say which it is; if it were the tensor one the shear would be half as stiff).
local shear = { 1, 3, 5, 9.5, 13, 17, 20.5, 25, 29, 33, 38, 44.5, 51, 60 }

local thickness = 0.375 * u.mm
local function pulled(forces, step)
  local points, steepest = { { 0, 0 } }, 0
  for i, F in ipairs(forces) do
    local e = i * step
    points[i + 1] = { e + e * e / 2, F / (1 + e) / thickness }
    steepest = math.max(steepest, (points[i + 1][2] - points[i][2]) / (points[i + 1][1] - points[i][1]))
  end
  return { loading = points, unloading = 4 * steepest, poisson = 0.4 }, points[#points][1]
end
local along_warp, warp_reach = pulled(warp, 0.0005)
local along_weft, weft_reach = pulled(weft, 0.004)
local sheared = { { 0, 0 } }
for i, F in ipairs(shear) do sheared[i + 1] = { i * 0.01 / 2, F / thickness } end

-- Mass times gravity times the cube of 18.6 mm.
local B = 0.15 * 9.80665 * 0.0186 ^ 3
local unloading = "assumed: 4 times the steepest tangent, the rule of fabric.lab.card"
local poisson = "assumed: 0.4, the rule of fabric.lab.card"
return fabric.woven {
  name = "wool",
  source = "R. Strohkorb, rstrohkorb/GNATV_cloth_sim, gnatvCloth/include/Materials.h (about 2019): force and displacement of a cloth sample",
  density = 0.15 / thickness, thickness = thickness,
  warp = along_warp, weft = along_weft,
  shear = { loading = sheared, unloading = 3 * 2 * 900 / thickness, measure = "tensor" },
  tested = { warp = warp_reach, weft = weft_reach, shear = 0.07 },
  bending = { warp = B, weft = B, twist = B / 2 },
  provenance = {
    ["warp.loading"] = "measured: 28 points of a pull", ["weft.loading"] = "measured: 28 points of a pull",
    ["shear.loading"] = "measured: 14 points to 0.14, taken as engineering shear",
    ["warp.unloading"] = unloading, ["weft.unloading"] = unloading,
    ["shear.unloading"] = "assumed: 3 times the steepest tangent, the rule of fabric.lab.card",
    ["warp.poisson"] = poisson, ["weft.poisson"] = poisson,
    bending = "assumed: bending length 18.6 mm, the median of 100 fabrics of 100 to 225 g/m2 [feng2022]", ["bending.twist"] = "assumed: half of it",
    density = "measured: 150 g/m2 over the thickness", thickness = "assumed: areal mass over 400 kg/m3",
  },
}
