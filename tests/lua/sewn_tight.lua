-- A band that is too short is sewn around a rod without friction, in steps of 5 ms. What is tight on a curve turns without resistance there, and no step
-- may push it on: the run goes over to the rule that does not once it has made two fifths of the ledger's limit. The threads of the seam swing within a
-- step. It ends at rest, with the strain of the polygon of its nodes; slowly, too, where the work of the threads has the weights of the rule.
-- warns: its stiffness was assumed
local fabric = require "fabric"
local mm = fabric.units.mm
local R, thickness, n, short = 40 * mm, 0.5 * mm, 32, 0.96
local card = fabric.svk { young = 4e6, poisson = 0, density = 400, thickness = thickness, name = "band", bending = { warp = 1e-6, weft = 1e-6, twist = 5e-7 } }
local r = R + thickness / 2
local width = 2 * math.pi * r * short
local mesh = fabric.mesh.rectangle { width = width, height = 0.02, nx = n, ny = 2 }
mesh:map(function(x, z)
  local a = (x - width / 2) / (r + 1 * mm)
  return (r + 1 * mm) * math.sin(a), -(r + 1 * mm) * math.cos(a), z
end)
local side = 2 * r * math.tan(math.pi / n) -- facets touch with their middles
local stretch = side / (width / n)
for _, slow in ipairs { false, true } do
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, points = 1 }
  local rod = fabric.rigid.cylinder { radius = R, from = { 0, 0, -0.1 }, to = { 0, 0, 0.1 }, name = "rod" }
  m:contact { between = { rod, "all" }, stiffness = 5e8 }:contact { self = "all" }:seam { "left", "right", over = 0.1 }:fix("all", "z")
  local a = fabric.dynamic { model = m, duration = 0.2, scheme = "implicit", step = 5e-3, slow = slow, damping = { mass = 60 } }:solve()
  fabric.expect {
    { "stitches closed", a.joints.closed, a.joints.stitches, absolute = 0 },
    { "strain around", a:mean "E22", (stretch ^ 2 - 1) / 2, relative = 0.02 }, -- the depth of contact
    { "at rest: kinetic over stored energy", a.energy.kinetic / a.energy.stored, 0, absolute = 1e-4 },
    { "ledger", a.energy.error, 0, absolute = slow and 1e-9 or 3e-2 },
  }
end
