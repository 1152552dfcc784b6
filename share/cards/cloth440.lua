-- A heavy, stiff cloth of 440 g/m2, fibre not stated. check() warns of the warp's
-- rigidity, above 100 uN.m: it was measured so.
return require "fabric.lab.hanging" {
  name = "cloth440", mass = 0.4404,
  -- Initial rigidity along warp, weft and at 45 degrees; it goes down with the curvature by 266849.4, 209415.4, 116530.7 pN.m2, which the card
  -- does not hold.
  cantilevers = { 108553.5, 24849.1, 53827.2 },
  source = "Feng et al. 2022, ACM TOG 41 [feng2022], dataset of DrapeTester/ClothDrapeTester: the fabric of 0.4404 kg/m2 with B 108553.5, 24849.1, 53827.2 nN.m",
}
