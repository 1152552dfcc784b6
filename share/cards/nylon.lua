-- Heat-bondable nylon fabric of 62 g/m2, pulled at 0, 45 and 90 degrees.
local fabric = require "fabric"
local u = fabric.units

local GPa = 1e3 * u.MPa
-- The elastic lamina that the authors of the records fitted to their own tests: rigidity E t^3/12.
local thickness, E1, E2 = 0.0675 * u.mm, 376.4 * u.MPa, 700.0 * u.MPa
local third = thickness ^ 3 / 12
local unloading = "assumed: 4 times the steepest tangent, the rule of fabric.lab.card"
local poisson = "assumed: 0.4, the rule of fabric.lab.card; the authors' lamina has 0"
return fabric.woven {
  name = "nylon",
  source = "bertoldi-collab/aerodynamic-textile-metamaterials (MIT): strips 2.25 mm wide, 12 side by side, 97 mm long; LAM_nylon_strips_2-25.py",
  density = 913.4, thickness = thickness,
  -- As scripts/lab/real/nylon.lua fits them with this thickness: rms 0.1, 0.2 and, at 45 degrees, 0.9 % of the peak.
  warp = { loading = { 0.3034 * GPa, 3.219 * GPa, 205.8 * GPa, -5144 * GPa }, unloading = 1.795 * GPa, poisson = 0.4 },
  weft = { loading = { 1.007 * GPa, -10.46 * GPa, -141.5 * GPa, 7452 * GPa }, unloading = 4.030 * GPa, poisson = 0.4 },
  shear = { loading = { 83.29 * u.MPa, -1660 * u.MPa }, unloading = 249.9 * u.MPa, measure = "tensor" },
  tested = { warp = 0.04056, weft = 0.03860, shear = 0.018 },
  bending = { warp = E1 * third, weft = E2 * third, twist = math.sqrt(E1 * E2) * third / 2 },
  provenance = {
    ["warp.loading"] = "fitted to 1 specimen, polynomial of degree 4",
    ["weft.loading"] = "fitted to 1 specimen, polynomial of degree 4; D(0) is loosely determined",
    ["shear.loading"] = "fitted to 1 specimen, the pull at 45 degrees",
    ["warp.unloading"] = unloading, ["weft.unloading"] = unloading,
    ["shear.unloading"] = "assumed: 3 times the steepest tangent, the rule of fabric.lab.card",
    ["warp.poisson"] = poisson, ["weft.poisson"] = poisson,
    bending = "assumed: E t^3/12 of the authors' lamina", ["bending.twist"] = "assumed: half of the mean",
    thickness = "fitted by the authors of the records, with their lamina", density = "typed: as the authors of the records give it",
  },
}
