-- Small symmetric positive definite matrices as lists of rows, for covariances of a few parameters.
local lists = require "fabric.lists"
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

-- A B
function linear.product(A, B)
  local out = linear.zeros(#A)
  for i = 1, #A do
    for j = 1, #A do
      for k = 1, #A do out[i][j] = out[i][j] + A[i][k] * B[k][j] end
    end
  end
  return out
end

-- A list without its correlation along a direction: its covariance is 1 + variance u u^T, and it is multiplied by the inverse square root of that.
function linear.whitened(list, u, variance, square)
  square = square or lists.dot(u, u)
  if variance == 0 or square == 0 then return list end
  local part, out = (1 - 1 / math.sqrt(1 + variance * square)) * lists.dot(u, list) / square, {}
  for k, x in ipairs(list) do out[k] = x - part * u[k] end
  return out
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
