local fabric = require "fabric"
return fabric.woven{
  name = "all of it", source = "-", density = 590, thickness = 0.00038,
  warp = { loading = {8e6, 826e6}, unloading = 864e6, poisson = 0.25 },
  weft = { loading = {{0, 0}, {0.05, 2e6}, {0.1, 9e6}}, unloading = 1080e6, poisson = 0.42 },
  shear = { loading = {2e6, -18e6, 90e6, -24e6}, unloading = 12e6, measure = "engineering", memory = "fading" },
  tested = { warp = 0.26, weft = 0.14, shear = 0.3 },
  law = "incremental", transverse = "follow", shear_hysteresis = false,
  bending = { warp = 1e-5, weft = 2e-5, twist = 1e-5, friction_warp = { moment = 1e-3, curvature = 20 }, friction_weft = { moment = 1e-3, curvature = 20 } },
  biaxial = { alpha = 1, offset = 0.01, loading = 1e8, unloading = 1e8 },
  bands = { level = 0.95, warp = { low = {7e6, 800e6, 850e6, 0.2}, high = {9e6, 850e6, 880e6, 0.3},
    covariance = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1} },
    biaxial = { low = {1, 0.01, 9e7, 9e7}, high = {1, 0.01, 1.1e8, 1.1e8}, covariance = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1} } },
}
