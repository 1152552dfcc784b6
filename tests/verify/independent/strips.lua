-- Strips: bent by moments and by their weight where the rigidity depends on the curvature, pushed beyond their buckling, hung as a chain, drawn
-- over springs; friction of bending. Each against an integration of its own.
--
-- The elastica: along a strip of arc length s, angle phi and curvature k = phi', the moment per width M(k) = int B dk falls by the force across the strip
-- that the rest of it carries, dM/ds = -w (l - s) cos phi under the weight w per area. The stretch is left out: E t is 1e5 times what pulls.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()

local g, width = 9.81, 0.02
local function card(bending, more)
  local t = { young = 30e6, density = 500, thickness = 0.4e-3, bending = bending }
  for k, v in pairs(more or {}) do t[k] = v end
  return common.sheet(t)
end
local weight = 0.2 * g -- N/m^2 of the standard card
local function strip(length, n, triangles) return fabric.mesh.rectangle { width = length, height = width, nx = n, ny = 1, triangles = triangles } end
local function tip(mesh, length) return common.nearest(mesh, length, 0) end

-- A cantilever of B(k) = b0 + b1 k under its weight: M = b0 k + b1 k^2 / 2 for k >= 0. Shooting for the curvature at the edge; none is left at the end.
do
  local l, b0, b1 = 0.045, 16e-6, -0.05e-6
  local function hang(k0)
    return common.integrate(function(s, y)
      local k = y[2]
      return { k, -weight * (l - s) * math.cos(y[1]) / (b0 + b1 * math.abs(k)), math.cos(y[1]), math.sin(y[1]) }
    end, 0, l, { 0, k0, 0, 0 }, 1000)
  end
  local k0 = common.root(function(k) return hang(k)[2] end, 0, 150)
  local want = hang(k0)
  -- Downwards is the other way for the strip, so that its curvature is negative: the law is odd.
  local c = card { warp = { b0, b1 }, weft = 3e-6, twist = 2e-6, tested = 200 }
  for _, kind in ipairs { "quadrilaterals", "triangles" } do
    local mesh = strip(l, 40, kind == "triangles")
    local m = fabric.model { mesh = mesh, card = c, warp = 0 }:fix("left", "x y z rotation"):traction("all", { z = fabric.ramp(-weight, 1) })
    local a = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
    local p = a:node(tip(mesh, l))
    checks("heavy strip of B(k), " .. kind .. ": reach", p.x / l, want[3] / l, { absolute = 2e-3 }) -- of the length; 40 elements: h^2
    checks("heavy strip of B(k), " .. kind .. ": drop", -p.z / l, want[4] / l, { absolute = 2e-3 })
    local _, _, up = a:reaction "left"
    checks("heavy strip of B(k), " .. kind .. ": support", up, weight * l * width, { relative = 1e-7 })
  end
  -- Let down in damped motion: the same shape, once it rests. Softer in its plane, for the explicit step.
  for _, scheme in ipairs { "implicit", "explicit" } do
    local mesh = strip(l, 20)
    local m = fabric.model { mesh = mesh, card = card({ warp = { b0, b1 }, weft = 3e-6, twist = 2e-6, tested = 200 }, { young = 2e6 }), warp = 0 }
    m:fix("left", "x y z rotation"):gravity { 0, 0, function(time) return time < 0.3 and -g * (1 - math.cos(math.pi * time / 0.3)) / 2 or -g end }
    local a = fabric.dynamic { model = m, duration = 1.1, scheme = scheme, step = scheme == "implicit" and 0.01 or nil, damping = { mass = 30 } }:solve()
    local p = a:node(tip(mesh, l))
    checks("heavy strip of B(k), " .. scheme .. ": reach", p.x / l, want[3] / l, { absolute = 2e-3 }) -- 20 elements; stretched by 2e-4
    checks("heavy strip of B(k), " .. scheme .. ": drop", -p.z / l, want[4] / l, { absolute = 2e-3 })
    checks("heavy strip of B(k), " .. scheme .. ": at rest", a.energy.kinetic / a.energy.stored, 0, { absolute = 1e-6 })
  end
end

-- Moment and curvature: end moments M bend a strip to an arc of the curvature k with b0 k + b1 k^2 / 2 + M_f = M (friction slips all the way), whose chord is
-- 2 sin(k l / 2) / k; let go to a fifth of it the friction moment has turned over: b0 k + b1 k^2 / 2 - M_f = M / 5.
do
  local l, b0, b1, Mf, kf, n = 0.06, 12e-6, -0.05e-6, 0.15e-3, 4, 24
  local function curvature(M) return common.root(function(k) return b0 * k + b1 * k * k / 2 - M end, 0, 100) end
  local M = 0.9e-3
  for _, axis in ipairs { "warp", "weft" } do
    local c = card(axis == "warp" and { warp = { b0, b1 }, weft = 4e-6, twist = 3e-6, tested = 120, friction_warp = { moment = Mf, curvature = kf } }
      or { weft = { b0, b1 }, warp = 4e-6, twist = 3e-6, tested = 120, friction_weft = { moment = Mf, curvature = kf } })
    local mesh = strip(l, n)
    -- Moments about y; the weft lies along the strip where the warp is turned by 90 degrees.
    local m = fabric.model { mesh = mesh, card = c, warp = axis == "warp" and 0 or 90 }
    m:fix("left", "x y z rotation"):moment("right", { y = fabric.history { { 0, 0 }, { 1, M * width }, { 2, M / 5 * width } } })
    local a = fabric.static { model = m, duration = 2, step = 0.0125 }
    for time, k in ipairs { curvature(M - Mf), curvature(M / 5 + Mf) } do
      a:advance(time)
      local p = a:node(tip(mesh, l))
      local turned = math.abs(math.atan(p.nx, p.nz))
      checks(("moment and curvature along the %s, %s: angle of the end"):format(axis, time == 1 and "up" or "back"), turned, math.acos(math.cos(k * l)), { relative = 1e-4 })
      checks(("moment and curvature along the %s, %s: chord"):format(axis, time == 1 and "up" or "back"), math.sqrt(p.x ^ 2 + p.z ^ 2),
        2 / k * math.sin(k * l / 2), { relative = 2e-3 })
    end
    -- All that was stored and lost is the moment's work, the area under its angle.
    checks("moment and curvature along the " .. axis .. ": ledger", a.energy.stored + a.energy.dissipated, a.energy.external, { relative = 5e-3 }) -- trapezoids over kinks of friction
    local lost = (curvature(M - Mf) - kf + curvature(M - Mf) - curvature(M / 5 + Mf) - 2 * kf) * Mf * l * width
    checks("moment and curvature along the " .. axis .. ": lost to friction", a.energy.dissipated_bending, lost, { relative = 2e-3 })
  end
end

-- Friction of bending in a point, closed cycles between k1 and -k2: the loop's area is 2 M_f (k1 + k2 - 2 k_f) where friction slips (k_f: over which it builds up).
-- The fading kind, m' = M_f / k_f (1 -+ m / M_f): int over both branches, by an integration of its own.
do
  local Mf, kf, k1, k2, B = 0.3e-3, 7, 90, 60, 9e-6
  for _, memory in ipairs { "slip", "fading" } do
    local c = card { warp = B, weft = B / 3, twist = B / 5, friction_warp = { moment = Mf, curvature = kf, memory = memory } }
    local p, before = fabric.point(c), nil
    for _, k in ipairs { k1, -k2, k1 } do before = p:bend { k11 = k } end
    local steps, area, last = 3000, 0, before
    for i = 1, steps do
      local x = i / steps
      local now = p:bend { k11 = x < 0.5 and k1 - (k1 + k2) * 2 * x or -k2 + (k1 + k2) * (2 * x - 1) }
      area = area + (last.M11 + now.M11) / 2 * (now.k11 - last.k11)
      last = now
    end
    local want = 2 * Mf * (k1 + k2 - 2 * kf)
    if memory == "fading" then
      -- From -k2 up: m' = (M_f - m) / k_f; from k1 down: m' = -(M_f + m) / k_f. In the closed cycle m(k1) = -m(-k2) = m1.
      local long = math.exp(-(k1 + k2) / kf)
      local m1 = Mf * (1 - long) / (1 + long)
      local up = common.integrate(function(_, y) return { (Mf - y[1]) / kf, y[1] } end, -k2, k1, { -m1, 0 }, 4000)
      want = 2 * up[2]
    end
    checks("friction of bending, " .. memory .. ": area of the loop", area, want, { relative = 1e-4 })
    checks("friction of bending, " .. memory .. ": dissipated", last.dissipated - before.dissipated, want, { relative = 1e-6 })
    checks("friction of bending, " .. memory .. ": across is elastic", p:bend { k22 = 30 }.M22, 30 * B / 3, { relative = 1e-12 })
  end
end

-- A strip clamped at one end and pushed at the other, free, end: the elastica of Euler. For the end angle alpha, k = sin(alpha / 2):
--   P = B K(k)^2 / l^2, x = l (2 E(k) / K(k) - 1), z = l 2 k / K(k)
-- with the complete elliptic integrals by the arithmetic-geometric mean. A thousandth of the load across shows the way.
do
  local l, B, n = 0.08, 11e-6, 32
  local function elliptic(k)
    local a, b, c, sum, power = 1, math.sqrt(1 - k * k), k, k * k / 2, 0.5
    while c > 1e-16 do
      a, b, c = (a + b) / 2, math.sqrt(a * b), (a - b) / 2
      power = 2 * power
      sum = sum + power * c * c
    end
    local K = math.pi / (2 * a)
    return K, K * (1 - sum)
  end
  local mesh = strip(l, n)
  local m = fabric.model { mesh = mesh, card = card { warp = B, weft = B / 2, twist = B / 4 }, warp = 0 }
  local euler = math.pi ^ 2 * B / (4 * l ^ 2) * width
  local K, E = elliptic(math.sin(math.rad(35)))
  local load = B * K ^ 2 / l ^ 2 * width
  assert(load > 1.1 * euler)
  -- A push across shows the way while the load comes, and is taken away under it: what is left is the elastica.
  m:fix("left", "x y z rotation"):force("right", { x = fabric.history { { 0, 0 }, { 1, -load }, { 2, -load } },
    z = fabric.history { { 0, 0 }, { 0.1, 0.05 * euler }, { 1, 0.05 * euler }, { 2, 0 } } })
  local a = fabric.static { model = m, duration = 2, step = 0.05 }:solve()
  local p = a:node(tip(mesh, l))
  local k = math.sin(math.rad(35))
  checks("beyond buckling: end's angle, degrees", math.deg(math.atan(math.abs(p.nx), p.nz)), 70, { relative = 5e-3 }) -- h^2, 1/n^2 of the load
  checks("beyond buckling: end's place along", p.x / l, 2 * E / K - 1, { absolute = 3e-3 })
  checks("beyond buckling: end's place across", p.z / l, 2 * k / K, { absolute = 3e-3 })
  checks("beyond buckling: stable", a.steps[#a.steps].negative_pivots, 0, { absolute = 0 })
end

-- Two bars that snap through, von Mises' truss, by half: span b and height h of a bar, length L; at the height z its strain is (z^2 - h^2) / (2 L^2) and the
-- half of the load that holds the joint F = E A (h^2 - z^2) z / (2 L^3), largest at z = h / sqrt 3. By arc length through the limit point and the lower one.
-- The bar has one element, which stays straight. The path goes back to loads below zero, so its history begins there.
do
  local b, h, young, t = 0.1, 0.03, 4e7, 1e-3
  local L = math.sqrt(b * b + h * h)
  for _, triangles in ipairs { false, true } do
    local mesh = fabric.mesh.rectangle { width = b, height = width, nx = 1, ny = 1, triangles = triangles }
    mesh:map(function(x, y) return x, y, h * x / b end)
    local c = common.sheet { young = young, thickness = t, bending = { warp = 10e-6, weft = 1e-6, twist = 1e-6 } }
    local m = fabric.model { mesh = mesh, card = c, warp = { 1, 0, 0 } }
    local top = young * t * width / 2 * (h ^ 2 - h ^ 2 / 3) * h / math.sqrt(3) / L ^ 3
    local load = fabric.history { { 0, 1.2 * top }, { 1, -1.5 * top } }
    m:fix("all", "y rx rz"):fix("left", "x z"):fix("right", "x"):force("right", { z = load })
    local a = fabric.static { model = m, duration = 1, step = 0.02, control = "arc" }
    local worst, most, back = 0, 0, math.huge
    local function force(z) return young * t * width / 2 * (h ^ 2 - z ^ 2) * z / L ^ 3 end
    a:every("step", function(run)
      if run.time == 0 then return end
      local z, F = h + run:node(2).uz, -load:value(run.time)
      worst = math.max(worst, math.abs(F - force(z)) / top)
      if z > 0 then most = math.max(most, F) elseif z > -h then back = math.min(back, F) end
    end)
    a:solve()
    local name = triangles and "truss of triangles: " or "truss: "
    checks(name .. "the path, of its limit load", worst, 0, { absolute = 1e-7 }) -- Newton's tolerance
    checks(name .. "limit load, seen in steps", most, top, { relative = 0.01 }) -- the top of a parabola between two steps
    checks(name .. "lower limit load", back, -top, { relative = 0.01 })
    checks(name .. "beyond", h + a:node(2).uz, common.root(function(z) return force(z) - 1.5 * top end, -2 * h, -h), { relative = 1e-8 })
  end
end

-- A strip that stretches, hung from two ends at the same height: H is constant, T^2 = H^2 + (w x s)^2 along the unstretched length s from the middle, and
-- dx/ds = lambda H / T, dz/ds = lambda w s / T with lambda from T = E t b lambda (lambda^2 - 1) / 2. Shooting for H.
do
  local l, span, b, t, young, rho = 0.6, 0.57, 0.03, 0.5e-3, 1.2e5, 600
  local w, k = rho * t * b * g, young * t * b
  local function stretch(T) return common.root(function(x) return k * x * (x * x - 1) / 2 - T end, 1, 3) end
  local function half(H)
    return common.integrate(function(s)
      local T = math.sqrt(H * H + (w * s) ^ 2)
      local x = stretch(T)
      return { x * H / T, x * w * s / T }
    end, 0, l / 2, { 0, 0 }, 60)
  end
  local H = common.root(function(x) return half(x)[1] - span / 2 end, 1e-3 * w, 100 * w)
  local sag = half(H)[2]
  local mesh = fabric.mesh.rectangle { width = l, height = b, nx = 60, ny = 1 }
  local c = common.sheet { young = young, thickness = t, density = rho, bending = { warp = 1e-9, weft = 1e-9, twist = 1e-9 } }
  local m = fabric.model { mesh = mesh, card = c, warp = 0 }
  m:fix("left", "x z"):fix("right", "z"):fix("all", "y rx rz")
  m:move("right", { x = fabric.history { { 0, 0 }, { 0.1, 0.01 }, { 0.3, 0.01 }, { 1, span - l } } })
  m:traction("all", { z = fabric.history { { 0, 0 }, { 0.1, 0 }, { 0.3, -rho * t * g } } })
  local a = fabric.static { model = m, duration = 1, step = 0.05 }:solve()
  local x, _, z = a:reaction "left"
  checks("chain: horizontal force", -x, H, { relative = 1e-3 })
  checks("chain: upward force at an end", z, w * l / 2, { relative = 1e-7 })
  checks("chain: sag", -a:node(31).uz, sag, { relative = 1e-3 })
end

-- Wrinkles on a foundation: a strip of rigidity B, pushed together by P per width, on springs K per area, under a load q cos(k x) has the amplitude
-- q / (B k^4 - P k^2 + K). The largest is that of k^2 = P / (2 B): with P = 1.6 sqrt(B K) wrinkles of the length 2 pi (B / K)^(1/4) / sqrt 0.8, whatever B and K.
-- Straight elements of the length h have the slopes s = 2 / h sin(k h / 2) where those of cos(k x) are k, and with the directors b sin(k x) the curvature
-- b s and the shear s + b cos(k h / 2). An eighth of the residual flexibility h^2 / (12 B) of [macneal1978] is in series with their shear, which is stiff. With
-- the least energy over b, B k^4 becomes B s^4 / (cos^2 + s^2 h^2 / 96), P k^2 becomes P s^2, by (k h)^2 / 14 more and (k h)^2 / 12 less.
do
  local l, t, young, n = 0.24, 0.4e-3, 30e6, 96
  for _, case in ipairs { { B = 8e-6, K = 260 }, { B = 8e-6, K = 16 * 260 }, { B = 2e-6, K = 260 } } do
    local B, K = case.B, case.K
    local P = 1.6 * math.sqrt(B * K) -- below 2 sqrt(B K), where the strip buckles
    local strain = -P / (young * t) -- P = -t S11, in the reference
    local mesh = strip(l, n)
    local function amplitude(k)
      local m = fabric.model { mesh = mesh, card = card({ warp = B, weft = B / 2, twist = B / 3 }, { thickness = t, young = young }), warp = 0 }
      m:fix("all", "y"):fix("left", "ry"):fix("right", "ry"):spring("all", { z = K * l * width })
      common.each(mesh, function(name, X)
        m:move(name, { x = fabric.ramp((math.sqrt(1 + 2 * strain) - 1) * X[1], 1) })
        local share = (X[1] < 1e-9 or X[1] > l - 1e-9) and 0.5 or 1
        m:force(name, { z = fabric.history { { 0, 0 }, { 1, 0 }, { 2, 1e-6 * math.cos(k * X[1]) * share * width / 2 * l / n } } })
      end)
      local a = fabric.static { model = m, duration = 2, step = 1 }:solve()
      return math.abs(a:node(1).uz) / 1e-6
    end
    local expected, best, best_k, off, of_nodes = math.floor(math.sqrt(P / (2 * B)) * l / math.pi + 0.5), 0, nil, 0, 0
    for waves = expected - 3, expected + 3 do
      local k = math.pi * waves / l
      local h, got = l / n, amplitude(k)
      local s, c = 2 / h * math.sin(k * h / 2), math.cos(k * h / 2)
      local below = B * k ^ 4 - P * k ^ 2 + K
      local bound = (k * h) ^ 2 / 12 * (B * k ^ 4 + P * k ^ 2) / below
      of_nodes = math.max(of_nodes, math.abs(got * (B * s ^ 4 / (c * c + s * s * h * h / 96) - P * s * s + K) - 1))
      off = math.max(off, math.abs(got * below - 1) / bound)
      if got > best then best, best_k = got, k end
    end
    checks(("wrinkles, B %g, K %g: amplitudes, over the mesh's error"):format(B, K), off, 0, { absolute = 1.3 })
    checks(("wrinkles, B %g, K %g: amplitudes of straight elements"):format(B, K), of_nodes, 0, { absolute = 1e-3 })
    checks(("wrinkles, B %g, K %g: number in the strip"):format(B, K), best_k * l / math.pi, expected, { absolute = 1 })
    checks(("wrinkles, B %g, K %g: scaling of their length"):format(B, K), 2 * math.pi / best_k * (K / B) ^ 0.25 * math.sqrt(0.8), 2 * math.pi,
      { relative = 1 / expected })
  end
end
checks()
