-- Signs in a single record that the specimen was not held as it should be: slip in the jaws, a late grip. They are told, not mended.
local signs = {}

local function median(list)
  table.sort(list)
  return list[(#list + 1) // 2] or 0
end

-- Scatter of the force about the mean of its neighbours, N.
local function scatter(F)
  local sizes = {}
  for i = 2, #F - 1 do sizes[#sizes + 1] = math.abs(F[i] - (F[i - 1] + F[i + 1]) / 2) end
  return 1.4826 * median(sizes) / math.sqrt(1.5)
end

-- Sudden falls of the force while the grips move apart, after which it rises beyond what it was. A fall is at least a twentieth of the largest force
-- so far, within `span` rows.
local least, span = 0.05, 3
local function slips(u, F, last)
  local out, noise, row = {}, scatter(F), 1
  while row < last do
    local bottom
    for k = row + 1, math.min(row + span, last) do
      if F[k] > F[row] then break end -- the fall begins at a later row
      if u[k] > u[k - 1] and F[row] - F[k] > math.max(least * F[row], 8 * noise) and F[row] > 10 * noise and F[k] < F[bottom or row] then bottom = k end
    end
    local back = false
    for k = (bottom or last) + 1, last do back = back or F[k] > F[row] end
    if bottom and back then out[#out + 1] = { row = row, share = (F[row] - F[bottom]) / F[row] } end
    row = bottom or row + 1
  end
  return out
end

-- The displacement over which nothing was pulled: the force stays within its noise, or within 0.2 % of the peak, and does not rise.
local function idle(u, F, peak, last)
  local noise, row = scatter(F), 1
  local limit = math.max(4 * noise, 2e-3 * peak)
  while row < last and math.abs(F[row + 1] - F[1]) <= limit do row = row + 1 end
  if row < 3 then return end
  return row, (u[row] - u[1]) / (u[last] - u[1])
end

-- The signs in a pull, each {code, text, row}. last: the row of failure, or of the largest force.
function signs.of(u, F, last, t)
  local out = {}
  local found = slips(u, F, last)
  if #found > 0 then
    local most = found[1]
    for _, slip in ipairs(found) do most = slip.share > most.share and slip or most end
    out[1] = { code = "slip", row = most.row, text = ("the force falls suddenly %d time%s and recovers, by %.0f %% at most (row %d, %.4g mm): slip in the jaws, "
      .. "or yarns that break one by one"):format(#found, #found == 1 and "" or "s", 100 * most.share, most.row, 1e3 * u[most.row]) }
  end
  local row, share = idle(u, F, F[last], last)
  if row and share > 0.1 and share < 1 and t.slack == "none" then
    out[#out + 1] = { code = "late-grip", row = row, text = ("nothing pulls before %.4g mm, %.0f %% of the way: was the specimen slack, or gripped late? "
      .. "slack='contact' counts from there, and so does find_slack of fabric.lab.fit"):format(1e3 * u[row], 100 * share) }
  end
  return out
end

return signs
