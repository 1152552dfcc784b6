-- Made families of records of several laboratories: how many points of a further record lie in the band that fabric.lab.effects learns from them (the bands of
-- fabric.lab.pool and fabric.lab.bias_sizes)?
--
--   fabricsh scripts/long/lab_next_size.lua [sets]        default 150 of each kind: half a minute
--
-- A record is a line through zero times 1 + c1 + c2 s + c3 (3 s^2 - 1)/2, s from -1 to 1 over its length, and noise. c of a laboratory has a deviation of 8 % times
-- (1, tilt, bend), c of a record beside that one of 2 or 8 % times the same.
local fabric = require "fabric"
local effects = require "fabric.lab.card.effects"
local draw = require "fabric.lab.random" (3)
local sets = tonumber(arg[1] or 150)
if not sets or sets < 10 then error("usage: fabricsh lab_next_size.lua [sets, 10 or more]", 0) end
if fabric.checking() then return end

local x = {}
for i = 1, 12 do x[i] = i / 12 end

local function coefficients(shape, deviation)
  local c = {}
  for k = 1, 3 do c[k] = shape[k] * deviation * draw.normal() end
  return c
end

local function record(laboratories, name, shape, own)
  laboratories[name] = laboratories[name] or coefficients(shape, 0.08)
  local c, of, t = coefficients(shape, own), laboratories[name], { x = x, scale = x, rest = {}, labels = { laboratory = name } }
  for i, at in ipairs(x) do
    local s = 2 * at - 1
    t.rest[i] = at * (c[1] + of[1] + (c[2] + of[2]) * s + (c[3] + of[3]) * (3 * s * s - 1) / 2) + 0.002 * draw.normal()
  end
  return t
end

-- Share of the points of a further record in its band, and half the band's width over the value.
local function family(names, new, shape, own)
  local laboratories, tests, inside, width = {}, {}, 0, 0
  for i, name in ipairs(names) do tests[i] = record(laboratories, name, shape, own) end
  local further = record(laboratories, new, shape, own)
  local p = effects.learn(tests, { "laboratory" }, 0.95):predict(further)
  for i, y in ipairs(further.rest) do
    inside = inside + (math.abs(y - p.shift[i]) <= p.half[i] and 1 or 0) / #x
    width = width + p.half[i] / x[i] / #x
  end
  return inside, width
end

local sum, kinds, least = 0, 0, 1
for _, shape in ipairs { { 1, 0.05, 0.02 }, { 1, 0.5, 0.25 } } do
  for _, case in ipairs { { "AB", "C" }, { "ABC", "D" }, { "AAABBB", "C" }, { "AAABBB", "A" } } do
    for _, own in ipairs { 0.02, 0.08 } do
      local names, inside, width = {}, 0, 0
      for name in case[1]:gmatch "." do names[#names + 1] = name end
      for _ = 1, sets do
        local share, half = family(names, case[2], shape, own)
        inside, width = inside + share / sets, width + half / sets
      end
      print(("tilt %g, bend %g, records of %s that differ by %g %%, a further one of %s: %.1f %% of the points, half width %.0f %%"):format(shape[2], shape[3], case[1],
        100 * own, case[2], 100 * inside, 100 * width))
      sum, kinds, least = sum + inside, kinds + 1, math.min(least, inside)
    end
  end
end
fabric.expect {
  { "points of further records in their 95 % bands, mean of all kinds", sum / kinds, 0.95, absolute = 0.05 },
  { "the kind with the fewest", least, 0.95, absolute = 0.2 },
}
