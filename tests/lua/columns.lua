-- Columns of a curve are calculated with; fabric.show prints rows as a table.
local fabric = require "fabric"
local MPa = fabric.units.MPa

-- a parabola S = E^2, by rows and by lists
local rows, lists = {}, { E = {}, S = {} }
for i = 1, 11 do
  local E = (i - 1) / 10
  rows[i] = { E = E, S = E ^ 2 }
  lists.E[i], lists.S[i] = E, E ^ 2
end
for _, c in ipairs { fabric.columns(rows), fabric.columns(lists) } do
  assert(#c == 11 and #c.S == 11 and c.E[3] == 0.2 and c[3].E == 0.2)
  assert(table.concat(c:names(), " ") == "E S" and c.nothing == nil)
  local off = c.S - c.E ^ 2
  assert(off:max() == 0 and off:min() == 0)
  local other = (2 * c.S + c.E / 2 - 1) * -1
  assert(other[11] == -1.5 and (-other)[11] == 1.5)
  assert(math.abs(c.S:sum() - 3.85) < 1e-12 and math.abs(c.S:mean() - 0.35) < 1e-12)
  local top, row = c:max "S"
  assert(top == 1 and row.E == 1)
  local value, place = c.S:min()
  assert(value == 0 and place == 1)
  assert(math.abs(c:interpolate("S", "E", 0.25) - 0.065) < 1e-15 and c:interpolate("S", "E", 0.3) == c.S[4])
  local none, why = c:interpolate("S", "E", 1.5)
  assert(none == nil and why == "E is nowhere 1.5, it goes from 0 to 1", why)
  assert(c:map(function(r) return r.S / 2 end)[11] == 0.5 and c.E:map(math.sqrt)[11] == 1)
end
assert(fabric.columns(rows) == rows, "the rows themselves become a curve")
assert(fabric.columns { E = { 0, 0 / 0, 2 } }.E:max() == 2, "a gap is passed over")
do
  local gaps = fabric.columns { E = { 0 / 0, 1, 3 }, S = { 0 / 0, 0 / 0, 0 / 0 } }
  assert(gaps.E:max() == 3 and gaps.E:min() == 1 and gaps.E:mean() == 2 and gaps.E:sum() == 4, "by all of them")
  for _, name in ipairs { "max", "min", "mean", "sum" } do
    local ok, message = pcall(function() local x = gaps.S[name](gaps.S) return x end)
    assert(not ok and message:find("column:" .. name .. ": expected at least one number, the column has none", 1, true), message)
  end
end

-- a wrong call whose result is only passed on names its line in the deck
do
  local text = "local c = require 'fabric'.columns { E = { 0, 1 } }\nlocal function top() return c.E.max() end\nlocal function all() return c:column(3) end\n"
  for last, words in pairs { ["return c.E.max()"] = ":4: column:max: expected a column in front of a colon",
    ["local _, told = coroutine.resume(coroutine.create(function() return c.E.max() end))\nerror(told, 0)"] = ":4: column:max: expected a column in front of a colon",
    ["local x = top() return x"] = ":2: column:max: expected a column in front of a colon", ["local x = all() return x"] = ":3: columns: expected the name of a column",
    ["return c:map(3)"] = ":4: curve:map: expected a function", ["return c.E + c"] = ":4: column +: expected a number or a column, got a curve; one of its columns is meant" } do
    local ok, message = pcall(assert(load(text .. last, "@deck.lua")))
    assert(not ok and message:sub(1, 8 + #words) == "deck.lua" .. words, message)
  end
  -- a function that waits may be called by map
  local steps = coroutine.wrap(function() return fabric.columns({ E = { 1, 2 } }).E:map(function(v) return v + coroutine.yield(v) end) end)
  assert(steps() == 1 and steps(10) == 2)
  local after = steps(20)
  assert(after[1] == 11 and after[2] == 22)
end

-- help says what a curve and a column are
do
  local said, print_ = {}, print
  print = function(text) said[#said + 1] = text end
  local c = fabric.columns { E = { 0, 1, 2 }, S = { 0, 1, 4 } }
  fabric.help(c)
  fabric.help(c.S)
  fabric.help { 1, 2 }
  print = print_
  assert(said[1]:find "^a curve of 3 rows: E, S\n" and said[1]:find("c:interpolate", 1, true), said[1])
  assert(said[2]:find "^a column of 3 numbers" and said[2]:find("c:mean()", 1, true), said[2])
  assert(said[3]:find "this is a plain table of Lua", said[3])
end

-- an end missed by rounding; gaps
do
  local short = fabric.columns { E = { 0, 0.15, 0.3 }, S = { 1, 2, 5 } }
  assert(0.1 + 0.2 > 0.3 and short:interpolate("S", "E", 0.1 + 0.2) == 5 and short:interpolate("S", "E", -1e-14) == 1)
  assert(short:interpolate("S", "E", 0.3 + 1e-9) == nil)
  local gap = fabric.columns { E = { 0, 0 / 0, 2 }, S = { 1, 2, 3 } }
  local none, why = gap:interpolate("S", "E", 1)
  assert(none == nil and why == "E is nowhere 1 between two rows without a gap (nan); it goes from 0 to 2, with 1 gaps", why)
  none, why = short:interpolate("S", "E", 0 / 0)
  assert(none == nil and why == "E is nowhere nan, which is no number", why)
end

-- a curve that has a column with the name of a method
local odd = fabric.columns { { max = 1, E = 0 }, { max = 3, E = 1 } }
assert(odd:column("max"):max() == 3 and odd:max "E" == 1)

-- the curve of a virtual test, and a file's columns
local r = fabric.lab.uniaxial { card = fabric.card "blend", displacement = 0.002, cells = { 1, 3 }, steps = 4 }
assert((r.curve.S / MPa):max() == r.curve.S:max() / MPa and r.curve:max "force" == r.curve.force:max())
local path = os.tmpname()
local file = assert(io.open(path, "w"))
file:write "time (s),force (N)\n0,0\n1,2.5\n2,5\n"
file:close()
local read = fabric.columns(fabric.table { file = path })
os.remove(path)
assert(read:interpolate("force", "time", 1.5) == 3.75)
-- printed in the order of the file; names that occur twice stay apart
local printed, real_print = {}, print
print = function(text) printed[#printed + 1] = text end -- luacheck: ignore
fabric.show(read)
fabric.write(path, "time,force,angle,force\n0,1,2,3\n1,4,5,6\n")
fabric.show(fabric.table { file = path })
print = real_print -- luacheck: ignore
os.remove(path)
assert(printed[1] == "  time  force" and printed[3] == "     1    2.5" and printed[5] == "  time  force  angle  force (4)" and printed[7] == "     1      4      5          6",
  table.concat(printed, "\n"))

-- as a table, the middle of a long one left out
local lines, print_ = {}, print
print = function(text) lines[#lines + 1] = text end -- luacheck: ignore
fabric.show(rows, { rows = 4, columns = { "S", "E" } })
fabric.show { { name = "blend", E = 1 }, { name = "duck" } }
fabric.show { { E = 1, list = { 4, 5 } } }
print = print_ -- luacheck: ignore
assert(table.concat(lines, "\n") == [[
     S    E
     0    0
  0.01  0.1
   ...  ...
  0.81  0.9
     1    1
  E   name
  1  blend
      duck
  E         list
  1  <list of 2>]], table.concat(lines, "\n"))

-- impossible operations
local function refused(words, call)
  local ok, message = pcall(call)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end
local c = fabric.columns(rows)
refused("column +: expected lists of equal length, got 11 and 2 numbers", function() return c.S + { 1, 2 } end)
refused("column /: expected a number or a list of numbers, got string", function() return c.S / "MPa" end)
refused("columns: expected a number Q in each row, row 1 of 11 has none; the columns are E, S", function() return c:max "Q" end)
refused("column:map: expected a function of a number, got nil", function() return c.S:map() end)
refused("curve:map: expected a function of a row, got number", function() return c:map(3) end)
refused("curve:interpolate: expected two names and a number", function() return c:interpolate("S", "E") end)
refused("columns: expected lists of equal length", function() return fabric.columns { E = { 1 }, S = { 1, 2 } } end)
refused("columns: expected at least one row", function() return fabric.columns {} end)
refused("columns: expected a table in each row, row 2 is 5", function() return fabric.columns { { E = 1 }, 5 } end)
refused("column:max: expected at least one number", function() return fabric.columns { E = { 0 / 0 } }.E:max() end)
refused("columns: expected at least one row, got empty lists", function() return fabric.columns { E = {} } end)
refused("show: field 'options.columns': no row has 'Q'", function() fabric.show(rows, { columns = { "Q" } }) end)
refused("column *: expected a number or a list of numbers, got nil", function() return c.S * nil end)
refused("column:max: expected a column in front of a colon, as in c.S:max(), got none", function() return (c.S.max()) end)
refused("curve:max: expected a curve in front of a colon, as in c:max('S'), got string", function() return (c.max "S") end)
refused("column:max: expected numbers, got '0.0' at place 1", function() return (c.S:map(tostring):max()) end)
refused("column:mean: expected numbers, got 'x' at place 1", function() return (c.S:map(function() return "x" end):mean()) end)
refused("columns: expected the name of a column, got nil; the columns are E, S", function() return (c:max()) end)

-- the line in a message is that of the deck
for _, wrong in ipairs { function() return (c.S:map()) end, function() return (c:interpolate("S")) end, function() return (c.S + { 1 }) end } do
  local _, message = pcall(wrong)
  assert(message:find "columns.lua:%d+: column" or message:find "columns.lua:%d+: curve", message)
  local line = tonumber(message:match ":(%d+):")
  assert(message:match "^(.-):%d+:" == arg[0] and line == debug.getinfo(wrong, "S").linedefined, message)
end
