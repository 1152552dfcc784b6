-- Cotton broad, a shirting of 124 g/m2. Bending, mass and thickness are measured, the in-plane part is not.
local u = require "fabric".units
local gf, cm = 9.80665e-3 * u.N, 1e-2

-- KES: B 0.118 gf cm2/cm, 2HB 0.124 gf cm/cm, one number each, taken for both directions; W 12.38 mg/cm2, T 0.497 mm.
local B = 0.118 * gf * cm
local friction = { moment = 0.124 * gf / 2, curvature = 10 }
return require "fabric.lab.hanging" {
  name = "broad", mass = 12.38e-2, thickness = 0.497 * u.mm,
  source = "Matsudaira, Masuda, Wada, Yokura 2015, J. Textile Eng. 61 [matsudaira2015], table 1, quoted in antonbj3/3fold-motion-engine: cotton broad",
  bending = { warp = B, weft = B, twist = B / 2, friction_warp = friction, friction_weft = friction },
  bending_origin = "measured: B, 2HB, one number for both directions; friction builds up over 10 1/m",
  twist_origin = "assumed: half of B",
}
