-- A rigid body that presses a sheet and leaves it in the steps of a chain: as one run along the whole history.
-- warns: results are too stiff
local fabric = require "fabric"
local checks = {}
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local deep, back = -2.2e-3, -1.9e-3
local card = fabric.card("muslin", { bending = "estimated" })

for _, tri in ipairs { false, true } do
  local function pressed()
    local mesh = fabric.mesh.rectangle { width = 0.05, height = 0.04, nx = 5, ny = 4, triangles = tri }
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("boundary", "x y z")
    local ball = fabric.rigid.sphere { radius = 0.008, centre = { 0.024, 0.021, 0.008 + card.thickness / 2 + 2e-5 } }
    return m:contact { between = { ball, "all" }, friction = 0, stiffness = 8e8 }, ball
  end
  local m, ball = pressed()
  local function to(from, z)
    return function(model, begins) model:move(ball, { z = fabric.history { { 0, 0 }, { begins + 1e-9, from }, { begins + 1, z } } }) end
  end
  local chain = fabric.lab.chain { model = m, steps = {
    { name = "in", duration = 1, loads = to(0, deep), options = { step = 0.125 } },
    { name = "out", duration = 1, loads = to(deep, back), options = { step = 0.125 } } },
    columns = { force = function(a) return (select(3, a:reaction(ball))) end } }
  local whole, punch = pressed()
  whole:move(punch, { z = fabric.history { { 0, 0 }, { 1, deep }, { 2, back } } })
  local one = fabric.static { model = whole, duration = 2, step = 0.125 }
  for i, row in ipairs(chain.rows) do
    one:advance(i)
    local of = (" after step %d%s"):format(i, tri and ", triangles" or "")
    checks[#checks + 1] = { "force" .. of, row.force, (select(3, one:reaction(punch))), absolute = 1e-6 }
    checks[#checks + 1] = { "stored" .. of, row.stored, one.energy.stored, relative = 1e-6 }
    checks[#checks + 1] = { "dissipated" .. of, row.dissipated, one.energy.dissipated, relative = 1e-6 }
  end
  -- A history that begins where the body is at that time, on a copy without the motion before.
  local start, ram = pressed()
  start:move(ram, { z = fabric.ramp(deep, 1) })
  local first = fabric.static { model = start, duration = 1, step = 0.125 }:solve()
  local out = start:copy { without = "move sphere" }:move(ram, { z = fabric.history { { 1, deep }, { 2, back } } })
  local second = fabric.static { from = first, model = out, duration = 1, step = 0.125 }:solve()
  checks[#checks + 1] = { "force, from where it is", (select(3, second:reaction(ram))), (select(3, one:reaction(punch))), absolute = 1e-6 }
  checks[#checks + 1] = { "stored, from where it is", second.energy.stored, one.energy.stored, relative = 1e-6 }
  -- A body that would be in the cloth of the state is refused all the same.
  local deeper = start:copy { without = "move sphere" }:move(ram, { z = fabric.history { { 1, 2 * deep }, { 2, back } } })
  check.fails("overlap", function() fabric.static { from = first, model = deeper, duration = 1 } end)
end
fabric.expect(checks)
