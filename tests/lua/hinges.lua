-- Creases that are hinges: one under an end moment opens by M/k; a stiff one is none, a free one carries nothing; frequencies and swings of a
-- panel on a hinge; creases that cross, at a vertex that folds rigidly. Energies, snapshots and runs from other runs with them.
local fabric = require "fabric"
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end
local rad = math.pi / 180

local B, width, length, at = 2e-3, 0.02, 0.09, 0.03
local card = fabric.svk { density = 500, thickness = 0.4e-3, warp = 50e6, weft = 50e6, shear = 20e6, poisson = 0,
  bending = { warp = B, weft = B, twist = B / 2 } }
local function strip(tri) return fabric.mesh.rectangle { width = length, height = width, nx = 9, ny = 2, triangles = tri } end
local function line(x) return { { x, 0, 0 }, { x, width, 0 } } end
local function model(tri, crease)
  local m = fabric.model { mesh = strip(tri), card = card }
  m:fix("left", "x y z rotation")
  if crease then m:crease(crease) end
  return m
end
-- The angle at the crease, in degrees, of the middle one of its nodes.
local function angle_of(a) return a:field "crease_angle"[14] end

for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  -- An end moment that bends each part to an arc and opens the hinge, which rests at 10 degrees.
  local M, k = 2e-4, 0.03
  local bent = model(tri, { line = line(at), angle = 10, stiffness = k }):moment("right", { y = -M })
  local a = fabric.static { model = bent, duration = 1, step = 0.25 }:solve()
  check("opens by M/k" .. of, angle_of(a), 10 + M / (k * width) / rad, 1e-6)
  local stored = 0.5 * (M / width) ^ 2 * width * (length / B + 1 / k)
  check("stores its part" .. of, a.energy.stored, stored, 1e-5)

  local plain = fabric.static { model = model(tri):moment("right", { y = -M }), duration = 1, step = 1 }:solve()
  local stiff = fabric.static { model = model(tri, { line = line(at), angle = 0, stiffness = 1e5 }):moment("right", { y = -M }), duration = 1, step = 1 }:solve()
  check("a stiff one is none" .. of, stiff:node(10).z, plain:node(10).z, 1e-6)

  -- A panel on a hinge: a stiff plate that turns about its edge; one that is free has no frequency.
  local wide = length - at
  local inertia = card.thickness * card.density * width * wide ^ 3 / 3 * (1 + 1 / (2 * 6 ^ 2)) -- of six elements with lumped masses
  local swing = model(tri, { line = line(at), angle = 0, stiffness = 2e-5 })
  local first = fabric.modes { model = swing, count = 1 }[1]
  check("frequency on the hinge" .. of, first.frequency, math.sqrt(2e-5 * width / inertia) / (2 * math.pi), 1e-3)
  local free = fabric.modes { model = model(tri, { line = line(at), angle = 0, stiffness = 0 }), count = 1 }[1]
  check("a free hinge carries nothing" .. of, 1 + free.frequency / first.frequency, 1, 1e-3)
end

-- Let go at 20 degrees from rest: half a swing to the other side.
local k = 2e-4
local half = math.pi * math.sqrt(card.thickness * card.density * width * (length - at) ^ 3 / 3 / (k * width))
local long = os.getenv "FABRICSH_TEST_LONG" -- the short form has triangles in implicit, quadrilaterals in explicit runs
for _, tri in ipairs { false, true } do
  for _, scheme in ipairs(long and { "implicit", "explicit" } or { tri and "implicit" or "explicit" }) do
    local of = ", " .. scheme .. (tri and ", triangles" or ", quadrilaterals")
    local m = model(tri, { line = line(at), angle = 20, stiffness = k })
    local d = fabric.dynamic { model = m, duration = half, scheme = scheme, step = scheme == "implicit" and half / 100 or "auto" }
    check("stored at the start" .. of, d.energy.stored, 0.5 * k * width * (20 * rad) ^ 2, 1e-9)
    local kept = d:advance(half / 2):snapshot()
    d:solve()
    check("on the other side" .. of, angle_of(d), 40, 0.02)
    check("energy" .. of, 1 + d.energy.error, 1, scheme == "implicit" and 2e-3 or 1e-2)
    local z = d:node(10).z
    d:restore(kept)
    check("again from a snapshot, same bits" .. of, d:solve():node(10).z == z and 1 or 0, 1, 0)
  end
end

-- The state of a static run goes on in motion: the moment that held it is gone.
local held = model(false, { line = line(at), angle = 0, stiffness = k }):moment("right", { y = -k * width * 30 * rad })
local from = fabric.static { model = held, duration = 1, step = 0.5 }:solve()
local let = model(false, { line = line(at), angle = 0, stiffness = k })
local motion = fabric.dynamic { model = let, from = from, duration = half, scheme = "implicit", step = half / 100 }:solve()
check("from a static run", angle_of(motion), -30, 0.02)

local other = model(false, { line = line(at), angle = 0, stiffness = 2 * k })
local ok, message = pcall(fabric.dynamic, { model = other, from = from, duration = 1 })
assert(not ok and tostring(message):find("expected a run of the same cloth; it differs in the creases", 1, true), tostring(message))

for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  -- A stiff panel on a hinge under an axial force buckles as a rigid one, with the hinge in series with the base and the panel.
  local axial = model(tri, { line = line(at), angle = 0, stiffness = k }):force("right", { x = -1e-5 })
  local straight = fabric.static { model = axial, duration = 1, step = 1 }:solve()
  local soft = 1 / k + at / B + (length - at) / (3 * B)
  check("buckles on the hinge" .. of, fabric.buckling { from = straight, count = 1 }[1].factor * 1e-5, width / soft / (length - at), 1e-3)

  -- It closes until the panels touch: contact sees one point where the sides of the hinge meet.
  local closing = fabric.model { mesh = strip(tri), card = card }
  closing:fix("left", "x y z rotation"):crease { line = line(0.04), angle = 178, stiffness = 5e-3 }:contact { self = "all", friction = 0, stiffness = 1e9 }
  local d = fabric.dynamic { model = closing, duration = 0.4, damping = { mass = 40 } }
  check("no contact at the start" .. of, 1 + d.energy.contact, 1, 0)
  d:solve()
  check("the hinge closes" .. of, d:field "crease_angle"[15], 177.7, 2e-3)
  check("balance" .. of, 1 + d.energy.error, 1, 1e-3)
end

-- A vertex of a Miura fold: the straight crease rises to both sides by the angle a, the oblique ones lie in the plane z = 0.
local alpha, size, n = 60 * rad, 0.03, 2
local function place(a)
  local p = math.cos(alpha) / math.cos(a)
  local q = math.sqrt(1 - p * p)
  return function(i, j)
    local s, t = math.abs(i) / n * size, math.abs(j) / n * size
    return { (i < 0 and -s or s) * math.cos(a) + t * p, (j < 0 and -t or t) * q, s * math.sin(a) }
  end
end
local function number(i, j) return (j + n) * (2 * n + 1) + i + n + 1 end
local function vertex(a, tri)
  local nodes, elements, of = {}, {}, place(a)
  for j = -n, n do for i = -n, n do nodes[number(i, j)] = of(i, j) end end
  for j = -n, n - 1 do
    for i = -n, n - 1 do
      local c = { number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1) }
      if tri then
        elements[#elements + 1] = { c[1], c[2], c[3] }
        elements[#elements + 1] = { c[1], c[3], c[4] }
      else
        elements[#elements + 1] = c
      end
    end
  end
  local mesh = fabric.mesh { nodes = nodes, elements = elements }
  local sets = { right = {}, left = {}, up = {}, down = {} }
  for i = 0, n do
    table.insert(sets.right, number(i, 0))
    table.insert(sets.left, number(-i, 0))
    table.insert(sets.up, number(0, i))
    table.insert(sets.down, number(0, -i))
  end
  for name, ids in pairs(sets) do mesh:set(name, ids) end
  return mesh
end
-- The angles of the four creases from the normals of the panels beside them.
local function angles(a)
  local of = place(a)
  local function sub(x, y) return { x[1] - y[1], x[2] - y[2], x[3] - y[3] } end
  local function cross(x, y) return { x[2] * y[3] - x[3] * y[2], x[3] * y[1] - x[1] * y[3], x[1] * y[2] - x[2] * y[1] } end
  local function dot(x, y) return x[1] * y[1] + x[2] * y[2] + x[3] * y[3] end
  local function unit(x) local l = math.sqrt(dot(x, x)) return { x[1] / l, x[2] / l, x[3] / l } end
  local function normal(i, j) return unit(cross(sub(of(i, 0), of(0, 0)), sub(of(0, j), of(0, 0)))) end
  local sign = function(i, j) local m = normal(i, j) return i * j < 0 and { -m[1], -m[2], -m[3] } or m end
  local function between(i, j, left, right)
    local t, p, q = unit(of(i, j)), sign(table.unpack(left)), sign(table.unpack(right))
    return math.atan(dot(t, cross(q, p)), dot(p, q)) / rad
  end
  return { right = between(n, 0, { n, n }, { n, -n }), left = between(-n, 0, { -n, -n }, { -n, n }),
    up = between(0, n, { -n, n }, { n, n }), down = between(0, -n, { n, -n }, { -n, -n }) }
end
for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  local start, rest = 25 * rad, 35 * rad
  local m = fabric.model { mesh = vertex(start, tri), reference = vertex(0, tri), card = card, warp = 0 }
  for name, angle in pairs(angles(rest)) do m:crease { set = name, angle = angle, stiffness = 0.01 } end
  local middle = number(0, 0)
  m.mesh:set("middle", { middle })
  m.mesh:set("side", { number(n, 0) })
  m.mesh:set("far", { number(0, n) })
  m:fix("middle", "x y z"):fix("side", "y"):fix("left", "y")
  m:fix("up", "z"):fix("down", "z")
  local a = fabric.static { model = m, duration = 1, step = 0.25 }
  local began = a.energy.stored
  a:solve()
  check("the vertex folds" .. of, a:node(number(n, 0)).z, size * math.sin(rest), 1e-4)
  check("its oblique creases come together" .. of, a:node(number(0, n)).x, size * math.cos(alpha) / math.cos(rest), 1e-4)
  check("and store nothing" .. of, 1 + a.energy.stored / began, 1, 1e-6)
end

-- A square folded in four by two creases that cross: three valleys and a mountain. In its place it has no stress.
for _, tri in ipairs { false, true } do
  local flat = fabric.mesh.rectangle { width = 0.08, height = 0.08, nx = 4, ny = 4, triangles = tri }
  local folded = fabric.mesh.rectangle { width = 0.08, height = 0.08, nx = 4, ny = 4, triangles = tri }
  folded:map(function(x, y) return 0.04 - math.abs(x - 0.04), 0.04 - math.abs(y - 0.04), 0 end)
  local m = fabric.model { mesh = folded, reference = flat, card = card }
  m:crease { line = { { 0.04, 0, 0 }, { 0.04, 0.08, 0 } }, angle = 180, stiffness = 0.01 }
  m:crease { line = { { 0, 0.04, 0 }, { 0.04, 0.04, 0 } }, angle = 180, stiffness = 0.01 }
  m:crease { line = { { 0.04, 0.04, 0 }, { 0.08, 0.04, 0 } }, angle = -180, stiffness = 0.01 }
  m:fix("left", "x y z")
  local a = fabric.static { model = m, duration = 1, step = 1 }
  check("folded in four" .. (tri and ", triangles" or ", quadrilaterals"), 1 + a.energy.stored / (0.01 * 0.16 * math.pi ^ 2 / 2), 1, 1e-12)
end
fabric.expect(checks)
