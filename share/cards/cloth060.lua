-- A light cloth of 60 g/m2, stiff along the weft; fibre not stated.
return require "fabric.lab.hanging" {
  name = "cloth060", mass = 0.0602,
  -- Initial rigidity along warp, weft and at 45 degrees; it goes down with the curvature by 34139.2, 22219.7, 16867.3 pN.m2, which the card
  -- does not hold.
  cantilevers = { 4493.3, 17166.8, 9693.1 },
  source = "Feng et al. 2022, ACM TOG 41 [feng2022], dataset of DrapeTester/ClothDrapeTester: the fabric of 0.0602 kg/m2 with B 4493.3, 17166.8, 9693.1 nN.m",
}
