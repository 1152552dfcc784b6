-- From files as frames of other countries write them to a card: headings, units, forces per width, strains alone, a file of words, photographs in BMP.
local fabric = require "fabric"
local lab = fabric.lab
local folder = require "fabric.lab.folder"
local here = os.tmpname()
os.remove(here)
assert(os.execute("mkdir '" .. here .. "'"))

local function write(name, text)
  local f <close> = assert(io.open(here .. "/" .. name, "wb"))
  f:write(text)
end
local function close(got, want, relative, what)
  assert(math.abs(got - want) <= relative * math.abs(want), ("%s: %g, want %g"):format(what, got, want))
end
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails

-- Strips of 0.2 x 0.05 m, 1 mm thick, S = 8 MPa E + 400 MPa E^2 along the warp, half of it along the weft; shear by a bias pull of S12 = 0.5 MPa E12
-- whose forces are those of yarns that do not stretch.
local length, width, thickness = 0.2, 0.05, 1e-3
local card = lab.card { name = "made", density = 500, thickness = thickness, warp = { loading = { 8e6, 8e8 } }, weft = { loading = { 4e6, 4e8 } },
  shear = { loading = { 0.5e6 } }, assume = true }
local function pull(part)
  local rows = {}
  for k = 0, 120 do
    local e = 0.2 * k / 120
    local E = e + e ^ 2 / 2
    rows[k + 1] = { s = k / 10, u = e * length, P = part * (8e6 * E + 4e8 * E ^ 2) * width * thickness * (1 + e) }
  end
  return rows
end
local function bias()
  local d = {}
  for k = 0, 60 do d[k + 1] = 0.025 * k / 60 end
  local made, rows = lab.bias_shear { displacement = d, card = card, width = width, length = length, limit = 60 }, {}
  for k = 1, #d do rows[k] = { s = k / 10, u = d[k], P = made.force[k] } end
  return rows
end

-- A dialect: its heading and preamble, what it writes of a row, comma or point.
local function number(x, decimal) return (("%.9g"):format(x):gsub("%.", decimal)) end
local function text(dialect, rows)
  local lines = { dialect.heading }
  for _, row in ipairs(rows) do
    local cells = {}
    for i, value in ipairs(dialect.cells(row)) do cells[i] = number(value, dialect.decimal) end
    lines[#lines + 1] = table.concat(cells, dialect.separator)
  end
  return table.concat(lines, dialect.line or "\n") .. (dialect.line or "\n")
end
local function plain(row) return { row.s, row.u * 1e3, row.P } end
local function relative(row) return { row.s, 100 * row.u / length, row.P / width / 20 } end -- per cent, N/5cm
local dialects = {
  { name = "Zwick, German", heading = "Pr\u{fc}fzeit;Standardweg;Standardkraft\ns;mm;N", cells = plain, decimal = ",", separator = ";", line = "\r\n" },
  { name = "Zwick, Latin 1, strain and force per width", heading = "Pr\xfcfzeit;Dehnung;Kraft\ns;%;N/5cm", cells = relative, decimal = ",", separator = ";" },
  { name = "Mesdan, Italian", heading = "Rapporto di prova\nTempo (s);Allungamento (mm);Forza (N)", cells = plain, decimal = ",", separator = ";" },
  { name = "Mesdan, Italian, strain", heading = "tempo [s]\tdeformazione [%]\tcarico [N/5cm]", cells = relative, decimal = ",", separator = "\t" },
  { name = "Polish", heading = "Czas [s];Wyd\u{142}u\u{17c}enie [mm];Si\u{142}a [N]", cells = plain, decimal = ",", separator = ";" },
  { name = "Polish, strain", heading = "Czas [s];Odkszta\u{142}cenie [%];Obci\u{105}\u{17c}enie [N/5cm]", cells = relative, decimal = ",", separator = ";" },
  { name = "Shimadzu, Japanese", heading = "\u{6642}\u{9593},\u{30b9}\u{30c8}\u{30ed}\u{30fc}\u{30af},\u{8a66}\u{9a13}\u{529b}\nsec,mm,N", cells = plain, decimal = ".", separator = "," },
  { name = "Shimadzu, Shift-JIS", heading = "\x8e\x9e\x8a\xd4,\x95\xcf\x88\xca,\x89\xd7\x8fd\nsec,mm,N", cells = plain, decimal = ".", separator = ",", line = "\r\n" },
  { name = "Japanese, strain", heading = "\u{6642}\u{9593}(\u{79d2}),\u{3072}\u{305a}\u{307f}(%),\u{8377}\u{91cd}(N/5cm)", cells = relative, decimal = ".", separator = "," },
  { name = "French", heading = "Temps (s);Allongement (mm);Charge (N)", cells = plain, decimal = ",", separator = ";" },
  { name = "words of one's own", heading = "Minuutit;Venym\u{e4} (mm);Voima (pauna)", decimal = ",", separator = ";",
    cells = function(row) return { row.s / 60, row.u * 1e3, row.P / 4.4482216152605 } end, vocabulary = "'words.lua'" },
}
write("words.lua", "return { displacement = { 'venym\u{e4}' }, force = { 'voima' }, units = { force = { pauna = 4.4482216152605 } } }\n")

local about = "return { name='mine', gauge_length=0.2, width=0.05, thickness=1e-3, plies=1, density=500, markers={3, 2}, degree=2, bias={ yarns='inextensible' }%s }\n"
for _, dialect in ipairs(dialects) do
  write("laboratory.lua", about:format(dialect.vocabulary and ", vocabulary=" .. dialect.vocabulary or ""))
  write("warp-1.csv", text(dialect, pull(1)))
  write("weft-1.txt", text(dialect, pull(0.5)))
  write("bias-1.csv", text(dialect, bias()))
  local found = folder.reduce(here).card
  for direction, part in pairs { warp = 1, weft = 0.5 } do
    close(found[direction].loading[1], part * 8e6, 2e-3, dialect.name .. ": " .. direction .. " d0")
    close(found[direction].loading[2], part * 8e8, 2e-3, dialect.name .. ": " .. direction .. " d1")
    assert(found.provenance[direction .. ".loading"]:find "^fitted to 1 specimen", dialect.name)
    assert(found.provenance[direction .. ".unloading"]:find "^assumed", dialect.name)
  end
  close(fabric.point(found):strain({ E12 = 0.1 }).S12, 0.05e6, 0.02, dialect.name .. ": shear") -- half angles between rows
end
-- words that nobody knows name the file and what stands there
write("laboratory.lua", about:format "")
fails("expected a column of the displacement, there are Minuutit, Venym\u{e4}, Voima", folder.reduce, here)
write("laboratory.lua", about:format ", vocabulary='nowhere.lua'")
fails("nowhere.lua", folder.reduce, here)

-- --- photographs in BMP: a dot grid pulled along y, 8 bits with a palette, rows from the bottom, each filled up to four bytes ---
local function bmp(along, across)
  local w, h = 150, 210
  local rows, stride = {}, (w + 3) // 4 * 4
  for y = h - 1, 0, -1 do
    local bytes = {}
    for x = 0, w - 1 do
      local X, Y = (x - 75) / across, (y - 105) / along
      local c, r = math.max(-0.5, math.min(0.5, math.floor(X / 40) + 0.5)), math.max(-1, math.min(1, math.floor(Y / 40 + 0.5)))
      local away = math.sqrt((X - 40 * c) ^ 2 + (Y - 40 * r) ^ 2) - 8
      bytes[#bytes + 1] = string.char(math.floor(40 + 170 / (1 + math.exp(-2 * away)) + 0.5))
    end
    rows[#rows + 1] = table.concat(bytes) .. ("\0"):rep(stride - w)
  end
  local palette = {}
  for i = 0, 255 do palette[i + 1] = string.char(i, i, i, 0) end
  local pixels = table.concat(rows)
  local head = ("<I4i4i4I2I2I4I4i4i4I4I4"):pack(40, w, h, 1, 8, 0, #pixels, 2835, 2835, 256, 0)
  return ("<c2I4I2I2I4"):pack("BM", 14 + 40 + 1024 + #pixels, 0, 0, 14 + 40 + 1024) .. head .. table.concat(palette) .. pixels
end
local names, ratio = {}, 0.4
for i = 0, 4 do
  local E = 0.05 * i
  names[i + 1] = here .. "/photo" .. i .. ".bmp"
  write("photo" .. i .. ".bmp", bmp(math.sqrt(1 + 2 * E), math.sqrt(1 - 2 * ratio * E)))
end
local grid = lab.track { files = names, rows = 3, columns = 2 }
local seen = lab.poisson { specimens = { grid } }
close(seen.value, ratio, 0.01, "the ratio on photographs in BMP")
local lines = { "frame,marker,x,y" }
for f = 0, 4 do
  for m = 1, 6 do lines[#lines + 1] = ("%d,%d,%.9g,%.9g"):format(f, m, grid.x[6 * f + m], grid.y[6 * f + m]) end
end
write("laboratory.lua", about:format "")
for _, name in ipairs { "warp-1.csv", "bias-1.csv" } do write(name, text(dialects[1], name == "warp-1.csv" and pull(1) or bias())) end
os.remove(here .. "/weft-1.txt")
write("warp-1-markers.csv", table.concat(lines, "\n") .. "\n")
local of_bmp = folder.reduce(here).card
close(of_bmp.warp.poisson, ratio, 0.01, "the card's ratio from photographs in BMP")
assert(of_bmp.provenance["warp.poisson"]:find "^fitted to the markers of 1 specimen" and of_bmp.provenance["weft.loading"]:find "^assumed")
assert(os.execute("rm -r '" .. here .. "'"))
