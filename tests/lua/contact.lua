-- Contact from the side of a deck: closed forms of bodies and cloth that meet, energies, restart, and what is refused.
local fabric = require "fabric"
local card = fabric.svk { young = 1e7, poisson = 0, density = 600, thickness = 0.4e-3 }
local sigma = 600 * 0.4e-3

local function fails(f, words)
  local ok, why = pcall(f)
  assert(not ok and tostring(why):find(words, 1, true), 'expected "' .. words .. '", got ' .. tostring(why))
end
local function near(name, got, want, relative)
  assert(math.abs(got - want) <= relative * math.abs(want), string.format("%s: expected %.9g, got %.9g", name, want, got))
end

-- The law of a sheet on a body: gap d0 = t/2, floor sigma/1500/2, stiffness coming up over a fifth of the way.
local d0, floor_ = 0.2e-3, sigma / 1500 / 2
local onset = 0.2 * (d0 - floor_)
local function energy(kappa, depth)
  if depth <= onset then return kappa * depth ^ 3 / (6 * onset) end
  local h = depth - onset
  return kappa * (onset ^ 2 / 6 + h * onset / 2 + h ^ 2 / 2)
end
local function depth_of(kappa, e)
  local low, high = 0, 0.7 * (d0 - floor_)
  for _ = 1, 200 do
    local mid = (low + high) / 2
    if energy(kappa, mid) < e then low = mid else high = mid end
  end
  return low
end

-- A flat sheet over a plane at z = 0, its nodes at height z.
local function over_plane(z, cells, contact)
  local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = cells, ny = cells }
  mesh:map(function(x, y) return x, y, z end)
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local ground = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 }, name = "ground" }
  contact.between = { ground, "all" }
  m:contact(contact)
  return m, ground
end

-- A sheet falls flat on a plane: deepest where the law has taken up its energy, and up again with the same speed.
for _, speed in ipairs { 0.5, 1.5 } do
  local kappa = 4e8
  local m, ground = over_plane(d0 + 2e-5, 4, { stiffness = kappa, restitution = 1 })
  m:velocity("all", { z = -speed })
  local a = fabric.dynamic { model = m, step = 2e-7, duration = 4e-5 / speed + 4 * math.sqrt(sigma / kappa) }
  local deepest, force, gap = 0, 0, math.huge
  a:every("step", function(r)
    deepest = math.max(deepest, d0 - r:node(7).z)
    local _, _, fz = r:reaction(ground)
    force, gap = math.max(force, fz), math.min(gap, (r:gap()))
  end)
  a:solve()
  -- Six triangles meet at this node: a third of each is its share of the mass.
  near("deepest", deepest, depth_of(kappa, sigma * speed ^ 2 / 2), 1e-2) -- its neighbours, some with less, hold it a little
  assert(#a:field "gap" == 25 and a:field "gap"[7] == a:node(7).gap and a:node(7).contact_pressure == 0)
  assert(gap > 0 and gap < d0 - floor_)
  local up = 0
  for i = 1, 25 do up = up + a:node(i).vz / 25 end
  assert(up > 0.9 * speed, up)
  assert(force > 0 and a.energy.guard == 0 and a.energy.error < 1e-3, a.energy.error)
end

-- A sheet on an incline sticks, or slides with g (sin - mu cos).
for _, case in ipairs { { 10, 0.3 }, { 30, 0.3 }, { 30, 0 } } do
  local angle, mu = math.rad(case[1]), case[2]
  local g, kappa = 9.81, 4e8
  local p = sigma * g * math.cos(angle)
  local m = over_plane(d0 - math.sqrt(2 * onset * p / kappa), 3, { stiffness = kappa, friction = mu })
  m:gravity { g * math.sin(angle), 0, -p / sigma }
  local a = fabric.dynamic { model = m, duration = 0.01 }
  a:solve()
  local slides = math.max(0, math.sin(angle) - mu * math.cos(angle)) * g
  local ux = a:node(6).ux
  if slides > 0 then
    near("slide", ux, slides * a.time ^ 2 / 2, 1e-2) -- it begins with a bounce: nodes have unlike shares of area and mass
    near("taken", a.energy.friction + 1e-12, mu * p * 4e-4 * ux + 1e-12, 2e-2)
  else
    -- The spring of friction slips by its share of the weight, and swings as far again.
    assert(ux > 0 and ux < 2.1 * p * math.tan(angle) / (2 / 7 * kappa), ux)
  end
  assert(a.energy.error < 1e-3, a.energy.error)
end

-- Calls that are refused.
local ball = fabric.rigid.sphere { radius = 0.005, centre = { 0.01, 0.01, 0.02 } }
local heavy = fabric.rigid.sphere { radius = 0.005, centre = { 0.01, 0.01, 0.02 }, mass = 0.01, name = "shot" }
local function sheet() return fabric.model { mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 4, ny = 4 }, card = card } end
fails(function() sheet():contact { between = { ball, "al" } } end, "contact: unknown set 'al'")
local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
local pole = fabric.rigid.cylinder { radius = 0.001, from = { 0, 0, 0.1 }, to = { 0, 0.01, 0.1 }, mass = 0.01 }
local stick = fabric.rigid.cylinder { radius = 0.001, from = { 0, 0, 0.2 }, to = { 0, 0.01, 0.2 } }
fails(function() sheet():contact { between = { ball, floor } } end, "bodies whose places are given do not meet each other")
fails(function() sheet():contact { between = { heavy, heavy } } end, "expected each body once, got the sphere twice")
fails(function() sheet():contact { between = { pole, stick } } end, "the cylinder and the cylinder do not meet each other")
fails(function() sheet():contact { between = { heavy, floor }, friction = 0.2 } end, "expected 0 between the sphere and the plane, got 0.2")
fails(function() sheet():contact { between = { heavy, floor }, settle = 0.2 } end, "expected bodies that begin apart")
fails(function() sheet():contact { self = "all", friction = { static = 0.2, kinetic = 0.3 } } end, "expected at least the kinetic friction of 0.3, got 0.2")
fails(function() sheet():contact { self = "all", friction = { static = 0.2 } } end, "kinetic")
fails(function() sheet():contact { between = { ball, "left" } } end, "holds no whole element")
fails(function() sheet():contact { between = { ball, "all" }, friction = -0.1 } end, "field 'friction'")
fails(function() sheet():contact { friction = 1 } end, "expected either between={...} or self=, got neither")
fails(function() sheet():move(heavy, { z = 1 }) end, "has a mass and moves freely")
fails(function() sheet():velocity(ball, { z = 1 }) end, "has no mass")
fails(function() sheet():move(ball, { z = 1 }):move(ball, { x = 1 }) end, "is moved already")
fails(function() sheet():move("all", { turn = { axis = { 0, 0, 1 }, angle = 3 } }) end, "m:turn turns a set")
fails(function() fabric.rigid.sphere { radius = -1, centre = { 0, 0, 0 } } end, "field 'radius'")
fails(function() fabric.rigid.disc { radius = 0.01, edge = 0.02, centre = { 0, 0, 0 }, normal = { 0, 0, 1 } } end, "below the radius")
local flat = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 4, ny = 4 }
fails(function() fabric.rigid.surface { mesh = flat, closed = true } end, "expected a closed surface")
fails(function() fabric.rigid.surface { mesh = flat, mass = 1 } end, "expected a closed surface")
local other = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 5, ny = 4 }
do -- quadrilaterals are cut as in the first shape, although others of their diagonals are the shorter ones later
  local function bowl(depth)
    return fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 4, ny = 4 }:map(function(x, y) return x, y, -depth * ((x - 0.01) ^ 2 + (y - 0.01) ^ 2) end)
  end
  fabric.rigid.motion { meshes = { bowl(0), bowl(20) }, times = { 0, 1 } }
end
fails(function() fabric.rigid.motion { meshes = { flat, other }, times = { 0, 1 } } end, "motion: field 'meshes': expected the same facets in every shape")
fails(function() fabric.rigid.motion { meshes = { flat, flat }, times = { 1, 0 } } end, "that ascend")
local function run(m) return fabric.dynamic { model = m, duration = 1e-3 } end
fails(function() run(sheet():move(ball, { z = 1 })) end, "touches nothing")
fails(function() run(sheet():contact { between = { ball, "all" } }:move(ball, { z = function() return 0 / 0 end })) end, "move: the sphere: field 'z': expected the history to return a finite number at t = 0 s, got nan")
-- A history that is fine at first and then no number stops the run there, and the run is not lost.
do
  local late = fabric.rigid.sphere { radius = 0.005, centre = { 0.01, 0.01, 0.02 } }
  local a = run(sheet():contact { between = { late, "all" } }:move(late, { z = function(t) return t > 5e-4 and 0 / 0 or 0 end }))
  fails(function() a:solve() end, "move: the sphere: field 'z': expected the history to return a finite number at t = ")
  assert(a.time > 4e-4 and a.time <= 5e-4 and a:node(1).z == 0 and a.energy.error < 1e-6)
end
local inside = fabric.rigid.sphere { radius = 0.005, centre = { 0.01, 0.01, 0.001 } }
fails(function() run(sheet():contact { between = { inside, "all" } }) end, "overlap at the start: node")
fails(function() fabric.static { model = sheet():contact { between = { heavy, "all" } }, duration = 1, method = "relaxation" } end, "is sought by Newton's method alone")
fails(function() fabric.dynamic { model = sheet():contact { between = { ball, "all" }, stiffness = 1e14 }, duration = 1e-3, step = 1e-6 } end, "the largest step that contact allows")
fails(function() sheet():fix("all", "x"); run(sheet()):gap() end, "nothing touches in this model")
fails(function() run(sheet()):field "gap" end, "nothing touches in this model")

-- The same bits after a restart, from a snapshot of the middle of the run: friction, a free ball, guard and all.
local function crash()
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.06, nx = 10, ny = 10 }
  local m = fabric.model { mesh = mesh, card = card }
  m:fix("boundary", "x y z rotation")
  local shot = fabric.rigid.sphere { radius = 0.01, centre = { 0.031, 0.029, 0.01 + d0 + 1e-5 }, mass = 0.005, name = "shot" }
  m:contact { between = { shot, "all" }, friction = 0.3, stiffness = 5e9 }:contact { self = "all", friction = 0.2 }
  m:velocity(shot, { x = 0.5, z = -1, spin = { 0, 2000, 0 } }):gravity { 0, 0, -9.81 }
  return fabric.dynamic { model = m, duration = 2e-3 }, shot
end
local a, shot = crash()
a:advance(5e-4)
local kept = a:snapshot()
a:solve()
local want = { a:body(shot) }
local e = a.energy
assert(e.rigid > 0 and e.friction > 0 and e.error < 1e-2, e.error)
a:restore(kept):solve()
for i, x in ipairs { a:body(shot) } do assert(x == want[i]) end
assert(a.energy.friction == e.friction and a.energy.kinetic == e.kinetic)

-- Relaxation while a body moves: nothing happens before it touches, and it ends where Newton's method does; a sheet that is free to move is said to be so.
do
  local function pushed(method, from, way)
    local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.05, height = 0.05, nx = 4, ny = 4 }, card = fabric.card "worsted" }
    m:fix("boundary", "x y z")
    local ball = fabric.rigid.sphere { radius = 0.01, centre = { 0.025, 0.025, from } }
    m:contact { between = { ball, "all" } }:move(ball, { z = fabric.ramp(way, 1) })
    local a = fabric.static { model = m, duration = 1, step = 0.2, method = method }:solve()
    local _, _, force = a:reaction(ball)
    return force, a
  end
  local force, a = pushed("relaxation", -0.05, 0.01)
  assert(force == 0 and a.time == 1 and a.energy.stored == 0)
  local by_newton = pushed("newton", -0.0103, 0.003)
  force = pushed("relaxation", -0.0103, 0.003)
  assert(by_newton ~= 0 and math.abs(force / by_newton - 1) < 1e-3, force .. " " .. by_newton)
  local free = fabric.model { mesh = fabric.mesh.rectangle { width = 0.05, height = 0.05, nx = 3, ny = 3 }, card = fabric.card "worsted" }
  free:fix("left", "x y"):gravity { 0, 0, fabric.ramp(-9.81, 1) }
  local good, message = pcall(function() fabric.static { model = free, duration = 1, method = "relaxation" }:solve() end)
  assert(not good and tostring(message):find("supports that leave no part free", 1, true), message)
end
