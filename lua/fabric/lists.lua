-- Lists and tables: how one follows from another, sums in the order of the list, and order.
local lists = {}

-- { f(first, 1), f(second, 2), ... }
function lists.map(list, f)
  local out = {}
  for i, value in ipairs(list) do out[i] = f(value, i) end
  return out
end

-- The same without nil.
function lists.collect(list, f)
  local out = {}
  for i, value in ipairs(list) do out[#out + 1] = f(value, i) end
  return out
end

-- { f(1), ..., f(n) }
function lists.of(n, f)
  local out = {}
  for i = 1, n do out[i] = f(i) end
  return out
end

function lists.scaled(list, factor)
  local out = {}
  for i, x in ipairs(list) do out[i] = x * factor end
  return out
end

function lists.joined(...)
  local out = {}
  for _, list in ipairs { ... } do table.move(list, 1, #list, #out + 1, out) end
  return out
end

-- The entries of a table, of which further ones, such as changes, take precedence.
function lists.copy(t, changes)
  local out = {}
  for key, value in pairs(t) do out[key] = value end
  for key, value in pairs(changes or {}) do out[key] = value end
  return out
end

-- Of f of each, if there is an f.
function lists.sum(list, f)
  local sum = 0
  for i, value in ipairs(list) do sum = sum + (f and f(value, i) or value) end
  return sum
end

function lists.mean(list, f) return lists.sum(list, f) / #list end

function lists.dot(a, b)
  local sum = 0
  for i = 1, #a do sum = sum + a[i] * b[i] end
  return sum
end

function lists.largest(list, f)
  local largest = -math.huge
  for i, value in ipairs(list) do largest = math.max(largest, f and f(value, i) or value) end
  return largest
end

function lists.keys(t)
  local keys = {}
  for key in pairs(t) do keys[#keys + 1] = key end
  table.sort(keys)
  return keys
end

-- The lower one of two in the middle; sorts the list.
function lists.median(list)
  table.sort(list)
  return list[(#list + 1) // 2]
end

-- Of ascending numbers, by linear interpolation between them; part from 0 to 1.
function lists.quantile(numbers, part)
  local place = 1 + part * (#numbers - 1)
  local k = math.floor(place)
  return k >= #numbers and numbers[#numbers] or numbers[k] + (place - k) * (numbers[k + 1] - numbers[k])
end

return lists
