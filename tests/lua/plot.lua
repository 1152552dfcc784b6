-- fabric.plot: units on the axes, curves by the names of fields, letters without a file, what it refuses.
local fabric = require "fabric"

local function fails(words, t)
  local ok, message = pcall(fabric.plot, t)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end

local rows = { { E = 0.001, S = 1e6 }, { E = 0.05, S = 4e6 } }
fails("field 'xunit': unknown unit 'mmm', did you mean 'mm'?", { xunit = "mmm", curves = { { x = { 1 }, y = { 1 } } } })
fabric.units[{}], fabric.units[1.5] = 1, 2  -- names are texts
fails("field 'xunit': unknown unit 'mmm', did you mean 'mm'?", { xunit = "mmm", curves = { { x = { 1 }, y = { 1 } } } })
fails("field 'curves[1].y': expected a list of numbers; a name goes with rows", { curves = { { x = { 1 }, y = "S" } } })
fails("field 'curves[1].rows[1].T': expected a number, got nil", { curves = { { rows = rows, x = "E", y = "T" } } })
fails("field 'curves[1].rows[2]': expected a table, got 7", { curves = { { rows = { rows[1], 7 }, x = "E", y = "S" } } })
fails("field 'curves[1]': expected x and y of one length, got 2 and 1", { curves = { { rows = rows, x = "E", y = { 1 } } } })
fails("field 'xrange': expected {low, high} in SI, low below high", { xrange = { 2, 1 }, curves = { { x = { 1 }, y = { 1 } } } })
fails("field 'curves[1].y': expected a list of numbers, got nil at place 2", { curves = { { x = { 1, 2, 3 }, y = { 1, nil, 3 } } } })
fails("field 'curves[1].x': expected a list of numbers, got an empty table", { curves = { { x = {}, y = {} } } })
if not os.execute "gnuplot --version >/dev/null 2>&1" then
  print "SKIPPED: gnuplot is not installed"
  return
end

-- quotients of units, as laboratories write them
fails("field 'yunit': unknown unit 'N/5furlong'", { yunit = "N/5furlong", curves = { { x = { 1 }, y = { 1 } } } })
fails("field 'yunit': unknown unit 'N/1.2.3cm'", { yunit = "N/1.2.3cm", curves = { { x = { 1 }, y = { 1 } } } })
fails("field 'yunit': unknown unit 'N/0mm'", { yunit = "N/0mm", curves = { { x = { 1 }, y = { 1 } } } })
for unit, top in pairs { ["N/5cm"] = 20, ["daN/5cm"] = 200, ["cN/tex"] = 1e4, daN = 10 } do
  local drawn = fabric.plot { ylabel = "pull", yunit = unit, yrange = { 0, 7 * top }, curves = { { x = { 0, 1 }, y = { 0, 6 * top } } } }
  assert(drawn:find("pull, " .. unit, 1, true) and drawn:find "\n +7 " and not drawn:find "\n +8 ", drawn)
end

local text = fabric.plot { title = "pull", xlabel = "strain", xunit = "%", ylabel = "stress", yunit = "MPa", xrange = { 0, 0.06 },
  curves = { { rows = rows, x = "E", y = "S", label = "simulated" }, { x = { 0.02 }, y = { 2e6 }, label = "measured", style = "points" } } }
for _, word in ipairs { "pull: stress, MPa", "strain, %", "simulated", "measured", "o" } do assert(text:find(word, 1, true), text) end
assert(text:find "\n +4 " and text:find " 6\n", text) -- 4 MPa and 6 %
local named = fabric.plot { ynames = { "pulls", "shear" }, curves = { { x = { 0, 3 }, y = { 1, 1 } }, { x = { 0, 2 }, y = { 2, 2 } } } }
assert(named:find "shear +" and named:find "pulls +" and not named:find "\n +1 ", named)
local wide = fabric.plot { columns = 40, lines = 12, curves = { { x = { 0, 1 }, y = { 0, 1 } } } }
for line in wide:gmatch "[^\n]+" do assert(#line <= 41) end
local file = os.tmpname() .. ".svg"
assert(fabric.plot { file = file, log = "xy", curves = { { x = { 1, 10 }, y = { 1, 100 } } } } == true)
assert(io.open(file):read "a":find "</svg>")

-- A number that is not finite is a gap: the curve is drawn in two pieces.
local nan = 0 / 0
assert(fabric.plot { file = file, curves = { { x = { 0, 1, 2, 3, 4 }, y = { 0, 1, nan, 1, 0 }, label = "two" },
  { rows = { { E = 0, S = 1 }, { E = 1, S = 2 }, { E = 2, S = -1 / 0 } }, x = "E", y = "S" } } })
local function content(path)
  local f <close> = assert(io.open(path))
  return f:read "a"
end
local curve = content(file):match 'id="gnuplot_plot_1".-id="gnuplot_plot_2"'
local _, pieces = curve:gsub("%f[%u]M", "")
assert(pieces == 2, curve)
fails("curve 'none': nothing to draw: none of its 2 points is finite", { curves = { { x = { 0, 1 }, y = { nan, nan }, label = "none" } } })

-- Labels are what was asked for, in a file that viewers open: every printable character before every digit, quotes, letters of
-- other alphabets, and what gnuplot takes for mark-up, an escape, a command, a macro or a format.
local svg = dofile((arg[0]:gsub("lua/[^/]*$", "deck/svg.lua")))
local words = { "0.25 mm/s", "ISO 13934-1", "2-3-4", "0,5 (1) [2] {3}", "it's \"quoted\" 'twice'", "''", "`date`", "@macro $1 #2 %d %% ~a",
  "a_b^2 {/:Bold c} &{d}", "\\101 \\n \\", "a\\", "<b>&amp;</b> ]]>", "Dehnung ε₁₁, µm – „Köper“ 綾織", "notitle", "columnhead" }
for first = 33, 126, 47 do
  local all = {}
  for byte = first, first + 46 do
    for digit = 0, 9 do all[#all + 1] = string.char(byte) .. digit end
  end
  words[#words + 1] = table.concat(all)
end
for _, word in ipairs(words) do
  assert(fabric.plot { file = file, title = word .. "t", xlabel = word .. "x", ylabel = word, curves = { { x = { 0, 1 }, y = { 0, 1 }, label = word .. "k" } } })
  local missing = svg.missing(svg.read(content(file)), { word, word .. "t", word .. "x", word .. "k" })
  assert(not missing, missing)
end
-- Characters that no text may hold are replaced.
assert(fabric.plot { file = file, title = "a\tb\1c\255d\xed\xa0\x80e", curves = { { x = { 0, 1 }, y = { 0, 1 } } } })
assert(not svg.missing(svg.read(content(file)), { "a b c\u{fffd}d\u{fffd}\u{fffd}\u{fffd}e" }))
os.remove(file)

-- The three ways of giving a list of rows, and a table of lists, draw the same.
local svg_of = function(fields, ...)
  assert(fabric.plot(fields, ...))
  return content(file)
end
local lists = { E = { 0.001, 0.05 }, S = { 1e6, 4e6 } }
local same = svg_of { file = file, xlabel = "E", ylabel = "S", curves = { { rows = rows, x = "E", y = "S" } } }
assert(svg_of(rows, "E", "S", { file = file }) == same)
assert(svg_of { file = file, rows = rows, x = "E", y = "S" } == same)
assert(svg_of(lists, "E", "S", { file = file }) == same and svg_of({ curve = rows }, "E", "S", { file = file }) == same)
assert(fabric.plot(rows, "E", "S"):find "E", "letters without a file")
local both = svg.read(svg_of(rows, "E", { "S", "E" }, { file = file, yunit = "MPa" }))
assert(not svg.missing(both, { "S", "E", "MPa" }))

-- Size, in mm; letters of the size and family asked for; the page white.
local mm = fabric.units.mm
local head = svg_of { file = file, size = { 120 * mm, 45.5 * mm }, font = "Times", font_size = 7, curves = { { x = { 0, 1 }, y = { 0, 1 } } } }
assert(head:find('width="120.00mm"', 1, true) and head:find('height="45.50mm"', 1, true))
local left, bottom, width, height = head:match 'viewBox="([%d.]+) ([%d.]+) ([%d.]+) ([%d.]+)"'
assert(tonumber(left) == 0 and tonumber(bottom) < 1)
assert(math.abs(width / 72 * 25.4 - 120) < 0.01 and math.abs(height / 72 * 25.4 - 45.5) < 0.01)
for size in head:gmatch 'font%-size="([%d.]+)"' do assert(tonumber(size) == 7) end
assert(head:find('font-family="Times"', 1, true) and same:find('font-family="Helvetica,Arial,sans-serif"', 1, true))
assert(same:find('width="85.00mm"', 1, true) and same:find('height="60.00mm"', 1, true))
-- No line is thinner than a quarter of a point. (The outlines of gnuplot's marks are in parts of their size.)
for line in (head:match "</defs>(.*)"):gmatch 'stroke%-width="([%d.]+)"' do assert(tonumber(line) >= 0.25, line) end

-- Bands, error bars, colours, and nothing but a band.
local E, S, low, high = { 0, 0.1, 0.2 }, { 0, 2, 5 }, { 0, 1.5, 4 }, { 0, 2.5, 6 }
local function curves_of(curve)
  local texts, count = svg.read(svg_of { file = file, curves = { curve } })
  return count, texts
end
assert(curves_of { x = E, y = S } == 1 and curves_of { x = E, y = S, band = { low = low, high = high } } == 2)
assert(curves_of { x = E, y = S, error = 0.5 } == 2 and curves_of { x = E, y = S, error = { 0.1, 0.2, 0.3 }, style = "points" } == 2)
assert(curves_of { x = E, y = S, error = { low = low, high = high }, band = { low = low, high = high }, style = "line_points" } == 4)
local count, texts = curves_of { x = E, band = { low = low, high = high }, label = "95 %" }
assert(count == 1 and not svg.missing(texts, { "95 %" }))
local spread = { { E = 0, m = 1, s = 0.1, a = 0, b = 2 }, { E = 1, m = 2, s = 0.2, a = 1, b = 3 } }
assert(curves_of { rows = spread, x = "E", y = "m", error = "s", band = { low = "a", high = "b" } } == 3)
assert(svg_of { file = file, curves = { { x = E, y = S, colour = "#123456" } } }:find "rgb%( *18, *52, *86%)")
-- The axes hold the ends of bars and bands: 5 +- 3 reaches 8.
assert(not svg.missing(svg.read(svg_of { file = file, curves = { { x = E, y = S, error = { 1, 1, 3 }, style = "points" } } }), { "8" }))
-- Error bars along x: three strokes for each point, as long as asked for, and the axis holds their ends.
local across = { x = { 1, 2, nan }, y = { 3, 4, 5 }, xerror = { 0.5, 1, 1 }, style = "points" }
local picture_of = svg_of { file = file, xrange = { 0, 4 }, yrange = { 0, 8 }, curves = { across } }
local _, strokes = picture_of:match('id="gnuplot_plot_1".-id="gnuplot_plot_2"'):gsub("%f[%u]M", "")
assert(strokes == 6, picture_of)
local lengths = {}
for x1, y1, x2, y2 in picture_of:match('id="gnuplot_plot_1".-id="gnuplot_plot_2"'):gmatch "M([%d.]+),([%d.]+) L([%d.]+),([%d.]+)" do
  if y1 == y2 then lengths[#lengths + 1] = x2 - x1 end
end
assert(#lengths == 2 and math.abs(lengths[2] / lengths[1] - 2) < 0.01, table.concat(lengths, " "))
assert(not svg.missing(svg.read(svg_of { file = file, curves = { { x = { 1, 5 }, y = { 0, 1 }, xerror = 3 } } }), { "8" }))
assert(curves_of { rows = spread, x = "E", y = "m", xerror = "s", error = "s", style = "points" } == 3)
assert(curves_of { x = E, y = S, xerror = { low = low, high = high } } == 2)
fails("field 'curves[1].xerror': expected lengths of at least 0, got -1 at place 1", { curves = { { x = { 1 }, y = { 1 }, xerror = -1 } } })
fails("field 'curves[1].xerror': expected as many as there are points, got 2 for 1", { curves = { { x = { 1 }, y = { 1 }, xerror = { 1, 2 } } } })
fails("field 'curves[1].xerror': expected y beside it", { curves = { { x = { 1 }, band = { low = { 0 }, high = { 1 } }, xerror = 1 } } })

-- A band is interrupted where one of its ends is not a number.
assert(curves_of { x = { 0, 1, 2, 3, 4 }, y = { 0, 1, 2, 3, 4 }, band = { low = { 0, 0, nan, 2, 3 }, high = { 1, 2, 3, 4, 5 } } } == 2)

-- Keys where they are asked for, or none.
local line = { x = E, y = S, label = "a line" }
for _, key in ipairs { "best", "top left", "top right", "bottom left", "bottom right", "below", "right" } do
  assert(not svg.missing(svg.read(svg_of { file = file, key = key, curves = { line } }), { "a line" }))
end
assert(svg.missing(svg.read(svg_of { file = file, key = "none", curves = { line } }), { "a line" }))

-- Panels: what one does not say is taken from the call; letters; curves are numbered through.
local panels = { { title = "warp", curves = { line } }, { curves = { line, line }, yunit = "kPa" }, { rows = rows, x = "E", y = "S", xunit = "" } }
local page = svg_of { file = file, xlabel = "strain", xunit = "%", ylabel = "stress", yunit = "MPa", panels = panels }
texts, count = svg.read(page)
assert(count == 4 and page:find('width="170.00mm"', 1, true) and page:find('height="120.00mm"', 1, true))
assert(not svg.missing(texts, { "(a) warp", "(b)", "(c)", "strain, %", "strain", "stress, MPa", "stress, kPa" }))
assert(svg.missing(svg.read(svg_of { file = file, letters = false, layout = { 1, 3 }, panels = panels }), { "(b)" }))
assert(fabric.plot { panels = panels }:find("warp", 1, true), "in letters one stands below the other")

-- A PNG has the pixels of its size and says how many an inch has.
local picture = os.tmpname() .. ".png"
assert(fabric.plot { file = picture, size = { 50.8 * mm, 25.4 * mm }, dpi = 200, font_size = 6, curves = { { x = E, y = S } } })
local bytes = content(picture)
local wide_, high_ = string.unpack(">I4I4", bytes, 17)
assert(wide_ == 400 and high_ == 200, wide_ .. " x " .. high_)
local place = assert(bytes:find("pHYs", 1, true))
local per_metre, _, unit = string.unpack(">I4I4B", bytes, place + 4)
assert(place == 38 and per_metre == 7874 and unit == 1) -- 200 / 0.0254
assert(bytes:byte(26) == 2 or bytes:byte(26) == 6)      -- colours
os.remove(picture)

-- A PDF has the size of its page, to the point, and its words as words.
local paper = os.tmpname() .. ".pdf"
assert(fabric.plot { file = paper, size = { 85 * mm, 60 * mm }, xlabel = "strain", ylabel = "stress", yunit = "MPa", curves = { line } })
bytes = content(paper)
local across, up = bytes:match "/MediaBox %[ 0 0 (%d+) (%d+) %]"
assert(across == "241" and up == "170", across)
if os.execute "pdftotext -v >/dev/null 2>&1" then
  os.execute(("pdftotext '%s' '%s.txt'"):format(paper, paper))
  local words = content(paper .. ".txt")
  for _, word in ipairs { "strain", "stress, MPa", "a line", "0.05" } do assert(words:find(word, 1, true), words) end
  os.remove(paper .. ".txt")
else
  print "SKIPPED: pdftotext is not installed; the words of a PDF were not read"
end
os.remove(paper)

-- An EPS has the size of its page, lines and letters and no pixels, and is the same file each time; of two bands the wider lies behind.
local post = os.tmpname() .. ".eps"
local function eps_of(fields)
  fields.file, fields.size, fields.xlabel, fields.ylabel, fields.yunit = post, { 85 * mm, 60 * mm }, "strain", "stress", "MPa"
  assert(fabric.plot(fields))
  return content(post)
end
local narrow = { x = E, band = { low = { 0, 1.9, 4.9 }, high = { 0.1, 2.1, 5.1 } }, label = "narrow", colour = "blue" }
local broad = { x = E, band = { low = low, high = high }, label = "broad", colour = "black" }
bytes = eps_of { curves = { narrow, broad, line } }
assert(bytes:find "^%%!PS%-Adobe%-3%.0 EPSF%-3%.0\n" and bytes:find "%%%%BoundingBox: 0 0 241 170\n")
assert(not bytes:match("%%%%EndProlog(.*)"):find "image", "a picture in pixels")
assert(bytes:find "/FontName" or bytes:find "%%%%BeginResource: font")
assert(not bytes:find("CreationDate", 1, true) and bytes == eps_of { curves = { narrow, broad, line } })
-- 204 and a fifth of the colour: #000000 becomes #cccccc, #0072b2 becomes #cce2ef.
local grey, blue = bytes:find("0.8 0.8 0.8 rg", 1, true) or bytes:find("0.8 g\n", 1, true), bytes:find "0%.8 0%.88%d+ 0%.93%d+ rg"
assert(grey and blue and grey < blue, "the wider band comes first")
if os.execute "gs --version >/dev/null 2>&1" then
  os.execute(("gs -q -dBATCH -dNOPAUSE -dEPSCrop -sDEVICE=txtwrite -o '%s.txt' '%s'"):format(post, post))
  local words = content(post .. ".txt") -- what stands upright comes letter by letter
  for _, word in ipairs { "strain", "a line", "narrow", "0.05" } do assert(words:find(word, 1, true), words) end
  os.remove(post .. ".txt")
else
  print "SKIPPED: ghostscript is not installed; the words of an EPS were not read"
end
os.remove(post)
os.remove(file)
