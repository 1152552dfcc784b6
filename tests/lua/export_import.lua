-- fabric.import.card: what was exported comes back as a card that answers alike; files written by hand; files that lie.
local fabric = require "fabric"
local rows = {}
local function check(label, got, want, relative) rows[#rows + 1] = { label, got, want, relative = relative } end
local function near(label, got, want, absolute) rows[#rows + 1] = { label, got, want, absolute = absolute } end

for _, name in ipairs { "blend", "denim", "duck", "muslin" } do
  local card = fabric.card(name)
  for _, to in ipairs { "openradioss", "abaqus" } do
    local file = name .. (to == "abaqus" and ".inp" or ".rad")
    fabric.export.card { card = card, to = to, file = file, units = "mm-kg-ms" }
    local r = fabric.import.card { file = file, units = "mm-kg-ms", thickness = card.thickness, poisson = { card.warp.poisson, card.weft.poisson },
      tested = card.tested }
    local back, label = r.card, name .. ", " .. to
    assert(back.name == name and back.source:find(file, 1, true) and #r.losses == 7, label)
    check(label .. ": density", back.density, card.density, 1e-9)
    check(label .. ": warp unloading", back.warp.unloading, card.warp.unloading, 0.02)
    check(label .. ": weft unloading", back.weft.unloading, card.weft.unloading, 0.02)
    check(label .. ": shear unloading", back.shear.unloading, card.shear.unloading, 0.08)
    check(label .. ": tested warp", back.tested.warp, card.tested.warp, 1e-3)
    for _, axis in ipairs { "warp", "weft" } do
      local E = 0.7 * card.tested[axis]
      check(("%s: S at %.3g, %s"):format(label, E, axis), fabric.point(back):uniaxial(axis, E).S, fabric.point(card):uniaxial(axis, E).S, 1e-3)
    end
    check(label .. ": S12", fabric.point(back):strain({ E12 = 0.2 }).S12, fabric.point(card):strain({ E12 = 0.2 }).S12, 1e-3)
    near(label .. ": the file's law beside the card, warp", r.lost.warp.worst, 0, 0.7)
    assert(r.lost["cyclic shear"].worst > 20 and tostring(r) == r.report)
    -- Without `tested` the strains come from the file's own comment, which has four digits.
    local alone = fabric.import.card { file = file, thickness = card.thickness, poisson = { card.warp.poisson, card.weft.poisson } }
    for _, part in ipairs { "warp", "weft", "shear" } do
      check(("%s: tested %s from the comment"):format(label, part), alone.card.tested[part], card.tested[part], 1e-3)
      check(("%s: unloading of the %s from there"):format(label, part), alone.card[part].unloading, card[part].unloading, part == "shear" and 0.08 or 0.02)
    end
    assert(not alone.report:find("along a curve", 1, true) and not alone.report:find("tested:", 1, true), alone.report)
  end
end

-- Without functions, in the example of the manual's kind: E1 x - B1 x^2 / 2, shear in two parts.
local function write(name, text)
  fabric.write(name, text)
  return name
end
local function wide(...)
  local out = {}
  for i, v in ipairs { ... } do out[i] = ("%20s"):format(v) end
  return table.concat(out)
end
local function plain(density, third)
  return table.concat({ "#RADIOSS STARTER", "/MAT/FABR_A/1/1", "by hand", wide(density), wide("4.5e8", "1e8", "3e8", "0", "0.01"),
    third or wide("1e6", "1e8", "60", "0"), wide("0", "0", "0"), ("%10d%10d"):format(1, 1) .. wide("1e-4", "1e-4"), "/END" }, "\n") .. "\n"
end
local r = fabric.import.card { file = write("plain.rad", plain "722.5"), units = "SI", thickness = 3e-4, density = 700 }
assert(r.card.name == "by hand" and r.card.density == 700 and #r.notes == 5, #r.notes)
assert(r.notes[1]:find("says up to which strains warp, weft, shear was measured; the ends of the curves were taken", 1, true), r.notes[1])
local e = 0.05
local E = e + e * e / 2
check("nominal stress by hand", (1 + e) * fabric.point(r.card):uniaxial("warp", E).S, (4.5e8 - 1e8 * e / 2) * e, 1e-3)
check("shear below the lock", fabric.point(r.card):strain({ E12 = 0.1 }).S12, 1e6 * math.tan(math.asin(0.2)), 1e-3)

-- A card with a curved loop: the file has its way down, the card that comes back a straight line from the same peak to the same rest, and says so.
local MPa = fabric.units.MPa
local looped = fabric.card("blend"):with { warp = { unloading = 300 * MPa, loop = { friction = 0.3, reach = 0.5, curve = 0.6 } } }
for _, file in ipairs { "looped.rad", "looped.inp" } do
  local e = fabric.export.card { card = looped, to = file:find "rad" and "openradioss" or "abaqus", file = file }
  assert(e.report:gsub("\n *", " "):find("curved loops: of the warp .* its loop %(friction 0.3, reach 0.5, curve 0.6%), and those inside it, are lost"), e.report)
  local l = fabric.import.card { file = file, thickness = looped.thickness, poisson = { 0.25, 0.42 }, tested = looped.tested }
  check(file .. ": modulus of the whole way down", l.card.warp.unloading, 300 * MPa, 0.02)
  assert(#l.notes == 1 and l.notes[1]:find "^warp: the file unloads along a curve, 2%d.%d %% of its peak stress off the straight line"
    and l.notes[1]:find "a stress%-strain loop is lost: card:with{ warp={ loop={...} } gives one" and l.report:find("- warp: the file unloads along a curve", 1, true), l.report)
end

-- What else has no place in another solver's law is said.
local rich = fabric.card("blend"):with { viscous = { shear = { modulus = 5 * MPa, time = 10 } }, compression = { { 0.3e-3, 1e3 }, { 0.2e-3, 1e5 } } }
local said = fabric.export.card({ card = rich, to = "abaqus" }).report:gsub("\n *[*]* *", " ")
assert(said:find("relaxation: the part of shear that relaxes (5e+06 Pa in 10 s) is lost; what is written is shear too quick for any of it to relax", 1, true), said)
check("sampled shear is the quick one", fabric.point(rich):strain({ E12 = 0.1 }).S12 - fabric.point(fabric.card "blend"):strain({ E12 = 0.1 }).S12, 5 * MPa * 0.1, 1e-12)
assert(said:find("compression: how the cloth is pressed is lost", 1, true), said)

-- Where no comment says up to which strain the cloth was tested, the ends of the curves are taken and a note says so; what is not tested is let go
-- where the export did; a comment with no number is an error.
do
  fabric.export.card { card = fabric.card "duck", to = "abaqus", file = "tested.inp" }
  local text = io.open("tested.inp"):read "a"
  fabric.write("ends.inp", (text:gsub("[^\n]*Tested up to[^\n]*\n", "")))
  local duck = { thickness = 0.62e-3, poisson = { 0.99, 0.68 } }
  local function import(file, tested) return fabric.import.card { file = file, thickness = duck.thickness, poisson = duck.poisson, tested = tested } end
  local ends = import "ends.inp"
  assert(#ends.notes == 1 and ends.notes[1]:find("nor tested= says up to which strains warp, weft, shear was measured", 1, true), ends.report)
  check("duck, no comment: the end of the warp's curve", ends.card.tested.warp, 1.3 * fabric.card "duck".tested.warp, 1e-3)
  local some = import("ends.inp", { warp = 0.0818 })
  assert(#some.notes == 1 and some.notes[1]:find("up to which strains weft, shear was measured", 1, true), some.report)
  check("duck, warp asked for", some.card.tested.warp, 0.0818, 1e-6)
  fabric.write("untested.inp", (text:gsub("E12 = 0.3;", "E12 = x;")))
  local ok, message = pcall(import, "untested.inp")
  assert(not ok and tostring(message):find("card: untested.inp:7: expected a tested strain of the shear from 0 to below 0.5, got", 1, true), tostring(message))
  local aramid = fabric.card "aramid"
  fabric.export.card { card = aramid, to = "abaqus", file = "aramid.inp" }
  local r = fabric.import.card { file = "aramid.inp", thickness = aramid.thickness, poisson = { 0, 0 } }
  check("aramid: shear that was not tested", r.card.tested.shear, 0.2, 1e-9)
  assert(#r.notes == 1 and r.notes[1]:find "^shear: line %d+ of the file says that it was not tested", r.report)
end

-- A law of constants takes secants: nothing is said there of curves that are written.
do
  local rubbing = looped:with { shear = { friction = { stress = 1e4, growth = 1e4 } } }
  for _, to in ipairs { { "ls-dyna", "MAT_235" }, { "openradioss", "LAW19" }, { "ls-dyna", "MAT_034" } } do
    local words = table.concat(fabric.export.card({ card = rubbing, to = to[1], material = to[2] }).sentences, "\n")
    local curves = to[2] == "MAT_034"
    assert((words:find("to zero stress is written", 1, true) ~= nil) == curves, words)
    assert((words:find("its ways up and down", 1, true) ~= nil) == curves, words)
    assert((words:find("the warp loads and unloads along one straight line there", 1, true) ~= nil) ~= curves, words)
    assert((words:find("only the secant at the tested shear is written", 1, true) ~= nil) ~= curves, words)
  end
end

-- Units that the file states: in a comment, or in /BEGIN.
local sheet = fabric.model { mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 1, ny = 1 }, card = fabric.card "blend", warp = 0 }
sheet:fix("bottom", "x y z")
for _, units in ipairs { "mm-t-s", "mm-kg-ms", "SI" } do
  fabric.export.card { card = fabric.card "blend", to = "abaqus", file = "said.inp", units = units }
  fabric.export.model { model = sheet, warp = 0, file = "said.rad", units = units }
  fabric.write("begin.rad", (fabric.export.model({ model = sheet, warp = 0, to = "openradioss", units = units }).text:gsub("#[^\n]*\n", "")))
  for _, file in ipairs { "said.inp", "said.rad", "begin.rad" } do assert(require "fabric.export.read_deck".units(file).name == units, file) end
end
for _, file in ipairs { "said.inp", "begin.rad" } do
  local one = fabric.import.card { file = file, thickness = file == "said.inp" and 0.38e-3 or nil }
  check(file .. " in SI, as it states: density", one.card.density, 590, 1e-9)
  check(file .. " in SI, as it states: thickness", one.card.thickness, 0.38e-3, 1e-9)
end
local grams = io.open("begin.rad"):read("a"):gsub("( +)kg( +) m( +) s\n", "%1 g%2mm%3ms\n")
fabric.write("grams.rad", grams)
check("units of no name, g mm ms: 1 MPa is", require "fabric.export.read_deck".units("grams.rad").stress * MPa, 1, 1e-12)

-- Refusals with file and line.
local function wrong(words, t)
  local good, message = pcall(fabric.import.card, t)
  assert(not good and tostring(message):find(words, 1, true), "expected: " .. words .. "\ngot: " .. tostring(message))
end
local function with(file) return { file = file, thickness = 3e-4, units = "SI" } end
wrong("card: cannot read 'none.rad': No such file or directory", with "none.rad")
wrong("card: field 'file': expected a name that ends in .rad or .inp, or field 'from', got 'plain.k'", with "plain.k")
wrong("card: field 'thickness': expected a positive number in m (plain.rad has no section), got nil", { file = "plain.rad", units = "SI" })
wrong("card: bad.rad:4: expected a number in columns 1 to 20, got 'heavy'", with(write("bad.rad", plain "heavy")))
wrong("card: bad.rad:6: expected a number in columns 1 to 20, got 'soft'", with(write("bad.rad", plain("722.5", wide("soft", "1e8", "60", "0")))))
wrong("there is no /MAT/LAW58 (or /MAT/FABR_A)", with(write("empty.rad", "#RADIOSS STARTER\n/END\n")))
wrong("card: short.rad:1: expected a title and at least five lines of LAW58", with(write("short.rad", "/MAT/LAW58/1\nshort\n")))
wrong("there is no *FABRIC", with(write("none.inp", "*MATERIAL, NAME=a\n*DENSITY\n600.,\n")))
wrong("card: field 'units': expected the units that said.inp states, 'SI' (line 3: Units: m, kg, s, N, Pa (SI)), got 'mm-t-s'; without the field they are taken from there",
  { file = "said.inp", thickness = 3e-4, units = "mm-t-s" })
wrong("card: field 'units': expected the units that grams.rad states, 'g, mm, ms' (line 4: /BEGIN with g, mm, ms), got 'SI'", with "grams.rad")
wrong("card: field 'units': words.rad states units that were not understood (line 4: /BEGIN with '",
  { file = write("words.rad", (grams:gsub("    g( +mm)", "stone%1", 1))), thickness = 3e-4 })
local stated = require "fabric.export.read_deck".units
local function units_in(first) return stated(write("units.inp", first .. "\n")) end
for _, words in ipairs { "** Units: kg, mm, ms", "** Units: mm, ms, kg (ms-kg-mm)", "** Units: (mm-kg-ms)" } do assert(units_in(words).name == "mm-kg-ms", words) end
wrong("card: units.inp:1: expected units and a name in brackets that agree, got 'Units: mm, t, s (mm-kg-ms)'", with(write("units.inp", "** Units: mm, t, s (mm-kg-ms)\n")))
wrong("units.inp states units twice that do not agree: line 1: Units: mm, t, s, and line 2: Units: m, kg, s", with(write("units.inp", "** Units: mm, t, s\n** Units: m, kg, s\n")))
wrong("units.inp states units that were not understood (line 1: Units: furlongs)", { file = write("units.inp", "** Units: furlongs\n"), thickness = 3e-4 })
wrong("there is no *FABRIC", with "units.inp") -- units= of the deck stands where the file's are not understood
local head = "*MATERIAL, NAME=a\n*DENSITY\n600.,\n*FABRIC\n*UNIAXIAL, COMPONENT=1\n*LOADING DATA\n"
wrong("card: order.inp:8: expected a strain above 0.1, got 0.05", with(write("order.inp", head .. "1e6, 0.1\n2e6, 0.05\n")))
wrong("card: word.inp:7: expected a stress and a strain, got 'one, two'", with(write("word.inp", head .. "one, two\n")))
wrong("card: word.inp:5: expected COMPONENT=1, 2 or SHEAR", with(write("word.inp", (head:gsub("COMPONENT=1", "COMPONENT=3")))))
wrong("expected DEFINITION=SHIFTED CURVE, got 'QUADRATIC'", with(write("un.inp", head .. "0., 0.\n1e6, 0.1\n*UNLOADING DATA, DEFINITION=QUADRATIC\n")))
wrong("*FABRIC has no *LOADING DATA in tension for the weft", with(write("half.inp", head .. "0., 0.\n1e6, 0.1\n")))
fabric.expect(rows)

-- A card's own `tested` is taken as it stands: 0 says that a part was not tested.
do
  local aramid = fabric.card "aramid"
  assert(aramid.tested.shear == 0)
  fabric.export.card { card = aramid, to = "openradioss", file = "aramid.rad" }
  local r = fabric.import.card { file = "aramid.rad", thickness = aramid.thickness, poisson = { 0, 0 }, tested = aramid.tested }
  local free = fabric.import.card { file = "aramid.rad", thickness = aramid.thickness, poisson = { 0, 0 } }
  assert(math.abs(r.card.tested.warp / aramid.tested.warp - 1) < 1e-4 and r.card.tested.shear == free.card.tested.shear)
end
