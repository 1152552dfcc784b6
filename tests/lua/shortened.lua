-- A step of implicit motion in which the ledger goes off is repeated at half its size. A clamped square of muslin, flat at first, snaps taut within the first
-- steps of its pressure; what comes to rest is the static shape, though the steps that the deck gives are far too long for the way there.
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local near, highest = check.near, check.highest

local function square(triangles, ramp)
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 6, ny = 6, triangles = triangles }, card = fabric.card("muslin", { bending = "estimated" }), warp = 0 }
  return m:fix("boundary", "x y z"):pressure(fabric.ramp(100, ramp))
end

for _, triangles in ipairs { false, true } do
  local static = fabric.static { model = square(triangles, 1), duration = 1, step = 0.25 }
  static:solve()
  for _, step in ipairs { 5e-3, 4e-3, 2e-3 } do
    local a = fabric.dynamic { model = square(triangles, 0.1), duration = 0.2, scheme = "implicit", step = step, damping = { mass = 100 } }
    a:advance(0.008)
    local before = a:snapshot()
    a:solve()
    local height, steps = highest(a), #a.steps
    near(height, highest(static), 0.03, "height")
    assert(a.energy.error < 5e-3, a.energy.error)
    assert(steps < 1.6 * 0.2 / step, steps)
    a:restore(before)
    a:solve()
    assert(highest(a) == height and #a.steps == steps)
    print(("%s, steps of %g ms: %.5g of the static height in %d steps, ledger %.1e"):format(triangles and "triangles" or "quadrilaterals", 1e3 * step, height / highest(static), steps, a.energy.error))
  end
end

-- A support that goes its whole way within one step of a short run: the force on it is far from a line in the strain of muslin, and the trapezoidal rule of
-- one step misses its work by half. Where it sets off smoothly, halves of the step tell it; where with a jump, what the cloth takes up does. Dense steps
-- give 1.64 J.
for _, smooth in ipairs { false, true } do
  local function pulled(steps)
    local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.09, nx = 3, ny = 9 }
    local m = fabric.model { mesh = mesh, card = fabric.card("muslin", { bending = "estimated" }), warp = 90 }
    m:fix("bottom", "x y z"):fix("top", "x z"):move("top", { y = smooth and function(t) return 0.004 * (1 - math.cos(math.pi * math.min(1, t / 0.01))) end or fabric.history { { 0, 0 }, { 0.01, 0.008 }, { 0.1, 0.008 } } })
    return fabric.dynamic { model = m, duration = 0.1, scheme = "implicit", step = 0.1 / steps }:solve()
  end
  local dense = pulled(400)
  for _, steps in ipairs { 5, 10 } do
    local a = pulled(steps)
    near(a.energy.external, dense.energy.external, 0.06, "work of a support") -- the ledger says 4.9 %
    assert(a.energy.error < 0.05, a.energy.error)
    print((smooth and "smoothly, " or "") .. ("the whole way in a step, %d steps planned: work %.4f J (%.4f), ledger %.1e, %d steps"):format(steps, a.energy.external, dense.energy.external, a.energy.error, #a.steps))
  end
end
