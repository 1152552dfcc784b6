-- Bias pulls of soft yarns, simulated: the shear that follows from the pull and the yarns' own curves.
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units

local function worst(yarn, weft, shear, width, length, way)
  local card = fabric.woven { name = "soft", density = 500, thickness = 0.4 * u.mm, warp = { loading = yarn, unloading = 4 * yarn[1] + (yarn[2] or 0), poisson = 0.2 },
    weft = { loading = weft, unloading = 4 * weft[1] + (weft[2] or 0), poisson = 0.2 }, shear = { loading = shear, unloading = 4 * shear[1], measure = "tensor" } }
  local test = lab.bias_extension { card = card, width = width, length = length, displacement = way, cells = 6, steps = 12 }
  local d, F = {}, {}
  for i, row in ipairs(test.curve) do d[i], F[i] = row.displacement, row.force end
  local function mean_error(more)
    local t = { displacement = d, force = F, width = width, length = length, thickness = card.thickness, cut = true }
    for name, value in pairs(more) do t[name] = value end
    local r, sum, n = lab.bias_shear(t), 0, 0
    local reference = fabric.point(card):path({ E12 = r.E12 }, { "S12" }).S12
    for i = #r.E12 // 2, #r.E12 do sum, n = sum + r.S12[i] / reference[i] - 1, n + 1 end
    return sum / n, r.taken_out or 0
  end
  local before = mean_error {}
  local after, strain = mean_error { warp = card.warp, weft = card.weft }
  return before, after, strain
end

local before, after = {}, {}
before[1], after[1] = worst({ 4e6 }, { 5e6 }, { 0.25e6 }, 0.05, 0.15, 0.012)
before[2], after[2] = worst({ 3e6, 60e6 }, { 2e6, 60e6 }, { 0.2e6 }, 0.05, 0.16, 0.015)
before[3], after[3] = worst({ 6e6 }, { 6e6 }, { 0.6e6 }, 0.06, 0.2, 0.02)

local stiff = table.pack(worst({ 4e8 }, { 5e8 }, { 0.25e6 }, 0.05, 0.15, 0.012))
local refused, words = pcall(lab.bias_shear, { displacement = { 0.001, 0.002 }, force = { 1, 2 }, width = 0.05, length = 0.15, thickness = 4e-4, warp = { loading = { 1e6 } } })

-- The evaluation simulates on another mesh than that of the "measured" pull.
local rows = { { "said which is missing", not refused and words:find("field 'weft': expected {loading=}", 1, true) and 1 or 0, 1, absolute = 0 },
  { "yarns that hardly stretch need nothing", stiff[2], 0, absolute = 0.015 } }
for i = 1, 3 do
  rows[#rows + 1] = { ("pull %d: error of S12 without yarns"):format(i), before[i], -0.19, absolute = 0.04 }
  rows[#rows + 1] = { ("pull %d: with them"):format(i), after[i], 0, absolute = 0.02 }
end
fabric.expect(rows)
