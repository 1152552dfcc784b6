-- A cloth of 201 g/m2, fibre not stated.
return require "fabric.lab.hanging" {
  name = "cloth201", mass = 0.2006,
  -- Initial rigidity along warp, weft and at 45 degrees; it goes down with the curvature by 15861.2, 7032.6, 14059.8 pN.m2, which the card
  -- does not hold.
  cantilevers = { 8852.1, 4705.9, 6244.4 },
  source = "Feng et al. 2022, ACM TOG 41 [feng2022], dataset of DrapeTester/ClothDrapeTester: the fabric of 0.2006 kg/m2 with B 8852.1, 4705.9, 6244.4 nN.m",
}
