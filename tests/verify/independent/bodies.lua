-- Rigid bodies in contact against closed forms: bodies that roll, turn by many turns, meet each other, are light and fast, stick and slide;
-- quadrilaterals and triangles, in every scheme where it applies. The short form has fewer pairs of elements and schemes, turns and steps.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()
local g, exact = 9.81, { absolute = 1e-12 }
local function cloth(thickness, density)
  return common.sheet { warp = 7e6, weft = 5e6, shear = 2e6, poisson = { 0, 0 }, density = density, thickness = thickness }
end
local schemes = { { "explicit" }, { "implicit", 5e-5 } }
local long = os.getenv "FABRICSH_TEST_LONG"
local function dynamic(m, T, how)
  return fabric.dynamic { model = m, duration = T, scheme = how[1], step = how[2], ledger_limit = 1 }
end

-- A ball and a rod that spin on held cloth come to roll with v = w R, R up to their own surface; 2/7 of w0 R of the ball is left.
for _, triangles in ipairs { false, true } do
  for _, how in ipairs(long and schemes or { schemes[triangles and 2 or 1] }) do
    local t, R, spin, mu = 0.6e-3, 4e-3, 1100, 0.35
    local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.012, nx = 10, ny = 4, triangles = triangles, origin = { -0.004, -0.006, 0 } }
    local m = fabric.model { mesh = mesh, card = cloth(t, 350), points = 1, warp = 0 }
    m:fix("all", "x y z rotation"):gravity { 0, 0, -g }
    local ball = fabric.rigid.sphere { radius = R, centre = { 0, 0.0011, R + t / 2 }, mass = 0.003 }
    m:contact { between = { ball, "all" }, friction = mu, stiffness = 1e11 }:velocity(ball, { spin = { 0, spin, 0 } })
    local run = dynamic(m, 0.011, how)
    run:solve()
    local _, _, _, vx, _, _, _, wy = run:body(ball)
    local name = ("ball that comes to roll, %s, %s: "):format(how[1], triangles and "triangles" or "quadrilaterals")
    checks(name .. "v over w R", vx / (math.rad(wy) * R), 1, { relative = 3e-3 })
    checks(name .. "v over 2/7 of the first w R", vx / (2 / 7 * math.rad(spin) * R), 1, { relative = 0.02 })
  end
end

-- A rod turns forwards under a strip: it drags as in small steps, forwards, however far it would turn in a step. That is nearly mu N, less what
-- the strip leans against it.
local small = {}
for _, degrees in ipairs(long and { 9, 40, 200, 350, 720 } or { 9, 200, 720 }) do
  for _, how in ipairs { "static", "implicit" } do
    local t, R = 0.5e-3, 7e-3
    local mesh = fabric.mesh.rectangle { width = 0.05, height = 0.008, nx = 10, ny = 2,  origin = { -0.025, -0.004, 0 } }
    local m = fabric.model { mesh = mesh, card = cloth(t, 400), points = 1, warp = 0 }
    m:fix("all", "y rotation"):fix("left", "x z"):fix("right", "x z")
    local rod = fabric.rigid.cylinder { radius = R, from = { 0, -0.02, -R - t / 2 }, to = { 0, 0.02, -R - t / 2 } }
    m:contact { between = { rod, "all" }, friction = 0.25 }
    local rise = fabric.history { { 0, 0 }, { 0.3, 1.5e-3 }, { 0.6, 1.5e-3 } }
    m:move(rod, { z = rise, turn = { axis = { 0, 1, 0 }, angle = fabric.history { { 0, 0 }, { 0.3, 0 }, { 0.6, 3 * degrees } } } })
    local run = how == "static" and fabric.static { model = m, duration = 0.6, step = 0.1 } or
      fabric.dynamic { model = m, duration = 0.6, step = 0.1, scheme = "implicit", ledger_limit = 1e9 }
    run:solve()
    local x, _, z = run:reaction(rod)
    local drag = x / (0.25 * math.abs(z))
    small[how] = small[how] or drag
    checks(("rod that turns, %s, %d degrees a step: drag over that in small steps"):format(how, degrees), drag / small[how], 1, { relative = how == "static" and 0.01 or 0.3 })
    checks(("rod that turns, %s, %d degrees a step: drag over mu N"):format(how, degrees), drag, 0.93, { relative = how == "static" and 0.02 or 0.3 })
  end
end

-- A paddle sweeps the free end of a strip aside, by a table and by a function of time, in a step of a whole turn.
for _, how in ipairs { "table", "function" } do
  local mesh = fabric.mesh.rectangle { width = 0.04, height = 0.01, nx = 8, ny = 2, triangles = how == "table", origin = { 0, -0.005, 0 } }
  local m = fabric.model { mesh = mesh, card = cloth(0.5e-3, 400), warp = 0 }
  m:fix("left", "x y z rotation")
  local blade = fabric.mesh.rectangle { width = 0.02, height = 0.012, nx = 2, ny = 2 }:map(function(x, y) return 0.034, x - 0.01, -0.029 + y end)
  local paddle = fabric.rigid.surface { mesh = blade, name = "paddle" }
  m:contact { between = { paddle, "all" } }
  local angle = how == "table" and fabric.ramp(360, 1) or function(t) return 360 * t end
  m:move(paddle, { turn = { axis = { 0, 1, 0 }, angle = angle, centre = { 0.034, 0, -0.0135 } } })
  local run, most = fabric.static { model = m, duration = 1, step = 1, method = "either" }, 0
  run:every("step", function(r)
    local x, y, z = r:reaction(paddle)
    most = math.max(most, math.sqrt(x * x + y * y + z * z))
  end)
  run:solve()
  checks("paddle, " .. how .. ": it pushes the strip", most > 5e-5 and 1 or most, 1, exact)
  checks("paddle, " .. how .. ": steps, at least twelve", math.min(#run.steps, 12), 12, exact)
end

-- Two balls meet aslant, so shortly that the line of their centres hardly turns meanwhile: along the line of their centres the speed of approach is turned round and falls to the share e, across it nothing
-- changes; momentum is conserved, and lost energy is in the balance.
local function stage(triangles)
  local mesh = fabric.mesh.rectangle { width = 1e-3, height = 1e-3, nx = 4, ny = 4, triangles = triangles, origin = { 1, 1, 1 } }
  return fabric.model { mesh = mesh, card = cloth(0.5e-3, 400), points = 1, warp = 0 }:fix("all", "x y z rotation")
end
local function sum(a, b, c, d) return { a * c[1] + b * d[1], a * c[2] + b * d[2], a * c[3] + b * d[3] } end
for _, e in ipairs { 1, 0.7 } do
  for _, how in ipairs { { "explicit" }, { "implicit", 5e-8 } } do
    local a, b, m1, m2 = 6e-3, 9e-3, 0.004, 0.011
    local n = { 0.8, 0.36, 0.48 }
    local m = stage(how[1] == "implicit")
    local d = a + b + 2e-5
    local one = fabric.rigid.sphere { radius = a, centre = { 0, 0, 0 }, mass = m1, name = "one" }
    local two = fabric.rigid.sphere { radius = b, centre = { d * n[1], d * n[2], d * n[3] }, mass = m2, name = "two" }
    local v, w = { 1.3, -0.2, 0.4 }, { -0.7, 0.3, 0.1 }
    m:contact { between = { one, two }, restitution = e }
    m:velocity(one, { x = v[1], y = v[2], z = v[3] }):velocity(two, { x = w[1], y = w[2], z = w[3] })
    local run = dynamic(m, 8e-5, how)
    run:solve()
    local _, _, _, x1, y1, z1 = run:body(one)
    local _, _, _, x2, y2, z2 = run:body(two)
    local came = (v[1] - w[1]) * n[1] + (v[2] - w[2]) * n[2] + (v[3] - w[3]) * n[3]
    local impulse = (1 + e) * came * m1 * m2 / (m1 + m2)
    local name = ("two balls, %s, restitution %g: "):format(how[1], e)
    local tight = { absolute = e < 1 and 0.06 or how[1] == "explicit" and 0.03 or 0.035 }
    for i, got in ipairs { x1, y1, z1 } do checks(name .. "velocity of one, " .. i, got, v[i] - impulse / m1 * n[i], tight) end
    for i, got in ipairs { x2, y2, z2 } do checks(name .. "velocity of two, " .. i, got, w[i] + impulse / m2 * n[i], tight) end
    local now, before = sum(m1, m2, { x1, y1, z1 }, { x2, y2, z2 }), sum(m1, m2, v, w)
    for i = 1, 3 do checks(name .. "momentum " .. i, now[i], before[i], { absolute = 1e-9 * m1 }) end
    checks(name .. "lost, J", run.energy.impact, (1 - e * e) / 2 * came ^ 2 * m1 * m2 / (m1 + m2), { absolute = 0.08 * m1 * came ^ 2 / 2 })
    checks(name .. "ledger", run.energy.error, 0, { absolute = 2e-3 })
  end
end

-- A ball, and a rod that falls level, bounce from a floor that stands, and from one that comes up at 0.5 m/s.
for _, how in ipairs { { "explicit" }, { "implicit", 1e-7 } } do
  for _, up in ipairs { 0, 0.5 } do
    for _, rod in ipairs { false, true } do
      local m = stage(rod)
      local R = 5e-3
      local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0.6, 0, 0.8 } }
      local at = R + 2e-5
      local body = rod and fabric.rigid.cylinder { radius = R, from = { at * 0.6, -0.01, at * 0.8 }, to = { at * 0.6, 0.01, at * 0.8 }, mass = 0.006 } or
        fabric.rigid.sphere { radius = R, centre = { at * 0.6, 0, at * 0.8 }, mass = 0.006 }
      m:contact { between = { body, floor }, restitution = 1 }:velocity(body, { x = -0.6 * 1.2, z = -0.8 * 1.2 })
      if up > 0 then m:move(floor, { x = fabric.ramp(0.6 * up, 1), z = fabric.ramp(0.8 * up, 1) }) end
      local run = dynamic(m, rod and 5e-4 or 1e-4, how)
      run:solve()
      local _, _, _, x, _, z = run:body(body)
      checks(("%s on a floor that comes with %g m/s, %s: speed after"):format(rod and "rod" or "ball", up, how[1]), 0.6 * x + 0.8 * z, 1.2 + 2 * up, { relative = how[1] == "explicit" and 5e-3 or 0.04 })
    end
  end
end

-- A ball bounces from facets, over a face and over an edge of them, from a disc and from a rod that stand, and does not turn.
for _, how in ipairs { { "explicit" }, { "implicit", 1e-7 } } do
  local R, r, v = 4e-3, 3e-3, 0.9
  local plate = fabric.mesh.rectangle { width = 0.02, height = 0.016, nx = 2, ny = 2, origin = { -0.01, -0.008, 0 } }
  for name, case in pairs {
    face = { fabric.rigid.surface { mesh = plate }, 0.0031, 0.0044 },
    edge = { fabric.rigid.surface { mesh = plate }, 0.0042, 0 },
    disc = { fabric.rigid.disc { radius = 0.01, centre = { 0, 0, -r }, normal = { 0, 0, 1 }, edge = r }, 0.0012, 0.0007 },
    rod = { fabric.rigid.cylinder { radius = r, from = { -0.01, 0, -r }, to = { 0.01, 0, -r } }, 0.0013, 0 },
    ball = { fabric.rigid.sphere { radius = r, centre = { 0, 0, -r } }, 0, 0 },
  } do
    local m = stage(how[1] == "explicit")
    local ball = fabric.rigid.sphere { radius = R, centre = { case[2], case[3], R + 2e-5 }, mass = 0.002 }
    m:contact { between = { ball, case[1] }, restitution = 1 }:velocity(ball, { z = -v })
    local run = dynamic(m, 1.2e-4, how)
    run:solve()
    local _, _, _, vx, vy, vz, wx, wy, wz = run:body(ball)
    local what = ("ball from a %s, %s: "):format(name, how[1])
    checks(what .. "speed after", vz, v, { relative = how[1] == "explicit" and 2e-3 or 0.03 })
    checks(what .. "speed aside", vx ^ 2 + vy ^ 2, 0, { absolute = 1e-12 })
    checks(what .. "spin", wx ^ 2 + wy ^ 2 + wz ^ 2, 0, { absolute = 1e-12 })
  end
end

-- Two balls with a free sheet between them: all momentum is kept.
for _, how in ipairs { { "explicit" }, { "implicit", 1e-5 } } do
  local mesh = fabric.mesh.rectangle { width = 0.024, height = 0.02, nx = 6, ny = 5, triangles = how[1] == "implicit", origin = { -0.012, -0.01, 0 } }
  local m = fabric.model { mesh = mesh, card = cloth(0.5e-3, 400), points = 1, warp = 0 }
  local low = fabric.rigid.sphere { radius = 6e-3, centre = { 0.0003, 0.0002, -6e-3 - 0.27e-3 }, mass = 0.002, name = "low" }
  local high = fabric.rigid.sphere { radius = 5e-3, centre = { -0.0002, 0.0004, 5e-3 + 0.27e-3 }, mass = 0.003, name = "high" }
  m:contact { between = { low, high, "all" }, restitution = 0.8 }:velocity(low, { z = 0.3 }):velocity(high, { z = -0.4 })
  local run = dynamic(m, 1e-3, how)
  run:solve()
  local pz = 0
  for _, body in ipairs { { low, 0.002 }, { high, 0.003 } } do
    local _, _, _, _, _, vz = run:body(body[1])
    pz = pz + body[2] * vz
  end
  local area = 0.024 * 0.02 * 0.5e-3 * 400
  local v = run:mean("vz")
  checks("sheet between two balls, " .. how[1] .. ": both still apart", (run:gap() > 0) and 1 or 0, 1, exact)
  checks("sheet between two balls, " .. how[1] .. ": momentum", (pz + area * v) / (0.002 * 0.3 - 0.003 * 0.4), 1, { absolute = 0.05 })
end

-- On an incline static friction holds up to its angle, if the weight comes slowly; beyond that it slides with the kinetic one.
for _, how in ipairs { { "explicit" }, { "implicit", 1e-4 }, long and { "implicit", 1e-5 } or nil } do
  for _, case in ipairs { { 21, false }, { 27, true } } do
    local t, rho, kappa = 0.5e-3, 420, 3e8
    local sigma, a, static, kinetic = t * rho, math.rad(case[1]), 0.44, 0.31
    local onset = 0.2 * (t / 2 - sigma / 1500 / 2)
    local mesh = fabric.mesh.rectangle { width = 0.05, height = 0.03, nx = 4, ny = 3, triangles = how[2] ~= 1e-4, origin = { 0, 0, t / 2 - math.sqrt(2 * onset * sigma * g * math.cos(a) / kappa) } }
    local m = fabric.model { mesh = mesh, card = cloth(t, rho), warp = 0 }
    local along = g * math.sin(a)
    m:gravity { case[2] and along or fabric.ramp(along, 4e-3), 0, -g * math.cos(a) }
    m:contact { between = { fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }, "all" }, friction = { static = static, kinetic = kinetic }, stiffness = kappa }
    local T = how[2] == 1e-5 and 0.008 or 0.015
    local run = dynamic(m, T, how)
    run:solve()
    local name = ("incline of %d degrees, static 0.44, kinetic 0.31, %s %g: "):format(case[1], how[1], how[2] or 0)
    if case[2] then
      checks(name .. "acceleration", run:node(7).vx / T, g * (math.sin(a) - kinetic * math.cos(a)), { relative = 0.01 })
    else
      checks(name .. "moved, m", run:node(7).ux, 0, { absolute = 1e-6 })
    end
    checks(name .. "ledger", run.energy.error, 0, { absolute = 5e-3 })
  end
end

-- In statics a strip that is drawn over a floor comes loose at the static and goes on at the kinetic friction. The nodes of quadrilaterals do not
-- press in proportion to their areas, so that some come loose before others: less so with one point through the thickness, whose shear holds the strip flat.
for _, triangles in ipairs { false, true } do
  local t, rho = 0.5e-3, 420
  local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.02, nx = 3, ny = 2, triangles = triangles, origin = { 0, 0, t / 2 - 1e-6 } }
  local m = fabric.model { mesh = mesh, card = cloth(t, rho), points = 1, warp = 0 }
  m:fix("all", "rotation"):fix("all", "y"):gravity { 0, 0, -g }
  m:contact { between = { fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }, "all" }, friction = { static = 0.5, kinetic = 0.3 }, stiffness = 3e8 }
  m:move("all", { x = fabric.history { { 0, 0 }, { 1, 4e-8 } } })
  local run, most = fabric.static { model = m, duration = 1, step = 0.01 }, 0
  local weight = t * rho * 0.03 * 0.02 * g
  run:every("step", function(r) most = math.max(most, (r:reaction("all"))) end)
  run:solve()
  local name = triangles and "drawn, triangles: " or "drawn, quadrilaterals: "
  checks(name .. "largest pull over the weight", most / weight, 0.5, { relative = triangles and 0.01 or 0.08 })
  checks(name .. "pull at the end over the weight", run:reaction("all") / weight, 0.3, { relative = 0.01 })
end

-- A light ball keeps the ledger of an explicit run.
for _, case in ipairs { { 0.1e-3, 5, false }, { 0.2e-3, 9, true } } do
  local R, v = case[1], case[2]
  local mesh = fabric.mesh.rectangle { width = 0.05, height = 0.05, nx = 10, ny = 10, triangles = case[3], origin = { -0.025, -0.025, 0 } }
  local m = fabric.model { mesh = mesh, card = cloth(0.5e-3, 400), points = 1, warp = 0 }
  m:fix("boundary", "x y z rotation")
  local ball = fabric.rigid.sphere { radius = R, centre = { 0.0007, 0.0011, R + 0.4e-3 }, mass = 4 / 3 * math.pi * R ^ 3 * 7800 }
  m:contact { between = { ball, "all" }, friction = 0.2 }:velocity(ball, { z = -v })
  local run = fabric.dynamic { model = m, duration = 2e-4 }
  run:solve()
  local _, _, _, _, _, vz = run:body(ball)
  checks(("ball of %g m at %g m/s: no faster than it came"):format(R, v), math.max(math.abs(vz), v), v, { relative = 1e-3 })
  checks(("ball of %g m at %g m/s: ledger"):format(R, v), run.energy.error, 0, { absolute = 5e-3 })
end

-- The speed that a run says it stops is stopped: a coarse sheet on a fine plate that it overhangs.
local function lands(speed, triangles)
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.08, nx = 2, ny = 2, triangles = triangles, origin = { -0.03, -0.04, 0 } }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), points = 1, warp = 0 }
  local plate = fabric.mesh.rectangle { width = 0.03, height = 0.04, nx = 30, ny = 30, origin = { -0.015, -0.02, 0 } }:map(function(x, y) return x, y, -0.2e-3 end)
  m:velocity("all", { z = -speed }):contact { between = { fabric.rigid.surface { mesh = plate }, "all" }, friction = 0.3 }
  local run = fabric.dynamic { model = m, duration = math.min(5e-3, 1e-3 / speed), ledger_limit = 1 }
  return pcall(run.solve, run)
end
for _, triangles in ipairs { false, true } do
  local done, why = lands(triangles and 9 or 5, triangles)
  checks("lands too fast: refused", done and 1 or 0, 0, exact)
  local said = tonumber(tostring(why):match "comes with ([%d.e+-]+) m/s anywhere")
  checks("the speed that is said is stopped", lands(said, triangles) and 1 or 0, 1, exact)
end

-- A stiff sheet lies on four needles with round tips, or on two wires, of 0.6 and of 0.04 mm: each carries its share of the weight, in all schemes;
-- in the short form relaxation and explicit runs on needles alone.
for _, case in ipairs { { 0.3e-3, false }, { 0.02e-3, true } } do
  local r, wires = case[1], case[2]
  for _, how in ipairs((not wires or long) and { "static", "relaxation", "implicit", "explicit" } or { "static", "implicit" }) do
    local L, t, rho, off = 0.04, 0.5e-3, 400, 0.0093
    local mesh = fabric.mesh.rectangle { width = L, height = L, nx = 8, ny = 8, triangles = how == "implicit", origin = { -L / 2, -L / 2, t / 2 } }
    mesh:set("middle", function(x, y) return math.abs(x) < 1e-9 and math.abs(y) < 1e-9 end)
    mesh:set("side", function(x, y) return math.abs(x - L / 2) < 1e-9 and math.abs(y) < 1e-9 end)
    local card = fabric.svk { young = 5e6, poisson = 0, density = rho, thickness = t, name = "sheet", bending = { warp = 3e-4, weft = 3e-4, twist = 1.5e-4 } }
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }
    m:fix("middle", "x y"):fix("side", "y"):gravity { 0, 0, -g }
    local carriers, top = {}, 1e-7
    for _, x in ipairs { -off, off } do
      for _, y in ipairs(wires and { 0 } or { -off, off }) do
        local one = fabric.rigid.cylinder { radius = r, from = { x, wires and -L or y, top - r }, to = { x, wires and L or y, wires and top - r or -0.02 } }
        m:contact { between = { one, "all" } }
        carriers[#carriers + 1] = one
      end
    end
    local method = how == "relaxation" and how or nil
    local run = (how == "static" or method) and fabric.static { model = m, duration = 1, step = 0.5, method = method } or
      fabric.dynamic { model = m, duration = 0.1, scheme = how, step = how == "implicit" and 1e-3 or nil, damping = { mass = 150 } }
    run:solve()
    for i, one in ipairs(carriers) do
      local share = select(3, run:reaction(one)) / (rho * t * L * L * g)
      checks(("%s of %g m, %s: share of the weight of %d"):format(wires and "wire" or "needle", r, how, i), share * #carriers, 1, { relative = (method or how == "static") and 1e-5 or 4e-3 })
    end
  end
end

-- Sliding cloth, and bodies that meet, go on with the same bits from a snapshot.
for _, how in ipairs { { "explicit" }, { "implicit", 2e-6 } } do
  local t = 0.5e-3
  local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.015, nx = 4, ny = 3, triangles = how[1] == "explicit", origin = { 0, 0, t / 2 - 1e-6 } }
  local m = fabric.model { mesh = mesh, card = cloth(t, 420), warp = 0 }
  local ball = fabric.rigid.sphere { radius = 3e-3, centre = { -0.02, 0.001, 3.02e-3 }, mass = 0.002 }
  local shot = fabric.rigid.sphere { radius = 2e-3, centre = { -0.02, 0.0012, 9e-3 }, mass = 0.001, name = "shot" }
  local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:gravity { 6, 0, -g }:contact { between = { floor, "all" }, friction = { static = 0.5, kinetic = 0.2 } }
  m:contact { between = { floor, ball, shot } }:velocity(shot, { z = -3 }):velocity("all", { x = 0.02 })
  local run = dynamic(m, 1e-3, how)
  run:advance(4e-4)
  local half = run:snapshot()
  local function ends()
    run:solve()
    local _, _, z, _, _, vz = run:body(ball)
    return { run:node(6).x, run:node(9).vx, z, vz, run.energy.friction, run.energy.impact }
  end
  local one = ends()
  run:restore(half)
  for i, x in ipairs(ends()) do checks(("from a snapshot, %s, %d"):format(how[1], i), x, one[i], { absolute = 0 }) end
end
checks()
