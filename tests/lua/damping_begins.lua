-- A sheet that falls about its middle folds so fast that average acceleration makes energy: steps damp from there on, unless the deck
-- has chosen a scheme; the choice belongs to the state of the run.
local fabric = require "fabric"
local function falls(options)
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 6, ny = 6 }
  mesh:set("middle", function(x, y) return math.abs(x - 0.1) < 1e-6 and math.abs(y - 0.1) < 1e-6 end)
  local card = fabric.card("muslin", { bending = "estimated" })
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  m:gravity { 0, 0, -9.81 }:fix("middle", "x y z rotation")
  return fabric.dynamic { model = m, duration = 0.2, scheme = "implicit", step = 2e-3, damping = { mass = 5 }, hht = options.hht, gamma = options.gamma }
end
local function begins(run)
  for _, w in ipairs(run.warnings) do
    if w.text:find "high frequencies are damped" then return w.time end
  end
end

-- Energy in the numbers of the steps that damp: what they take is in the ledger, which closes better than without.
local run, kept = falls {}, falls { hht = 0 }
run:advance(0.04)
assert(not begins(run))
local before = run:snapshot()
run:solve()
kept:solve()
local since = begins(run)
assert(since and since > 0.04 and not begins(kept))
assert(run.energy.error < 5e-3 and kept.energy.error > 1e-2)
assert(run.energy.damping > kept.energy.damping)

-- Back before it, and over it again: the same bits; `before` has the steps that do not damp.
local z, lost = run:node(1).z, run.energy.damping
run:restore(before)
assert(not begins(run))
run:solve()
assert(begins(run) == since and run:node(1).z == z and run.energy.damping == lost)

-- A scheme of the deck's own choice stays.
for _, options in ipairs { { gamma = 0.55 }, { hht = -0.05 } } do
  local own = falls(options)
  own:advance(0.12)
  assert(not begins(own))
end
