-- The model discrepancy: a smooth difference along each test, estimated from the residuals of a fit, and what it does to the fitted parameters.
--
-- Residuals over their noise after the fit, r = M (d + e): e is independent with variance v, at least 1; d = sum_j c_j phi_j, cosines along the points of each test, var(c_j) = s^2 / (1 + j^2/4)^q.
-- M takes away what the parameters explain. v and s^2 follow from the restricted likelihood [patterson1971]. Where the parameters would have followed d, nothing of it is in the residuals; that
-- part has the same s^2, and how large it is beside the visible one depends on q: the steeper the spectrum, the longer the waves. s and q are unknown, and whether there is such a difference is
-- uncertain too: the prior gives a model that is right (s = 0) 0.6, and else even odds to s below half the noise. Each s and q weighs by its likelihood [kennedy2001]; for each the parameters'
-- covariance is C J^T (v I + s^2 Phi W Phi^T) J C with C = (J^T J)^-1, and an interval is of the mixture of them, so that residuals that look like noise narrow it by as much as they would have shown.
local lab = require("fabric").lab
local linear = require "fabric.lab.common.linear"
local discrepancy = {}

local modes, fewest = 6, 8 -- of a test; points of a test of which smooth differences can be told from noise
local steep = { 1, 1.5, 2 } -- q: from waves hardly longer than the shortest to a difference that is nearly one long wave
local right, scale = 0.6, 0.5 -- the prior: of a model that misses nothing, and the median of s where it does
local sure = 6.6           -- twice the logarithm of the ratio of likelihoods that is as unlikely as one in a hundred

-- Eigenvalues and eigenvectors (columns of V) of a small symmetric matrix, by Jacobi's rotations.
local function eigen(A)
  local n, V = #A, {}
  for i = 1, n do
    V[i] = {}
    for j = 1, n do V[i][j] = i == j and 1 or 0 end
  end
  for _ = 1, 30 do
    local off = 0
    for p = 1, n - 1 do
      for q = p + 1, n do
        off = off + A[p][q] ^ 2
        if A[p][q] ~= 0 then
          local theta = (A[q][q] - A[p][p]) / (2 * A[p][q])
          local t = (theta >= 0 and 1 or -1) / (math.abs(theta) + math.sqrt(theta * theta + 1))
          local c = 1 / math.sqrt(t * t + 1)
          local s = t * c
          local function turn(rows)
            for k = 1, n do
              local row = rows[k]
              local x, y = row[p], row[q]
              row[p], row[q] = c * x - s * y, s * x + c * y
            end
          end
          turn(A)
          local P, Q = A[p], A[q]
          for k = 1, n do
            local x, y = P[k], Q[k]
            P[k], Q[k] = c * x - s * y, s * x + c * y
          end
          turn(V)
        end
      end
    end
    if off < 1e-24 then break end
  end
  local values = {}
  for i = 1, n do values[i] = A[i][i] end
  return values, V
end

-- The variance of a cosine's coefficient over that of the constant: smooth differences have more of the long waves.
local function share_of(j, q) return 1 / (1 + j * j / 4) ^ q end

-- The weighted cosines of all tests, each a list { first, values } over the points of its test.
local function functions_of(counts, steepness)
  local out, first = {}, 0
  for _, n in ipairs(counts) do
    if n >= fewest then
      for j = 0, math.min(modes, n // 3) - 1 do
        local values, weight = {}, math.sqrt((j == 0 and 1 or 2) * share_of(j, steepness))
        for k = 1, n do values[k] = weight * math.cos(math.pi * j * (k - 0.5) / n) end
        out[#out + 1] = { first = first, values = values }
      end
    end
    first = first + n
  end
  return out
end

-- Log likelihood of v and s2, where u has the variances v + s2 g, and the other `count` components v and the sum of squares `rest`.
local function likelihood(v, s2, u, g, rest, count)
  local sum = -count * math.log(v) - rest / v
  for i, x in ipairs(u) do
    local variance = v + s2 * g[i]
    sum = sum - math.log(variance) - x * x / variance
  end
  return sum / 2
end

-- The likeliest v >= 1 for an s2, by golden section in its logarithm.
local function best_noise(s2, u, g, rest, count, most)
  local low, high, golden = 0, math.log(math.max(1.0001, most)), (math.sqrt(5) - 1) / 2
  for _ = 1, 40 do
    local a, b = high - golden * (high - low), low + golden * (high - low)
    if likelihood(math.exp(a), s2, u, g, rest, count) > likelihood(math.exp(b), s2, u, g, rest, count) then high = b else low = a end
  end
  local v = math.exp((low + high) / 2)
  if likelihood(1, s2, u, g, rest, count) >= likelihood(v, s2, u, g, rest, count) then v = 1 end
  return v, likelihood(v, s2, u, g, rest, count)
end

-- The parameters that the fit moved, with their J and C: the others lie on a bound, and their derivatives take nothing away from the residuals.
local function moved(jacobian, C, fixed)
  local n, m, list, J, normal = #C, #jacobian // #C, {}, {}, {}
  for i = 1, n do
    if not fixed[i] then list[#list + 1] = i end
  end
  for k = 0, m - 1 do
    for _, i in ipairs(list) do J[#J + 1] = jacobian[k * n + i] end
  end
  if #list == n then return list, J, C end
  for a, i in ipairs(list) do
    normal[a] = {}
    for b, l in ipairs(list) do
      normal[a][b] = 0
      for k = 0, m - 1 do normal[a][b] = normal[a][b] + jacobian[k * n + i] * jacobian[k * n + l] end
    end
  end
  return list, J, #list > 0 and linear.inverse(normal) or {}
end

-- The residuals orthogonal to the derivatives: they themselves at a minimum, and a fit ends near it.
local function beside(residuals, J, C)
  local n, slope, out = #C, {}, {}
  for i = 1, n do
    slope[i] = 0
    for k, r in ipairs(residuals) do slope[i] = slope[i] + J[(k - 1) * n + i] * r end
  end
  for k, r in ipairs(residuals) do
    for i = 1, n do
      for l = 1, n do r = r - J[(k - 1) * n + i] * C[i][l] * slope[l] end
    end
    out[k] = r
  end
  return out
end

-- The normal distribution's probability beyond -z and z, within 2e-7 [abramowitz1964, 7.1.26].
local function beyond(z)
  local t = 1 / (1 + 0.3275911 * z / math.sqrt(2))
  return t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)))) * math.exp(-z * z / 2)
end

-- Half of the 95 % interval of a parameter whose variance is own v + smooth s^2 in each case { weight, noise = v, s2, effective, of = the spectrum with its smooth[a][a] }, with m degrees of
-- freedom of v and `effective` ones of s^2; without `a` no difference moves the parameter. Each case has Student's interval, as a normal distribution in the mixture: s^2 often rests on one or two
-- waves, and Student's distribution of so few degrees of freedom has a middle that would narrow the whole.
local function half_width(cases, own, a, m)
  local list, high = {}, 0
  for _, c in ipairs(cases) do
    local smooth = a and c.of.smooth[a][a] or 0
    if not (own < math.huge and smooth < math.huge) then return math.huge end -- the records do not determine it
    local x, y = own * c.noise, smooth * c.s2
    if x + y > 0 then
      local freedom = (x + y) ^ 2 / (x * x / m + y * y / math.max(1, c.effective))
      local half = math.sqrt(x + y) * lab.student(0.975, freedom)
      list[#list + 1], high = { weight = c.weight, half = half }, math.max(high, half)
    end
  end
  local low = 0
  for _ = 1, 40 do
    local at, outside = (low + high) / 2, 0
    for _, c in ipairs(list) do outside = outside + c.weight * beyond(1.959964 * at / c.half) end
    if outside > 0.05 then low = at else high = at end
  end
  return high
end

-- Projections on the cosines of a spectrum with the exponent q: `explained`, the parameters that each would make; u, the residuals along the directions beside the parameters, with the variances
-- v + s2 g; `rest`, the sum of squares of the `count` other components; `weights`, the sum of the shares.
local function spectrum_of(residuals, squares, counts, jacobian, C, q)
  local n, phi, with_J, explained = #C, functions_of(counts, q), {}, {}
  for a, f in ipairs(phi) do
    with_J[a], explained[a] = {}, {}
    for i = 1, n do
      local sum = 0
      for k, x in ipairs(f.values) do sum = sum + x * jacobian[(f.first + k - 1) * n + i] end
      with_J[a][i] = sum
    end
    for i = 1, n do
      local sum = 0
      for l = 1, n do sum = sum + C[i][l] * with_J[a][l] end
      explained[a][i] = sum
    end
  end
  local G, b = {}, {}
  for a, f in ipairs(phi) do
    G[a], b[a] = {}, 0
    for k, x in ipairs(f.values) do b[a] = b[a] + x * residuals[f.first + k] end
    for p, h in ipairs(phi) do
      local sum = 0
      if f.first == h.first then
        for k, x in ipairs(f.values) do sum = sum + x * h.values[k] end
      end
      for i = 1, n do sum = sum - with_J[a][i] * explained[p][i] end
      G[a][p] = sum
    end
  end
  local u, g, rest = {}, {}, squares
  if #phi > 0 then
    local largest = 0
    local values, V = eigen(G)
    for _, x in ipairs(values) do largest = math.max(largest, x) end
    for i, x in ipairs(values) do
      if x > 1e-2 * largest then -- what the parameters take up nearly whole shows nothing of its size
        local along = 0
        for a = 1, #phi do along = along + V[a][i] * b[a] end
        u[#u + 1], g[#g + 1] = along / math.sqrt(x), x
        rest = rest - along * along / x
      end
    end
  end
  local smooth, weights = {}, 0
  for i = 1, n do
    smooth[i] = {}
    for l = 1, n do
      smooth[i][l] = 0
      for a = 1, #phi do smooth[i][l] = smooth[i][l] + explained[a][i] * explained[a][l] end
    end
  end
  for j = 0, modes - 1 do weights = weights + share_of(j, q) end
  return { u = u, g = g, rest = math.max(rest, 0), count = math.max(0, #residuals - n - #u), smooth = smooth, weights = weights }
end

-- residuals: predicted less measured over the noise, all tests one after the other, `counts` points each; all_derivatives: theirs by the parameters, row by row; all_covariance: (J^T J)^-1, a
-- list of rows; fixed: true for a parameter on a bound, which counts as known. Returns { noise (v), deviation (rms of d over the noise), ratio (twice the logarithm of the likelihoods'), told, covariance, half_width (of each parameter's 95 % interval) }.
function discrepancy.of(all_residuals, counts, all_derivatives, all_covariance, fixed)
  local list, jacobian, C = moved(all_derivatives, all_covariance, fixed or {})
  local residuals = beside(all_residuals, jacobian, C)
  local m, n = #residuals, #C
  local out, squares = { noise = 1, deviation = 0, ratio = 0, told = false, covariance = {}, half_width = {} }, 0
  for _, r in ipairs(residuals) do squares = squares + r * r end
  local most = 4 * math.max(1, squares / math.max(1, m - n))
  -- the model that misses nothing, and for each q sizes that are even in their logarithm, of which the prior has `density` each
  local cases, v, top, none = {}, 1, nil, nil
  for _, q in ipairs(steep) do
    local s = spectrum_of(residuals, squares, counts, jacobian, C, q)
    if not none then
      v, none = best_noise(0, s.u, s.g, s.rest, s.count, most)
      top, cases[1] = none, { value = none, prior = right, noise = v, s2 = 0, of = s }
    end
    for k = #s.u > 0 and s.count > 2 and -10 or math.huge, 15 do
      local size = 10 ^ (k / 5)
      local noise, value = best_noise(size * size, s.u, s.g, s.rest, s.count, most)
      if value > top then v, top = noise, value end
      local density = 2 / math.pi * (size / scale) / (1 + (size / scale) ^ 2) * math.log(10) / 5
      cases[#cases + 1] = { value = value, prior = (1 - right) * density / #steep, noise = noise, s2 = size * size, of = s }
    end
  end
  local sum, likely = 0, {}
  for _, c in ipairs(cases) do
    c.weight, c.effective = c.prior * math.exp(c.value - top), 0 -- by the highest, so that none overflows however long the records
    for _, x in ipairs(c.of.g) do c.effective = c.effective + c.s2 * x / (c.noise + c.s2 * x) end
    sum = sum + c.weight
  end
  local square = 0
  for _, c in ipairs(cases) do
    c.weight = c.weight / sum
    square = square + c.weight * c.s2 * c.of.weights
    if c.weight > 1e-9 then likely[#likely + 1] = c end
  end
  out.noise, out.deviation, out.ratio, out.told = v, math.sqrt(square), 2 * (top - none), 2 * (top - none) > sure
  for i in ipairs(all_covariance) do
    out.covariance[i] = {}
    for l in ipairs(all_covariance) do out.covariance[i][l] = v * all_covariance[i][l] end
    out.half_width[i] = half_width(likely, all_covariance[i][i], nil, math.max(1, m - n))
  end
  for a, i in ipairs(list) do
    for e, l in ipairs(list) do
      for _, c in ipairs(likely) do out.covariance[i][l] = out.covariance[i][l] + c.weight * c.s2 * c.of.smooth[a][e] end
    end
    out.half_width[i] = half_width(likely, all_covariance[i][i], a, math.max(1, m - n))
  end
  return out
end

return discrepancy
