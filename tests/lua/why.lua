-- why(): the report is of what was measured in the step that failed, and what it says to try helps.
local fabric = require "fabric"

local function has(text, part) assert(text:find(part, 1, true), text .. "\nis without: " .. part) end
local function failing(a)
  local ok, e = pcall(a.solve, a)
  assert(not ok and e.kind == "numerical", tostring(e))
  assert(e.why == a:why() and fabric.why() == e.why)
  return e.why
end
local function strip(motion)
  local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 2, ny = 6 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
  return m:fix("bottom", "x y z rotation"):fix("top", "x"):move("top", { y = motion })
end

assert(fabric.why() == "no run has failed")
local flat = function() return strip(fabric.ramp(0.018, 1)):fix("all", "z rotation") end
assert(fabric.static { model = flat(), duration = 1 }:why() == "this run has not failed")

-- too few iterations: the residual is falling, and the setter helps
local a = fabric.static { model = flat(), duration = 1, step = 1, max_cuts = 0, max_iterations = 2 }
local text = failing(a)
has(text, "static: no step beyond time 0 s\ntried      a step of 1 s: too many iterations; residuals ")
has(text, "element    ")
has(text, "strain     E11 ")
has(text, "switches   warp ")
has(text, "elements   12 of 12 switch branches in the step, 0 are slack both ways")
has(text, "the residual is still falling")
has(text, "a support moves by 0.018 m in a step, an element is 0.0127 m")
assert(not text:find "negative pivots")
a:set { max_iterations = 50, max_cuts = 12, step = 0.05 }:solve()
assert(a.time == 1)

-- ... slowly at first, as with forces on cloth that stiffens
local loaded = fabric.model { mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 3, ny = 9 }, card = fabric.card "denim", warp = 90 }
loaded:fix("all", "z rotation"):fix("bottom", "x y"):force("top", { y = fabric.ramp(300, 1) })
a = fabric.static { model = loaded, duration = 1, step = 0.5, max_cuts = 0, max_iterations = 8 }
text = failing(a)
has(text, "(still falling)")
has(text, "more max_iterations, set{ max_iterations=20 } (the residual is still falling)")
a:set { max_iterations = 20 }:solve()
assert(a.time == 1)

-- a tolerance below what numbers can do
a = fabric.static { model = flat(), duration = 1, step = 0.1, max_cuts = 1, max_iterations = 2, tolerance = 1e-15 }
text = failing(a)
assert(select(2, text:gsub("\ntried", "")) == 2, text)

-- a sheet with nothing to hold it out of its plane
local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 2, ny = 2 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend" }
m:force("right", { x = fabric.ramp(1, 1) })
text = failing(fabric.static { model = m, duration = 1 })
has(text, "the tangent is singular")
has(text, 'fix("all", "z")')

-- loads that are there at time 0, on cloth with bending of its own or of its thickness: the first step is relaxed, and said so;
-- it ends where growing loads do
local function hangs(card, options, load)
  local hung = fabric.mesh.rectangle { width = 0.06, height = 0.01, nx = 12, ny = 1 }
  local model = fabric.model { mesh = hung, card = card, warp = 0 }:fix("left", "x y z rotation"):gravity { 0, 0, load or -9.81 }
  options.model, options.duration = model, 1
  local run = fabric.static(options):solve()
  return -run:node(hung:set("right")[1]).uz, run
end
local worsted = fabric.card "worsted"
local grown = hangs(worsted, {}, fabric.ramp(-9.81, 1))
local jumped, run = hangs(worsted, {})
assert(math.abs(jumped / grown - 1) < 2e-3 and run.time == 1, jumped / grown)
assert(math.abs(hangs(worsted, { method = "relaxation" }) / jumped - 1) < 1e-6)
local thick = fabric.card("blend", { bending = "thickness" })
assert(math.abs(hangs(thick, {}) / hangs(thick, {}, fabric.ramp(-9.81, 1)) - 1) < 2e-3)
-- ... where stabilising forces are asked for instead, why() names the jump and what takes it, and nothing else
local function stabilised() return fabric.static { model = (function()
  local held = fabric.model { mesh = fabric.mesh.rectangle { width = 0.06, height = 0.01, nx = 12, ny = 1 }, card = worsted, warp = 0 }
  return held:fix("left", "x y z rotation"):gravity { 0, 0, -9.81 }
end)(), duration = 1, stabilise = 1e-8, max_cuts = 2, max_iterations = 1 } end
text = failing(stabilised())
has(text, "jump       gravity (z = -9.81 m/s^2) is there in full at time 0")
has(text, 'try        loads that grow from 0, fabric.ramp(load, duration)') -- relaxation has been tried in this run
assert(not text:find("stabilise=true", 1, true) and not text:find("arc", 1, true), text)

-- ... and where a motion of a support stands beside the load, both are named; relaxation takes loads alone
local function jumping(gravity, motion)
  local held = fabric.model { mesh = fabric.mesh.rectangle { width = 0.06, height = 0.01, nx = 12, ny = 1 }, card = worsted, warp = 0 }
  held:fix("left", "x y z rotation"):move("right", { x = motion, z = fabric.ramp(0.03, 1) })
  if gravity then held:gravity { 0, 0, gravity } end
  return fabric.static { model = held, duration = 1, stabilise = 1e-8, max_cuts = 1, max_iterations = 1 }
end
text = failing(jumping(-9.81, -0.01))
has(text, "jump       gravity (z = -9.81 m/s^2) and the motion of 'right' (x = -0.01 m) are there in full at time 0")
has(text, "try        loads and motions that grow from 0, fabric.ramp(way, duration)")
assert(not text:find('method="relaxation", or loads', 1, true), text)
text = failing(jumping(nil, -0.01))
has(text, "jump       the motion of 'right' (x = -0.01 m) is there in full at time 0")
has(text, "try        motions that grow from 0")
-- ... as is what begins at once after time 0
text = failing(jumping(function(t) return t > 0 and -9.81 or 0 end, fabric.ramp(-0.01, 1)))
has(text, "jump       gravity (z = -9.81 m/s^2) is there in full at time 0")
assert(not text:find("the motion of", 1, true), text)
-- ... which is relaxed, too
local stepped = hangs(worsted, {}, function(t) return t > 0 and -9.81 or 0 end)
assert(math.abs(stepped / jumped - 1) < 1e-9, stepped / jumped)

-- strained far beyond the card
text = failing(fabric.static { model = strip(fabric.ramp(7, 1)), duration = 1, step = 0.5, max_cuts = 1, max_iterations = 1 })
has(text, "tested to ")
has(text, "card:check()")

-- in motion: an explicit run away from its step
local d = fabric.dynamic { model = strip(fabric.ramp(0.001, 1)):velocity("right", { z = 1e6 }), duration = 0.01 }
text = failing(d)
has(text, "dynamic: stopped at time 0 s")
has(text, "fastest    node ")
has(text, "\nrun        to 0.01 s, card ")

-- ... because its step is above the stable one: no larger limit is offered
local pulled = strip(fabric.ramp(0.001, 1e-3))
local stable = fabric.dynamic({ model = pulled, duration = 1e-3 }).stable_step
text = failing(fabric.dynamic { model = strip(fabric.ramp(0.001, 1e-3)), duration = 0.01, step = 3 * stable, force = true })
has(text, 'step="auto" (the step of ')
assert(not text:find("ledger_limit", 1, true), text)

-- yarns that turn onto each other, in a frame whose cloth does not lock: an element has no area left, on any mesh
do
  local MPa, side = fabric.units.MPa, 0.05
  local card = fabric.woven { name = "loose", density = 900, thickness = 0.3e-3, warp = { loading = { 300 * MPa }, unloading = 300 * MPa, poisson = 0 },
    weft = { loading = { 300 * MPa }, unloading = 300 * MPa, poisson = 0 }, shear = { loading = { 0.2 * MPa }, unloading = 0.2 * MPa, measure = "tensor" },
    bending = { warp = 1e-5, weft = 1e-5, twist = 1e-5 }, tested = { warp = 0.1, weft = 0.1, shear = 0.5 } }
  local x, y = {}, {}
  for i = 0, 20 do
    local angle = math.rad(95 * i / 20)
    x[#x + 1], y[#y + 1] = { i / 20, side * math.sin(angle) }, { i / 20, side * (math.cos(angle) - 1) }
  end
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = side, height = side, nx = 3, ny = 3 }, card = card }
  m:fix("all", "z rotation"):fix("bottom", "x y"):move("top", { x = fabric.history(x), y = fabric.history(y) })
  text = failing(fabric.static { model = m, duration = 1, step = 0.05, method = "newton" })
  has(text, "try        less stroke, or a card whose shear stiffens before its yarns meet, as cloth does (element ")
  has(text, " degrees, at 90 warp and weft lie on each other and an element has no area; a finer mesh does not help)")
  assert(tonumber(text:match "has come to (%d+) degrees") > 80)
end
