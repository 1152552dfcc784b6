-- Steady swings under a base or a force that shakes against closed forms with a complex stiffness: one mode, a taut strip, a cantilever;
-- quadrilaterals and triangles, reciprocity, and what is said where modes are missing.
-- warns: the modes that are taken, 1, have 64 % of the mass that moves with the supports
-- warns: the lower half of the modes that are taken, 3, gives 65 % of the deflection under the force at rest
-- warns: the last of the modes that are taken, 3, swings at
-- warns: the last of the modes that are taken, 1, swings at
local fabric = require "fabric"
local pi = math.pi
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end

-- Complex numbers as far as they are needed.
local function times(a, b) return { a[1] * b[1] - a[2] * b[2], a[1] * b[2] + a[2] * b[1] } end
local function over(a, b)
  local size = b[1] ^ 2 + b[2] ^ 2
  return { (a[1] * b[1] + a[2] * b[2]) / size, (a[2] * b[1] - a[1] * b[2]) / size }
end
local function power(a, p)
  local r, angle = (a[1] ^ 2 + a[2] ^ 2) ^ (p / 2), p * math.atan(a[2], a[1])
  return { r * math.cos(angle), r * math.sin(angle) }
end
local function cosh(x) return (math.exp(x) + math.exp(-x)) / 2 end
local function sinh(x) return (math.exp(x) - math.exp(-x)) / 2 end
local function cos(a) return { math.cos(a[1]) * cosh(a[2]), -math.sin(a[1]) * sinh(a[2]) } end
local function sin(a) return { math.sin(a[1]) * cosh(a[2]), math.cos(a[1]) * sinh(a[2]) } end
local function size(a) return math.sqrt(a[1] ^ 2 + a[2] ^ 2) end
local function degrees(a) return 180 / pi * math.atan(a[2], a[1]) end

-- The row of a curve at the frequency nearest to one.
local function at(r, f)
  local best = r.curve[1]
  for _, row in ipairs(r.curve) do if math.abs(row.frequency - f) < math.abs(best.frequency - f) then best = row end end
  return best
end

-- One node that can move, along z alone: one mode, with 1 / damping at resonance.
do
  local card = fabric.svk { density = 640, thickness = 0.3e-3, warp = 20e6, weft = 12e6, shear = 4e6, poisson = 0 }
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.07, nx = 2, ny = 2 }
  mesh:set("middle", function(x, y) return math.abs(x - 0.05) < 1e-9 and math.abs(y - 0.035) < 1e-9 end)
  local n = mesh:set "middle"[1]
  local m = fabric.model { mesh = mesh, card = card, warp = 0, membrane = true, prestress = { warp = 300, weft = 200 } }
  m:fix("boundary", "x y z"):fix("middle", "x y")
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local f0 = fabric.modes { from = run, count = 1 }[1].frequency
  for _, eta in ipairs { 0.02, 0.3 } do
    local r = fabric.lab.frequency_response { from = run, base = { z = 2e-5 }, damping = eta, node = n, lowest = f0 / 3, highest = 3 * f0, points = 9, count = 2 }
    local e = run:element(1) -- the stress-free shape is smaller
    check("the mass of one node", r.modes.mass.z, 640 * 0.3e-3 * 0.1 * 0.07 / 4 / math.sqrt((1 + 2 * e.E11) * (1 + 2 * e.E22)), 1e-9)
    check("all of it", r.covered, 1, 1e-9)
    check("at resonance", at(r, f0).relative, 2e-5 / eta, 1e-9)
    local half = at(r, f0 * math.sqrt(1 + eta)) -- where the stiffness and the inertia differ by the damping
    check("half the power", half.relative, 2e-5 / eta * (1 + eta) / math.sqrt(2), 1e-9)
    local low = r.curve[1]
    local q = over({ 1, eta }, { 1 - 1 / 9, eta })
    check("below resonance", low.amplitude, 2e-5 * size(q), 1e-9)
    check("its phase", low.phase, degrees(q), 1e-9)
    local pushed = fabric.lab.frequency_response { from = run, force = { set = n, z = 3e-3 }, damping = eta, node = n, lowest = f0 / 3, highest = 3 * f0, points = 9, count = 2 }
    local mass = pushed.modes[1].own_mass
    check("by a force", at(pushed, f0).amplitude, 3e-3 / (mass * eta * (2 * pi * f0) ^ 2), 1e-9)
    check("a quarter behind", at(pushed, f0).phase, -90, 1e-9)
  end
end

-- A taut strip between two supports: w / base = 1 / cos(k L / 2) and w / F = tan(k L / 2) / (2 T k) in the middle, T (1 + i eta).
for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  local L, b, h, eta = 0.24, 0.03, 0.2e-3, 0.06
  local card = fabric.svk { density = 750, thickness = h, warp = 40e6, weft = 40e6, shear = 10e6, poisson = 0 }
  local mesh = fabric.mesh.rectangle { width = L, height = b, nx = 40, ny = 2, triangles = tri }
  mesh:set("middle", function(x) return math.abs(x - L / 2) < 1e-9 end)
  mesh:set("inside", function(x) return x > 1e-9 and x < L - 1e-9 end)
  local m = fabric.model { mesh = mesh, card = card, warp = 0, membrane = true, prestress = { warp = 240 } }
  m:fix("left", "x y z"):fix("right", "x y z"):fix("inside", "x y")
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local E = run:element(5).E11
  local T, mu = 240 * b, 750 * h * b / math.sqrt(1 + 2 * E)
  local n = mesh:set "middle"[2]
  local first = math.sqrt(T / mu) / (2 * L)
  local function response(load)
    local t = { from = run, damping = eta, node = n, lowest = 0.2 * first, highest = 3.7 * first, points = 61, count = 60 }
    for k, v in pairs(load) do t[k] = v end
    return fabric.lab.frequency_response(t)
  end
  local shaken = response { base = { z = 1e-4 } }
  assert(shaken.covered > 0.97, shaken.covered)
  for _, part in ipairs { 0.5, 1, 1.04, 1.7, 3, 3.3 } do
    local row = at(shaken, part * first)
    local k = over({ 2 * pi * row.frequency * math.sqrt(mu / T), 0 }, power({ 1, eta }, 0.5))
    local w = over({ 1, 0 }, cos(times(k, { L / 2, 0 })))
    check(("shaken at %.2f"):format(part) .. of, row.amplitude, 1e-4 * size(w), part < 2 and 0.01 or 0.04)
    if part < 2 then check(("its phase at %.2f"):format(part) .. of, row.phase / 180, degrees(w) / 180, 0.01) end
  end
end

-- A cantilever: w(L) / base = (cos b + cosh b) / (1 + cos b cosh b), b = L (mu omega^2 / (B (1 + i eta)))^(1/4); and with a force at its end.
for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  local L, b, h, B, eta = 0.15, 0.04, 0.8e-3, 6e-3, 0.05
  local card = fabric.svk { density = 900, thickness = h, warp = 3e8, weft = 3e8, shear = 1e8, poisson = 0, bending = { warp = B, weft = B, twist = B / 2 } }
  local mesh = fabric.mesh.rectangle { width = L, height = b, nx = 30, ny = 2, triangles = tri }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("left", "x y z rotation")
  local mu, n = 900 * h, mesh:set "right"[2]
  local f1 = (1.8751041 / L) ^ 2 * math.sqrt(B / mu) / (2 * pi)
  local function response(load, count)
    local t = { model = m, damping = eta, node = n, lowest = 0.1 * f1, highest = 9 * f1, points = 90, count = count }
    for k, v in pairs(load) do t[k] = v end
    return fabric.lab.frequency_response(t)
  end
  local shaken, pushed = response({ base = { z = 1e-3 } }, 24), response({ force = { set = "right", z = 2e-4 } }, 24)
  assert(shaken.covered > 0.9 and pushed.covered > 0.9)
  for _, part in ipairs { 0.1, 0.6, 1, 2, 3.5, 6.267 } do
    local row, other = at(shaken, part * f1), at(pushed, part * f1)
    local beta = power(over({ mu * (2 * pi * row.frequency) ^ 2 / B, 0 }, { 1, eta }), 0.25)
    local x = times(beta, { L, 0 })
    local ix = { -x[2], x[1] }
    local c, s, ch, sh = cos(x), sin(x), cos(ix), times(sin(ix), { 0, -1 })
    local cch = times(c, ch)
    local below = { 1 + cch[1], cch[2] }
    check(("cantilever shaken at %.2f"):format(part) .. of, row.amplitude, 1e-3 * size(over({ c[1] + ch[1], c[2] + ch[2] }, below)), 0.01)
    local a, d = times(c, sh), times(s, ch) -- w / F = (cosh sin - sinh cos) / (B b beta^3 (1 + cos cosh))
    local stiff = times(times({ B * b, B * b * eta }, times(beta, times(beta, beta))), below)
    check(("cantilever pushed at %.2f"):format(part) .. of, other.amplitude, 2e-4 * size(over({ d[1] - a[1], d[2] - a[2] }, stiff)), 0.01)
  end

  -- Reciprocity: a force here moves the other place as a force there moves this one.
  local here, there = mesh:set "right"[1], mesh:set "top"[6]
  local go = fabric.lab.frequency_response { model = m, force = { set = here, z = 1e-3 }, damping = eta, node = there, lowest = 1, highest = 60, count = 24 }
  local back = fabric.lab.frequency_response { model = m, force = { set = there, z = 1e-3 }, damping = eta, node = here, lowest = 1, highest = 60, count = 24 }
  check("reciprocity" .. of, go.curve[70].amplitude, back.curve[70].amplitude, 1e-9)
  check("in phase, too" .. of, go.curve[70].phase, back.curve[70].phase, 1e-9)
end
-- The effective masses of all modes are the mass that moves, with ties and tilted supports, too.
do
  local card = fabric.svk { density = 500, thickness = 1e-3, warp = 5e7, weft = 4e7, shear = 2e7, poisson = 0.1, bending = { warp = 2e-4, weft = 2e-4, twist = 1e-4 } }
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.06, nx = 3, ny = 2 }
  mesh:set("corner", { mesh:set "left"[1] })
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("left", "x z", { frame = { { 1, 1, 0 }, { -1, 1, 0 } } }):fix("corner", "x y z rotation"):tie("equal", "right", "y")
  local modes, sum = fabric.modes { model = m, count = 60 }, { x = 0, y = 0, z = 0 }
  for _, mode in ipairs(modes) do
    for axis in pairs(sum) do
      sum[axis] = sum[axis] + mode.mass[axis]
      check("effective mass", 1 + mode.participation[axis] ^ 2 * mode.own_mass, 1 + mode.mass[axis], 1e-12)
    end
  end
  for axis, mass in pairs(sum) do check("all that moves along " .. axis, mass, modes.mass[axis], 1e-6) end
end

-- Too few modes are said.
do
  local card = fabric.svk { density = 500, thickness = 1e-3, warp = 5e7, weft = 4e7, shear = 2e7, poisson = 0, bending = { warp = 2e-4, weft = 2e-4, twist = 1e-4 } }
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.03, nx = 12, ny = 2 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("left", "x y z rotation")
  local n = mesh:set "right"[1]
  fabric.lab.frequency_response { model = m, base = { z = 1e-3 }, damping = 0.1, node = n, lowest = 0.1, highest = 1, count = 1 }
  fabric.lab.frequency_response { model = m, force = { set = mesh:set "top"[4], z = 1e-3 }, damping = 0.1, node = n, lowest = 0.1, highest = 5, count = 3 }
end

-- A state that is not stable has no steady swing.
do
  local card = fabric.svk { density = 500, thickness = 1e-3, warp = 5e6, weft = 5e6, shear = 2e6, poisson = 0, bending = { warp = 2e-4, weft = 2e-4, twist = 1e-4 } }
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.03, nx = 10, ny = 2 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("left", "x y z rotation"):fix("right", "y z"):move("right", { x = fabric.ramp(-2e-3, 0.1) })
  local run = fabric.dynamic { model = m, duration = 0.1, scheme = "implicit", step = 0.02 }:solve() -- pressed, and still flat
  local ok, words = pcall(fabric.lab.frequency_response, { from = run, base = { z = 1e-3 }, damping = 0.1, node = 5, lowest = 1, highest = 5 })
  assert(not ok and tostring(words):find("the state is not a stable equilibrium", 1, true), words)
end
fabric.expect(checks)
