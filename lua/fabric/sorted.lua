-- What stands in order: the keys of a table, and the quantiles of numbers.
local sorted = {}

function sorted.keys(t)
  local keys = {}
  for key in pairs(t) do keys[#keys + 1] = key end
  table.sort(keys)
  return keys
end

-- Of ascending numbers, by linear interpolation between them; part from 0 to 1.
function sorted.quantile(numbers, part)
  local place = 1 + part * (#numbers - 1)
  local k = math.floor(place)
  return k >= #numbers and numbers[#numbers] or numbers[k] + (place - k) * (numbers[k + 1] - numbers[k])
end

return sorted
