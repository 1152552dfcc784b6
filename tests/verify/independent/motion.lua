-- Motion against closed forms and integrations of its own: frequencies of taut, clamped and hanging sheets, waves, damping, tumbling, spinning, the
-- work of supports, momentum; explicit and implicit steps, quadrilaterals and triangles.
--
-- The central differences' frequency of a mode w is higher by (w dt)^2 / 24, the trapezoidal rule's lower by (w dt)^2 / 12; steps are so small
-- that what is left is the mesh.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()
local soft = { warp = 1e-12, weft = 1e-12, twist = 1e-12 }

-- The mean period of a node's displacement in a run.
local function period(a, node, component)
  local zero = common.crossings()
  a:every("step", function(run) zero.see(run.time, run:node(node)[component]) end)
  a:solve()
  return zero.period()
end

-- A taut sheet, stretched by l1 and l2 in its plane: rho w,tt = S11 w,XX + S22 w,YY over the reference, so that
--   f = 1/2 sqrt((S11 / a^2 + S22 / b^2) / rho). Started with the velocities of that mode.
for _, case in ipairs { { "explicit" }, { "implicit" }, { "explicit", triangles = true } } do
  local a, b, E1, E2, l1, l2, rho, n = 0.3, 0.2, 3e6, 5e6, 1.05, 1.03, 450, 8
  local mesh = fabric.mesh.rectangle { width = a, height = b, nx = n, ny = n, triangles = case.triangles }
  local card = common.sheet { warp = E1, weft = E2, shear = 1e6, poisson = { 0, 0 }, density = rho, bending = soft }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  mesh:set("inside", function(x, y) return x > 1e-9 and x < a - 1e-9 and y > 1e-9 and y < b - 1e-9 end)
  common.each(mesh, function(name, X) m:move(name, { x = (l1 - 1) * X[1], y = (l2 - 1) * X[2] }) end)
  m:fix("boundary", "z")
  m:velocity("inside", function(x, y) return { z = 1e-3 * math.sin(math.pi * x / a) * math.sin(math.pi * y / b) } end)
  local S1, S2 = E1 * (l1 ^ 2 - 1) / 2, E2 * (l2 ^ 2 - 1) / 2
  local f = 0.5 * math.sqrt((S1 / a ^ 2 + S2 / b ^ 2) / rho)
  local run = fabric.dynamic { model = m, duration = 2.1 / f, scheme = case[1], step = case[1] == "implicit" and 0.01 / f or nil, inertia = "true" }
  local name = ("taut sheet, %s%s: frequency, Hz"):format(case[1], case.triangles and ", triangles" or "")
  checks(name, 1 / period(run, common.nearest(mesh, a / 2, b / 2), "uz"), f, { relative = 0.01 }) -- (k h)^2 / 24 = 0.6 %
end

-- A string pulled by F, in its j-th mode: f = j / (2 l) sqrt(F / mass per length), with the length and the mass per length as stretched.
for j, scheme in ipairs { "explicit", "implicit" } do
  local l, b, rho, t, n, F = 0.5, 0.01, 700, 0.4e-3, 30, 0.9
  local mesh = fabric.mesh.rectangle { width = l, height = b, nx = n, ny = 1 }
  local m = fabric.model { mesh = mesh, card = common.sheet { young = 4e6, density = rho, thickness = t, bending = soft }, warp = 0 }
  local strain = common.root(function(e) return 4e6 * e * math.sqrt(1 + 2 * e) * b * t - F end, 0, 1)
  local stretch = math.sqrt(1 + 2 * strain)
  m:fix("all", "y"):fix("left", "z"):fix("right", "z")
  common.each(mesh, function(name, X) m:move(name, { x = (stretch - 1) * X[1] }) end)
  mesh:set("inside", function(x) return x > 1e-9 and x < l - 1e-9 end)
  m:velocity("inside", function(x) return { z = 1e-3 * math.sin(j * math.pi * x / l) } end)
  local f = j / (2 * l * stretch) * math.sqrt(F / (rho * b * t / stretch)) -- in the stretched state: length, and mass per length
  local a = fabric.dynamic { model = m, duration = 2.1 / f, scheme = scheme, step = scheme == "implicit" and 0.005 / f or nil, inertia = "true" }
  checks(("string, %s, mode %d: frequency, Hz"):format(scheme, j), 1 / period(a, common.nearest(mesh, l / (2 * j), 0), "uz"), f, { relative = 5e-3 })
end

-- A clamped strip: f = 1.8751041^2 / (2 pi l^2) sqrt(B / mass per area), in its first mode, along the warp and along the weft.
for _, case in ipairs { { "implicit", warp = 0 }, { "explicit", warp = 90 } } do
  local l, B1, B2, n, beta = 0.05, 14e-6, 6e-6, 12, 1.875104069
  local mesh = fabric.mesh.rectangle { width = l, height = 0.02, nx = n, ny = 1 }
  local m = fabric.model { mesh = mesh, card = common.sheet { young = 5e6, bending = { warp = B1, weft = B2, twist = 3e-6 } }, warp = case.warp }
  local sigma = ((math.exp(beta) + math.exp(-beta)) / 2 + math.cos(beta)) / ((math.exp(beta) - math.exp(-beta)) / 2 + math.sin(beta))
  mesh:set("moves", function(x) return x > 1e-9 end)
  m:fix("left", "x y z rotation"):velocity("moves", function(x)
    local s = beta * x / l
    return { z = 1e-4 * ((math.exp(s) + math.exp(-s)) / 2 - math.cos(s) - sigma * ((math.exp(s) - math.exp(-s)) / 2 - math.sin(s))) }
  end)
  local f = beta ^ 2 / (2 * math.pi * l ^ 2) * math.sqrt((case.warp == 0 and B1 or B2) / 0.2)
  local run = fabric.dynamic { model = m, duration = 3.1 / f, scheme = case[1], step = case[1] == "implicit" and 0.005 / f or nil }
  checks(("clamped strip, %s: frequency, Hz"):format(case[1]), 1 / period(run, n + 1, "uz"), f, { relative = 0.01 }) -- h^2
end

-- A strip hung from its upper edge swings as a chain: w = j / 2 sqrt(g / l), j = 2.404826 the first zero of Bessel's J0, in the shape J0(j sqrt(s / l)), s from
-- the free end. The weight comes before: the strip stands at rest in its length until then.
do
  local l, n, g, j = 0.25, 20, 9.81, 2.404825558
  local function J0(x)
    local sum, term = 1, 1
    for k = 1, 40 do
      term = -term * (x / 2 / k) ^ 2
      sum = sum + term
    end
    return sum
  end
  local mesh = fabric.mesh.rectangle { width = 0.02, height = l, nx = 1, ny = n }
  local m = fabric.model { mesh = mesh, card = common.sheet { young = 2e7, bending = { warp = 1e-10, weft = 1e-10, twist = 1e-10 } }, warp = 90 }
  mesh:set("moves", function(_, y) return y < l - 1e-9 end)
  m:fix("top", "x y z"):fix("all", "x"):gravity { 0, -g, 0 }
  m:velocity("moves", function(_, y) return { z = 2e-3 * J0(j * math.sqrt(y / l)) } end)
  local f = j / 2 * math.sqrt(g / l) / (2 * math.pi)
  local a = fabric.dynamic { model = m, duration = 2.1 / f, scheme = "implicit", step = 0.004 / f, hht = -0.05 }
  checks("hanging strip: frequency, Hz", 1 / period(a, 1, "uz"), f, { relative = 5e-3 })
end

-- A strip struck at its end: the wave runs with c = sqrt(E / rho), and the end carries rho c v per area until it is back. Small strain, v / c = 1e-4.
for _, scheme in ipairs { "explicit", "implicit" } do
  local l, b, t, E, rho, n = 0.4, 0.01, 0.5e-3, 4e6, 640, 200
  local c = math.sqrt(E / rho)
  local v = 1e-4 * c
  local mesh = fabric.mesh.rectangle { width = l, height = b, nx = n, ny = 1 }
  local m = fabric.model { mesh = mesh, card = common.sheet { warp = E, weft = 2e6, shear = 1e6, poisson = { 0, 0 }, density = rho, thickness = t }, warp = 0 }
  m:fix("all", "y z rotation"):move("left", { x = function(time) return v * time end })
  local near, far = common.nearest(mesh, 0.3 * l, 0), common.nearest(mesh, 0.75 * l, 0)
  local a = fabric.dynamic { model = m, duration = 0.85 * l / c, scheme = scheme, step = scheme == "implicit" and 0.5 * l / n / c or nil }
  local last, last_time, passed = { [near] = 0, [far] = 0 }, 0, {}
  a:every("step", function(run)
    for node, before in pairs(last) do
      local now = run:node(node).vx
      if not passed[node] and now >= v / 2 then passed[node] = last_time + (v / 2 - before) * (run.time - last_time) / (now - before) end
      last[node] = now
    end
    last_time = run.time
  end)
  a:solve()
  checks("wave, " .. scheme .. ": speed, m/s", 0.45 * l / (passed[far] - passed[near]), c, { relative = 5e-3 }) -- the front widens over some elements
  checks("wave, " .. scheme .. ": force at its source", (a:reaction "left"), rho * c * v * b * t, { relative = 5e-3 })
  local met = common.nearest(mesh, 0.2 * l, 0)
  checks("wave, " .. scheme .. ": strain behind it", (a:node(met + 1).ux - a:node(met).ux) / (l / n), -v / c, { relative = 0.02 }) -- ringing behind the front
end

-- A stiff sheet on springs with mass damping a: u = v / w e^(-a t / 2) sin(w t), w^2 = K / M - a^2 / 4. The logarithmic decrement of one period is pi a / w, and
-- what has gone is what damping took.
for _, scheme in ipairs { "explicit", "implicit" } do
  local K, alpha, v = 30, 40, 0.2
  local mesh = fabric.mesh.rectangle { width = 0.05, height = 0.03, nx = 2, ny = 1 }
  local M = 0.05 * 0.03 * 0.2
  local m = fabric.model { mesh = mesh, card = common.sheet { young = 2e6 }, warp = 0 }
  m:fix("all", "x y rotation"):spring("all", { z = K }):velocity("all", { z = v })
  local w = math.sqrt(K / M - alpha ^ 2 / 4)
  local T = 2 * math.pi / w
  local a = fabric.dynamic { model = m, duration = 2.25 * T, scheme = scheme, step = scheme == "implicit" and T / 500 or nil, damping = { mass = alpha } }
  local tops = {}
  for k = 0, 2 do
    a:advance((0.25 + k) * T)
    tops[#tops + 1] = a:node(1).uz
    checks(("damped, %s: place after %g periods"):format(scheme, 0.25 + k), a:node(1).uz, v / w * math.exp(-alpha * a.time / 2), { relative = 2e-3 })
  end
  checks("damped, " .. scheme .. ": logarithmic decrement", math.log(tops[1] / tops[3]) / 2, math.pi * alpha / w, { relative = 2e-3 })
  local e = a.energy
  checks("damped, " .. scheme .. ": taken", e.damping, M * v * v / 2 - e.kinetic - e.stored, { relative = 1e-3 })
end

-- A stiff plate thrown with a spin about the middle of its three axes tumbles over: Euler's equations I1 w1' = (I2 - I3) w2 w3 and so on, the axes carried along by
-- e' = w x e, integrated here. Inertia from the lumped masses, a grid whose inner lines weigh twice the outer: a^2 / 12 (1 + 2 / n^2) for a^2 / 12.
for _, scheme in ipairs { "explicit", "implicit" } do
  local a, b, nx, ny, t, rho = 0.12, 0.07, 3, 2, 3e-3, 300
  local mesh = fabric.mesh.rectangle { width = a, height = b, nx = nx, ny = ny, origin = { -a / 2, -b / 2, 0 } }
  local m = fabric.model { mesh = mesh, card = common.sheet { young = 4e6, thickness = t, density = rho }, warp = 0 }
  local I1 = b * b / 12 * (1 + 2 / ny ^ 2) + t * t / 12
  local I2 = a * a / 12 * (1 + 2 / nx ^ 2) + t * t / 12
  local I3 = b * b / 12 * (1 + 2 / ny ^ 2) + a * a / 12 * (1 + 2 / nx ^ 2)
  local spin = { 1.5, 25, -1.2 } -- rad/s
  m:velocity("all", { x = 0.1, y = -0.2, z = 0.3, spin = { math.deg(spin[1]), math.deg(spin[2]), math.deg(spin[3]) } })
  local time = 0.25
  local run = fabric.dynamic { model = m, duration = time, scheme = scheme, step = scheme == "implicit" and 5e-4 or nil, inertia = "true" }
  run:solve()
  -- w in the body's axes, then the three axes in space.
  local y = common.integrate(function(_, s)
    local w = { s[1], s[2], s[3] }
    local out = { (I2 - I3) / I1 * w[2] * w[3], (I3 - I1) / I2 * w[3] * w[1], (I1 - I2) / I3 * w[1] * w[2] }
    for c = 1, 3 do -- e1' = w3 e2 - w2 e3 and so on
      local e1, e2, e3 = s[3 + c], s[6 + c], s[9 + c]
      out[3 + c], out[6 + c], out[9 + c] = w[3] * e2 - w[2] * e3, w[1] * e3 - w[3] * e1, w[2] * e1 - w[1] * e2
    end
    return out
  end, 0, time, { spin[1], spin[2], spin[3], 1, 0, 0, 0, 1, 0, 0, 0, 1 }, 4000)
  local corner = run:node((nx + 1) * (ny + 1))
  local centre = { 0.1 * time, -0.2 * time, 0.3 * time }
  local places, off = { corner.x, corner.y, corner.z }, 0
  for c = 1, 3 do off = off + (places[c] - centre[c] - y[3 + c] * a / 2 - y[6 + c] * b / 2) ^ 2 end
  assert(y[2] < 0, "it has tumbled over")
  -- Speeds of 1.5 m/s against waves of 115: stretched by (v / c)^2 = 2e-4; the moment of turning over grows that.
  checks("tumbling, " .. scheme .. ": a corner's place, of the diagonal", math.sqrt(off) / math.sqrt(a * a + b * b), 0, { absolute = 0.02 })
end

-- A thick sheet thrown with a spin: kinetic energy M v^2 / 2 + I w^2 / 2 about each axis, where the thickness counts with t^2 / 12 about the axes in the sheet.
for _, scheme in ipairs { "explicit", "implicit" } do
  local a, b, nx, ny, t, rho, w = 0.06, 0.04, 3, 2, 0.015, 400, 7
  local of_a, of_b, M = a * a / 12 * (1 + 2 / nx ^ 2), b * b / 12 * (1 + 2 / ny ^ 2), rho * a * b * t
  for axis, I in ipairs { of_b + t * t / 12, of_a + t * t / 12, of_a + of_b } do
    local mesh = fabric.mesh.rectangle { width = a, height = b, nx = nx, ny = ny, origin = { -a / 2, -b / 2, 0 } }
    -- Once with bending by its thickness, once with a rigidity of its own.
    local own = scheme == "implicit" and { warp = 1, weft = 0.7, twist = 0.3 } or nil
    local m = fabric.model { mesh = mesh, card = common.sheet { young = 4e6, thickness = t, density = rho, bending = own }, warp = 0 }
    local spin = { 0, 0, 0 }
    spin[axis] = math.deg(w)
    m:velocity("all", { x = 0.05, z = -0.02, spin = spin })
    local run = fabric.dynamic { model = m, duration = 5e-3, scheme = scheme, step = scheme == "implicit" and 1e-4 or nil, inertia = "true" }
    local want = M * (0.05 ^ 2 + 0.02 ^ 2) / 2 + M * I * w * w / 2
    run:advance(2e-6)
    checks(("spinning about axis %d, %s: kinetic energy"):format(axis, scheme), run.energy.kinetic, want, { relative = 1e-6 })
    run:solve()
    checks(("spinning about axis %d, %s: kept"):format(axis, scheme), run.energy.kinetic + run.energy.stored, want, { relative = 1e-4 })
  end
end

-- A strip that spins about an axis across it: N' = -rho w^2 x, N = lambda E (lambda^2 - 1) / 2 per area, x' = lambda, none at the end: shooting for the stretch at
-- the root. Spun up slowly; what is left of swinging is averaged over a stretch of time.
do
  local r, l, b, E, rho, n, w = 0.03, 0.2, 0.02, 2e6, 500, 16, 110
  local function outer(first)
    -- N = A S lambda; lambda from N by its own root: carried as N, x.
    local function stretch(N) return common.root(function(q) return E * q * (q * q - 1) / 2 - N end, 0.8, 2) end
    local y = common.integrate(function(_, s) return { -rho * w * w * s[2], stretch(s[1]) } end, 0, l, { first, r }, 50)
    return y[1], y[2]
  end
  local N = common.root(function(first) return (outer(first)) end, 0, rho * w * w * l * (r + l))
  local _, want = outer(N)
  local mesh = fabric.mesh.rectangle { width = l, height = b, nx = n, ny = 1, origin = { r, -b / 2, 0 } }
  local m = fabric.model { mesh = mesh, card = common.sheet { warp = E, weft = 2 * E, shear = E, poisson = { 0, 0 }, density = rho }, warp = 0 }
  local T = 1.5
  local function angle(t) return t < T and w / 2 * (t - T / math.pi * math.sin(math.pi * t / T)) or w * (t - T / 2) end
  m:fix("all", "z rotation")
  for _, y in ipairs { -b / 2, b / 2 } do
    local name = "root " .. y
    mesh:set(name, function(X, Y) return X < r + 1e-9 and math.abs(Y - y) < 1e-9 end)
    m:move(name, { x = function(t) return r * math.cos(angle(t)) - y * math.sin(angle(t)) - r end,
      y = function(t) return r * math.sin(angle(t)) + y * math.cos(angle(t)) - y end })
  end
  local a = fabric.dynamic { model = m, duration = T + 0.05 }
  local sum, count, pull = 0, 0, 0
  a:every("step", function(run)
    if run.time < T then return end
    local p, q = run:node(n + 1), run:node(2 * (n + 1))
    local x, y = run:reaction "left"
    sum, count = sum + math.sqrt(((p.x + q.x) / 2) ^ 2 + ((p.y + q.y) / 2) ^ 2), count + 1
    pull = pull - x * math.cos(angle(run.time)) - y * math.sin(angle(run.time))
  end)
  a:solve()
  assert(want > 1.04 * (r + l))
  checks("spinning strip: radius of its end", sum / count, want, { relative = 1e-3 })
  checks("spinning strip: pull at its root", pull / count, N * b * 0.4e-3, { relative = 0.01 }) -- h^2, and swings
end

-- The work of a support, summed here over the steps, is the run's; in motion it is what is stored, dissipated and moves. Momentum is the support's impulse.
for _, scheme in ipairs { "static", "explicit", "implicit" } do
  local T, pull = scheme == "static" and 1 or 0.02, 0.004
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.03, nx = 4, ny = 2 }
  local card = fabric.card "blend"
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("all", "z rotation"):fix("left", "x y"):fix("right", "y")
  m:move("right", { x = function(t) return pull * math.sin(2.2 * math.pi * t / T) ^ 2 end })
  local a = scheme == "static" and fabric.static { model = m, duration = T, step = T / 400 }
    or fabric.dynamic { model = m, duration = T, scheme = scheme, step = scheme == "implicit" and T / 800 or nil }
  local work, impulse, last, way, time = 0, 0, 0, 0, 0
  a:every("step", function(run)
    local right = run:reaction "right"
    local left, u = run:reaction "left", run:node(5).ux
    work = work + (right + last) / 2 * (u - way)
    impulse = impulse + (right + left) * (run.time - time)
    last, way, time = right, u, run.time
  end)
  a:solve()
  local e = a.energy
  checks("work of a support, " .. scheme, e.external, work, { relative = 2e-3 }) -- trapezoids here, and other ones there
  checks("work of a support, " .. scheme .. ": where it went", e.kinetic + e.stored + e.dissipated, e.external, { relative = 1e-2 })
  assert(e.dissipated > 0.3 * e.external)
end

-- A ball strikes a free sheet while both fall: their momentum is the ball's and what the weight of both adds in time.
for _, scheme in ipairs { "explicit", "implicit" } do
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.04, nx = 6, ny = 4 }
  local card = common.sheet { young = 1e6, density = 500, thickness = 0.5e-3, bending = { warp = 30e-6, weft = 20e-6, twist = 10e-6 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local mass, speed = 1e-3, 0.15
  local ball = fabric.rigid.sphere { radius = 0.01, centre = { 0.024, 0.022, 0.0105 }, mass = mass }
  m:contact { between = { ball, "all" }, friction = 0.3 }
  m:velocity(ball, { x = 0.1, z = -speed }):gravity { 0, 0, -9.81 }
  local a = fabric.dynamic { model = m, duration = 8e-3, scheme = scheme, step = scheme == "implicit" and 8e-5 or nil }:solve()
  local of_cloth, v = 0, a:field "vz"
  local weight = {}
  for i = 1, #mesh.nodes do
    local X = mesh.nodes[i]
    local edge = function(x, size) return (x < 1e-9 or x > size - 1e-9) and 0.5 or 1 end
    weight[i] = 500 * 0.5e-3 * 1e-4 * edge(X[1], 0.06) * edge(X[2], 0.04)
    of_cloth = of_cloth + weight[i] * v[i]
  end
  local vz = select(6, a:body(ball))
  assert(vz > -0.95 * (speed + 9.81 * a.time), "it has struck")
  checks("struck, " .. scheme .. ": momentum", of_cloth + mass * vz, -mass * speed - (mass + 500 * 0.5e-3 * 0.06 * 0.04) * 9.81 * a.time, { relative = 1e-6 })
end
checks()
