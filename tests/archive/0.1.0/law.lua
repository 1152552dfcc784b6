-- Cards and material points: every kind of card, copies, what a card says of itself, paths at a point.
local fabric = require "fabric"
local mm, MPa = fabric.units.mm, fabric.units.MPa
local card = dofile((arg[0]:gsub("[^/]*$", "card.lua")))
local svk = fabric.svk{ young=10*MPa, poisson=0.3, density=400, thickness=0.5*mm }
local thin = card:with{ name="thin", thickness=0.3*mm, bending={ warp=15e-6, weft=12e-6, twist=5e-6 } }
thin:write "out/thin.lua"
local back = fabric.checking() and thin or fabric.card "./out/thin.lua"
local c = 0.42*8e6 / (1 - 0.25*0.42) -- the coupling, by its formula
local p = fabric.point(card)
local up, down = p:uniaxial("warp", 0.1), p:uniaxial("warp", 0.098)
local q = fabric.point(card):strain{ E11=0.05, E22=0.03, E12=0.02 }
fabric.expect{
  { "S at E = 0.1 is P(E), Pa", up.S, 8e6*0.1 + 826e6*0.1^2/2, relative=1e-12 },
  { "down at the unloading modulus, Pa", up.S - down.S, 864e6*0.002, relative=1e-9 },
  { "contraction", up.E_lateral, -0.025, relative=1e-12 },
  { "biaxial S11, Pa", q.S11, 8e6*0.05 + 826e6*0.05^2/2 + c*(0.25*0.05 + 0.03), relative=1e-12 },
  { "biaxial S22, Pa", q.S22, 37e6*0.03 + 1650e6*0.03^2/2 + c*(0.42*0.03 + 0.05), relative=1e-12 },
  { "shear S12, Pa", q.S12, 2e6*0.02 - 18e6*0.02^2/2 + 90e6*0.02^3/3 - 24e6*0.02^4/4, relative=1e-12 },
  { "St. Venant-Kirchhoff, Pa", fabric.point(svk):uniaxial("warp", 0.1).S, 1e6, relative=1e-12 },
  { "a card written and read", back.bending.weft + back.thickness, 12e-6 + 0.3*mm, relative=1e-15 },
  { "the card is usable (1: yes)", card:check().ok and 1 or 0, 1, absolute=0 },
}
