-- One shear curve from bias pulls of several sizes: edges of a known width are found and told from none, another size is predicted.
local fabric = require "fabric"
local lab = fabric.lab
local draw = require "fabric.lab.random" (11)

local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails

-- Grips' force of cloth with N = 30 g + 200 g^3 (N/m) whose free edges carry nothing over a width e: the rule of the zones, written anew.
local function N(g) return 30 * g + 200 * g ^ 3 end
local function force(w, h, d, e)
  local g = math.pi / 2 - 2 * math.acos((h - w + d) / (math.sqrt(2) * (h - w)))
  local middle, mixed = w * (2 * h - 3 * w) / 2 - 2 * e * (h - 2 * w), w * w - 4 * e * w -- areas: two sides of h - 2w, four of w
  return (2 * middle * math.cos(g) * N(g) + mixed * math.cos(g / 2) * N(g / 2)) / ((h - w) * (math.cos(g / 2) - math.sin(g / 2)))
end
local function pull(w, h, e, noise, factor, degrees)
  local s = { displacement = {}, force = {}, width = w, length = h }
  local most = (math.sqrt(2) * math.cos(math.pi / 4 - math.rad(degrees or 29.9) / 2) - 1) * (h - w)
  for i = 1, 40 do
    s.displacement[i] = most * i / 40
    s.force[i] = (factor or 1) * force(w, h, s.displacement[i], e) + (noise or 0) * draw.normal()
  end
  return s
end

-- without edges it is the rule of bias_shear
local made = pull(0.15, 0.45, 0)
local shear = lab.bias_shear { displacement = made.displacement, force = made.force, width = 0.15, length = 0.45, thickness = 1e-3 }
for i, g in ipairs(shear.angle) do assert(math.abs(shear.normal_force[i] / N(math.rad(g)) - 1) < 0.02) end

-- Edges of 4 mm: found from two sizes, and a third is predicted where the simple rule misses.
local edge = 4e-3
local sizes = { pull(0.05, 0.15, edge, 0.01), pull(0.15, 0.45, edge, 0.02) }
local b = lab.bias_sizes { specimens = sizes, thickness = 1e-3, scatter = 0.02 }
assert(b.edges and math.abs(b.edge / edge - 1) < 0.1, b.text)
assert(b.edge_deviation > 5e-4 and b.edge_deviation < 2e-3, b.edge_deviation)
for _, s in ipairs(b.specimens) do assert(s.rms < 0.005 and s.without.rms > 0.015, b.text) end
assert(b.text:find("edges (slip of edge yarns, pull-out): +", 1, true) and b.specimens[1].name == "50 x 150 mm", b.text)
local third = pull(0.03, 0.12, edge)
local with = b:predict(third)
local without = b:predict { displacement = third.displacement, width = 0.03, length = 0.12, edges = false }
for i = 20, 40 do
  assert(math.abs(with.force[i] / third.force[i] - 1) < 0.06, with.force[i] / third.force[i])
  assert(with.low[i] < third.force[i] and third.force[i] < with.high[i])
end
local function miss(p) return math.abs(p.force[40] / third.force[40] - 1) end
assert(miss(without) > 0.15 and miss(with) < 0.05, miss(without) .. " " .. miss(with))
for k, g in ipairs(b.curve.angle) do
  if k > 3 then assert(math.abs(b.curve.normal_force[k] / N(math.rad(g)) - 1) < 0.04) end
end

-- The card of several sizes says what it was made of, and predicts by the same curve.
local card = lab.card { name = "sizes", density = 1000, thickness = 1e-3, warp = { loading = { 50e6 } }, shear = b.shear, assume = true }
assert(card.provenance["shear.loading"]:find "^fitted to 2 bias pulls of 50 x 150 mm, 150 x 450 mm together, monotone curve up to 30 degrees, edges of 4%.?%d* mm",
  card.provenance["shear.loading"])
local whole = pull(0.1, 0.3, 0)
local of_card = lab.bias_shear { displacement = whole.displacement, card = card, width = 0.1, length = 0.3 }
assert(math.abs(of_card.force[36] / whole.force[36] - 1) < 0.05)

-- Two laboratories that differ by 4 % where specimens scatter by 2 tell no edges: sqrt(2) of their deviations.
for _, factor in ipairs { 1.04, 0.96 } do
  local two = { pull(0.05, 0.15, 0, 0, factor), pull(0.15, 0.45, 0) }
  local f = lab.bias_sizes { specimens = two, thickness = 1e-3, scatter = 0.02, knots = 6 }
  local deviations = math.abs(f.edge) / f.edge_deviation
  assert(not f.edges and deviations > 1 and deviations < 1.9, f.text)
  assert(f.text:find "these sizes cannot separate them from the scatter of specimens and laboratories; taken as none", f.text)
end
-- one laboratory that shows a third more is no edge
b = lab.bias_sizes { specimens = { pull(0.05, 0.15, 0, 0, 1.6), pull(0.15, 0.45, 0) }, thickness = 1e-3 }
assert(not b.edges and b.edge_on_bound and b.text:find "at the bound, a fifth of the width, which does not explain", b.text)
-- and sizes that are alike in shape cannot
b = lab.bias_sizes { specimens = { sizes[1], sizes[1] }, thickness = 1e-3 }
assert(not b.edges and not b.edge_deviation and b.text:find "edges: specimens of such similar shape cannot separate them from the curve; taken as none", b.text)
-- rows beyond the limit are left out
assert(#lab.bias_sizes({ specimens = { pull(0.1, 0.3, 0, 0, 1, 45) }, thickness = 1e-3 }).specimens[1].predicted.force < 30)

fails("predict: expected displacements up to 0.02", b.predict, b, { displacement = { 0.5 }, width = 0.05, length = 0.15 })
fails("predict: expected { displacement={...}, width=, length= } in m", b.predict, b, {})
fails("bias_sizes: field 'specimens[1].width': expected a length in m, got nil", lab.bias_sizes, { specimens = { { displacement = { 1 }, force = { 1 } } }, thickness = 1e-3 })
fails("bias_sizes: field 'specimens[1]': expected at least 3 rows within 30 degrees, got 2", lab.bias_sizes,
  { specimens = { { displacement = { 1e-3, 2e-3 }, force = { 1, 2 }, width = 0.05, length = 0.15 } }, thickness = 1e-3 })
fails("field 'specimens': expected at least one, got none", lab.bias_sizes, { specimens = {}, thickness = 1e-3 })

-- a force of the wrong sign, none at all, or one that turns negative, in all that take a bias pull
local folder = require "fabric.lab.folder"
local place = os.tmpname()
os.remove(place)
assert(os.execute("mkdir '" .. place .. "'"))
local function write(name, text)
  local f <close> = assert(io.open(place .. "/" .. name, "w"))
  f:write(text)
end
local function wrong(words, sign)
  local s = pull(0.1, 0.3, 0)
  local lines = { "Displacement (mm),Force (N)" }
  for i, F in ipairs(s.force) do
    s.force[i] = sign(i) * F
    lines[i + 1] = ("%g,%g"):format(s.displacement[i] * 1e3, s.force[i])
  end
  fails("bias_sizes: field 'specimens[1].force': " .. words, lab.bias_sizes, { specimens = { s }, thickness = 1e-3 })
  s.speed = 1e-3
  fails("viscous: field 'tests[1].force': " .. words, lab.viscous, { tests = { s }, thickness = 1e-3 })
  fails("bias_shear: field 'force': " .. words, lab.bias_shear, { displacement = s.displacement, force = s.force, width = 0.1, length = 0.3, thickness = 1e-3 })
  write("bias-1.csv", table.concat(lines, "\n") .. "\n")
  write("laboratory.lua", "return { name='x', gauge_length=0.3, width=0.1, thickness=1e-3, density=500 }")
  fails("bias-1.csv: field 'force': " .. words, folder.reduce, place)
end
wrong("force runs from -", function() return -1 end)
wrong("force runs from -", function(i) return i < 30 and 1 or -1 end)
wrong("expected a pull with a force, got only zeros", function() return 0 end)
assert(os.execute("rm -r '" .. place .. "'"))
local noisy = pull(0.1, 0.3, 0)
noisy.force[1] = -0.01 * noisy.force[40]
assert(lab.bias_shear { displacement = noisy.displacement, force = noisy.force, width = 0.1, length = 0.3, thickness = 1e-3 })
-- lengths in mm are asked about
local warned, warn = {}, fabric.warn
fabric.warn = function(words) warned[#warned + 1] = words end
lab.bias_shear { displacement = noisy.displacement, force = noisy.force, width = 115, length = 230, thickness = 1e-3 }
fabric.warn = warn
assert(#warned == 2 and warned[1] == "bias_shear: field 'width': 115 m is far from what cloth is: is it in m?", warned[1])
