-- From synthetic tests back to the card: do the true values lie in the bands as often as they say?
--
--   fabricsh scripts/lab/round_trip.lua [repeats] [specimens] [fabric ...]
--
-- Each repeat makes warp, weft and bias tests of a shipped card with scatter between specimens, slack, slip, compliance and
-- noise, reduces them as a laboratory would, and looks whether each modulus and ratio is inside its own 95 % band. The load
-- cell's class of 0.5 % stands in the bands of moduli as what all specimens share: an error that may lie anywhere within 0.5 %
-- has a standard deviation of 0.5 %/sqrt(3), which is what the made records have. A ratio of strains knows no such error.
-- warns: was the specimen slack, or gripped late?
-- warns: is unlike the others
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units

local repeats, specimens = math.tointeger(tonumber(arg[1] or 10)), math.tointeger(tonumber(arg[2] or 6))
if not repeats or repeats < 1 or not specimens or specimens < 2 then
  error("usage: fabricsh round_trip.lua [repeats >= 1] [specimens >= 2] [fabric ...]", 0)
end
local names = #arg > 2 and table.move(arg, 3, #arg, 1, {}) or { "blend", "duck", "muslin", "denim" }

local geometry = { gauge_length = 76.2 * u.mm, width = 25.4 * u.mm, plies = 2 }
local compliance, slip = 2e-7, 1e-6 -- m/N, known to the laboratory
local shared = 0.005 / math.sqrt(3)

local function merged(a, b)
  local out = {}
  for k, v in pairs(a) do out[k] = v end
  for k, v in pairs(b) do out[k] = v end
  return out
end

-- Pulls along a yarn: its backbone, and the contraction across it.
local function along(card, direction, seed)
  local options = merged(geometry, { thickness = card.thickness })
  local made = lab.synthetic(merged(options, { card = card, direction = direction, specimens = specimens, seed = seed,
    compliance = compliance, slip = slip }))
  local tests, grids = {}, {}
  for i, s in ipairs(made) do
    tests[i] = lab.tensile(merged(options, { record = s.record, compliance = compliance, slip = slip }))
    grids[i] = s.photographs.markers
  end
  return lab.fit { tests = tests, find_slack = true, common = shared }, lab.poisson { specimens = grids }
end

local function in_shear(card, seed)
  local options = merged(geometry, { thickness = card.thickness, compliance = compliance, slip = slip })
  local made = lab.synthetic(merged(options, { card = card, direction = "bias", specimens = specimens, seed = seed, photographs = 200 }))
  local tests = {}
  for i, s in ipairs(made) do tests[i] = lab.shear_from_bias(merged(options, s.photographs)) end
  return lab.fit { tests = tests, common = shared, rule = "robust" }
end

-- Truths inside bands, by parameter. A coefficient that the chosen degree leaves out stands at zero without a band.
local counts, order = {}, {}
local function count(key, reference, low, high)
  if not counts[key] then
    counts[key] = { inside = 0, of = 0 }
    order[#order + 1] = key
  end
  counts[key].of = counts[key].of + 1
  if low <= reference and reference <= high then counts[key].inside = counts[key].inside + 1 end
end

local function compare(key, fit, part)
  if not fit.degree then -- no polynomial with a positive tangent: every parameter is missed
    for i, d in ipairs(part.loading) do count(("%s d%d"):format(key, i - 1), d, d + 1, d - 1) end
    return count(key .. " unloading", 0, 1, -1)
  end
  for i = 1, math.max(fit.degree, #part.loading) do
    local low, high = fit.band.low[i], fit.band.high[i]
    if i > fit.degree then low, high = 0, 0 end
    count(("%s d%d"):format(key, i - 1), part.loading[i] or 0, low, high)
  end
  count(key .. " unloading", part.unloading, fit.band.low[fit.degree + 1], fit.band.high[fit.degree + 1])
end

if fabric.checking() then return end
local rows = {}
for f, name in ipairs(names) do
  local card = fabric.card(name)
  counts, order = {}, {}
  for k = 1, repeats do
    local seed = 1000003 * f + 3 * k
    for i, direction in ipairs { "warp", "weft" } do
      local fit, ratio = along(card, direction, seed + i)
      compare(direction, fit, card[direction])
      count(direction .. " poisson", card[direction].poisson, ratio.low, ratio.high)
    end
    compare("shear", in_shear(card, seed), card.shear)
  end
  local inside, of = 0, 0
  for _, key in ipairs(order) do
    inside, of = inside + counts[key].inside, of + counts[key].of
    print(("%-8s %-18s inside in %3d of %d"):format(name, key, counts[key].inside, counts[key].of))
  end
  local share = inside / of
  print(("%-8s all parameters: inside in %.1f %%"):format(name, 100 * share))
  -- Parameters of one repeat hang together: the count of repeats, not of parameters, makes the allowance of two deviations.
  local allowed = repeats >= 100 and 1e-9 or 2 * math.sqrt(0.05 * 0.95 / repeats)
  rows[f] = { name .. ": share inside the 95 % bands", math.min(share, 0.95), 0.95, absolute = allowed }
end
fabric.expect(rows)
