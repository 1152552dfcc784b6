-- Curved loops found from made records: do the true values lie in the bands of one specimen as often as they say?
--
--   fabricsh scripts/long/lab_loops.lua [repeats]
--
-- Records are the law's own, two cycles with a loop inside the second, with noise of 0.5 % of the largest stress and 5e-6 of strain: of a loop
-- that is wide, and of a narrow one whose friction is lost over nearly the whole way.
local fabric = require "fabric"
local random = require "fabric.lab.random"
local MPa = fabric.units.MPa

local repeats = math.tointeger(tonumber(arg[1] or 100))
if not repeats or repeats < 10 then error("usage: fabricsh lab_loops.lua [repeats >= 10]", 0) end
if fabric.checking() then return end

local kinds = { "loading", "unloading", "reloading", "loading", "unloading", "reloading", "unloading", "reloading", "loading" }

local function record(card, seed)
  local draw, Du = random(seed), card.warp.unloading
  local function P(E) return card.warp.loading[1] * E + card.warp.loading[2] * E ^ 2 / 2 end
  local function way(m, x) return m - (1 - x) * P(m) / Du end
  local corners = { 0, 0.06, way(0.06, 0.1), 0.06, 0.12, way(0.12, 0.1), way(0.12, 0.7), way(0.12, 0.05), 0.12, 0.13 }
  local E, S, branches = {}, {}, {}
  for k, kind in ipairs(kinds) do
    local first = #E + 1
    for j = 1, 60 do E[#E + 1] = corners[k] + (corners[k + 1] - corners[k]) * j / 60 end
    branches[k] = { kind = kind, first = first, last = #E }
  end
  for j, r in ipairs(fabric.point(card):uniaxial("warp", E)) do S[j] = r.S + 0.005 * P(0.13) * draw.normal() end
  for j = 1, #E do E[j] = E[j] + 5e-6 * draw.normal() end
  return { E = E, S = S, branches = branches }
end

local rows = {}
for _, reference in ipairs {
  { friction = 0.3, reach = 0.5, curve = 0.6, unloading = 300 * MPa, name = "wide" },
  { friction = 0.15, reach = 0.9, curve = 0.3, unloading = 500 * MPa, name = "narrow" },
} do
  local card = fabric.card("blend"):with { warp = { unloading = reference.unloading,
    loop = { friction = reference.friction, reach = reference.reach, curve = reference.curve } } }
  local inside, off = {}, {}
  for seed = 1, repeats do
    local l = fabric.lab.loops { tests = { record(card, seed) } }
    assert(l.curved)
    for _, name in ipairs { "unloading", "friction", "reach", "curve" } do
      local held = l.low[name] <= reference[name] and reference[name] <= l.high[name]
      inside[name] = (inside[name] or 0) + (held and 1 or 0)
      off[name] = (off[name] or 0) + (l.values[name] / reference[name] - 1) ^ 2 / repeats
    end
  end
  for _, name in ipairs { "unloading", "friction", "reach", "curve" } do
    -- Three deviations of a count below 95 %; where friction and reach hang together, and the modulus with them, the bands are known to be
    -- narrow: estimates lie one deviation too high, which a band around them does not know.
    local hangs = reference.name == "narrow" and name ~= "curve"
    local share, wanted = inside[name] / repeats, hangs and 0.87 or 0.97
    rows[#rows + 1] = { ("%s: %s, share of true values inside"):format(reference.name, name), share, wanted, absolute = 0.03 + 3 * math.sqrt(0.07 / repeats) }
    print(("%-7s %-10s inside %3d of %d, rms deviation %.2f %%"):format(reference.name, name, inside[name], repeats, 100 * math.sqrt(off[name])))
  end
end
fabric.expect(rows)
