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

local text = fabric.plot { title = "pull", xlabel = "strain", xunit = "%", ylabel = "stress", yunit = "MPa", xrange = { 0, 0.06 },
  curves = { { rows = rows, x = "E", y = "S", label = "simulated" }, { x = { 0.02 }, y = { 2e6 }, label = "measured", style = "points" } } }
for _, word in ipairs { "pull: stress, MPa", "strain, %", "simulated", "measured", "o" } do assert(text:find(word, 1, true), text) end
assert(text:find "\n +4 " and text:find " 6\n", text) -- 4 MPa and 6 %
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
assert(pieces == 3, curve) -- and the line in the key
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
-- What no text may hold is replaced.
assert(fabric.plot { file = file, title = "a\tb\1c\255d\xed\xa0\x80e", curves = { { x = { 0, 1 }, y = { 0, 1 } } } })
assert(not svg.missing(svg.read(content(file)), { "a b c\u{fffd}d\u{fffd}\u{fffd}\u{fffd}e" }))
os.remove(file)
