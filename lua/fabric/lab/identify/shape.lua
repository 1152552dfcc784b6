-- The differences of specimens beyond a factor, for fabric.lab.pool: how large it is, its correlation along a curve, and its uncertainty.
--
-- A specimen whose curve runs above the model at one point does so at the next one too. Taken for noise of single points that would make the
-- parameters look better known than they are; and a prediction for the next specimen needs to know from how many independent differences its
-- size was found, since that determines the quantile [satterthwaite1946].
local dot = require("fabric.lists").dot
local shape = {}

-- Residuals over their noise without the specimen's own factor.
local function without_factor(r, u)
  local square, out = dot(u, u), {}
  local b = square > 0 and dot(r, u) / square or 0
  for k, x in ipairs(r) do out[k] = x - b * u[k] end
  return out
end

-- Correlation of residuals as many places apart as the index says.
local function correlations(rests, longest)
  local out, whole, points = { [0] = 1 }, 0, 0
  for _, r in ipairs(rests) do whole, points = whole + dot(r, r), points + #r end
  for lag = 1, longest - 1 do
    local sum, pairs_of = 0, 0
    for _, r in ipairs(rests) do
      for k = 1, #r - lag do sum, pairs_of = sum + r[k] * r[k + lag], pairs_of + 1 end
    end
    out[lag] = whole > 0 and sum / pairs_of / whole * points or 0
  end
  return out
end

-- Of specimens' residuals r and directions u (both over the noise) after a fit of `parameters`: the variance beyond noise 1 and factors, its
-- correlation, and its degrees of freedom.
function shape.of(residuals, directions, parameters)
  local rests, n, points, longest, sum = {}, #residuals, 0, 0, 0
  for i, r in ipairs(residuals) do
    rests[i] = without_factor(r, directions[i])
    points, longest, sum = points + #r, math.max(longest, #r), sum + dot(rests[i], rests[i])
  end
  local correlation = correlations(rests, longest)
  local independent = 0
  for _, r in ipairs(rests) do
    local squares = #r
    for lag = 1, #r - 1 do squares = squares + 2 * (#r - lag) * correlation[lag] ^ 2 end
    independent = independent + (#r) ^ 2 / squares
  end
  -- The fit and the factors take part of it away: of n curves of m independent parts each at most all but (n - 1) (m - 1).
  local each = independent / n
  local left = 1 - math.min(n + parameters - 1, n + each - 1) / independent
  if n < 2 or each <= 1.5 then left = math.max(left, (1 - 1 / math.max(2, n)) / 2) end
  return { variance = sum / points / left, correlation = correlation, freedom = math.max(1, independent * left) }
end

-- R y for a list along one curve. R is found by pairs, so y^T R y may come out too small, even negative: the caller sets a floor.
function shape.times(correlation, y)
  local out = {}
  for j = 1, #y do
    local sum = 0
    for k, b in ipairs(y) do sum = sum + b * correlation[math.abs(j - k)] end
    out[j] = sum
  end
  return out
end

return shape
