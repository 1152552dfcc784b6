-- Two knits, five pulls each, the force read off a display by photograph, four pins tracked (sabetta/stitch-by-stitch, MIT): readings that stand
-- alone left out, the ratio of the pins, how specimens differ, and how well four of them tell where the fifth lies.
--
--   fabricsh scripts/lab/real/knit.lua [out]
--
-- The records are not part of the program: they lie in ../shared/data beside this checkout, or the deck says SKIPPED.
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units

local place = (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/knit-pulls/"
local out = arg[1] or "out/knit"
local knits = { "Acrylic_Yarn_Garter_X", "Pearlized_Cotton_Garter_X" }
if not io.open(place .. knits[1] .. ".dim") then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
if fabric.checking() then return end

-- The pins stand at the tips of a diamond; their distances are what was tracked.
local function pins(file)
  local t = fabric.table { file = file }
  local width, length = t[4].values, t[5].values
  local grid = { rows = 2, columns = 2, x = {}, y = {}, file = file }
  for i = 1, #width, 20 do
    local w, l = width[i] / 2, length[i] / 2
    for k, pin in ipairs { { 0, -l }, { -w, 0 }, { w, 0 }, { 0, l } } do
      local n = #grid.x + 1
      grid.x[n], grid.y[n] = pin[1], pin[2]
    end
  end
  return grid
end

-- A specimen's stress (MPa) in 20 equal steps of strain, as a test for fabric.lab.pool: means, and how far their rows scatter about them.
local steps = 20
local function pooled(tests, reach)
  local function predict(p)
    local y = {}
    for k = 1, steps do
      local x = (k - 0.5) / steps
      y[k] = p.a * x + p.b * x ^ 2 + p.c * x ^ 3 + p.d * x ^ 4
    end
    return y
  end
  local list, parameters = {}, {}
  for i, test in ipairs(tests) do
    local sum, squares, count = {}, {}, {}
    for k = 1, steps do sum[k], squares[k], count[k] = 0, 0, 0 end
    for _, branch in ipairs(test.branches) do
      for row = branch.first, branch.kind == "loading" and math.min(branch.last, test.failure or branch.last) or 0 do
        local k = math.ceil(test.E[row] / reach * steps)
        if k >= 1 and k <= steps then
          local S = test.S[row] / u.MPa
          sum[k], squares[k], count[k] = sum[k] + S, squares[k] + S ^ 2, count[k] + 1
        end
      end
    end
    list[i] = { name = "pull " .. i, measured = {}, noise = {}, predict = predict }
    for k = 1, steps do
      local mean = sum[k] / count[k]
      list[i].measured[k], list[i].noise[k] = mean, math.sqrt(math.max(0, squares[k] / count[k] - mean ^ 2)) / 2 + 2e-4
    end
  end
  for i, name in ipairs { "a", "b", "c", "d" } do parameters[i] = { name = name, start = 0.1, low = -5, high = 5 } end
  return lab.pool { parameters = parameters, tests = list, processes = 1 }
end

local rows, coverage, held = {}, 0, 0
for _, name in ipairs(knits) do
  local length, width = io.open(place .. name .. ".dim"):read("n", "n")
  local tests, grids = {}, {}
  for i = 1, 5 do
    local file = place .. name .. "_video" .. i .. ".csv"
    tests[i] = lab.tensile { file = file, gauge_length = length * u.mm, width = width * u.mm, thickness = 1 * u.mm, plies = 1, outliers = "drop", pretension = 0.5 }
    print(("%s, pull %d: %d of %d readings of the force stood alone and were left out"):format(name, i, #(tests[i].outliers or {}),
      #tests[i].E + #(tests[i].outliers or {})))
    grids[i] = pins(file)
  end
  local spread, ratio = lab.spread { tests = tests }, lab.poisson { specimens = grids }
  print(name .. ": " .. spread.text)
  local pool = pooled(tests, spread.reach)
  print(name .. ": one curve for all (fabric.lab.pool):\n" .. pool.text)
  held = held + pool.coverage / #knits
  print(("%s: ratio of the pins %.3f, %.3f to %.3f"):format(name, ratio.value, ratio.low, ratio.high))
  local fit = lab.fit { tests = tests, find_slack = "either" }
  print(fit.text)
  local card = lab.card { name = name, source = "sabetta/stitch-by-stitch", density = 300, thickness = 1 * u.mm, warp = fit, poisson = { warp = ratio },
    assume = { thickness = true, density = true } }
  local E, S = {}, {}
  for i, e in ipairs(spread.E) do E[i], S[i] = e, spread.S[i] end
  local c = lab.compare({ E = E, S = S }, { E = E, S = fabric.point(card):uniaxial("warp", E, { "S" }).S },
    { file = ("%s/%s.svg"):format(out, name), title = (name:gsub("_", " ")) })
  print(name .. ": card beside the mean of the specimens: " .. c.text)
  card:write(("%s/%s.lua"):format(out, name))
  print(card)
  coverage = coverage + spread.coverage / #knits
  rows[#rows + 1] = { name .. ": card beside the mean, rms over the peak", c.rms, 0, absolute = 0.05 }
end
rows[#rows + 1] = { "points of specimens left out, in the band of the others", coverage, 0.94, absolute = 0.04 }
-- Points of a specimen hang together: of ten specimens in bands of 95 % none may be outside as well as one.
rows[#rows + 1] = { "the same, of one curve for all with the specimens' own factors", held, 0.95, absolute = 0.05 }
fabric.expect(rows)
