-- fabric.columns: rows of a test, or lists of equal length, as columns for calculations; fabric.show: prints such rows as a table.
local define = require "fabric.define"
local windowed = require "fabric.window"
local lists = require "fabric.lists"
local fail = define.fail

local Column, Curve = {}, {}  -- methods
local column_kind, curve_kind = { __name = "fabric.column" }, { __name = "fabric.curve" }

local function column(values) return setmetatable(values, column_kind) end

-- A value in a message.
local function shown(value) return type(value) == "string" and "'" .. value .. "'" or tostring(value) end

-- Methods are called with a colon; c.S.max() and c.max("S") have no column or curve of their own.
local function with_colon(name, method)
  local kind, rest = name:match "^(%a+):(.*)"
  return define.keep_caller(function(self, ...)
    if getmetatable(self) ~= "fabric." .. kind then
      fail(("%s: expected a %s in front of a colon, as in %s:%s, got %s"):format(name, kind, kind == "curve" and "c" or "c.S",
        kind == "curve" and rest .. "('S')" or rest .. "()", self == nil and "none" or type(self)))
    end
    return method(self, ...)
  end)
end

-- The operand for each row: a number is the same for all, a list has one value per row.
local function operand(value, count, sign)
  if type(value) == "number" then return function() return value end end
  if type(value) ~= "table" then fail(("column %s: expected a number or a list of numbers, got %s"):format(sign, type(value))) end
  if getmetatable(value) == "fabric.curve" then fail(("column %s: expected a number or a column, got a curve; one of its columns is meant, as in c.S"):format(sign)) end
  if #value ~= count then fail(("column %s: expected lists of equal length, got %d and %d numbers"):format(sign, count, #value)) end
  return function(i)
    if type(value[i]) ~= "number" then fail(("column %s: expected numbers, got %s at place %d"):format(sign, shown(value[i]), i)) end
    return value[i]
  end
end

local function operator(sign, calculate)
  return function(a, b)
    local count = #(type(a) == "table" and a or b)
    local left, right, out = operand(a, count, sign), operand(b, count, sign), {}
    for i = 1, count do out[i] = calculate(left(i), right(i)) end
    return column(out)
  end
end

column_kind.__index = Column
column_kind.__metatable = "fabric.column"
column_kind.__add = operator("+", function(a, b) return a + b end)
column_kind.__sub = operator("-", function(a, b) return a - b end)
column_kind.__mul = operator("*", function(a, b) return a * b end)
column_kind.__div = operator("/", function(a, b) return a / b end)
column_kind.__pow = operator("^", function(a, b) return a ^ b end)
function column_kind.__unm(a) return a * -1 end

local function number_at(values, i, name)
  if type(values[i]) ~= "number" then fail(("%s: expected numbers, got %s at place %d"):format(name, shown(values[i]), i)) end
  return values[i]
end

-- The first extreme value and its index; gaps (nan) are skipped.
local function extreme(values, better, name)
  local best, place
  for i in ipairs(values) do
    local value = number_at(values, i, name)
    if value == value and (not best or better(value, best)) then best, place = value, i end
  end
  if not best then fail(name .. ": expected at least one number, the column has none") end
  return best, place
end

function Column:max() return extreme(self, function(a, b) return a > b end, "column:max") end
function Column:min() return extreme(self, function(a, b) return a < b end, "column:min") end

-- The sum of the numbers, and how many there are; gaps (nan) are skipped.
local function sum(values, name)
  local total, count = 0, 0
  for i in ipairs(values) do
    local value = number_at(values, i, name)
    if value == value then total, count = total + value, count + 1 end
  end
  if count == 0 and #values > 0 then fail(name .. ": expected at least one number, the column has none") end
  return total, count
end

function Column:sum() return (sum(self, "column:sum")) end

function Column:mean()
  if #self == 0 then fail "column:mean: expected at least one number, the column has none" end
  local total, count = sum(self, "column:mean")
  return total / count
end

function Column:map(change)
  if type(change) ~= "function" then fail("column:map: expected a function of a number, got " .. type(change)) end
  local out = {}
  for i, value in ipairs(self) do out[i] = change(value, i) end
  return column(out)
end

-- The names of the columns of a curve in the order of its file; other curves have none.
local orders = setmetatable({}, { __mode = "k" })

local function names_of(rows)
  local names = lists.collect(orders[rows] or {}, function(name) if type((rows[1] or {})[name]) == "number" then return name end end)
  if #names > 0 then return names end
  for name, value in pairs(rows[1] or {}) do
    if type(name) == "string" and type(value) == "number" then names[#names + 1] = name end
  end
  table.sort(names)
  return names
end

local function named(rows, name)
  if type(name) ~= "string" then
    fail(("columns: expected the name of a column, got %s; the columns are %s"):format(tostring(name), table.concat(names_of(rows), ", ")))
  end
  local out = {}
  for i = 1, #rows do
    local value = rawget(rows[i], name)
    if type(value) ~= "number" then
      fail(("columns: expected a number %s in each row, row %d of %d has %s; the columns are %s"):format(tostring(name), i, #rows,
        value == nil and "none" or shown(value), table.concat(names_of(rows), ", ")))
    end
    out[i] = value
  end
  return column(out)
end

function Curve:column(name) return named(self, name) end
function Curve:names() return names_of(self) end

function Curve:map(change)
  if type(change) ~= "function" then fail("curve:map: expected a function of a row, got " .. type(change)) end
  local out = {}
  for i = 1, #self do out[i] = change(self[i], i) end
  return column(out)
end

-- y where x first passes the value, by linear interpolation between two rows; nil and a sentence that says why if it never does.
function Curve:interpolate(y, x, value)
  if type(value) ~= "number" then
    fail(("curve:interpolate: expected two names and a number, as in curve:interpolate('S', 'E', 0.1), got %s"):format(tostring(value)))
  end
  local xs, ys = named(self, x), named(self, y)
  for i = 1, #xs do
    if xs[i] == value then return ys[i] end
    local before = i > 1 and xs[i - 1]
    if before and (before - value) * (xs[i] - value) < 0 then
      return ys[i - 1] + (ys[i] - ys[i - 1]) * (value - before) / (xs[i] - before)
    end
  end
  if #xs == 0 then return nil, "the curve has no rows" end
  if value ~= value then return nil, ("%s is nowhere nan, which is no number"):format(x) end
  local gaps, low, high = 0, math.huge, -math.huge
  for _, v in ipairs(xs) do
    if v ~= v then gaps = gaps + 1 else low, high = math.min(low, v), math.max(high, v) end
  end
  if gaps == #xs then return nil, ("%s has gaps (nan) only"):format(x) end
  for _, i in ipairs { #xs, 1 } do -- an end missed by rounding alone, as 0.1 + 0.2 misses 0.3
    if math.abs(xs[i] - value) <= 1e-12 * (high - low) then return ys[i] end
  end
  if gaps > 0 then return nil, ("%s is nowhere %.6g between two rows without a gap (nan); it goes from %.6g to %.6g, with %d gaps"):format(x, value, low, high, gaps) end
  return nil, ("%s is nowhere %.6g, it goes from %.6g to %.6g"):format(x, value, xs:min(), (xs:max()))
end

-- The means of a column over the seconds about each row, by the column `time` (of a table read from a record: 'time').
function Curve:window(name, seconds)
  if type(seconds) ~= "number" or not (seconds > 0) then
    fail(("curve:window: expected a name and a time in s above 0, as in curve:window('force', 0.01), got %s"):format(tostring(seconds)))
  end
  local t = named(self, "time")
  for i = 2, #t do
    if not (t[i] > t[i - 1]) then fail(("curve:window: expected times that increase, got %.6g s after %.6g s in row %d"):format(t[i], t[i - 1], i)) end
  end
  return column(windowed(t, named(self, name), seconds))
end

for _, which in ipairs { "max", "min" } do
  Curve[which] = function(self, name)
    local values = named(self, name)
    local value, place = values[which](values)
    return value, self[place]
  end
end

for kind, methods in pairs { column = Column, curve = Curve } do
  for name, method in pairs(methods) do methods[name] = with_colon(kind .. ":" .. name, method) end
end

-- curve.S is a column; a column with the name of a method is available by curve:column.
function curve_kind.__index(rows, name)
  if Curve[name] then return Curve[name] end
  if type(name) ~= "string" or not rawget(rows, 1) or rawget(rows[1], name) == nil then return nil end
  return named(rows, name)
end
curve_kind.__metatable = "fabric.curve"

-- Converts lists {E={...}, S={...}} to rows.
local function rows_of_lists(given)
  local count, first
  for name, values in pairs(given) do
    if type(name) ~= "string" or type(values) ~= "table" then
      fail("columns: expected a list of rows, or a table of lists with names, got an entry " .. tostring(name) .. " = " .. tostring(values))
    end
    if count and #values ~= count then
      fail(("columns: expected lists of equal length, got %d numbers in %s and %d in %s"):format(count, first, #values, name))
    end
    count, first = count or #values, first or name
  end
  if count == 0 then fail "columns: expected at least one row, got empty lists" end
  local rows = {}
  for i = 1, count or 0 do
    rows[i] = {}
    for name, values in pairs(given) do rows[i][name] = values[i] end
  end
  return rows
end

-- Converts columns as read from a file by fabric.table: {name=, unit=, values=}. A name that occurs again gets its place behind it.
local function rows_of_columns(columns)
  local given, order = {}, {}
  for i, each in ipairs(columns) do
    order[i] = given[each.name] and ("%s (%d)"):format(each.name, i) or each.name
    given[order[i]] = each.values
  end
  local rows = rows_of_lists(given)
  orders[rows] = order
  return rows
end

local function columns_of(rows)
  if getmetatable(rows) == "fabric.curve" then return rows end
  if getmetatable(rows) ~= nil then rows = table.move(rows, 1, #rows, 1, {}) end -- a result with a metatable of its own
  if next(rows) == nil then fail "columns: expected at least one row, got an empty table" end
  if type(rows[1]) ~= "table" then return setmetatable(rows_of_lists(rows), curve_kind) end
  if type(rows[1].values) == "table" and rows[1].name then return setmetatable(rows_of_columns(rows), curve_kind) end
  for i = 1, #rows do
    if type(rows[i]) ~= "table" then fail(("columns: expected a table in each row, row %d is %s"):format(i, tostring(rows[i]))) end
  end
  return setmetatable(rows, curve_kind)
end

define {
  name = "fabric.columns",
  positional = true,
  arguments = { { name = "rows", kind = "table", sentence = "of a test, a record, or a fabric.table; or lists of equal length with names" } },
  sentence = "Rows as columns that can be calculated with, as the curves of virtual tests are: curve.S / MPa, curve.S:max(), :min(), :mean(), :sum(), "
    .. ":map(f), of which all but map skip gaps (nan); curve:max('S') gives the row too, curve:interpolate('S', 'E', 0.1) is S where E first passes 0.1 (nil and the reason where it never does), "
    .. "curve:map(f) a column of f(row), curve:window('S', 0.01) the means of S over the 0.01 s about each row, by the column time: for what chatters from step to step.",
  example = "local c = require 'fabric'.columns{ E={0, 0.1, 0.2}, S={0, 1e6, 3e6} }\n"
    .. "assert((c.S / 1e6):max() == 3 and math.abs(c:interpolate('S', 'E', 0.15) - 2e6) < 1)",
  run = columns_of,
}

local function cell(value)
  if math.type(value) == "integer" then return tostring(value) end
  if type(value) == "number" then return ("%.6g"):format(value) end
  if type(value) == "table" then return #value > 0 and ("<list of %d>"):format(#value) or "<table>" end
  return value == nil and "" or tostring(value)
end

-- The indices of the rows to show: all, or those at the beginning and the end.
local function places(count, most)
  local out = {}
  for i = 1, count do
    if count <= most or i <= most - most // 2 or i > count - most // 2 then out[#out + 1] = i end
  end
  return out
end

local function every_name(rows)
  if orders[rows] then return orders[rows] end
  local names, known = {}, {}
  for _, row in ipairs(rows) do
    for name in pairs(row) do
      if not known[name] then
        known[name] = true
        names[#names + 1] = name
      end
    end
  end
  table.sort(names, function(a, b) return tostring(a) < tostring(b) end)
  return names
end

local function chosen(options, rows)
  local names = options and options.columns or every_name(rows)
  for _, name in ipairs(names) do
    local found = false
    for _, row in ipairs(rows) do found = found or row[name] ~= nil end
    if not found then
      fail(("show: field 'options.columns': no row has '%s'; they have %s"):format(tostring(name), table.concat(every_name(rows), ", ")))
    end
  end
  return names
end

local function show(rows, options)
  rows = columns_of(rows)
  local names = chosen(options, rows)
  local lines, widths = { {} }, {}
  for k, name in ipairs(names) do lines[1][k] = tostring(name) end
  local last = 0
  for _, i in ipairs(places(#rows, options and options.rows or 40)) do
    if i ~= last + 1 then
      lines[#lines + 1] = {}
      for k in ipairs(names) do lines[#lines][k] = "..." end
    end
    lines[#lines + 1] = {}
    for k, name in ipairs(names) do lines[#lines][k] = cell(rawget(rows[i], name)) end
    last = i
  end
  for _, line in ipairs(lines) do
    for k, word in ipairs(line) do widths[k] = math.max(widths[k] or 0, #word) end
  end
  for _, line in ipairs(lines) do
    local words = lists.map(line, function(word, k) return (" "):rep(widths[k] - #word) .. word end)
    print("  " .. table.concat(words, "  "))
  end
end

define {
  name = "fabric.show",
  positional = true,
  arguments = {
    { name = "rows", kind = "table", sentence = "of a test, a record, or a fabric.table; or lists of equal length with names" },
    { name = "options", kind = "fields", optional = true, sentence = "what to show", rows = {
      { name = "rows", kind = "integer", low = 2, default = 40, sentence = "at most, from the beginning and the end" },
      { name = "columns", kind = "table", optional = true, sentence = "names, in their order; default: all, in the order of a file, else by the alphabet" } } },
  },
  sentence = "Prints rows as a table under their names.",
  example = "require 'fabric'.show({ {E=0, S=0}, {E=0.1, S=1.5e6} }, { columns={'E', 'S'} })",
  run = show,
}

-- An empty curve, to be filled with rows.
local function made() return setmetatable({}, curve_kind) end

-- Help on a curve or a column; nil of anything else.
local function about(value)
  local kind = getmetatable(value)
  if kind == "fabric.curve" then
    local names = names_of(value)
    return {
      ("a curve of %d rows: %s"):format(#value, #names > 0 and table.concat(names, ", ") or "no columns yet"),
      "  c.S                          the column S, to calculate with: + - * / ^ with numbers and columns",
      "  c[3]                         a row",
      "  c:column('S')                the column S, also where a method has its name",
      "  c:names()                    of the columns",
      "  c:max('S'), c:min('S')       the value and its row",
      "  c:interpolate('S', 'E', 0.1) S where E first passes 0.1; nil and the reason where it never does",
      "  c:map(f)                     the column of f(row)",
      "  c:window('S', 0.01)          the column of the means of S over 0.01 s of its column time",
      "  fabric.show(c)               prints it as a table",
    }
  elseif kind == "fabric.column" then
    return {
      ("a column of %d numbers, to calculate with: + - * / ^ with numbers and columns"):format(#value),
      "  c:max(), c:min()             the value and its place",
      "  c:mean(), c:sum()            gaps (nan) are skipped, as by max and min",
      "  c:map(f)                     the column of f(value)",
    }
  end
end

return { made = made, about = about }
