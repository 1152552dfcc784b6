-- The models of other programs' laws where stretches differ, yarns have turned far and stresses press: against the pull-back of a stress in space, which is
-- done here with matrices, and against the work of a change.
local fabric = require "fabric"
local laws = require "fabric.export.laws"
local checks = {}
local function check(name, got, want, relative) checks[#checks + 1] = { name, got, want, relative = relative or 1e-9 } end

-- A sheet with stretches l1, l2 along its yarns, the warp along x, the weft turned towards it by `angle` degrees: F = [l1, l2 sin; 0, l2 cos].
local function sheet(l1, l2, angle)
  local s, c = math.sin(math.rad(angle)), math.cos(math.rad(angle))
  return { l1, l2 * s, l2 * c }, { (l1 * l1 - 1) / 2, (l2 * l2 - 1) / 2, l1 * l2 * s / 2 }, s, c
end

-- S = J F^-1 sigma F^-T of a Cauchy stress (xx, yy, xy): F^-1 = [1/a, -b/(a d); 0, 1/d] for F = [a, b; 0, d].
local function pulled_back(F, xx, yy, xy)
  local a, b, d = F[1], F[2], F[3]
  local p, q, r = 1 / a, -b / (a * d), 1 / d
  local J = a * d
  return J * (p * p * xx + 2 * p * q * xy + q * q * yy), J * r * r * yy, J * (p * r * xy + q * r * yy)
end

-- Stresses s1, s2 along the yarns and tau between them: s1 a a + s2 b b + tau (a b + b a), a = (1, 0), b = (sin, cos).
local function along_yarns(s1, s2, tau, s, c) return s1 + s2 * s * s + 2 * tau * s, s2 * c * c, s2 * s * c + tau * c end

-- *MAT_235: half of each family of yarns per area, over the logarithm of the stretch; the shear modulus is a share of G12 up to the locking angle, G12 beyond it.
do
  local E1, E2, G, share, lock = 40e6, 90e6, 3e6, 0.2, 36 -- THL: between the yarns at locking, 90 - 2 THL = 18 degrees of shear
  local law = laws.mat_235 { E1 = E1, E2 = E2, G12 = G, DSCF = share, THL = lock }
  for _, case in ipairs { { 1.12, 1.03, 11 }, { 1.12, 1.03, 29 }, { 0.97, 1.08, -25 }, { 1.02, 0.99, -17.9 }, { 1.02, 0.99, 18.1 } } do
    local l1, l2, angle = table.unpack(case)
    local F, E, s, c = sheet(l1, l2, angle)
    local size = math.rad(math.abs(angle))
    local free = math.rad(90 - 2 * lock)
    local tau = size <= free and share * G * size or share * G * free + G * (size - free)
    if angle < 0 then tau = -tau end
    local k = (E1 + E2) / 2
    local S11, S22, S12 = pulled_back(F, along_yarns(k * math.log(l1), k * math.log(l2), tau, s, c))
    local g11, g22, g12 = law:stress(E[1], E[2], E[3])
    local name = ("MAT_235 at %g, %g, %g degrees: "):format(l1, l2, angle)
    check(name .. "S11", g11, S11)
    check(name .. "S22", g22, S22)
    check(name .. "S12", g12, S12)
  end
end

-- LAW19: linear orthotropic over logarithmic strain in axes along the yarns; of principal stresses, those that press are RE of what they are.
do
  local E11, E22, nu, G, RE = 8e6, 20e6, 0.3, 2e6, 0.25
  local law = laws.law19 { E11 = E11, E22 = E22, NU12 = nu, G12 = G, RE = RE }
  local q = 1 - nu * nu * E22 / E11
  for _, case in ipairs { { 1.1, 1.04, 8 }, { 1.06, 0.95, 15 }, { 0.95, 1.02, -12 }, { 0.96, 0.93, 3 } } do
    local l1, l2, angle = table.unpack(case)
    local F, E = sheet(l1, l2, angle)
    local e1, e2 = math.log(l1), math.log(l2)
    local xx, yy = (E11 * e1 + nu * E22 * e2) / q, (nu * E22 * e1 + E22 * e2) / q
    local xy = G * math.rad(angle)
    -- Principal stresses and the direction of the larger one.
    local turn = math.atan(2 * xy, xx - yy) / 2
    local cc, ss = math.cos(turn), math.sin(turn)
    local big, small = xx * cc * cc + yy * ss * ss + 2 * xy * cc * ss, xx * ss * ss + yy * cc * cc - 2 * xy * cc * ss
    local function pressed(x) return x < 0 and RE * x or x end
    big, small = pressed(big), pressed(small)
    xx, yy, xy = big * cc * cc + small * ss * ss, big * ss * ss + small * cc * cc, (big - small) * cc * ss
    -- Its axes are taken along the yarns, so that J, l1, l2 alone go between the two stresses.
    local J = F[1] * F[3]
    local g11, g22, g12 = law:stress(E[1], E[2], E[3])
    local name = ("LAW19 at %g, %g, %g degrees: "):format(l1, l2, angle)
    check(name .. "S11", g11, xx * J / l1 ^ 2)
    check(name .. "S22", g22, yy * J / l2 ^ 2)
    check(name .. "S12", g12, xy * J / (l1 * l2))
  end
end

-- *FABRIC: nominal stresses T1, T2 and T12, conjugate to the stretches and to the angle: S:dE = T1 dl1 + T2 dl2 + T12 dg for any change, which differences show.
do
  local line = function(k) return { loading = { x = { -0.5, 0, 1 }, y = { -0.5 * k, 0, k } }, unloading = { x = { 0, 1 }, y = { 0, 3 * k } } } end
  local k1, k2, k3 = 30e6, 70e6, 2e6
  local law = laws.fabric { warp = line(k1), weft = line(k2), shear = line(k3) }
  for _, case in ipairs { { 1.1, 1.02, 20 }, { 1.03, 1.15, -33 } } do
    local l1, l2, angle = table.unpack(case)
    local _, E = sheet(l1, l2, angle)
    local S = { law:stress(E[1], E[2], E[3]) }
    local T = { k1 * (l1 - 1), k2 * (l2 - 1), k3 * math.rad(angle) }
    local h = 1e-6
    for i, name in ipairs { "l1", "l2", "angle" } do
      local function at(d)
        local _, e = sheet(l1 + (i == 1 and d or 0), l2 + (i == 2 and d or 0), angle + (i == 3 and math.deg(d) or 0))
        return e
      end
      local up, down, work = at(h), at(-h), 0
      for j = 1, 3 do work = work + (j == 3 and 2 or 1) * S[j] * (up[j] - down[j]) / (2 * h) end
      check(("FABRIC at %g, %g, %g degrees: work of a change of %s"):format(l1, l2, angle, name), work, T[i], 1e-7)
    end
  end
end

-- LAW58 and LAW158 with yarns that are nearly straight: the force per initial width of the sheet over the elongation, S = force / stretch, each yarn by its own
-- stretch; the shear stress over the angle.
for name, make in pairs { LAW58 = laws.law58, LAW158 = laws.law158 } do
  local function line(k) return { loading = { x = { -1, 0, 1 }, y = { -k, 0, k } }, unloading = { x = { 0, 1 }, y = { 0, 2 * k } }, meet = { 1, k } } end
  local k1, k2 = 1e8, 3e8
  local law = make { warp = line(k1), weft = line(k2), shear = { loading = { x = { -90, 0, 90 }, y = { -9e6, 0, 9e6 } }, unloading = { x = { 0, 90 }, y = { 0, 18e6 } }, meet = { 90, 9e6 } },
    S1 = 1e-4, S2 = 1e-4, FLEX = 1, FLEX1 = 1, FLEX2 = 1, E1 = k1, E2 = k2 }
  local _, E = sheet(1.09, 1.03, 24)
  local S11, S22, S12 = law:stress(E[1], E[2], E[3])
  check(name .. ": S11 by the warp's stretch", S11, k1 * (1.09 - 1.0001) / 1.09, 2e-3) -- the crimp, 1e-4 of the length, has not gone whole
  check(name .. ": S22 by the weft's stretch", S22, k2 * (1.03 - 1.0001) / 1.03, 5e-3)
  check(name .. ": S12 by the angle", S12, 2.4e6)
end

-- *MAT_034: second Piola-Kirchhoff over Green-Lagrange, each yarn its own; nothing presses; the shear over 2 E12 has its sign.
do
  local function line(k) return { loading = { x = { 0, 1 }, y = { 0, k } }, unloading = { x = { 0, 1 }, y = { 0, k } }, meet = { 1, k } } end
  local law = laws.mat_034 { warp = line(2e6), weft = line(5e6), shear = line(3e5) }
  local _, E = sheet(1.2, 0.9, -15)
  local S11, S22, S12 = law:stress(E[1], E[2], E[3])
  check("MAT_034: S11", S11, 2e6 * (1.2 ^ 2 - 1) / 2)
  assert(S22 == 0)
  check("MAT_034: S12", S12, -3e5 * 1.2 * 0.9 * math.sin(math.rad(15)))
end
fabric.expect(checks)
