-- Forces, moments, springs, dampers and partial supports of rigid bodies: closed forms in explicit, implicit and static runs.
local fabric = require "fabric"
local card = fabric.svk { young = 1e7, poisson = 0, density = 600, thickness = 0.4e-3 }

local function near(name, got, want, relative)
  assert(math.abs(got - want) <= relative * math.abs(want), string.format("%s: expected %.12g, got %.12g", name, want, got))
end
local function fails(words, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(words, 1, true), 'expected "' .. words .. '", got ' .. tostring(why))
end

-- A held sheet, from which all bodies are far.
local function far_from(...)
  local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 2, ny = 2 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("all", "x y z rotation")
  for _, body in ipairs { ... } do m:contact { between = { body, "all" } } end
  return m
end
local function disc(mass, z, name)
  return fabric.rigid.disc { radius = 0.03, centre = { 0.5, 0.5, z or 0.5 }, normal = { 0, 0, 1 }, edge = 0.002, mass = mass, name = name or "disc" }
end

for _, scheme in ipairs { "explicit", "implicit" } do
  local T, explicit = 0.02, scheme == "explicit"
  local function run(m, step)
    return fabric.dynamic { model = m, duration = T, scheme = scheme, step = step or not explicit and T / 40 or nil }
  end
  do -- a constant force along one free direction, and a moment about one free axis
    local body, second = disc(2), disc(0.5, 0.8, "second")
    local m = far_from(body, second):force(body, { x = 3, y = 7 }):fix(body, "y z rotation")
    m:moment(second, { z = 1e-3, x = 5 }):fix(second, "x y z rx ry")
    local a = run(m):solve()
    local x, y, z, vx = a:body(body)
    near("way", x - 0.5, 3 * T ^ 2 / 2 / 2, 1e-12)
    near("speed", vx, 3 * T / 2, 1e-12)
    assert(y == 0.5 and z == 0.5)
    local spin = select(9, a:body(second))
    local inertia = 0.5 * 0.03 ^ 2 / 2
    near("spin", spin, math.deg(1e-3 * T / inertia), 1e-9)
    near("work", a.energy.external, 3 * (x - 0.5) + 1e-3 * 1e-3 * T ^ 2 / 2 / inertia, 1e-9)
    near("kinetic", a.energy.rigid, a.energy.external, 1e-9)
    assert(a.energy.error < 1e-9)
  end
  do -- a force that grows, on a spring that is slack elsewhere: x'' = (F t/T - k (x - s))/m
    local body, k, mass, s = disc(0.2), 900, 0.2, 1e-3
    local m = far_from(body):fix(body, "x y rotation"):force(body, { z = fabric.ramp(40, T) })
    m:spring(body, { z = k }, { to = { 0.5, 0.5, 0.5 + s } })
    local a = run(m, not explicit and T / 400):solve()
    local w, _, _, z = math.sqrt(k / mass), a:body(body)
    local want = s * (1 - math.cos(w * T)) + 40 / T / k * (T - math.sin(w * T) / w)
    near("on a spring", z - 0.5, want, 1e-3)
    assert(a.energy.error < 1e-3 and a.energy.stored > 0, a.energy.error)
  end
  do -- a damper, and what it takes
    local body, c, mass, F = disc(0.2), 30, 0.2, 5
    local m = far_from(body):fix(body, "x y rotation"):force(body, { z = -F }):damper(body, { z = c })
    local a = run(m, not explicit and T / 2000):solve()
    local _, _, z, _, _, v = a:body(body)
    local tau = mass / c
    near("damped speed", v, -F / c * (1 - math.exp(-T / tau)), 1e-3)
    near("damped way", z - 0.5, -F / c * (T - tau * (1 - math.exp(-T / tau))), 1e-3)
    near("damping", a.energy.damping, F * (0.5 - z) - mass * v ^ 2 / 2, 1e-3)
    assert(a.energy.error < 1e-3, a.energy.error)
  end
  do -- two bodies on a spring: their centre of mass stays
    local one, two, k = disc(0.3, 0.5, "one"), disc(0.1, 0.8, "two"), 500
    local m = far_from(one, two):spring(one, { x = k, z = k }, { to = two }):velocity(one, { x = 0.5 })
    local a = run(m, not explicit and T / 400):solve()
    local x1, _, _, v1 = a:body(one)
    local x2, _, _, v2 = a:body(two)
    near("momentum", 0.3 * v1 + 0.1 * v2, 0.15, 1e-9)
    local w, mean = math.sqrt(k * (1 / 0.3 + 1 / 0.1)), 0.15 / 0.4
    near("drawn", x1 - x2, 0.5 / w * math.sin(w * T), 1e-3)
    near("both", 0.3 * (x1 - 0.5) + 0.1 * (x2 - 0.5), 0.4 * mean * T, 1e-9)
  end
  do -- one that is drawn by another that is moved
    local free, moved, k = disc(0.3, 0.5, "free"), disc(nil, 0.8, "moved"), 400
    local m = far_from(free, moved):spring(free, { x = k }, { to = moved }):damper(free, { x = 2 }, { to = moved })
    m:fix(free, "y z rotation"):move(moved, { x = fabric.ramp(0.01, T) })
    local a = run(m, not explicit and T / 400):solve()
    assert(a.energy.external > 0 and a.energy.error < 1e-3, a.energy.error)
  end
end

-- Statics: no mass is needed. A plate on springs; and one that presses a sheet on a plane, whose force it has then.
do
  local body = disc(nil, 0.5)
  local m = far_from(body):force(body, { z = fabric.ramp(-20, 1) }):fix(body, "x y rotation"):spring(body, { z = 4000 })
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  near("sunk", 0.5 - select(3, a:body(body)), 20 / 4000, 1e-9)
  near("work of the force", a.energy.external, 20 ^ 2 / 4000 / 2, 1e-9)
  near("stored", a.energy.stored, 20 ^ 2 / 4000 / 2, 1e-9)
end

-- A support holds what else acts on the body in its directions: a force, a spring, gravity.
for _, steps in ipairs { "explicit", "implicit", "static" } do
  local body = disc(steps ~= "static" and 0.2 or nil, 0.5)
  local m = far_from(body):force(body, { x = 7, y = fabric.ramp(-3, 0.004), z = fabric.ramp(-2, 0.004) }):fix(body, "x y rotation"):spring(body, { x = 500, z = 800 }, { to = { 0.51, 0, 0.5 } })
  if steps ~= "static" then m:gravity { 9, 0, 0 } end
  local a = steps == "static" and fabric.static { model = m, duration = 0.004, step = 0.001 }
      or fabric.dynamic { model = m, duration = 0.004, scheme = steps, step = steps == "implicit" and 1e-4 or nil }
  a:solve()
  local x, y, z = a:reaction(body, { support = true })
  local far = 500 * (0.51 - a:body(body))
  near("held along x, " .. steps, x, -7 - far - (steps ~= "static" and 0.2 * 9 or 0), 1e-9)
  assert(math.abs(y - 3 * math.min(1, a.time / 0.004)) < 1e-9 and z == 0, y .. " " .. z)
end
local function pressed(nx, triangles)
  local mesh = fabric.mesh.rectangle { width = 0.04, height = 0.04, nx = nx, ny = nx, triangles = triangles, origin = { -0.02, -0.02, 0 } }
  mesh:map(function(x, y) return x, y, 0.199e-3 end)
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("corners", "x y")
  local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 }, name = "floor" }
  local plate = fabric.rigid.plane { point = { 0, 0, 0.398e-3 }, normal = { 0, 0, -1 }, name = "plate" }
  m:contact { between = { floor, "all" }, friction = 0.1 }:contact { between = { plate, "all" }, friction = 0.1 }
  m:fix(plate, "x y rotation"):force(plate, { z = fabric.ramp(-16, 1) })
  return m, floor, plate
end
for _, nx in ipairs { 2, 5 } do
  local m, floor, plate = pressed(nx, nx == 5)
  local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  near("on the floor", select(3, a:reaction(floor)), 16, 1e-6)
  near("under the plate", select(3, a:reaction(plate)), -16, 1e-6)
  assert(select(3, a:body(plate)) < 0.4e-3)
end

-- A restart in the middle has the same bits.
do
  local function make()
    local body = disc(0.2)
    local m = far_from(body):fix(body, "x y rotation"):force(body, { z = -5 }):damper(body, { z = 3 }):spring(body, { z = 800 })
    return fabric.dynamic { model = m, duration = 0.004 }, body
  end
  local a, body = make()
  a:advance(0.002)
  local s = a:snapshot()
  a:solve()
  local z, damping = select(3, a:body(body)), a.energy.damping
  a:restore(s)
  a:solve()
  assert(select(3, a:body(body)) == z and a.energy.damping == damping and damping > 0)
end

-- Loads that are listed, taken back, and refused.
do
  local body = disc(1)
  local m = far_from(body):force(body, { z = -4 }):moment(body, { x = 1 }):spring(body, { z = 5 }, { to = { 0, 0, 1 } }):damper(body, { x = 6 }):fix(body, "x rx ry rz")
  local words = tostring(m:list())
  for _, line in ipairs { "force.*disc.*z %-4 N", "moment.*disc.*x 1 N m", "spring.*disc.*z 5 N/m, slack at", "damper.*disc.*x 6 N s/m", "fix.*disc.*x rx ry rz" } do
    assert(words:find(line), line .. " in " .. words)
  end
  local before = #m:list()
  m:remove { kind = "damper", set = "disc" }
  assert(#m:list() == before - 1 and #m:declared() > 0)
end
local light, moved = disc(nil), disc(nil, 0.8, "moved")
fails("dynamic: forces, springs or supports place the disc, which has no mass: expected mass= where it is made", function()
  fabric.dynamic { model = far_from(light):force(light, { z = 1 }), duration = 1e-4 }
end)
fails("moved by m:move, which gives its whole place", function() far_from(moved):move(moved, { z = 1e-3 }):force(moved, { z = 1 }) end)
fails("which decide where it is", function() far_from(moved):force(moved, { z = 1 }):move(moved, { z = 1e-3 }) end)
fails("would turn about two axes", function() far_from(light):fix(light, "rx") end)
fails("touches nothing", function() fabric.static { model = far_from():force(light, { z = 1 }), duration = 1 } end)
fails("a plane has no end about which it could turn", function()
  local plane = fabric.rigid.plane { point = { 0, 0, 1 }, normal = { 0, 0, -1 } }
  fabric.static { model = far_from(plane):force(plane, { z = -1 }), duration = 1 }
end)
fails("is loaded along global axes", function() far_from(light):force(light, { z = 1 }, { frame = { { 1, 0, 0 }, { 0, 1, 0 } } }) end)
fails("expected another body than itself", function() far_from(light):spring(light, { z = 1 }, { to = light }) end)
fails("control=\"load\"", function() fabric.static { model = far_from(light):force(light, { z = 1 }), duration = 1, control = "arc" } end)
