-- A cloth of 146 g/m2, fibre not stated.
return require "fabric.lab.hanging" {
  name = "cloth146", mass = 0.1462,
  -- Initial rigidity along warp, weft and at 45 degrees; it goes down with the curvature by 6854.1, 5906.6, 4065.2 pN.m2, which the card
  -- does not hold.
  cantilevers = { 3436.1, 2478.2, 4024.7 },
  source = "Feng et al. 2022, ACM TOG 41 [feng2022], dataset of DrapeTester/ClothDrapeTester: the fabric of 0.1462 kg/m2 with B 3436.1, 2478.2, 4024.7 nN.m",
}
