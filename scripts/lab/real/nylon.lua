-- Nylon strips cut at several angles to the warp, monotone pulls without markers and without unloading (bertoldi-collab/aerodynamic-textile-metamaterials,
-- MIT): a card of those at 0, 45 and 90 degrees, what it assumes, and what it says for pulls at other angles, with a range.
--
--   fabricsh scripts/lab/real/nylon.lua [out] [folder] [scatter]        scatter: deviation of specimens, relative; default 0.05
--
-- The folder holds strip-ANGLE.csv (strip-00.csv ...): displacement and force, mm and N where a heading does not say otherwise. The records at 0, 45 and
-- 90 degrees make the card, one of 0 and 90 at least; every other angle is predicted and laid beside its record, 15, 30, 60 and 75 degrees in any case. The
-- records are not part of the program: the default is ../shared/data/nylon-strips beside this checkout, or the deck says SKIPPED.
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units
local mm = u.mm

local place = arg[2] or (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/nylon-strips"
local out, scatter = arg[1] or "out/nylon", tonumber(arg[3] or 0.05)
if not arg[2] and not io.open(place .. "/strip-00.csv") then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
if not scatter or scatter < 0 or scatter > 1 then error("usage: fabricsh nylon.lua [out] [folder] [scatter of specimens, 0 to 1]", 0) end
if fabric.checking() then return end

-- Twelve strips of 2.25 mm side by side; the thickness was not told.
local size = { gauge_length = 97 * mm, width = 12 * 2.25 * mm, thickness = 0.1 * mm, plies = 1 }
local tests, angles = {}, {}
for _, file in ipairs(fabric.folder(place)) do
  local angle = tonumber(file:match "^strip%-(%d+%.?%d*).*%.csv$")
  if angle and angle > 90 then error(("nylon: %s/%s: expected an angle of 0 to 90 degrees, got %g"):format(place, file, angle), 0) end
  if angle and tests[angle] then error(("nylon: %s: expected one record at %g degrees, got another, %s"):format(place, angle, file), 0) end
  if angle then
    local path = place .. "/" .. file
    local headings = fabric.table({ file = path, lenient = true }).header
    local t = { file = path, columns = not headings and { displacement = 1, force = 2 } or nil, default_units = { displacement = "mm", force = "N" }, zero = true }
    for name, value in pairs(size) do t[name] = value end
    tests[angle], angles[#angles + 1] = lab.tensile(t), angle
  end
end
table.sort(angles)
if not (tests[0] or tests[90]) then error("nylon: expected strip-00.csv or strip-90.csv in " .. place .. ": there is no pull along a yarn", 0) end

local function fitted(find_slack)
  local fits = {}
  if tests[0] then fits.warp = lab.fit { tests = { tests[0] }, find_slack = find_slack } end
  if tests[90] then fits.weft = lab.fit { tests = { tests[90] }, find_slack = find_slack } end
  return fits
end
local fits = fitted "either"
for _, name in ipairs { "warp", "weft" } do print(name .. ": " .. (fits[name] and fits[name].text or "no record, assumed as the other")) end

-- Between 0 and 90 degrees every yarn ends at the cut edges (in a strip of 2.25 mm one at 15 degrees is 9 mm long, one at 45 degrees 3 mm), and over some width
-- from there it slips and carries nothing. At 0 and 90 degrees the yarns that carry end in the grips, and at 45 the shear that is found makes up for it: these
-- three do not tell the width, and without it the law is too stiff at all angles at which yarns and shear share the load. `lost`: of the width, both edges.
local function at(card, angle, strains, lost)
  local S = fabric.point(card):uniaxial(angle, strains, { "S" }).S
  for i, s in ipairs(S) do S[i] = angle > 0 and angle < 90 and (1 - (lost or 0)) * s or s end
  return S
end
local function thinned(test)
  local E, S = {}, {}
  local step = math.max(1, #test.E // 20)
  for i = 1 + step // 2, test.failure or #test.E, step do E[#E + 1], S[#S + 1] = test.E[i], test.S[i] end
  return E, S
end

-- The shear follows from the pull at 45 degrees: the straight backbone with which a strip with free ends carries the measured force, by least squares over
-- the pull. It goes by the ratios and the toes that are taken for the yarns, and is found for each of them anew.
local function card_with(yarns, shear, ratio)
  local assume = { thickness = true, density = true, ["shear.loading"] = shear }
  return lab.card { name = "nylon", source = "bertoldi-collab, nylon strips", density = 500, thickness = size.thickness, assume = assume, warp = yarns.warp,
    weft = yarns.weft, poisson = ratio and { warp = ratio, weft = ratio } or nil }
end
local E45, S45
if tests[45] then E45, S45 = thinned(tests[45]) end
local function sheared(yarns, ratio, lost)
  if not E45 then return card_with(yarns, nil, ratio) end
  local found = lab.identify {
    parameters = { { name = "G0", start = 7.5, low = 5, high = 10 }, { name = "G1", start = 0, low = -20, high = 30 } },
    tests = { { name = "45 degrees", measured = S45, noise = 0.01 * S45[#S45],
      predict = function(p) return at(card_with(yarns, { 10 ^ p.G0, 10 ^ p.G0 * p.G1 }, ratio), 45, E45, lost) end } }, processes = 1,
  }
  if not ratio and not lost then print(found.text) end
  local p = found.parameters
  return card_with(yarns, { 10 ^ p.G0, 10 ^ p.G0 * p.G1 }, ratio)
end
local card = sheared(fits)
if not E45 then print "no record at 45 degrees: the shear is assumed" end

-- The yarns' own pulls count from the first contact that their fits found.
local rows = {}
local function beside(angle, test, slack, by, lost)
  local E, S = thinned(test)
  local c = lab.compare({ E = E, S = S }, { E = E, S = at(by or card, angle, E, lost) }, { slack = slack, file = ("%s/nylon-%02d.svg"):format(out, angle // 1),
    label = ("nylon, %g\u{b0}"):format(angle) })
  print(("%g degrees: %s"):format(angle, c.text))
  return c
end
for _, angle in ipairs { 0, 45, 90 } do
  local fit = angle == 0 and fits.warp or angle == 90 and fits.weft
  if tests[angle] then
    rows[#rows + 1] = { angle .. " degrees: rms over the peak", beside(angle, tests[angle], fit and fit.specimens and fit.specimens[1].slack or 0).rms, 0, absolute = 0.03 }
  end
end

-- Other angles: a range over what nobody measured. The ratios across those of the shipped cloths, either toe of each yarn, edges that lose from nothing to two fifths
-- of the width (half a millimetre each), the shear found anew for each (assumed: from 0.05 to 0.27 of the yarns); and two deviations of specimens, of which
-- one pull each tells nothing. All of it is assumed: the range has no stated confidence.
local drawn, losses = {}, E45 and { 0, 0.1, 0.2, 0.3, 0.4 } or { 0, 0.4 }
local middle = { card = E45 and sheared(fits, nil, 0.2) or card, lost = 0.2 }
for _, toe in ipairs { false, true } do
  local good, yarns = pcall(fitted, toe)
  for _, ratio in ipairs(good and { 0.12, 0.4, 0.9 } or {}) do
    for _, lost in ipairs(losses) do
      local made, one = pcall(sheared, yarns, ratio, lost)
      if made then drawn[#drawn + 1] = { card = one, lost = lost } end
      if made and not E45 then
        local G = one.shear.loading[1] / 0.09
        for _, part in ipairs { 0.05, 0.27 } do
          drawn[#drawn + 1] = { card = one:with { shear = { loading = { part * G }, unloading = 3 * part * G } }, lost = lost }
        end
      end
    end
  end
end
print(("other angles: range of %d cards (assumed: ratios 0.12 to 0.9, either toe, edges that lose 0 to %.2f mm each, the shear found for each; specimens that differ by %g %%), no stated confidence"):format(
  #drawn, losses[#losses] * 2.25 / 2, 100 * scatter))
-- Records at further angles tell the edges: those that miss the others least (all but `angle`), and one step of the list to either side; nil without such records.
local by_lost = {}
local function edges_from_others(angle)
  local best, least
  for _, lost in ipairs(E45 and losses or {}) do
    by_lost[lost] = by_lost[lost] or { card = sheared(fits, nil, lost), lost = lost }
    local sum, count = 0, 0
    for _, other in ipairs(angles) do
      if other ~= angle and other ~= 0 and other ~= 45 and other ~= 90 then
        local E, measured = thinned(tests[other])
        for i, s in ipairs(at(by_lost[lost].card, other, E, lost)) do sum, count = sum + ((s - measured[i]) / measured[#measured]) ^ 2 / #E, count + 1 end
      end
    end
    if count > 0 and (not least or sum < least) then best, least = lost, sum end
  end
  return best
end
local function band(angle, strains)
  local told = edges_from_others(angle)
  local centre = told and by_lost[told] or middle
  local S, low, high = at(centre.card, angle, strains, centre.lost), {}, {}
  for i, s in ipairs(S) do low[i], high[i] = s, s end
  for _, one in ipairs(drawn) do
    for i, s in ipairs((not told or math.abs(one.lost - told) < 0.11) and at(one.card, angle, strains, one.lost) or {}) do low[i], high[i] = math.min(low[i], s), math.max(high[i], s) end
  end
  for i in ipairs(S) do low[i], high[i] = (1 - 2 * scatter) * low[i], (1 + 2 * scatter) * high[i] end
  return S, low, high, centre, told
end
local others, reach = { 15, 30, 60, 75 }, 0.03
for _, angle in ipairs(angles) do
  if angle % 15 ~= 0 then others[#others + 1] = angle end
end
table.sort(others)
for _, angle in ipairs(others) do
  if angle > 45 and not tests[90] or angle < 45 and not tests[0] then
    print(("%g degrees: no range, since no pull was made along the yarn that carries most there, and the other yarn's curve stands for it"):format(angle))
    goto continue
  end
  local S, low, high, centre, told = band(angle, { reach })
  print(("%g degrees at E = %g: %.3g MPa, %.3g to %.3g"):format(angle, reach, S[1] / u.MPa, low[1] / u.MPa, high[1] / u.MPa) .. (told and (", with edges that lose %.0f %% of the width, as the other angles tell"):format(100 * told) or ""))
  if tests[angle] then
    local E, measured = thinned(tests[angle])
    local inside, _, from, to = 0, band(angle, E)
    for i, s in ipairs(measured) do inside = inside + (s >= from[i] and s <= to[i] and 1 or 0) end
    local c = beside(angle, tests[angle], 0, centre.card, centre.lost)
    print(("%g degrees: %d of %d measured points lie in the range"):format(angle, inside, #E))
    if E45 and tests[0] and tests[90] then rows[#rows + 1] = { angle .. " degrees, predicted: rms over the peak", c.rms, 0, absolute = 0.3 } end
  end
  ::continue::
end
card:write(out .. "/card.lua")
print(card)
fabric.expect(rows)
