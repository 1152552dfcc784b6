-- Relaxation is concluded only where no choice of the largest angle turns it round: a fast record that is stiffer at first and softer later tells nothing, and the
-- ratio of the records against the angle shows why.
local fabric = require "fabric"
local lab = fabric.lab

-- Two speeds a decade apart; the fast record carries `early` times the slow one up to 10 degrees and `late` times beyond 13.
local function records(early, late)
  local tests = {}
  for i, speed in ipairs { 1e-3, 1e-2 } do
    local t = { E = {}, S = {}, time = {}, name = i == 1 and "slow" or "fast" }
    for k = 1, 300 do
      local E = 0.24 * k / 300
      local part = math.max(0, math.min(1, (math.deg(math.asin(2 * E)) - 10) / 3))
      t.E[k], t.time[k] = E, E / speed
      t.S[k] = (3e6 * E + 4e7 * E ^ 3) * (i == 1 and 1 or early + (late - early) * part)
    end
    tests[i] = t
  end
  return tests
end

local turning = records(1.3, 0.75)
for _, limit in ipairs { 10, 30 } do
  local v = lab.viscous { tests = turning, limit = limit, scatter = 0.03 }
  assert(v.withheld and not v.viscous and not v.modulus and not v.contradicts, v.text)
  assert(v.text:find "^Nothing is concluded, since it depends on the angles that are used: up to %d+ degrees", v.text)
end
local v = lab.viscous { tests = turning, scatter = 0.03 }
assert(v.text:find("the fastest over the slowest against the angle: 1 degrees 1.30", 1, true), v.text)
for k, angle in ipairs(v.ratio.angle) do
  local want = angle < 9 and 1.3 or angle > 14 and 0.75
  if want then assert(math.abs(v.ratio.ratio[k] - want) < 0.02 and v.ratio.low[k] < want and want < v.ratio.high[k], v.ratio.ratio[k]) end
end
assert(#v.by_limit >= 2 and v.by_limit[1].limit == 10)

-- softer everywhere: the same at every limit, and said; a scatter that nobody measured is told apart from a band
v = lab.viscous { tests = records(0.75, 0.75) }
assert(v.contradicts and not v.withheld, v.text)
assert(v.scatter_from == "assumed" and v.text:find("The intervals hold under an assumed scatter of specimens", 1, true), v.text)
