-- Runs in motion: gravity, explicit and implicit, damping, events, snapshots, the ledger.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = dofile((arg[0]:gsub("[^/]*$", "card.lua"))):with{ bending={ warp=15e-6, weft=15e-6, twist=7e-6 } }
local mesh = fabric.mesh.rectangle{ width=60*mm, height=10*mm, nx=6, ny=1 }
local function swing(options)
  local model = fabric.model{ mesh=mesh, card=card, warp=0 }
  model:fix("left", "x y z rotation"):gravity{ 0, 0, fabric.ramp(-9.81, 0.05) }
  options.model, options.duration = model, 0.1
  return fabric.dynamic(options)
end
local run = swing{ damping={ mass=5 } }
local passed
run:event{ value=function(a) return a:node(7).uz + 5*mm end, action=function(a) passed = a.time end }
run:advance(0.05)
local kept = run:snapshot()
run:solve()
local tip = run:node(7).uz
run:restore(kept):solve()
local slow = swing{ scheme="implicit", step=1e-3, damping={ mass=5 } }:solve()
if fabric.checking() then return end
fabric.expect{
  { "tip, m", tip, -0.031510771, relative=1e-6 },
  { "the same from the snapshot, m", run:node(7).uz, tip, absolute=0 },
  { "implicit against explicit, m", slow:node(7).uz, tip, relative=2e-2 },
  { "5 mm down at, s", passed, 0.0546235801, relative=1e-6 },
  { "ledger", run.energy.error, 0, absolute=1e-3 },
}
