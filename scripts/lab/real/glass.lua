-- Plain-weave glass/PP of two specimen sizes and two laboratories, bias extension without markers [cao2008]: the shear curve from both together,
-- what each says of the other, and a card.
--
--   fabricsh scripts/lab/real/glass.lua [out]
--
-- The records are not part of the program: they lie in ../shared/data beside this checkout, or the deck says SKIPPED.
local fabric = require "fabric"
local lab, mm = fabric.lab, fabric.units.mm

local place = (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/cao-2008/"
local out = arg[1] or "out/glass"
local sizes = {
  { name = "150 x 450 mm", file = "bias-extension-150x450.csv", width = 150 * mm, length = 450 * mm },
  { name = "115 x 230 mm", file = "bias-extension-115x230-INSA.csv", width = 115 * mm, length = 230 * mm },
}
if not io.open(place .. sizes[1].file) then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
if fabric.checking() then return end

local thickness = 1 * mm -- assumed: the shear force per width is what the test shows

-- N over the angle, up to the limit, as a test for the fit.
for _, size in ipairs(sizes) do
  size.record = lab.read { file = place .. size.file, units = { displacement = "mm", force = "N" } }
  size.shear = lab.bias_shear { displacement = size.record.displacement, force = size.record.force, width = size.width, length = size.length,
    thickness = thickness, cut = true }
  size.test = { E = size.shear.E12, S = size.shear.S12, branches = { { kind = "loading", first = 1, last = #size.shear.E12 } } }
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
  local predicted = lab.bias_shear { displacement = d, card = card, width = size.width, length = size.length }
  local c = lab.compare({ displacement = d, force = force }, { displacement = d, force = predicted.force },
    { file = out .. "/" .. size.file:gsub("%.csv$", ".svg"), title = "glass, " .. size.name })
  return c, predicted.force[#d] / force[#d] - 1
end

local rows = {}
local both, tested = card_of { sizes[1].test, sizes[2].test }
print "fitted on both:"
for i, size in ipairs(sizes) do
  local c, at_end = misfit(both, tested, size)
  print(("  %s: %s; at the end %+.1f %%"):format(size.name, c.text, 100 * at_end))
  rows[#rows + 1] = { size.name .. ": rms over the peak, fitted on both", c.rms, 0, absolute = 0.1 }
  local other, reach = card_of { sizes[3 - i].test }
  local held, end_held = misfit(other, reach, size)
  print(("  left out, predicted from the other: %s; at the end %+.1f %%"):format(held.text, 100 * end_held))
  rows[#rows + 1] = { size.name .. ": rms over the peak, left out", held.rms, 0, absolute = 0.15 }
end
-- At equal angles the two laboratories differ by this, which no single curve can fit: slip of the edge yarns, and the laboratories.
local sum, n = 0, 0
for i, angle in ipairs(sizes[1].shear.angle) do
  if angle > 10 then
    for k = 2, #sizes[2].shear.angle do
      local a, b = sizes[2].shear.angle[k - 1], sizes[2].shear.angle[k]
      if a <= angle and angle < b then
        local N = sizes[2].shear.normal_force
        local other = N[k - 1] + (N[k] - N[k - 1]) * (angle - a) / (b - a)
        sum, n = sum + (other / sizes[1].shear.normal_force[i] - 1), n + 1
      end
    end
  end
end
print(("between sizes: from 10 to 30 degrees the shear force of %s is %+.1f %% of that of %s on the mean (slip of edge yarns, pull-out, laboratories)"):format(
  sizes[2].name, 100 * sum / n, sizes[1].name))
local specimens = {}
for i, size in ipairs(sizes) do
  specimens[i] = { name = size.name, displacement = size.record.displacement, force = size.record.force, width = size.width, length = size.length }
end
print(lab.bias_sizes({ specimens = specimens, thickness = thickness }).text)
both:write(out .. "/card.lua")
print(both)
fabric.expect(rows)
