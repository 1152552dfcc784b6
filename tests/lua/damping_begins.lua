-- A sheet that falls about its middle folds so fast that average acceleration makes energy: steps damp from there on, unless the deck
-- has chosen a scheme; the choice belongs to the state of the run.
local fabric = require "fabric"
local function falls(options)
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 8, ny = 8 }
  mesh:set("middle", function(x, y) return math.abs(x - 0.1) < 1e-6 and math.abs(y - 0.1) < 1e-6 end)
  local card = fabric.card("muslin", { bending = "estimated" })
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  m:gravity { 0, 0, -9.81 }:fix("middle", "x y z rotation")
  return fabric.dynamic { model = m, duration = 0.2, scheme = "implicit", step = 2e-3, hht = options.hht, gamma = options.gamma }
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
assert(run.energy.error < kept.energy.error / 2 and kept.energy.error > 1e-2)
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

-- A stiff strip that plates press into a fold has axial vibrations far faster than the steps. Average acceleration would make energy within a few
-- steps: the step that does is repeated with strong damping, or, in the coarsest ones, in parts, and the elastica comes out, F D^2/B = 2.8711 per width.
local mm = fabric.units.mm
local B, width, t, half, D, T = 1e-5, 1 * mm, 0.3 * mm, 14 * mm, 10 * mm, 0.4
local function fold(step, triangles, hht)
  local strip = fabric.svk { young = 50e6, poisson = 0, density = 500, thickness = t, name = "strip", bending = { warp = B, weft = B, twist = B / 2 } }
  local mesh = fabric.mesh.rectangle { width = width, height = 2 * half, nx = 1, ny = 40, triangles = triangles }
  mesh:map(function(x, y) return 0.1 * mm * (1 - (y / half - 1) ^ 2), x, y - half end)
  mesh:set("middle", function(_, _, z) return math.abs(z) < 1e-9 end)
  local m = fabric.model { mesh = mesh, card = strip, warp = { 0, 0, 1 } }
  m:fix("middle", "x y z rotation"):fix("all", "y")
  local from, plates = half + t / 2 - 1e-7, {}
  for k, side in ipairs { 1, -1 } do
    plates[k] = fabric.rigid.plane { point = { 0, 0, side * from }, normal = { 0, 0, -side } }
    m:contact { between = { plates[k], "all" } }:move(plates[k], { z = fabric.ramp(-side * (half - D / 2), T) })
  end
  return fabric.dynamic { model = m, duration = T, scheme = "implicit", step = step, damping = { mass = 60 }, hht = hht }, plates[1]
end
local function words_of(run, words)
  for _, w in ipairs(run.warnings) do
    if w.code == "ledger" and w.text:find(words, 1, true) then return w end
  end
end
for _, case in ipairs { { 4e-3 }, { 2e-3, true }, { 1e-3 } } do
  local folds, plate = fold(case[1], case[2])
  folds:solve()
  local low, high = math.huge, -math.huge
  for _, z in ipairs(folds:field "z") do low, high = math.min(low, z), math.max(high, z) end
  local ratio = math.abs((select(3, folds:reaction(plate)))) / width * (high - low) ^ 2 / B / 2.8711
  print(("fold, step %g: force over the elastica's %.4f, ledger %.1e"):format(case[1], ratio, folds.energy.error))
  assert(math.abs(ratio - 1) < 0.015, ratio)
  -- In the coarsest steps it is that of the first, in which the plates set off: five sixths of the work so far.
  assert(folds.energy.error < (case[1] > 2e-3 and 2e-2 or 1e-2), folds.energy.error)
  assert(case[1] > 2e-3 or (words_of(folds, "would have made") and words_of(folds, "gamma=1")))
end

-- From a snapshot before the repeated step the bits are the same.
do
  local folds = fold(1e-3)
  folds:advance(0)
  local start = folds:snapshot()
  folds:advance(0.02)
  local x, lost = folds:node(2).x, folds.energy.damping
  folds:restore(start)
  assert(not words_of(folds, "would have made"))
  folds:advance(0.02)
  assert(folds:node(2).x == x and folds.energy.damping == lost)
end

-- Neither a scheme of the deck's own, nor a support that begins to move with a jump, whose first work the ledger does not know well.
do
  local own = fold(1e-3, false, 0)
  own:advance(5e-3)
  assert(not words_of(own, "would have made"))
  for _, triangles in ipairs { false, true } do
    local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.05, nx = 8, ny = 4, triangles = triangles }
    local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), points = 1, warp = 0 }
    m:fix("left", "x y z"):fix("right", "y z"):move("right", { x = fabric.ramp(3e-3, 0.1) })
    local pulled = fabric.dynamic { model = m, duration = 0.1, scheme = "implicit", step = 1e-3 }
    pulled:solve()
    -- The two steps behind the jump take what its wave has (tests/lua/corners.lua).
    assert(pulled.energy.error < 1e-4 and pulled.energy.damping < 2e-4 * pulled.energy.external)
  end
end

-- A driven run is young for a tenth of its duration, however few its steps: those behind that are shortened for their error, and the run need not
-- stop as it comes of age. (A strip that yarns let go and reload, 80 steps.)
local strip = fabric.mesh.rectangle { width = 0.03, height = 0.06, nx = 3, ny = 6 }
local cycles = fabric.model { mesh = strip, card = fabric.card("denim", { bending = "estimated" }), warp = 90 }
local way = 3.6e-3
cycles:fix("bottom", "x y z rotation"):fix("top", "x z rotation")
cycles:move("top", { y = fabric.history { { 0, 0 }, { 0.1, way }, { 0.16, 0.2 * way }, { 0.24, 1.4 * way }, { 0.32, 0.1 * way }, { 0.4, 1.2 * way } } })
local driven = fabric.dynamic { model = cycles, duration = 0.4, scheme = "implicit", step = 5e-3, damping = { mass = 60 } }:solve()
assert(driven.time == 0.4 and driven.energy.error < 0.02, driven.energy.error)

-- Two sheets fall on a floor, a soft one below a stiff one. The energy that alpha loses of the stiff one is not in its own sum: where a hundredth is
-- missing, the loss is all that is missing.
local function sheet(nx, ny, turn, tilt, z0)
  local cell, c, s, up, along = 9e-3, math.cos(turn), math.sin(turn), math.sin(tilt), math.cos(tilt)
  local mesh = fabric.mesh.rectangle { width = nx * cell, height = ny * cell, nx = nx, ny = ny, origin = { -nx * cell / 2, -ny * cell / 2, 0 } }
  mesh:map(function(x, y) return x * c - y * s * along, x * s + y * c * along, z0 + y * up end)
  return { mesh = mesh, warp = { c, s, 0 } }
end
local bodies = { sheet(5, 5, 0.4, 0.25, 7e-3), sheet(7, 4, -2.2733, -0.5632, 22e-3) }
for i, young in ipairs { 1.4e6, 3.11556e7 } do
  bodies[i].name = "sheet" .. i
  bodies[i].card = fabric.svk { young = young, poisson = 0.25, density = 480, thickness = i == 1 and 0.46e-3 or 0.57e-3, bending = { warp = 1e-5, weft = 5e-6, twist = 2e-6 } }
end
local pile = fabric.model { bodies = bodies }
pile:contact { self = "all", friction = 0.18 }
pile:contact { between = { fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }, "all" }, friction = 0.18 }
pile:velocity("sheet1.all", function() return { x = 0.2, y = 0, z = -0.4 } end)
pile:velocity("sheet2.all", function() return { x = -0.3, y = 0.2, z = -1.2 } end):gravity { 0, 0, -9.81 }
local falling = fabric.dynamic { model = pile, duration = 0.05, scheme = "implicit", step = 1e-3 }:solve()
assert(falling.energy.error < 0.02, falling.energy.error) -- 3.6 % with alpha to the end
