-- A pull with loops, from record to card: what the straight law misses, and the curved loop that follows.
--
--   fabricsh scripts/lab/loops.lua [folder]
--
-- Three records are made: of a cloth whose law has curved loops (what comes back is known), of loops that no card can hold exactly (a power
-- of the way down, another up), and of a cloth with the straight law, which is recognised as straight.
local fabric = require "fabric"
local random = require "fabric.lab.random"
local MPa = fabric.units.MPa
local folder = arg[1] or "out/loops"

local gauge, width, thickness = 0.2, 0.05, 0.4e-3
local reference = { friction = 0.3, reach = 0.5, curve = 0.6 }
local Du = 300 * MPa
local card = fabric.card("blend"):with { warp = { unloading = Du, loop = reference } }
local straight = fabric.card("blend"):with { warp = { unloading = Du } }

-- To 0.06 and back, to 0.12 and back with two loops on the way, and up again; strains between, in rows of equal stretch.
local function path(rest)
  local turns = { 0, 0.06, rest(0.06, 0.1), 0.12, rest(0.12, 0.5), rest(0.12, 0.8), rest(0.12, 0.1), rest(0.12, 0.6), rest(0.12, 0.05), 0.13 }
  local E = {}
  for k = 2, #turns do
    local n = math.max(20, math.ceil(math.abs(turns[k] - turns[k - 1]) / 2.5e-4))
    for i = 1, n do E[#E + 1] = turns[k - 1] + (turns[k] - turns[k - 1]) * i / n end
  end
  return E
end

-- Crosshead and load cell: a force of 0.2 % of the largest, a displacement of 3 um (standard deviations).
local function record(E, S, seed)
  local draw, out, most = random(seed), { displacement = { 0 }, force = { 0 } }, 0
  for _, s in ipairs(S) do most = math.max(most, s) end
  for i, e in ipairs(E) do
    local stretch = math.sqrt(1 + 2 * e)
    out.displacement[i + 1] = gauge * (stretch - 1) + 3e-6 * draw.normal()
    out.force[i + 1] = (S[i] + 0.002 * most * draw.normal()) * stretch * width * thickness
  end
  return out
end
local function tensile(E, S, seed)
  return fabric.lab.tensile { record = record(E, S, seed), gauge_length = gauge, width = width, thickness = thickness, plies = 1, outliers = "keep" }
end
local function stresses(run)
  local S = {}
  for i, r in ipairs(run) do S[i] = r.S end
  return S
end

local yarn = card.warp
local function P(E) return yarn.loading[1] * E + yarn.loading[2] * E ^ 2 / 2 end
local function way(m, x) return m - (1 - x) * P(m) / Du end
local E = path(way)

-- 1. The reference is a card.
local own = tensile(E, stresses(fabric.point(card):uniaxial("warp", E)), 1)
local back = fabric.lab.loops { tests = { own } }
print("1. a cloth with curved loops\n" .. back.text)

-- 2. Loops by another rule: from each turn the rest of the way in a power of the part that is gone, 2.2 down and 0.6 up.
local function foreign(list)
  local S, m, turn, last = {}, 0, nil, 0
  for i, e in ipairs(list) do
    if e >= m then
      m, turn, S[i] = e, nil, P(e)
    else
      local down = e < last
      if not turn or turn.down ~= down then turn = { down = down, E = last, S = S[i - 1] } end
      local rest = way(m, 0)
      if down then
        S[i] = turn.S * math.max((e - rest) / (turn.E - rest), 0) ^ 2.2
      else
        local t = (e - turn.E) / (m - turn.E)
        S[i] = turn.S + (P(m) - turn.S) * (0.55 * t + 0.45 * t ^ 0.6)
      end
    end
    last = e
  end
  return S
end
local other = fabric.lab.loops { tests = { tensile(E, foreign(E), 2) } }
print("\n2. loops by another rule\n" .. other.text)

-- 3. A straight cloth.
local plain = fabric.lab.loops { tests = { tensile(E, stresses(fabric.point(straight):uniaxial("warp", E)), 3) } }
print("\n3. a cloth with the straight law\n" .. plain.text)

-- From the first record to a card: what was not measured is assumed, and said.
local made = fabric.lab.card { name = "looped", density = 590, thickness = thickness, warp = back, poisson = { warp = 0.25 }, assume = true }
print("\n" .. tostring(made))
if fabric.checking() then return end -- no file is written then
made:write(folder .. "/looped.lua")
local read = fabric.card(folder .. "/looped.lua")

-- The second cycle of the second record.
local c, shown = other.curves[1], {}
for i, e in ipairs(c.E) do
  if e > 0.08 then shown[#shown + 1] = { E = e, S = c.S[i], straight = c.straight[i], curved = c.curved[i] } end
end
fabric.plot {
  file = folder .. "/lab_loops.svg",
  xlabel = "Green-Lagrange strain E11",
  ylabel = "second Piola-Kirchhoff stress S11",
  yunit = "MPa",
  curves = {
    { rows = shown, x = "E", y = "S", label = "record" },
    { rows = shown, x = "E", y = "straight", label = "straight law", colour = "grey" },
    { rows = shown, x = "E", y = "curved", label = "curved loop" },
  },
}

local rows = {
  { "1: unloading, MPa", back.unloading / MPa, Du / MPa, relative = 0.02 },
  { "1: friction", back.loop.friction, reference.friction, absolute = 0.02 },
  { "1: reach", back.loop.reach, reference.reach, absolute = 0.05 },
  { "1: curve", back.loop.curve, reference.curve, absolute = 0.05 },
  { "1: rms of the curved loop is the noise", back.rms.curved.all, 0.002, absolute = 0.001 },
  { "1: the straight law misses by a share of the peak", back.rms.straight.unloading, 0.1, absolute = 0.05 },
  { "3: rms of the straight law is the noise", plain.rms.straight.all, 0.002, absolute = 0.001 },
  { "3: its modulus, MPa", plain.rms and plain.line / MPa, Du / MPa, relative = 0.01 },
  { "2: the curved loop misses a third of what the straight law does at most", other.rms.curved.unloading / other.rms.straight.unloading, 0.17, absolute = 0.17 },
  { "the card keeps the loop", read.warp.loop.friction, back.loop.friction, relative = 1e-15 },
}
assert(back.curved and other.curved and not plain.curved and not plain.loop)
assert(made.provenance["warp.loop"]:find "^fitted to 1 specimen: friction" and made.provenance["warp.unloading"]:find "secant of curved loops")
assert(fabric.point(read):uniaxial("warp", { 0.1, 0.09 })[2].S == fabric.point(made):uniaxial("warp", { 0.1, 0.09 })[2].S)
fabric.expect(rows)
