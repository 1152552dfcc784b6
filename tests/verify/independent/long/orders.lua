-- The closed forms of the quick decks on finer and finer meshes: their errors fall with the square of the element's size, which tells a formula that is nearly right from
-- one that is right.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "../common.lua")))
local checks = common.checks()

-- error(n) on the meshes given; their ratios from mesh to mesh, each twice as fine, tend to 4.
local function order(name, sizes, least, most, error)
  local last
  for _, n in ipairs(sizes) do
    local now = error(n)
    print(("  %-40s %4d elements %12.4e%s"):format(name, n, now, last and ("  ratio %.2f"):format(last / now) or ""))
    if last and n == sizes[#sizes] then checks(name .. ": error over that of a mesh twice as fine", last / now, (least + most) / 2, { absolute = (most - least) / 2 }) end
    last = now
  end
end

-- Plates. Supported, with no turning along the edges: Navier's series for the bending and for the shear across, 16 q / (pi^2 m n) over D (m^2 + n^2)^2 (pi / a)^4 and over
-- 5/6 G t (m^2 + n^2) (pi / a)^2, exact for any thickness. Clamped: 0.00126532 q a^4 / D [timoshenko1959, article 44] for a thin plate; shear adds (t / a)^2.
-- The residual flexibility of quadrilaterals takes away most of the clamped plate's error, the arcs of triangles that of a thin supported one: what is left falls faster
-- than the square, or changes its sign. A supported plate a tenth as thick as wide has an error to be seen.
do
  local E, nu, side = 4e8, 0.3, 0.2
  for _, case in ipairs { { "clamped", 0.25e-3 }, { "supported", 20e-3 } } do
    local t = case[2]
    local D, shear = E * t ^ 3 / (12 * (1 - nu ^ 2)), 5 / 6 * E / (2 * (1 + nu)) * t
    local q = 1e-4 * t * D / side ^ 4 / 0.0013
    local want = 0.00126532 * q * side ^ 4 / D
    if case[1] == "supported" then
      want = 0
      for m = 1, 199, 2 do
        for n = 1, 199, 2 do
          local k = (m * m + n * n) * (math.pi / side) ^ 2
          want = want + 16 * q / (math.pi ^ 2 * m * n) * (-1) ^ ((m - 1) // 2 + (n - 1) // 2) * (1 / (D * k * k) + 1 / (shear * k))
        end
      end
    end
    for _, triangles in ipairs { false, true } do
      -- The closed form of the clamped plate, which has no transverse shear, errs by 3e-5, as 32 quadrilaterals or 64 triangles along a side do.
      local thin = case[1] == "clamped"
      local sizes = thin and { 4, 8, 16, triangles and 32 or nil } or { 8, 16, 32, triangles and 64 or nil }
      order(case[1] .. (triangles and " plate, triangles" or " plate"), sizes, 3.4, not thin and 4.6 or triangles and 8 or 16, function(n)
        local mesh = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n, triangles = triangles }
        local m = fabric.model { mesh = mesh, card = common.sheet { young = E, poisson = nu, thickness = t }, warp = 0, points = 2 }
        if case[1] == "clamped" then
          m:fix("boundary", "x y z rotation")
        else
          m:fix("boundary", "x y z"):fix("left", "rx"):fix("right", "rx"):fix("bottom", "ry"):fix("top", "ry")
        end
        m:pressure(fabric.ramp(q, 1))
        local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
        return math.abs(a:node(common.nearest(mesh, side / 2, side / 2)).uz / want - 1)
      end)
    end
  end
end

-- A heavy strip that hangs from its edge, by shooting.
do
  local l, B, w, width = 0.045, 14e-6, 0.2 * 9.81, 0.02
  local function hang(k0)
    return common.integrate(function(s, y) return { y[2], -w * (l - s) * math.cos(y[1]) / B, math.cos(y[1]), math.sin(y[1]) } end, 0, l, { 0, k0, 0, 0 }, 4000)
  end
  local want = hang(common.root(function(k) return hang(k)[2] end, 0, 200))
  order("heavy strip", { 10, 20, 40, 80 }, 3.6, 4.4, function(n)
    local mesh = fabric.mesh.rectangle { width = l, height = width, nx = n, ny = 1 }
    -- So stiff in its plane that stretch does not show.
    local m = fabric.model { mesh = mesh, card = common.sheet { young = 3e9, bending = { warp = B, weft = B / 3, twist = B / 4 } }, warp = 0 }
    m:fix("left", "x y z rotation"):traction("all", { z = fabric.ramp(-w, 1) })
    local a = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
    local p = a:node(n + 1)
    return math.sqrt((p.x - want[3]) ^ 2 + (p.z + want[4]) ^ 2) / l
  end)
end

-- A taut sheet's frequency, implicit with a step that falls with the mesh, and explicit.
for _, scheme in ipairs { "implicit", "explicit" } do
  local a, b, E1, E2, l1, l2, rho = 0.3, 0.2, 3e6, 5e6, 1.05, 1.03, 450
  local S1, S2 = E1 * (l1 ^ 2 - 1) / 2, E2 * (l2 ^ 2 - 1) / 2
  local f = 0.5 * math.sqrt((S1 / a ^ 2 + S2 / b ^ 2) / rho)
  order("taut sheet, " .. scheme, { 4, 8, 16 }, 3.5, 4.5, function(n)
    local mesh = fabric.mesh.rectangle { width = a, height = b, nx = n, ny = n }
    local card = common.sheet { warp = E1, weft = E2, shear = 1e6, poisson = { 0, 0 }, density = rho, bending = { warp = 1e-12, weft = 1e-12, twist = 1e-12 } }
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }
    mesh:set("inside", function(x, y) return x > 1e-9 and x < a - 1e-9 and y > 1e-9 and y < b - 1e-9 end)
    common.each(mesh, function(name, X) m:move(name, { x = (l1 - 1) * X[1], y = (l2 - 1) * X[2] }) end)
    m:fix("boundary", "z"):velocity("inside", function(x, y) return { z = 1e-4 * math.sin(math.pi * x / a) * math.sin(math.pi * y / b) } end)
    local run = fabric.dynamic { model = m, duration = 3.1 / f, scheme = scheme, step = scheme == "implicit" and 0.08 / f / n or nil, inertia = "true" }
    local zero, middle = common.crossings(), common.nearest(mesh, a / 2, b / 2)
    run:every("step", function(r) zero.see(r.time, r:node(middle).uz) end)
    run:solve()
    return math.abs(1 / zero.period() / f - 1)
  end)
end

-- A tube under pressure: facets around.
do
  local R, length, E, t, p = 0.04, 0.02, 2.5e6, 0.4e-3, 2200
  local card = common.sheet { warp = 2 * E, weft = E, shear = 1e6, poisson = { 0, 0 }, thickness = t, bending = { warp = 1e-9, weft = 1e-9, twist = 1e-9 } }
  order("tube", { 16, 32, 64, 128 }, 3.6, 4.4, function(n)
    local mesh = fabric.mesh.cylinder { radius = R, length = length, around = n, along = 1 }
    local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 } }
    mesh:set("on x", function(_, y) return math.abs(y) < 1e-6 end)
    mesh:set("on y", function(x) return math.abs(x) < 1e-6 end)
    m:fix("all", "z"):fix("on x", "y"):fix("on y", "x"):pressure(fabric.history { { 0, 0 }, { 1, p } })
    local a = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
    return math.abs(a:mean "E22" / (p * R / t / E) - 1)
  end)
end

-- A chain's sag.
do
  local l, span, b, t, young, rho, g = 0.6, 0.57, 0.03, 0.5e-3, 1.2e5, 600, 9.81
  local w, k = rho * t * b * g, young * t * b
  local function half(H)
    return common.integrate(function(s)
      local T = math.sqrt(H * H + (w * s) ^ 2)
      local x = common.root(function(q) return k * q * (q * q - 1) / 2 - T end, 1, 3)
      return { x * H / T, x * w * s / T }
    end, 0, l / 2, { 0, 0 }, 200)
  end
  local H = common.root(function(x) return half(x)[1] - span / 2 end, 1e-3 * w, 100 * w)
  local sag = half(H)[2]
  order("chain", { 10, 20, 40, 80 }, 3.6, 4.4, function(n)
    local mesh = fabric.mesh.rectangle { width = l, height = b, nx = n, ny = 1 }
    local c = common.sheet { young = young, thickness = t, density = rho, bending = { warp = 1e-12, weft = 1e-12, twist = 1e-12 } }
    local m = fabric.model { mesh = mesh, card = c, warp = 0 }
    m:fix("left", "x z"):fix("right", "z"):fix("all", "y rx rz")
    m:move("right", { x = fabric.history { { 0, 0 }, { 0.1, 0.01 }, { 0.3, 0.01 }, { 1, span - l } } })
    m:traction("all", { z = fabric.history { { 0, 0 }, { 0.1, 0 }, { 0.3, -rho * t * g } } })
    local a = fabric.static { model = m, duration = 1, step = 0.05 }:solve()
    return math.abs(-a:node(n // 2 + 1).uz / sag - 1)
  end)
end
checks()
