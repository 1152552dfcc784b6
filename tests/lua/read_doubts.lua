-- Records that may be read in two ways, or that show how they were measured: each is read as it is meant with a word, or refused with what to give.
local fabric = require "fabric"
local lab = fabric.lab
local said = {}
fabric.warn = function(words) said[#said + 1] = words end
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails

local function close(got, want, what)
  if not (type(got) == "number" and math.abs(got - want) <= 1e-9 * math.max(math.abs(want), 1e-9)) then error(("%s: %s, want %g"):format(what or "value", tostring(got), want), 2) end
end
local function with_file(text, f, more)
  local path = os.tmpname() .. ".csv"
  fabric.write(path, text)
  local t = { file = path }
  for k, v in pairs(more or {}) do t[k] = v end
  said = {}
  local ok, result = pcall(f, t)
  os.remove(path)
  if not ok then error(result, 0) end
  return result
end
local function read(text, more) return with_file(text, lab.read, more) end
local size = { gauge_length = 0.08, width = 0.03, thickness = 3e-4, plies = 1 }
local function tensile(text, more)
  local t = {}
  for _, list in ipairs { size, more or {} } do
    for k, v in pairs(list) do t[k] = v end
  end
  return with_file(text, lab.tensile, t)
end
local function told(words, count)
  local found = 0
  for _, one in ipairs(said) do
    if one:find(words, 1, true) then found = found + 1 end
  end
  if count and found ~= count or found == 0 then error(("told %d times: %s\n%s"):format(found, words, table.concat(said, "\n")), 2) end
end
local function quiet() if #said > 0 then error("told: " .. table.concat(said, "\n"), 2) end end
local function code(result, want)
  for _, one in ipairs(result.warnings or {}) do
    if one.code == want then return one end
  end
  error("no warning with the code " .. want, 2)
end

-- --- signs between thousands and of decimals ---
-- the decimal sign that a row below the first ones shows: integers, or points between thousands, before it
close(read("Weg [mm];Kraft [N]\n0;0\n1;110\n2;230\n3;370\n4;490\n5;505,75\n").force[6], 505.75)
close(read("Weg [mm];Kraft [N]\n0;0\n1;1.110\n2;2.230\n3;3.370\n4;4.490\n5;5.505,75\n").force[6], 5505.75)
close(read("Weg [mm];Kraft [N]\n0;0\n1;1.110\n2;2.230\n3;3.370\n4;4.490\n5;5.505,75\n").force[3], 2230)
close(read("Extension [mm]\tLoad [N]\n0\t0\n1\t1,110\n2\t2,230\n3\t3,370\n4\t4,490\n5\t5,505.75\n").force[4], 3370)
fails(":7: column 'Kraft': expected a finite number, got '5x5'", read, "Weg [mm];Kraft [N]\n0;0\n1;1.110\n2;2.230\n3;3.370\n4;4.490\n5;5x5\n")
-- decimal commas in one column, points between thousands in the other, where 0 or 640 stands without any
local r = read "Weg [mm]\tKraft [cN]\n0,0\t0\n1,5\t640\n3,0\t1.310\n4,5\t12.020\n"
close(r.force[3], 13.10)
close(r.force[4], 120.20)
told("column 'Kraft': '1.310' is read as 1310, its point between thousands, since column 'Weg' has a decimal comma ('0,0') and '0' has no decimals", 1)
assert(code(r, "signs"))
-- and the other way round
r = read "Crosshead (mm);Load (mN)\n0;0\n1.5;950\n4.5;1,310\n6.25;2,480\n"
close(r.force[3], 1.310)
close(r.displacement[4], 6.25e-3)
told "'1,310' is read as 1310"
-- a sign that only a later row shows is asked for
fails(":6: column 'Load': expected a finite number, got '1,310'; if its comma stands between thousands, give thousands=','", read,
  "Crosshead (mm);Load (mN)\n0;0\n1.5;250\n2;700\n3;950\n4.5;1,310\n6.25;2,480\n")
-- the deck says what is meant
close(read("Weg [mm]\tKraft [cN]\n0,0\t0\n1,5\t640\n3,0\t1.310\n", { thousands = "." }).force[3], 13.10)
quiet()
close(read("Weg [mm]\tKraft [N]\n0,0\t0\n1,5\t0\n3,0\t1.310\n", { thousands = "none" }).force[3], 1.310)
-- no integer beside the groups: it is asked
fails("column 'Kraft': '1.310' may be 1310 or a number with decimals: column 'Weg' has a decimal comma ('0,5'); give thousands='.' or thousands='none'", read,
  "Weg [mm];Kraft [N]\n0,5;1.310\n1,5;2.640\n")
-- one sign in the whole file, which no other number shows to be that of decimals
r = read "Weg [mm];Kraft [N]\n0;0\n2;1.300\n4;2.950\n6;4.410\n"
close(r.force[2], 1.3)
told "column 'Kraft': '1.300' is read as a number with decimals, but '0' stands beside it without any: if its point stands between thousands (1300), give thousands='.', if not, thousands='none'"
r = read "Weg [mm];Kraft [N]\n0;0\n2;450\n4;1,213\n6;2,417\n"
close(r.force[3], 1.213)
told "if its comma stands between thousands (1213), give thousands=','"
for _, form in ipairs { "0.5;0\n2;1.300\n4;2.95\n", "0;0.000\n2;1.300\n4;2.950\n", "0;0\n2;1.213\n4;2.417\n" } do
  read("Weg [mm];Kraft [N]\n" .. form)
  quiet()
end
-- decimal points in one column, commas in the other: both are read, and it is told
r = read "Stroke (mm);Force (N)\n0.5;0,25\n1.5;1,125\n2.5;2,000\n"
close(r.displacement[2], 1.5e-3)
close(r.force[2], 1.125)
told("column 'Force': '0,25' is read with a decimal comma, where column 'Stroke' has a decimal point ('0.5')", 1)
r = read '"Traverse","Kraft"\n"mm","N"\n"0.5","0,25"\n"1.5","1,5"\n'
close(r.force[2], 1.5)
-- both in one column
fails("column 'Force': decimal points and decimal commas in one column: '1.5' and '0,25'; write all with one sign", read, "Stroke (mm);Force (N)\n0.5;0,25\n1.5;1.5\n2.5;2,75\n")
close(read('"Traverse (mm)","Kraft (N)"\n"0,00","0,0"\n"0,75","12,5"\n"1,50","27,25"\n').force[3], 27.25)

-- --- units in the cells ---
r = read "Elongation;Tension load;Clock\n0,0 mm;0,0 cN;0 s\n1,5 mm;120,5 cN;1 s\n3,0 mm;310,0 cN;2 s\n"
close(r.force[2], 1.205)
close(r.displacement[3], 3e-3)
r = read("Dehnung,Kraft\n0%,0N\n2.5%,12N\n5%,31.5N\n", { gauge_length = 0.08 })
close(r.strain[3], 0.05)
r = read("Time (s),Stroke,Load (N)\n0,0\u{a0}cm,0 N\n1,0.2\u{a0}cm,5 N\n2,0.4\u{a0}cm,11 N\n")
close(r.displacement[3], 4e-3)
close(r.force[3], 11)
fails("column 'Load': expected the unit of the force", read, "Stroke (mm),Load\n0,0 furlong\n1,5 furlong\n2,11 furlong\n")
fails(":2: column 'Load': its numbers carry different units, 'N' and 'kN'", read, "Stroke (mm),Load (N)\n0,0 N\n1,5 kN\n2,11 N\n")
fails("column 'Load': its numbers carry the unit 'cN', its heading names 'N'", read, "Stroke (mm),Load (N)\n0 mm,0 cN\n1 mm,5 cN\n2 mm,11 cN\n")
fails("column 'Load': some of its numbers carry the unit 'N', others none", read, "Stroke,Load\n0 mm,0\n1 mm,5 N\n2 mm,11 N\n")

-- --- names, and lines of headings ---
for _, heading in ipairs { "Traverse (mm);Kraft (N)", "Tool separation (mm);Standard force (N)", "Werkzeugabstand [mm];Pr\u{fc}flast [N]", "Traversa (mm);Carico (N)", "Traves\u{e3}o (mm)", "Jaw separation (mm);Load cell (N)",
  "Traverse (mm);Effort (N)", "Траверса (мм);Сила (Н)", "横梁位移 (mm);试验力 (N)", "つかみ具間距離 (mm);試験力 (N)", "크로스헤드 (mm);하중 (N)", "Backenabstand in mm;Zuglast in N" } do
  if heading:find ";" then
    r = read(heading .. "\n0;0\n1,5;3,5\n3;7,25\n")
    assert(math.abs(r.displacement[3] - 3e-3) < 1e-15 and r.force[2] == 3.5, heading)
  end
end
for _, heading in ipairs { "Time;Extension;Load\nCH1;CH2;CH3\ns;mm;cN", "Zeit;Traverse;Kraft\ns;mm;cN\nKanal A;Kanal B;Kanal C", "A;B;C\nZeit;Weg;Kraft\n[s];[mm];[cN]",
  "Time (s);Stroke (mm);Force (cN)\nfloat;float;float\nX;Y;Z", "Run;Run;Run\nTime;Stroke;Force\nsec;mm;cN\nraw;raw;raw" } do
  r = read(heading .. "\n0;0;0\n1;2,5;350\n2;5;725\n")
  assert(r.time[2] == 1 and math.abs(r.displacement[2] - 2.5e-3) < 1e-15 and math.abs(r.force[3] - 7.25) < 1e-12, heading)
end

-- --- pulls ---
local function rows(n, form, f)
  local out = {}
  for i = 0, n - 1 do out[#out + 1] = form:format(f(i)) end
  return table.concat(out)
end
local function force(u) return 2.3 * u + 0.9 * u ^ 2 end
local heading = "Time (s),Extension (mm),Load (N)\n"

-- signs the wrong way round: the advice is what helps
local both = heading .. rows(30, "%g,%.6f,%.6f\n", function(i) return 0.4 * i, -0.35 * i, -force(0.35 * i) end)
r = read(both)
assert(code(r, "reversed").which == "both" and r.force[30] < 0)
told "the frame counts a pull negative. reverse='both' changes both signs"
fails("reverse='both' changes both signs", tensile, both)
r = read(both, { reverse = "both" })
quiet()
close(r.displacement[30], 10.15e-3)
close(tensile(both, { reverse = "both" }).force[30], force(10.15))
local falling = heading .. rows(30, "%g,%.6f,%.6f\n", function(i) return 0.4 * i, 80 - 0.35 * i, force(0.35 * i) end)
fails("displacement falls from 0.08 to 0.06985 m while the force rises from 0 to 116.1 N: it is the position of a part that moves the other way. reverse='displacement' changes its sign, and zero=true takes the beginning off",
  tensile, falling)
close(tensile(falling, { reverse = "displacement", zero = true }).displacement[30], 10.15e-3)
fails("zero=true counts it from the beginning", tensile, falling, { reverse = "displacement" })
fails("reverse='displacement' changes its sign", tensile, falling, { zero = true })
local pushed = heading .. rows(30, "%g,%.6f,%.6f\n", function(i) return 0.4 * i, 0.35 * i, -force(0.35 * i) end)
fails("force runs from -116.1 to 0 N: a pull counts positive; change the sign of the record (reverse='force')", tensile, pushed)
close(tensile(pushed, { reverse = "force" }).force[30], force(10.15))
local own = { displacement = { 0, -1e-3, -2e-3, -3e-3 }, force = { 0, -2, -5, -9 } }
local made = { record = own, reverse = "both" }
for k, v in pairs(size) do made[k] = v end
close(lab.tensile(made).force[4], 9)
assert(own.force[4] == -9)

-- two pulls in one: with the time going on, and without a time
local function two(with_time, scale)
  return (with_time and heading or "Extension (mm),Load (N)\n") .. rows(50, with_time and "%g,%.6f,%.6f\n" or "%2$.6f,%3$.6f\n", function(i)
    local k = i % 25
    return 0.4 * i + (i >= 25 and 12 or 0), 0.35 * k, (i >= 25 and scale or 1) * force(0.35 * k)
  end)
end
local untimed = function(scale) return (two(true, scale):gsub("\n[%d.]+,", "\n"):gsub("^Time %(s%),", "")) end
for _, text in ipairs { two(true, 0.8), untimed(1.3), two(true, 1.3) } do
  r = read(text)
  assert(#r.force == 50 and code(r, "restart").row == 26)
  told "does another specimen begin here? It is read as the same, as a cycle whose way back is missing; restarts='specimens' reads 2 specimens"
  assert(code(tensile(text), "restart"))
  r = read(text, { restarts = "specimens" })
  quiet()
  assert(#r == 2 and #r[2].force == 25 and r[2].specimen == "2" and r[2].rows == 25)
  assert(#tensile(text, { restarts = "specimens" }) == 2)
  assert(not read(text, { restarts = "cycles" }).warnings)
  quiet()
end
-- after a break, too; a way back that was recorded is a cycle
local broken = heading .. rows(60, "%g,%.6f,%.6f\n", function(i)
  local k = i % 30
  return 0.4 * i, 0.35 * k, k > 26 and 1.5 or force(0.35 * k)
end)
assert(code(read(broken), "restart").row == 31)
local cycle = heading .. rows(90, "%g,%.6f,%.6f\n", function(i)
  local k = i < 30 and i or i < 60 and 59 - i or i - 59
  return 0.4 * i, 0.35 * k, force(0.35 * k)
end)
assert(not read(cycle).warnings)
quiet()
-- a column that names the tests parts them
for _, name in ipairs { "Test No", "Test", "Versuch Nr.", "Essai", "Prova" } do
  r = read((two(true, 0.9):gsub("^", name .. ","):gsub("\n()", function(at) return "\n" end):gsub("\n([%d.]+,)", function(t) return "\n" .. (tonumber(t:sub(1, -2)) < 10 and "7," or "8,") .. t end)))
  assert(#r == 2 and r[1].specimen == "7" and #r[2].force == 25, name)
end

-- an extensometer that is taken off: it stays where it was, or goes back to zero
for _, left in ipairs { 4.9, 0 } do
  local text = heading .. rows(40, "%g,%.6f,%.6f\n", function(i) return 0.4 * i, i > 14 and left or 0.35 * i, i > 37 and 3 or force(0.35 * i) end)
  r = read(text)
  assert(code(r, "extensometer").row == 15 and #r.force == 40, left)
  local test = tensile(text)
  assert(test.extensometer == 15 and #test.E == 15 and #test.force == 15 and #test.beyond.force == 40 and test.loading.last == 15 and code(test, "extensometer"))
  local fit = lab.fit { tests = { test } }
  assert(fit.tested <= test.E[15] * 1.0001)
end
-- a hold, a break and a coarse display are none
for _, f in ipairs {
  function(i) return 0.4 * i, 0.35 * math.min(i, 20), force(0.35 * math.min(i, 20)) * (i > 20 and 0.9 + 0.1 * math.exp(-0.2 * (i - 20)) or 1) end,
  function(i) return 0.4 * i, 0.35 * i, i > 30 and 2 or force(0.35 * i) end,
  function(i) return 0.4 * i, 1.4 * (i // 4), force(0.35 * i) end,
} do
  local t = heading .. rows(40, "%g,%.6f,%.6f\n", f)
  local test = tensile(t)
  assert(not test.extensometer and #test.E == 40)
end
-- strength without elongation
local folder = os.tmpname()
os.remove(folder)
for k = 1, 3 do
  fabric.write(("%s/warp-%d.csv"):format(folder, k), heading .. rows(40, "%g,%.6f,%.6f\n", function(i) return 0.4 * i, math.min(0.35 * i, k == 2 and 7 or 99), i > 36 and 3 or k * force(0.35 * i) end))
end
local table_ = lab.breaking_strength { folder = folder, gauge_length = 0.2, width = 0.05, breaks = {} }
close(table_.groups.warp.specimens[2].force, 2 * tonumber(("%.6f"):format(force(12.6))), "strength")
assert(table_.groups.warp.specimens[2].elongation == nil and table_.groups.warp.specimens[2].remark:find "extensometer taken off, no elongation" and table_.groups.warp.elongation.n == 2)
for k = 1, 3 do os.remove(("%s/warp-%d.csv"):format(folder, k)) end
os.remove(folder)

-- a zero that drifts below itself, before the pull and behind the break
local drifting = heading .. rows(60, "%g,%.6f,%.6f\n", function(i) return 0.4 * i, 0.35 * math.max(0, i - 20), i > 55 and -6 or force(0.35 * math.max(0, i - 20)) - 0.2 * math.min(i, 20) end)
r = tensile(drifting)
assert(code(r, "drift").text:find "force falls below zero, from 0 at the beginning to %-6 N in row 57, behind the largest force", code(r, "drift").text)
r = tensile(heading .. rows(60, "%g,%.6f,%.6f\n", function(i) return 0.4 * i, 0.35 * math.max(0, i - 20), force(0.35 * math.max(0, i - 20)) - 0.2 * math.min(i, 20) end))
assert(code(r, "drift").row == 21)

-- a strain without a unit: small ones are numbers, large ones are told, those above one are asked
local function strained(most) return "Strain,Load (N)\n" .. rows(20, "%.5f,%.5f\n", function(i) return most * i / 19, force(0.3 * i) end) end
assert(not read(strained(0.08), size.gauge_length and { gauge_length = 0.08 }).warnings)
r = read(strained(0.7), { gauge_length = 0.08 })
assert(code(r, "strain-unit").text:find "runs to 0.7 and its heading names no unit: it is read as a number, 70 %%")
assert(code(tensile(strained(0.7)), "strain-unit"))
assert(not read(strained(0.7), { gauge_length = 0.08, units = { strain = "-" } }).warnings)
close(read(strained(0.7), { gauge_length = 0.08, units = { strain = "%" } }).strain[20], 0.007)
fails("the strain runs to 1.2 and its heading names no unit", read, strained(1.2), { gauge_length = 0.08 })
