-- Plates under small pressure: clamped and supported squares and a rectangle whose rigidities differ, circles; on squares, on distorted quadrilaterals
-- and on triangles. A sheet twisted by its corners, two plies that bend as they are pulled, a sphere blown up. Then a flat membrane that carries the pressure
-- by tension alone, and one that is taut beforehand.
--
-- Rigidity of a homogeneous sheet D = E t^3 / (12 (1 - nu^2)) [timoshenko1959]: a clamped square of side a has w = 0.001265 q a^4 / D in the middle (table
-- 35; the series gives 0.0012653), a supported one 0.004062 (table 8). Circles of radius a: clamped q a^4 / (64 D), supported (5 + nu) / (1 + nu) times that.
-- Bending of its own, B1 along x, B2 along y, Bt with 2 k12 and no coupling: M11 = B1 k11, M22 = B2 k22, M12 = 2 Bt k12, whose equilibrium is
--   B1 w,xxxx + 4 Bt w,xxyy + B2 w,yyyy = q: over a supported rectangle a x b by Navier's double sine series, term by term.
-- A sheet of tension per width T1, T2 and no rigidity: T1 w,xx + T2 w,yy = -q, the same series with T1 (m pi / a)^2 + T2 (n pi / b)^2.
-- Transverse shear adds to a supported square the deflection of a membrane of the tension 5/6 G t: 1.3e-4, of which triangles leave less than a tenth.
-- Elsewhere it is not counted. Errors left are those of the meshes, h^2.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()

-- The middle of a supported rectangle: sum of 16 / (pi^2 m n) q sin(m pi / 2) sin(n pi / 2) / k(m, n).
local function navier(q, k)
  local sum = 0
  for m = 1, 99, 2 do
    for n = 1, 99, 2 do sum = sum + 16 * q / (math.pi ^ 2 * m * n) * (-1) ^ ((m - 1) // 2 + (n - 1) // 2) / k(m * math.pi, n * math.pi) end
  end
  return sum
end

-- The middle's deflection under the pressure q, one linear step: so small that the sheet does not stretch.
local function middle(mesh, card, q, hold, x, y)
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  hold(m)
  m:pressure(fabric.ramp(q, 1))
  local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
  return a:node(common.nearest(mesh, x, y)).uz
end

local E, nu, t = 4e8, 0.3, 1e-3
local thick = common.sheet { young = E, poisson = nu, thickness = t }
local D = E * t ^ 3 / (12 * (1 - nu ^ 2))
local side = 0.2
-- Deflections of 1e-4 of the thickness.
local q = 1e-4 * t * D / side ^ 4 / 0.0013
local function clamped(m) m:fix("boundary", "x y z rotation") end
local function supported(m) m:fix("boundary", "x y z") end
-- The series' supports hold the edges straight, so that nothing turns along them.
local function straight(m) m:fix("left", "rx"):fix("right", "rx"):fix("bottom", "ry"):fix("top", "ry") end
local function square(n, triangles) return fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n, triangles = triangles } end
local bent, sheared = navier(1, function(m, n) return (m ^ 2 + n ^ 2) ^ 2 end), navier(1, function(m, n) return m ^ 2 + n ^ 2 end)
local whole = bent + sheared * D / (5 / 6 * E / (2 * (1 + nu)) * t * side ^ 2)
for _, hold in ipairs { { "clamped", clamped, 0.0012653, 0.015 }, { "supported", function(m) supported(m) straight(m) end, whole, 1e-4 } } do
  local function found(mesh) return middle(mesh, thick, q, hold[2], side / 2, side / 2) end
  local want = hold[3] * q * side ^ 4 / D
  checks(hold[1] .. " square, squares", found(square(16)), want, { relative = 5e-3 })
  checks(hold[1] .. " square, distorted", found(common.distorted(square(16), side, side, 16, 16, 0.2)), want, { relative = 0.015 })
  -- Flat triangles lose more: 5 % of a clamped plate on 16 x 16 x 2, less than a quarter of that on twice as many.
  local coarse, fine = found(square(14, true)), found(square(28, true))
  checks(hold[1] .. " square, triangles", fine, want, { relative = hold[4] })
  checks(hold[1] .. " square, triangles: a mesh twice as fine", math.max((want - fine) / (want - coarse), 0.25), 0.25, { absolute = 0 })
end

-- A circle.
do
  local r = 0.1
  local mesh = fabric.mesh.disk { radius = r, cells = 6 }
  local load = 1e-4 * t * 64 * D / r ^ 4
  checks("clamped circle", middle(mesh, thick, load, clamped, 0, 0), load * r ^ 4 / (64 * D), { relative = 0.015 })
  checks("supported circle", middle(mesh, thick, load, supported, 0, 0), (5 + nu) / (1 + nu) * load * r ^ 4 / (64 * D), { relative = 0.015 })
end

-- A rectangle with three rigidities of its own, the warp along x and, with the sides exchanged, along y.
do
  local a, b, B1, B2, Bt = 0.15, 0.1, 20e-6, 5e-6, 3e-6
  local card = common.sheet { young = 50e6, bending = { warp = B1, weft = B2, twist = Bt } }
  local load = 1e-3
  local want = navier(load, function(m, n) return B1 * (m / a) ^ 4 + 4 * Bt * (m / a * n / b) ^ 2 + B2 * (n / b) ^ 4 end)
  local function hold(m)
    m:fix("all", "x y"):fix("boundary", "z")
    straight(m)
  end
  local mesh = fabric.mesh.rectangle { width = a, height = b, nx = 18, ny = 12 }
  local small = 1e-6 / want * load -- deflections of a micrometre
  checks("rectangle, B1 B2 Bt", middle(mesh, card, small, hold, a / 2, b / 2), want * small / load, { relative = 0.01 })
  local function triangles(n)
    return middle(fabric.mesh.rectangle { width = a, height = b, nx = 3 * n, ny = 2 * n, triangles = true }, card, small, hold, a / 2, b / 2)
  end
  local coarse, fine = triangles(4), triangles(8)
  checks("rectangle, B1 B2 Bt, triangles, extrapolated", fine + (fine - coarse) / 3, want * small / load, { relative = 5e-3 })
  local turned = fabric.mesh.rectangle { width = b, height = a, nx = 12, ny = 18 }
  local m = fabric.model { mesh = turned, card = card, warp = 90 }
  hold(m)
  m:pressure(fabric.ramp(small, 1))
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  checks("rectangle, warp along y", run:node(common.nearest(turned, b / 2, a / 2)).uz, want * small / load, { relative = 0.01 })
end

-- A sheet of free edges twisted by forces F at its corners, up at two and down at the others: w = c x y about its middle has the twist k12 = c, whose energy 2 Bt c^2 per area is
-- half of the forces' work, so that c = F / (4 Bt) and each corner moves by F a b / (16 Bt). Bilinear elements have that shape. Along free edges the twist of quadrilaterals falls off
-- in a layer whose width goes with the element's (1/100 of the residual flexibility, [macneal1978]): a part in 500 on this mesh, half of it on one twice as fine, none extrapolated.
do
  local a, b, Bt, F = 0.14, 0.09, 4e-6, 1e-10 -- so small that it does not stretch
  local card = common.sheet { young = 50e6, bending = { warp = 30e-6, weft = 8e-6, twist = Bt } }
  local function twisted(triangles, k)
    local mesh = fabric.mesh.rectangle { width = a, height = b, nx = 7 * k, ny = 5 * k, triangles = triangles, origin = { -a / 2, -b / 2, 0 } }
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }
    m:fix("all", "x y")
    for i, at in ipairs { { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } } do
      mesh:set("corner " .. i, { common.nearest(mesh, at[1] * a / 2, at[2] * b / 2) })
      -- Three of them are held, and carry the forces that are left.
      if i == 1 then m:force("corner 1", { z = fabric.ramp(F, 1) }) else m:fix("corner " .. i, "z") end
    end
    local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
    return run, run:node(common.nearest(mesh, a / 2, b / 2)).uz
  end
  for _, triangles in ipairs { false, true } do
    local run, corner = twisted(triangles, 1)
    -- Held there, the first corner moves by as much as four do about the middle.
    local name, want = triangles and "twisted sheet of triangles: " or "twisted sheet: ", F * a * b / (4 * Bt)
    if triangles then
      checks(name .. "its corner", corner, want, { relative = 1e-4 })
    else
      local _, fine = twisted(false, 2)
      checks(name .. "its corner, extrapolated", 2 * fine - corner, want, { relative = 1e-4 })
      checks(name .. "its corner on this mesh", corner, want, { relative = 2e-3 })
    end
    local _, _, z = run:reaction "corner 3"
    checks(name .. "the corner across carries as much", z, -F + 2 * F, { relative = 1e-6 })
    _, _, z = run:reaction "corner 2"
    checks(name .. "the one beside, the other way", z, -F, { relative = 1e-6 })
  end
end

-- Two plies of unlike thickness and moduli, the upper one's warp across: pulled by N per width at the middle of both the strip bends. With A, B, D = int E (1, z, z^2) dz,
-- N = A e + B k, 0 = B e + D k, and the end goes by -k l^2 / 2 where k turns the directors towards x.
do
  local l, b, E1, E2, t1, t2, N = 0.1, 0.02, 40e6, 9e6, 0.5e-3, 0.3e-3, 1e-5
  local lower = common.sheet { warp = E1, weft = 3e6, shear = 1e7, poisson = { 0, 0 } }
  local upper = common.sheet { warp = 5e6, weft = E2, shear = 1e7, poisson = { 0, 0 } }
  local low, middle, high = -(t1 + t2) / 2, t1 - (t1 + t2) / 2, (t1 + t2) / 2
  local A, B, D = E1 * t1 + E2 * t2, (E1 * (middle ^ 2 - low ^ 2) + E2 * (high ^ 2 - middle ^ 2)) / 2, (E1 * (middle ^ 3 - low ^ 3) + E2 * (high ^ 3 - middle ^ 3)) / 3
  local e = N / (A - B * B / D)
  local k = -B / D * e
  local mesh = fabric.mesh.rectangle { width = l, height = b, nx = 8, ny = 1 }
  local m = fabric.model { mesh = mesh, layers = { { card = lower, thickness = t1 }, { card = upper, warp = 90, thickness = t2 } }, warp = 0 }
  m:fix("left", "x y z rotation"):force("right", { x = fabric.ramp(N * b, 1) })
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local p = run:node(9)
  -- So small that its deflection does not shift the line of the pull: by 5e-5 of the arm that it has.
  checks("two plies: the end's turn", p.nx, k * l, { relative = 2e-4 })
  checks("two plies: the end's deflection", p.uz, -k * l * l / 2, { relative = 2e-4 })
  checks("two plies: longer", p.ux, e * l, { relative = 2e-4 })
end

-- A sphere blown up: the force per width S t carries p r / 2 with r = lambda R, so that S = p lambda R / (2 t), and S = E / (1 - nu) (lambda^2 - 1) / 2. An eighth of it, held in its
-- planes of symmetry; the pole is left out, and the edge of that hole goes outwards as it must.
do
  local R, t, E, nu, p = 0.05, 0.4e-3, 3e6, 0.3, 3500
  local lambda = common.root(function(x) return E / (1 - nu) * (x * x - 1) / 2 - p * x * R / (2 * t) end, 1.001, 1.5)
  assert(lambda > 1.05)
  local mesh = fabric.mesh.hemisphere { radius = R, hole = 30, around = 16, along = 12 }
  local card = common.sheet { young = E, poisson = nu, thickness = t, bending = { warp = 1e-9, weft = 1e-9, twist = 1e-9 } }
  local m = fabric.model { mesh = mesh, card = card, warp = function(x, y) return { -y, x, 0 } end }
  m:symmetry("bottom", "z"):symmetry("start", "y"):symmetry("end", "x")
  for _, i in ipairs(mesh:set "top") do
    local name, X = "rim " .. i, mesh.nodes[i]
    mesh:set(name, { i })
    local move = { z = fabric.ramp((lambda - 1) * X[3], 1) }
    if X[1] > 1e-9 then move.x = fabric.ramp((lambda - 1) * X[1], 1) end
    if X[2] > 1e-9 then move.y = fabric.ramp((lambda - 1) * X[2], 1) end
    m:move(name, move)
  end
  m:pressure(fabric.ramp(p, 1))
  local run = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
  local far, near = 0, math.huge
  for i = 1, #mesh.nodes do
    local x = run:node(i)
    local r = math.sqrt(x.x ^ 2 + x.y ^ 2 + x.z ^ 2)
    far, near = math.max(far, r), math.min(near, r)
  end
  checks("sphere: widest", far / R, lambda, { relative = 2e-3 }) -- facets of 5 degrees
  checks("sphere: narrowest", near / R, lambda, { relative = 2e-3 })
  checks("sphere: stress along the equator", run:mean "S11", E / (1 - nu) * (lambda ^ 2 - 1) / 2, { relative = 0.01 })
  checks("sphere: stress across it", run:mean "S22", E / (1 - nu) * (lambda ^ 2 - 1) / 2, { relative = 0.01 })
  -- The lower edge carries p over the quarter of the circle that it closes, less what the edge of the hole carries.
  local pi4 = math.pi / 4 * (lambda * R) ^ 2
  local _, _, z = run:reaction "bottom"
  checks("sphere: held down at the equator", z, -p * pi4, { relative = 0.01 })
end

-- A membrane stretched by other amounts in its two directions and then loaded by a dead traction. In the reference the transverse motion of a stretched
-- sheet is t (S11 w,XX + S22 w,YY) = -q, exact for small w; S from the constant moduli.
do
  local a, b, E1, E2, l1, l2, t = 0.3, 0.2, 3e6, 5e6, 1.06, 1.025, 0.4e-3
  local card = common.sheet { warp = E1, weft = E2, shear = 1e6, poisson = { 0, 0 }, bending = { warp = 1e-12, weft = 1e-12, twist = 1e-12 } }
  local mesh = fabric.mesh.rectangle { width = a, height = b, nx = 18, ny = 12 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  common.each(mesh, function(name, X)
    m:move(name, { x = fabric.history { { 0, 0 }, { 1, (l1 - 1) * X[1] } }, y = fabric.history { { 0, 0 }, { 1, (l2 - 1) * X[2] } } })
  end)
  local load = 0.01
  m:fix("boundary", "z"):traction("all", { z = fabric.history { { 0, 0 }, { 1, 0 }, { 2, load } } })
  local run = fabric.static { model = m, duration = 2, step = 1 }:solve()
  local S1, S2 = E1 * (l1 ^ 2 - 1) / 2, E2 * (l2 ^ 2 - 1) / 2
  local want = navier(load, function(m, n) return t * (S1 * (m / a) ^ 2 + S2 * (n / b) ^ 2) end)
  checks("taut membrane under a traction", run:node(common.nearest(mesh, a / 2, b / 2)).uz, want, { relative = 0.01 })
  local _, _, up = run:reaction "all"
  checks("taut membrane: the frame carries the load", up, -load * a * b, { relative = 1e-8 }) -- 1e-10 of the tension's forces
end

-- Hencky's circle for nu = 0.2, by integration of its two equations from the middle (Foeppl's membrane, small slopes). With radial force N and hoop
-- force M per width, slope f = w': (r N)' = M, N f = -p r / 2, compatibility (M - nu N)' r = -(1 + nu) (M - N) - E t f^2 / 2, held rim: M = nu N.
-- In r = a x, N = (p^2 a^2 E t)^(1/3) y: y' = (z - y) / x, z' = nu y' - (1 + nu) (z - y) / x - x / (8 y^2).
do
  local a, t, E, nu = 0.5, 1e-4, 1e8, 0.2
  local p = 2e-6 * E * t / a
  local function rim(y0)
    -- About the middle y = z = y0 - x^2 / (64 y0^2) and three times that for z: the start of the series.
    local x0 = 1e-3
    local c = 1 / (64 * y0 ^ 2)
    local end_ = common.integrate(function(x, s)
      local y, z = s[1], s[2]
      local dy = (z - y) / x
      return { dy, nu * dy - (1 + nu) * (z - y) / x - x / (8 * y * y), x / (2 * y) }
    end, x0, 1, { y0 - c * x0 ^ 2, y0 - 3 * c * x0 ^ 2, x0 ^ 2 / (4 * y0) }, 2000)
    return end_[2] - nu * end_[1], end_[3]
  end
  local y0 = common.root(function(y) return (rim(y)) end, 0.3, 0.7)
  local _, depth = rim(y0)
  local want = depth * a * (p * a / (E * t)) ^ (1 / 3)
  local mesh = fabric.mesh.disk { radius = a, cells = 6 }
  mesh:set("core", function(x, y) return x * x + y * y < (0.25 * a) ^ 2 end) -- four elements
  local card = common.sheet { young = E, poisson = nu, thickness = t, bending = { warp = 1e-9, weft = 1e-9, twist = 1e-9 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local taut, rest = 1e-4, fabric.history { { 0, 0 }, { 0.1, 0 }, { 0.5, p } }
  for i, node in ipairs(mesh:set "boundary") do
    local X, name = mesh.nodes[node], "rim " .. i
    mesh:set(name, { node })
    local function draw(x) return fabric.history { { 0, 0 }, { 0.1, taut * x }, { 0.5, taut * x }, { 1, 0 } } end
    m:move(name, { x = draw(X[1]), y = draw(X[2]) })
  end
  m:fix("boundary", "z"):pressure(rest)
  local run = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
  checks("membrane of Hencky, nu = 0.2: middle", run:node(mesh:set("centre")[1]).uz, want, { relative = 5e-3 })
  -- The mean of both directions is y0 - 2 c x^2, and over the four squares of the side h about the middle x^2 has the mean 2/3 (h / a)^2.
  local h = 0
  for _, node in ipairs(mesh:set "core") do h = math.max(h, math.abs(mesh.nodes[node][1]), math.abs(mesh.nodes[node][2])) end
  local mean = y0 - 2 / (64 * y0 ^ 2) * 2 / 3 * (h / a) ^ 2
  checks("membrane of Hencky, nu = 0.2: force in the middle", run:mean("S11", "core") * t, mean * (p ^ 2 * a ^ 2 * E * t) ^ (1 / 3), { relative = 0.01 })
end
checks()
