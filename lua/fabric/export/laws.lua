-- Small models of the laws to which cards are exported, written from the equations in their manuals (for OpenRadioss: its source), for
-- comparison with the card's own law. All take Green-Lagrange strain (tensor components, material axes) and return second Piola-Kirchhoff
-- stress, Pa: law:stress(E11, E22, E12) -> S11, S22, S12 for a trial state; law:commit() keeps the last one. The thickness is constant, as
-- for the elements of all these laws in their usual setting, so that J = lambda1 lambda2 cos(shear angle).
local laws = {}

-- The value of a piecewise linear curve {x, y}; the end segments are continued, as the solvers do. The segment found last is tried first.
local function value(curve, x)
  local xs, ys = curve.x, curve.y
  local low = curve.last
  local high = low and low + 1
  if not (low and xs[low] <= x and x < xs[high]) then
    low, high = 1, #xs
    while high - low > 1 do
      local middle = (low + high) // 2
      if xs[middle] <= x then low = middle else high = middle end
    end
    curve.last = high > low and low or nil
  end
  return ys[low] + (ys[high] - ys[low]) * (x - xs[low]) / (xs[high] - xs[low])
end
laws.value = value

-- --- one yarn direction, or shear, with a curve for loading and one for unloading ---

-- The unloading curve, which meets the loading curve at {x, y} = `meet`, is scaled along both axes to the point of reversal.
--   reload = "curve": reloads along the unloading curve          (*MAT_034 with RL = 0)
--   reload = "scaled": reloads along the loading curve, scaled in between (LAW58: sigeps58c, branches LOAD, RELOAD, UNLOAD)
local function scaled(loading, unloading, meet, reload, odd)
  local function new() return { x = 0, most = 0, most_y = 0, turn = 0, turn_y = 0, low = 0, low_y = 0, virgin = true, sign = 1 } end
  local s, t, evaluated = new(), new(), false
  local function evaluate(x)
    t.x, t.most, t.most_y, t.turn, t.turn_y = s.x, s.most, s.most_y, s.turn, s.turn_y
    t.low, t.low_y, t.virgin, t.sign = s.low, s.low_y, s.virgin, s.sign
    evaluated = true
    local sign = 1
    if odd then
      sign = x < 0 and -1 or 1
      if sign ~= s.sign and x ~= 0 then -- shear in the other direction starts anew
        t = new()
        t.sign = sign
      end
      x = math.abs(x)
    end
    local y
    local previous = t.x
    t.x = x
    if x <= 0 and not odd then
      y = value(loading, x)
      if reload == "scaled" then t.most, t.turn, t.low, t.virgin = 0, 0, 0, true end
    elseif x >= t.most then
      y = value(loading, x)
      t.most, t.most_y, t.turn, t.turn_y, t.low, t.low_y, t.virgin = x, y, x, y, x, y, true
    elseif reload == "curve" or x < previous then
      y = value(unloading, x * meet[1] / t.turn) * t.turn_y / meet[2]
      t.low, t.low_y, t.virgin = x, y, false
    elseif t.virgin then
      y = value(loading, x)
    else
      local part = t.most * (x - t.low) / (t.most - t.low)
      y = t.low_y + (t.most_y - t.low_y) / t.most_y * value(loading, part)
      t.turn, t.turn_y = x, y
    end
    return sign * y
  end
  local function commit()
    if evaluated then s, t, evaluated = t, s, false end
  end
  return { at = evaluate, commit = commit }
end

-- The unloading curve {x, y}, which rises from {0, 0}, is shifted to the point of reversal; below its zero the yarn is slack.
-- (*FABRIC: TYPE=PERMANENT DEFORMATION, DEFINITION=SHIFTED CURVE)
local function shifted(loading, unloading, odd)
  local s, trial = { most = 0, sign = 1 }, nil
  local inverse = { x = unloading.y, y = unloading.x }
  local function evaluate(x)
    local most, sign = s.most, 1
    if odd then
      sign = x < 0 and -1 or 1
      if sign ~= s.sign and x ~= 0 then most = 0 end
      x = math.abs(x)
    end
    local y
    if x >= most then
      y, most = value(loading, x), math.max(most, x)
    else
      local offset = most - value(inverse, value(loading, most))
      y = x > offset and value(unloading, x - offset) or 0
    end
    trial = { most = most, sign = sign }
    return sign * y
  end
  return { at = evaluate, commit = function() s = trial or s end }
end

-- Stretches along the yarns, and the sine and cosine of the shear angle.
local function kinematics(E11, E22, E12)
  local l1, l2 = math.sqrt(math.max(1 + 2 * E11, 1e-6)), math.sqrt(math.max(1 + 2 * E22, 1e-6))
  local sine = math.max(-0.999, math.min(0.999, 2 * E12 / (l1 * l2)))
  return l1, l2, sine, math.sqrt(1 - sine * sine)
end

-- *MAT_FABRIC (*MAT_034), FORM = 14: second Piola-Kirchhoff stress over Green-Lagrange strain along each yarn, and over the engineering
-- shear 2 E12, without coupling; CSE = 1 removes compressive stress.
function laws.mat_034(p)
  local a = scaled(p.warp.loading, p.warp.unloading, p.warp.meet, "curve")
  local b = scaled(p.weft.loading, p.weft.unloading, p.weft.meet, "curve")
  local ab = scaled(p.shear.loading, p.shear.unloading, p.shear.meet, "curve", true)
  local law = {}
  function law:stress(E11, E22, E12)
    local S1, S2, S3 = a.at(E11), b.at(E22), ab.at(2 * E12)
    return math.max(S1, 0), math.max(S2, 0), S3
  end
  function law:commit() a.commit() b.commit() ab.commit() end
  return law
end

-- *MAT_235 with straight yarns (BFI = BWI = 0): half of each family per area, linear along and across a yarn in Cauchy stress over
-- logarithmic strain; the shear modulus is DSCF G12 up to the locking angle, then G12.
function laws.mat_235(p)
  local law = { commit = function() end }
  local k = (p.E1 + p.E2) / 2
  local lock = math.rad(90 - 2 * p.THL)
  function law:stress(E11, E22, E12)
    local l1, l2, sine, cosine = kinematics(E11, E22, E12)
    local J = l1 * l2 * cosine
    local angle = math.asin(sine)
    local free = math.min(math.abs(angle), lock)
    local tau = p.DSCF * p.G12 * free + p.G12 * (math.abs(angle) - free)
    return k * math.log(l1) * J / l1 ^ 2, k * math.log(l2) * J / l2 ^ 2, (angle < 0 and -tau or tau) * J / (l1 * l2)
  end
  return law
end

-- LAW58 with loading and unloading functions (OpenRadioss, engine/source/materials/mat/mat058/sigeps58c.F, branch UNLOAD = 1): yarns with
-- the elongation d - d0 over a crimp height h that the two directions exchange; the force per initial width of the sheet is a function of
-- that elongation; the shear stress is a function of the shear angle in degrees, without coupling. No damping and no friction.
function laws.law58(p)
  local warp = scaled(p.warp.loading, p.warp.unloading, p.warp.meet, "scaled")
  local weft = scaled(p.weft.loading, p.weft.unloading, p.weft.meet, "scaled")
  local shear = scaled(p.shear.loading, p.shear.unloading, p.shear.meet, "scaled", true)
  local d1, d2 = 1 + p.S1, 1 + p.S2
  local h1, h2 = math.sqrt(d1 ^ 2 - 1), math.sqrt(d2 ^ 2 - 1)
  local flex = p.FLEX * (p.E1 * h1 / d1 + p.E2 * h2 / d2)
  local law = {}
  local function yarn(part, length, height, rest)
    local d = math.sqrt(length * length + height * height)
    return part.at(d - rest), height / d, length / d
  end
  function law:stress(E11, E22, E12)
    local l1, l2, sine = kinematics(E11, E22, E12)
    local low, high = -h1, h2 -- changes of crimp height: gain of the warp, loss of the weft
    for _ = 1, 50 do
      local y = (low + high) / 2
      local F1, sine1 = yarn(warp, l1, h1 + y, d1)
      local F2, sine2 = yarn(weft, l2, h2 - y, d2)
      if flex * y + F1 * sine1 - F2 * sine2 > 0 then high = y else low = y end
    end
    local y = (low + high) / 2
    local F1, _, c1 = yarn(warp, l1, h1 + y, d1)
    local F2, _, c2 = yarn(weft, l2, h2 - y, d2)
    return F1 * c1 / l1, F2 * c2 / l2, shear.at(math.deg(math.asin(sine)))
  end
  function law:commit() warp.commit() weft.commit() shear.commit() end
  return law
end

-- LAW158 (OpenRadioss, engine/source/materials/mat/mat158/sigeps158c.F): yarns as in LAW58, elastic along their loading curves. The crimp height of
-- each direction has a spring of its own, logarithmic in its relative change (FLEX1, FLEX2), and FLEX holds the sum of both heights. At rest the pull
-- of a yarn across the sheet is in balance with both. No damping; the friction of that law acts in no motion without it.
function laws.law158(p)
  local yarns = { { curve = p.warp.loading, K = p.FLEX1, d0 = 1 + p.S1 }, { curve = p.weft.loading, K = p.FLEX2, d0 = 1 + p.S2 } }
  for _, y in ipairs(yarns) do y.h0 = math.sqrt(y.d0 ^ 2 - 1) end
  local H = yarns[1].h0 + yarns[2].h0
  local least = math.log(1e-4) -- the law lets no height become less than a ten thousandth of that at rest
  -- Imbalance of a yarn of length l and crimp height h0 exp(u), without FLEX; its derivative; its force and length.
  local function balance(y, l, u)
    local h = y.h0 * math.exp(u)
    local d = math.sqrt(l * l + h * h)
    local x = d - y.d0
    local F, slope = value(y.curve, x), (value(y.curve, x + 1e-7) - value(y.curve, x - 1e-7)) / 2e-7
    return F * h / d + y.K * u, slope * h ^ 3 / d ^ 2 + F * h / d * (1 - h * h / (d * d)) + y.K, F, d, h
  end
  -- The height at which a yarn is in balance with a pull Q of FLEX, by halving.
  local function height(y, l, Q)
    local low, high = least, 12
    for _ = 1, 60 do
      local u = (low + high) / 2
      if balance(y, l, u) + Q > 0 then high = u else low = u end
    end
    return (low + high) / 2
  end
  local last = { 0, 0 }
  local function sum(u) return p.FLEX * (yarns[1].h0 * (math.exp(u[1]) - 1) + yarns[2].h0 * (math.exp(u[2]) - 1)) / H end
  -- The heights of both: Newton's method from those of the last state; where it does not get there, both by turns.
  local function heights(l)
    local u = { last[1], last[2] }
    for _ = 1, 30 do
      local a, ja, _, _, h1 = balance(yarns[1], l[1], u[1])
      local b, jb, _, _, h2 = balance(yarns[2], l[2], u[2])
      local Q = sum(u)
      a, b = a + Q, b + Q
      local q1, q2 = p.FLEX * h1 / H, p.FLEX * h2 / H
      ja, jb = ja + q1, jb + q2
      local det = ja * jb - q1 * q2
      local du, dv = -(a * jb - b * q2) / det, -(b * ja - a * q1) / det
      local most = math.max(math.abs(du), math.abs(dv))
      if not (ja > 0 and jb > 0 and det > 0 and most < 1e3) then break end
      local t = math.min(1, 1 / most)
      u[1], u[2] = math.max(least, u[1] + t * du), math.max(least, u[2] + t * dv)
      if most < 1e-12 then return u end
    end
    local low, high = -p.FLEX, 1e3 * p.FLEX
    for _ = 1, 60 do
      local Q = (low + high) / 2
      u[1], u[2] = height(yarns[1], l[1], Q), height(yarns[2], l[2], Q)
      if sum(u) > Q then low = Q else high = Q end
    end
    return u
  end
  local law = {}
  function law:stress(E11, E22, E12)
    local l1, l2, sine = kinematics(E11, E22, E12)
    local u = heights { l1, l2 }
    last = u
    local _, _, F1, d1 = balance(yarns[1], l1, u[1])
    local _, _, F2, d2 = balance(yarns[2], l2, u[2])
    local angle = math.deg(math.asin(sine))
    local S12 = value(p.shear.loading, math.abs(angle))
    return F1 / d1, F2 / d2, angle < 0 and -S12 or S12
  end
  function law:commit() end
  return law
end

-- LAW19 (OpenRadioss, engine/source/materials/mat/mat019/sigeps19c.F): linear orthotropic, Cauchy stress over logarithmic strain; principal
-- stresses in compression are reduced by RE.
function laws.law19(p)
  local nu21 = p.NU12 * p.E22 / p.E11
  local q = 1 - p.NU12 * nu21
  local A11, A22, A12 = p.E11 / q, p.E22 / q, nu21 * p.E11 / q
  local law = { commit = function() end }
  function law:stress(E11, E22, E12)
    local l1, l2, sine, cosine = kinematics(E11, E22, E12)
    local J = l1 * l2 * cosine
    local e1, e2 = math.log(l1), math.log(l2)
    local s1, s2, s3 = A11 * e1 + A12 * e2, A12 * e1 + A22 * e2, p.G12 * math.asin(sine)
    local mean, half = (s1 + s2) / 2, (s1 - s2) / 2
    local r = math.sqrt(s3 * s3 + half * half)
    if mean - r < 0 then
      local largest = mean + r
      if largest > 0 then
        local beta = ((1 - p.RE) * mean / r + 1 + p.RE) / 2
        s1, s2, s3 = beta * (s1 - largest) + largest, beta * (s2 - largest) + largest, beta * s3
      else
        s1, s2, s3 = p.RE * s1, p.RE * s2, p.RE * s3
      end
    end
    return s1 * J / l1 ^ 2, s2 * J / l2 ^ 2, s3 * J / (l1 * l2)
  end
  return law
end

-- *FABRIC with test data (Abaqus/Explicit): nominal stress over nominal strain lambda - 1 along each yarn, and over the change of the angle
-- between the yarns, independent of each other. The three stresses are conjugate to the three strains, which gives S: T11 = lambda1 S11 +
-- lambda2 sin(g) S12, T12 = lambda1 lambda2 cos(g) S12.
function laws.fabric(p)
  local warp = shifted(p.warp.loading, p.warp.unloading)
  local weft = shifted(p.weft.loading, p.weft.unloading)
  local shear = shifted(p.shear.loading, p.shear.unloading, true)
  local law = {}
  function law:stress(E11, E22, E12)
    local l1, l2, sine, cosine = kinematics(E11, E22, E12)
    local S12 = shear.at(math.asin(sine)) / (l1 * l2 * cosine)
    return (warp.at(l1 - 1) - l2 * sine * S12) / l1, (weft.at(l2 - 1) - l1 * sine * S12) / l2, S12
  end
  function law:commit() warp.commit() weft.commit() shear.commit() end
  return law
end

-- St. Venant-Kirchhoff: *ELASTIC, TYPE=ENGINEERING CONSTANTS in CalculiX with NLGEOM (S is second Piola-Kirchhoff over Green-Lagrange).
function laws.svk(p)
  local q = 1 - p.NU12 * p.NU21
  local c = p.NU21 * p.E11 / q
  local law = { commit = function() end }
  function law:stress(E11, E22, E12)
    return p.E11 / q * E11 + c * E22, c * E11 + p.E22 / q * E22, 2 * p.G12 * E12
  end
  return law
end

-- --- the paths ---

-- Uniaxial tension at an angle to the warp: E along the pull is given; lateral stress and shear stress in the axes of the pull vanish.
local function turned(law, angle, Ex, Ey, Exy)
  local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
  local S11, S22, S12 = law:stress(Ex * c * c + Ey * s * s - 2 * Exy * s * c, Ex * s * s + Ey * c * c + 2 * Exy * s * c,
    -- the axes of the pull are rotated by +angle from the warp
    (Ex - Ey) * s * c + Exy * (c * c - s * s))
  return S11 * c * c + S22 * s * s + 2 * S12 * s * c, S11 * s * s + S22 * c * c - 2 * S12 * s * c,
    (S22 - S11) * s * c + S12 * (c * c - s * s)
end

-- Newton's method with a difference quotient for (Ey, Exy); steps are halved until the residual decreases. guess: modified in place.
local function solve_uniaxial(law, angle, Ex, guess)
  local function at(y, z)
    local S, Sy, Sz = turned(law, angle, Ex, y, z)
    return S, Sy, Sz, Sy * Sy + Sz * Sz
  end
  local y, z = guess[1], guess[2]
  local S, a, b, size = at(y, z)
  for _ = 1, 60 do
    if size <= (1e-7 * math.max(math.abs(S), 1)) ^ 2 then break end
    local h = 1e-7
    local _, ay, by = at(y + h, z)
    local _, az, bz = at(y, z + h)
    local m11, m21, m12, m22 = (ay - a) / h, (by - b) / h, (az - a) / h, (bz - b) / h
    m11, m22 = m11 + 1, m22 + 1 -- a slack yarn has no stiffness: one pascal keeps the matrix regular
    local det = m11 * m22 - m12 * m21
    if det == 0 then break end
    local dy, dz = -(a * m22 - b * m12) / det, -(b * m11 - a * m21) / det
    local most = math.max(math.abs(dy), math.abs(dz))
    local t, better = most > 0.05 and 0.05 / most or 1, false
    for _ = 1, 30 do
      local S2, a2, b2, size2 = at(y + t * dy, z + t * dz)
      if size2 < size then
        y, z, S, a, b, size, better = y + t * dy, z + t * dz, S2, a2, b2, size2, true
        break
      end
      t = t / 2
    end
    if not better then break end
  end
  guess[1], guess[2] = y, z
  S = at(y, z)
  return S
end

-- The stresses of a law along a path (see sampled.paths): one list, or two for the biaxial path.
function laws.along(law, path)
  local first, second, guess = {}, path.drive == "biaxial" and {} or nil, { 0, 0 }
  for i, x in ipairs(path.values) do
    if path.drive == "uniaxial" then
      first[i] = solve_uniaxial(law, path.angle, x, guess)
    elseif path.drive == "shear" then
      first[i] = select(3, law:stress(0, 0, x))
    else
      first[i], second[i] = law:stress(x, x, 0)
    end
    law:commit()
  end
  return first, second
end

return laws
