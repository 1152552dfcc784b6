-- The drape coefficient of a card as an interval over what the card assumes: its numbers that nobody measured are drawn from their ranges (share/doc/budget.md),
-- each disc with an irregularity and an orientation of its own, by relaxation, without contact.
--
--   fabricsh scripts/lab/drape_interval.lua                              worsted, 8 samples, 3 elements over the overhang: seconds
--   fabricsh scripts/lab/drape_interval.lua "broad nylon" 16 5           these cards, 16 samples (two discs each), five elements
--   fabricsh scripts/long/drape_interval.lua                             every card but wool, and the table of share/doc/drape.md
--
-- A card whose coefficient was measured on a JIS disc [matsudaira2015] has a second row, for that disc, with the measured one, and lines on what makes its width:
-- the coefficients of one disc with each assumption at the ends of its range, alone, and the test that would determine it.
-- warns: carries without folding within it
-- warns: the steps are long: in two halves they end
-- warns: relaxation has taken
-- warns: turned inside out
-- warns: is turned over: it is more than 90 degrees
-- warns: hangs where the pedestal is
local fabric = require "fabric"
local assumed, tests_for = require "fabric.assumed", require "fabric.lab.card.tests_for"
local which, samples, cells, write = arg[1] or "worsted", tonumber(arg[2] or 8), tonumber(arg[3] or 3), arg[4] == "write"
local root = arg[0]:gsub("[^/]*$", "") .. "../../"
local measured = { broad = 82.9, tropical = 50.7 }
local fine = { nylon = true, tarpaulin = true } -- whose yarns lock a coarse mesh: eight elements, where the others have five
local slow = { wool = true } -- tens of thousands of iterations a disc

local names = {}
for word in which:gmatch "%S+" do
  if word ~= "all" then names[#names + 1] = word end
  for _, name in ipairs(word == "all" and fabric.cards() or {}) do
    if not slow[name] then names[#names + 1] = name end
  end
end

-- The thesis' four have no bending of their own but an estimate.
local function card_of(name)
  local card = fabric.card(name)
  return card.bending and card or fabric.card(name, { bending = "estimated" })
end

-- The coefficient in % of a disc with the given diameters (m), elements over the overhang and irregularity.
local function coefficient_of(card, disc, support, elements, seed)
  local test = { card = card, disc = disc, support = support, cells = elements, seed = seed, by = "relaxation", contact = false }
  local done, r = pcall(fabric.lab.cusick, test)
  if not done then -- the motion is slower, and goes on where relaxation finds no way
    test.by = "motion"
    r = fabric.lab.cusick(test)
  end
  return 100 * r.coefficient
end

-- The effect of each assumption alone, at the ends of its range; those that change the coefficient by two points and more, the largest first.
local function alone(name, disc, support, elements)
  local card, list = card_of(name), {}
  for _, input in ipairs(assumed.of(card)) do
    local low, high = coefficient_of(input.apply(card, input[1]), disc, support, elements, 1), coefficient_of(input.apply(card, input[2]), disc, support, elements, 1)
    if math.abs(high - low) >= 2 then list[#list + 1] = { math.abs(high - low), ("%s: %s alone, %.3g to %.3g, makes %.0f to %.0f %%: %s would tell"):format(name, input.name, input[1], input[2],
      math.min(low, high), math.max(low, high), tests_for[input.name] or "a test of it") } end
  end
  table.sort(list, function(a, b) return a[1] > b[1] end)
  for _, row in ipairs(list) do print(row[2]) end
end

-- The interval in %, of discs with the given diameters (m) and elements over the overhang.
local function interval_of(name, disc, support, elements)
  local b = fabric.budget { card = card_of(name), samples = samples, shares = false, print = false, run = function(p)
    return { coefficient = coefficient_of(p.card, disc, support, elements, p.specimen) }
  end }
  return b, b.band.coefficient
end

local rows, expected = {}, {}
local function add(name, disc, support, elements, words)
  local b, band = interval_of(name, disc, support, elements)
  if fabric.checking() then return end
  local low, high = math.max(band.low, 0), math.min(band.high, 100)
  rows[#rows + 1] = { name = name, low = low, high = high,
    text = ("| %s | %s | %.0f to %.0f | %.0f | %d | %s |"):format(name, words, low, high, b.value.coefficient, elements, measured[name] and disc < 0.3 and
      ("%.1f, %s"):format(measured[name], low <= measured[name] and measured[name] <= high and "inside"
        or ("outside by %.1f points"):format(math.max(low - measured[name], measured[name] - high))) or "") }
  print(rows[#rows].text)
  expected[#expected + 1] = { name .. ", " .. words .. ": the card as it is lies in the interval (1: yes)", band.low - 1e-9 <= b.value.coefficient and b.value.coefficient <= band.high + 1e-9 and 1 or 0, 1, absolute = 0 }
end
for _, name in ipairs(names) do
  local elements = fine[name] and math.max(cells, cells == 5 and 8 or cells) or cells
  add(name, 0.3, 0.18, elements, "300")
  if measured[name] then
    add(name, 0.254, 0.127, cells == 5 and 8 or cells, "254")
    if not fabric.checking() then alone(name, 0.254, 0.127, cells) end
  end
end
if fabric.checking() then return end

table.sort(rows, function(a, b) return a.low + a.high < b.low + b.high end)
local lines = { "| card | disc mm | 95 % interval, % | as it is, % | elements | measured, % |", "|---|---|---|---|---|---|" }
for _, row in ipairs(rows) do lines[#lines + 1] = row.text end
local text = table.concat(lines, "\n")
if write then
  local path = root .. "share/doc/drape.md"
  local file = assert(io.open(path))
  local page = file:read "a"
  file:close()
  local before, after = page:match "^(.*\n<!%-%- written by scripts/long/drape_interval.lua %-%->\n).-(\n<!%-%- end of the intervals %-%->.*)$"
  fabric.write(path, before .. "\n" .. text .. "\n" .. after)
end
fabric.expect(expected)
