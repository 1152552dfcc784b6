-- A strip with a tearable zone is pulled until it has parted: the break costs the energy of the card times the width, on any mesh.
local fabric = require "fabric"
local mm = fabric.units.mm
local width, energy = 20 * mm, 4
local card = fabric.svk { young = 1e8, poisson = 0, density = 500, thickness = 0.5 * mm }:with { rupture = { weft = { strength = 2e3, energy = energy } } }

for _, cells in ipairs { 2, 4 } do
  local mesh = fabric.mesh.rectangle { width = width, height = 20 * mm, nx = cells, ny = 2 * cells }
  local m = fabric.model { mesh = mesh, card = card }
  m:fix("all", "x z rotation"):fix("bottom", "y"):move("top", { y = fabric.ramp(6 * mm, 0.1) })
  m:tearable("all", { coarse = "keep" })
  local a = fabric.dynamic { model = m, duration = 0.1, damping = { mass = 2000 }, ledger_limit = 1 }
  a:solve()
  fabric.expect {
    { cells .. " cells: energy", a.energy.fracture, energy * width, relative = 1e-3 },
    { cells .. " cells: energy balance", a.energy.error, 0, absolute = 1e-2 },
  }
end
