-- m:centrifuge against a stiff sheet on a hinge, which turns about the vertical through the hinge: at the angle t from below it has
-- V(t) = -w^2/2 (J sin^2 t + L b sin t cos t) + g (b sin t - L/2 cos t) per unit of mass, where J = L^2/3 (1 + 1/(2 n^2)) with
-- masses at n + 1 rows of nodes, and b is how far the mass lies off the hinge. At rest V' = 0; swings about that have the frequency
-- V''; a sheet let go turns where V is the same again. Coriolis forces lie along the hinge and do nothing.
local wrong = ... -- of tests/lua/errors.lua, which reads what follows
if wrong then
  wrong("model:centrifuge", "model:centrifuge{ axis={0, 0, 1} }",
    "deck.lua:1: centrifuge: field 'speed': expected a number in degrees/s or a function or a history, got nil (missing, or a misspelt variable)")
  wrong("model:centrifuge", "model:centrifuge{ speed='fast', axis={0, 0, 1} }",
    "deck.lua:1: centrifuge: field 'speed': expected a number in degrees/s or a function or a history, got 'fast'")
  wrong("model:centrifuge", "model:centrifuge{ speed=360, axis=1 }",
    "deck.lua:1: centrifuge: field 'axis': expected a table of numbers, got 1")
  wrong("model:centrifuge", "model:centrifuge{ speed=360, axis={0, 0, 0} }",
    "deck.lua:1: centrifuge: field 'axis': expected a direction {x, y, z}")
  wrong("model:centrifuge", "model:centrifuge{ speed=360, axis={0, 0, 1}, set=7 }",
    "deck.lua:1: centrifuge: field 'set': expected a string, got 7")
  wrong("model:centrifuge", "model:centrifuge{ speed=360, axis={0, 0, 1}, center={0, 0, 0} }",
    "deck.lua:1: centrifuge: unknown field 'center', did you mean 'centre'?")
  return
end
local fabric = require "fabric"
local pi, g, L, W, n, thick = math.pi, 9.81, 0.2, 0.05, 8, 0.01
local w = math.sqrt(3 * g / L) -- rests near 60 degrees
local card = fabric.linear { warp = 1.6e8, weft = 1.6e8, shear = 0.8e8, poisson = { 0, 0 }, density = 40, thickness = thick }

-- At the angle t, degrees.
local function sheet(t, triangles, offset)
  local s, c = math.sin(math.rad(t)), math.cos(math.rad(t))
  local nodes, elements = {}, {}
  for i = 0, n do
    for j = 0, 1 do nodes[#nodes + 1] = { 1 + i / n * L * s, j * W, -i / n * L * c } end
    local a = 2 * i - 1
    if i > 0 and triangles then elements[#elements + 1], elements[#elements + 2] = { a, a + 2, a + 3 }, { a, a + 3, a + 1 } end
    if i > 0 and not triangles then elements[#elements + 1] = { a, a + 2, a + 3, a + 1 } end
  end
  local mesh = fabric.mesh { nodes = nodes, elements = elements }
  mesh:set("hinge", { 1, 2 })
  local m = fabric.model { mesh = mesh, card = card, warp = { s, 0, -c }, offset = offset }
  return m:fix("hinge", "x y z"):gravity { 0, 0, -g }:centrifuge { speed = math.deg(w), axis = { 0, 0, 2 }, centre = { 1, W / 2, 7 } }
end
local function angle(a)
  local tip = a:node(2 * n + 1)
  return math.deg(math.atan(tip.x - 1, -tip.z))
end

local J = L ^ 2 / 3 * (1 + 1 / (2 * n ^ 2))
local function V(t, b)
  local s, c = math.sin(math.rad(t)), math.cos(math.rad(t))
  return -w ^ 2 / 2 * (J * s ^ 2 + L * b * s * c) + g * (b * s - L / 2 * c)
end
local function slope(t, b) return (V(t + 1e-3, b) - V(t - 1e-3, b)) / math.rad(2e-3) end
local function zero(f, low, high)
  for _ = 1, 60 do
    local mid = (low + high) / 2
    if f(mid) * f(low) > 0 then low = mid else high = mid end
  end
  return low
end

local checks = {}
for _, triangles in ipairs { false, true } do
  local of = triangles and ", triangles" or ", quadrilaterals"
  for _, offset in ipairs { 0, 1 } do
    local b = -offset * thick / 2
    local rests = zero(function(t) return slope(t, b) end, 30, 85)
    local a = fabric.static { model = sheet(rests - 4, triangles, offset), duration = 1, step = 1 }:solve()
    local stiffness = (slope(rests + 0.01, b) - slope(rests - 0.01, b)) / math.rad(0.02)
    checks[#checks + 1] = { "rests" .. of .. ", offset " .. offset, angle(a), rests, absolute = 1e-3 } -- it bends by so much
    checks[#checks + 1] = { "swings" .. of .. ", offset " .. offset, fabric.modes { from = a, count = 1 }[1].frequency, math.sqrt(stiffness / J) / 2 / pi, relative = 1e-5 }
  end
  for _, scheme in ipairs { "explicit", "implicit" } do
    local a = fabric.dynamic { model = sheet(35, triangles, 0), duration = 0.4, scheme = scheme, step = scheme == "implicit" and 1e-3 or nil }
    local most = 0
    while a.time < 0.4 do
      a:advance(a.time + 2e-3)
      most = math.max(most, angle(a))
    end
    checks[#checks + 1] = { "turns, " .. scheme .. of, most, zero(function(t) return V(t, 0) - V(35, 0) end, 65, 89.9), absolute = 2e-3 }
    checks[#checks + 1] = { "ledger, " .. scheme .. of, a.energy.error, 0, absolute = 1e-5 }
  end
end
fabric.expect(checks)
