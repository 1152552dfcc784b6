-- Yarns cycled to failure at several lengths [picciotto1970]: the cycles at each length from the yarns of the other lengths, with a band for one more yarn.
--
--   fabricsh scripts/lab/real/yarn_lengths.lua [file]
--
-- The file has the columns inches and kilocycles. It is not part of the program: the default is ../shared/data/yarn-strength beside this checkout, or the deck
-- says SKIPPED.
local fabric = require "fabric"
local lab = fabric.lab

local path = arg[1] or (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/yarn-strength/picciotto1970_yarn_fatigue.csv"
local file = io.open(path)
if not file then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
file:close()
if fabric.checking() then return end

-- ln cycles of the yarns of each length, and their mean.
local lengths, yarns = {}, {}
local records = fabric.table { file = path, lenient = true }
for i, inches in ipairs(records[1].values) do
  if not yarns[inches] then lengths[#lengths + 1], yarns[inches] = inches, {} end
  table.insert(yarns[inches], math.log(records[2].values[i]))
end
table.sort(lengths)
if #lengths < 4 then error(("yarn_lengths: %s: expected yarns of four lengths at least, got %d"):format(path, #lengths), 0) end
local mean = {}
for inches, list in pairs(yarns) do
  local sum = 0
  for _, y in ipairs(list) do sum = sum + y end
  mean[inches] = sum / #list
end

-- A line through the means over ln length: its value at a length, its slope, and half the 95 % band of the mean of a further length.
local function line_through(others, inches)
  local n, x, y, xx, xy = #others, 0, 0, 0, 0
  for _, l in ipairs(others) do x, y = x + math.log(l) / n, y + mean[l] / n end
  for _, l in ipairs(others) do xx, xy = xx + (math.log(l) - x) ^ 2, xy + (math.log(l) - x) * (mean[l] - y) end
  local slope, squares = xy / xx, 0
  for _, l in ipairs(others) do squares = squares + (mean[l] - y - slope * (math.log(l) - x)) ^ 2 end
  local off = math.log(inches) - x
  return y + slope * off, slope, lab.student(0.975, n - 2) * math.sqrt(squares / (n - 2) * (1 + 1 / n + off ^ 2 / xx))
end

-- How yarns of one length lie about their mean: 2.5 and 97.5 % of all yarns of the other lengths. No distribution is assumed.
local function within(others)
  local all = {}
  for _, l in ipairs(others) do
    for _, y in ipairs(yarns[l]) do all[#all + 1] = y - mean[l] end
  end
  table.sort(all)
  return all[math.max(1, math.floor(0.025 * #all))], all[math.ceil(0.975 * #all)]
end

local inside, total = 0, 0
for i, inches in ipairs(lengths) do
  local others = table.move(lengths, 1, #lengths, 1, {})
  table.remove(others, i)
  local centre, slope, half = line_through(others, inches)
  local low, high = within(others)
  low, high = centre - math.sqrt(half ^ 2 + low ^ 2), centre + math.sqrt(half ^ 2 + high ^ 2)
  local own = 0
  for _, y in ipairs(yarns[inches]) do own = own + (y >= low and y <= high and 1 or 0) end
  inside, total = inside + own, total + #yarns[inches]
  print(("%g inches from the others: mean %.3g kilocycles, %.3g measured; %d of %d yarns in %.3g to %.3g; cycles go with length^%.2f"):format(inches, math.exp(centre),
    math.exp(mean[inches]), own, #yarns[inches], math.exp(low), math.exp(high), slope))
end
print(("all: %d of %d yarns (%.1f %%) lie in the band of the other lengths"):format(inside, total, 100 * inside / total))
fabric.expect { { "share of yarns in the 95 % band of the other lengths", inside / total, 0.95, absolute = 0.05 } }
