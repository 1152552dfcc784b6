-- Histories as points for decks of other solvers: those that were given as points as they are, functions of time within a stated error.
local define = require "fabric.define"
local tabulate = {}

local first = 32       -- equal parts that are looked at before any is divided, so that a function that comes back is not missed
local shortest = 20    -- halvings of such a part at most: a jump is that narrow
local most = 20000     -- points at most
local looked = { 0.25, 0.5, 0.75 } -- places within a part at which it is compared with the straight line

-- Points {t, v} from 0 to `duration` of a function, between which it differs from a straight line by at most `share` of its range at the places looked at;
-- and the largest difference seen, in the function's unit.
function tabulate.of_function(f, duration, share)
  local values, low, high = {}, math.huge, -math.huge
  for i = 0, first do
    values[i] = f(duration * i / first)
    low, high = math.min(low, values[i]), math.max(high, values[i])
  end
  local out, worst = { { 0, values[0] } }, 0
  local function divide(a, va, b, vb, depth)
    local at, off = {}, 0
    for k, s in ipairs(looked) do
      at[k] = f(a + s * (b - a))
      low, high = math.min(low, at[k]), math.max(high, at[k])
      off = math.max(off, math.abs(at[k] - (va + s * (vb - va))))
    end
    if off > share * (high - low) and depth < shortest and #out < most then
      local middle = (a + b) / 2
      divide(a, va, middle, at[2], depth + 1)
      divide(middle, at[2], b, vb, depth + 1)
    else
      out[#out + 1], worst = { b, vb }, math.max(worst, off)
    end
  end
  for i = 1, first do divide(duration * (i - 1) / first, values[i - 1], duration * i / first, values[i], 0) end
  return out, worst
end

-- The points of a history that has some, from 0 to at least `duration`: before its first and after its last point it holds their values.
function tabulate.of_points(history, points, duration)
  local out = {}
  if points[1][1] ~= 0 then out[1] = { 0, history:value(0) } end
  for _, p in ipairs(points) do
    if p[1] >= 0 then out[#out + 1] = { p[1], p[2] } end
  end
  local last = out[#out]
  if last[1] < duration then out[#out + 1] = { duration, last[2] } end
  return out
end

-- Points that a deck gives: each { t, v }, with times that increase.
function tabulate.check(points, field)
  for i, p in ipairs(points) do
    if type(p) ~= "table" or type(p[1]) ~= "number" or type(p[2]) ~= "number" or (i > 1 and not (p[1] > points[i - 1][1])) then
      define.fail(("model: field '%s': expected points {t, v} with times that increase, got something else at place %d"):format(field, i))
    end
  end
  if #points == 0 then define.fail(("model: field '%s': expected points {t, v}, got an empty table"):format(field)) end
  return points
end

return tabulate
