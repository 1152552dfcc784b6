-- A driven implicit run of fewer than 50 steps is told of an error of its ledger above 1e-3 of the work, too, at its end.
local fabric = require "fabric"
local card = fabric.card("denim", { bending = "estimated" })
local high = card.thickness / 2 - 1e-7

-- A sheet on another on a plane that starts to go: the errors are those of yarns that switch as the sheets begin to slide.
local function stack(options)
  local function sheet(x, y, z) return fabric.mesh.rectangle { width = 0.04, height = 0.03, nx = 4, ny = 3, origin = { x, y, z } } end
  local m = fabric.model { bodies = { { name = "a", mesh = sheet(0, -0.015, high), card = card, warp = 0 },
    { name = "b", mesh = sheet(1.3e-3, -0.0143, 3 * high), card = card, warp = 0 } } }
  local plane = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:gravity { 0, 0, -9.81 }:contact { between = { plane, "a.all" }, friction = 0.3 }:contact { between = { "a", "b" }, friction = 0.2 }
  m:move(plane, { x = function(t) return 4 * t * t end })
  local o = { model = m, duration = 0.2, scheme = "implicit" }
  for key, value in pairs(options) do o[key] = value end
  local a = fabric.dynamic(o):solve()
  local told = 0
  for _, w in ipairs(a.warnings) do
    if w.code == "ledger" then
      told = told + 1
      assert(w.time == a.time and not w.text:find "from here on", w.text)
    end
  end
  assert(#a.steps < 60)
  return a.energy.error, told
end
local over, under = 0, 0
for _, options in ipairs { { step = 5e-3 }, { step = 1e-2 }, { step = 1e-2, error = 1e-4 }, { step = 5e-3, slow = true } } do
  local error, told = stack(options)
  if error > 1e-3 then over = over + 1 else under = under + 1 end
  assert(told == (error > 1e-3 and 1 or 0), ("error %g, told %d times"):format(error, told))
end
fabric.expect { { "runs with an error above 1e-3, at least 2", math.min(over, 2), 2, absolute = 0 }, { "with less, at least 1", math.min(under, 1), 1, absolute = 0 } }
