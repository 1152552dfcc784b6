-- Cotton denim BD11, twill.
local fabric = require "fabric"
local u = fabric.units

return fabric.woven {
  name = "denim",
  source = "Williams 2010: tables 7.1 (axial moduli), 7.2 (Poisson ratios), 7.3 (shear), 3.3 (mass, density, thickness), 3.4 (tested range)",
  -- 390 g/m2 over 1.12 mm, as in table 3.3. Table 7.2 prints 370 (its rows of muslin and denim are swapped).
  density = 350,
  thickness = 1.12 * u.mm,
  -- Table 7.1 writes the warp curve in E22; E11 is meant.
  warp = { loading = fabric.poly({ 7, 3, -200, 1810 }, u.MPa), unloading = 385 * u.MPa, poisson = 0.12 },
  weft = { loading = fabric.poly({ 15, -184, 6240, 3040 }, u.MPa), unloading = 402 * u.MPa, poisson = 0.22 },
  -- Table 7.3 does not say its measure; it is the tensor one: in the other, the modulus would turn negative inside the test.
  shear = { loading = fabric.poly({ 1, -4, 33, -53 }, u.MPa), unloading = 2 * u.MPa, measure = "tensor" },
  -- Table 3.4: 20 and 9 mm on 76.2 mm, E = e + e^2/2; bias test to 20 mm.
  tested = { warp = (20 / 76.2) * (1 + 20 / 76.2 / 2), weft = (9 / 76.2) * (1 + 9 / 76.2 / 2), shear = 0.30 },
  -- The thesis measured no bending; as it did, a run integrates through the thickness, which is far stiffer than cloth.
  provenance = { bending = "assumed: not measured, so integrated through the thickness" },
  estimate = {
    bending = { warp = { 32.2e-6, -0.0891e-6 }, weft = { 18.8e-6, -0.0474e-6 }, twist = 14.6e-6, tested = 100 },
    source = "X. Feng et al., ACM TOG 41 (2022): median of 24 cloths of 392 g/m^2 within a quarter, cantilevers in three directions",
  },
}
