-- The mean force of tongue and trouser tears on h, h / 2 and h / 4: half of the energy of breaking, and within 5 % alike on all. The work beyond
-- that goes into swinging legs, which differs from mesh to mesh. Long: the finest takes ten seconds.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("long/[^/]*$", "common.lua")))
local checks = common.checks()
local mm = fabric.units.mm

local card = common.sheet { warp = 1e8, weft = 6e7, shear = 3e7, poisson = { 0, 0 }, thickness = 0.5e-3 }:with { rupture = { weft = { strength = 15e3, energy = 20 } } }
for _, method in ipairs { "trouser", "tongue" } do
  local first
  for _, h in ipairs { 4, 2, 1 } do
    local test = fabric.lab.tear { card = card, method = method, width = (method == "tongue" and 32 or 24) * mm, leg = 20 * mm, tear = 32 * mm, speed = 0.8, h = h * mm }
    first = first or test.mean
    checks(("%s, elements of %g mm: mean force, N"):format(method, h), test.mean, 10, { relative = h > 1 and 0.03 or 0.06 })
    checks(("%s, elements of %g mm: mean force as on 4 mm, N"):format(method, h), test.mean, first, { relative = 0.05 })
  end
end
checks()
