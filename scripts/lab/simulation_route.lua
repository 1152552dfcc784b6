-- The round trip through simulation: a bias test in clamped grips, whose zones no formula undoes, gives the shear backbone back.
--
--   fabricsh scripts/lab/simulation_route.lua [repeats] [fabric ...]
--
-- Each repeat is a simulated clamped bias test, up and partly back, with noise of the load cell; shear coefficients and unloading
-- modulus are identified through the same simulation, and are to lie in their own 95 % bands.
-- warns: the card was tested to 0.3
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units
local random = require "fabric.lab.random"

local repeats = math.tointeger(tonumber(arg[1] or 2))
local names = #arg > 1 and table.move(arg, 2, #arg, 1, {}) or { "denim" }
if fabric.checking() then return end

local noise = 0.02 -- N
local function forces(card)
  local test = lab.bias { card = card, grips = "clamped", displacement = 18 * u.mm, steps = 48, rows = 48, path = { 1, 0.9 }, tolerance = 1e-9 }
  local curve, out = test.curve, {}
  if #curve < 49 then error("the test ends on the way back: " .. tostring(test.analysis.stopped)) end
  for i = 1, 48 do out[i] = curve[i + 1].force end
  return out
end

local function with(card, p)
  local loading = {}
  for i = 1, #card.shear.loading do loading[i] = p["d" .. i - 1] * u.MPa end
  return card:with { shear = { loading = loading, unloading = p.Gu * u.MPa } }
end

local function one(card, seed)
  local draw, measured, parameters = random(seed), forces(card), {}
  for i, P in ipairs(measured) do measured[i] = P + noise * draw.normal() end
  for i, d in ipairs(card.shear.loading) do
    local reference = d / u.MPa
    local reach = (i == 1 and 0.9 or 4) * math.abs(reference)
    parameters[i] = { name = "d" .. i - 1, start = reference * 1.1, low = reference - reach, high = reference + reach }
  end
  local Gu = card.shear.unloading / u.MPa
  parameters[#parameters + 1] = { name = "Gu", start = 1.2 * Gu, low = 0.5 * Gu, high = 2 * Gu }
  return lab.identify { parameters = parameters, tolerance = 1e-7,
    tests = { { name = "bias", measured = measured, noise = noise, predict = function(p) return forces(with(card, p)) end } } }
end

local rows = {}
for f, name in ipairs(names) do
  local card, inside, of, missed = fabric.card(name), 0, 0, {}
  local reference = { Gu = card.shear.unloading / u.MPa }
  for i, d in ipairs(card.shear.loading) do reference["d" .. i - 1] = d / u.MPa end
  for k = 1, repeats do
    local found = one(card, 7919 * f + k)
    if k == 1 then print(name .. "\n" .. found.text) end
    local places = #card.shear.loading + 1
    for i = 1, places do
      local parameter = i < places and "d" .. i - 1 or "Gu"
      of = of + 1
      if math.abs(found.x[i] - reference[parameter]) <= 1.96 * found.deviation[i] then
        inside = inside + 1
      else
        missed[#missed + 1] = parameter
      end
    end
  end
  print(("%s: inside the 95 %% bands in %d of %d; outside: %s"):format(name, inside, of, table.concat(missed, " ")))
  -- three deviations of a count whose parameters hang together within a repeat
  rows[f] = { name .. ": share inside", inside / of, 0.95, absolute = 3 * math.sqrt(0.95 * 0.05 / repeats) }
end
fabric.expect(rows)
