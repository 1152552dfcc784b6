-- Isolated wrong readings, for example from a display read off photographs, or a sample lost by a load cell. A row is an outlier if it is
-- far from the values that the rows before and after it predict, each by a line of median slope [sen1968]. A rupture is a step, whose rows
-- agree with one of the sides, and the tip of a reversal lies on the lines of both.
local outliers = {}

local reach = 8          -- rows on either side
local times = 8          -- deviations of the scatter
local floor = 0.02       -- of the largest value; smaller deviations are accepted
local longest = 24       -- rows in a run of outliers

local function median(list)
  table.sort(list)
  local n = #list
  return n % 2 == 1 and list[(n + 1) // 2] or (list[n // 2] + list[n // 2 + 1]) / 2
end

-- Value at row `at` of the line with median slope and median offset through the rows of a list.
local function line(rows, y, at)
  local slopes, offsets = {}, {}
  for i = 1, #rows do
    for j = i + 1, #rows do slopes[#slopes + 1] = (y[rows[j]] - y[rows[i]]) / (rows[j] - rows[i]) end
  end
  local slope = #slopes > 0 and median(slopes) or 0
  for i, row in ipairs(rows) do offsets[i] = y[row] + slope * (at - row) end
  return median(offsets)
end

-- Rows of one side: the nearest ones that are not outliers, in the order of the list.
local function side(bad, from, step, n)
  local rows, row = {}, from
  while #rows < reach and row >= 1 and row <= n and math.abs(row - from) < longest + reach do
    if not bad[row] then rows[#rows + 1] = row end
    row = row + step
  end
  return rows
end

-- Scatter of the values about the mean of their neighbours: 1.4826 times the median of the absolute deviations, which is the standard
-- deviation for a normal distribution.
local function scatter(y)
  local sizes = {}
  for i = 2, #y - 1 do sizes[#sizes + 1] = math.abs(y[i] - (y[i - 1] + y[i + 1]) / 2) end
  return #sizes > 0 and 1.4826 * median(sizes) / math.sqrt(1.5) or 0
end

-- Places of the outliers in a list of readings, in order.
function outliers.find(y)
  local n, peak = #y, 0
  for _, v in ipairs(y) do peak = math.max(peak, math.abs(v)) end
  local limit = math.max(times * scatter(y), floor * peak)
  local bad, found = {}, {}
  for i = 2, n - 1 do
    -- Only rows far from the last accepted row before them are examined.
    local before = side(bad, i - 1, -1, n)
    if #before >= 3 and math.abs(y[i] - y[before[1]]) > limit then
      local left = line(before, y, i)
      local behind = {}
      if math.abs(y[i] - left) > limit then
        -- If later rows continue from the rows before, the outliers end there.
        for row = i + 1, math.min(n, i + longest) do
          if math.abs(y[row] - left) <= limit + math.abs(left - y[before[1]]) * (row - i + 1) then behind[#behind + 1] = row end
          if #behind == reach then break end
        end
        local back = #behind >= 3 and line(behind, y, i) or nil
        if back and math.abs(y[i] - back) > limit and (y[i] > left) == (y[i] > back) then bad[i], found[#found + 1] = true, i end
      end
    end
  end
  return found
end

return outliers
