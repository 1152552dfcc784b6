-- A hook at every step only looks: steps that contact has shortened grow again as without it.
local fabric = require "fabric"

local function steps(hook)
  local mesh = fabric.mesh.rectangle { width = 0.04, height = 0.02, nx = 8, ny = 4, origin = { -0.02, -0.01 } }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), warp = 0 }
  local ball = fabric.rigid.sphere { radius = 0.005, centre = { 0, 0, 0.006 }, mass = 0.005 }
  local floor = fabric.rigid.plane { point = { 0, 0, -0.001 }, normal = { 0, 0, 1 }, name = "floor" }
  m:contact { between = { ball, "all" }, friction = 0.3 }:contact { between = { floor, "all" }, friction = 0.3 }
  m:velocity(ball, { z = -1 })
  local a = fabric.dynamic { model = m, duration = 0.004, damping = { mass = 20 } }
  if hook then a:every("step", function() end) end
  a:solve()
  return #a.steps, a.duration / a.step_size
end

local alone, planned = steps(false)
local hooked = steps(true)
assert(alone > 1.02 * planned, "an impact shortens steps")
assert(math.abs(hooked - alone) < 0.2 * alone)
