-- A shear backbone from a bias-extension record, through the simulated test: what eqs. 3.15 and 3.16 cannot give when the
-- specimen has its three zones, and no photographs were taken.
--
--   fabricsh scripts/lab/identify_bias.lua [file] [width mm] [length mm] [out] [cells] [other width mm] [other length mm] [other file]
--
-- file: displacement (mm) and force (N); default: the published benchmark curve of a plain-weave glass fabric, 150 x 450 mm
-- [cao2008], if it lies beside this checkout (../shared/data); the program carries no copy. Writes card.lua, overlay.svg and
-- what was simulated so far (identify.part, taken up again) into out. cells: squares across the width, default 6. The card then runs another specimen, 115 x 230 mm,
-- and is compared with its record (of another laboratory, in ../shared/data).
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units

local place = arg[0]:match "^(.*)scripts/" or ""
local function readable(path)
  local f = io.open(path)
  if f then f:close() end
  return f and path
end
local benchmark = "shared/data/cao-2008/bias-extension-150x450.csv"
local file = (arg[1] ~= "" and arg[1]) or readable(place .. "../" .. benchmark)
if not file then
  print "SKIPPED: the published curve is not beside this checkout; give a file"
  return
end
local function size(i, default) return (tonumber(arg[i]) or default) * u.mm end
local width, length, out = size(2, 150), size(3, 450), arg[4] or "out/identify-bias"
local cells = math.tointeger(tonumber(arg[5] or 6))
local other = { width = size(6, 115), length = size(7, 230) }
other.file = arg[8] or not arg[6] and not arg[7] and readable(place .. "../shared/data/cao-2008/bias-extension-115x230-INSA.csv")
if fabric.checking() then return end

local record = lab.read { file = file, default_units = { displacement = "mm", force = "N" } }

-- Tensor shear strain of the middle zone if yarns do not stretch: its diagonal L - W grows by the displacement.
local function middle_strain(w, l, d)
  local half = math.min(1, (l - w + d) / (math.sqrt(2) * (l - w)))
  return math.sin(math.pi / 2 - 2 * math.acos(half)) / 2
end
local reach, last = 0, 0
for i, d in ipairs(record.displacement) do
  if d > last then last, reach = d, middle_strain(width, length, d) end
end

-- The backbone: straight pieces between knots of shear strain, closer where the yarns lock; a parameter is the logarithm of a
-- piece's tangent (Pa). Yarns: the test says little of their stiffness, so it is assumed (line load 50 kN/m per unit strain).
local thickness, yarn = 1 * u.mm, 50 * u.MPa
local parts = { 0.06, 0.2, 0.45, 0.65, 0.8, 0.91, 1 }
local function card_of(p)
  local points, stress, before, steepest = { { 0, 0 } }, 0, 0, 0
  for i, part in ipairs(parts) do
    local tangent = 10 ^ p["G" .. i]
    stress, steepest = stress + tangent * (part * reach - before), math.max(steepest, tangent)
    before = part * reach
    points[i + 1] = { before, stress }
  end
  points[#points + 1] = { 1.15 * reach, stress + steepest * 0.15 * reach } -- elements at the corners of the zones go further
  local along = { loading = { yarn }, unloading = yarn, poisson = 0 }
  return fabric.woven {
    name = "bias", source = "identified from " .. file:match "[^/]*$" .. " through the simulated bias test; yarn modulus, thickness and density assumed",
    density = 1000, thickness = thickness, warp = along, weft = along,
    shear = { loading = points, unloading = 20 * steepest, measure = "tensor" }, tested = { warp = 0.05, weft = 0.05, shear = 1.15 * reach },
  }
end

local function simulate(card, w, l, displacement, squares)
  return lab.bias_extension { card = card, width = w, length = l, displacement = displacement, steps = 40, cells = squares or cells,
    tolerance = 1e-7 }.curve
end

local function at_displacements(curve, displacements)
  local force, k = {}, 1
  for i, d in ipairs(displacements) do
    while k < #curve - 1 and curve[k + 1].displacement < d do k = k + 1 end
    local a, b = curve[k], curve[k + 1]
    force[i] = a.force + (b.force - a.force) * (d - a.displacement) / (b.displacement - a.displacement)
  end
  return force
end

local noise, peak = {}, 0
for i, P in ipairs(record.force) do
  noise[i], peak = 0.05 + 0.02 * P, math.max(peak, P)
end
local parameters = {}
for i in ipairs(parts) do parameters[i] = { name = "G" .. i, start = 4.5 + 1.5 * parts[i] ^ 4, low = 2.5, high = 7 } end
local start = {}
for _, parameter in ipairs(parameters) do start[parameter.name] = parameter.start end
card_of(start):write(out .. "/start.lua")
-- The record that a picture frame would add: the shear stress itself at eight angles, to 5 % of the largest.
local function in_frame(p)
  local strains = {}
  for i = 1, 8 do strains[i] = reach * i / 8 end
  return fabric.point(card_of(p)):path({ E12 = strains }, { "S12" }).S12
end
local frame_noise = 0.05 * in_frame(start)[8]
local found = lab.identify {
  parameters = parameters, checkpoint = out .. "/identify.part", progress = true, tolerance = 1e-4,
  key = ("%.17g x %.17g m, %d cells, %.17g m pulled"):format(width, length, cells, last),
  tests = { { name = "bias", measured = record.force, noise = noise,
    predict = function(p) return at_displacements(simulate(card_of(p), width, length, last), record.displacement) end } },
  further = { { name = "a picture frame", predict = in_frame, noise = frame_noise } },
}
print(found.text)
local card = card_of(found.parameters)
card:write(out .. "/card.lua")
local curve = simulate(card, width, length, last)
local finer = simulate(card, width, length, last, 2 * cells)
print(("residual: rms %.2f %%, largest %.2f %% of the peak force"):format(100 * found.misses.bias.rms, 100 * found.misses.bias.worst))
print(("peak force %.3f N; on a mesh of half the size %.3f N; measured %.3f N"):format(curve[#curve].force, finer[#finer].force, peak))

-- The same card on another specimen, to the same shear of its middle zone.
local there = last * (other.length - other.width) / (length - width)
local small = simulate(card, other.width, other.length, there)
print(("%g x %g mm: %.3f N at %.1f mm"):format(other.width / u.mm, other.length / u.mm, small[#small].force, there / u.mm))

-- The measured record of the other specimen, to the same displacement.
local there_measured = other.file and lab.read { file = other.file, default_units = { displacement = "mm", force = "N" } }
local function rows_to(c, most)
  local x, y = {}, {}
  for i, d in ipairs(c.displacement) do
    if d <= most then x[#x + 1], y[#y + 1] = d / u.mm, c.force[i] end
  end
  return x, y
end

local function columns(c)
  local x, y = {}, {}
  for i, row in ipairs(c) do x[i], y[i] = row.displacement / u.mm, row.force end
  return x, y
end
local x, y = columns(curve)
local sx, sy = columns(small)
local measured = {}
for i, d in ipairs(record.displacement) do measured[i] = d / u.mm end
local function named(w, l, what) return ("%g × %g mm, %s"):format(w / u.mm, l / u.mm, what) end
local curves = { { x = measured, y = record.force, label = named(width, length, "measured"), style = "points" }, { x = x, y = y, label = named(width, length, "card fitted to it") },
  { x = sx, y = sy, label = named(other.width, other.length, "predicted"), style = "dashed" } }
if there_measured then
  local mx, my = rows_to(there_measured, there)
  curves[4] = { x = mx, y = my, label = named(other.width, other.length, "measured"), style = "points" }
  if #mx > 0 then print(("%g x %g mm measured: %.3f N at %.1f mm"):format(other.width / u.mm, other.length / u.mm, my[#my], mx[#mx])) end
end
fabric.plot { file = out .. "/overlay.svg", xlabel = "displacement, mm", ylabel = "force, N", key = "below", curves = curves }
fabric.expect {
  { "largest residual over the peak force", found.misses.bias.worst, 0, absolute = 0.05 },
  { "force of the other specimen is a force", small[#small].force > 0 and 1 or 0, 1, absolute = 0 },
}
