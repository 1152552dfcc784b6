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
assert(fabric.plot { file = file, log = "xy", curves = { { x = { 1, 10 }, y = { 1, 100 } } } } == nil)
assert(io.open(file):read "a":find "</svg>")
os.remove(file)
