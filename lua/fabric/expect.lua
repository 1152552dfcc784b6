-- fabric.expect: a deck's check of its results. Prints a table; an error if a row fails, so that the exit code is 1.
local define = require "fabric.define"
local fail = define.fail

-- Evaluates one row {label, got, want, relative= | absolute=}; returns got, want, error, limit, and the kind of error.
local function judge(row, place)
  local label, got, want = row[1], row[2], row[3]
  if type(label) ~= "string" then
    fail("expect: row " .. place .. ": expected a label first, got " .. tostring(label))
  end
  if type(got) ~= "number" or type(want) ~= "number" then
    fail(("expect: row '%s': expected two numbers (got, want), got %s and %s"):format(label, tostring(got), tostring(want)))
  end
  local limit = row.relative or row.absolute
  if type(limit) ~= "number" or (row.relative and row.absolute) then
    fail(("expect: row '%s': expected relative= or absolute= (one of them)"):format(label))
  end
  local miss = math.abs(got - want)
  if row.relative then miss = miss / math.abs(want) end
  return label, got, want, miss, limit
end

local function print_row(label, got, want, miss, limit, good)
  print(("  %-44s %16.9g %16.9g %10.2e %10.2e  %s"):format(label, got, want, miss, limit, good and "ok" or "MISSED"))
end

-- A hole in the list would end it unnoticed, and so would a name in place of a number.
local function check_list(rows)
  local last = 0
  for place in pairs(rows) do
    if math.type(place) ~= "integer" or place < 1 then
      fail("expect: expected rows { {label, got, want, relative=}, ... }, got an entry " .. tostring(place))
    end
    last = math.max(last, place)
  end
  if last == 0 then fail "expect: expected at least one row {label, got, want, relative=}, got none" end
  for place = 1, last do
    if type(rows[place]) ~= "table" then
      fail(("expect: row %d: expected a table {label, got, want, relative=}, got %s"):format(place, tostring(rows[place])))
    end
  end
end

local function expect(rows)
  if require "fabric".checking() then return end  -- the results of runs are not available here
  check_list(rows)
  print(("  %-44s %16s %16s %10s %10s"):format("expected", "got", "want", "error", "allowed"))
  local missed = {}
  for place, row in ipairs(rows) do
    local label, got, want, miss, limit = judge(row, place)
    local good = miss <= limit
    print_row(label, got, want, miss, limit, good)
    if not good then missed[#missed + 1] = "'" .. label .. "'" end
  end
  if #missed > 0 then
    fail(("expect: %d of %d missed: %s"):format(#missed, #rows, table.concat(missed, ", ")))
  end
end

define {
  name = "fabric.expect",
  positional = true,
  arguments = { { name = "rows", kind = "table", sentence = "{ {label, got, want, relative= or absolute=}, ... }" } },
  sentence = "Checks results of a deck: prints computed and expected values; an error (exit code 1) if one is outside its tolerance.",
  example = "require 'fabric'.expect{ {'a third', 1/3, 0.333333333333, relative=1e-9} }",
  run = expect,
}
