-- Readings of a textile laboratory: nominal strain and stress, true stress, tensions, the share of what was tested; a run that
-- stops beyond it, and one that stops where a force is reached.
local fabric = require "fabric"

local function near(got, wanted, tolerance, what)
  assert(math.abs(got - wanted) <= (tolerance or 1e-10) * math.max(math.abs(wanted), 1e-30),
    ("%s: %.17g, wanted %.17g"):format(what or "value", got, wanted))
end
local function rectangle() return fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 } end
local mesh = rectangle()
local function strip(card, top, warp)
  return fabric.model { mesh = mesh, card = card, warp = warp or 90 }:fix("all", "z rotation"):fix("bottom", "y")
    :fix("left", "x"):move("top", { y = top })
end
local blend = fabric.card "blend"

-- Pulled along the warp, sides free but for one line: stretch s along it, k across.
local a = fabric.static { model = strip(blend, fabric.ramp(0.008, 1)), duration = 1 }:solve()
local e = a:element(2)
local s, k = math.sqrt(1 + 2 * e.E11), math.sqrt(1 + 2 * e.E22)
near(s, 1 + 0.008 / 0.0762, 1e-9, "stretch")
near(a:field "nominal_strain_warp"[2], s - 1)
near(a:field "nominal_strain_weft"[2], k - 1)
near(a:field "nominal_stress_warp"[2], e.S11 * s)
near(a:field "tension_warp"[2], e.S11 * s * blend.thickness)
near(a:field "cauchy_11"[2], e.S11 * s / k, 1e-9)
local _, fy = a:reaction "top"
near(a:field "nominal_stress_warp"[2] * 0.0254 * blend.thickness, fy, 1e-8, "force by the nominal stress")
near(a:field "cauchy_11"[2] * 0.0254 * k * blend.thickness, fy, 1e-8, "force by the true stress")

-- Simple shear of a linear card: closed form by pushing S forward.
local linear = fabric.svk { name = "linear", warp = 1e6, weft = 2e6, shear = 3e5, poisson = { 0.1, 0.2 }, density = 500, thickness = 1e-3 }
local g = 0.2
local mesh = rectangle()
local sheared = fabric.model { mesh = mesh, card = linear, warp = 0 }:fix("all", "y z rotation")
for row = 0, 3 do
  local y = row * 0.0254
  mesh:set("row " .. row, function(_, at) return math.abs(at - y) < 1e-9 end)
  sheared:move("row " .. row, { x = fabric.ramp(g * y, 1) })
end
local b = fabric.static { model = sheared, duration = 1 }:solve()
local v = b:element(2)
near(v.E12, g / 2, 1e-9, "E12")
near(v.E22, g * g / 2, 1e-9, "E22")
-- F = [1 g; 0 1], the warp stays along x.
near(b:field "cauchy_11"[2], v.S11 + 2 * g * v.S12 + g * g * v.S22, 1e-9, "cauchy_11")
near(b:field "cauchy_12"[2], v.S12 + g * v.S22, 1e-9, "cauchy_12")
near(b:field "cauchy_22"[2], v.S22, 1e-9, "cauchy_22")
near(b:field "shear_angle"[2], math.atan(g) * 180 / math.pi, 1e-9, "shear angle")
assert(b:field "beyond"[1] == 0) -- the card does not say what it was tested to

-- Beyond what was tested: by element, the part of the elements, and the run that stops there.
local far = fabric.ramp(0.03, 1)
local c = fabric.static { model = strip(fabric.card "denim", far), duration = 1, step = 0.05 }:solve()
assert(c.beyond and c.beyond.share > 1.5 and c.beyond.elements == 1)
near(math.max(table.unpack(c:field "beyond")), c.beyond.share, 1e-12)
local d = fabric.static { model = strip(fabric.card "denim", far), duration = 1, step = 0.05, limit = "stop" }:solve()
assert(d.time < c.time and d.beyond.share > 1.02 and d.beyond.share < c.beyond.share and d.stopped)
local at = d.time
near(d.beyond.share, 1.0202, 1.5e-4) -- 2 % are let pass, and the step ends right behind them
for _, step in ipairs { 1, 0.31 } do -- however long the steps
  local long = fabric.static { model = strip(fabric.card "denim", far), duration = 1, step = step, limit = "stop" }:solve()
  near(long.beyond.share, 1.0202, 1.5e-4)
  near(long.time, at, 1e-3)
end
d:solve() -- asked for again, it goes on
assert(d.time == 1 and at < 1)
local moving = fabric.dynamic { model = strip(fabric.card "denim", fabric.ramp(0.03, 0.01)), duration = 0.01, limit = "stop" }
moving:solve()
assert(moving.time < 0.01 and moving.beyond.share > 1.02 and moving.beyond.share < 1.021)
local slow = fabric.dynamic { model = strip(fabric.card "denim", fabric.ramp(0.03, 0.01)), duration = 0.01, scheme = "implicit", step = 2e-3, limit = "stop" }:solve()
near(slow.beyond.share, 1.0202, 1.5e-4)
near(slow.time, moving.time, 2e-2)

-- Until a force is reached, on the way up and again on the way down.
local up_and_down = fabric.history { { 0, 0 }, { 1, 0.008 }, { 2, 0.001 } }
local f = fabric.static { model = strip(blend, up_and_down), duration = 2, step = 0.1 }
local function force(run) return (select(2, run:reaction "top")) end
f:reach(force, 10)
near(force(f), 10, 1e-5)
assert(f.time < 1)
local first = f.time
f:advance(1)
f:reach(force, 10)
near(force(f), 10, 1e-5)
assert(f.time > 1 and f.time > first)
f:reach("nominal_strain_warp", 0.02)
near(f:mean "nominal_strain_warp", 0.02, 1e-5)
local good, why = pcall(function() f:reach(force, 1e6) end)
assert(not good and tostring(why):find("reach: the value did not reach 1e+06", 1, true), tostring(why))
assert(f.time == 2)
