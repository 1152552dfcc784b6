-- Peaks of a tear record, and their means as the standards define them.
local peaks = {}

local skipped = 0.25 -- of the record, before its mean is taken

-- Mean force over the way after the first quarter of it, from lists of displacement and force; nil if the displacement does not grow.
function peaks.mean_force(displacement, force)
  local n = #displacement
  local from, work, way = displacement[1] + skipped * (displacement[n] - displacement[1]), 0, 0
  for i = 2, n do
    local step = displacement[i] - displacement[i - 1]
    if displacement[i - 1] >= from and step > 0 then
      work, way = work + step * (force[i] + force[i - 1]) / 2, way + step
    end
  end
  return way > 0 and work / way or nil
end

-- The peaks of a curve of { displacement=, force= }: the force falls by at least this share of it before the next one, and has risen by as
-- much of it since the one before.
function peaks.of(curve, share)
  local out, high, low, rising = {}, nil, curve[1], true
  for _, row in ipairs(curve) do
    if rising then
      if not high or row.force > high.force then high = row end
      if high.force > 0 and row.force < (1 - share) * high.force then
        out[#out + 1], low, rising = high, row, false
      end
    else
      if row.force < low.force then low = row end
      if row.force - low.force > share * row.force then high, rising = row, true end
    end
  end
  return out
end

local function mean(list)
  local sum = 0
  for _, row in ipairs(list) do sum = sum + row.force end
  return #list > 0 and sum / #list or nil
end

-- ISO 13937-2, 10.3 and ISO 13937-3: the record from the first peak to the last is divided into four equal parts; the mean of all
-- peaks but those of the first part.
function peaks.iso(list)
  if #list == 0 then return end
  local first, last, counted = list[1].displacement, list[#list].displacement, {}
  for _, row in ipairs(list) do
    if row.displacement >= first + (last - first) / 4 then counted[#counted + 1] = row end
  end
  return mean(counted)
end

-- ASTM D2261 and D5587: the mean of the five highest peaks; of a record with fewer, its highest.
function peaks.astm(list)
  local sorted = { table.unpack(list) }
  table.sort(sorted, function(a, b) return a.force > b.force end)
  if #sorted < 5 then return sorted[1] and sorted[1].force end
  return mean { table.unpack(sorted, 1, 5) }
end

return peaks
