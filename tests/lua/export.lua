-- fabric.export.card: texts parsed back, curves against closed forms in the target's measures, losses, refusals.
local fabric = require "fabric"
local rows = {}
local function check(label, got, want, relative) rows[#rows + 1] = { label, got, want, relative = relative } end
local function near(label, got, want, absolute) rows[#rows + 1] = { label, got, want, absolute = absolute } end

-- P(E), the integral of a card's tangent.
local function P(part, E)
  local sum = 0
  for k, d in ipairs(part.loading) do sum = sum + d * E ^ k / k end
  return sum
end

-- --- readers, written from the formats alone ---
local function fields(line, width)
  local out = {}
  for i = 1, #line, width do out[#out + 1] = tonumber(line:sub(i, i + width - 1)) or false end
  return out
end

local function lines_of(text)
  local out = {}
  for l in text:gmatch "[^\n]*" do out[#out + 1] = l end
  return out
end

-- LS-DYNA: keyword -> list of blocks of data lines, comments and (with _TITLE) titles left out.
local function dyna(text)
  local blocks, block = {}, nil
  for _, l in ipairs(lines_of(text)) do
    if l:sub(1, 1) == "*" then
      block = { titled = l:find "_TITLE" }
      blocks[l:gsub("_TITLE", "")] = blocks[l:gsub("_TITLE", "")] or {}
      table.insert(blocks[l:gsub("_TITLE", "")], block)
    elseif l ~= "" and l:sub(1, 1) ~= "$" and block then
      if block.titled then block.titled, block.title = nil, l else block[#block + 1] = l end
    end
  end
  return blocks
end

local function curve(block)
  local out = { id = fields(block[1], 10)[1], title = block.title, x = {}, y = {} }
  for i = 2, #block do
    local f = fields(block[i], 20)
    out.x[i - 1], out.y[i - 1] = f[1], f[2]
  end
  return out
end

-- Radioss: "/KEY/ID" -> data lines; the first is the title.
local function radioss(text)
  local blocks, block = {}, nil
  for _, l in ipairs(lines_of(text)) do
    if l:sub(1, 1) == "/" then
      block = {}
      blocks[l] = block
    elseif l ~= "" and l:sub(1, 1) ~= "#" and block then
      block[#block + 1] = l
    end
  end
  return blocks
end

local cards = {}
local long = os.getenv "FABRICSH_TEST_LONG" -- the short form takes the two that differ most
for _, name in ipairs(long and { "blend", "denim", "duck", "muslin" } or { "blend", "duck" }) do cards[#cards + 1] = fabric.card(name) end

-- --- LS-DYNA, mm-t-s: 2nd Piola-Kirchhoff stress over Green's strain ---
for _, card in ipairs(cards) do
  local r = fabric.export.card { card = card, to = "ls-dyna", id = 7 }
  assert(r.material == "MAT_034" and r.text:sub(1, 9) == "*KEYWORD\n" and r.text:find "%*END\n$")
  for _, l in ipairs(lines_of(r.text)) do assert(l:sub(1, 1) == "$" or #l <= 80, l) end
  assert(r.text:find("Williams 2010", 1, true), "the card's source")
  local b = dyna(r.text)
  local mat = b["*MAT_FABRIC"][1]
  local one, three, six = fields(mat[1], 10), fields(mat[3], 10), fields(mat[6], 10)
  check(card.name .. " density, t/mm3", one[2], card.density * 1e-12, 1e-8)
  assert(one[1] == 7 and three[6] == 14 and six[1] == 71 and six[6] == 76)
  local curves = b["*DEFINE_CURVE"]
  assert(#curves == 6)
  local warp, weft, shear, back = curve(curves[1]), curve(curves[2]), curve(curves[3]), curve(curves[4])
  assert(warp.id == 71 and warp.title == "warp, loading" and back.title == "warp, unloading" and warp.x[1] == 0 and warp.y[1] == 0)
  for i = 2, #warp.x do assert(warp.x[i] > warp.x[i - 1] and warp.y[i] > warp.y[i - 1]) end
  local middle = 40
  check(card.name .. " S11, MPa", warp.y[middle], P(card.warp, warp.x[middle]) * 1e-6, 1e-8)
  check(card.name .. " S22, MPa", weft.y[middle], P(card.weft, weft.x[middle]) * 1e-6, 1e-8)
  check(card.name .. " S12, MPa over 2 E12", shear.y[middle], P(card.shear, shear.x[middle] / 2) * 1e-6, 1e-8)
  -- the unloading curve falls from the tested strain with the unloading modulus
  local n = #back.x - 1
  check(card.name .. " meets at the tested strain", back.x[n], card.tested.warp, 1e-8)
  check(card.name .. " unloading slope", (back.y[n] - back.y[n - 1]) / (back.x[n] - back.x[n - 1]), card.warp.unloading * 1e-6, 1e-6)
  assert(back.x[1] == 0 and back.y[1] == 0)
end

-- --- OpenRadioss in mm-kg-ms: nominal stress over engineering strain, shear over degrees ---
local blend = fabric.card "blend"
do
  local r = fabric.export.card { card = blend, to = "openradioss", units = "mm-kg-ms" }
  local b = radioss(r.text)
  local mat = b["/MAT/LAW58/1"]
  assert(mat[1] == "blend")
  check("density, kg/mm3", fields(mat[2], 20)[1], blend.density * 1e-9, 1e-10)
  local numbers = fields(mat[6]:sub(1, 20), 10)
  assert(numbers[1] == 1 and numbers[2] == 1)
  check("S1, straight yarns", fields(mat[6]:sub(21), 20)[1], 1e-4, 1e-12)
  local function funct(id)
    local x, y = {}, {}
    for i = 2, #b["/FUNCT/" .. id] do
      local f = fields(b["/FUNCT/" .. id][i], 20)
      x[#x + 1], y[#y + 1] = f[1], f[2]
    end
    return x, y
  end
  local x, y = funct(11)
  local stretch = 1 + x[30]
  check("nominal stress, GPa", y[30], stretch * P(blend.warp, (stretch ^ 2 - 1) / 2) * 1e-9, 1e-9)
  x, y = funct(13)
  assert(x[1] == -x[#x] and y[1] == -y[#y], "odd in the angle")
  local i = #x - 20
  check("shear stress at an angle", y[i], P(blend.shear, math.sin(math.rad(x[i])) / 2) * 1e-9, 1e-9)
  for _, id in ipairs { 11, 12, 13, 14, 15, 16 } do -- the starter refuses a curve that does not rise
    x, y = funct(id)
    for k = 2, #x do assert(x[k] > x[k - 1] and y[k] > y[k - 1], "function " .. id) end
  end
end

-- --- LAW158: the columns of the reader's own description (mat_158_fabric.cfg), field by field ---
for _, card in ipairs(cards) do
  local r = fabric.export.card { card = card, to = "openradioss", material = "LAW158", id = 3, units = "mm-kg-ms" }
  local same = radioss(fabric.export.card({ card = card, to = "openradioss", material = "LAW58", id = 3, units = "mm-kg-ms" }).text)
  local b = radioss(r.text)
  local mat = b["/MAT/LAW158/3"]
  assert(r.material == "LAW158" and mat[1] == card.name and #mat == 8)
  check(card.name .. ": density, kg/mm3", fields(mat[2], 20)[1], card.density * 1e-9, 1e-10)
  local crimp = fields(mat[3], 20) -- S1, S2, FLEX, FLEX1, FLEX2; where one is 0 the reader takes its default instead
  assert(#crimp == 5 and crimp[1] == 1e-4 and crimp[2] == 1e-4, mat[3])
  for k = 3, 5 do assert(crimp[k] > 0, mat[3]) end
  local switch = fields(mat[4], 10) -- ZEROSTRESS in 1 to 20, nothing in 21 to 30, the sensor in 31 to 40
  assert(tonumber(mat[4]:sub(1, 20)) == 0 and mat[4]:sub(21, 30) == (" "):rep(10) and switch[4] == 0 and #mat[4] == 40, mat[4])
  for k = 1, 3 do -- a function in 1 to 10, its scale in 21 to 40: 1, since the engine applies none
    local l = mat[4 + k]
    assert(tonumber(l:sub(1, 10)) == 30 + k and l:sub(11, 20) == (" "):rep(10) and tonumber(l:sub(21, 40)) == 1, l)
    assert(table.concat(b["/FUNCT/" .. 30 + k], "\n") == table.concat(same["/FUNCT/" .. 30 + k], "\n"), "the loading curves are those of LAW58")
    local x, y = {}, {}
    for i = 2, #b["/FUNCT/" .. 30 + k] do
      local f = fields(b["/FUNCT/" .. 30 + k][i], 20)
      x[#x + 1], y[#y + 1] = f[1], f[2]
      assert(i == 2 or x[i - 1] > x[i - 2] and y[i - 1] > y[i - 2], "the starter refuses a curve that does not rise")
    end
  end
  for k = 1, 2 do -- the springs of the crimp: a millionth of the curves' first slopes
    local second = fields(b["/FUNCT/" .. 30 + k][3], 20)
    check(("%s: FLEX%d"):format(card.name, k), crimp[3 + k] / (second[2] / second[1]), 1e-6, 1e-6)
    assert(crimp[3] >= crimp[3 + k])
  end
  assert(fields(mat[8], 10)[1] == 0 and fields(mat[8], 10)[2] == 0 and not b["/FUNCT/34"], "no functions of the crimp, none of unloading")
  -- Elastic: down it is as up, so all that the card loses between up and down is what cyclic paths lose.
  local law = r:law()
  local function S(E) return (law:stress(E, 0, 0)) end
  local E = 0.8 * card.tested.warp
  local up = S(E)
  S(card.tested.warp)
  law:commit()
  check(card.name .. ": the way down is the way up", S(E), up, 1e-9)
  assert(r.report:find("hysteresis: elastic, none", 1, true) and r.lost["cyclic warp"].work < -50, r.report)
end
-- Its law against closed forms: E11 = E22 with straight yarns; and yarns of much crimp whose sum of heights is held, so that the warp lengthens
-- without force until it is straight, while the weft takes twice its height and shortens.
do
  local laws = require "fabric.export.laws"
  local K = 1e8
  local line = { loading = { x = { 0, 1 }, y = { 0, K } } }
  local law = laws.law158 { warp = line, weft = line, shear = { loading = { x = { 0, 90 }, y = { 0, 9e6 } } }, S1 = 1e-4, S2 = 1e-4, FLEX = 1, FLEX1 = 1, FLEX2 = 1 }
  local l = 1.08
  local S11, S22, S12 = law:stress((l * l - 1) / 2, (l * l - 1) / 2, -math.sin(math.rad(30)) * l * l / 2)
  check("LAW158, straight yarns", S11, K * (l - 1.0001) / l, 1e-9)
  check("LAW158, weft alike", S22, S11, 1e-12)
  check("LAW158, 30 degrees the other way", S12, -3e6, 1e-9)
  near("LAW158, a yarn pressed together gives way", (law:stress(-0.05, 0, 0)) / K, 0, 1e-5)
  local S = 0.1
  local function crimped() return laws.law158 { warp = line, weft = line, shear = line, S1 = S, S2 = S, FLEX = 1e4 * K, FLEX1 = 1e-6, FLEX2 = 1e-6 } end
  local long, short = (1 + S) * 1.05, math.sqrt((1 + S) ^ 2 - 4 * ((1 + S) ^ 2 - 1))
  local given = crimped()
  S11, S22 = given:stress((long ^ 2 - 1) / 2, (short ^ 2 - 1) / 2, 0)
  check("LAW158, crimp exchanged: the warp", S11, K * (long - 1 - S) / long, 1e-3)
  near("LAW158, crimp exchanged: the weft is free", S22 / S11, 0, 1e-3)
  -- It is elastic: dS11/dE22 = dS22/dE11 where the yarns are half straight.
  local soft = { warp = line, weft = { loading = { x = { 0, 1 }, y = { 0, 2 * K } } }, shear = line, S1 = 0.05, S2 = 0.08, FLEX = 3e6, FLEX1 = 1e6, FLEX2 = 2e6 }
  local function at(E11, E22) return laws.law158(soft):stress(E11, E22, 0) end
  local h = 1e-5
  local across = (select(1, at(0.06, 0.03 + h)) - select(1, at(0.06, 0.03 - h))) / (2 * h)
  local back = (select(2, at(0.06 + h, 0.03)) - select(2, at(0.06 - h, 0.03))) / (2 * h)
  assert(across > 0.01 * K, across)
  check("LAW158, coupling is symmetric", across, back, 1e-6)
end

-- --- Abaqus in SI: stress first ---
do
  local r = fabric.export.card { card = blend, to = "abaqus", units = "SI" }
  local data, part = {}, nil
  for _, l in ipairs(lines_of(r.text)) do
    if l:find "^%*UNIAXIAL" then part = l:match "COMPONENT=(%w+)" end
    if l:find "^%*[^*]" then data[#data + 1] = { word = l, part = part } end
    local y, x = l:match "^([-%d.e+]+), ([-%d.e+]+)$"
    if y then table.insert(data[#data], { tonumber(x), tonumber(y) }) end
  end
  local function of(part, word, k)
    for _, d in ipairs(data) do
      if d.part == part and d.word:find(word, 1, true) then
        k = (k or 1) - 1
        if k == 0 then return d end
      end
    end
  end
  local loading, unloading, shear = of("1", "*LOADING"), of("1", "*UNLOADING"), of("SHEAR", "*LOADING")
  assert(loading.word:find "PERMANENT DEFORMATION" and unloading.word:find "SHIFTED CURVE" and of("SHEAR", "*LOADING", 2).word:find "COMPRESSION")
  local x, y = loading[30][1], loading[30][2]
  check("nominal stress, Pa", y, (1 + x) * P(blend.warp, (1 + x) ^ 2 / 2 - 0.5), 1e-8)
  x, y = shear[30][1], shear[30][2]
  check("stress conjugate to the angle", y, math.cos(x) * P(blend.shear, math.sin(x) / 2), 1e-8)
  assert(unloading[1][1] == 0 and math.abs(unloading[1][2]) < 1)
end

-- --- losses ---
for _, card in ipairs(cards) do
  for _, target in ipairs { { "ls-dyna", "MAT_034", 0.1 }, { "ls-dyna", "MAT_235" }, { "openradioss", "LAW58", 0.7 }, { "openradioss", "LAW158", 0.7 },
    { "openradioss", "LAW19" }, { "abaqus", "FABRIC", 0.1 } } do
    local r = fabric.export.card { card = card, to = target[1], material = target[2] }
    local label = card.name .. " " .. target[2]
    assert(#r.losses == 7 and r.lost["cyclic shear"].words and #r.sentences >= 4, label)
    for _, row in ipairs(r.losses) do
      assert(row.worst == row.worst and row.worst < 2000 and row.rms <= row.worst and row.peak > 0, label .. " " .. row.path)
    end
    if target[3] then -- laws with curves give uniaxial tension back; what couples the axes or turns the shear does not go over
      near(label .. " warp, per cent", r.lost.warp.worst, 0, target[3])
      near(label .. " weft, per cent", r.lost.weft.worst, 0, target[3])
      assert(r.lost.biaxial.worst > 3 and r.lost["cyclic shear"].worst > 30, label)
    else
      assert(r.lost.warp.worst > 20 or r.lost.weft.worst > 20, label)
    end
    -- 1:1: the card is stiffer by c (nu12 + 1) E, S22 by c (nu21 + 1) E, which is what is lost
    if target[2] == "MAT_034" then
      local E, n12, n21 = math.min(card.tested.warp, card.tested.weft), card.warp.poisson, card.weft.poisson
      local c = math.min(n21 * card.warp.loading[1], n12 * card.weft.loading[1]) / (1 - n12 * n21)
      local most = math.max(c * (n12 + 1), c * (n21 + 1)) * E
      local peak = math.max(P(card.warp, E) + c * (n12 + 1) * E, P(card.weft, E) + c * (n21 + 1) * E)
      check(label .. " 1:1 by hand", r.lost.biaxial.worst, 100 * most / peak, 5e-3)
    end
  end
end
-- Bending with friction is named as lost.
local soft = blend:with { bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6, friction_warp = { moment = 1e-4, curvature = 5 } } }
local r = fabric.export.card { card = soft, to = "ls-dyna" }
assert(r.report:find("bending friction: lost", 1, true) and tostring(r) == r.report)

-- Bending that changes with the curvature, as coefficients or as measured points, is told by that of the flat sheet.
for _, warp in ipairs { { 2e-5, -1e-7 }, { { 0, 0 }, { 50, 1e-3 }, { 100, 1.5e-3 } } } do
  r = fabric.export.card { card = blend:with { bending = { warp = warp, weft = 1e-5, twist = 5e-6 } }, to = "ls-dyna" }
  assert(r.report:gsub("%s+", " "):find("(the card's rigidity: warp 2e-05 and changing with the curvature, weft 1e-05, twist 5e-06 N.m)", 1, true), r.report)
end

-- The comparison laws follow their path: they are loaded in steps, and unload from there with the card's modulus, to a residual strain.
for _, law in ipairs { "incremental", "thesis" } do
  local card = blend:with { law = law }
  for _, to in ipairs { { "ls-dyna", "MAT_034" }, { "openradioss", "LAW58" }, { "openradioss", "LAW158" }, { "abaqus", "FABRIC" } } do
    r = fabric.export.card { card = card, to = to[1], material = to[2] }
    near(("%s law, %s: warp, per cent"):format(law, to[2]), r.lost.warp.worst, 0, 2)
    assert(r.report:find(("law: the card's '%s' law was sampled"):format(law), 1, true), r.report)
  end
  local meet, back = r.parameters.warp.meet, r.parameters.warp
  local stretch = 1 + meet[1]
  local residual = card.tested.warp - meet[2] / stretch / card.warp.unloading
  check(law .. " law: residual strain of the warp", back.residual, residual, 1e-2)
end

-- Breaking yarns: the stress falls between two nominal strains, and an element pulled apart spends what the card says. The force per width is E t e along
-- a straight spring in the card's own measure, S (1 + e), which is integrated by hand.
do
  local strength, energy = 6e3, 15
  local breaks = blend:with { rupture = { warp = { strength = strength, energy = energy, scatter = { modulus = 9 } }, weft = { strength = 0.8 * strength, energy = energy } } }
  for _, law in ipairs { "LAW58", "LAW158" } do
    local out = fabric.export.card { card = breaks, to = "openradioss", material = law, element = 2e-3, id = 3 }
    local line = out.text:match "/FAIL/FABRIC/3\n#[^\n]*\n([^\n]*)\n"
    local f1, r1, f2, r2 = table.unpack(fields(line, 20))
    local function force(e) return fabric.point(blend):uniaxial("warp", e + e * e / 2).S * (1 + e) * blend.thickness end
    check(law .. ": force per width where the warp begins to fail, N/m", force(tonumber(f1)), strength, 1e-3)
    local last = (force(f1) - force(f1 - 1e-3)) / 1e-3
    local spent, n = 0, 2000
    for i = 1, n do -- the middle of each part
      local e = (i - 0.5) / n * r1
      spent = spent + r1 / n * (e < f1 + 0 and force(e) or (strength + last * (e - f1)) * (1 - (e - f1) / (r1 - f1)))
    end
    check(law .. ": energy of an element pulled apart, J/m", 2e-3 * spent, energy, 5e-3)
    assert(tonumber(f2) < tonumber(r2) and out.report:find("the scatter of the warp is lost", 1, true) and out.report:gsub("%s+", " "):find("on elements of 0.002 m along it", 1, true))
  end
  -- LAW19 carries E11 ln(1 + e) over the width (1 + e)^-nu12; its element fails by damage D = (to / e) (e - from) / (to - from)
  local little = 6
  local out = fabric.export.card { card = blend:with { rupture = { warp = { strength = strength, energy = little }, weft = { strength = 0.8 * strength, energy = little } } }, to = "openradioss",
    material = "LAW19", element = 2e-3, id = 3 }
  local lines = {}
  for line in (out.text:match "/FAIL/ORTHSTRAIN/3\n(.*)"):gmatch "[^\n]+" do
    if line:sub(1, 1) ~= "#" then lines[#lines + 1] = line end
  end
  assert(#lines == 9 and tonumber(lines[1]:sub(21, 40)) == 1 and tonumber(lines[1]:sub(91, 100)) == 2)
  local p = out.parameters
  for k, yarn in ipairs { "warp", "weft" } do
    local from, to = tonumber(lines[3 + k]:sub(1, 20)), tonumber(lines[3 + k]:sub(21, 40))
    local E, nu = k == 1 and p.E11 or p.E22, k == 1 and p.NU12 or p.NU12 * p.E22 / p.E11
    local function force(e) return E * math.log(1 + e) * (1 + e) ^ -nu * blend.thickness end
    check("LAW19: force per width where the " .. yarn .. " begins to fail, N/m", force(from), (k == 1 and 1 or 0.8) * strength, 1e-3)
    local spent, n = 0, 4000
    for i = 1, n do
      local e = (i - 0.5) / n * to
      spent = spent + to / n * force(e) * (e < from and 1 or 1 - to / e * (e - from) / (to - from))
    end
    check("LAW19: energy of an element pulled apart along the " .. yarn .. ", J/m", 2e-3 * spent, little, 5e-3)
  end
  assert(not out.report:find "spends less than that")
  local much = fabric.export.card { card = breaks, to = "openradioss", material = "LAW19", element = 1e-3 }
  assert(much.report:gsub("%s+", " "):find("for the weft spends less than that: its strains are cut at", 1, true), much.report)
  for k = 6, 9 do assert(tonumber(lines[k]:sub(1, 20)) == 1e20 and tonumber(lines[k]:sub(51, 70)) == 1e20) end
  assert(out.report:gsub("%s+", " "):find("an element is removed when one family has failed", 1, true), out.report)
  for _, target in ipairs { { "openradioss", "LAW58", "element=h" }, { "ls-dyna", "MAT_034", "*MAT_ADD_EROSION would remove whole elements" }, { "abaqus", "FABRIC", "nothing written breaks" } } do
    local out = fabric.export.card { card = breaks, to = target[1], material = target[2] }
    assert(out.report:gsub("%s+", " "):find(target[3], 1, true) and not out.text:find("/FAIL", 1, true), out.report)
  end
end

-- A St. Venant-Kirchhoff card goes to *ELASTIC whole, to LAW19 but for the measure.
local svk = fabric.svk { warp = 8e6, weft = 37e6, shear = 1e6, poisson = { 0.25, 0.42 }, density = 590, thickness = 0.38e-3 }
r = fabric.export.card { card = svk, to = "abaqus" }
assert(r.material == "ELASTIC")
for _, row in ipairs(r.losses) do near("SVK, " .. row.path, row.worst, 0, 1e-5) end
r = fabric.export.card { card = svk, to = "openradioss" }
assert(r.material == "LAW19" and r.lost.warp.worst > 1)
-- R_E in columns 1 to 20, nothing up to 40, ZEROSTRESS, FSCALE_POR, the sensor in 81 to 90; each name ends with its number
local names, numbers = r.text:match "\n(#[^\n]*ZEROSTRESS[^\n]*)\n([^\n]*)"
assert(names:find("R?E", 18) and select(2, names:find "ZEROSTRESS") == 60 and select(2, names:find "FSCALE_POR") == 80 and #names == 90 and #numbers == 90, names)
assert(numbers:sub(21, 40):match "^ +$" and tonumber(numbers:sub(41, 60)) == 0 and tonumber(numbers:sub(81, 90)) == 0)

-- --- files and refusals ---
local path = os.tmpname() .. ".k"
r = fabric.export.card { card = blend, to = "ls-dyna", material = "*MAT_34", file = path }
local f = assert(io.open(path))
assert(f:read "a" == r.text)
f:close()
os.remove(path)
local function wrong(words, t)
  local good, message = pcall(fabric.export.card, t)
  assert(not good and tostring(message):find(words, 1, true), "expected: " .. words .. "\ngot: " .. tostring(message))
end
wrong("card: field 'to': expected 'ls-dyna' or 'openradioss' or 'abaqus', got 'lsdyna', did you mean 'ls-dyna'?", { card = blend, to = "lsdyna" })
wrong("card: field 'to': expected", { card = blend })
wrong("field 'material': expected MAT_034 or MAT_235 for ls-dyna, got 'MAT_58'", { card = blend, to = "ls-dyna", material = "MAT_58" })
wrong("field 'card': MAT_235 takes no card of the law 'svk'; such a card goes to LAW19 (openradioss), ELASTIC (abaqus)",
  { card = svk, to = "ls-dyna", material = "MAT_235" })
wrong("field 'card': ls-dyna takes no card of the law 'svk'", { card = svk, to = "ls-dyna" })
wrong("field 'units': expected 'mm-t-s' or 'mm-kg-ms' or 'SI', got 'inch'", { card = blend, to = "ls-dyna", units = "inch" })
wrong("/proc/nowhere", { card = blend, to = "abaqus", file = "/proc/nowhere/card.inp" })
wrong("field 'card'", { card = "blend", to = "abaqus" })
wrong("card: field 'element': the card 'blend' has no rupture", { card = blend, to = "openradioss", element = 2e-3 })
wrong("card: field 'element': an element of 0.5 m has spent more than the energy of the warp, 15 J/m, when it begins to fail: expected at most",
  { card = blend:with { rupture = { warp = { strength = 6e3, energy = 15 } } }, to = "openradioss", element = 0.5 })
for _, axis in ipairs { { 0, 0, 0 }, { 1, 0 }, { 1, 2, 3, 4 } } do
  wrong(("card: field 'axis': expected a direction {x, y, z} other than zero, got {%s}"):format(table.concat(axis, ", ")), { card = blend, to = "ls-dyna", axis = axis })
end
fabric.expect(rows)
