-- A heavy, limp cloth of 300 g/m2, fibre not stated.
return require "fabric.lab.hanging" {
  name = "cloth300", mass = 0.2997,
  -- Initial rigidity along warp, weft and at 45 degrees; it goes down with the curvature by 28157.6, 12874.6, 9902.7 pN.m2, which the card
  -- does not hold.
  cantilevers = { 8117.8, 7183.4, 6364.7 },
  source = "Feng et al. 2022, ACM TOG 41 [feng2022], dataset of DrapeTester/ClothDrapeTester: the fabric of 0.2997 kg/m2 with B 8117.8, 7183.4, 6364.7 nN.m",
}
