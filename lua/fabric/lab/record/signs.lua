-- Signs in a single record that the specimen was not held as it should be: slip in the jaws, a late grip. They are reported, not corrected.
local lists = require "fabric.lists"
local signs = {}

-- Scatter of the force about the mean of its neighbours, N.
local function scatter(F)
  local sizes = {}
  for i = 2, #F - 1 do sizes[#sizes + 1] = math.abs(F[i] - (F[i - 1] + F[i + 1]) / 2) end
  return 1.4826 * (lists.median(sizes) or 0) / math.sqrt(1.5)
end

signs.scatter = scatter

-- Sudden falls of the force while the grips move apart, after which it rises beyond what it was. A fall is at least a twentieth of the largest force
-- so far, within `span` rows.
local least, span = 0.05, 3
local floor = 0.02 -- of the peak; a fall from less is no slip of cloth that is pulled
local function slips(u, F, last)
  local out, noise, row = {}, scatter(F), 1
  local threshold = math.max(10 * noise, floor * F[last])
  while row < last do
    local bottom
    for k = row + 1, math.min(row + span, last) do
      if F[k] > F[row] then break end -- the fall begins at a later row
      if u[k] > u[k - 1] and F[row] - F[k] > math.max(least * F[row], 8 * noise) and F[row] > threshold and F[k] < F[bottom or row] then bottom = k end
    end
    local back
    for k = last, (bottom or last) + 1, -1 do back = F[k] > F[row] and k or back end
    if bottom and back then out[#out + 1] = { row = row, share = (F[row] - F[bottom]) / F[row], way = u[back] - u[row] } end
    row = bottom or row + 1
  end
  return out
end

local function mean(F, first, last)
  local sum = 0
  for i = first, last do sum = sum + F[i] end
  return sum / (last - first + 1)
end

-- Ways over which the force does not rise while the grips move further apart than ever before, and then goes on: the jaws let go slowly. At least a part of
-- the whole way and some rows; the second half is not above the first by half of the noise, which a soft cloth with noise would be.
local least_way, least_rows = 0.03, 4
local function stalls(u, F, last)
  local out, noise, reach, top = {}, scatter(F), u[1], 1
  local threshold = math.max(10 * noise, floor * F[last])
  for k = 2, last do
    if u[k] <= reach then
      top = nil -- a hold or a way back, after which the force is another one
    else
      if not top or F[k] > F[top] then
        local long = top and k - top >= least_rows and u[k] - u[top] > least_way * (u[last] - u[1]) and F[top] > threshold
        local middle = long and (top + k) // 2
        if long and mean(F, middle + 1, k - 1) <= mean(F, top + 1, middle) + noise / 2 then out[#out + 1] = { row = top, way = u[k] - u[top] } end
        top = k
      end
      reach = u[k]
    end
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

-- The signs in a pull, each {code, text, row}; slip has its largest way until the force is back where it was, m. last: the row of failure, or of the largest force.
function signs.of(u, F, last, t)
  local out = {}
  local found = slips(u, F, last)
  if #found > 0 then
    local most = found[1]
    local way = 0
    for _, slip in ipairs(found) do
      most = slip.share > most.share and slip or most
      way = math.max(way, slip.way)
    end
    out[1] = { code = "slip", row = most.row, way = way, text = ("the force falls suddenly %d time%s and recovers, by %.0f %% at most (row %d, %.4g mm): slip in the jaws, "
      .. "or yarns that break one by one"):format(#found, #found == 1 and "" or "s", 100 * most.share, most.row, 1e3 * u[most.row]) }
  end
  local stalled = #found == 0 and stalls(u, F, last) or {}
  if #stalled > 0 then
    local longest = stalled[1]
    for _, stall in ipairs(stalled) do longest = stall.way > longest.way and stall or longest end
    out[1] = { code = "slip", row = longest.row, way = longest.way,
      text = ("the force does not rise over %.4g mm (row %d, %.4g mm), and then goes on: slow slip in the jaws, or yarns that break one by one"):format(1e3 * longest.way, longest.row,
        1e3 * u[longest.row]) }
  end
  local row, share = idle(u, F, F[last], last)
  if row and share > 0.1 and share < 1 and t.slack == "none" then
    out[#out + 1] = { code = "late-grip", row = row, text = ("nothing pulls before %.4g mm, %.0f %% of the way: was the specimen slack, or gripped late? "
      .. "slack='contact' counts from there, and so does find_slack of fabric.lab.fit"):format(1e3 * u[row], 100 * share) }
  end
  return out
end

return signs
