-- Free rigid bodies follow the rule of the cloth: with slow=true and a small spectral_radius what no step resolves dies, its
-- energy is in the loss, and a weight let down at once ends where statics place it.
local fabric = require "fabric"
local card = fabric.svk { warp = 1e7, weft = 1e7, shear = 4e6, poisson = { 0, 0 }, density = 500, thickness = 0.5e-3, bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6 } }

-- Solves, in the middle from a snapshot; the loss may only rise.
local function solve(name, a, each, from)
  local lost = 0
  a:every("step", function(r)
    assert(r.energy.damping >= lost - 1e-15 * (1 + lost), name .. ": the loss falls")
    lost = r.energy.damping
    if each then each(r) end
  end)
  if from then a:advance(from):restore(a:snapshot()) end
  a:solve()
  fabric.expect { { name .. ": ledger", a.energy.error, 0, absolute = 1e-6 } }
  return a
end

-- A body on a spring and a damper, with a force at once, another that rises and gravity that comes up: step by step the
-- generalised trapezoidal rule, x+ = x + dt v + theta dt^2 a, v+ = v + dt a, with the forces theta at the end of the step.
local function sprung(options, theta, k, c)
  local mass, dt, T, F = 0.02, 5e-3, 0.3, 0.8
  local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 1, ny = 1 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("all", "x y z rotation")
  local ball = fabric.rigid.sphere { radius = 0.01, centre = { 0.3, 0.05, 0.3 }, mass = mass, name = "ball" }
  m:contact { between = { ball, "all" } }:spring(ball, { x = k }):fix(ball, "y z rotation"):gravity { fabric.ramp(3, 0.2), 0, 0 }
  m:force(ball, { x = fabric.history { { 0, F }, { 0.1, F }, { 0.2, 2 * F } } })
  if c then m:damper(ball, { x = c }) end
  local o = { model = m, duration = T, scheme = "implicit", step = dt, max_cuts = 0 }
  for key, value in pairs(options) do o[key] = value end
  local function force(t) return F * (1 + math.max(0, math.min(1, (t - 0.1) / 0.1))) + mass * 3 * math.min(1, t / 0.2) end
  local x, v, off, most = 0, 0, 0, 0
  local a = solve("sprung", fabric.dynamic(o), function(r)
    if r.time == 0 then return end
    local mean = (1 - theta) * force(r.time - dt) + theta * force(r.time)
    -- x+ from x+ = x + dt v + theta dt^2 (mean - k ((1 - theta) x + theta x+) - c (x+ - x) / dt) / mass
    local share = theta * dt ^ 2 / mass
    local now = (x + dt * v + share * (mean - k * (1 - theta) * x + (c or 0) / dt * x)) / (1 + share * (k * theta + (c or 0) / dt))
    v = v + (now - x - dt * v) / theta / dt
    x = now
    local place, _, _, speed = r:body(ball)
    off, most = math.max(off, math.abs(place - 0.3 - x) + dt * math.abs(speed - v)), math.max(most, math.abs(x))
  end, 0.1)
  local e = a.energy
  fabric.expect {
    { ("theta %g, k %g: off by, of the way"):format(theta, k), off / most, 0, absolute = 1e-6 }, -- Newton's tolerance
    { "what is lost", (e.external - e.stored - e.kinetic) / e.damping, 1, absolute = 1e-6 },
    theta == 1 and { "where statics place it", x / ((2 * F + mass * 3) / k), 1, absolute = k > 1000 and 1e-9 or 0.1 } or nil,
  }
end
for _, k in ipairs { 8e4, 80 } do -- periods of 3 and 99 ms
  sprung({ slow = true }, 1, k)
  sprung({ spectral_radius = 0.2 }, 1 / 1.2, k)
  sprung({ slow = true }, 1, k, 0.5)
  sprung({ spectral_radius = 0.8 }, 1 / 1.8, k, 0.5)
  sprung({}, 0.5, k, 0.5) -- the midpoint's rule; beside cloth without forces no step is cut for rounding
end

-- A weight of 1 N on a strip of cloth, let down at once: a disc to which its end is tied, or its stiff end itself.
local F = 1
local function hung(kind, options)
  local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.1, nx = 1, ny = 5 }
  local m = fabric.model { mesh = mesh, card = card, warp = 90 }:fix("top", "x y z rotation")
  local id, weight = mesh:set "bottom"[1], nil
  if kind == "disc" then
    weight = fabric.rigid.disc { radius = 0.02, edge = 1e-3, centre = { 0.01, -0.002, 0 }, normal = { 0, 1, 0 }, mass = 0.2, name = "weight" }
    mesh:set("far", function(_, y) return y > 0.05 end)
    m:contact { between = { weight, "far" } }:tie("rigid", "bottom", weight):fix(weight, "x z rotation"):force(weight, { y = -F })
  else
    mesh:set("end", function(_, y) return y < 0.021 end)
    m:tie("rigid", "end"):force("bottom", { y = -F })
  end
  local a
  if options then
    a = solve(kind, fabric.dynamic { model = m, duration = 1.2, scheme = "implicit", step = 5e-3, slow = options.slow }, nil, 0.1)
  else
    a = fabric.static { model = m, duration = 1, step = 1 }:solve()
  end
  return -a:node(id).uy, a.energy
end
for _, kind in ipairs { "disc", "stiff end" } do
  local want, rest = hung(kind)
  local way, e = hung(kind, { slow = true })
  fabric.expect {
    { kind .. ": way, of that in statics", way / want, 1, absolute = 1e-4 },
    { kind .. ": kinetic energy, of what is stored", e.kinetic / e.stored, 0, absolute = 1e-6 },
    { kind .. ": the loss, half of the work", e.damping / (F * want - rest.stored), 1, absolute = 1e-3 },
  }
end

-- A rigid set that turns: the arms of its momentum are those of the middle of the step, the speeds of its points their ways
-- over the step, so that w+ = w cos((phi + phi+)/2) = 2 sin(phi+/2) / dt. Where its centre goes, nothing is lost.
do
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.03, nx = 4, ny = 2 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:tie("rigid", "all")
  m:velocity("all", { x = 0.3, spin = { 0, 0, 2880 }, centre = { 0.03, 0.015, 0 } })
  local dt, spin = 1e-3, math.rad(2880)
  local a = solve("turning", fabric.dynamic { model = m, duration = 0.1, scheme = "implicit", step = dt, slow = true })
  local w, phi = spin, 0
  for _ = 1, 100 do
    local now = w * dt
    for _ = 1, 50 do now = 2 * math.asin(w * math.cos((phi + now) / 2) * dt / 2) end
    w, phi = 2 * math.sin(now / 2) / dt, now
  end
  local e, centre, along = a.energy, 0, 0.06 * 0.03 * 0.5e-3 * 500 * 0.3 ^ 2 / 2
  for _, id in ipairs(mesh:set "all") do centre = centre + a:node(id).ux / #mesh:set "all" end
  fabric.expect {
    { "turning: kinetic energy, J", e.kinetic, along + (e.initial - along) * (w / spin) ^ 2, relative = 1e-6 },
    { "turning: the loss, J", e.damping, e.initial - e.kinetic, relative = 1e-9 },
    { "turning: way of its centre, m", centre, 0.03, relative = 1e-9 },
  }
end
