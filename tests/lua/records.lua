-- Files as frames and spreadsheets write them: where a record ends, how many specimens a file holds, what is said of a pull that was not held well.
local fabric = require "fabric"
local lab = fabric.lab
local said = {}
fabric.warn = function(words) said[#said + 1] = words end

local function close(got, want, what)
  if not (type(got) == "number" and math.abs(got - want) <= 1e-12 * math.abs(want)) then error(("%s: %s, want %g"):format(what or "value", tostring(got), want), 2) end
end
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails
local function with_file(text, f, more)
  local path = os.tmpname() .. ".csv"
  fabric.write(path, text)
  local t = { file = path }
  for k, v in pairs(more or {}) do t[k] = v end
  local ok, result = pcall(f, t)
  os.remove(path)
  if not ok then error(result, 0) end
  return result
end
local function read(text, more) return with_file(text, lab.read, more) end
local function columns(text, more) return with_file(text, fabric.table, more) end
local function told(words)
  for _, one in ipairs(said) do
    if one:find(words, 1, true) then return true end
  end
  error("not told: " .. words .. "\n" .. table.concat(said, "\n"), 2)
end
-- Rows of u and F = 3 u + u^2 / 7, from `first`, with a time where `step` is given.
local function pull(n, scale, form, step)
  local lines = {}
  for i = 0, n - 1 do
    local u, F = 0.25 * i, scale * (0.75 * i + (0.25 * i) ^ 2 / 7)
    lines[#lines + 1] = step and form:format(step * i, u, F) or form:format(u, F)
  end
  return table.concat(lines)
end
local last = 0.75 * 11 + 2.75 ^ 2 / 7 -- the force in row 12

-- --- where a record ends ---
local heading, rows = "Time (s),Extension (mm),Load (N)\n", pull(12, 1, "%g,%.10g,%.14g\n", 0.5)
for _, below in ipairs { "Mean,1.375,4.6\nStd. Dev.,0.9,3\nMaximum,2.75,9.33\n", ",1.375,4.6\n", "\nMittelwert,1.4,4.6\n", "Fmax,,9.3303571\n", "5.5,2.75,Maximum\n", "End of test\n",
  "Mean,1.375\n", "Mean,1.375,4.6,77\n" } do
  local r = read(heading .. rows .. below)
  assert(#r.force == 12 and #r.time == 12 and r.left_out[1].line == (below:sub(1, 1) == "\n" and 15 or 14), below)
  close(r.force[12], last, below)
end
-- a label in a column of text ends it too; a word in a column of numbers amid them is an error
local r = read("Cycle,Extension (mm),Load (N)\n" .. pull(12, 1, "up,%.10g,%.14g\n") .. "mean,1.375,4.6\n")
assert(#r.force == 12 and r.left_out[1].text == "mean,1.375,4.6")
fails(":12: column 'Load': expected a finite number, got 'x'", read, heading .. rows:gsub("[^,]*\n(5.5)", "x\n%1"))
fails(":12: column 'Time': expected a finite number, got 'mean'", columns, heading .. rows:gsub("5,(2.5,)", "mean,%1"))
-- totals in numbers: the time goes back, or the length leaps
fails(":14: the time goes back from 5.5 to 2.75 s", read, heading .. rows .. "2.75,1.375,4.6\n")
fails(":6: the time goes back from 2 to 1.5 s", read, heading .. rows:gsub("(1.5,[^\n]*\n)(2,[^\n]*\n)", "%2%1"))
assert(read(heading .. "0,0,0\n1,1,2\n0,2,3\n", { columns = { time = false } }).time == nil)
fails(":22: the displacement leaps back from 0.00475 to 0.002375 m in one row, before by 0.00025 m at most", read,
  "Extension (mm),Load (N)\n" .. pull(20, 1, "%.10g,%.14g\n") .. "2.375,9\n4.75,13\n")
-- a way back that was recorded leaps nowhere
assert(#read("Extension (mm),Load (N)\n" .. pull(20, 1, "%.10g,%.14g\n") .. "4,9\n3,2\n2.9,0.1\n").force == 23)

-- --- several specimens ---
local two = "Specimen A7\nExtension (mm),Load (N)\n" .. pull(12, 1, "%.10g,%.14g\n") .. "\nSpecimen B2\nWidth,25\nExtension (mm),Load (kN)\n" .. pull(9, 0.004, "%.10g,%.14g\n")
r = read(two)
assert(#r == 2 and r[1].specimen == "A7" and r[2].specimen == "B2" and #r[1].force == 12 and #r[2].force == 9)
close(r[1].force[12], last)
close(r[2].force[9], 4 * (6 + 4 / 7))
fails("a further table begins here, table 2 of 2: expected one table; blocks=true reads each", columns, two)
local blocks = columns(two, { blocks = true })
assert(#blocks == 2 and blocks[2][2].unit == "kN" and blocks[2].preamble[2] == "Width,25" and blocks[2].lines[1] == 19)
-- equal headings; another order of the columns; sums between them are told
r = read((two:gsub("kN", "N"):gsub("\nSpecimen B2", "Mean,1.4,4.6\n\nSpecimen B2")))
assert(#r == 2 and #r[1].force == 12 and r[1].left_out[1].text == "Mean,1.4,4.6")
r = read("Extension (mm),Load (N)\n" .. pull(12, 1, "%.10g,%.14g\n") .. "Load (N),Extension (cm),Time (s)\n0,0,0\n5,0.1,1\n9,0.2,2\n")
close(r[2].displacement[3], 2e-3)
assert(r[2].specimen == "2" and r[2].force[3] == 9)
-- a table of results beside the records is told
said = {}
r = read("Specimen,Maximum load (N),Modulus (MPa)\n1,9.3,7\n2,7,8\n3,8,8\n4,9,7\n\n" .. two)
assert(#r == 2 and r[1].specimen == "A7")
told ":2: the table that begins here is no record of a force and a displacement, and is left out"
-- frames that repeat the heading above each block: the time goes on
r = read(heading .. "0,0,0\n0.5,0.25,1\n" .. heading .. "1,0.5,2\n1.5,0.75,3\n")
assert(#r.force == 4 and r.force[4] == 3)
assert(#columns(heading .. "0,0,0\n0.5,0.25,1\n" .. heading .. "1,0.5,2\n1.5,0.75,3\n")[1].values == 4)
r = read(heading .. "0,0,0\n0.5,0.25,1\n1,0.3,2\n" .. heading .. "0,0,0\n1.5,0.75,3\n2,1,4\n")
assert(#r == 2 and r[2].force[2] == 3)
-- a column that names the specimen
for _, name in ipairs { "Specimen", "Sample no.", "Probe Nr", "Pr\u{fc}fling", "\u{8bd5}\u{6837}" } do
  local long = {}
  for k, label in ipairs { "3", "1", "1b" } do long[k] = pull(4 + k, k, label .. ",%.10g,%.14g\n") end
  r = read(name .. ",Extension (mm),Load (N)\n" .. table.concat(long))
  assert(#r == 3 and r[1].specimen == "3" and r[3].specimen == "1b" and #r[2].force == 6, name)
  close(r[3].force[7], 3 * (0.75 * 6 + 1.5 ^ 2 / 7))
end
said = {}
assert(#read("Sample,Extension (mm),Load (N)\n1,0,0\n2,1,1\n3,2,2\n4,3,3\n").force == 4)
told "has 4 different values in 4 rows and is not taken for the names of specimens"
said = {}
r = read("Specimen,Extension (mm),Load (N)\n1,0,0\n1,1,2\n1,2,3\n2,0,0\n2,1,1\n2,2,5\n9,7,7\n")
assert(#r == 2)
told ":8: specimen '9' has 1 row, which is no record, and is left out"
-- the laboratory takes them: tensile as a list, a folder as specimens
local tests = with_file(two, lab.tensile, { gauge_length = 0.1, width = 0.02, thickness = 5e-4, plies = 1 })
assert(#tests == 2 and tests[2].specimen == "B2" and #tests[2].E == 9)
close(tests[1].S[12], last / 1e-5 / (1 + 2.75e-3 / 0.1))
local fit = lab.fit { tests = tests, degree = 1 }
assert(#fit.specimens == 2)
local here = os.tmpname()
os.remove(here)
fabric.write(here .. "/laboratory.lua", "return { name='m', gauge_length=0.1, width=0.02, thickness=5e-4, plies=1, density=400, thousands='.' }")
fabric.write(here .. "/warp-1.csv", ("Probe;Weg (mm);Kraft (mN)\n" .. pull(30, 2e3, "1;%.10g;%.14g\n") .. pull(30, 2.2e3, "2;%.10g;%.14g\n") .. pull(30, 2.1e3, "3;%.10g;%.14g\n")):gsub("(%d)%.", "%1,") .. "")
fabric.write(here .. "/bias-1.csv", (("Probe 1\nWeg (mm);Kraft (N)\n" .. pull(30, 0.1, "%.10g;%.14g\n") .. "Probe 2\nWeg (mm);Kraft (N)\n" .. pull(30, 0.11, "%.10g;%.14g\n")):gsub("(%d)%.", "%1,")))
local found = require("fabric.lab.folder").reduce(here)
assert(#found.warp.tests == 3 and found.warp.tests[3].specimen == "3" and found.warp.spread and #found.shear.tests == 2)
assert(os.execute("rm -r '" .. here .. "'"))

-- --- what stands between cells is decided by the whole file ---
local short = "Extension (mm),Load (N)\n0,0\n1\n" .. pull(40, 1, "%.0f,%.0f\n")
fails(":3: expected 2 cells, got 1", columns, short)
fails(":3: expected 2 cells, got 1", read, short)
local one = columns "Load (N)\n0\n0,5\n1\n1,5\n2\n"
assert(#one == 1 and one[1].values[4] == 1.5)

-- --- signs, units and times ---
r = read("Dehnung;Kraft\n%;N\n0;0\n\u{2212}0,5;\u{2212}1,25\n1;1\u{202f}234,5\n2;2\u{a0}000\n3;12 345,5\n", { gauge_length = 0.1 })
close(r.strain[2], -0.005)
assert(r.force[2] == -1.25 and r.force[3] == 1234.5 and r.force[4] == 2000 and r.force[5] == 12345.5)
assert(read("Weg (mm),Kraft (N)\n0,0\n1,1'234.5\n2,2\u{2019}000\n").force[3] == 2000)
assert(read("Weg (mm);Kraft (N)\n0,5;0\n1,5;1.234\n2;1.300,5\n").force[2] == 1234) -- the last row shows what its points are
assert(read("Weg (mm);Kraft (N)\n0,5;0\n1,5;1.234\n2;1.300,5\n", { thousands = "." }).force[2] == 1234)
r = read "Time,Extension (mm),Load (N)\n00:59.50,0,0\n1:00.25,1,2\n1:02:03,2,3\n"
assert(r.time[1] == 59.5 and r.time[2] == 60.25 and r.time[3] == 3723)
for _, heading in ipairs { "Tiempo (s);Desplazamiento (mm);Fuerza (N)", "Tempo (s);Deslocamento (mm);For\u{e7}a (N)", "Tempo (s);Alongamento (mm);Carga (N)", "Tempo (s);Allungamento (mm);Forza (N)",
  "Temps (s);D\u{e9}placement (mm);Effort (N)", "Tijd (s);Verplaatsing (mm);Kracht (N)", "S\u{fc}re (s);Uzama (mm);Kuvvet (N)", "Zaman (sn);Yer de\u{11f}i\u{15f}tirme (mm);Y\u{fc}k (N)",
  "Время, с;Перемещение, мм;Нагрузка, Н", "ВРЕМЯ (с);УДЛИНЕНИЕ (мм);УСИЛИЕ (Н)", "时间(s);位移(mm);力(N)", "时间（秒）;变形（毫米）;试验力（牛）", "時間(s);伸長(mm);負荷(N)", "時間(s);変位(mm);試験力(N)",
  "시간(초);변위(mm);하중(N)", "Czas [s];Wyd\u{142}u\u{17c}enie [mm];Obci\u{105}\u{17c}enie [N]", "Zeit (s);Traversenweg (mm);Last (N)",
  "\xca\xb1\xbc\xe4(s);\xce\xbb\xd2\xc6(mm);\xca\xd4\xd1\xe9\xc1\xa6(N)", "\xca\xb1\xbc\xe4(s);\xce\xbb\xd2\xc6(mm);\xc1\xa6(N)",
  "\u{65f6}\u{95f4}/s;\u{4f4d}\u{79fb}/mm;\u{8f7d}\u{8377}/N", "time/s;crosshead/mm;load/N", "\u{10c}as (s);Dr\u{e1}ha (mm);S\u{ed}la (N)", "Tid (s);F\u{f6}rl\u{e4}ngning (mm);Kraft (N)" } do
  r = read(heading .. "\n0;0;0\n1;2,5;3,5\n2;5;7\n")
  assert(r.time and r.time[2] == 1 and math.abs(r.displacement[2] - 2.5e-3) < 1e-18 and r.force[2] == 3.5, heading)
end
-- a total with its unit in one cell is told, and lines of separators alone are none
said = {}
r = read "Data:;No.;Zeit;Weg;Kraft\n;;;;\n;;s;mm;N\n;1;0;0;0\n;2;1;2;3,5\n;;;;\n;3;2;3;7\n;;;;\n"
assert(#r.force == 3 and r.time[3] == 2 and r.displacement[3] == 3e-3 and r.force[2] == 3.5)
assert(columns "Zeit;Kraft\ns;N\n0;1\n1;2\n2;3\nFmax;3,0 N\n".left_out[1].numbers)
-- --- specimens side by side, each to its own end ---
local both = "Extension (mm),Load (N),Extension (mm),Load (N)\n0,0,0,0\n1,2,1,5\n2,4,2,7\n3,9,,\n4,11,,\n"
r = read(both)
assert(#r == 2 and r[1].specimen == "1" and #r[1].force == 5 and r[2].specimen == "2" and #r[2].force == 3 and r[2].force[3] == 7 and #r[2].lines == 3)
assert(#read(both, { columns = { displacement = 1, force = 2 } }).force == 5)
r = read(both, { columns = { displacement = 3, force = 4 } })
assert(#r.force == 3 and #r.displacement == 3 and r.rows == 3 and #r.lines == 3 and r.force[3] == 7)
fails(":3: column 'Load': expected a finite number, got ''", read, (both:gsub("1,5\n", "1,\n")))
-- the first one shorter, names above, a blank column between, units of their own
r = read "Probe A;;;;Probe B 7;;\nZeit;Weg;Kraft;;Zeit;Weg;Kraft\ns;mm;N;;s;mm;kN\n0;0;0;;0;0;0\n1;1,5;2;;1;1;0,5\n2;2,5;4;;2;2;0,7\n;;;;3;3;0,9\n;;;;4;4;1,1\n"
assert(#r == 2 and r[1].specimen == "A" and r[2].specimen == "B 7" and #r[1].force == 3 and #r[2].force == 5 and r[2].force[5] == 1100 and r[2].time[5] == 4)
-- numbers in the headings, one time for all
r = read "Time (s),Stroke 1 (mm),Force 1 (N),Stroke 2 (mm),Force 2 (N),Stroke 3 (mm),Force 3 (N)\n0,0,0,0,0,0,0\n1,1,2,1,3,1,4\n2,2,4,2,6,2,8\n3,3,6,,,3,12\n"
assert(#r == 3 and #r[1].time == 4 and #r[2].time == 3 and r[3].force[4] == 12 and r[3].specimen == "3" and #r[2].names == 3)
-- two lengths of one specimen are no two specimens
fails("columns 'Extension' and 'Extension' (1, 2) may each be the displacement", read, "Extension (mm),Extension (mm),Load (N)\n0,0,0\n1,1,2\n2,2,4\n")
-- under one heading, with a blank line between
local rest = "Extension (mm),Load (N)\n" .. pull(12, 1, "%.10g,%.14g\n") .. "\n" .. pull(9, 2, "%.10g,%.14g\n")
r = read(rest)
assert(#r == 2 and #r[1].force == 12 and #r[2].force == 9 and r[2].lines[1] == 15)
assert(#read(heading .. pull(12, 1, "%g,%.10g,%.14g\n", 0.5) .. "\n" .. pull(9, 2, "%g,%.10g,%.14g\n", 0.5)) == 2)
assert(#read("Extension (mm),Load (N)\n" .. pull(12, 1, "%.10g,%.14g\n") .. "\n3,10\n3.25,11\n").force == 14)
-- a sum below the rows
fails(":14: the displacement leaps on from 0.00275 to 0.0165 m in one row", read, heading .. rows .. "33,16.5,70\n")
-- nothing is dropped or chosen without a word
said = {}
r = read "Temps (tic);Allongement (mm);D\u{e9}placement traverse (mm);Force (N)\n0;0;0;0\n1;2;3;4\n2;3;4;5\n"
assert(r.time == nil and r.displacement[2] == 2e-3)
told "the time is left out, since the unit of column 'Temps' is not known: 'tic'"
told "the displacement is column 'Allongement'; 'D\u{e9}placement traverse' might be it too"

-- --- headings: an empty last column, units with gaps, brackets that repeat ---
local study = columns "case,load,error\n1,2.5,\n2,3.5,\n"
assert(#study == 3 and study[2].name == "load" and study[3].name == "error" and study[2].values[2] == 3.5)
local rheometer = columns "Interval data:\tPoint No.\tTime\tGap\tNormal Force\tStatus\n\t\t[s]\t[mm]\t[N]\n\t1\t0.5\t1\t2\t\n\t2\t1\t2\t3\t\n\t3\t1.5\t3\t5\t\n"
assert(rheometer[3].unit == "s" and rheometer[5].unit == "N" and rheometer[6].name == "Status" and rheometer[4].values[3] == 3)

-- --- what a pull shows of the jaws ---
local size = { gauge_length = 0.1, width = 0.02, thickness = 5e-4, plies = 1 }
local function tensile(u, F, more)
  local t = { record = { displacement = u, force = F } }
  for k, v in pairs(size) do t[k] = v end
  for k, v in pairs(more or {}) do t[k] = v end
  return lab.tensile(t)
end
local u, F = {}, {}
for i = 1, 100 do u[i], F[i] = 1e-4 * (i - 1), 0.3 * (i - 1) - (i > 60 and 3.5 or 0) end
local slipped = tensile(u, F)
assert(slipped.warnings[1].code == "slip" and slipped.warnings[1].row == 60 and slipped.warnings[1].text:find "1 time and recovers, by 18 %%", slipped.warnings[1].text)
-- slow slip: nothing is gained over the rows 60 to 70, and the same with a hold there is none
for i = 1, 100 do F[i] = 0.3 * (i - 1 - (i > 70 and 10 or math.max(0, i - 60))) end
local slow = tensile(u, F).warnings[1]
assert(slow.code == "slip" and slow.row == 60 and slow.text:find "does not rise over 1%.%d mm", slow.text)
assert(math.abs(slow.way - 1.1e-3) < 1e-12)
local held = table.move(u, 1, 100, 1, {})
for i = 61, 100 do held[i] = u[math.max(60, i - 10)] end
assert(not tensile(held, F).warnings)
for i = 1, 100 do F[i] = math.max(0, 0.3 * (i - 21)) end
assert(tensile(u, F).warnings[1].code == "late-grip" and tensile(u, F).warnings[1].row == 21)
assert(not tensile(u, F, { slack = "contact" }).warnings)
for i = 1, 100 do F[i] = 1 + 0.3 * (i - 1) end
assert(tensile(u, F).warnings[1].code == "preload" and not tensile(u, F, { zero = true }).warnings)
-- a break is none, and a soft toe is none
for i = 1, 100 do F[i] = i <= 80 and 0.3 * (i - 1) or 2 end
assert(tensile(u, F).failure == 80 and not tensile(u, F).warnings)
for i = 1, 100 do F[i] = 1e-3 * (i - 1) ^ 2 end
assert(not tensile(u, F).warnings)

-- a specimen unlike its fellows; with scales 1, 1.02, 0.97, 1.01 the others differ by 2.2 %, and t(1 - 0.05 / 10, 3) = 5.84
local function specimens(scales)
  local out = {}
  for k, scale in ipairs(scales) do
    local f = {}
    for i = 1, 100 do f[i] = scale * 0.3 * (i - 1) end
    out[k] = tensile(u, f)
  end
  return lab.spread { tests = out }
end
local odd = specimens { 1, 1.02, 1.4, 0.97, 1.01 }
assert(#odd.unlike == 1 and odd.unlike[1].specimen == 3 and math.abs(odd.unlike[1].ratio - 1.4) < 1e-9 and odd.text:find "specimen 3 is unlike the others: 140 %%")
assert(math.abs(odd.unlike[1].deviation - 0.0216024690) < 1e-6)
assert(#specimens({ 1, 1.02, 1.12, 0.97, 1.01 }).unlike == 0 and #specimens({ 1, 1.02, 0.97, 1.01 }).unlike == 0)

-- --- spreadsheets, all sheets of them, where Python has openpyxl ---
local book = os.tmpname()
os.remove(book)
book = book .. ".xlsx"
local make = [==[%s -I -c "
import openpyxl, datetime
book = openpyxl.Workbook()
one = book.active
one.title = 'A'
for row in [['Kraft und Weg'], [], ['Zeit', None, 'Weg (mm)', 'Kraft (N)'], [datetime.time(0, 0, 1, 500000), None, 0, 0.1], [datetime.time(0, 1, 2), None, 1.0/3, 2], [datetime.time(1, 0, 0), None, 1, 1234.5]]:
    one.append(row)
book.create_sheet('notes').append(['nothing but words'])
two = book.create_sheet('B')
for row in [['Weg (mm)', 'Kraft (kN)'], [0, 0], [2, 0.5], [3, 0.75], ['Mean', 0.4]]:
    two.append(row)
book.save('%s')
" 2>/dev/null]==]
local reader
for _, python in ipairs { "python3", "/usr/bin/python3" } do reader = reader or os.execute(make:format(python, book)) end
if reader then
  said = {}
  r = lab.read { file = book }
  assert(#r == 2 and r[1].specimen == "A" and r[2].specimen == "B")
  assert(r[1].time[1] == 1.5 and r[1].time[3] == 3600 and r[1].displacement[2] == 1 / 3 * 1e-3 and r[1].force[3] == 1234.5)
  assert(#r[2].force == 3 and r[2].force[2] == 500 and r[2].left_out[1].text == "Mean\t0.4" and r[1].left_out[1].text == "sheet 'notes', which has no rows of numbers")
  fails("a further table begins here, table 2 of 2", fabric.table, { file = book })
  fabric.write(book, "PK\3\4xl/workbook.xml damaged")
  fails("openpyxl cannot read this spreadsheet: zipfile.BadZipFile: File is not a zip file", lab.read, { file = book })
else
  print "SKIPPED: spreadsheets, since no Python with openpyxl is installed (apt install python3-openpyxl)"
  fabric.write(book, "PK\3\4xl/workbook.xml")
  fails("is read by openpyxl, a module of Python, which is not installed: apt install python3-openpyxl, or save each sheet as CSV", lab.read, { file = book })
end
os.remove(book)
