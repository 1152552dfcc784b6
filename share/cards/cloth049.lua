-- A very light cloth of 49 g/m2, fibre not stated. check() warns of the weft's rigidity, below 1 uN.m:
-- it was measured so.
return require "fabric.lab.hanging" {
  name = "cloth049", mass = 0.0490,
  -- Initial rigidity along warp, weft and at 45 degrees; it goes down with the curvature by 2316.3, 1867.0, 898.7 pN.m2, which the card
  -- does not hold.
  cantilevers = { 1078.5, 815.2, 884.8 },
  source = "Feng et al. 2022, ACM TOG 41 [feng2022], dataset of DrapeTester/ClothDrapeTester: the fabric of 0.0490 kg/m2 with B 1078.5, 815.2, 884.8 nN.m",
}
