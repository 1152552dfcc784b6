-- Closed forms of contact in every scheme: static runs by the default method and by relaxation, implicit and explicit motion so slow that inertia
-- counts for nothing; quadrilaterals and triangles; three steps where a scheme has a choice of them.
--
--   fabricsh scripts/contact/schemes.lua            one step and one kind of elements per scheme and problem, one scheme of motion,
--                                                   and two layers at rest
--   fabricsh scripts/contact/schemes.lua all        every combination (scripts/long/contact/schemes.lua)
--
-- Printed is the largest deviation from the closed form, as a share of it.
-- warns: is at full value at time 0
local fabric = require "fabric"
local every = arg[1] == "all"
local g, thickness, density, kappa = 9.81, 0.4e-3, 600, 1e9
local sigma = density * thickness
local sheet = fabric.svk { young = 1e7, poisson = 0, density = density, thickness = thickness, name = "sheet", bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6 } }
local moves = { implicit = true, explicit = true }
local function plane() return fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } } end
local function rectangle(width, height, nx, ny, x, z, triangles)
  return fabric.mesh.rectangle { width = width, height = height, nx = nx, ny = ny, triangles = triangles, origin = { x, 0, z } }
end

-- The depth at which the pressure p acts: the stiffness rises to kappa over the onset, a fifth of the way from the gap to the floor.
local function depth_at(p, gap, floor_)
  local onset = 0.2 * (gap - floor_)
  local depth = math.sqrt(2 * onset * p / kappa)
  return depth <= onset and depth or p / kappa + onset / 2
end

-- One way of computing a problem: how.scheme, and its step as a share of the duration.
local function analysis(m, how, duration, damping)
  if not moves[how.scheme] then
    return fabric.static { model = m, duration = duration, step = how.step * duration, method = how.scheme == "relaxation" and "relaxation" or nil }
  end
  return fabric.dynamic { model = m, duration = duration, scheme = how.scheme, step = how.step and how.step * duration, damping = damping > 0 and { mass = damping } or nil }
end

-- Runs to the end; the mean of look(run), a list of numbers, over the last tenth, or its value at the end of a static run.
local function measured(run, how, duration, look)
  local sums, count = {}, 0
  local function add(r)
    count = count + 1
    for i, x in ipairs(look(r)) do sums[i] = (sums[i] or 0) + x end
  end
  if moves[how.scheme] then
    run:every(duration / 2000, function(r) if r.time > 0.9 * duration then add(r) end end)
  end
  run:solve()
  if count == 0 then add(run) end
  for i = 1, #sums do sums[i] = sums[i] / count end
  return sums
end

local problems = {}

-- Layers at rest on a plane: each gap carries what lies above it. The shares of the mass and of the area are not alike at the nodes of
-- quadrilaterals, which are not quite flat.
problems[#problems + 1] = { allowed = 0.03, name = "layers at rest: weight on the plane; gaps", solve = function(how, triangles)
  local n, z, bodies, names, T = every and 3 or 2, 0, {}, {}, every and 0.4 or 0.2
  for i = 1, n do
    z = z + (i == 1 and thickness / 2 or thickness) - 1e-7
    bodies[i] = { name = "layer" .. i, card = sheet, warp = 0, mesh = rectangle(0.02, 0.02, 4, 4, 0, z, triangles) }
    names[i] = bodies[i].name .. ".all"
  end
  local m, ground = fabric.model { bodies = bodies }, plane()
  m:contact { between = { ground, "all" }, stiffness = kappa }:contact { between = names, stiffness = kappa }
  m:fix("all", "x y"):gravity { 0, 0, fabric.history { { 0, 0 }, { T / 2, -g } } }
  local nodes = #bodies[1].mesh.nodes
  local found = measured(analysis(m, how, T, 300), how, T, function(r)
    local heights, list, below = r:field "z", { (select(3, r:reaction(ground))) }, 0
    for i = 1, n do
      local mean = 0
      for k = (i - 1) * nodes + 1, i * nodes do mean = mean + heights[k] / nodes end
      list[i + 1], below = (i == 1 and thickness / 2 or thickness) - (mean - below), mean
    end
    return list
  end)
  local ratios = { found[1] / (n * sigma * g * 4e-4) }
  for i = 1, n do
    local share = i == 1 and 0.5 or 1
    ratios[i + 1] = found[i + 1] / depth_at((n - i + 1) * sigma * g, share * thickness, share * sigma / 1500)
  end
  return ratios
end }

-- A strip over half a cylinder, held by the tension T1 at one end: drawn at the other with friction; or both ends free to slide. Facets touch
-- with their middles, which for the friction mu takes mu theta d^2 (1/4 - (1 + mu^2)/12) off the thread's ln(T2/T1), d being the turn of a facet.
local function drum(how, triangles, mu)
  local n, lead, R, width, tension, T = 16, 4, 0.03, 0.01, 10, 0.3
  local turn, half = math.pi / n, math.pi / 2
  local r = (R + 0.498 * thickness) / math.cos(turn / 2)
  local facet, cells = 2 * r * math.sin(turn / 2), n + 2 * lead
  local mesh = rectangle(cells * facet, width, cells, 1, 0, 0, triangles)
  mesh:map(function(s, y)
    local k = s / facet - lead
    local inside = math.max(0, math.min(n, k))
    local angle, beyond = inside * turn - half, (k - inside) * facet
    return r * math.sin(angle) + beyond * math.cos(angle), y, r * math.cos(angle) - beyond * math.sin(angle)
  end)
  local card = fabric.svk { young = 2e8, poisson = 0, density = density, thickness = thickness, name = "tape", bending = { warp = 1e-6, weft = 1e-6, twist = 1e-6 } }
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = function(x, _, z)
    local angle = math.max(-half, math.min(half, math.atan(x, z)))
    return { math.cos(angle), 0, -math.sin(angle) }
  end }
  local body = fabric.rigid.cylinder { radius = R, from = { 0, -width, 0 }, to = { 0, 2 * width, 0 } }
  m:contact { between = { body, "all" }, friction = mu, stiffness = 1e9 }
  m:fix("all", "y"):fix("left", "x"):fix("right", "x")
  m:force("left", { z = fabric.history { { 0, 0 }, { T / 4, -tension * width } } })
  m:move("right", { z = fabric.history { { 0, 0 }, { T / 4, 0 }, { T, -6e-4 * cells * facet } } })
  return measured(analysis(m, how, T, 100), how, T, function(run)
    return { -select(3, run:reaction "right") / (tension * width), select(3, run:reaction(body)) / (2 * tension * width) }
  end)
end
problems[#problems + 1] = { name = "strip drawn over half a cylinder, friction 0.3: T2/T1", solve = function(how, triangles)
  local mu, theta, d = 0.3, math.pi, math.pi / 16
  return { drum(how, triangles, mu)[1] / math.exp(mu * theta * (1 - d ^ 2 * (1 / 4 - (1 + mu ^ 2) / 12))) }
end }
problems[#problems + 1] = { name = "the same without friction: T2/T1; force on the cylinder", solve = function(how, triangles) return drum(how, triangles, 0) end }

-- A sheet drawn from between two that are pressed together.
problems[#problems + 1] = { name = "sheet drawn from between two, friction 0.4: 2 mu N", solve = function(how, triangles)
  local pressure, mu, T = 1000, 0.4, 0.2
  local apart = thickness - 1e-6
  local m = fabric.model { bodies = { { name = "low", mesh = rectangle(0.02, 0.01, 4, 2, 0, 0, triangles), card = sheet, warp = 0 },
                                      { name = "middle", mesh = rectangle(0.035, 0.01, 7, 2, -0.0075, apart, triangles), card = sheet, warp = 0 },
                                      { name = "high", mesh = rectangle(0.02, 0.01, 4, 2, 0, 2 * apart, triangles), card = sheet, warp = 0 } } }
  for _, pair in ipairs { { "low.all", "middle.all" }, { "middle.all", "high.all" } } do m:contact { between = pair, friction = mu, stiffness = kappa } end
  m:fix("low.all", "x y z rotation"):fix("middle.all", "y rotation"):fix("high.all", "x y rotation")
  m:pressure(fabric.history { { 0, 0 }, { T / 2, -pressure } }, "high.all")
  m:move("middle.right", { x = fabric.history { { 0, 0 }, { T / 2, 0 }, { T, 1e-4 } } })
  return measured(analysis(m, how, T, 300), how, T, function(run) return { (run:reaction "middle.right") / (2 * mu * pressure * 0.02 * 0.01) } end)
end }

-- A sheet drawn over a floor of facets, whose edges its nodes pass.
problems[#problems + 1] = { name = "sheet drawn over facets, friction 0.37: mu times the weight", solve = function(how, triangles)
  local mu, T = 0.37, 0.4
  local m = fabric.model { mesh = rectangle(0.06, 0.045, 4, 3, 0, thickness / 2 - 1e-7, triangles), card = sheet, warp = 0 }
  local floor = fabric.rigid.surface { mesh = fabric.mesh.rectangle { width = 0.2, height = 0.12, nx = 23, ny = 11, triangles = true, origin = { -0.05, -0.03, 0 } } }
  m:fix("all", "rotation"):fix("all", "y"):gravity { 0, 0, fabric.history { { 0, 0 }, { 0.1 * T, -g } } }:contact { between = { floor, "all" }, friction = mu, stiffness = 3e8 }
  m:move("left", { x = function(t) -- without a jump in its speed, of which the sheet would ring
    local rising, speed = 0.3 * T, 0.02 / T
    local s = math.max(0, math.min(1, t / rising - 2 / 3))
    return speed * (rising * (s ^ 3 - s ^ 4 / 2) + math.max(0, t - 0.5 * T))
  end })
  return measured(analysis(m, how, T, 0), how, T, function(run) return { (run:reaction "left") / (mu * sigma * 0.06 * 0.045 * g) } end)
end }

-- A sheet that lies on a plane as deep as its weight presses it at this slope.
local function on_incline(angle, triangles)
  local depth = depth_at(sigma * g * math.cos(angle), thickness / 2, sigma / 3000)
  return fabric.model { mesh = rectangle(0.06, 0.045, 4, 3, 0, thickness / 2 - depth, triangles), card = sheet, warp = 0 }
end

-- A sheet on an incline of 20 degrees that holds it: what it moves, over the way that it would slide without friction.
problems[#problems + 1] = { name = "sheet held on an incline, friction 0.42: way over that without friction", still = true, allowed = 1e-5, solve = function(how, triangles)
  local T, angle = 0.1, math.rad(20)
  local m = on_incline(angle, triangles)
  local along = g * math.sin(angle)
  m:fix("all", "rotation"):gravity { moves[how.scheme] and along or fabric.history { { 0, 0 }, { T / 2, along } }, 0, -g * math.cos(angle) }
  m:contact { between = { plane(), "all" }, friction = 0.42, stiffness = kappa }
  local run = analysis(m, how, T, 0)
  run:solve()
  return { run:node(8).ux / (along * T ^ 2 / 2) }
end }

-- A sheet that slides down an incline: its acceleration. Statics has none.
problems[#problems + 1] = { name = "sheet sliding on an incline of 33 degrees, friction 0.42: acceleration", motion = true, solve = function(how, triangles)
  local T, angle, mu = 0.04, math.rad(33), 0.42
  local m = on_incline(angle, triangles)
  m:gravity { g * math.sin(angle), 0, -g * math.cos(angle) }:contact { between = { plane(), "all" }, friction = mu, stiffness = kappa }
  local run = analysis(m, how, T, 0)
  run:solve()
  return { run:node(8).vx / T / (g * (math.sin(angle) - mu * math.cos(angle))) }
end }

-- A sheet that starts pressed by 0.4 of the way to the floor onto a plane, which presses it to 0.6: energy at the end, work of the plane.
problems[#problems + 1] = { name = "sheet pressed by a plane: energy of contact; work of the plane", solve = function(how, triangles)
  local side, gap, T = 0.02, thickness / 2, 0.1
  local range = gap - sigma / 3000
  local onset = 0.2 * range
  local function energy(y) return side ^ 2 * kappa * ((y - onset / 2) ^ 2 / 2 + onset ^ 2 / 24) end
  local m = fabric.model { mesh = rectangle(side, side, 4, 4, 0, gap - 0.4 * range, triangles), card = sheet, warp = 0 }
  local ground = plane()
  m:contact { between = { ground, "all" }, stiffness = kappa }:fix("all", "x y z rotation"):move(ground, { z = fabric.ramp(0.2 * range, T) })
  local run = analysis(m, how, T, 0)
  run:solve()
  return { run.energy.contact / energy(0.6 * range), run.energy.external / (energy(0.6 * range) - energy(0.4 * range)) }
end }

local ways = { static = { 0.1, 0.025, 0.5 }, relaxation = { 0.1, 0.025, 0.5 }, implicit = { 5e-3, 1e-3, 2e-4 }, explicit = { false } }
local order, rows = { "static", "relaxation", "implicit", "explicit" }, {}
print(("%-72s %10s %10s %10s %10s"):format("", table.unpack(order)))
for p, problem in ipairs(problems) do
  local line = {}
  for c, scheme in ipairs(order) do
    local worst, none = 0, problem.motion and c < 3 or not every and c == 3 + p % 2
    for s, step in ipairs(ways[scheme]) do
      for _, triangles in ipairs { false, true } do
        if not none and (every or (s == 1 and triangles == ((p + c) % 2 == 0))) then
          for _, ratio in ipairs(problem.solve({ scheme = scheme, step = step or nil }, triangles)) do
            local off = math.abs(ratio - (problem.still and 0 or 1))
            worst = math.max(worst, off)
          end
        end
      end
    end
    line[c] = none and "-" or ("%.1e"):format(worst)
    if not none then rows[#rows + 1] = { scheme .. ": " .. problem.name, worst, 0, absolute = problem.allowed or 0.01 } end
  end
  print(("%-72s %10s %10s %10s %10s"):format(problem.name, table.unpack(line)))
end
fabric.expect(rows)
