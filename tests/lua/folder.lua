-- A folder of measurements: what counts as a specimen, what laboratory.lua must say; the card that comes of it.
local fabric = require "fabric"
local lab = fabric.lab
local folder = require "fabric.lab.folder"

local sample = arg[0]:gsub("tests/lua/[^/]*$", "") .. "share/data/synthetic-blend/"
local place = os.tmpname()
os.remove(place)
assert(os.execute("mkdir '" .. place .. "'"))

local function write(name, text)
  local f = assert(io.open(place .. "/" .. name, "w"))
  f:write(text)
  f:close()
end
local function remove(name) assert(os.remove(place .. "/" .. name)) end
local function text_of(name)
  local f = assert(io.open(sample .. name))
  local text = f:read "a"
  f:close()
  return text
end
local function refused(words)
  local ok, message = pcall(folder.reduce, place)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end

for _, name in ipairs(fabric.folder(sample)) do
  if name:find "%-[12][%-.]" or name == "laboratory.lua" then write(name, text_of(name)) end
end
local clean = folder.reduce(place)
assert(#clean.warp.tests == 2 and #clean.weft.tests == 2 and #clean.shear.tests == 2)

-- forces of the wrong sign, with markers
write("bias-1-frames.csv", (text_of("bias-1-frames.csv"):gsub("\t(%-?[%d.]+)\n", "\t-%1\n"):gsub("\t%-%-", "\t")))
refused "bias-1-frames.csv: field 'force': force runs from -"
write("bias-1-frames.csv", text_of "bias-1-frames.csv")

-- pictures of an earlier run and copies are no specimens
write("warp-residual.svg", "<svg/>")
write("warp-1.bak", text_of "warp-1.csv")
write("bias-1-frames.bak", "")
local again = folder.reduce(place)
assert(#again.warp.tests == 2 and #again.shear.tests == 2 and again.card.warp.loading[1] == clean.card.warp.loading[1])
write("warp-1.txt", text_of "warp-1.csv")
refused "expected one file for specimen 1, got warp-1.csv and warp-1.txt"
remove "warp-1.txt"

-- laboratory.lua
local about = text_of "laboratory.lua"
local function with(from, to)
  local text, count = about:gsub(from, to)
  assert(count == 1)
  write("laboratory.lua", text)
end
with("return {", "local about = {")
refused "laboratory.lua: expected 'return { name=, gauge_length=, ... }' at its end, got nil"
with("markers = { 4, 3 }, ", "")
refused "laboratory.lua: field 'markers': expected {rows, columns} of the grid, for "
with("mass_per_area = 0.2242, ", "")
refused "laboratory.lua: field 'density': expected density (kg/m^3) or mass_per_area (kg/m^2)"
with("gauge_length = 76.2e%-3", "gauge_lenght = 76.2e-3")
refused "laboratory.lua: unknown field 'gauge_lenght', did you mean 'gauge_length'?"
with("width = 25.4e%-3, ", "")
refused "laboratory.lua: field 'width': expected a length in m, got nil"
with("return {", "return { default_units = { displacement = 'furlong' },")
refused "field 'default_units.displacement': 'furlong' is no unit of length known"
with("return {", "return { default_units = 'mm',")
refused "laboratory.lua: field 'default_units': expected {displacement='mm', force='N'}, got mm"
with("return {", "return { default_units = { displacement = 'mm', force = 'N' },")
assert(folder.reduce(place).card.warp.loading[1] == clean.card.warp.loading[1])
remove "laboratory.lua"
refused "laboratory.lua"
write("laboratory.lua", about)

-- whatever there is makes a card: no bias tests, one direction alone, no markers; what is missing is assumed, and named with its test
local function without(pattern)
  for _, name in ipairs(fabric.folder(place)) do
    if name:find(pattern) then remove(name) end
  end
  return folder.reduce(place)
end
local function says(result, field, words) assert((result.card.provenance[field] or "nothing"):find(words, 1, true) == 1, field) end
local part = without "^bias"
assert(not part.shear and part.card.warp.loading[1] == clean.card.warp.loading[1] and #part.further == 3)
says(part, "shear.loading", "assumed: straight, 0.09 of")
assert(part.further[1].field == "bending" and part.further[1].test:find "^cantilevers" and part.further[2].field == "shear.loading" and part.further[2].test:find "a bias pull")
part = without "^weft"
assert(not part.weft and #part.further == 6)
says(part, "weft.loading", "assumed: as the warp's")
part = without "markers"
says(part, "warp.poisson", "assumed: 0.4")
says(part, "warp.unloading", "fitted to 2 specimens")

-- three pulls to rupture, and a bias pull without markers
for i = 1, 3 do
  local rows = { "Extension (mm),Load (N)" }
  for k = 0, 200 do rows[#rows + 1] = ("%.5f,%.4f"):format(k * 0.05, (1 + 0.02 * i) * (k * 0.5 + 0.005 * k ^ 2)) end
  for k = 1, 7 do rows[#rows + 1] = ("%.5f,%g"):format(10 + 0.05 * k, 3 / k) end
  write("warp-" .. i .. ".csv", table.concat(rows, "\n") .. "\n")
end
local bias_pull = "Extension (mm),Load (N)\n0,0\n2,1\n4,1.5\n6,2.2\n8,3\n10,4.1\n12,5.5\n14,7.5\n16,10\n18,14\n20,19\n"
write("bias-1.csv", bias_pull)
part = folder.reduce(place)
assert(part.warp.tests[1].failure == 201 and not part.warp.fit.unloading and part.warp.spread and part.shear.without_markers)
says(part, "warp.unloading", "assumed: 4 times the steepest tangent")
says(part, "shear.loading", "fitted to 1 specimen")
assert(part.card:check().ok and part.shear.fit.tested <= math.sin(math.rad(30)) / 2 + 1e-9)
local report = require "fabric.lab.report"
local drawn, plot = {}, fabric.plot
fabric.plot = function(t)
  drawn[t.file:match "[^/]*$"] = t
  return plot(t)
end
local figures, rows = report.write(part, place .. "/out")
fabric.plot = plot
-- the words of the axes, and a frame on which no mark lies
assert(drawn["shear.svg"].xlabel == "shear strain E12" and drawn["shear-residual.svg"].xlabel == "shear strain E12" and drawn["warp.svg"].xlabel == "Green-Lagrange strain E")
for _, name in ipairs { "warp.svg", "shear.svg" } do
  for _, axis in ipairs { "x", "y" } do
    local low, high = table.unpack(drawn[name][axis .. "range"])
    for _, c in ipairs(drawn[name].curves) do
      for _, v in ipairs(c[axis] or {}) do assert(v > low + 0.01 * (high - low) and v < high - 0.01 * (high - low), name) end
    end
  end
end
assert(figures.warp.residual < 0.02 and figures.shear and not figures.weft and #report.contradictions(figures) == 0)
local html = io.open(place .. "/out/report.html"):read "a"
for _, words in ipairs { "What further tests would settle", "weft.loading<td>pulls along the weft", "assumed: as the warp's", "specimens to E = " } do
  assert(html:find(words, 1, true), words)
end
local found
for _, row in ipairs(rows) do found = found or row[1] == "weft ratio" and row[5]:find "^assumed: 0.4" end
assert(found)
-- a card that its specimens contradict is said to be one
local stiff = part.card.warp.loading
for i, d in ipairs(stiff) do stiff[i] = 2 * d end
part.card = part.card:with { warp = { loading = stiff, unloading = 2 * part.card.warp.unloading } }
figures = report.write(part, place .. "/out")
assert(report.contradictions(figures)[1]:find "^The data contradict the card in warp: over %d+ %% of the strain")
-- frames without their markers are a pull without markers, which begins with noise below zero; beside tests with markers it is left out, and told
write("bias-2-frames.csv", "Extension (mm),Load (N)\n-0.001,0\n0,0\n2,1\n4,1.5\n6,2.2\n8,3\n10,4.1\n12,5.5\n14,7.5\n16,10\n18,14\n20,19\n")
part = folder.reduce(place)
assert(part.shear.without_markers and #part.shear.tests == 2 and #part.shear.tests[2].E == #part.shear.tests[1].E)
remove "bias-2-frames.csv"
-- parts that are asked for and no file can give
with("return {", "return { loops = true, viscous = true,")
remove "bias-1.csv"
local warned, warn = {}, fabric.warn
fabric.warn = function(words) warned[#warned + 1] = words end
part = folder.reduce(place)
fabric.warn = warn
assert(#part.missed == 2 and part.missed[1] == "loops=true, but no record of a yarn's pull comes back, so there is no loop", part.missed[1])
assert(warned[#warned]:find("laboratory.lua: viscous=true, but there is no bias pull, so that relaxation cannot be determined", 1, true), warned[#warned])
report.write(part, place .. "/out")
assert(io.open(place .. "/out/report.html"):read("a"):find("<p>viscous=true, but there is no bias pull", 1, true))
write("laboratory.lua", about)
write("bias-1.csv", bias_pull)
-- a bias pull alone: the yarns go by its shear
part = without "^warp"
assert(not part.warp and not part.weft and #part.further == 8)
says(part, "warp.loading", "assumed: straight, 11 times the initial modulus in shear")
says(part, "shear.loading", "fitted to 1 specimen")
assert(report.write(part, place .. "/out").shear)
-- where the shear stiffens, that rule would let the yarns stretch in a test that is evaluated as if they did not: E = S12 at its end over 1 %
do
  local card = fabric.lab.card { name = "bias", density = 500, thickness = 1e-3, assume = true, shear = { loading = { 1e5, 0, 9e7 }, tested = 0.4 } }
  local stiff = (1e5 * 0.4 + 9e7 * 0.4 ^ 3 / 3) / 0.01
  assert(math.abs(card.warp.loading[1] / stiff - 1) < 1e-12 and card.provenance["weft.loading"]:find("assumed: straight, 196 MPa, with which the yarns stretch by 1 %", 1, true),
    card.provenance["weft.loading"])
  -- an assumption is told where it is written for others
  local before = #warned
  fabric.warn = function(words) warned[#warned + 1] = words end
  local out = fabric.export.card { card = card, to = "abaqus" }
  fabric.warn = warn
  assert(#warned == before + 1 and warned[#warned]:find("export: card 'bias': the loading of the warp and weft was not measured, it is assumed (straight, 196 MPa", 1, true), warned[#warned])
  assert(out.report:find "not measured: warp.loading, assumed: straight, 196 MPa" and out.report:find "not measured: warp.poisson, assumed: 0.4")
end
-- a yarn that softens to a tenth of its first modulus: the assumed ratio is less, and where no strip can be run the report says so
local soft = { "Extension (mm),Load (N)" }
for k = 0, 249 do soft[#soft + 1] = ("%.4f,%.5f"):format(0.04 * k, 100 * (1 - math.exp(-k / 60))) end
write("warp-1.csv", table.concat(soft, "\n") .. "\n")
part = folder.reduce(place)
says(part, "warp.poisson", "assumed: 0.1 (0.12 to 2.04 on the shipped cloths), since no markers were tracked; not 0.4, since the yarn softens")
figures = report.write(part, place .. "/out")
assert(figures.warp.residual < 0.02 and figures.warp.trouble:find "the law at a point takes its place" and report.contradictions(figures)[1] == "warp: " .. figures.warp.trouble)
assert(part.card.provenance["warp.loading"]:find "1 specimen" and not (part.card.bands and part.card.bands.warp))
-- cantilevers: bending with its band, in card, table and page; without strips at 45 degrees the twist is assumed, and the test that tells it is named
with("return {", "return { cantilevers = { warp = { 0.021, 0.022, 0.0215 }, weft = { 0.018, 0.0184 }, bias = { 0.0196, 0.0201 } },")
part = folder.reduce(place)
assert(part.card.bands.bending and math.abs(part.card.bending.weft / (9.80665 * 0.2242 * (0.018 ^ 3 + 0.0184 ^ 3) / 2) - 1) < 1e-12 and part.card.bands.bending.low[3] > 0)
says(part, "bending", "measured: cantilevers, 3 along the warp, 2 along the weft, 2 along the bias")
for _, f in ipairs(part.further) do assert(not f.field:find "^bending", f.field) end
local _, table_rows = report.write(part, place .. "/out")
local last = table_rows[#table_rows]
assert(last[1] == "bending twist" and last[3]:find "^%S+ to %S+$" and last[4] == "uN.m" and last[5] == "likewise", table.concat(last, " "))
with("return {", "return { cantilevers = { warp = { 0.021, 0.022 }, weft = { 0.018, 0.0184 } },")
part = folder.reduce(place)
assert(part.further[1].field == "bending.twist" and part.further[1].test:find "45 degrees")
with("return {", "return { bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6 }, cantilevers = { warp = 0.02, weft = 0.02 },")
refused "laboratory.lua: field 'cantilevers': expected either bending or cantilevers, got both"
with("return {", "return { cantilevers = { warp = 0.02 },")
refused "field 'cantilevers': expected strips along warp and weft, got those along one alone"
with("return {", "return { cantilevers = { warp = 21, weft = 0.02 },")
refused "field 'cantilevers': expected bending lengths of warp in m, 0.001 to 0.5 (half of the overhang), got 21"
with("return {", "return { cantilevers = { wrap = 0.02, weft = 0.02 },")
refused "field 'cantilevers': expected warp, weft and bias, got 'wrap'"
with("plies = 2,", "")
refused "laboratory.lua: field 'plies': expected 1 (a strip in two clamps) or 2 (a loop on two pins), got nil"
write("laboratory.lua", about)

local ok, message = pcall(folder.reduce)
assert(not ok and message:find("^" .. arg[0]:gsub("%p", "%%%0") .. ":%d+: laboratory: expected the name of a folder, got nil$"), message)
assert(os.execute("rm -r '" .. place .. "'"))

-- One replicate of four that only loads: the loading keeps its band, the unloading that of the three others.
local function test(scale, back)
  local E, S, n = {}, {}, 60
  for i = 0, n do E[i + 1] = i / 300; S[i + 1] = scale * (8e6 * E[i + 1] + 4e8 * E[i + 1] ^ 2) end
  local branches = { { kind = "loading", first = 1, last = n + 1 } }
  if back then
    for i = 1, 10 do E[n + 1 + i] = E[n + 1] - i * 1e-4; S[n + 1 + i] = S[n + 1] - scale * 900e6 * i * 1e-4 end
    branches[2] = { kind = "unloading", first = n + 2, last = n + 11 }
  end
  return { E = E, S = S, branches = branches }
end
local whole = lab.fit { tests = { test(1, true), test(1.02, true), test(0.97, true), test(1.01, true) }, degree = 2 }
for hole = 1, 4 do
  local tests = {}
  for i, scale in ipairs { 1, 1.02, 0.97, 1.01 } do tests[i] = test(scale, i ~= hole) end
  local part = lab.fit { tests = tests, degree = 2 }
  local points = lab.fit { tests = tests, degree = "monotone" }
  local card = lab.card { name = "mine", density = 600, thickness = 4e-4, warp = part, weft = whole, shear = points, poisson = { warp = 0.2, weft = 0.3 } }
  local bands = card.bands
  for i = 1, 2 do
    assert(bands.warp.low[i] == part.band.low[i] and bands.warp.high[i] == part.band.high[i] and bands.warp.low[i] < bands.warp.high[i])
    assert(bands.weft.low[i] == whole.band.low[i])
  end
  assert(bands.warp.low[3] == part.unloading_band.low[1] and bands.warp.low[3] < part.unloading and part.unloading < bands.warp.high[3])
  assert(bands.warp.covariance[2 * 4 + 3] == part.unloading_band.covariance[1] and bands.warp.covariance[3] == 0)
  assert(card.source == "warp: 4 specimens, polynomial of degree 2; weft: 4 specimens, polynomial of degree 2; shear: 4 specimens, monotone curve", card.source)
end
