-- A ball or a rod presses with the force of the law's integral over the surface, wherever it lies against the
-- nodes: small against the elements, and of any radius where the stiffness is given; on held cloth, quadrilaterals and triangles, in statics, implicit and explicit motion; and cloth between two bodies is pressed likewise.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.svk { young = 2e8, poisson = 0.2, density = 500, thickness = 0.5 * mm, bending = { warp = 4e-5, weft = 4e-5, twist = 2e-5 } }
local gap = card.thickness / 2
local floor = card.density * card.thickness / 3000
local kappa = 6e7
local function pressure(depth)
  local onset = (gap - floor) / 5
  if depth <= 0 then return 0 end
  return kappa * (depth < onset and depth * depth / (2 * onset) or depth - onset / 2)
end
-- The law over flat cloth at the distance R + gap - d from the middle, N (of a rod N/m).
local function law(kind, R, d)
  local sum, n, way = 0, 4000, R + gap - d
  for i = 1, n do
    local x = (i - 0.5) / n * R
    local far = math.sqrt(x * x + way * way)
    sum = sum + (kind == "rod" and 2 or 2 * math.pi * x) * pressure(R + gap - far) * way / far * R / n
  end
  return sum
end
local side, cells = 30 * mm, 6 -- elements of 5 mm
local function body(kind, R, x, y, turn, z)
  if kind == "ball" then return fabric.rigid.sphere { radius = R, centre = { x, y, z } } end
  local c, s = 40 * mm * math.cos(turn), 40 * mm * math.sin(turn)
  return fabric.rigid.cylinder { radius = R, from = { x - c, y - s, z }, to = { x + c, y + s, z } }
end
local function run(m, scheme)
  if scheme == "static" then return fabric.static { model = m, duration = 1, step = 0.5 } end
  return fabric.dynamic { model = m, duration = 2e-5, scheme = scheme, step = scheme == "implicit" and 1e-5 or nil }
end
local worst = 0
local function pressed(o)
  local R, d, end_of, n = o.R, o.depth, o.scheme == "static" and 1 or 2e-5, o.cells or cells
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n, origin = { -side / 2, -side / 2, 0 }, triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0, points = 1 }:fix("all", "x y z rotation")
  local b = body(o.kind, R, o.x * mm, o.y * mm, o.turn or 0, R + gap + 1e-6)
  m:move(b, { z = fabric.ramp(-d - 1e-6, end_of) }):contact { between = { b, "all" }, stiffness = kappa, friction = o.friction, restitution = 1 }
  local a = run(m, o.scheme)
  a:solve()
  local _, _, z = a:reaction(b)
  local length = o.kind == "rod" and side / math.max(math.abs(math.cos(o.turn or 0)), math.abs(math.sin(o.turn or 0))) or 1
  local ratio = -z / (law(o.kind, R, d) * length)
  worst = math.max(worst, math.abs(ratio - 1))
  assert(math.abs(ratio - 1) < 0.08, ("%s, radius %g mm at %g, %g mm, %s: %.3f of the law's force"):format(o.kind, R / mm, o.x, o.y, o.scheme, ratio))
end
local places = { { 0, 0 }, { 2.5, 0 }, { 2.5, 2.5 }, { 1.7, 0.9 }, { -3.1, 4.2 } }
for i, place in ipairs(places) do
  for _, kind in ipairs { "ball", "rod" } do
    for _, R in ipairs { 2 * mm, 4.5 * mm } do
      local scheme = ({ "static", "implicit", "explicit" })[(i + (kind == "rod" and 1 or 0)) % 3 + 1]
      pressed { kind = kind, R = R, x = place[1], y = place[2], triangles = i % 2 == 0, scheme = scheme, depth = (0.05 + 0.012 * i) * mm, friction = i == 3 and 0.3 or 0 }
    end
  end
end
for _, turn in ipairs { math.pi / 2, math.pi / 4, 0.4 } do pressed { kind = "rod", R = 2.5 * mm, x = 0.3, y = 1.1, turn = turn, scheme = "static", depth = 0.12 * mm, triangles = turn == 0.4 } end

-- Of larger radii, and on finer elements, of 2.5, 1.25 and 0.75 mm.
for i, o in ipairs { { 3, 12 }, { 8, 6 }, { 5, 24 }, { 25, 6 }, { 12, 12 }, { 3, 40 }, { 6, 12 } } do
  for k, kind in ipairs { "ball", "rod" } do
    local h = 30 / o[2]
    local scheme = ({ "static", "implicit", "explicit" })[(i + k) % 3 + 1]
    pressed { kind = kind, R = o[1] * mm, cells = o[2], x = 0.17 * i * h, y = 0.31 * h, triangles = (i + k) % 2 == 0, scheme = scheme, depth = (0.06 + 0.01 * i) * mm }
  end
end
-- With a stiffness that is assumed or stiff as a constraint they press through nodes, and the run says so, also where nothing is printed.
for _, o in ipairs { { kappa, false }, { 1e11, true }, { nil, true } } do
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = side, height = side, nx = 6, ny = 6 }, card = card, warp = 0, points = 1 }:fix("all", "x y z rotation")
  m:contact { between = { fabric.rigid.sphere { radius = 9 * mm, centre = { 0, 0, 9 * mm + gap + 1e-6 }, name = "bob" }, "all" }, stiffness = o[1] }
  local a, said = fabric.static { model = m, duration = 1, step = 1 }, nil
  a:solve()
  for _, w in ipairs(a.warnings) do if w.code == "nodes" then said = w end end
  assert((said ~= nil) == o[2] and (not said or not said.serious and said.text:find("bob on the cloth; its force on cloth that stays flat there depends on where the nodes lie", 1, true)), said and said.text)
end

-- Between two rods or two balls: the cloth is free to move, and takes the middle.
for i, kind in ipairs { "rod", "ball" } do
  for _, at in ipairs { 0, 1.3, 2.5 } do
    local R, d = 3 * mm, 0.1 * mm
    local mesh = fabric.mesh.rectangle { width = side, height = side, nx = cells, ny = cells, origin = { -side / 2, -side / 2, 0 }, triangles = i == 2 }
    local m = fabric.model { mesh = mesh, card = card, warp = 0, points = 1 }:fix("all", "x y rotation"):fix("boundary", "z")
    local low, high = body(kind, R, at * mm, at * mm, math.pi / 2, -R - gap - 1e-6), body(kind, R, at * mm, at * mm, math.pi / 2, R + gap + 1e-6)
    m:move(high, { z = fabric.ramp(-d - 1e-6, 1) }):move(low, { z = fabric.ramp(d + 1e-6, 1) })
    m:contact { between = { low, "all" }, stiffness = kappa }:contact { between = { high, "all" }, stiffness = kappa }
    local a = fabric.static { model = m, duration = 1, step = 0.25 }
    a:solve()
    local _, _, z = a:reaction(high)
    local ratio = -z / (law(kind, R, d) * (kind == "rod" and side or 1))
    worst = math.max(worst, math.abs(ratio - 1))
    assert(math.abs(ratio - 1) < 0.08, ("nip of two %ss at %g mm: %.3f"):format(kind, at, ratio))
  end
end
print(("largest deviation from the law's force %.3f"):format(worst))

-- A rod that is drawn over held cloth with friction: mu times the normal force all the way, from element to element.
for _, o in ipairs { { "static", false }, { "implicit", true }, { "explicit", false } } do
  local scheme, triangles, mu, R, d = o[1], o[2], 0.35, 2 * mm, 0.1 * mm
  local mesh = fabric.mesh.rectangle { width = side, height = 10 * mm, nx = cells, ny = 2, origin = { -side / 2, -5 * mm, 0 }, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0, points = 1 }:fix("all", "x y z rotation")
  local rod = body("rod", R, -4 * mm, 0, math.pi / 2, R + gap + 1e-6)
  local T = scheme == "static" and 1 or 2e-3
  m:move(rod, { z = fabric.history { { 0, 0 }, { 0.1 * T, -d - 1e-6 }, { T, -d - 1e-6 } }, x = fabric.history { { 0, 0 }, { 0.1 * T, 0 }, { T, 8 * mm } } })
  m:contact { between = { rod, "all" }, stiffness = kappa, friction = mu, restitution = 1 }
  local a = scheme == "static" and fabric.static { model = m, duration = 1, step = 0.02 } or fabric.dynamic { model = m, duration = T, scheme = scheme, step = scheme == "implicit" and 0.02 * T or nil }
  local seen = 0
  a:every(0.1 * T, function()
    if a.time < 0.35 * T then return end
    local x, _, z = a:reaction(rod)
    seen = seen + 1
    assert(math.abs(-z / (law("rod", R, d) * 10 * mm) - 1) < 0.08, z)
    assert(math.abs(math.abs(x / z) / mu - 1) < 0.01, ("%s: friction %g of the normal force"):format(scheme, x / z))
  end)
  a:solve()
  assert(seen >= 6 and math.abs(a.energy.error) < 0.01, a.energy.error)
end
