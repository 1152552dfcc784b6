-- Small symmetric positive definite matrices as lists of rows, for covariances of a few parameters.
local linear = {}

function linear.zeros(n)
  local out = {}
  for i = 1, n do
    out[i] = {}
    for j = 1, n do out[i][j] = 0.0 end
  end
  return out
end

-- Cholesky factor L of A = L L^T after scaling A to a unit diagonal; and the scale.
local function factor(A)
  local n, scale, L = #A, {}, linear.zeros(#A)
  for i = 1, n do scale[i] = 1 / math.sqrt(A[i][i]) end
  for i = 1, n do
    for j = 1, i do
      local sum = A[i][j] * scale[i] * scale[j]
      for k = 1, j - 1 do sum = sum - L[i][k] * L[j][k] end
      L[i][j] = i == j and math.sqrt(math.max(sum, 1e-15)) or sum / L[j][j]
    end
  end
  return L, scale
end

-- x of A x = b.
function linear.solve(A, b)
  local L, scale = factor(A)
  local n, y = #A, {}
  for i = 1, n do
    local sum = b[i] * scale[i]
    for k = 1, i - 1 do sum = sum - L[i][k] * y[k] end
    y[i] = sum / L[i][i]
  end
  for i = n, 1, -1 do
    for k = i + 1, n do y[i] = y[i] - L[k][i] * y[k] end
    y[i] = y[i] / L[i][i]
  end
  for i = 1, n do y[i] = y[i] * scale[i] end
  return y
end

function linear.inverse(A)
  local n, out = #A, linear.zeros(#A)
  for j = 1, n do
    local unit = {}
    for i = 1, n do unit[i] = i == j and 1 or 0 end
    local column = linear.solve(A, unit)
    for i = 1, n do out[i][j] = column[i] end
  end
  return out
end

function linear.log_determinant(A)
  local L, scale = factor(A)
  local sum = 0
  for i = 1, #A do sum = sum + 2 * math.log(L[i][i] / scale[i]) end
  return sum
end

-- x^T A x
function linear.quadratic(A, x)
  local sum = 0
  for i = 1, #x do
    for j = 1, #x do sum = sum + A[i][j] * x[i] * x[j] end
  end
  return sum
end

return linear
