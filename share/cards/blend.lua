-- Cotton-polyester blend CRS8, plain weave (the thesis also calls it C/P ripstop).
local fabric = require "fabric"
local u = fabric.units

return fabric.woven {
  name = "blend",
  source = "Williams 2010: tables 7.1 (axial moduli), 7.2 (Poisson ratios, density), 7.3 (shear), 3.3 (thickness), 3.4 (tested range)",
  density = 590,
  thickness = 0.38 * u.mm,
  warp = { loading = fabric.poly({ 8, 826 }, u.MPa), unloading = 864 * u.MPa, poisson = 0.25 },
  weft = { loading = fabric.poly({ 37, 1650 }, u.MPa), unloading = 1080 * u.MPa, poisson = 0.42 },
  -- Table 7.3 does not say its measure; it is the tensor one: dS12/dE12 over E12.
  shear = { loading = fabric.poly({ 2, -18, 90, -24 }, u.MPa), unloading = 12 * u.MPa, measure = "tensor" },
  -- Table 3.4: 18 and 10 mm on 76.2 mm, E = e + e^2/2; bias test to 20 mm.
  tested = { warp = (18 / 76.2) * (1 + 18 / 76.2 / 2), weft = (10 / 76.2) * (1 + 10 / 76.2 / 2), shear = 0.30 },
  -- The thesis measured no bending; as it did, a run integrates through the thickness, which is far stiffer than cloth.
  provenance = { bending = "assumed: not measured, so integrated through the thickness" },
  estimate = {
    bending = { warp = { 24.1e-6, -0.0682e-6 }, weft = { 13.6e-6, -0.0301e-6 }, twist = 9.7e-6, tested = 100 },
    source = "X. Feng et al., ACM TOG 41 (2022): median of 55 cloths of 224 g/m^2 within a quarter, cantilevers in three directions",
  },
}
