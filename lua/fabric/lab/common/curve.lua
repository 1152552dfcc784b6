-- Operations on the points of a curve: interpolation, selection of the virgin loading.
local curve = {}

-- y at x by linear interpolation between the points of a curve (ascending x); nil outside.
function curve.interpolate(xs, ys, x)
  local low, high = 1, #xs
  if high == 0 or x < xs[1] or x > xs[high] then return end
  while high - low > 1 do
    local middle = (low + high) // 2
    if xs[middle] <= x then low = middle else high = middle end
  end
  if high == low or xs[high] == xs[low] then return ys[low] end
  return ys[low] + (ys[high] - ys[low]) * (x - xs[low]) / (xs[high] - xs[low])
end

-- The points beyond all earlier points: virgin loading.
function curve.envelope(xs, ys)
  local x, y, largest = {}, {}, -math.huge
  for i, value in ipairs(xs) do
    if value > largest then
      largest = value
      x[#x + 1], y[#y + 1] = value, ys[i]
    end
  end
  return x, y
end

-- The rows of a test in virgin loading, {E, S}: branches of that kind, up to failure, or up to yield on request.
function curve.loading(test, upto)
  local stop = upto == "yield" and (test.yield or test.failure) or test.failure
  local E, S = {}, {}
  for _, branch in ipairs(test.branches) do
    if branch.kind == "loading" then
      for i = branch.first, math.min(branch.last, stop or branch.last) do
        E[#E + 1], S[#S + 1] = test.E[i], test.S[i]
      end
    end
    if stop and branch.last >= stop then break end
  end
  return { E = E, S = S }
end

-- Strain and stress relative to first contact, the stretch at which the specimen becomes taut.
function curve.from_contact(E, S, stretch) return ((1 + 2 * E) / stretch ^ 2 - 1) / 2, S * stretch end

return curve
