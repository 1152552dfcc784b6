-- Checks of the tables passed to the laboratory's functions; errors are reported at the deck's line.
local fabric = require "fabric"
local fail = require "fabric.define".fail
local check = {}

-- Warns of a width or length that no specimen has, as of one in mm.
function check.lengths(call, t)
  for _, name in ipairs { "width", "length", "gauge_length" } do
    if t[name] and (t[name] < 1e-3 or t[name] > 2) then fabric.warn(("%s: field '%s': %g m is far from what cloth is: is it in m?"):format(call, name, t[name])) end
  end
end

-- A list of finite numbers.
function check.numbers(call, field, list)
  if type(list) ~= "table" then fail(("%s: field '%s': expected a table of numbers, got %s"):format(call, field, tostring(list))) end
  for i = 1, #list do
    local v = list[i]
    if type(v) ~= "number" or v ~= v or v == math.huge or v == -math.huge then
      fail(("%s: field '%s': expected finite numbers, got %s at place %d"):format(call, field, tostring(v), i))
    end
  end
  return #list
end

-- The forces of a pull in the given rows are positive: what noise makes negative is at most this share of the largest.
local below = 0.1
function check.pull(call, field, forces, rows)
  local low, high, place = math.huge, -math.huge, 1
  for _, row in ipairs(rows) do
    local F = forces[row] or 0
    if F < low then low, place = F, row end
    high = math.max(high, F)
  end
  if low == 0 and high == 0 then fail(("%s: field '%s': expected a pull with a force, got only zeros"):format(call, field)) end
  if #rows > 0 and low < -below * math.max(high, 0) then
    fail(("%s: field '%s': force runs from %.4g to %.4g N (the least at place %d): a pull counts positive; change the sign of the record, or take off its offset"):format(
      call, field, low, high + 0.0, place))
  end
end

-- A list of tests, at least one.
function check.tests(call, tests)
  if #tests > 0 then return end
  local got = tests.E and tests.S and "one test: write tests={ test }" or "none"
  fail(("%s: field 'tests': expected at least one test, got %s"):format(call, got))
end

-- A test: lists E, S of equal length, with branches within them.
function check.test(call, i, test, field)
  field = field or ("tests[%d]"):format(i)
  if type(test) ~= "table" then
    fail(("%s: field '%s': expected a result of fabric.lab.tensile or shear_from_bias, got %s"):format(call, field, tostring(test)))
  end
  local n, m = check.numbers(call, field .. ".E", test.E), check.numbers(call, field .. ".S", test.S)
  if n ~= m or n == 0 then fail(("%s: field '%s': expected E and S of one length, got %d and %d numbers"):format(call, field, n, m)) end
  if type(test.branches) ~= "table" or #test.branches == 0 then
    fail(("%s: field '%s.branches': expected a list of {kind=, first=, last=}, got %s"):format(call, field, tostring(test.branches)))
  end
  for k, branch in ipairs(test.branches) do
    local good = type(branch) == "table" and type(branch.kind) == "string" and math.type(branch.first) == "integer" and math.type(branch.last) == "integer"
      and branch.first >= 1 and branch.last <= n and branch.first <= branch.last + 1
    if not good then
      fail(("%s: field '%s.branches': expected {kind=, first=, last=} with rows from 1 to %d at place %d"):format(call, field, n, k))
    end
  end
  for _, mark in ipairs { "failure", "yield" } do
    local row = test[mark]
    if row ~= nil and (math.type(row) ~= "integer" or row < 1 or row > n) then
      fail(("%s: field '%s.%s': expected a row from 1 to %d, got %s"):format(call, field, mark, n, tostring(row)))
    end
  end
end

-- A grid of markers: rows, columns and positions; those of lost markers are NaN.
function check.grid(call, field, grid)
  if type(grid) ~= "table" then fail(("%s: field '%s': expected a result of fabric.lab.tracks, got %s"):format(call, field, tostring(grid))) end
  for _, name in ipairs { "rows", "columns" } do
    if not math.tointeger(grid[name]) then
      fail(("%s: field '%s.%s': expected an integer, got %s"):format(call, field, name, tostring(grid[name])))
    end
  end
  for _, name in ipairs { "x", "y" } do
    if type(grid[name]) ~= "table" then fail(("%s: field '%s.%s': expected a table of numbers, got %s"):format(call, field, name, tostring(grid[name]))) end
  end
end

return check
