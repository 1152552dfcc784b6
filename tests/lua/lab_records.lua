-- Records as frames of other countries write them, readings that stand alone, toes, specimens that differ, and a measured curve beside a simulated one.
local fabric = require "fabric"
local lab = fabric.lab
local draw = require "fabric.lab.random" (17)
local said = {}
fabric.warn = function(words) said[#said + 1] = words end

local function close(got, want, relative, what)
  assert(math.abs(got - want) <= relative * math.abs(want), ("%s: %g, want %g"):format(what or "value", got, want))
end
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails
local function read(text, more)
  local path = os.tmpname() .. ".csv"
  local f <close> = assert(io.open(path, "w"))
  f:write(text)
  f:flush()
  local t = { file = path }
  for k, v in pairs(more or {}) do t[k] = v end
  local ok, record = pcall(lab.read, t)
  os.remove(path)
  if not ok then error(record, 0) end
  return record
end

-- strains in the units that frames write; one that is not known is an error, as nothing else says how far the specimen was pulled
for unit, size in pairs { Prozent = 1e-2, percent = 1e-2, pct = 1e-2, ["\u{2030}"] = 1e-3, ["mm/m"] = 1e-3, ["um/m"] = 1e-6, ["\u{b5}m/m"] = 1e-6, ["in/in"] = 1 } do
  local r = read(("Dehnung [%s];Kraft [N]\n0;0\n0,2;3\n0,5;7\n"):format(unit), { gauge_length = 0.1 })
  assert(math.abs(r.strain[3] / (0.5 * size) - 1) < 1e-12 and math.abs(r.displacement[3] / (0.05 * size) - 1) < 1e-12, unit)
end
fails("column 'Dehnung': expected the unit of the strain (one of %, -, 1, ", read, "Dehnung [Zoll];Kraft [N]\n0;0\n0,2;3\n0,5;7\n", { gauge_length = 0.1 })
fails("got 'Zoll'; give units={ strain='...' }", read, "Dehnung [Zoll];Kraft [N]\n0;0\n0,2;3\n0,5;7\n", { gauge_length = 0.1 })

-- a mass is no force, and the remedy is named; a column of the time that cannot be read is left out with a warning
for mass, force in pairs { kg = "kgf", g = "gf" } do
  local text = ("Weg (mm);Kraft (%s)\n0;0\n2;3\n"):format(mass)
  fails(("column 'Kraft': '%s' is a unit of mass, expected one of force; for the weight of that mass give units={ force='%s' }"):format(mass, force), read, text)
  close(read(text, { units = { force = force } }).force[2], mass == "kg" and 29.41995 or 0.02941995, 1e-12)
end
do
  local before = #said
  local r = read "Zeit (s);Weg (mm);Kraft (N)\n0.5;0,0;0,0\n1.5;1,5;2,5\n2.5;2,5;3,5\n"
  assert(r.time == nil and r.force[3] == 3.5 and #said == before + 1)
  assert(said[#said]:find("the time is left out, since its column cannot be read: .*expected a finite number with a decimal comma, got '0.5'"), said[#said])
end

-- Zwick, Instron, Shimadzu, Mesdan, in their languages, as UTF-8, Latin 1 and Shift-JIS
for _, heading in ipairs {
  "Pr\u{fc}fzeit;Standardweg;Standardkraft\ns;mm;N", "Pr\xfcfzeit;Weg;Kraft\ns;mm;N", "Zeit (s);Verl\u{e4}ngerung (mm);Pr\u{fc}fkraft (N)",
  "Tempo (s);Spostamento (mm);Forza (N)", "tempo [s];Allungamento [mm];Carico [N]", "Czas [s];Przemieszczenie [mm];Si\u{142}a [N]",
  "CZAS (s);WYD\u{141}U\u{17b}ENIE (mm);OBCI\u{104}\u{17b}ENIE (N)", "Temps (s);Allongement (mm);Charge (N)",
  "\u{6642}\u{9593};\u{5909}\u{4f4d};\u{8a66}\u{9a13}\u{529b}\nsec;mm;N", "\u{6642}\u{9593}(\u{79d2});\u{30b9}\u{30c8}\u{30ed}\u{30fc}\u{30af}(mm);\u{8377}\u{91cd}(N)",
  "\x8e\x9e\x8a\xd4;\x83X\x83g\x83\x8d\x81[\x83N;\x8e\x8e\x8c\xb1\x97\xcd\nsec;mm;N", "Time (sec);Stroke (mm);Force (N)",
  "Zeit in s;Verformung in mm;Kraft in N", "Zeit;Dehnung;Standardkraft\ns;mm;N", "Temps (s);D\u{e9}formation (mm);Effort (N)",
  "Czas [s];Wyd\xb3u\xbfenie [mm];Si\xb3a [N]", "\u{6642}\u{9593}(s);\u{ff7d}\u{ff84}\u{ff9b}\u{ff70}\u{ff78}(mm);\u{8377}\u{91cd}(N)",
  "Tempo (s);Deformazione (mm);Forza (N)",
} do
  local r = read(heading .. "\n0;0;0\n1;2,5;3,5\n2;5;7\n")
  assert(r.time[2] == 1 and math.abs(r.displacement[2] - 2.5e-3) < 1e-18 and r.force[2] == 3.5, heading)
end

-- strains alone, forces per width
local r = read("Elongation (%),Load (N/5cm)\n0,0\n2,100\n4,210\n", { gauge_length = 0.2, width = 0.03 })
close(r.displacement[2], 4e-3, 1e-15)
close(r.force[2], 60, 1e-15)
assert(r.from_strain and math.abs(r.strain[2] - 0.02) < 1e-17)
-- as laboratories of textiles write them
for unit, newton in pairs { daN = 10, DaN = 10, cN = 0.01, gf = 9.80665e-3, kgf = 9.80665, lbf = 4.4482216152605, ozf = 4.4482216152605 / 16 } do
  close(read(("Extension (mm),Load (%s)\n0,0\n2,100\n4,210\n"):format(unit)).force[2] / newton, 100, 1e-12)
end
for unit, newton in pairs { ["daN/5cm"] = 200, ["daN/5 cm"] = 200, ["N/5 cm"] = 20, ["kgf/5cm"] = 196.133, ["lbf/in"] = 4.4482216152605 / 0.0254, ["lb/in"] = 4.4482216152605 / 0.0254,
  ["mN/mm"] = 1, ["cN/cm"] = 1, ["gf/cm"] = 0.980665, ["kgf/2.5 cm"] = 9.80665 / 0.025, ["ozf / in."] = 4.4482216152605 / 16 / 0.0254, ["N / 30 mm"] = 1 / 0.03,
  ["kN/m"] = 1e3 } do
  close(read(("Extension (mm),Load (%s)\n0,0\n2,100\n4,210\n"):format(unit), { width = 0.5 }).force[2] / newton, 50, 1e-12)
end
fails("expected the unit of the force (one of N, cN, daN, gf, kN, kgf, lbf, mN, ozf; per width one of these over a length, as N/mm or kgf/5cm), got 'cN/tex'", read, "Extension (mm),Force (cN/tex)\n0,0\n2,100\n4,210\n")
for _, unit in ipairs { "N/0cm", "N/1.2.3cm", "N/", "/mm", "N/kg", "N/mm/mm" } do
  fails(("got '%s'"):format(unit), read, ("Extension (mm),Load (%s)\n0,0\n2,100\n4,210\n"):format(unit), { width = 0.5 })
end
-- a user's unit composes too, and a user's own pound is no guess
close(read("Extension (mm),Load (pdl/cm)\n0,0\n2,100\n4,210\n", { width = 0.5, vocabulary = { units = { force = { pdl = 0.138254954 } } } }).force[2], 100 * 0.138254954 * 50, 1e-12)
-- pounds and ounces of a force column are told to be taken for forces, lbf and ozf are not
local told, warn = {}, fabric.warn
fabric.warn = function(words) told[#told + 1] = words end
for _, unit in ipairs { "lbf", "ozf", "lbf/in", "N" } do read(("Extension (mm),Load (%s)\n0,0\n2,100\n"):format(unit), { width = 0.5 }) end
read("Extension (mm),Load (lb)\n0,0\n2,100\n", { vocabulary = { units = { force = { lb = 4.5 } } } })
assert(#told == 0, told[1])
for i, pair in ipairs { { "lb", "lbf" }, { "lbs", "lbf" }, { "oz", "ozf" }, { "lb/in", "lbf" } } do
  read(("Extension (mm),Load (%s)\n0,0\n2,100\n"):format(pair[1]), { width = 0.5 })
  local words = ("column 'Load': '%s' is a unit of mass; it is taken for the force %s"):format(pair[1]:match "^%a+", pair[2])
  assert(told[i] and told[i]:find(words, 1, true), told[i])
end
read("Extension,Load\n0,0\n2,100\n", { units = { displacement = "mm", force = "lb" } })
assert(#told == 5)
fabric.warn = warn
-- short words; columns by a place that is none; decimal commas between commas; lengths in mm; files that are no text; other line ends and UTF-16
for _, heading in ipairs { "ext_mm,load_N", "Disp (mm),F (N)", "Elong. (mm),Load (N)" } do close(read(heading .. "\n0,0\n2,100\n").displacement[2], 2e-3, 1e-15) end
fails("expected a place from 1 to 2 for the force, there are 'Extension', 'Load', got 7", read, "Extension (mm),Load (N)\n0,0\n2,100\n", { columns = { force = 7 } })
fails("there are 1, 2, 3, 4 (the line above has 2 words for 4 cells: are there decimal commas between commas?", read, "Extension (mm),Load (N)\n0,0,0,0\n1,5,2,5\n")
close(read('Extension (mm),Load (N)\n"0,0","0,0"\n"1,5","2,5"\n').force[2], 2.5, 1e-15)
fails("expected plain text, got an empty file", read, "")
fails("expected plain text, got a spreadsheet (.xlsx, .ods) or another archive; save the sheet as CSV", read, "PK\3\4\20\0")
for _, text in ipairs { "Extension (mm),Load (N)\r0,0\r2,100\r", "\xff\xfe" .. ("Extension (mm)\tLoad (N)\r\n0\t0\r\n2\t100\r\n"):gsub(".", "%0\0") } do close(read(text).force[2], 100, 1e-15) end
do
  local asked, warn_ = {}, fabric.warn
  fabric.warn = function(words) asked[#asked + 1] = words end
  read("Extension (mm),Load (N/mm)\n0,0\n2,100\n", { width = 25 })
  read("Strain (%),Load (N)\n0,0\n2,100\n", { gauge_length = 100 })
  read("Extension (mm),Load (N)\n0,0\n2,100\n", { gauge_length = 100, width = 25 }) -- neither is used
  fabric.warn = warn_
  assert(#asked == 2 and asked[1] == "read: field 'width': 25 m is far from what cloth is: is it in m?" and asked[2]:find("'gauge_length': 100 m", 1, true), asked[1])
end
-- a record that does not move, and one test in the place of a list
local function pull(displacement, force)
  return lab.tensile { record = { displacement = displacement, force = force }, gauge_length = 0.1, width = 0.025, thickness = 4e-4, plies = 1 }
end
fails("tensile: displacement stays at 0 m in the only row: expected the rows of a pull", pull, { 0 }, { 0 })
fails("tensile: displacement stays at 0.001 m in all 3 rows", pull, { 1e-3, 1e-3, 1e-3 }, { 0, 1, 2 })
fails("tensile: force stays at 0 N in all 2 rows", pull, { 0, 1e-3 }, { 0, 0 })
fails("fit: field 'tests': expected at least one test, got one test: write tests={ test }", lab.fit, { tests = pull({ 0, 1e-3, 2e-3 }, { 0, 1, 2 }) })
fails("expected at least 6 loading points of every specimen, got 3 of specimen 1", lab.fit, { tests = { pull({ 0, 1e-3, 2e-3 }, { 0, 1, 2 }) } })
do -- the file is named, since a folder has many
  local short = os.tmpname() .. ".csv"
  fabric.write(short, "Extension (mm),Load (N)\n0,0\n1,3\n2,7\n3,12\n")
  local test = lab.tensile { file = short, gauge_length = 0.2, width = 0.05, thickness = 5e-4, plies = 1 }
  fails("got 4 of specimen 1 (" .. short .. ")", lab.fit, { tests = { test } })
  os.remove(short)
end
fails("a strain but no displacement: expected field 'gauge_length' in m", read, "Dehnung (%),Kraft (N)\n0,0\n2,100\n4,210\n")
fails("column 'Load' is a force per width: expected field 'width' of the specimen in m", read, "Extension (mm),Load (N/mm)\n0,0\n2,100\n4,210\n")
-- the extension in mm is the displacement, the one in per cent the strain
r = read "Extension (%),Extension (mm),Load (N)\n0,0,0\n2,4,100\n4,8,210\n"
assert(r.displacement[3] == 8e-3 and math.abs(r.strain[3] - 0.04) < 1e-17)

-- the unit decides whether a column is an elongation or a strain
r = read("Dehnung in %;Kraft in N\n0;0\n2;100\n4;210\n", { gauge_length = 0.1 })
assert(r.displacement[3] == 4e-3 and r.strain[3] == 0.04)
-- units where the headings say none, and none in their place where they do
r = read("Extension (cm),Load\n0,0\n2,100\n4,210\n", { default_units = { displacement = "mm", force = "cN" } })
assert(r.displacement[3] == 0.04 and r.force[3] == 2.1)
r = read("0;0\n1;2\n2;4\n", { columns = { displacement = 1, force = 2 }, default_units = { displacement = "mm", force = "N" } })
assert(r.displacement[3] == 2e-3 and r.force[3] == 4)
fails("field 'default_units.displacement': 'furlong' is no unit of length known: expected one of cm, in, m, mm, um", read, "Extension,Load\n0,0\n2,100\n4,210\n",
  { default_units = { displacement = "furlong", force = "N" } })
-- a strain beyond 1 without a unit is asked about
local strains = "Dehnung;Kraft (N)\n0;0\n0,75;100\n1,5;210\n"
fails("column 'Dehnung': the strain runs to 1.5 and its heading names no unit: is it in %?", read, strains, { gauge_length = 0.1 })
close(read(strains, { gauge_length = 0.1, units = { strain = "%" } }).strain[3], 0.015, 1e-15)
close(read(strains, { gauge_length = 0.1, default_units = { strain = "%" } }).strain[3], 0.015, 1e-15)
close(read(strains, { gauge_length = 0.1, units = { strain = "-" } }).strain[3], 1.5, 1e-15)
close(read("Dehnung;Kraft (N)\n0;0\n0,1;100\n0,2;210\n", { gauge_length = 0.1 }).strain[3], 0.2, 1e-15)
fails("expected displacement, force, time or strain, got 'load'", read, "a (mm),b\n0,0\n", { default_units = { load = "N" } })

-- a frame that writes in blocks, the heading above each anew, words in between
r = read("MTS793|ENU|1|0\n\nData Acquisition: Timed\nTime\tExtension\tLoad\nsec\tmm\tN\n0\t0\t0\n1\t1\t2\n2\t2\t4\n3\t3\t6\n\nData Acquisition: Timed, block 2\nTime\tExtension\tLoad\n"
  .. "sec\tmm\tN\n4\t4\t8\nTime\tExtension\tLoad\nsec\tmm\tN\n5\t5\t10\n")
assert(r.rows == 6 and r.time[5] == 4 and r.displacement[4] == 3e-3 and r.force[6] == 10)
fails(":6: column 'Load': expected a finite number, got 'broken'", read, "Extension (mm),Load (N)\n0,0\n1,1\n2,2\n3,3\n4,broken\n")
fails(":6: expected 2 cells, got 1", read, "Extension (mm),Load (N)\n0,0\n1,1\n2,2\n3,3\nend of test\n4,4\n")
-- words under the last row are none; a row that is cut short is told
assert(read("Extension (mm),Load (N)\n0,0\n1,1\n2,2\n3,3\n\nData Header: Timer: 15 Sec\nend of test\n").rows == 4)
fails(":6: expected 2 cells, got 1", read, "Extension (mm),Load (N)\n0,0\n1,1\n2,2\n3,3\n4\n")
fails(":6: expected 2 cells, got 1", read, "Extension (mm),Load (N)\n0,0\n1,1\n2,2\n3,3\nend of test\n4\n")

-- words of one's own, from a table or a file, go before those of the house
local mine = { displacement = { "hub" }, force = { "zug" }, units = { force = { dyn = 1e-5 }, displacement = { furlong = 201.168 } } }
r = read("Zugweg,hub (furlong),zug (dyn)\n9,0,0\n9,2,3\n9,4,5\n", { vocabulary = mine, columns = { force = 3 } })
close(r.displacement[2], 402.336, 1e-15)
close(r.force[3], 5e-5, 1e-15)
local file = os.tmpname() .. ".lua"
do
  local f <close> = io.open(file, "w")
  f:write "return { displacement = { 'hub' }, force = { 'zug' } }"
end
assert(read("Hub (mm),Zug (N)\n0,0\n2,3\n4,5\n", { vocabulary = file }).force[3] == 5)
do
  local f <close> = io.open(file, "w")
  f:write "return os.getenv 'HOME'"
end
fails("expected 'return { force={...}, ... }'", read, "Hub (mm),Zug (N)\n0,0\n2,3\n4,5\n", { vocabulary = file })
os.remove(file)
fails("expected displacement, force, time, strain or units, got 'load'", read, "Hub (mm),Zug (N)\n0,0\n2,3\n", { vocabulary = { load = { "zug" } } })
fails("field 'units.force': expected a positive number for each unit, got dyn = -1", read, "Hub (mm),Zug (N)\n0,0\n2,3\n",
  { vocabulary = { units = { force = { dyn = -1 } } } })

-- A pull S = 8 MPa E + 400 MPa E^2 read off a display that now and then shows another digit, alone or for some rows.
local size = { gauge_length = 0.1, width = 0.02, thickness = 1e-3, plies = 1 }
local function tensile(record, more)
  local t = { record = record }
  for k, v in pairs(size) do t[k] = v end
  for k, v in pairs(more or {}) do t[k] = v end
  return lab.tensile(t)
end
local function pull(n, slack, scale)
  local record = { displacement = {}, force = {} }
  for i = 0, n do
    local u = 0.02 * i / n
    local e = math.max(0, (u - (slack or 0)) / (0.1 + (slack or 0)))
    local E = e + e ^ 2 / 2
    record.displacement[i + 1] = u
    record.force[i + 1] = (scale or 1) * (8e6 * E + 4e8 * E ^ 2) * 2e-5 * (1 + e) + 0.02 * draw.normal()
  end
  return record
end
local clean = pull(600)
said = {}
assert(not tensile(clean).outliers and #said == 0)
local dropped = { displacement = clean.displacement, force = table.move(clean.force, 1, #clean.force, 1, {}) }
local wrong = { 200, 301, 302, 303, 304, 450, 451, 580 }
for _, row in ipairs(wrong) do dropped.force[row] = dropped.force[row] / 10 end
local test = tensile(dropped)
assert(#said == 1 and said[1]:find("8 of 601 readings of the force are outliers and are left out (place 200: ", 1, true), said[1])
assert(#test.outliers == #wrong and #test.E == 601 - #wrong and #test.force == #test.E)
for i, row in ipairs(wrong) do assert(test.outliers[i] == row) end
assert(not tensile(dropped, { outliers = "drop" }).failure and #said == 1)
assert(#tensile(dropped, { outliers = "keep" }).E == 601)
-- none of it is found in a rupture, a reversal, or a hold in which the force falls
local turned = { displacement = {}, force = {} }
for i = 1, 450 do
  local row = i <= 400 and i or 800 - i
  turned.displacement[i], turned.force[i] = clean.displacement[row], i <= 400 and clean.force[row] or clean.force[400] - 3 * (clean.force[400] - clean.force[row])
end
assert(not tensile(turned).outliers)
local broken = { displacement = clean.displacement, force = table.move(clean.force, 1, #clean.force, 1, {}) }
for i = 500, 601 do broken.force[i] = 0.1 * clean.force[499] + 0.02 * draw.normal() end
test = tensile(broken)
assert(not test.outliers and test.failure == 499, test.failure)
-- a force that falls and comes back is no rupture
local slipped = { displacement = clean.displacement, force = table.move(clean.force, 1, #clean.force, 1, {}) }
for i = 500, 560 do slipped.force[i] = 0.6 * clean.force[i] end
assert(not tensile(slipped).failure)

-- The toe: slack that is there is found; what is no polynomial leaves it open, and the band holds both answers.
local function tests_of(slack)
  local tests = {}
  for i = 1, 3 do tests[i] = tensile(pull(200, slack and slack + 2e-4 * i, 1 + 0.02 * draw.normal())) end
  return tests
end
local found = lab.fit { tests = tests_of(1e-3), find_slack = "either" }
assert(found.text:find "there was slack" and found.specimens[1].slack > 5e-3, found.text)
local open = {}
for i = 1, 3 do
  local record = pull(200)
  for k, u in ipairs(record.displacement) do record.force[k] = (60 + 0.2 * i) * (u / 0.02) ^ 0.7 * (1 - math.exp(-(u / 1.5e-3) ^ 2)) end -- no quartic
  open[i] = tensile(record)
end
local without, with = lab.fit { tests = open, degree = 4 }, lab.fit { tests = open, degree = 4, find_slack = true }
local either = lab.fit { tests = open, degree = 4, find_slack = "either" }
assert(either.text:find "no law describes the records to their noise", either.text)
assert(either.text:find "the polynomial of degree 4 that was asked for does not describe the mean: it misses it by up to [%d.]+ %% of the largest stress", either.text)
for _, D in ipairs { without.loading[1], with.loading[1] } do assert(either.band.low[1] <= D and D <= either.band.high[1]) end
local scattered = lab.fit { tests = { tensile(pull(200, 0, 0.7)), tensile(pull(200, 0, 1)), tensile(pull(200, 0, 1.3)) } }
assert(scattered.text:find "D%(0%) is loosely determined: [%d.]+ MPa, " and scattered.loose, scattered.text)
assert(not lab.fit({ tests = { tensile(pull(200)), tensile(pull(200)) }, degree = 2 }).loose)
-- a curve that is straight for long and then steep is no quartic at its toe: measured points instead
local late = {}
for i = 1, 3 do
  local record = pull(200)
  for k, u in ipairs(record.displacement) do record.force[k] = (1 + 0.01 * i) * (1000 * u + 1e-3 * math.exp(600 * u)) end
  late[i] = tensile(record)
end
local points = lab.fit { tests = late, find_slack = "either" }
assert(points.text:find "points of a monotone curve instead" and type(points.loading[1]) == "table", points.text)
for _, p in ipairs(points.loading) do
  local e = math.sqrt(1 + 2 * p[1]) - 1
  local reference = 1.02 * (1000 * 0.1 * e + 1e-3 * (math.exp(60 * e) - 1)) / 2e-5 / (1 + e)
  assert(math.abs(p[2] - reference) < 0.01 * points.loading[#points.loading][2], p[1])
end

-- How specimens differ: with four and more of them the band of the others holds one left out 95 times in 100.
local inside, n = 0, 0
for trial = 1, 60 do
  local tests = {}
  for i = 1, 5 do
    local E, S, scale = {}, {}, 1 + 0.05 * draw.normal()
    for k = 1, 60 do E[k], S[k] = k / 500, scale * 1e7 * k / 500 end
    tests[i] = { E = E, S = S, branches = { { kind = "loading", first = 1, last = 60 } } }
  end
  local s = lab.spread { tests = tests, points = 10 }
  inside, n = inside + s.coverage, n + 1
  if trial == 1 then
    local sum, squares = 0, 0
    for _, t in ipairs(tests) do sum = sum + t.S[60] / 5 end
    for _, t in ipairs(tests) do squares = squares + (t.S[60] - sum) ^ 2 / 4 end
    local relative = math.sqrt(squares) / sum
    close(s.deviation[10] / s.S[10], relative, 1e-12, "deviation")
    close((s.high[10] - s.S[10]) / s.S[10], 2.776445 * relative / math.sqrt(5), 1e-6, "band of the mean")
    close((s.next_high[10] - s.S[10]) / s.S[10], 2.776445 * relative * math.sqrt(1.2), 1e-6, "band of the next")
  end
end
assert(math.abs(inside / n - 0.95) < 0.03, inside / n) -- 300 left out: two standard errors

-- A measured curve beside a test's: slack, points between, residuals, a figure.
local card = fabric.card "blend"
local run = lab.uniaxial { card = card, direction = "warp", grips = "free", steps = 40 }
local slack = 0.01
local measured = { E = {}, S = {} }
for i = 1, 50 do
  local E = 0.25 * i / 50
  local S = 8e6 * E + 413e6 * E ^ 2
  measured.E[i], measured.S[i] = ((1 + 2 * E) * (1 + slack) ^ 2 - 1) / 2, 1.02 * S / (1 + slack)
end
local figure = os.tmpname() .. ".svg"
local c = lab.compare(measured, run, { slack = slack, file = figure, title = "warp" })
os.remove(figure)
assert(#c.x == 50 and c.outside == 0 and c.columns[1] == "E")
close(c.worst, 0.02 / 1.02, 0.01, "largest residual") -- between the test's points
close(c.residual[50], 0.02 / 1.02 * measured.S[50] * (1 + slack), 0.02, "residual")
assert(c.text:find "50 points, 0 outside of the test; measured less simulated: rms", c.text)
local own = lab.compare({ displacement = { 0, 0.01, 0.03 }, force = { 0, run.curve[20].force, 5 } }, run.curve)
assert(own.columns[1] == "displacement" and own.outside == 1)
fails("expected measured points within the test's E", lab.compare, { E = { 2, 3 }, S = { 1, 2 } }, run)

-- Slack that the curve itself shows, not what would hide a softer specimen; strains and displacements.
local soft = { E = {}, S = {} }
for i = 1, 200 do
  local E = -0.01 + 0.26 * i / 200
  local S = E > 0 and 0.9 * (8e6 * E + 413e6 * E ^ 2) or 0
  soft.E[i], soft.S[i] = ((1 + 2 * E) * (1 + slack) ^ 2 - 1) / 2, S / (1 + slack) + 2e4 * draw.normal()
end
c = lab.compare(soft, run, { slack = "find" })
close(c.slack, slack, 0.1, "slack found")
close(c.worst, 0.1 / 0.9, 0.1, "the softer specimen's residual")
local late_pull, straight = { displacement = {}, force = {} }, { displacement = {}, force = {} }
for i = 1, 200 do
  local u = 1e-4 * i
  straight.displacement[i], straight.force[i] = u, 500 * u + 5e4 * u ^ 2
  local d = math.max(0, u - 2e-3)
  late_pull.displacement[i], late_pull.force[i] = u, 500 * d + 5e4 * d ^ 2
end
c = lab.compare(late_pull, straight, { slack = "find" })
close(c.slack, 2e-3, 1e-3, "slack of a displacement")
assert(c.worst < 1e-3, c.text)
-- the band of the next specimen, from each one's own contact
local scaled = {}
for i, scale in ipairs { 0.95, 1, 1.04, 1.01 } do
  scaled[i] = { E = {}, S = {}, branches = { { kind = "loading", first = 1, last = 100 } } }
  for k = 1, 100 do
    local E = 0.25 * k / 100
    scaled[i].E[k], scaled[i].S[k] = ((1 + 2 * E) * (1 + slack * i) ^ 2 - 1) / 2, scale * (8e6 * E + 413e6 * E ^ 2) / (1 + slack * i)
  end
end
local taut = { specimens = {} }
for i = 1, 4 do taut.specimens[i] = { slack = slack * i } end
local seen = lab.spread { tests = scaled, fit = taut }
close(seen.deviation[40] / seen.S[40], 0.037417, 2e-3, "deviation from contact") -- of 0.95, 1, 1.04, 1.01 over their mean
assert(lab.spread({ tests = scaled }).deviation[40] > 2 * seen.deviation[40])
c = lab.compare(scaled[4], run, { slack = 4 * slack, spread = seen })
assert(c.inside > 0.9 and c.text:find "%d+ %% of the points lie in the band of the next specimen", c.text)
for i, S in ipairs(soft.S) do soft.S[i] = 0.7 * S end
c = lab.compare(soft, run, { slack = slack, spread = seen })
assert(c.inside < 0.3, c.text)
fails("expected the fit of these 4 tests, got one of 2", lab.spread, { tests = scaled, fit = { specimens = { {}, {} } } })
fails("fit.specimens[1].slack': expected a stretch, got nil", lab.spread, { tests = scaled, fit = { specimens = { {}, {}, {}, {} } } })
fails("field 'spread': a band of S over E, got force over displacement", lab.compare, late_pull, straight, { spread = seen })
local good, hole = { displacement = { 0, 1, 2 }, force = { 0, 1, 2 } }, { displacement = { 0, 1, 2 }, force = { 0, 0 / 0, 2 } }
for words, pair in pairs {
  ["field 'measured.force': expected finite numbers, got "] = { hole, good }, ["field 'test.force': expected finite numbers, got "] = { good, hole },
  ["field 'test.force': expected finite numbers, got x at place 2"] = { good, { displacement = { 0, 1 }, force = { 0, "x" } } },
  ["field 'measured.force': expected values that are not all zero"] = { { displacement = { 0, 1, 2 }, force = { 0, 0, 0 } }, good },
  ["field 'test': expected a result of a test with a curve, or lists displacement and force of one length"] = { good, { displacement = { 0, 1 }, force = { 0 } } },
  ["field 'test.displacement': expected two points or more, got 0"] = { good, { displacement = {}, force = {} } },
  ["field 'measured.branches': expected rows of loading"] = { { E = { 0, 1 }, S = { 0, 1 }, branches = { { kind = "unloading", first = 1, last = 2 } } }, { E = { 0, 1 }, S = { 0, 1 } } },
} do fails("compare: " .. words, lab.compare, pair[1], pair[2]) end
fails("field 'slack': expected at least 6 rising points to find it, got 3", lab.compare, { displacement = { 1, 2, 3 }, force = { 0, 2, 3 } }, straight, { slack = "find" })
fails("field 'slack': no first contact is found in this curve", lab.compare, { displacement = { 1, 2, 3, 4, 5, 6, 7, 8 }, force = { 8, 7, 6, 5, 4, 3, 2, 1 } }, straight, { slack = "find" })

-- The force of a card by the kinematics of a bias pull is the inverse of the shear from a force.
local d = {}
for i = 1, 100 do d[i] = 0.03 * i / 100 end
local made = lab.bias_shear { displacement = d, card = card, width = 0.1, length = 0.3, limit = 60 }
local back = lab.bias_shear { displacement = d, force = made.force, width = 0.1, length = 0.3, thickness = card.thickness, limit = 60 }
local S12 = fabric.point(card):path({ E12 = back.E12 }, { "S12" }).S12
for i = 10, 100 do close(back.S12[i], S12[i], 2e-3, "shear at place " .. i) end -- half angles between rows

-- Four pins at the tips of a diamond, in any order: the ratio of its diagonals, and the shear of the yarns along its sides.
local tips = { { 0, -1, 0, -1.2 }, { -1, 0, -0.9, 0 }, { 1, 0, 0.9, 0 }, { 0, 1, 0, 1.2 } }
local orders = 0
local function diamond(order, n)
  if n > 1 then
    for i = 1, n do
      order[n], order[i] = order[i], order[n]
      diamond(order, n - 1)
      order[n], order[i] = order[i], order[n]
    end
    return
  end
  local grid = { rows = 2, columns = 2, x = {}, y = {} }
  for k, tip in ipairs(order) do
    grid.x[k], grid.y[k], grid.x[k + 4], grid.y[k + 4] = table.unpack(tips[tip])
  end
  close(lab.poisson({ specimens = { grid }, noise = 0 }).value, (1 - 0.81) / (1.44 - 1), 1e-12, "ratio of the diagonals")
  local sheared = lab.shear_from_bias { markers = grid, force = { 0, 1 }, displacement = { 0, 0.01 }, gauge_length = 0.1, width = 0.02, thickness = 5e-4, plies = 1 }
  close(sheared.E[2], (1.44 - 0.81) / 4, 1e-12, "shear of a diamond")
  orders = orders + 1
end
diamond({ 1, 2, 3, 4 }, 4)
assert(orders == 24)

-- One specimen of four that is unlike the others is said with the fit; three alike are not.
do
  local words, warn = {}, fabric.warn
  fabric.warn = function(text) words[#words + 1] = text end
  local function fitted(scales)
    local tests = {}
    for i, scale in ipairs(scales) do
      local E, S = {}, {}
      for k = 0, 60 do E[k + 1], S[k + 1] = k / 300, scale * (8e6 * k / 300 + 4e8 * (k / 300) ^ 2) end
      tests[i] = { E = E, S = S, file = "out/s" .. i .. ".csv", branches = { { kind = "loading", first = 1, last = 61 } } }
    end
    return fabric.lab.fit { tests = tests, degree = 2 }
  end
  assert(fitted({ 1, 1.02, 0.98 }).warnings == nil and #words == 0)
  local w = fitted({ 1, 1.02, 1.6, 0.98 }).warnings
  assert(#w == 1 and w[1].code == "unlike" and w[1].specimen == 3 and w[1].text:find "^specimen 3 %(s3.csv%) is unlike the others: 160 %%", w[1].text)
  assert(#words == 1 and words[1]:find(w[1].text, 1, true))
  fabric.warn = warn
end
