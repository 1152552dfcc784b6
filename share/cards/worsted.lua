-- Plain-woven pure wool of 168 g/m2, the whole sheet of a FAST laboratory but for the thickness.
local fabric = require "fabric"
local u = fabric.units

-- Extension in per cent under 5, 20, 100 gf/cm (E5: warp 0.67, weft 0.40), bending length 15.0 and 14.5 mm, bias extension 4.7 %.
-- The curve with one bend goes through E20 and E100; of E5 it shows 0.76 and 0.57. Results there
-- from the measured ones: B 5.56 and 5.02 uN.m, G 26.17 N/m, formability 0.45 and 0.50 mm2, as FAST's formulas give.
local thickness = 0.42 * u.mm
local card = fabric.lab.fast_card {
  name = "worsted", thickness = thickness, density = 0.168 / thickness,
  warp = { E20 = 1.87, E100 = 4.60, B = 5.56 }, weft = { E20 = 1.87, E100 = 5.87, B = 5.02 }, EB5 = 4.7,
  poisson = { warp = 0.4, weft = 0.4 }, unloading_ratio = 2,
}
local unloading = "assumed: 2 times the steepest tangent, since FAST does not come back"
local poisson = "assumed: 0.4, the rule of fabric.lab.card"
return card:with {
  source = "Laboratory report 'Fabric Assurance by Simple Testing', tables II to VII (2014, author not named; bartleby.com, majortests.com)",
  provenance = {
    ["warp.loading"] = "measured: E20, E100 (FAST-3)", ["weft.loading"] = "measured: E20, E100 (FAST-3)",
    ["shear.loading"] = "measured: EB5 (FAST-3) less what the yarns stretch",
    ["warp.unloading"] = unloading, ["weft.unloading"] = unloading, ["shear.unloading"] = unloading,
    ["warp.poisson"] = poisson, ["weft.poisson"] = poisson,
    bending = "measured: bending length (FAST-2)", ["bending.twist"] = "assumed: half of the mean",
    density = "measured: 168 g/m2 over the thickness",
    thickness = "assumed: areal mass over 400 kg/m3; the report has only a surface thickness",
  },
}
