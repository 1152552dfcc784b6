-- Cotton muslin WM12, plain weave.
local fabric = require "fabric"
local u = fabric.units

return fabric.woven {
  name = "muslin",
  source = "Williams 2010: tables 7.1 (axial moduli), 7.2 (Poisson ratios), 7.3 (shear), 3.3 (mass, thickness), 3.4 (tested range)",
  -- 100 g/m2 over 0.28 mm. Table 7.2 prints 350, denim's (the two rows are swapped); table 3.3 prints 370.
  density = 360,
  thickness = 0.28 * u.mm,
  warp = { loading = fabric.poly({ 9, 15300 }, u.MPa), unloading = 1570 * u.MPa, poisson = 2.04 },
  weft = { loading = fabric.poly({ 6, 274 }, u.MPa), unloading = 205 * u.MPa, poisson = 0.41 },
  -- Table 7.3 does not say its measure; it is the tensor one: dS12/dE12 over E12.
  shear = { loading = fabric.poly({ 2, -8, 13, 22 }, u.MPa), unloading = 6 * u.MPa, measure = "tensor" },
  -- Table 3.4: 3 and 10 mm on 76.2 mm, E = e + e^2/2; bias test to 20 mm.
  tested = { warp = (3 / 76.2) * (1 + 3 / 76.2 / 2), weft = (10 / 76.2) * (1 + 10 / 76.2 / 2), shear = 0.30 },
  -- The thesis measured no bending; as it did, a run integrates through the thickness, which is far stiffer than cloth.
  provenance = { bending = "assumed: not measured, so integrated through the thickness" },
  estimate = {
    bending = { warp = { 5.98e-6, -0.0146e-6 }, weft = { 3.98e-6, -0.0077e-6 }, twist = 1.19e-6, tested = 100 },
    source = "X. Feng et al., ACM TOG 41 (2022): median of 33 cloths of 101 g/m^2 within a quarter, cantilevers in three directions",
  },
}
