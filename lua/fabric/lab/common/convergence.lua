-- Where values on finer and finer meshes (or with shorter and shorter steps) go, from three of them, whatever the ratio of their sizes.
--
-- With f = f0 + c h^p the order p solves (f1 - f2) / (f2 - f3) = (h1^p - h2^p) / (h2^p - h3^p), whose right side grows with p; then f0 = f3 - (f2 - f3) h3^p / (h2^p - h3^p)
-- is the value that is given. How far it may be wrong shows in what other orders would have given: half an order less and more, and the parabola through the three values, which holds
-- if the first and second order act together. Values that do not come nearer to each other as an order of 0.4 demands (or go back and forth) tell nothing of f0.
local convergence = {}

local least, most, cap = 0.4, 8, 4 -- orders: of convergence at all; that are looked for; that are extrapolated with
local safety = 0.7                 -- standard uncertainty over the largest difference of the extrapolations
local share = 0.5                  -- of the extrapolation itself, the least of that difference
local lost = 0.7                   -- standard uncertainty over the spread, where the values tell nothing

local function limit(h, f, p) return f[3] - (f[2] - f[3]) * h[3] ^ p / (h[2] ^ p - h[3] ^ p) end

-- The parabola through three values, at size zero.
local function parabola(h, f)
  local sum = 0
  for i = 1, 3 do
    local weight = 1
    for j = 1, 3 do
      if j ~= i then weight = weight * h[j] / (h[j] - h[i]) end
    end
    sum = sum + weight * f[i]
  end
  return sum
end

-- The order that three values show; nil if it is below the least.
local function order_of(h, f)
  local function ratio(p) return (h[1] ^ p - h[2] ^ p) / (h[2] ^ p - h[3] ^ p) end
  local quotient = (f[1] - f[2]) / (f[2] - f[3])
  if f[2] == f[3] or quotient ~= quotient or quotient < 0 or quotient < ratio(least) * (1 - 1e-9) then return end
  if quotient >= ratio(most) then return most end
  local low, high = least, most
  for _ = 1, 80 do
    local middle = (low + high) / 2
    if ratio(middle) < quotient then low = middle else high = middle end
  end
  return (low + high) / 2
end

-- sizes: falling lengths (of elements, or steps); values there. Returns { value, deviation (standard uncertainty), order }: from the last three, order is nil where they tell nothing, and the
-- value then the last; from two, whose order is unknown, the last value with three times the uncertainty of an order of one; nil for one.
function convergence.of(sizes, values)
  local n = #values
  if n < 2 then return end
  local h, f = {}, {}
  if n == 2 then
    return { value = values[2], deviation = 3 * math.abs(values[2] - values[1]) / math.max(sizes[1] / sizes[2] - 1, 1e-9) / 2, order = 1, two = true }
  end
  for k = 1, 3 do h[k], f[k] = sizes[n - 3 + k], values[n - 3 + k] end
  local spread = math.max(f[1], f[2], f[3]) - math.min(f[1], f[2], f[3])
  if spread <= 1e-12 * math.abs(f[3]) then return { value = f[3], deviation = 0 } end
  local order, bent = order_of(h, f), parabola(h, f)
  if not order then return { value = f[3], deviation = lost * math.max(spread, math.abs(bent - f[3])), untold = true } end
  local p = math.min(order, cap)
  local value = limit(h, f, p)
  local apart = math.max(share * math.abs(f[3] - value), math.abs(bent - value), math.abs(limit(h, f, p + 0.5) - value),
    math.abs(limit(h, f, p > 1.25 and math.max(1, p - 0.5) or 0.8 * p) - value))
  return { value = value, deviation = safety * apart, order = order }
end

return convergence
