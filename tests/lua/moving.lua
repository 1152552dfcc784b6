-- Surfaces that change their shape: friction acts with the speed that the surface has where it touches. A floor that slides, one that stretches,
-- series in files, and what is refused.
local fabric = require "fabric"
local fails = function(words, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(words, 1, true), 'expected "' .. words .. '", got ' .. tostring(why))
end
local near = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).near
local g, thickness, density, kappa, mu = 9.81, 0.5e-3, 420, 2e8, 0.4
local sigma = thickness * density
local card = fabric.svk { name = "limp", young = 1e8, poisson = 0, density = density, thickness = thickness, bending = { warp = 2e-6, weft = 2e-6, twist = 1e-6 } }
-- Where its weight keeps it: kappa y^2 / (2 onset).
local depth = math.sqrt(2 * 0.2 * (thickness / 2 - sigma / 1500 / 2) * sigma * g / kappa)
local L, W = 0.08, 0.02
local function strip(triangles)
  local mesh = fabric.mesh.rectangle { width = L, height = W, nx = 8, ny = 2, triangles = triangles, origin = { -L / 2, 0, thickness / 2 - depth } }
  return fabric.model { mesh = mesh, card = card, warp = 0, points = 1 }, mesh
end
-- A floor of facets that moves from shape to shape: x -> way(t, x).
local function floor_mesh(f, triangles)
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.06, nx = 13, ny = 5, triangles = triangles, origin = { -0.1, -0.02, 0 } }
  return mesh:map(function(x, y, z) return f(x), y, z end)
end
local function floor_of(way, times)
  local meshes = {}
  for i, t in ipairs(times) do meshes[i] = floor_mesh(function(x) return way(t, x) end) end
  return fabric.rigid.motion { meshes = meshes, times = times }
end
local runs = { { "explicit" }, { "explicit", nil, true }, { "implicit", 1e-4 }, { "implicit", 1e-4, true } }

-- A floor slides with the speed v under a strip at rest: friction takes it along with mu g until it is as fast. The floor does the work m v^2,
-- of which friction takes half.
for _, how in ipairs(runs) do
  local v, T = 0.02, 0.01
  local m = strip(how[3])
  local floor = floor_of(function(t, x) return x + v * t end, { 0, 0.003, T })
  m:gravity { 0, 0, -g }:contact { between = { floor, "all" }, friction = mu, stiffness = kappa }
  local a = fabric.dynamic { model = m, duration = T, scheme = how[1], step = how[2] }
  local name = ("slides, %s%s: "):format(how[1], how[3] and ", triangles" or "")
  a:advance(0.003)
  near(a:node(9).vx, mu * g * 0.003, 0.01, name .. "speed at 3 ms")
  a:solve()
  near(a:node(9).vx, v, 0.01, name .. "speed at the end")
  near((select(4, a:body(floor))), 0, 0, name .. "the floor has arrived")
  local mass = sigma * L * W
  near(a.energy.friction, mass * v ^ 2 / 2, 0.01, name .. "friction")
  near(a.energy.external, mass * v ^ 2, 0.01, name .. "work of the floor")
  assert(a.energy.error < 1e-3)
end
do -- the speed of a surface is the mean of its vertices' speeds
  local m = strip()
  local floor = floor_of(function(t, x) return (1 + 2 * t) * x + 0.3 * t end, { 0, 1 })
  m:contact { between = { floor, "all" }, stiffness = kappa }
  local x, _, _, vx, vy = fabric.dynamic { model = m, duration = 1e-3 }:solve():body(floor)
  near(vx, 0.3, 1e-12, "speed of the body")
  assert(vy == 0)
  near(x, 0.3e-3, 1e-9, "place of the body")
end

-- A floor that stretches evenly about the middle of a strip slides outwards below it. The tension rises from the ends by mu sigma g per length, to
-- mu sigma g L/2 in the middle.
for _, how in ipairs { { "static" }, { "static", nil, true }, { "explicit" }, { "implicit", 2e-4 } } do
  local T = how[1] == "static" and 1 or 0.02
  local m, mesh = strip(how[3])
  local floor = floor_of(function(t, x) return (1 + 0.02 * t / T) * x end, { 0, T })
  m:fix("all", "y"):gravity { 0, 0, how[1] == "static" and fabric.ramp(-g, 0.1) or -g }:contact { between = { floor, "all" }, friction = mu, stiffness = kappa }
  local a
  if how[1] == "static" then
    a = fabric.static { model = m, duration = T, step = 0.1 }
  else
    -- The stretching begins at once, and the strip vibrates along itself until that is damped.
    a = fabric.dynamic { model = m, duration = T, scheme = how[1], step = how[2], damping = { mass = 1000 }, gamma = how[1] == "implicit" and 0.55 or nil }
  end
  a:solve()
  -- Triangles do not press evenly over the width, so that columns are averaged.
  local tension, sum, count = a:field "tension_warp", {}, {}
  for e, corners in ipairs(mesh.elements) do
    local column = math.huge
    for _, n in ipairs(corners) do column = math.min(column, math.floor((mesh.nodes[n][1] + L / 2) / L * 8 + 0.5)) end
    sum[column], count[column] = (sum[column] or 0) + tension[e], (count[column] or 0) + 1
  end
  for column, total in pairs(sum) do
    local x = ((column + 0.5) / 8 - 0.5) * L
    local got, want = total / count[column], mu * sigma * g * (L / 2 - math.abs(x))
    assert(math.abs(got - want) < 0.01 * mu * sigma * g * L / 2, ("stretches, %s%s: tension at %g m: got %g, want %g"):format(how[1], how[3] and ", triangles" or "", x, got, want))
  end
end

-- A series of OBJ or VTU files is that of the meshes, to the bit.
do
  os.execute "mkdir -p work"
  local times, ways = { 0, 2e-3, 5e-3 }, { 0, 1e-4, -2e-4 }
  local function moved(ending)
    local given = {}
    for i, by in ipairs(ways) do
      local mesh = floor_mesh(function(x) return x + by end, true)
      given[i] = ending and ("work/floor%d.%s"):format(i, ending) or mesh
      if ending then mesh:write(given[i]) end
    end
    local m = strip()
    local floor = fabric.rigid.motion { times = times, [ending and "files" or "meshes"] = given }
    m:gravity { 0, 0, -g }:contact { between = { floor, "all" }, friction = mu, stiffness = kappa }
    return fabric.dynamic { model = m, duration = 5e-3 }:solve():field "displacement"
  end
  local want = moved()
  for _, ending in ipairs { "obj", "vtu" } do
    for i, row in ipairs(moved(ending)) do
      for c, value in ipairs(row) do assert(math.abs(value - want[i][c]) <= (ending == "vtu" and 0 or 1e-12), ending) end
    end
  end
  local coarse = fabric.mesh.rectangle { width = 0.2, height = 0.06, nx = 12, ny = 5, triangles = true }
  coarse:write "work/floor4.obj"
  fails("expected the same facets in every shape, got 78 vertices in shape 2 and 84 in the first",
    fabric.rigid.motion, { files = { "work/floor1.obj", "work/floor4.obj" }, times = { 0, 1 } })
end

-- A closed surface that moves has an inside, in which no cloth may start, and keeps it.
do
  local function ball(r, open)
    local _, mesh = fabric.rigid.torso { sections = { { -1e-3, r, r }, { 1e-3, r, r } }, around = 16 }
    if open then mesh:map(function(x, y, z) return -x, y, z end) end
    return mesh
  end
  local swelling = fabric.rigid.motion { meshes = { ball(0.1), ball(0.11) }, times = { 0, 1 }, closed = true, name = "ball" }
  local m = strip():contact { between = { swelling, "all" } }
  fails("starts inside the ball, which bounds a solid", fabric.dynamic, { model = m, duration = 1 })
  fails("motion: field 'closed': shape 2: ", fabric.rigid.motion, { meshes = { ball(0.1), ball(0.1, true) }, times = { 0, 1 }, closed = true })
  fails("motion: field 'closed': rigid body: expected a closed surface", fabric.rigid.motion,
    { meshes = { floor_mesh(function(x) return x end) }, times = { 0 }, closed = true })
end
