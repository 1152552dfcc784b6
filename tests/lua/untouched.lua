-- A body on its way to the cloth does no work before they touch: until then the ledger is watched as beside one that stands still,
-- and the run is the same.
local fabric = require "fabric"
local card = fabric.card("muslin", { bending = "estimated" })
local function flutters(speed)
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 6, ny = 6, triangles = true }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:velocity("all", function(x, y) return { x = 0.2, y = 0.4 * math.sin(30 * x), z = 0.5 * math.cos(40 * y) } end)
  local ball = fabric.rigid.sphere { radius = 0.02, centre = { 0.1, 0.1, 1 } }
  if speed > 0 then m:move(ball, { z = function(t) return -speed * t end }) end
  m:contact { between = { ball, "all" } }
  local a = fabric.dynamic { model = m, duration = 0.2, scheme = "implicit", step = 5e-3 }:solve()
  local first
  for _, w in ipairs(a.warnings) do if w.code == "ledger" then first = first or w.time end end
  return a, first
end
local still, told = flutters(0)
local driven, told_driven = flutters(0.1)
assert(told and told < 0.02, "the case has lost its errors")
fabric.expect {
  { "the ledger is told of at", told_driven or 1, told, absolute = 0 },
  { "steps", #driven.steps, #still.steps, absolute = 0 },
  { "kinetic energy", driven.energy.kinetic, still.energy.kinetic, relative = 1e-9 },
  { "damping", driven.energy.damping, still.energy.damping, relative = 1e-9 },
}
