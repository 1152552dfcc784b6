-- Explicit steps with gamma above 1/2 are stable up to sqrt(2 / gamma) over the highest frequency: the chosen step, and the
-- largest that is accepted, know it.
local fabric = require "fabric"

local function swung(gamma, share)
  local mesh = fabric.mesh.rectangle { width = 0.16, height = 0.08, nx = 16, ny = 8 }
  local card = fabric.svk { young = 2e6, poisson = 0.3, density = 500, thickness = 4e-4, bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("left", "x y z"):velocity("all", function(x, y)
    return { x = 0.1 * math.sin(20 * x) + 0.05 * math.sin(200 * x * y), y = 0.05 * math.cos(150 * x + 30 * y), z = 0.1 * math.sin(90 * x - 40 * y) }
  end)
  local a = fabric.dynamic { model = m, duration = 0.03, gamma = gamma }
  return share and fabric.dynamic { model = m, duration = 0.03, gamma = gamma, step = share * a.stable_step } or a
end

local usual = swung(0.5)
for _, gamma in ipairs { 0.75, 1 } do
  local a, largest = swung(gamma), swung(gamma, 0.999)
  assert(math.abs(a.step_size / usual.step_size * math.sqrt(2 * gamma) - 1) < 1e-9)
  for _, run in ipairs { a, largest } do
    local first
    run:every("step", function(now) first = first or now.energy.kinetic end)
    run:solve()
    assert(run.energy.kinetic < first and run.energy.damping > 0 and run.energy.error < 1e-2)
  end
end
