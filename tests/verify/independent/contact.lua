-- Contact against closed forms in every scheme and at several steps: cloth that lies, falls, sticks and slides on a plane, on facets and on a
-- turntable; quadrilaterals and triangles. The short form has fewer sizes of steps.
--
-- A sheet of areal mass s lies at a depth y with kappa y^2 / (2 o) = s g cos(a), where the stiffness comes up over o, a fifth of the way from
-- half of the thickness to the floor (areal mass over 1500 kg/m3, half of it on a body).
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()
local g, thickness, density, kappa = 9.81, 0.5e-3, 420, 3e8
local sigma = thickness * density
local onset = 0.2 * (thickness / 2 - sigma / 1500 / 2)
local card = common.sheet { warp = 8e6, weft = 6e6, shear = 2e6, poisson = { 0, 0 }, density = density, thickness = thickness }
local function depth(pressure) return math.sqrt(2 * onset * pressure / kappa) end

-- A sheet above a plane z = 0 by half of its thickness and `height`.
local function lies(height, triangles)
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.045, nx = 4, ny = 3, triangles = triangles, origin = { 0, 0, thickness / 2 + height } }
  return fabric.model { mesh = mesh, card = card, warp = 0 }, mesh
end
-- The mean of a component over all nodes, which is not that of the masses at the edge, but moves like it when the sheet moves as a whole.
local function mean(run, component)
  local sum, values = 0, run:field(component)
  for _, value in ipairs(values) do sum = sum + value / #values end
  return sum
end
local function plane() return fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } } end
local runs = { { "explicit" }, { "implicit", 1e-3 }, { "implicit", 1e-4, true } }
local whole = os.getenv "FABRICSH_TEST_LONG"
if whole then runs[4] = { "implicit", 2e-5 } end

-- On an incline it sticks while tan(a) < mu, and stays where it is; else it goes with g (sin(a) - mu cos(a)), and friction takes mu times the
-- weight's part across the incline times the way.
for _, case in ipairs { { 17, 0.42 }, { 24, 0.46 }, { 33, 0.42 } } do
  local a, mu = math.rad(case[1]), case[2]
  for _, how in ipairs(runs) do
    local m = lies(-depth(sigma * g * math.cos(a)), how[3])
    m:gravity { g * math.sin(a), 0, -g * math.cos(a) }:contact { between = { plane(), "all" }, friction = mu, stiffness = kappa }
    local T = 0.02
    local run = fabric.dynamic { model = m, duration = T, scheme = how[1], step = how[2] }
    run:solve()
    local node, name = run:node(8), ("incline %d, friction %g, %s %g"):format(case[1], mu, how[1], how[2] or 0)
    local want = g * (math.sin(a) - mu * math.cos(a))
    if want < 0 then
      checks(name .. ": moved, m", node.ux, 0, { absolute = 1e-6 })
    else
      checks(name .. ": acceleration", node.vx / T, want, { relative = 0.005 })
      checks(name .. ": taken by friction, J", run.energy.friction, mu * sigma * 0.06 * 0.045 * g * math.cos(a) * node.ux, { relative = 0.01 })
    end
    checks(name .. ": ledger", run.energy.error, 0, { absolute = 1e-3 })
  end
end

-- The same in statics, whatever the number of steps: gravity turns until it has its slope, then nothing changes.
for _, steps in ipairs(whole and { 8, 40, 160 } or { 8, 40 }) do
  local a = math.rad(20)
  local m = lies(-depth(sigma * g * math.cos(a)), steps == 40)
  m:fix("all", "rotation"):gravity { fabric.history { { 0, 0 }, { 0.25, g * math.sin(a) } }, 0, -g * math.cos(a) }
  m:contact { between = { plane(), "all" }, friction = 0.42, stiffness = kappa }
  local run = fabric.static { model = m, duration = 1, step = 1 / steps }
  local before
  run:every("step", function(r) if r.time >= 0.25 and not before then before = r:node(8).ux end end)
  run:solve()
  checks(("incline 20, static, %d steps: moved, m"):format(steps), run:node(8).ux, 0, { absolute = 1e-6 })
  checks(("incline 20, static, %d steps: moved under a constant load, m"):format(steps), run:node(8).ux - before, 0, { absolute = 1e-12 })
end

-- On a turntable it goes round with it as long as w^2 r < mu g, through an eighth of a turn.
for _, how in ipairs { { "explicit" }, { "implicit", 1e-3 }, { "implicit", 2e-4, true } } do
  local m, mesh = lies(-depth(sigma * g), how[3])
  local table_, w, T = plane(), 7, math.pi / 4 / 7
  m:velocity("all", function(x, y) return { x = -w * y, y = w * x } end):gravity { 0, 0, -g }
  m:contact { between = { table_, "all" }, friction = 0.5, stiffness = kappa }
  m:move(table_, { turn = { axis = { 0, 0, 1 }, centre = { 0, 0, 0 }, angle = fabric.history { { 0, 0 }, { 1, math.deg(w) } } } })
  local run = fabric.dynamic { model = m, duration = T, scheme = how[1], step = how[2] }
  run:solve()
  local off = 0
  for i = 1, #mesh.nodes do
    local X, at = mesh.nodes[i], run:node(i)
    local x, y = (X[1] - X[2]) / math.sqrt(2), (X[1] + X[2]) / math.sqrt(2)
    off = math.max(off, math.sqrt((at.x - x) ^ 2 + (at.y - y) ^ 2))
  end
  checks(("turntable, %s %g: off its place, m"):format(how[1], how[2] or 0), off, 0, { absolute = 1e-6 })
end

-- Drawn slowly over a floor of facets, whose edges its nodes pass: the pull is mu times the weight all the way.
for _, triangles in ipairs { false, true } do
  local m = lies(-depth(sigma * g), triangles)
  local floor = fabric.rigid.surface { mesh = fabric.mesh.rectangle { width = 0.2, height = 0.12, nx = 23, ny = 11, triangles = true, origin = { -0.05, -0.03, 0 } } }
  m:fix("all", "rotation"):fix("all", "y"):gravity { 0, 0, -g }:contact { between = { floor, "all" }, friction = 0.37, stiffness = kappa }
  m:move("left", { x = fabric.history { { 0, 0 }, { 1, 0.012 } } })
  local run = fabric.static { model = m, duration = 1, step = 0.04 }
  local low, high = math.huge, -math.huge
  run:every("step", function(r)
    if r.time < 0.3 then return end
    local pull = r:reaction("left")
    low, high = math.min(low, pull), math.max(high, pull)
  end)
  run:solve()
  local want = 0.37 * sigma * 0.06 * 0.045 * g
  checks("drawn over facets: least pull, N", low, want, { relative = 0.01 })
  checks("drawn over facets: largest pull, N", high, want, { relative = 0.01 })
end

-- It lies at rest for a second, and stays.
for _, step in ipairs { 1e-2, 1e-3 } do
  for _, height in ipairs((whole or step == 1e-2) and { 0, -depth(sigma * g), -1e-6 } or { 0 }) do
    local m = lies(height, height == 0)
    m:gravity { 0, 0, -g }:contact { between = { plane(), "all" }, friction = 0.3, stiffness = kappa }
    local run = fabric.dynamic { model = m, duration = 1, scheme = "implicit", step = step }
    run:solve()
    local name = ("rest, step %g, from %g m"):format(step, height)
    -- of a node at the edge with three triangles, whose share of the area is that of its mass
    checks(name .. ": depth, m", -run:node(2).uz - height, depth(sigma * g), { absolute = 1e-9 })
    checks(name .. ": kinetic energy over the weight's over a thickness", run.energy.kinetic / (sigma * 0.06 * 0.045 * g * thickness), 0, { absolute = 1e-5 })
    checks(name .. ": ledger", run.energy.error, 0, { absolute = 1e-3 })
  end
end

-- Falling flat it leaves with at most what it came with, and with the restitution e where steps are short against the contact's period. The
-- mass of a quadrilateral's nodes is not in proportion to the areas of its triangles, with which they press; that of triangles is.
local fall = 1.5e-3

-- The speed with which a mass leaves the contact that it meets with `came`: the stiffness rises over the onset, and an approach is damped by a
-- share zeta of the critical damping with the stiffness of the moment; zeta is that with which a constant stiffness gives e.
local function leaves(e, came)
  local low, high = 0, 1
  for _ = 1, 60 do
    local zeta = (low + high) / 2
    if math.exp(-zeta * math.acos(zeta) / math.sqrt(1 - zeta * zeta)) > e then low = zeta else high = zeta end
  end
  local y, v, dt = 0, came, 2e-8
  repeat
    local k = kappa * math.min(1, math.max(0, y) / onset)
    local p = y < onset and kappa * y * y / 2 / onset or kappa * (y - onset / 2)
    v = v + dt * (g - (p + (v > 0 and e < 1 and 2 * low * math.sqrt(sigma * k) * v or 0)) / sigma)
    y = y + v * dt
  until y <= 0
  return -v
end

for _, e in ipairs { 1, 0.5 } do
  for _, how in ipairs { { "explicit", 5e-7 }, { "implicit", 1e-3 }, { "implicit", 1e-4 }, { "implicit", 2e-6 } } do
    local long = how[1] == "implicit" and how[2] > 1e-5
    local m = lies(fall, how[2] ~= 1e-4)
    m:gravity { 0, 0, -g }:contact { between = { plane(), "all" }, restitution = e, stiffness = kappa }
    local came, T = math.sqrt(2 * g * fall), math.sqrt(2 * fall / g)
    if how[2] == 2e-6 then m = lies(2e-5, true):velocity("all", { z = -came }):contact { between = { plane(), "all" }, restitution = e, stiffness = kappa } end
    -- A bounce in some 25 steps loses 3 % of its speed by the scheme that damps beside contact.
    local radius = how[2] == 2e-6 and 1 or nil
    local run = fabric.dynamic { model = m, duration = how[2] == 2e-6 and 4e-4 or T + 0.004, scheme = how[1], step = how[2], spectral_radius = radius }
    local up = -1
    if how[2] ~= 2e-6 then run:advance(0.9 * T) end -- it falls freely
    run:every("step", function(r) up = math.max(up, mean(r, "vz")) end)
    run:solve()
    local name = ("fall, restitution %g, %s %g"):format(e, how[1], how[2] or 0)
    if long then
      checks(name .. ": leaves with more than it came with, as a share", math.max(0, up / came - 1), 0, { absolute = 1e-3 })
    else
      checks(name .. ": leaves, m/s", up, leaves(e, came), { relative = 0.03 })
    end
    checks(name .. ": ledger", run.energy.error, 0, { absolute = 1e-2 })
  end
end

-- Let down from a quarter of a millimetre onto an incline: it settles and sticks, or goes with the closed form's acceleration.
for _, how in ipairs { { "explicit" }, { "implicit", 5e-4 } } do
  local a = math.rad(30)
  for _, mu in ipairs { 0.7, 0.3 } do
    local m = lies(0.25e-3, how[1] == "explicit")
    m:gravity { g * math.sin(a), 0, -g * math.cos(a) }:contact { between = { plane(), "all" }, friction = mu, stiffness = kappa }
    local run = fabric.dynamic { model = m, duration = 0.1, scheme = how[1], step = how[2] }
    local at, v
    run:every(0.06, function(r) if r.time > 0.05 and not at then at, v = r:node(8), mean(r, "vx") end end)
    run:solve()
    local node, name = run:node(8), ("let down, friction %g, %s"):format(mu, how[1])
    if mu == 0.7 then
      checks(name .. ": way, m", node.ux, 0, { absolute = 2e-3 })
      checks(name .. ": way in the last 40 ms, m", node.ux - at.ux, 0, { absolute = 1e-6 })
    else
      checks(name .. ": acceleration", (mean(run, "vx") - v) / 0.04, g * (math.sin(a) - mu * math.cos(a)), { relative = 0.02 })
    end
  end
end
checks()
