-- Sliding: friction by direction, and a film between surfaces, in explicit and implicit steps and over a restart.
local fabric = require "fabric"

local function near(name, got, want, relative)
  assert(math.abs(got - want) <= relative * math.abs(want), string.format("%s: expected %.9g, got %.9g", name, want, got))
end

local thickness, density, g = 0.4e-3, 900, 9.81
local areal = thickness * density
local card = fabric.svk { young = 5e7, poisson = 0, density = density, thickness = thickness, bending = { warp = 2e-5, weft = 2e-5, twist = 1e-5 } }

-- A sheet lies on a plane and sets out with a velocity.
local function slides(t)
  local mesh = fabric.mesh.rectangle { width = 0.04, height = 0.03, nx = 4, ny = 3, triangles = t.triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = t.warp or 0 }
  local floor = fabric.rigid.plane { point = { 0, 0, -thickness / 2 }, normal = { 0, 0, 1 } }
  m:contact { between = { floor, "all" }, friction = t.friction, film = t.film, stiffness = 1e8, thickness = thickness }
  m:gravity { 0, 0, -g }:velocity("all", { x = t.velocity[1], y = t.velocity[2] })
  local a = fabric.dynamic { model = m, duration = t.duration, scheme = t.scheme, step = t.scheme == "implicit" and t.duration / 40 or nil }
  return a, m, mesh
end

local function speed(a)
  local x, y, n = 0, 0, 20
  for i = 1, n do
    local p = a:node(i)
    x, y = x + p.vx / n, y + p.vy / n
  end
  return x, y
end

for _, how in ipairs { { "explicit", false }, { "explicit", true }, { "implicit", false }, { "implicit", true } } do
  local scheme, triangles = how[1], how[2]
  local name = scheme .. (triangles and ", triangles" or "")

  -- A film of 2 Pa s and 0.5 mm: the speed falls as exp(-viscosity t / (thickness * areal mass)).
  local drag, v = 0.04 / 0.5e-3, 0.3
  local a = slides { film = { viscosity = 0.04, thickness = 0.5e-3 }, velocity = { v, 0 }, duration = 4e-3, scheme = scheme, triangles = triangles }
  a:solve()
  local n, dt = 40, 4e-3 / 40
  local want = scheme == "implicit" and v * (1 + drag * dt / areal) ^ -n or v * math.exp(-drag * 4e-3 / areal)
  near("speed on a film, " .. name, speed(a), want, 0.02)
  near("what a film takes, " .. name, a.energy.friction, areal * 0.04 * 0.03 * (v ^ 2 - speed(a) ^ 2) / 2, 1e-3)
  assert(a.energy.error < 1e-4, a.energy.error)

  -- Friction along and across the warp: an ellipse; what slides goes straight on.
  for _, angle in ipairs { 0, 50, 90 } do
    local towards, turn = math.rad(20), math.rad(angle)
    local along, across, time = 0.2, 0.45, 0.03
    local b = slides { friction = { warp = along, weft = across }, warp = 20 - angle, velocity = { math.cos(towards), math.sin(towards) },
                       duration = time, scheme = scheme, triangles = triangles }
    b:solve()
    local mu = 1 / math.sqrt((math.cos(turn) / along) ^ 2 + (math.sin(turn) / across) ^ 2)
    local x, y = speed(b)
    near(("friction at %d degrees, %s"):format(angle, name), 1 - math.sqrt(x * x + y * y), mu * g * time, 0.03)
    near(("direction at %d degrees, %s"):format(angle, name), math.deg(math.atan(y, x)), 20, 0.02)
  end
end

-- A film that thins above 0.02 m/s: the sheet against the integral of its one equation, m dv/dt = -drag v (1 + (v/v0)^2)^((n-1)/2). Its loss only grows,
-- also where a force draws the sheet to and fro.
local function thinned(drag, v0, n, v, time)
  local steps = 20000
  local function rate(u) return -drag / areal * u * (1 + (u / v0) ^ 2) ^ ((n - 1) / 2) end
  local dt = time / steps
  for _ = 1, steps do
    local k1 = rate(v)
    local k2 = rate(v + dt / 2 * k1)
    local k3 = rate(v + dt / 2 * k2)
    v = v + dt / 6 * (k1 + 2 * k2 + 2 * k3 + rate(v + dt * k3))
  end
  return v
end
for _, how in ipairs { { "explicit", false }, { "explicit", true }, { "implicit", false }, { "implicit", true } } do
  local name = how[1] .. (how[2] and ", triangles" or "")
  local film = { viscosity = 0.15, thickness = 0.5e-3, speed = 0.02, exponent = 0.4 }
  local a, m = slides { film = film, velocity = { 0.24, 0.18 }, duration = 4e-3, scheme = how[1], triangles = how[2] }
  local taken, falls = 0, 0
  a:every("step", function(run)
    falls = math.max(falls, taken - run.energy.friction)
    taken = run.energy.friction
  end)
  a:solve()
  local x, y = speed(a)
  local v, want = math.sqrt(x * x + y * y), thinned(0.15 / 0.5e-3, 0.02, 0.4, 0.3, 4e-3)
  near("speed on a film that thins, " .. name, v, want, 0.03) -- it takes the sheet 0.1 ms to sink in
  assert(v > 1.2 * 0.3 * math.exp(-300 * 4e-3 / areal) + 0.01, v) -- as thick at all speeds it would have stopped
  near("its direction, " .. name, y / x, 0.75, 1e-3)
  near("what it takes, " .. name, a.energy.friction, areal * 0.04 * 0.03 * (0.3 ^ 2 - v ^ 2) / 2, 2e-3)
  assert(a.energy.error < 1e-4 and falls <= 1e-12 * taken, falls / taken)
  assert(tostring(m:list()):find "film of 0.15 Pa s, 0.0005 m, thinner above 0.02 m/s, exponent 0.4", tostring(m:list()))
end

-- In the middle of it the same bits from a snapshot.
do
  local function make() return slides { friction = { warp = 0.2, weft = 0.3 }, film = { viscosity = 0.02, thickness = 0.5e-3, speed = 0.05, exponent = 0.6 }, velocity = { 0.2, 0.1 }, duration = 2e-3 } end
  local a = make()
  local kept
  a:every(1e-4, function(run) kept = kept or run.time > 9e-4 and run:snapshot() end)
  a:solve()
  local x, y = speed(a)
  local friction = a.energy.friction
  a:restore(kept)
  a:solve()
  local again, too = speed(a)
  assert(x == again and y == too and friction == a.energy.friction)
end

-- Films are listed, and told apart.
do
  local _, m = slides { friction = { warp = 0.2, weft = 0.3 }, film = { viscosity = 0.02, thickness = 0.5e-3 }, velocity = { 0.2, 0.1 }, duration = 2e-3 }
  assert(tostring(m:list()):find "friction 0.2 along the warp, 0.3 across, film of 0.02 Pa s, 0.0005 m", tostring(m:list()))
end
print "films ok"
