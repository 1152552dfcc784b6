-- In-plane shear at one material point: a cycle with flips, a partial unloading, and the two memories
-- [williams2010, figs. 7-27, 7-28].
--
--   fabricsh scripts/law/shear.lua [folder]
local fabric = require "fabric"
local MPa = fabric.units.MPa
local folder = arg[1] or "out/law"

local card = fabric.card "blend"
local shear = card.shear

-- Tensor measure: with gamma = 2 E12, S12 = Pg(gamma), G12(gamma) = table(gamma / 2) / 2.
local function Pg(gamma)
  local sum = 0
  for i, d in ipairs(shear.loading) do sum = sum + d * (gamma / 2) ^ i / i end
  return sum
end
local Gu = shear.unloading / 2

local function drive(with, corners, n)
  local p, E, S, last, at = fabric.point(with), { 0 }, { 0 }, 0, {}
  for k, corner in ipairs(corners) do
    local path = {}
    for i = 1, n do path[i] = { 0, 0, last + (corner - last) * i / n } end
    local run = p:path(path)
    for _, r in ipairs(run) do E[#E + 1], S[#S + 1] = r.E12, r.S12 / MPa end
    last, at[k] = corner, run[#run]
  end
  return { x = E, y = S }, at
end

local cycle, fine = drive(card, { 0.2, -0.2, 0.25, 0 }, 200)
local _, coarse = drive(card, { 0.2, -0.2, 0.25, 0 }, 1)
fabric.plot {
  file = folder .. "/law_shear.svg",
  xlabel = "shear strain E12 (tensor)",
  ylabel = "shear stress S12, MPa",
  curves = { { x = cycle.x, y = cycle.y, label = "E12 to 0.2, -0.2, 0.25, 0" } },
}

-- Reloading from just before and just after zero stress.
local rest = 0.2 - Pg(0.4) / Gu / 2 -- E12 at which the stress has come back to zero
local fading = card:with { shear = { memory = "fading" } }
local curves, reached = {}, {}
local function every(n, list)
  local out = {}
  for i = 1, #list, n do out[#out + 1] = list[i] end
  return out
end
for _, case in ipairs { { "printed", card }, { "fading", fading } } do
  for _, where in ipairs { { "before", 0.002, "line" }, { "after", -0.002, "dashed" } } do
    local run, at = drive(case[2], { 0.2, rest + where[2], 0.25 }, 200)
    reached[#reached + 1] = at[3].S12
    if case[2] == fading then run = { x = every(30, run.x), y = every(30, run.y) } end -- points on the lines of the printed memory
    run.label, run.style = ("%s, turned just %s zero"):format(case[1], where[1]), case[2] == fading and "points" or where[3]
    curves[#curves + 1] = run
  end
end
fabric.plot {
  file = folder .. "/law_memory.svg",
  xlabel = "shear strain E12 (tensor)",
  ylabel = "shear stress S12, MPa",
  curves = curves,
}

-- Closed forms. First leg: Pg. Second: down the Gu line to zero stress at gamma0, then a virgin branch the other way.
local gamma0 = 0.4 - Pg(0.4) / Gu
local back = gamma0 + 0.4                  -- reverse strain of the second leg past its origin
local gamma1 = -0.4 + Pg(back) / Gu        -- where the third leg crosses zero
local rows = {}
for i, at in ipairs { fine, coarse } do
  local name = i == 1 and "200 steps a leg: " or "1 step a leg: "
  rows[#rows + 1] = { name .. "S12 at 0.2", at[1].S12, Pg(0.4), relative = 1e-12 }
  rows[#rows + 1] = { name .. "S12 at -0.2", at[2].S12, -Pg(back), relative = 1e-12 }
  rows[#rows + 1] = { name .. "S12 at 0.25", at[3].S12, Pg(0.5 - gamma1), relative = 1e-12 }
end
-- The branch that each memory keeps where the turn comes just after zero stress: the printed rule starts a virgin branch there.
local before, printed, _, faded = table.unpack(reached)
local turn = 2 * (rest - 0.002)
local reverse = 2 * 0.002
local origin = turn + Pg(reverse) / Gu -- zero stress again after the small reverse slip
rows[#rows + 1] = { "printed, turned before: back on the old curve", before, Pg(0.5), relative = 1e-12 }
rows[#rows + 1] = { "printed, turned after: a virgin branch from there", printed, Pg(0.5 - origin), relative = 1e-12 }
print(("at E12 = 0.25: turned before zero %.4f MPa; after zero, printed %.4f, fading %.4f MPa"):format(
  before / MPa, printed / MPa, faded / MPa))
-- The fading memory has lost 0.004 of its 0.4 of shear: it comes back to the old curve within that part.
rows[#rows + 1] = { "fading, turned after: nearly the old curve", faded, Pg(0.5), relative = 0.004 / 0.4 }
fabric.expect(rows)
