-- SI units: Pa, m, kg/m^3; strains are Green-Lagrange, tensor components.
local fabric = require "fabric"
return fabric.woven{
  name = "archived blend",
  source = "as card:write of 0.1.0 wrote it",
  density = 590, thickness = 0.00038000000000000002,
  warp = { loading = {8e+06, 8.26e+08}, unloading = 8.64e+08, poisson = 0.25 },
  weft = { loading = {3.7e+07, 1.65e+09}, unloading = 1.08e+09, poisson = 0.42 },
  shear = { loading = {2e+06, -1.8e+07, 9e+07, -2.4e+07}, unloading = 1.2e+07, measure = "tensor", memory = "printed" },
  tested = { warp = 0.26, weft = 0.14, shear = 0.3 },
  law = "potential",
}
