-- The part of shear that relaxes, found from made tests: do the true values lie in the bands as often as they say?
--
--   fabricsh scripts/long/lab_viscous.lua [repeats]
--
-- Tests are closed form: a curve of third degree and a spring and dashpot of 1 MPa, sheared to E12 = 0.2 at 0.001 or 0.05 /s, with noise of 0.2 %
-- of the peak; specimens differ by a factor of deviation 3 % and by half of that between the ends of their curves. Four designs: one specimen
-- that is held, four that are held, one at each of two speeds, three at each of them; and three at each of cloth that does not relax.
local fabric = require "fabric"
local lab = fabric.lab
local draw = require "fabric.lab.random" (2)

local repeats = math.tointeger(tonumber(arg[1] or 60))
if not repeats or repeats < 10 then error("usage: fabricsh lab_viscous.lua [repeats >= 10]", 0) end
if fabric.checking() then return end

local scatter, reach = 0.03, 0.2
local function test(speed, modulus, time, hold)
  local t = { E = {}, S = {}, time = {} }
  local own, bend, rise = scatter * draw.normal(), scatter / 2 * draw.normal(), reach / speed
  for k = 0, 300 do
    local s = rise * k / 300 * (1 + (hold or 0))
    local e, up = math.min(reach, speed * s), math.min(rise, s)
    local q = modulus * time * speed * (1 - math.exp(-up / time)) * math.exp(-(s - up) / time)
    t.E[k + 1], t.time[k + 1] = e, s
    t.S[k + 1] = (1 + own + bend * (2 * e / reach - 1)) * (3e6 * e + 4e7 * e ^ 3 + q) + 2e3 * draw.normal()
  end
  return t
end
local function times(n, f)
  local list = {}
  for i = 1, n do list[i] = f(i) end
  return list
end
local designs = {
  { "one specimen, held", 1e6, 8, function() return { test(0.05, 1e6, 8, 5) } end, scatter },
  { "four specimens, held", 1e6, 8, function() return times(4, function() return test(0.05, 1e6, 8, 5) end) end },
  { "one at each of two speeds", 1e6, 30, function() return { test(0.001, 1e6, 30), test(0.05, 1e6, 30) } end, scatter },
  { "three at each of two speeds", 1e6, 30, function() return times(6, function(i) return test(i <= 3 and 0.001 or 0.05, 1e6, 30) end) end },
}
local rows, all, of_all = {}, 0, 0
for _, design in ipairs(designs) do
  local name, modulus, time, make, known = table.unpack(design)
  local inside, of, told = { modulus = 0, time = 0, viscosity = 0 }, 0, 0
  for _ = 1, repeats do
    local v = lab.viscous { tests = make(), scatter = known }
    if v.modulus then
      of = of + 1
      for field, reference in pairs { modulus = modulus, time = time, viscosity = modulus * time } do
        local low = field == "time" and v.open_below and 0 or v.low[field]
        local high = field == "time" and v.open_above and math.huge or v.high[field]
        if low <= reference and reference <= high then inside[field] = inside[field] + 1 end
      end
    end
    if v.viscous then told = told + 1 end
  end
  print(("%-28s seen in %d of %d, told in %d; inside: modulus %d, time %d, product %d"):format(name, of, repeats, told, inside.modulus, inside.time, inside.viscosity))
  all, of_all = all + inside.modulus + inside.time + inside.viscosity, of_all + 3 * of
end
local wrongly = 0
for _ = 1, repeats do
  local v = lab.viscous { tests = times(6, function(i) return test(i <= 3 and 0.001 or 0.05, 0, 30) end) }
  if v.viscous or v.contradicts then wrongly = wrongly + 1 end
end
print(("cloth that does not relax: something said of %d of %d"):format(wrongly, repeats))
print(("all: inside in %.1f %% of %d"):format(100 * all / of_all, of_all))
-- The three of a repeat hang together: the count of repeats makes the allowance of two deviations and a half.
rows[1] = { "share inside the 95 % bands", math.min(0.95, all / of_all), 0.95, absolute = 2.5 * math.sqrt(0.05 * 0.95 / (#designs * repeats)) }
rows[2] = { "cloth that does not relax, of which something is said", wrongly / repeats, 0.05, absolute = 0.05 + 2 * math.sqrt(0.05 * 0.95 / repeats) }
fabric.expect(rows)
