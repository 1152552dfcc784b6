-- A light, limp cloth of 97 g/m2, fibre not stated.
return require "fabric.lab.hanging" {
  name = "cloth097", mass = 0.0974,
  -- Initial rigidity along warp, weft and at 45 degrees; it goes down with the curvature by 2864.9, 2786.4, 3769.2 pN.m2, which the card
  -- does not hold.
  cantilevers = { 1138.4, 1899.0, 1678.1 },
  source = "Feng et al. 2022, ACM TOG 41 [feng2022], dataset of DrapeTester/ClothDrapeTester: the fabric of 0.0974 kg/m2 with B 1138.4, 1899.0, 1678.1 nN.m",
}
