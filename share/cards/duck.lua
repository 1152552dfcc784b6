-- Cotton duck WD10, 2 x 1 basket weave.
local fabric = require "fabric"
local u = fabric.units

return fabric.woven {
  name = "duck",
  source = "Williams 2010: tables 7.1 (axial moduli), 7.2 (Poisson ratios, density), 7.3 (shear), 3.3 (thickness), 3.4 (tested range)",
  density = 470,
  thickness = 0.62 * u.mm,
  warp = { loading = fabric.poly({ 9, 5620 }, u.MPa), unloading = 1570 * u.MPa, poisson = 0.99 },
  weft = { loading = fabric.poly({ 28, -1000, 48300, -79200 }, u.MPa), unloading = 887 * u.MPa, poisson = 0.68 },
  -- Table 7.3 does not say its measure; it is the tensor one: dS12/dE12 over E12.
  shear = { loading = fabric.poly({ 1, -10, 105, -143 }, u.MPa), unloading = 14 * u.MPa, measure = "tensor" },
  -- Table 3.4: 6 and 7 mm on 76.2 mm, E = e + e^2/2; bias test to 20 mm.
  tested = { warp = (6 / 76.2) * (1 + 6 / 76.2 / 2), weft = (7 / 76.2) * (1 + 7 / 76.2 / 2), shear = 0.30 },
  -- The thesis measured no bending; as it did, a run integrates through the thickness, which is far stiffer than cloth.
  provenance = { bending = "assumed: not measured, so integrated through the thickness" },
  estimate = {
    bending = { warp = { 23.3e-6, -0.0585e-6 }, weft = { 14.6e-6, -0.035e-6 }, twist = 11.5e-6, tested = 100 },
    source = "X. Feng et al., ACM TOG 41 (2022): median of 42 cloths of 291 g/m^2 within a quarter, cantilevers in three directions",
  },
}
