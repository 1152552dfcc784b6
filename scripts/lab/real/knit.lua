-- Two knits, five pulls each, the force read off a display by photograph, four pins tracked (sabetta/stitch-by-stitch, MIT): readings that stand
-- alone left out, the ratio of the pins, how specimens differ, and how well four of them tell where the fifth lies.
--
--   fabricsh scripts/lab/real/knit.lua [out] [folder] [knit ...]      a knit: the part of the names before _video1.csv; default: all in the folder
--
-- NAME_videoN.csv is a pull: force, extension (N and mm, where the headings say nothing else), and the distances of the pins, `pin width` and
-- `pin length`; NAME.dim holds the first length and width in mm. Without it the first distances of the pins take their place, which is told. The
-- records are not part of the program: the default is ../shared/data/knit-pulls beside this checkout, or the deck says SKIPPED.
-- warns: slip in the jaws, or yarns that break one by one
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units

local place = arg[2] or (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/knit-pulls"
local out = arg[1] or "out/knit"
if not arg[2] and not io.open(place .. "/Acrylic_Yarn_Garter_X.dim") then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
if fabric.checking() then return end

-- The pulls of each knit, in the order of their numbers.
local knits, pulls, wanted = {}, {}, {}
for i = 3, #arg do wanted[arg[i]] = true end
for _, file in ipairs(fabric.folder(place)) do
  local name, number = file:match "^(.+)_video(%d+)%.csv$"
  if name and (#arg < 3 or wanted[name]) then
    if not pulls[name] then knits[#knits + 1], pulls[name] = name, {} end
    table.insert(pulls[name], { file = place .. "/" .. file, number = tonumber(number) })
  end
end
for i = 3, #arg do
  if not pulls[arg[i]] then error(("knit: expected files %s_video1.csv ... in %s, there are none"):format(arg[i], place), 0) end
end
if #knits == 0 then error("knit: expected files NAME_video1.csv ... in " .. place .. ", there are none", 0) end
for _, list in pairs(pulls) do
  table.sort(list, function(a, b) return a.number < b.number end)
end

-- Distances of the pins in m, by their headings; nil where a file has none. The pins stand at the tips of a diamond.
local function pins(file)
  local distances = {}
  for _, column in ipairs(fabric.table { file = file, lenient = true }) do
    local which = column.name:lower():match "pin%s*_?(%a+)"
    if which == "width" or which == "length" then
      local unit = column.unit == "" and "mm" or column.unit
      if not u[unit] then error(("%s: column '%s': expected a unit of length, got '%s'"):format(file, column.name, unit), 0) end
      distances[which] = {}
      for i, x in ipairs(column.values) do distances[which][i] = x * u[unit] end
    end
  end
  if not (distances.width and distances.length) then return nil end
  local grid = { rows = 2, columns = 2, x = {}, y = {}, file = file, width = distances.width[1], length = distances.length[1] }
  for i = 1, #distances.width, math.max(1, math.min(20, #distances.width // 50)) do
    local w, l = distances.width[i] / 2, distances.length[i] / 2
    if w > 0 and l > 0 then -- not a number, or zero, where a pin was lost
      for k, pin in ipairs { { 0, -l }, { -w, 0 }, { w, 0 }, { 0, l } } do
        local n = #grid.x + 1
        grid.x[n], grid.y[n] = pin[1], pin[2]
      end
    end
  end
  return #grid.x >= 12 and grid or nil
end

-- Length and width (m) before the pull.
local function size_of(name, grid)
  local file = io.open(place .. "/" .. name .. ".dim")
  if not file then
    if not grid then error(("knit: %s: expected %s.dim with length and width in mm, or columns of the pins' distances"):format(place, name), 0) end
    print(("%s: no %s.dim: the first distances of the pins stand for length and width, %.1f and %.1f mm"):format(name, name, grid.length / u.mm, grid.width / u.mm))
    return grid.length, grid.width
  end
  local words = file:read("a"):gsub("(%d),(%d)", "%1.%2")
  file:close()
  local length, width = words:match "([%d.]+)%s*[;,%s]%s*([%d.]+)"
  length, width = tonumber(length), tonumber(width)
  if not (length and width and length > 0 and width > 0) then
    error(("knit: %s/%s.dim: expected two numbers, length and width in mm, got '%s'"):format(place, name, words), 0)
  end
  return length * u.mm, width * u.mm
end

-- A specimen's stress (MPa) in 20 equal steps of strain, as a test for fabric.lab.pool: the mean of the rows about the middle of each step, and how far
-- they scatter about a line through them; between points where a step has fewer than three rows.
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
    local groups, E, S = {}, {}, {}
    for k = 1, steps do groups[k] = { n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0 } end
    for _, branch in ipairs(test.branches) do
      for row = branch.first, branch.kind == "loading" and math.min(branch.last, test.failure or branch.last) or 0 do
        E[#E + 1], S[#S + 1] = test.E[row], test.S[row] / u.MPa
        local g = groups[math.ceil(test.E[row] / reach * steps)]
        if g then
          local x, y = test.E[row] / reach * steps % 1 - 0.5, test.S[row] / u.MPa
          g.n, g.x, g.y, g.xx, g.xy, g.yy = g.n + 1, g.x + x, g.y + y, g.xx + x * x, g.xy + x * y, g.yy + y * y
        end
      end
    end
    local line = fabric.columns({ E = E, S = S })
    list[i] = { name = "pull " .. i, pull = i, measured = {}, noise = {}, predict = predict }
    for k, g in ipairs(groups) do
      if g.n >= 3 then
        local xx, xy, yy = g.xx - g.x ^ 2 / g.n, g.xy - g.x * g.y / g.n, g.yy - g.y ^ 2 / g.n
        local slope = xx > 0 and xy / xx or 0
        list[i].measured[k] = g.y / g.n - slope * g.x / g.n -- at the middle of the step
        list[i].noise[k] = math.sqrt(math.max(0, yy - slope * xy) / (g.n - 2)) + 2e-4
      else
        list[i].measured[k], list[i].noise[k] = line:interpolate("S", "E", (k - 0.5) / steps * reach), 2e-3
      end
    end
  end
  for i, name in ipairs { "a", "b", "c", "d" } do parameters[i] = { name = name, start = 0.1, low = -5, high = 5 } end
  return lab.pool { parameters = parameters, tests = list, groups = { "pull" }, processes = 1 }
end

local rows, coverage, held, several = {}, 0, 0, 0
for _, name in ipairs(knits) do
  local tests, grids, length, width = {}, {}, nil, nil
  for i, pull in ipairs(pulls[name]) do
    local grid = pins(pull.file)
    if not length then length, width = size_of(name, grid) end
    local headings = fabric.table({ file = pull.file, lenient = true }).header
    tests[i] = lab.tensile { file = pull.file, columns = not headings and { displacement = 2, force = 3 } or nil,
      default_units = { displacement = "mm", force = "N" }, gauge_length = length, width = width, thickness = 1 * u.mm, plies = 1, outliers = "drop",
      pretension = 0.5 }
    print(("%s, pull %d: %d of %d readings of the force stood alone and were left out%s"):format(name, pull.number, #(tests[i].outliers or {}),
      #tests[i].E + #(tests[i].outliers or {}), grid and "" or "; no pins"))
    grids[#grids + 1] = grid
  end
  local fit = lab.fit { tests = tests, find_slack = "either" }
  print(fit.text)
  local ratio = #grids > 0 and lab.poisson { specimens = grids } or nil
  if ratio then
    print(("%s: ratio of the pins %.3f, %s"):format(name, ratio.value, #grids > 1 and ratio.low and ("%.3f to %.3f"):format(ratio.low, ratio.high) or "one specimen"))
  end
  local card = lab.card { name = name, source = "sabetta/stitch-by-stitch", density = 300, thickness = 1 * u.mm, warp = fit, poisson = { warp = ratio },
    assume = { thickness = true, density = true } }
  local measured = tests[1]
  if #tests >= 3 then
    local spread = lab.spread { tests = tests }
    print(name .. ": " .. spread.text)
    measured = { E = spread.E, S = spread.S }
    local pool = pooled(tests, spread.reach)
    print(name .. ": one curve for all (fabric.lab.pool):\n" .. pool.text)
    several, held, coverage = several + 1, held + pool.coverage, coverage + spread.coverage
  else
    print(("%s: %d pull%s: how specimens differ takes three and more"):format(name, #tests, #tests == 1 and "" or "s"))
  end
  local c = lab.compare(measured, { E = measured.E, S = fabric.point(card):uniaxial("warp", measured.E, { "S" }).S },
    { file = ("%s/%s.svg"):format(out, name), label = (name:gsub("_", " ")) })
  print(("%s: card beside %s: %s"):format(name, #tests >= 3 and "the mean of the specimens" or "the first of them", c.text))
  card:write(("%s/%s.lua"):format(out, name))
  print(card)
  rows[#rows + 1] = { name .. ": card beside the measured curve, rms over the peak", c.rms, 0, absolute = #tests >= 3 and 0.05 or 0.1 }
end
-- Points of a specimen hang together. Of made families of five specimens nine in ten lie between 0.81 and 1, of pairs of them between 0.83 and 1
-- (scripts/long/lab_next_specimen.lua); the more knits, the nearer to 0.95.
if several > 0 then
  local allowed = 0.14 / math.sqrt(several)
  rows[#rows + 1] = { "points of specimens left out, in the band of the others", coverage / several, 0.95, absolute = allowed }
  rows[#rows + 1] = { "the same, of one curve for all with the specimens' own factors", held / several, 0.95, absolute = allowed }
end
fabric.expect(rows)
