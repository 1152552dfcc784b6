-- The standard instruments both ways: from a card to the curve an instrument records, to its numbers, to a card that shows them.
local fabric = require "fabric"
local kernels = require "fabric.kernels"
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

-- The loop is 2HG high as long as the other side's backbone has begun where it is read: 2HG5 is lower where 2HG < 5 G. The stress
-- itself, so that the square of the angle does not come in.
for _, case in ipairs { { 1.5, nil, 1.5, 1.5 / 0.8 }, { 5, nil, 5, nil }, { 0.2, nil, 0.2, 0.2 * 8 / (0.8 * 7.5 + 0.2) } } do
  local wanted = { G = 0.8, ["2HG"] = case[1] }
  local it = lab.kes_card { name = "shirt", thickness = 4e-4, density = 400, warp = given.warp, weft = given.weft, poisson = given.poisson, shear = wanted }
  local per_width = fabric.point(it):path({ E12 = E12 }, { "S12" }).S12
  for i, s in ipairs(per_width) do per_width[i] = s * it.thickness end
  local k = lab.kes_shear { angle = angle, force = per_width }
  local name = ("2HG %g, 2HG5 %s: "):format(case[1], tostring(case[2]))
  if case[3] then check(name .. "2HG", k["2HG"], case[3], 1e-6) end -- read between rows
  if case[4] then check(name .. "2HG5", k["2HG5"], 0.8 * 3 * case[4] / (8 - case[4]), 4e-3) end -- the sines of 5 and 8 degrees part from the angles by 3.3e-3
  if case[1] == 5 then check(name .. "2HG5", k["2HG5"], 5, 1e-6) end
  local shown, at5 = it.source:match "shows 2HG ([%d.]+) .* 2HG5 ([%d.]+)"
  check(name .. "said", tonumber(shown), k["2HG"], 5e-3) -- three digits
  check(name .. "said at 5 degrees", tonumber(at5), k["2HG5"], 5e-3)
end

-- With 2HG5 the friction grows (or falls) with the angle: all three numbers come back, and a loop that nobody can have is refused.
for _, case in ipairs { { 0.8, 1.5, 3 }, { 0.8, 1.5, 0.7 }, { 0.5, 0.4, 1.2 }, { 2, 6, 7 }, { 0.3, 0.1, 0.1 } } do
  local it = lab.kes_card { name = "shirt", T = 0.4, W = 16, warp = given.warp, weft = given.weft, poisson = given.poisson,
    shear = { G = case[1], ["2HG"] = case[2], ["2HG5"] = case[3] }, compression = { LC = 0.3, WC = 0.1, RC = 50 } }
  local k = lab.kes_shear { card = it }
  local name = ("G %g, 2HG %g, 2HG5 %g: "):format(table.unpack(case))
  check(name .. "G", k.G, case[1], 1e-6) -- read between rows
  check(name .. "2HG", k["2HG"], case[2], 1e-4)
  check(name .. "2HG5", k["2HG5"], case[3], 1e-4)
  assert(it.source:find("compression LC 0.3, WC 0.1 as given, RC 50 not: contact gives back all of it", 1, true))
  check(name .. "T and W", it.thickness * it.density, 0.16, 1e-12)
end
for _, case in ipairs { { 0.2, 0.5, 2, "expected less than 2HG + 4.5 G" }, { 0.8, 1.5, 0.5, "expected a loop that is open" } } do
  local ok, message = pcall(lab.kes_card, { name = "shirt", T = 0.4, W = 16, warp = given.warp, weft = given.weft, poisson = given.poisson,
    shear = { G = case[1], ["2HG"] = case[2], ["2HG5"] = case[3] } })
  assert(not ok and tostring(message):find(case[4], 1, true), tostring(message))
end

-- A whole sheet, to a card and back by virtual tests: within 3 % for any linearity that cloth has.
for _, case in ipairs { { 0.3, 45 }, { 0.4, 60 }, { 0.5, 50 }, { 0.5, 70 }, { 0.6, 65 }, { 0.7, 80 }, { 0.85, 60 }, { 1.1, 40 }, { 1.2, 40 } } do
  local LT, RT = table.unpack(case)
  local sheet = { name = "sheet", T = 0.5, W = 18, poisson = { warp = 0.2, weft = 0.3 }, warp = { EMT = 4, LT = LT, RT = RT },
    weft = { EMT = 12, WT = LT * 30, RT = RT }, shear = { G = 0.7, ["2HG"] = 1.1, ["2HG5"] = 2.4 },
    bending = { warp = { B = 0.1, ["2HB"] = 0.05 }, weft = { B = 0.06, ["2HB"] = 0.04 } } }
  local it = lab.kes_card(sheet)
  assert(it:check().ok)
  local back = lab.kes_sheet { card = it }
  assert(back.compression == nil)
  sheet.weft.LT = LT
  for _, part in ipairs { "warp", "weft", "shear" } do
    for field, value in pairs(sheet[part]) do check(("LT %g, RT %g: %s %s"):format(LT, RT, part, field), back[part][field], value, 3e-2) end
  end
  for _, part in ipairs { "warp", "weft" } do
    for field, value in pairs(sheet.bending[part]) do check(("bending %s %s"):format(part, field), back.bending[part][field], value, 1e-6) end
  end
  check("T", back.T, 0.5, 1e-12)
  check("W", back.W, 18, 1e-12)
end

-- ... and with what it was pressed with: contact gives all back, so RC is not the sheet's
for _, case in ipairs { { 0.25, 0.15, 0.6 }, { 0.4, 0.05, 0.3 }, { 0.6, 0.3, 1.2 }, { 0.95, 0.1, 1 } } do
  local LC, WC, T = table.unpack(case)
  local it = lab.kes_card { name = "pressed", T = T, W = 18, poisson = given.poisson, warp = given.warp, weft = given.weft, shear = { G = 0.7, ["2HG"] = 1.1 },
    compression = { LC = LC, WC = WC, RC = 50 } }
  local c, back = it.compression, lab.kes_sheet({ card = it }).compression
  check("LC", back.LC, LC, 3e-3)
  check("WC", back.WC, WC, 3e-3)
  check("RC", back.RC, 100, 1e-12)
  check("thickness at 0.5 gf/cm^2", c[#c][1], T * 1e-3, 1e-12)
  check("pressure there", c[#c][2], 0.5 * gf / cm ^ 2, 1e-12)
  check("way to 50 gf/cm^2", c[#c][1] - c[1][1], 2 * WC * gf / cm / (LC * 50 * gf / cm ^ 2), 1e-9)
  check("50 gf/cm^2", c[1][2], 50 * gf / cm ^ 2, 1e-12)
  assert(it.source:find("RC 50 not", 1, true) and it:check().ok)
end
-- nothing is pressed thinner than its fibres, 0.18 kg/m^2 over 1500 kg/m^3; contact that begins far beyond T is told, where it begins follows from the parabola that runs out
do
  local told, warn = {}, fabric.warn
  fabric.warn = function(words) told[#told + 1] = words end
  local function pressed(compression, more)
    local t = { name = "x", T = 1, W = 18, poisson = given.poisson, warp = given.warp, weft = given.weft, shear = { G = 0.7, ["2HG"] = 1.1 }, compression = compression }
    for key, value in pairs(more or {}) do t[key] = value end
    return lab.kes_card(t)
  end
  local function refused(words, ...)
    local ok, message = pcall(pressed, ...)
    assert(not ok and tostring(message):find(words, 1, true), tostring(message))
  end
  refused("field 'compression.WC': expected less than 0.88, at which LC 0.4 leaves of T 1 mm the 0.12 mm that the fibres alone fill (W over fibre_density), got 1.2", { LC = 0.4, WC = 1.2, RC = 50 })
  refused("expected less than 0.88,", { LC = 0.4, WC = 0.881, RC = 50 })
  refused("expected less than 0.88,", { LC = 0.4, WC = 1 - 1e-16, RC = 50 }) -- all of T, but for rounding
  refused("expected less than 0.8, at which LC 0.4 leaves of T 1 mm the 0.2 mm", { LC = 0.4, WC = 0.85, RC = 50 }, { fibre_density = 900 })
  refused("field 'compression.LC'", { LC = 0.015, WC = 0.01, RC = 50 })
  assert(#told == 0, told[1])
  assert(pressed({ LC = 0.4, WC = 0.87, RC = 50 }).compression[1][1] > 0.12e-3 and pressed({ LC = 0.4, WC = 0.85, RC = 50 }, { fibre_density = 1500 }).fibre_density == 1500)
  assert(#told == 0, told[1])
  local soft = pressed { LC = 0.2, WC = 0.3, RC = 50 }
  local c, free, fibres = soft.compression, kernels.free_thickness(soft)
  check("where contact begins", free, c[#c][1] + 2 * c[#c][2] * (c[#c][1] - c[#c - 1][1]) / (c[#c - 1][2] - c[#c][2]), 1e-12)
  check("what fibres fill", fibres, 0.18 / 1500, 1e-12)
  assert(#told == 1 and told[1]:find(("kes_card: field 'compression': contact begins at %.3g mm, %.2g times T: as soft as LC 0.2 and WC 0.3 have it"):format(free * 1e3, free / 1e-3), 1, true), told[1])
  check("without compression", (kernels.free_thickness(pressed())), 1e-3, 1e-15)
  fabric.warn = warn
end

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

-- its bias strip too, yarns and shear together; and the loads are 5, 20 and 100 gf per cm of width: 123 = 100/4 of the first, 14.7 =
-- the second less the first, to their digits
do
  local stretch, E, load = line(0, 0.06, 6000), {}, {}
  for i, e in ipairs(stretch) do E[i] = e + e * e / 2 end
  local S = fabric.point(fast):uniaxial(45, E, { "S" }).S
  for i, s in ipairs(S) do load[i] = s * fast.thickness * (1 + stretch[i]) end
  local along = { stretch = { 0, 0.02 }, force = { 0, 100 * gf / cm } }
  local f = lab.fast { along = along, bias = { stretch = stretch, force = load } }
  check("EB5", f.EB5, 4, 1e-6) -- between rows
  check("G", f.G, 123 / 4, 1e-6)
  check("E5", f.E5, 0.1, 1e-12)
  check("E20", f.E20, 0.4, 1e-12)
  check("E100", f.E100, 2, 1e-12)
  local stiff = { stretch = { 0, 0.1 }, force = { 0, 4 * 30 * 0.1 } } -- a strip that only shears: E45 = 4 G
  check("G of a strip that only shears", lab.fast({ along = along, bias = stiff }).G, 30, 4e-3) -- 123 for 122.6
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
local bias = lab.bias_shear { displacement = d, force = F, width = w, length = h, thickness = 1e-3, limit = 60.1 }
check("angle of the middle zone", bias.angle[400], 50, 1e-9)
check("normal force from a bias pull", bias.normal_force[400], want[400], 1e-5) -- half angles between rows
-- a straight N(gamma) comes back as it is at any spacing, from the first point on
for _, angles in ipairs { { 10, 20, 30, 40 }, { 2, 35, 36, 50 }, { 50 }, { 0, 20, 60 } } do
  local d, F = {}, {}
  for i, degrees in ipairs(angles) do
    local x = math.rad(degrees)
    d[i] = degrees == 0 and 0 or math.sqrt(2) * (h - w) * math.cos(math.pi / 4 - x / 2) - (h - w)
    F[i] = 40 * ((2 * h - 3 * w) * math.cos(x) * x + w * x / 2 * math.cos(x / 2)) / ((h / w - 1) * (math.cos(x / 2) - math.sin(x / 2)))
  end
  local back = lab.bias_shear { displacement = d, force = F, width = w, length = h, thickness = 1e-3, limit = 60.1 }
  for i, degrees in ipairs(angles) do
    rows[#rows + 1] = { ("straight N, point %d at %g degrees"):format(i, degrees), back.normal_force[i], 40 * math.rad(degrees), absolute = 1e-10 }
  end
end
-- beyond the limit rows are marked, or left out; what steps back a little is noise, a reversal is refused or cut
do
  local function shear(more)
    local t = { displacement = d, force = F, width = w, length = h, thickness = 1e-3 }
    for k, v in pairs(more or {}) do t[k] = v end
    return lab.bias_shear(t)
  end
  local said = {}
  local warn = fabric.warn
  fabric.warn = function(words) said[#said + 1] = words end
  local marked, wide, cut = shear(), shear { limit = 51 }, shear { cut = true }
  fabric.warn = warn
  assert(#said == 1 and said[1]:find("bias_shear: 160 of 400 rows are beyond 30 degrees (up to 50.0)", 1, true), said[1])
  assert(#marked.angle == 400 and marked.valid[240] and not marked.valid[241] and marked.angle[241] > 30 and wide.valid[400])
  assert(#cut.angle == 240 and #cut.E12 == 240 and cut.normal_force[240] == marked.normal_force[240])
  local up, force = {}, {}
  for i = 1, 200 do up[i], force[i] = d[i], F[i] end
  up[100] = up[99] - 1e-6
  local noisy = shear { displacement = up, force = force }
  assert(#noisy.rows == 199 and noisy.rows[99] == 99 and noisy.rows[100] == 101)
  for i = 1, 20 do up[200 + i], force[200 + i] = d[200 - i], F[200 - i] end
  local ok, message = pcall(shear, { displacement = up, force = force })
  assert(not ok and message:find "field 'displacement': expected rising values, got [%d.]+ m at place 20%d after [%d.]+: end the record at the reversal", message)
  cut = shear { displacement = up, force = force, cut = true }
  assert(cut.rows[#cut.rows] == 200 and math.abs(cut.normal_force[#cut.rows] / wide.normal_force[200] - 1) < 1e-5) -- a row less between
  -- 84 degrees are no shear that a cloth of yarns without stretch has: the force comes out negative
  local far = { displacement = { 0.01, 0.02, 0.03, 0.0465 }, force = { 1.5, 4, 8, 17.85 }, width = 0.1, length = 0.2128, thickness = 1e-3 }
  fabric.warn = function() end
  ok, message = pcall(lab.bias_shear, far)
  fabric.warn = warn
  assert(not ok and message:find("the shear force turns negative at place 4 (46.5 mm, 17.85 N, 83.9 degrees: -", 1, true), message)
  far.cut = true
  assert(#lab.bias_shear(far).angle == 2)
end
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

-- Bending alone: what is missing comes from the library, with the ranges that its apparel cloths show. Force per width at a stretch, and at an angle.
do
  local function pulled(c, direction, e) return fabric.point(c):uniaxial(direction, e + e * e / 2).S * c.thickness * (1 + e) end
  local function sheared(c, degrees) return fabric.point(c):strain({ E12 = math.sin(math.rad(degrees)) / 2 }).S12 * c.thickness / math.rad(degrees) end
  local pulls, shears = {}, {}
  for _, name in ipairs { "blend", "denim", "duck", "muslin", "wool", "worsted" } do
    local c = fabric.card(name)
    pulls[#pulls + 1], pulls[#pulls + 2], shears[#shears + 1] = pulled(c, "warp", 0.01), pulled(c, "weft", 0.01), sheared(c, 0.5)
  end
  table.sort(pulls)
  table.sort(shears)
  local worsted, filled = fabric.card "worsted", require "fabric.lab.card.filled"
  local mean = (pulled(worsted, "warp", 0.01) + pulled(worsted, "weft", 0.01)) / 2
  check("lowest pull of the library over worsted's", pulls[1] / mean, filled.pull[1], 0.05) -- the ranges have one digit or two
  check("highest but one", pulls[11] / mean, filled.pull[2], 0.05)
  check("lowest shear: a quarter of worsted's, which is the lowest", shears[1] / sheared(worsted, 0.5) / 4, filled.shear[1], 1e-12)
  check("highest shear", shears[6] / sheared(worsted, 0.5), filled.shear[2], 0.05)

  local B = { warp = { B = 0.11, ["2HB"] = 0.05 }, weft = { B = 0.07, ["2HB"] = 0.03 } }
  local alone = lab.kes_card { name = "alone", T = 0.5, W = 14, bending = B }
  check("bending alone: force at 3 % per width", pulled(alone, "weft", 0.03), pulled(worsted, "weft", 0.03), 1e-12)
  check("bending alone: shear per width", sheared(alone, 3), sheared(worsted, 3), 1e-12)
  local k = lab.kes_sheet { card = alone }
  check("bending alone: B of the weft", k.bending.weft.B, 0.07, 1e-3)
  check("bending alone: W", k.W, 14, 1e-12)
  local ranges = {}
  for _, input in ipairs(require "fabric.assumed".of(alone)) do ranges[input.name] = input end
  for _, name in ipairs { "warp", "weft" } do
    assert(ranges[name .. ".loading"][1] == 0.8 and ranges[name .. ".loading"][2] == 30 and ranges[name .. ".poisson"][2] == 1 and ranges[name .. ".unloading"])
  end
  assert(ranges["shear.loading"][1] == 0.25 and ranges["shear.loading"][2] == 22 and ranges["bending.twist"])
  local stiff = ranges["shear.loading"].apply(ranges["warp.loading"].apply(alone, 7), 3)
  check("seven times the pull of the warp", pulled(stiff, "warp", 0.02), 7 * pulled(alone, "warp", 0.02), 1e-9)
  check("and its way back", stiff.warp.unloading, 7 * alone.warp.unloading, 1e-12)
  check("that of the weft as before", pulled(stiff, "weft", 0.02), pulled(alone, "weft", 0.02), 1e-12)
  check("three times the shear", sheared(stiff, 2), 3 * sheared(alone, 2), 1e-9)
  assert(alone.source:find("Poisson ratios assumed; warp, weft, shear assumed: not on the sheet", 1, true), alone.source)

  -- one yarn pulled, shear with friction measured: the other yarn is as the first
  local one = lab.kes_card { name = "one", T = 0.4, W = 16, warp = { EMT = 4, LT = 0.6, RT = 55 }, shear = { G = 0.8, ["2HG"] = 1.5, ["2HG5"] = 3 }, poisson = { warp = 0.2, weft = 0.3 } }
  check("the weft as the warp", pulled(one, "weft", 0.03) / pulled(one, "warp", 0.03), 1, 1e-9)
  assert(one.weft.poisson == 0.3 and one.provenance["weft.loading"]:find "^assumed: as the warp's" and one.ranges["weft.loading"][1] == 0.1 and one.ranges["weft.loading"][2] == 10 and one.provenance["warp.loading"] == "measured: KES")
  ranges = {}
  for _, input in ipairs(require "fabric.assumed".of(one)) do ranges[input.name] = input end
  assert(ranges["weft.loading"][2] == 10 and not ranges["warp.loading"] and not ranges["shear.loading"] and not ranges["weft.poisson"])
  -- friction of a part goes with its forces
  local softer = require "fabric.assumed".of(one:with { provenance = { ["shear.loading"] = "assumed: as worn cloth" } })
  for _, input in ipairs(softer) do
    if input.name == "shear.loading" then
      local twice = lab.kes_shear { card = input.apply(one, 2) }
      check("2HG of twice the shear", twice["2HG"], 3, 1e-4)
      check("G of twice the shear", twice.G, 1.6, 1e-6)
    end
  end
  local nothing, why = pcall(lab.kes_card, { name = "none", T = 0.4, W = 16 })
  assert(not nothing and tostring(why):find("expected the numbers of one test at least: warp, weft, shear or bending", 1, true), tostring(why))
  -- the whole sheet has no provenance, as before
  assert(lab.kes_card(given).provenance == nil or not next(lab.kes_card(given).provenance))
end
fabric.expect(rows)
