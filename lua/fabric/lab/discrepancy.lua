-- What a model misses beside the noise: a smooth difference along each test, estimated from the residuals of a fit, and what it does to the fitted parameters.
--
-- Residuals over their noise after the fit, r = M (d + e): e is independent with variance v, at least 1; d = sum_j c_j phi_j, cosines along the points of each test, var(c_j) = s^2 / (1 + j^2/4).
-- M takes away what the parameters explain. v and s^2 follow from the restricted likelihood [patterson1971]. Where the parameters would have followed d, nothing of it is in the residuals; that
-- part has the same s^2, averaged over its likelihood (prior of s: half of it below half the noise, since what the residuals do not show may be there), and so the parameters' covariance is C J^T (v I + s^2 Phi W Phi^T) J C with C = (J^T J)^-1 [kennedy2001].
local linear = require "fabric.lab.linear"
local discrepancy = {}

local modes, fewest = 6, 8 -- of a test; points of a test of which smooth differences can be told from noise
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

-- The weighted cosines of all tests, each a list { first, values } over the points of its test.
local function functions_of(counts)
  local out, first = {}, 0
  for _, n in ipairs(counts) do
    if n >= fewest then
      for j = 0, math.min(modes, n // 3) - 1 do
        local values, weight = {}, math.sqrt((j == 0 and 1 or 2) / (1 + j * j / 4))
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

-- residuals: predicted less measured over the noise, all tests one after the other, `counts` points each; all_derivatives: theirs by the parameters, row by row; all_covariance: (J^T J)^-1, a
-- list of rows; fixed: true for a parameter on a bound, which counts as known. Returns { noise (v), deviation (rms of d over the noise), ratio (twice the logarithm of the likelihoods'), told, covariance, freedom (of each parameter's variance) }.
function discrepancy.of(all_residuals, counts, all_derivatives, all_covariance, fixed)
  local list, jacobian, C = moved(all_derivatives, all_covariance, fixed or {})
  local residuals = beside(all_residuals, jacobian, C)
  local m, n, phi = #residuals, #C, functions_of(counts)
  local out, squares = { noise = 1, deviation = 0, ratio = 0, told = false, covariance = {}, freedom = {} }, 0
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
  -- s2, averaged
  local s2, top = 0, none
  if #u > 0 and count > 2 then
    local whole, sum, values, highest = 0, 0, {}, none
    for k = -20, 30 do
      local size = 10 ^ (k / 10)
      local noise, value = best_noise(size * size, u, g, rest, count, most)
      if value > top then v, top = noise, value end
      values[#values + 1], highest = { size = size, value = value }, math.max(highest, value)
    end
    for _, at in ipairs(values) do -- likelihoods by the highest, so that none overflows however long the records
      local weight = math.exp(at.value - highest) * at.size / (1 + (at.size / 0.5) ^ 2)
      sum, whole = sum + weight, whole + weight * at.size ^ 2
    end
    s2 = whole / sum
  end
  local effective, weights = 0, 0
  for j = 0, modes - 1 do weights = weights + 1 / (1 + j * j / 4) end
  for _, x in ipairs(g) do effective = effective + s2 * x / (v + s2 * x) end
  out.noise, out.deviation, out.ratio, out.told = v, math.sqrt(s2 * weights), 2 * (top - none), 2 * (top - none) > sure
  for i in ipairs(all_covariance) do
    out.covariance[i] = {}
    for l in ipairs(all_covariance) do out.covariance[i][l] = v * all_covariance[i][l] end
    out.freedom[i] = math.max(1, m - n)
  end
  for a, i in ipairs(list) do
    for e, l in ipairs(list) do
      local smooth = 0
      for q = 1, #phi do smooth = smooth + explained[q][a] * explained[q][e] end
      out.covariance[i][l] = v * all_covariance[i][l] + s2 * smooth
      if a == e then
        local own, c = v * all_covariance[i][i], s2 * smooth
        out.freedom[i] = own + c > 0 and (own + c) ^ 2 / (own * own / math.max(1, m - n) + c * c / math.max(1, effective)) or 1
      end
    end
  end
  return out
end

return discrepancy
