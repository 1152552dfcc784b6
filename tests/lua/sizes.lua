-- A call that makes nodes, facets, shapes, rows or cells from a number or a file is refused before it fills the memory, with what was expected.
local fabric = require "fabric"
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails
local rigid, panel = fabric.rigid, fabric.mesh.panel

local function limb(more)
  local t = { upper = 0.3, lower = 0.26, radii = { 0.05, 0.04, 0.03 } }
  for k, v in pairs(more) do t[k] = v end
  return rigid.limb(t)
end
fails("limb: field 'size': expected at most 4000000 facets, got 32 x 5600", limb, { size = 1e-9 })
fails("limb: field 'size': expected at most 4000000 facets, got 50000 x ", limb, { around = 50000, size = 1e-4 })
fails("limb: field 'around': expected a count from 8 to 100000, got 3000000000", limb, { around = 3000000000 })
fails("limb: field 'every': expected at most 100000 shapes, got 2 s / 1e-08 s", limb, { bend = fabric.ramp(60, 2), duration = 2, every = 1e-8 })
fails("limb: field 'every': expected at most 4000000 facets, got 32 x 9", limb, { bend = fabric.ramp(60, 2), duration = 2, every = 1e-4 })
local sections = { { 0, 0.15, 0.1 }, { 0.2, 0.14, 0.1 } }
fails("torso: field 'size': expected at most 4000000 facets, got 48 x 20000026 (around, along)", rigid.torso, { sections = sections, size = 1e-8 })
fails("torso: field 'around': expected a count from 8 to 100000, got 200000", rigid.torso, { sections = sections, around = 200000 })

local lab, denim = fabric.lab, fabric.card "denim"
fails("synthetic: field 'rows': expected an integer from 10 to 1e+06, got 2e+06", lab.synthetic, { card = denim, rows = 2000000 })
fails("synthetic: field 'rows': expected at most 20000 for 500 specimens (10000000 rows in all), got 30000", lab.synthetic, { card = denim, rows = 30000, specimens = 500 })
fails("synthetic: field 'markers': expected at most 10000 markers, got 400 x 30", lab.synthetic, { card = denim, markers = { 400, 30 } })
fails("band: field 'draws': expected an integer from 100 to 1e+06, got 3e+06", lab.band, { specimens = { { 1 }, { 2 }, { 4 } }, draws = 3000000 })
fails("sobol_points: argument 'count': expected at most 500000 points of 200 dimensions, got 700000", require "fabric.kernels".sobol_points, 700000, 200)
fails("sample: argument 'n': expected an integer from 1 to 100000, got 2e+06", function() denim:sample(2000000) end)
local many = {}
for i = 1, 300 do many[i] = i end
fails("study: field 'parameters': expected lists whose combinations are at most 1000000 cases, got 2.7e+07", fabric.study,
  { parameters = { a = many, b = many, c = many }, run = function() return {} end })

local outline = { { 0, 0 }, { 0.4, 0, name = "a" }, { 0.4, 0.3, name = "b" }, { name = "c" } }
fails("panel: field 'holes': hole 1, piece 1: expected at most 4000000 nodes on all lines, got 4.18", panel, { size = 0.003, outline = outline, holes = { { circle = { 0.1, 0.1 }, radius = 2e4 } } })
fails("panel: field 'outline': edge 'a': expected at most 4000000 nodes on all lines, got 7e+08", panel,
  { size = 0.05, outline = { { 0, 0 }, { 0.4, 0, name = "a", elements = 700000000 }, { 0.4, 0.3, name = "b" }, { name = "c" } } })
fails("expected a size that gives at most 4000000 elements", panel, { size = 1e-5, outline = outline })
local path = os.tmpname() .. ".dxf"
fabric.write(path, "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n1\n90\n3\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n"
  .. "0\nCIRCLE\n8\n11\n10\n0.5\n20\n0.3\n40\n99000000\n0\nENDSEC\n0\nEOF\n")
fails("panel: field 'holes': hole 1, piece 2: expected at most 4000000 nodes on all lines", panel, { file = path, grain = 0, size = 0.02 })
os.remove(path)

-- --- spreadsheets, where Python has openpyxl: by the cells that are used, whatever lies between them ---
local book = os.tmpname()
os.remove(book)
book = book .. ".xlsx"
local function make(lines)
  local script = ([==[%%s -I -c "
import openpyxl
book = openpyxl.Workbook()
one = book.active
for row in [['Weg (mm)', 'Kraft (N)'], [0, 0], [1, 2], [2, 5], [3, 9]]:
    one.append(row)
%s
book.save('%s')
" 2>/dev/null]==]):format(lines, book)
  for _, python in ipairs { "python3", "/usr/bin/python3" } do
    if os.execute(script:format(python)) then return true end
  end
end
if make "one.cell(900000, 1, 3)\none.cell(900000, 2, 11)" then
  local r = fabric.lab.read { file = book }
  assert(#r.force == 5 and r.force[5] == 11 and r.lines[5] == 900000)
  make "one.cell(1000000, 15000, 'x')"
  fabric.lab.read { file = book, columns = { displacement = 1, force = 2 } }
  make "pass"
  os.execute(([==[python3 -I -c "
import zipfile
with zipfile.ZipFile('%s') as old: parts = {name: old.read(name) for name in old.namelist()}
sheet = 'xl/worksheets/sheet1.xml'
parts[sheet] = parts[sheet].replace(b'</sheetData>', b'</sheetData><mergeCells><mergeCell ref=\x22A7:XFD900000\x22/></mergeCells>')
with zipfile.ZipFile('%s', 'w') as new:
    for name, data in parts.items(): new.writestr(name, data)
"]==]):format(book, book))
  fails("openpyxl cannot read this spreadsheet: expected at most 8000000 cells, got 14745", fabric.lab.read, { file = book })
  make "for i in range(3000): one.cell(10 + i, 10 + i, i)"
  fails("expected at most 8000000 cells in the rows and columns that are used, got 9", fabric.lab.read, { file = book })
  make "for i in range(9): book.create_sheet(str(i)).cell(1000000, 1, 3)"
  fails("expected at most 8000000 rows, got", fabric.lab.read, { file = book })
else
  print "SKIPPED: spreadsheets, since no Python with openpyxl is installed (apt install python3-openpyxl)"
end
os.remove(book)
