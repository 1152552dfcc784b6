-- The report of a characterisation: no band without width, digits by the band, the residual of the whole loop; and the budget's figure with its sources and intervals.
local fabric = require "fabric"
local lab = fabric.lab
local report = require "fabric.lab.report"
local out = os.tmpname()
os.remove(out)

local function pulled(n, back)
  local tests = {}
  for i = 1, n do
    local r, draw = { displacement = {}, force = {} }, require "fabric.lab.random"(i)
    for k = 0, 60 do
      local E = 0.1 * k / 60
      r.displacement[k + 1], r.force[k + 1] = 0.1 * (math.sqrt(1 + 2 * E) - 1), (1 + 0.02 * i) * 8e-6 * (2e7 * E + 3e8 * E * E) + 0.01 * draw.normal()
    end
    local top, u = r.force[61], r.displacement[61]
    for k = 1, back and 20 or 0 do r.displacement[61 + k], r.force[61 + k] = u - 1e-4 * k, top * (1 - k / 25) end
    tests[i] = lab.tensile { record = r, gauge_length = 0.1, width = 0.02, thickness = 4e-4, plies = 1 }
  end
  return { tests = tests, fit = lab.fit { tests = tests, find_slack = "either" }, spread = n > 2 and lab.spread { tests = tests } or nil }
end
local function rows_of(n, back)
  local part = pulled(n, back)
  local result = { about = { name = "made", gauge_length = 0.1, width = 0.02, thickness = 4e-4 }, warp = part, further = {}, missed = {}, seen = {} }
  result.card = lab.card { name = "made", density = 500, thickness = 4e-4, warp = part.fit, assume = true }
  local figures, rows = report.write(result, out)
  return rows, figures
end

local rows, figures = rows_of(3, true)
local seen = 0
for _, row in ipairs(rows) do
  local low, high = row[3]:match "^(%S+) to (%S+)$"
  if low then
    seen = seen + 1
    assert(tonumber(low) < tonumber(high) and tonumber(low) <= tonumber(row[2]) and tonumber(row[2]) <= tonumber(high), row[1] .. ": " .. row[3])
  end
  assert(not row[2]:find "e%+", row[2])
end
assert(seen >= 3, seen)
-- the band of the others beside the specimen that was left out
if #figures.warp.files > 0 then
  local text = ""
  for _, file in ipairs(figures.warp.files) do
    local f <close> = assert(io.open(file))
    if file:find "left%-out" then text = f:read "a" end
  end
  assert(text:find("left out", 1, true) and text:find("95 % of the next specimens, by the other 2", 1, true), text)
end
assert(figures.warp.whole and figures.warp.whole > 0 and figures.warp.whole < 0.2)
rows, figures = rows_of(1, false)
assert(not figures.warp.whole)
for _, row in ipairs(rows) do
  if row[1] == "warp unloading" then assert(row[3] == "" and #row[2]:gsub("0+$", ""):gsub("%D", "") <= 2, row[2] .. " " .. row[3]) end -- assumed by rule: no band, two digits
  if row[1] == "warp d0" then assert(row[3] ~= "" and row[5]:find "is a guess, one does not show it", row[5]) end
end
