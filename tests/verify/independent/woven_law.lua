-- The woven law at a point, written again from its definition and integrated here, against fabric.point: stresses and energies along paths at random,
-- cycles, rest states, equal strains in both directions; the sheet of constant moduli in closed form.
--
-- The law [share/doc/law.md]. Loading has the tangents D1(E), D2(E), D12(gamma); unloading the moduli Du1, Du2, Gu.
--   c = min(nu21 D1(0), nu12 D2(0)) / (1 - nu12 nu21),  h1 = c / nu21,  h2 = c / nu12
-- A yarn remembers its largest strain m and has the residual strain Er = m - P(m) / Du, P the integral of D:
--   E >= m: H = P(E) + c nu E;   Er <= E < m: H = Du (E - Er) + c nu E;   E < Er: H = c nu Er + h (E - Er)
--   S11 = H1(E11) + c E22,  S22 = H2(E22) + c E11
-- Shear, gamma = 2 E12, on a branch of direction sg that began at g0 and has been as far as gp from it, r = sg (gamma - g0):
--   r >= gp: S12 = sg Pg(r);   r0 <= r < gp, r0 = gp - Pg(gp) / Gu: S12 = sg (Pg(gp) - Gu (gp - r));   r < r0: a new branch the other way from there.
-- Nothing below calls the program but fabric.point and the numbers of its cards.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()

-- The integral of a tangent from 0 to x by Simpson's rule in many steps: exact for cubic tangents.
local function integral(D, x)
  local n = 8
  local h, sum = x / n, D(0) + D(x)
  for i = 1, n - 1 do sum = sum + (i % 2 == 1 and 4 or 2) * D(i * h) end
  return sum * h / 3
end

-- A loading curve up to `tested`; beyond, the tangent stays where it stops rising or reaches that of unloading (found on a fine grid).
local function backbone(coefficients, tested, unloading)
  local function D(x)
    local sum = 0
    for k = #coefficients, 1, -1 do sum = sum * x + coefficients[k] end
    return sum
  end
  local limit, h = tested, 1e-5
  while D(limit) < unloading and D(limit + h) > D(limit) and limit < 5 do limit = limit + h end
  return function(x) return D(math.min(x, limit)) end, function(x)
    local inside = math.min(x, limit)
    return integral(D, inside) + (x - inside) * D(limit)
  end
end

local function own_law(card)
  local nu12, nu21 = card.warp.poisson, card.weft.poisson
  local d, k = card.warp.loading[1], card.weft.loading[1]
  local c = math.min(nu21 * d, nu12 * k) / (1 - nu12 * nu21)
  local yarns = {}
  for i, y in ipairs { { card.warp, card.tested.warp, nu12, c / nu21 }, { card.weft, card.tested.weft, nu21, c / nu12 } } do
    local _, P = backbone(y[1].loading, y[2], y[1].unloading)
    yarns[i] = { P = P, Du = y[1].unloading, nu = y[3], h = y[4], m = 0 }
  end
  -- The card's shear is over the tensor's E12: G(gamma) = table(gamma / 2) / 2.
  local halves = {}
  for i, x in ipairs(card.shear.loading) do halves[i] = x / 2 / 2 ^ (i - 1) end
  local Gu = card.shear.unloading / 2
  local _, Pg = backbone(halves, 2 * card.tested.shear, Gu)
  local g0, gp, sg = 0, 0, 1
  local law = { c = c, yarns = yarns, Pg = Pg, Gu = Gu }
  local function H(y, E)
    local Er = y.m - y.P(y.m) / y.Du
    if E >= y.m then
      y.m = E
      return y.P(E) + c * y.nu * E
    elseif E >= Er then
      return y.Du * (E - Er) + c * y.nu * E
    end
    return c * y.nu * Er + y.h * (E - Er)
  end
  local function shear(gamma)
    for _ = 1, 2 do
      local r = sg * (gamma - g0)
      local r0 = gp - Pg(gp) / Gu
      if r >= gp then
        gp = r
        return sg * Pg(r)
      elseif r >= r0 then
        return sg * (Pg(gp) - Gu * (gp - r))
      end
      g0, sg, gp = g0 + sg * r0, -sg, 0
    end
    error "two turns in one step"
  end
  function law.strain(E11, E22, E12)
    return H(yarns[1], E11) + c * E22, H(yarns[2], E22) + c * E11, shear(2 * E12)
  end
  return law
end

-- Numbers that are the same everywhere: a linear congruence.
local function random(seed)
  local state = seed
  return function()
    state = (1103515245 * state + 12345) % 2147483648
    return state / 2147483648
  end
end

for _, name in ipairs { "blend", "duck", "muslin", "denim" } do
  local card = fabric.card(name)
  local law, p, draw = own_law(card), fabric.point(card), random(7)
  local E, worst, scale = { 0, 0, 0 }, 0, 0
  -- Work by the trapezoidal rule in many parts of each stretch: kinks of the law fall inside them.
  local parts, work, S = 200, 0, { 0, 0, 0 }
  local last
  for _ = 1, 60 do
    local to = { (1.3 * draw() - 0.15) * card.tested.warp, (1.3 * draw() - 0.15) * card.tested.weft, (2.4 * draw() - 1.2) * card.tested.shear }
    local from = { table.unpack(E) }
    for k = 1, parts do
      local before = { table.unpack(E) }
      for i = 1, 3 do E[i] = from[i] + (to[i] - from[i]) * k / parts end
      local s11, s22, s12 = law.strain(E[1], E[2], E[3])
      last = p:strain { E11 = E[1], E22 = E[2], E12 = E[3] }
      worst = math.max(worst, math.abs(last.S11 - s11), math.abs(last.S22 - s22), math.abs(last.S12 - s12))
      scale = math.max(scale, math.abs(s11), math.abs(s22))
      work = work + (S[1] + s11) / 2 * (E[1] - before[1]) + (S[2] + s22) / 2 * (E[2] - before[2]) + (S[3] + s12) * (E[3] - before[3])
      S = { s11, s22, s12 }
    end
  end
  -- The guard begins where the grid of 1e-5 finds it: 1e-5 of the strain.
  checks(name .. ": stresses along a path at random, of the largest", worst / scale, 0, { absolute = 2e-5 })
  checks(name .. ": work is what is stored and dissipated", last.stored + last.dissipated, work, { relative = 2e-4 })

  -- Uniaxial: S = P(E), the measured contraction, the unloading modulus. After the weft was pulled and let go the rest state of the warp has moved
  -- (exchange of crimp): E11 = -nu21 Er2.
  local fresh, e = own_law(card), 0.7 * card.tested.weft
  local q = fabric.point(card)
  local up = q:uniaxial("weft", e)
  checks(name .. ": weft alone, S = P(E)", up.S22, fresh.yarns[2].P(e), { relative = 1e-9 })
  checks(name .. ": weft alone, contraction of the warp", up.E11 / e, -card.weft.poisson, { relative = 1e-9 })
  local down = q:uniaxial("weft", e * (1 - 1e-4))
  checks(name .. ": weft alone, unloading", (up.S22 - down.S22) / (1e-4 * e), card.weft.unloading, { relative = 1e-6 })
  local residual = e - fresh.yarns[2].P(e) / card.weft.unloading
  local rest = q:uniaxial("weft", residual)
  checks(name .. ": weft let go, no stress", rest.S22 / up.S22, 0, { absolute = 1e-9 })
  checks(name .. ": weft let go, the warp's rest strain", rest.E11, -card.weft.poisson * residual, { relative = 1e-8 })
  -- Then the warp to a peak and back: both at rest at Er1 - nu21 Er2, Er2 - nu12 Er1, where no stress is left.
  local top = 0.8 * card.tested.warp
  local residual1 = top - fresh.yarns[1].P(top) / card.warp.unloading
  q:strain { E11 = top, E22 = residual }
  local both = q:strain { E11 = residual1 - card.weft.poisson * residual, E22 = residual - card.warp.poisson * residual1 }
  checks(name .. ": both let go, warp", both.S11 / up.S22, 0, { absolute = 1e-9 })
  checks(name .. ": both let go, weft", both.S22 / up.S22, 0, { absolute = 1e-9 })

  -- Equal strains in both directions: S11 = P1(E) + c (1 + nu12) E, S22 = P2(E) + c (1 + nu21) E.
  local equal = 0.6 * math.min(card.tested.warp, card.tested.weft)
  local r = fabric.point(card):strain { E11 = equal, E22 = equal }
  checks(name .. ": equal strains, warp", r.S11, fresh.yarns[1].P(equal) + fresh.c * (1 + card.warp.poisson) * equal, { relative = 1e-9 })
  checks(name .. ": equal strains, weft", r.S22, fresh.yarns[2].P(equal) + fresh.c * (1 + card.weft.poisson) * equal, { relative = 1e-9 })

  -- Cycles of shear between +a and -b: what is stored and dissipated in a cycle is the area of its loop; nothing is ever given back. Where the loop
  -- has closed (the origin of its branches wanders for some cycles), all of the area is dissipated. Trapezoids in many steps; kinks cost the square of one.
  local s, n, a, b = fabric.point(card), 2000, 0.24, 0.17
  local now = s:strain { E12 = a }
  local least, first = math.huge, nil
  for cycle = 1, 40 do
    local area, before = 0, now
    for i = 1, n do
      local phase, last_step = i / n, now
      now = s:strain { E12 = phase < 0.5 and a - (a + b) * 2 * phase or -b + (a + b) * (2 * phase - 1) }
      area = area + (last_step.S12 + now.S12) * (now.E12 - last_step.E12)
      least = math.min(least, now.dissipated - last_step.dissipated)
    end
    local dissipated, stored = now.dissipated - before.dissipated, now.stored - before.stored
    if cycle == 1 then first = { dissipated + stored, area } end
    if cycle == 40 then
      checks(name .. ": the first cycle of shear, its area", first[1], first[2], { relative = 1e-5 })
      checks(name .. ": a closed cycle of shear dissipates its area", dissipated, area, { relative = 1e-5 })
      checks(name .. ": a closed cycle of shear stores nothing", stored / area, 0, { absolute = 1e-5 })
      checks(name .. ": nothing dissipated is given back", math.min(least, 0) / area, 0, { absolute = 1e-14 })
    end
  end
end

-- Shear with friction in parallel that grows with the strain: q' = k E12' held within +-(Y0 + Y1 |E12|), k = unloading - D(0), here in 40,000 small steps beside the elastic
-- curve, there in one step for each stretch; what is dissipated is the work of q less what its spring holds, q^2 / (2 k), twice for the tensor's strain.
do
  local d, Y0, Y1, unloading = { 2e6, -3e6, 40e6 }, 30e3, 0.4e6, 14e6
  local card = fabric.card "blend":with { shear = { loading = d, unloading = unloading, measure = "tensor", friction = { stress = Y0, growth = Y1 } } }
  local k, q, x, work = unloading - d[1], 0, 0, 0
  local p, worst, last = fabric.point(card), 0, nil
  local function elastic(e)
    local sum = 0
    for i, c in ipairs(d) do sum = sum + c * math.abs(e) ^ i / i end
    return e < 0 and -sum or sum
  end
  for _, to in ipairs { 0.21, 0.08, 0.2, -0.13, -0.02, -0.17, 0.19, 0.05 } do
    local n = 40000
    local h = (to - x) / n
    for _ = 1, n do
      local before = q
      x = x + h
      local Y = Y0 + Y1 * math.abs(x)
      q = math.max(-Y, math.min(Y, q + k * h))
      work = work + (before + q) * h
    end
    x = to
    last = p:strain { E12 = to }
    worst = math.max(worst, math.abs(last.S12 - elastic(to) - q) / elastic(0.21))
  end
  checks("shear with friction: stress at each turn", worst, 0, { absolute = 1e-4 }) -- small steps of the integration here
  checks("shear with friction: dissipated", last.dissipated, work - q * q / k, { relative = 1e-4 })
end

-- St. Venant-Kirchhoff: C11 = E1 / (1 - nn), C12 = sqrt(nn E1 E2) / (1 - nn), S12 = 2 G E12, nn = nu12 nu21, with ratios that are not those of a symmetric
-- material. Simple shear F = [1 g; 0 1]: E12 = g / 2, E22 = g^2 / 2. Uniaxial along the warp: S22 = 0 makes E22 = -C12 / C22 E11, S11 = (1 - nn) C11 E11.
do
  local E1, E2, G, n12, n21, g = 3e6, 8e6, 0.7e6, 0.2, 0.45, 0.3
  local p = fabric.point(common.sheet { warp = E1, weft = E2, shear = G, poisson = { n12, n21 } })
  local nn = n12 * n21
  local C11, C22, C12 = E1 / (1 - nn), E2 / (1 - nn), math.sqrt(nn * E1 * E2) / (1 - nn)
  local r = p:strain { E11 = 0, E22 = g * g / 2, E12 = g / 2 }
  checks("constant moduli, simple shear: S11", r.S11, C12 * g * g / 2, { relative = 1e-12 })
  checks("constant moduli, simple shear: S22", r.S22, C22 * g * g / 2, { relative = 1e-12 })
  checks("constant moduli, simple shear: S12", r.S12, G * g, { relative = 1e-12 })
  checks("constant moduli, simple shear: stored", r.stored, C22 * g ^ 4 / 8 + G * g * g / 2, { relative = 1e-12 })
  local u = fabric.point(common.sheet { warp = E1, weft = E2, shear = G, poisson = { n12, n21 } }):uniaxial("warp", 0.1)
  checks("constant moduli, uniaxial: S11", u.S11, (1 - nn) * C11 * 0.1, { relative = 1e-9 })
  checks("constant moduli, uniaxial: E22", u.E22, -0.1 * C12 / C22, { relative = 1e-9 })
end
checks()
