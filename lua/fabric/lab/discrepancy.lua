-- What a model misses beside the noise: a smooth difference along each test, estimated from the residuals of a fit, and what it does to the fitted parameters.
--
-- Residuals over their noise after the fit, r = M (d + e): e is independent with variance v, at least 1; d = sum_j c_j phi_j, cosines along the points of each test, var(c_j) = s^2 / (1 + j^2/4)^1.5.
-- M takes away what the parameters explain. v and s^2 follow from the restricted likelihood [patterson1971]. Where the parameters would have followed d, nothing of it is in the residuals; that
-- part has the same s^2. Whether there is such a difference is uncertain too: the prior gives the model even odds of being right (s = 0), and else to s half below half the noise. Each s weighs by its
-- likelihood [kennedy2001]; for each the parameters' covariance is C J^T (v I + s^2 Phi W Phi^T) J C with C = (J^T J)^-1, and an interval is of the mixture of them, so that residuals that look like
-- noise narrow it by as much as they would have shown.
local linear = require "fabric.lab.linear"
local discrepancy = {}

local modes, fewest = 6, 8 -- of a test; points of a test of which smooth differences can be told from noise
local right, scale = 1/2, 0.5 -- the prior: of a model that misses nothing, and the median of s where it does
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
          for k = 1, n do A[k][p], A[k][q] = c * A[k][p] - s * A[k][q], s * A[k][p] + c * A[k][q] end
          for k = 1, n do A[p][k], A[q][k] = c * A[p][k] - s * A[q][k], s * A[p][k] + c * A[q][k] end
          for k = 1, n do V[k][p], V[k][q] = c * V[k][p] - s * V[k][q], s * V[k][p] + c * V[k][q] end
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
local function share_of(j) return 1 / (1 + j * j / 4) ^ 1.5 end

-- The weighted cosines of all tests, each a list { first, values } over the points of its test.
local function functions_of(counts)
  local out, first = {}, 0
  for _, n in ipairs(counts) do
    if n >= fewest then
      for j = 0, math.min(modes, n // 3) - 1 do
        local values, weight = {}, math.sqrt((j == 0 and 1 or 2) * share_of(j))
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

-- What the residuals keep beside the derivatives: nothing but themselves at a minimum, and a fit ends near it.
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

-- Student's probability beyond -t and t, for whole degrees of freedom by the finite sum of powers of the cosine, between them in proportion; from 100 on as for 100.
local function beyond(t, freedom)
  local low = math.floor(math.min(freedom, 100))
  local function whole(n)
    local angle = math.atan(t / math.sqrt(n))
    local square, odd = math.cos(angle) ^ 2, n % 2
    local term, sum = odd == 1 and math.cos(angle) or 1, 0
    for k = 1, n // 2 do
      sum, term = sum + term, term * (2 * k - 1 + odd) / (2 * k + odd) * square
    end
    return 1 - (odd == 1 and (angle + math.sin(angle) * sum) * 2 / math.pi or math.sin(angle) * sum)
  end
  local part = math.min(freedom, 100) - low
  return part > 0 and (1 - part) * whole(low) + part * whole(low + 1) or whole(low)
end

-- Half of the 95 % interval of a parameter whose variance is own v + smooth s^2 in each case { weight, noise = v, s2, effective }, with m degrees of freedom of v and `effective` ones of s^2.
local function half_width(cases, own, smooth, m)
  if not (own < math.huge and smooth < math.huge) then return math.huge end -- the records do not determine it
  local list, high = {}, 0
  for _, c in ipairs(cases) do
    local a, b = own * c.noise, smooth * c.s2
    if a + b > 0 then
      list[#list + 1] = { weight = c.weight, deviation = math.sqrt(a + b), freedom = (a + b) ^ 2 / (a * a / m + b * b / math.max(1, c.effective)) }
      high = math.max(high, 13 * math.sqrt(a + b)) -- 12.7 is the quantile of one degree of freedom
    end
  end
  local low = 0
  for _ = 1, 40 do
    local at, outside = (low + high) / 2, 0
    for _, c in ipairs(list) do outside = outside + c.weight * beyond(at / c.deviation, c.freedom) end
    if outside > 0.05 then low = at else high = at end
  end
  return high
end

-- residuals: predicted less measured over the noise, all tests one after the other, `counts` points each; all_derivatives: theirs by the parameters, row by row; all_covariance: (J^T J)^-1, a
-- list of rows; fixed: true for a parameter on a bound, which counts as known. Returns { noise (v), deviation (rms of d over the noise), ratio (twice the logarithm of the likelihoods'), told, covariance, half_width (of each parameter's 95 % interval) }.
function discrepancy.of(all_residuals, counts, all_derivatives, all_covariance, fixed)
  local list, jacobian, C = moved(all_derivatives, all_covariance, fixed or {})
  local residuals = beside(all_residuals, jacobian, C)
  local m, n, phi = #residuals, #C, functions_of(counts)
  local out, squares = { noise = 1, deviation = 0, ratio = 0, told = false, covariance = {}, half_width = {} }, 0
  for _, r in ipairs(residuals) do squares = squares + r * r end
  -- J^T phi, and phi without what the parameters explain
  local with_J, explained = {}, {}
  for q, f in ipairs(phi) do
    with_J[q], explained[q] = {}, {}
    for i = 1, n do
      local sum = 0
      for k, x in ipairs(f.values) do sum = sum + x * jacobian[(f.first + k - 1) * n + i] end
      with_J[q][i] = sum
    end
    for i = 1, n do
      local sum = 0
      for l = 1, n do sum = sum + C[i][l] * with_J[q][l] end
      explained[q][i] = sum
    end
  end
  local G, b = {}, {}
  for q, f in ipairs(phi) do
    G[q], b[q] = {}, 0
    for k, x in ipairs(f.values) do b[q] = b[q] + x * residuals[f.first + k] end
    for p, h in ipairs(phi) do
      local sum = 0
      if f.first == h.first then
        for k, x in ipairs(f.values) do sum = sum + x * h.values[k] end
      end
      for i = 1, n do sum = sum - with_J[q][i] * explained[p][i] end
      G[q][p] = sum
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
        for q = 1, #phi do along = along + V[q][i] * b[q] end
        u[#u + 1], g[#g + 1] = along / math.sqrt(x), x
        rest = rest - along * along / x
      end
    end
  end
  local count = math.max(0, m - n - #u)
  rest = math.max(rest, 0)
  local most = 4 * math.max(1, squares / math.max(1, m - n))
  local v, none = best_noise(0, u, g, rest, count, most)
  -- s2, averaged over the model that misses nothing and sizes that are even in their logarithm, of which the prior has `density` each
  local s2, top, cases = 0, none, { { value = none, prior = right, noise = v, s2 = 0 } }
  if #u > 0 and count > 2 then
    for k = -20, 30 do
      local size = 10 ^ (k / 10)
      local noise, value = best_noise(size * size, u, g, rest, count, most)
      if value > top then v, top = noise, value end
      local density = 2 / math.pi * (size / scale) / (1 + (size / scale) ^ 2) * math.log(10) / 10
      cases[#cases + 1] = { value = value, prior = (1 - right) * density, noise = noise, s2 = size * size }
    end
  end
  local sum, likely = 0, {}
  for _, c in ipairs(cases) do
    c.weight, c.effective = c.prior * math.exp(c.value - top), 0 -- by the highest, so that none overflows however long the records
    for _, x in ipairs(g) do c.effective = c.effective + c.s2 * x / (c.noise + c.s2 * x) end
    sum = sum + c.weight
  end
  for _, c in ipairs(cases) do
    c.weight = c.weight / sum
    s2 = s2 + c.weight * c.s2
    if c.weight > 1e-9 then likely[#likely + 1] = c end
  end
  local weights = 0
  for j = 0, modes - 1 do weights = weights + share_of(j) end
  out.noise, out.deviation, out.ratio, out.told = v, math.sqrt(s2 * weights), 2 * (top - none), 2 * (top - none) > sure
  for i in ipairs(all_covariance) do
    out.covariance[i] = {}
    for l in ipairs(all_covariance) do out.covariance[i][l] = v * all_covariance[i][l] end
    out.half_width[i] = half_width(likely, all_covariance[i][i], 0, math.max(1, m - n))
  end
  for a, i in ipairs(list) do
    for e, l in ipairs(list) do
      local smooth = 0
      for q = 1, #phi do smooth = smooth + explained[q][a] * explained[q][e] end
      out.covariance[i][l] = v * all_covariance[i][l] + s2 * smooth
      if a == e then out.half_width[i] = half_width(likely, all_covariance[i][i], smooth, math.max(1, m - n)) end
    end
  end
  return out
end

return discrepancy
