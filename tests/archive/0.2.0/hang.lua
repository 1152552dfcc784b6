-- A strip with a bending rigidity that hangs over an edge, against the angle of the elastica: m:gravity, bending, static.
local fabric = require "fabric"
local mm = fabric.units.mm
local g, areal, thickness, c = 9.81, 0.2, 0.4*mm, 20*mm
local B = areal * g * c^3
local card = fabric.svk{ name="strip", young=50e6, poisson=0, density=areal / thickness, thickness=thickness, bending={ warp=B, weft=B, twist=B } }
local mesh = fabric.mesh.rectangle{ width=2*c, height=25*mm, nx=24, ny=1 }
local m = fabric.model{ mesh=mesh, card=card }
m:fix("left", "x y z rotation"):gravity{ 0, 0, -g }
local a = fabric.static{ model=m, duration=1, step=1 }:solve()
local tip = a:node(25)
fabric.expect{ { "the chord hangs at 41.5 degrees, by which ASTM D1388 reads a bending length", math.deg(math.atan(-tip.uz, 2*c + tip.ux)), 41.5, absolute=0.5 } }
