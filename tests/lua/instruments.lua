-- The standard instruments both ways: from a card to the curve an instrument records, to its numbers, to a card that shows them.
local fabric = require "fabric"
local lab = fabric.lab
local gf, cm = 9.80665e-3, 1e-2
local rows = {}
local function check(name, got, want, relative) rows[#rows + 1] = { name, got, want, relative = relative } end

local function line(from, to, n)
  local out = {}
  for i = 1, n do out[i] = from + (to - from) * i / n end
  return out
end
local function joined(...)
  local out = { 0.0 }
  for _, part in ipairs { ... } do table.move(part, 1, #part, #out + 1, out) end
  return out
end

local given = { name = "shirt", thickness = 4e-4, density = 400, warp = { EMT = 4, WT = 9, RT = 55 }, weft = { EMT = 6, WT = 13, RT = 50 },
  shear = { G = 0.8, ["2HG"] = 1.5 }, poisson = { warp = 0.2, weft = 0.25 },
  bending = { warp = { B = 0.1, ["2HB"] = 0.05 }, weft = { B = 0.06, ["2HB"] = 0.04 } } }
local card = lab.kes_card(given)

-- tensile: up to 500 gf/cm and back until the cloth is slack
for _, direction in ipairs { "warp", "weft" } do
  local k = given[direction]
  local stretch = joined(line(0, k.EMT / 100, 2000), line(k.EMT / 100, 0, 20000))
  local E, force = {}, {}
  for i, e in ipairs(stretch) do E[i] = e + e * e / 2 end
  local S = fabric.point(card):uniaxial(direction, E, { "S" }).S
  for i, s in ipairs(S) do force[i] = math.max(0, s) * card.thickness * (1 + stretch[i]) end
  local got = lab.kes_tensile { stretch = stretch, force = force }
  check(direction .. " EMT", got.EMT, k.EMT, 1e-12)
  check(direction .. " load there", force[2001], 500 * gf / cm, 1e-12)
  check(direction .. " WT", got.WT, k.WT, 1e-6) -- trapezoids
  -- The card comes back along its own straight line in S over E; the kink where it goes slack falls within a row.
  check(direction .. " RT", got.RT, k.RT, 1e-6)
  check(direction .. " LT", got.LT, k.WT / (500 * k.EMT / 200), 1e-6)
end

-- shear: 0, +8, -8, 0 degrees at constant warp length
local angle = joined(line(0, 8, 4000), line(8, -8, 8000), line(-8, 0, 4000))
local E12, force = {}, {}
for i, a in ipairs(angle) do E12[i] = math.sin(math.rad(a)) / 2 end
local S12 = fabric.point(card):path({ E12 = E12 }, { "S12" }).S12
for i, s in ipairs(S12) do force[i] = s * card.thickness * math.cos(math.rad(angle[i])) end
local got = lab.kes_shear { angle = angle, force = force }
-- The card is straight in S12 over E12, the instrument reads N over the angle: they part by the square of the angle.
check("G", got.G, 0.8, 2e-3)
check("2HG", got["2HG"], 1.5, 1e-3)

-- bending: the loop of a straight line with friction m: at height 2m once the friction has built up
local k, M = joined(line(0, 250, 500), line(250, -250, 1000), line(-250, 0, 500)), {}
local m, B = 0.025 * gf, 0.1 * gf * cm
local slip = 0
for i, x in ipairs(k) do
  slip = math.max(-m, math.min(m, slip + (i > 1 and m / 10 * (x - k[i - 1]) or 0)))
  M[i] = B * x + slip
end
local b = lab.kes_bending { curvature = k, moment = M }
check("B", b.B, 0.1, 1e-12)
check("2HB", b["2HB"], 0.05, 1e-12)
check("B on the card", card.bending.warp, 0.1 * gf * cm, 1e-14)
check("friction on the card", card.bending.friction_warp.moment, 0.025 * gf, 1e-14)

-- FAST: the numbers of a card made from the numbers
local fast = lab.fast_card { name = "suit", thickness = 5e-4, density = 400, warp = { E20 = 0.9, E100 = 2.5, B = 8 }, weft = { E20 = 1.2, E100 = 4, B = 6 },
  EB5 = 4, poisson = { warp = 0.2, weft = 0.2 } }
for direction, want in pairs { warp = { 0.9, 2.5 }, weft = { 1.2, 4 } } do
  local stretch, E, load = line(0, 0.05, 5000), {}, {}
  for i, e in ipairs(stretch) do E[i] = e + e * e / 2 end
  local S = fabric.point(fast):uniaxial(direction, E, { "S" }).S
  for i, s in ipairs(S) do load[i] = s * fast.thickness * (1 + stretch[i]) end
  local f = lab.fast { along = { stretch = stretch, force = load }, bending_length = 0.02, mass_per_area = 0.2 }
  check(direction .. " E20", f.E20, want[1], 1e-6) -- between rows
  check(direction .. " E100", f.E100, want[2], 1e-6)
  check(direction .. " F", f.F, (f.E20 - f.E5) * 0.2 * 9.80665 * 8 / 14.7, 1e-12)
end

-- A bias extension without markers [cao2008]: the force that a known N(gamma) makes gives it back. N = a gamma + b gamma^3.
local w, h = 0.1, 0.3
local function N(x) return 40 * x + 90 * x ^ 3 end
local d, F, want = {}, {}, {}
for i = 1, 400 do
  local x = math.rad(50) * i / 400
  d[i] = math.sqrt(2) * (h - w) * math.cos(math.pi / 4 - x / 2) - (h - w)
  F[i] = ((2 * h - 3 * w) * math.cos(x) * N(x) + w * N(x / 2) * math.cos(x / 2)) / ((h / w - 1) * (math.cos(x / 2) - math.sin(x / 2)))
  want[i] = N(x)
end
local bias = lab.bias_shear { displacement = d, force = F, width = w, length = h, thickness = 1e-3 }
check("angle of the middle zone", bias.angle[400], 50, 1e-9)
check("normal force from a bias pull", bias.normal_force[400], want[400], 1e-5) -- half angles between rows
-- the grips' work is that of the shear in the middle zone and, at half the angle, in the mixed ones
local function sum(xs, ys)
  local total = 0
  for i = 2, #xs do total = total + (ys[i] + ys[i - 1]) / 2 * (xs[i] - xs[i - 1]) end
  return total
end
local angles, power = {}, {}
for i = 1, 400 do
  local x = math.rad(50) * i / 400
  angles[i] = x
  power[i] = w * (2 * h - 3 * w) / 2 * N(x) * math.cos(x) + w * w * N(x / 2) * math.cos(x / 2) / 2
end
check("work of a bias pull", sum(d, F), sum(angles, power), 1e-5) -- trapezoids
-- the picture frame's too: stored and dissipated energy of the cloth
local blend, side, edge, fd = fabric.card "blend", 0.2, 0.15, { 0.0 }
for i = 1, 2000 do fd[i + 1] = 0.04 * i / 2000 end
local frame = lab.picture_frame { displacement = fd, card = blend, frame = side, cloth = edge }
local back = lab.picture_frame { displacement = fd, force = frame.force, thickness = blend.thickness, frame = side, cloth = edge }
local energy = fabric.point(blend):path { { 0, 0, back.E12[#fd] } }[1]
check("work of a picture frame", sum(fd, frame.force), (energy.stored + energy.dissipated) * edge ^ 2 * blend.thickness, 1e-6) -- trapezoids
check("its shear stress", back.S12[#fd], energy.S12, 1e-12)
fabric.expect(rows)
