-- Half models with bodies: a half model with half a body moves like the whole one; what is not symmetric is refused.
local fabric = require "fabric"
local card = fabric.card("blend", { bending = "estimated" })

-- Rods that lie across the plane x = 0 and balls in it, thrown at a clamped sheet beside its middle line.
local function thrown(half, scheme, make, plane)
  local L, n = 0.06, 4
  local mesh = fabric.mesh.rectangle { width = half and L / 2 or L, height = L, nx = half and n or 2 * n, ny = 6, origin = { half and 0 or -L / 2, -L / 2 } }
  mesh:set("outer", function(x, y) return math.abs(math.abs(x) - L / 2) < 1e-9 or math.abs(math.abs(y) - L / 2) < 1e-9 end)
  mesh:set("middle", function(x) return math.abs(x) < 1e-9 end)
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 90 }
  if half then m:symmetry("middle", "x") end
  m:fix("outer", "x y z")
  local body = make(half)
  m:velocity(body, { y = 0.3, z = -2, spin = { 200, 0, 0 } }):contact { between = { body, "all" }, friction = 0.3 }:gravity { 0, 0, -9.81 }
  local a = fabric.dynamic { model = m, duration = scheme == "implicit" and 0.002 or 0.004, scheme = scheme, step = scheme == "implicit" and 2e-5 or "auto", ledger_limit = scheme == "implicit" and 1e9 or nil }:solve()
  return a, body
end

local function rod(half) return fabric.rigid.cylinder { radius = 0.004, from = { -0.007, 0.003, 0.0046 }, to = { 0.007, 0.003, 0.0046 }, mass = half and 0.002 or 0.004 } end
-- A bar whose facets are the same on both sides; its half ends in the plane.
local function bar(half)
  local file = os.tmpname() .. ".obj"
  local h = assert(io.open(file, "w"))
  for _, x in ipairs { 0, 0.008, -0.008 } do
    for _, p in ipairs { { -0.002, 0.0006 }, { 0.006, 0.0006 }, { 0.006, 0.0046 }, { -0.002, 0.0046 } } do h:write(("v %.9g %.9g %.9g\n"):format(x, p[1], p[2])) end
  end
  local function facet(a, b, c, d) h:write(("f %d %d %d\nf %d %d %d\n"):format(a, b, c, a, c, d)) end
  for k = 1, 4 do
    local l = k % 4 + 1
    facet(k, l, l + 4, k + 4)
    if not half then facet(l, k, k + 8, l + 8) end
  end
  facet(5, 6, 7, 8)
  if half then facet(4, 3, 2, 1) else facet(12, 11, 10, 9) end
  h:close()
  local body = fabric.rigid.surface { file = file, closed = true, mass = half and 0.003 or 0.006 }
  os.remove(file)
  return body
end

for _, case in ipairs { { "rod, explicit", "explicit", rod }, { "rod, implicit", "implicit", rod }, { "half a bar, explicit", "explicit", bar } } do
  local name, scheme, make = table.unpack(case)
  local whole, w = thrown(false, scheme, make)
  local part, p = thrown(true, scheme, make)
  local x, y, z, vx, vy, vz, wx, wy, wz = part:body(p)
  local X, Y, Z, _, VY, VZ, WX = whole:body(w)
  if make == rod then assert(x == 0, x) else assert(math.abs(x - 0.004) < 1e-12) end
  assert(vx == 0 and wy == 0 and wz == 0 and (make == bar or math.abs(X) < 1e-9))
  -- The whole loses its symmetry by rounding alone. Contact with the facets of a whole bar is itself not quite symmetric: it moves sideways by some um.
  local near = make == bar and 0.1 or 1e-6
  fabric.expect {
    { name .. ": y, m", y, Y, relative = near },
    { name .. ": z, m", z, Z, relative = near },
    { name .. ": vy, m/s", vy, VY, relative = near },
    { name .. ": vz, m/s", vz, VZ, relative = near },
    { name .. ": spin, degrees/s", wx, WX, relative = near },
    { name .. ": kinetic energy, J", 2 * part.energy.kinetic, whole.energy.kinetic, relative = near },
    { name .. ": stored energy, J", 2 * part.energy.stored, whole.energy.stored, relative = near },
  }
  assert(math.abs(VZ) < 1.9 and math.abs(WX - 200) > 10, "they have met, and rub")
end

local function says(words, chunk)
  local ok, e = pcall(chunk)
  assert(not ok and tostring(e):find(words, 1, true), tostring(e))
end
local function half_with(body, velocity)
  local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.06, nx = 3, ny = 6 }
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  m:symmetry("left", "x"):contact { between = { body, "all" } }
  if velocity then m:velocity(body, velocity) end
  return fabric.dynamic { model = m, duration = 1e-5 }
end
local function ball(x, mass) return fabric.rigid.sphere { radius = 0.005, centre = { x, 0.03, 0.006 }, mass = mass or 0.01 } end
says("model: the sphere is not symmetric about the plane of symmetry x = 0 m of set 'left', which cuts it: expected a body of the same shape on both sides, the centre of its mass in the plane (it is at x = 0.001 m)", function() half_with(ball(0.001)) end)
says("velocity: the sphere is cut by the plane of symmetry x = 0 m of set 'left': expected a velocity in the plane and a spin about its normal alone", function() half_with(ball(0), { x = 0.1, z = -1 }) end)
says("expected a velocity in the plane", function() half_with(ball(0), { spin = { 0, 0, 90 } }) end)
half_with(ball(0.02), { x = 0.1 }):solve() -- one that the plane does not cut is free

-- Loads are symmetric, too: gravity across the plane would pull the part that is left out the other way.
local function hung(gravity, planes)
  local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.06, nx = 3, ny = 6 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  for set, normal in pairs(planes) do m:symmetry(set, normal) end
  return fabric.static { model = m:gravity(gravity), duration = 1 }
end
says("gravity: its x points across the plane of symmetry x = 0 m of set 'left', and would pull the part that is left out the other way: expected gravity in the plane, or the whole model",
  function() hung({ fabric.ramp(9.81, 1), 0, -9.81 }, { left = "x" }) end)
says("gravity: its y points across the plane of symmetry y = 0.06 m of set 'top'", function() hung({ 0, function(t) return 3 * math.sin(t) end, 0 }, { left = "x", top = "y" }) end)
hung({ 0, 3, -9.81 }, { left = "x" })
hung({ 0, 3, -9.81 }, { all = "z" }) -- a sheet in its plane is whole
-- So is a body that is moved.
local function pressed(x, motion)
  local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.06, nx = 3, ny = 6 }
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  local rod = fabric.rigid.cylinder { radius = 0.004, from = { x - 0.01, 0.03, 0.006 }, to = { x + 0.01, 0.03, 0.006 } }
  return fabric.static { model = m:symmetry("left", "x"):contact { between = { rod, "all" } }:move(rod, motion), duration = 1 }
end
local moved = "move: the cylinder is cut by the plane of symmetry x = 0 m of set 'left': expected a motion in the plane and a turn about its normal alone, or the whole model"
says(moved, function() pressed(0, { z = fabric.ramp(-0.01, 1), x = function(t) return 0.01 * t end }) end)
says(moved, function() pressed(0, { turn = { axis = { 1, 0, 0.1 }, angle = fabric.ramp(20, 1) } }) end)
pressed(0, { y = fabric.ramp(0.01, 1), turn = { axis = { -2, 0, 0 }, angle = fabric.ramp(20, 1) } })
pressed(0.02, { x = fabric.ramp(0.001, 1) }) -- the plane does not cut it
-- Nor may the plane cut a ball or a rod that stands still, or is moved along the plane, off its middle: the whole would have two of them.
local function beside(body)
  local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.06, nx = 3, ny = 6 }
  local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
  return fabric.static { model = m:symmetry("left", "x"):contact { between = { body, "all" } }:move(body, { z = fabric.ramp(-0.01, 1) }), duration = 1 }
end
local function still(x) return fabric.rigid.sphere { radius = 0.005, centre = { x, 0.03, 0.006 } } end
local function along(x, tilt) return fabric.rigid.cylinder { radius = 0.004, from = { x, 0.01, 0.006 }, to = { x + tilt, 0.05, 0.006 } } end
says("model: the sphere is cut by the plane of symmetry x = 0 m of set 'left' off its middle, so that the whole has two that overlap: expected its middle in the plane, or the whole model", function() beside(still(0.002)) end)
says("model: the cylinder is cut by the plane of symmetry x = 0 m of set 'left' off its middle", function() beside(along(-0.001, 0)) end)
for _, body in ipairs { still(0), still(0.006), along(0, 0), along(0.005, 0), along(0, 0.01) } do beside(body) end

-- A quarter of a sheet that falls on a ball moves like the whole one: its squares are cut for contact along mirrored diagonals.
for _, case in ipairs { { 5, 0, 1e-12 }, { 6, 0, 1e-12 }, { 6, 0.2, 1e-12 } } do
  local n, friction, near = table.unpack(case)
  local function fallen(quarter)
    local L = 0.08
    local across = quarter and n or 2 * n
    local mesh = fabric.mesh.rectangle { width = quarter and L / 2 or L, height = quarter and L / 2 or L, nx = across, ny = across, origin = quarter and { 0, 0 } or { -L / 2, -L / 2 } }
    local m = fabric.model { mesh = mesh, card = card, points = 1, warp = 0 }
    if quarter then m:symmetry("left", "x"):symmetry("bottom", "y") end
    local ball = fabric.rigid.sphere { radius = 0.015, centre = { 0, 0, -0.0162 } }
    m:velocity("all", { z = -1 }):contact { between = { ball, "all" }, friction = friction }:gravity { 0, 0, -9.81 }
    return fabric.dynamic { model = m, duration = 0.004, step = "auto" }:solve(), mesh
  end
  local whole, mesh = fallen(false)
  local part, quarter = fallen(true)
  local worst, lowest = 0, 0
  local at = {}
  for i, X in ipairs(mesh.nodes) do at[("%.6f %.6f"):format(X[1], X[2])] = i end
  for i, X in ipairs(quarter.nodes) do
    local a, b = part:node(i), whole:node(at[("%.6f %.6f"):format(X[1], X[2])])
    worst = math.max(worst, math.abs(a.x - b.x), math.abs(a.y - b.y), math.abs(a.z - b.z))
    lowest = math.min(lowest, b.uz)
  end
  assert(lowest < -0.004 and worst < near, worst)
end
