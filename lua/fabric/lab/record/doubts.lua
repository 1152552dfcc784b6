-- Signs in a record of how it was written or measured: numbers the wrong way round, a second pull in the same rows, an extensometer that was taken off, a zero
-- that drifts. Each is {code, text, row}; fabric.lab.read tells them and keeps them in record.warnings, fabric.lab.tensile in test.warnings.
local scatter = require("fabric.lab.record.signs").scatter
local doubts = {}

local function range(list)
  local low, high, least, most = list[1], list[1], 1, 1
  for i, v in ipairs(list) do
    if v < low then low, least = v, i end
    if v > high then high, most = v, i end
  end
  return low, high, least, most
end

-- --- signs the wrong way round ---

local function is_negative(low, high) return high <= 0 and low < 0 or -low > 2 * math.max(high, 0) and low < 0 end

-- The quantity that must be reversed: "both", "displacement", "force" or nil; and in words why.
function doubts.reversed(u, F)
  local Flow, Fhigh, Fleast, Fmost = range(F)
  if #F < 2 or Fhigh == Flow then return end
  local force = is_negative(Flow, Fhigh)
  local peak = force and Fleast or Fmost
  local low, high = range(u)
  if high == low then return end
  local falls = u[peak] - u[1] < -0.5 * (high - low)
  if force and falls then
    return "both", ("displacement and force both run below zero or fall in the pull (displacement from %.4g to %.4g m, force from %.4g to %.4g N): the frame counts a pull "
      .. "negative. reverse='both' changes both signs"):format(u[1] + 0.0, u[peak], F[1] + 0.0, F[peak])
  elseif force then
    return "force", ("force runs from %.4g to %.4g N: a pull counts positive; change the sign of the record (reverse='force')"):format(Flow, Fhigh + 0.0)
  elseif falls then
    local offset = math.abs(u[1]) > 0.02 * (high - low)
    return "displacement", ("displacement falls from %.4g to %.4g m while the force rises from %.4g to %.4g N: it is %s. reverse='displacement' changes its sign%s"):format(u[1], u[peak],
      F[1], F[peak], offset and "the position of a part that moves the other way" or "counted the other way", offset and ", and zero=true takes the beginning off" or "")
  end
end

-- --- another pull in the same rows ---

local least_way, at_start, steps = 0.5, 0.05, 5

-- Rows at which displacement and force are back at their beginning within two rows, though the displacement never moved so far in a row, and then another pull
-- begins: the way back of a cycle would be in the record.
function doubts.restarts(u, F)
  local rows, first, row = {}, 1, 3
  local low, high, most, top = u[1], u[1], 0, F[1]
  local function leaps(k)
    local from = k > first + 1 and math.max(u[k - 1], u[k - 2]) or u[k - 1]
    return k - first >= 4 and from - u[k] > least_way * (high - low) and from - u[k] > steps * most and u[k] - low < at_start * (high - low)
      and math.abs(F[k] - F[first]) < at_start * (top - F[first])
  end
  local function goes_on(k)
    local far = u[k]
    for i = k + 1, #u do
      far = math.max(far, u[i])
      if i - k >= 3 and far - u[k] > 0.25 * (high - low) and F[i] - F[k] > 0.1 * (top - F[first]) then return true end
    end
    return false
  end
  low, high, most, top = math.min(u[1], u[2] or u[1]), math.max(u[1], u[2] or u[1]), math.abs((u[2] or u[1]) - u[1]), math.max(F[1], F[2] or F[1])
  while row <= #u do
    if leaps(row) and goes_on(row) then
      rows[#rows + 1], first = row, row
      low, high, most, top = u[row], u[row], 0, F[row]
    else
      low, high, most, top = math.min(low, u[row]), math.max(high, u[row]), math.max(most, u[row] - u[row - 1]), math.max(top, F[row])
    end
    row = row + 1
  end
  return rows
end

-- --- an extensometer that was taken off ---

local least_rows, least_rise = 4, 0.05

-- The largest rise of the force over rows in which the displacement stands still, up to `last`: what its resolution hides.
local function hidden(u, F, last)
  local most, from = 0, 1
  for i = 2, last do
    if u[i] ~= u[from] then from = i end
    most = math.max(most, F[i] - F[from])
  end
  return most
end

-- The last row that counts, where the force goes on beyond what it was while the displacement stands still or is back for good; nil if it does not.
function doubts.extensometer(u, F)
  local _, top, _, peak = range(F)
  local low, high = range(u)
  if high == low or peak <= least_rows then return end
  local eps, reach, row = 1e-3 * (high - low), u[1], 1
  for i = 2, peak do
    if u[i] > reach + eps then reach, row = u[i], i end
  end
  -- the force at which the displacement was largest, in the rows that reach it
  local before = F[row]
  for i = 1, row do before = math.max(before, F[i]) end
  local rise = math.max(least_rise * (top - F[1]), 3 * hidden(u, F, row), 6 * scatter(F))
  if row > 2 and peak - row >= least_rows and F[peak] - before > rise then return row end
end

-- --- a zero that drifts ---

local least_drift = 0.01

local function drift_of(out, name, values, unit, last, quiet)
  local low, high = math.huge, -math.huge
  local least = 1
  for i, v in ipairs(values) do
    if v < low then low, least = v, i end
    high = math.max(high, v)
  end
  local limit = math.max(least_drift * (high - low), quiet and 5 * scatter(values) or 0)
  if low >= -limit then return end
  local from = values[1]
  if from - low <= limit then return end -- it begins there: an offset, of which the reader of the record speaks
  out[#out + 1] = { code = "drift", row = least, text = ("%s falls below zero, from %.4g at the beginning to %.4g %s in row %d%s, of at most %.4g: %s; zero=true takes off only what it is in the first row")
    :format(name, from, low, unit, least, least > last and ", behind the largest force" or "", high,
      name == "force" and "the zero of the load cell drifts, or the cloth was pushed" or "the zero drifts, or the jaws came closer than they were") }
end

-- The first row of the largest value of a list.
function doubts.largest_row(F)
  local top = 1
  for i = 2, #F do
    if F[i] > F[top] then top = i end
  end
  return top
end

-- All of them, in a list. restarts: "tell", or nil where they were settled.
function doubts.of(record, restarts)
  local u, F, out = record.displacement, record.force, {}
  for _, list in ipairs { u, F } do
    for _, v in ipairs(list) do
      if v ~= v or v == math.huge or v == -math.huge then return out end
    end
  end
  if #u < 2 then return out end
  local which, why = doubts.reversed(u, F)
  if which then
    out[1] = { code = "reversed", which = which, row = 1, text = why }
    return out
  end
  local rows = doubts.restarts(u, F)
  if #rows > 0 then
    if restarts == "tell" then
      out[#out + 1] = { code = "restart", row = rows[1], rows = rows,
        text = ("displacement and force leap back to their beginning in row %d (%.4g to %.4g m), and rise again%s: does another specimen begin here? It is read as the same, as a cycle "
          .. "whose way back is missing; restarts='specimens' reads %d specimens, restarts='cycles' says that it is one"):format(rows[1], u[rows[1] - 1], u[rows[1]],
          #rows > 1 and (", %d times"):format(#rows) or "", #rows + 1) }
    end
  else
    local row = doubts.extensometer(u, F)
    if row then
      local _, top = range(F)
      out[#out + 1] = { code = "extensometer", row = row,
        text = ("the displacement ends at %.4g m in row %d, and the force goes on from %.4g to %.4g N: was the extensometer taken off? Later rows are not used for the strain")
          :format(u[row], row, F[row], top) }
    end
  end
  local last = doubts.largest_row(F)
  drift_of(out, "force", F, "N", last, true)
  drift_of(out, "displacement", u, "m", last, true)
  return out
end

-- The row behind which the displacement of a record says nothing; nil if all of it counts.
function doubts.end_of(list)
  for _, one in ipairs(list or {}) do
    if one.code == "extensometer" then return one.row end
  end
end

-- The record up to that row; its whole force and time are `beyond`.
function doubts.cut(record, row)
  local out, n = {}, #record.force
  for name, values in pairs(record) do
    out[name] = type(values) == "table" and #values == n and table.move(values, 1, row, 1, {}) or values
  end
  out.beyond = { force = record.force, time = record.time }
  return out
end

-- The record with signs changed: which is "both", "displacement" or "force".
function doubts.reverse(record, which)
  if not which or which == "none" then return record end
  for _, name in ipairs { "displacement", "strain", "force" } do
    if record[name] and (which == "both" or which == name or which == "displacement" and name == "strain") then
      for i, v in ipairs(record[name]) do record[name][i] = -v + 0.0 end
    end
  end
  return record
end

return doubts
