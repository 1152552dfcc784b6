-- Plain-weave glass/PP of two specimen sizes and two laboratories, bias extension without markers [cao2008]: the shear curve from all sizes together,
-- what the others say of each, and a card.
--
--   fabricsh scripts/lab/real/glass.lua [out] [file or folder ...]
--
-- Each file is displacement and force of one size (mm and N, where its headings say nothing else; without headings the first two columns), and its
-- name says which: ...150x450....csv is 150 mm wide and 450 mm long, ...150x450-NAME.csv of the laboratory NAME. A folder gives its files with such a name, but not those of rate.lua, which say
-- their speed. The records are not part of the program: the default is ../shared/data beside this checkout, or the deck says SKIPPED.
local fabric = require "fabric"
local lab, mm = fabric.lab, fabric.units.mm

local default = (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/cao-2008"
local out = arg[1] or "out/glass"
local given = #arg > 1 and table.move(arg, 2, #arg, 1, {}) or { default }
if #arg < 2 and not io.open(default .. "/bias-extension-150x450.csv") then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
if fabric.checking() then return end

local sizes, named = {}, false -- named: a laboratory stands in a file's name; a file without one counts as of a laboratory of its own
local function add(path)
  local width, length = path:match "(%d+%.?%d*)x(%d+%.?%d*)[^/]*$"
  if not width then error(path .. ": expected the size in the file's name, such as 150x450 (width and length in mm)", 0) end
  width, length = tonumber(width), tonumber(length)
  if length < 2 * width then
    error(("%s: expected a length of at least twice the width, since the middle zone is clamped otherwise, got %g x %g mm"):format(path, width, length), 0)
  end
  local stem = path:match "([^/]*)%.%w+$"
  local laboratory = path:match "%d+%.?%d*x%d+%.?%d*%-(%a[%w%-]*)%.%w+$"
  named = named or laboratory ~= nil
  sizes[#sizes + 1] = { name = ("%g x %g mm"):format(width, length), path = path, laboratory = laboratory or "that of " .. stem, stem = stem, width = width * mm, length = length * mm }
end
for _, path in ipairs(given) do
  local is_folder, names = pcall(fabric.folder, path)
  if not is_folder then
    add(path)
  else
    for _, name in ipairs(names) do
      if name:match "%d+x%d+.*%.%w+$" and name:match "%.[ctd][sxa][vt]$" and not name:match "mm%-min" then add(path .. "/" .. name) end
    end
  end
end
if #sizes == 0 then error("glass: expected files with their size in the name (150x450), there are none in " .. table.concat(given, ", "), 0) end
local times = {}
for _, size in ipairs(sizes) do -- two files of one size are told apart by their names
  times[size.name] = (times[size.name] or 0) + 1
end
for _, size in ipairs(sizes) do
  if times[size.name] > 1 then size.name = size.name .. ", " .. size.stem end
end

-- In the legend of the figure: size and laboratory, and a number where several are of one size and laboratory.
local same = {}
for _, size in ipairs(sizes) do
  local own = size.laboratory:match "^that of " and "" or ", " .. size.laboratory
  size.label = ("%g × %g mm%s"):format(size.width / mm, size.length / mm, own)
  same[size.label] = (same[size.label] or 0) + 1
  if same[size.label] > 1 then size.label = ("%s, no. %d"):format(size.label, same[size.label]) end
end

local thickness = 1 * mm -- assumed: the shear force per width is what the test shows

-- N over the angle, up to the limit, as a test for the fit.
for _, size in ipairs(sizes) do
  local headings = fabric.table({ file = size.path, lenient = true }).header
  size.record = lab.read { file = size.path, columns = not headings and { displacement = 1, force = 2 } or nil,
    default_units = { displacement = "mm", force = "N" } }
  size.shear = lab.bias_shear { displacement = size.record.displacement, force = size.record.force, width = size.width, length = size.length,
    thickness = thickness, cut = true }
  size.test = { E = size.shear.E12, S = size.shear.S12, branches = { { kind = "loading", first = 1, last = #size.shear.E12 } } }
  print(("%s: %d rows of %s, %d of them to %.0f degrees"):format(size.name, size.record.rows, size.path:match "[^/]*$", #size.shear.rows,
    size.shear.angle[#size.shear.angle]))
end

local function card_of(tests)
  local shear = lab.fit { tests = tests, degree = "monotone" }
  local yarn = { loading = { 50e6 }, unloading = 60e6 }
  return lab.card { name = "glass", source = "Cao et al. 2008, plain-weave glass/PP", density = 1000, thickness = thickness, warp = yarn, weft = yarn,
    shear = shear, poisson = { warp = 0, weft = 0 }, assume = { ["shear.unloading"] = 20e6, thickness = true, density = true } }, shear.tested
end

-- Measured and predicted force over the displacement, where the card knows the shear.
local function misfit(card, tested, size)
  local reach, d, force = math.deg(math.asin(2 * tested)), {}, {}
  for i, row in ipairs(size.shear.rows) do
    if size.shear.angle[i] <= reach then d[#d + 1], force[#force + 1] = size.record.displacement[row], size.record.force[row] end
  end
  if #d < 2 then return nil end
  local predicted = lab.bias_shear { displacement = d, card = card, width = size.width, length = size.length }
  local c = lab.compare({ displacement = d, force = force }, { displacement = d, force = predicted.force },
    { file = out .. "/" .. size.stem .. ".svg", label = size.stem })
  return c, predicted.force[#d] / force[#d] - 1
end

local rows, tests = {}, {}
for i, size in ipairs(sizes) do tests[i] = size.test end
local all, tested = card_of(tests)
print(#sizes > 1 and ("fitted on all %d:"):format(#sizes) or "fitted on the only one, no other size to predict:")
for i, size in ipairs(sizes) do
  local c, at_end = misfit(all, tested, size)
  print(("  %s: %s; at the end %+.1f %%"):format(size.name, c.text, 100 * at_end))
  rows[#rows + 1] = { size.name .. ": rms over the peak, fitted on all", c.rms, 0, absolute = 0.1 }
  if #sizes > 1 then
    local others = table.move(tests, 1, #tests, 1, {})
    table.remove(others, i)
    local other, reach = card_of(others)
    local held, end_held = misfit(other, reach, size)
    if held then
      print(("  left out, predicted from the others: %s; at the end %+.1f %%"):format(held.text, 100 * end_held))
      rows[#rows + 1] = { size.name .. ": rms over the peak, left out", held.rms, 0, absolute = 0.15 }
    else
      print "  left out: the others were not sheared as far as its first rows, no prediction"
    end
  end
end
-- At equal angles the laboratories differ by this, which no single curve can fit: slip of the edge yarns, and the laboratories.
local first = sizes[1].shear
for k = 2, #sizes do
  local other, sum, n = sizes[k].shear, 0, 0
  for i, angle in ipairs(first.angle) do
    for j = 2, angle > 10 and #other.angle or 0 do
      local a, b = other.angle[j - 1], other.angle[j]
      if a <= angle and angle < b then
        local N = other.normal_force[j - 1] + (other.normal_force[j] - other.normal_force[j - 1]) * (angle - a) / (b - a)
        sum, n = sum + (N / first.normal_force[i] - 1), n + 1
      end
    end
  end
  if n > 0 then
    print(("between sizes: from 10 to 30 degrees the shear force of %s is %+.1f %% of that of %s on the mean (slip of edge yarns, pull-out, laboratories)"):format(
      sizes[k].name, 100 * sum / n, sizes[1].name))
  else
    print(("between sizes: %s and %s have no angle above 10 degrees in common"):format(sizes[k].name, sizes[1].name))
  end
end
if #sizes > 1 then
  local specimens = {}
  for i, size in ipairs(sizes) do
    specimens[i] = { name = size.name, displacement = size.record.displacement, force = size.record.force, width = size.width, length = size.length,
      laboratory = named and size.laboratory or nil }
  end
  local b = lab.bias_sizes { specimens = specimens, thickness = thickness }
  print(b.text)
  local curves = {}
  for _, size in ipairs(sizes) do -- as a further specimen of its size in another laboratory
    local d, F = {}, {}
    for k, row in ipairs(size.shear.rows) do d[k], F[k] = size.record.displacement[row], size.record.force[row] end
    local p = b:predict { displacement = d, width = size.width, length = size.length }
    curves[#curves + 1] = { x = p.angle, y = p.force, label = size.label .. (p.band and ", predicted, 95 % band" or ", predicted"), style = #curves > 0 and "dashed" or "line", band = p.band and { low = p.low, high = p.high } or nil }
    curves[#curves + 1] = { x = p.angle, y = F, label = size.label .. ", measured", style = "points" }
  end
  fabric.plot { file = out .. "/sizes.svg", xlabel = "shear angle, °", ylabel = "force, N", curves = curves }
end
all:write(out .. "/card.lua")
print(all)
fabric.expect(rows)
