-- Checks the tables passed to fabric.lab.identify (or to another function with the same ones: `by`) before any simulation.
local define = require "fabric.define"
local registry, fail = define.registry, define.fail

local call = "identify" -- the function that is called

local function refuse(path, wanted, got)
  local what = type(got) == "table" and "a table" or type(got) == "string" and "'" .. got .. "'" or registry.show(got)
  fail(("%s: field '%s': expected %s, got %s"):format(call, path, wanted, what))
end

local name = { name = "name", kind = "text" }
local predict = { name = "predict", kind = "function" }
local noise = { name = "noise", kind = "number|numbers", above = 0, optional = true }
local parameter_rows = { name, { name = "start", kind = "number" }, { name = "low", kind = "number" }, { name = "high", kind = "number" } }
local test_rows = { name, predict, { name = "measured", kind = "numbers" }, noise }
local further_rows = { name, predict, noise }

local function check_name(path, t, seen)
  if seen[t.name] then refuse(path .. ".name", "another name than those before", t.name) end
  seen[t.name] = true
end

local function check_holes(path, list)
  for key in pairs(list) do
    if math.type(key) ~= "integer" or key < 1 or key > #list then refuse(path, ("a list of numbers without holes, 1 to %d"):format(#list), ("place %s"):format(key)) end
  end
end

local function check_test(path, test, seen, rows)
  define.check(call, path, test, rows)
  check_name(path, test, seen)
  check_holes(path .. ".measured", test.measured or {})
  if type(test.noise) == "table" then
    check_holes(path .. ".noise", test.noise)
    if test.measured and #test.noise ~= #test.measured then refuse(path .. ".noise", ("%d numbers, one per measured one"):format(#test.measured), #test.noise) end
  end
end

local function check_parameter(path, p, seen)
  define.check(call, path, p, parameter_rows)
  check_name(path, p, seen)
  if p.low >= p.high then refuse(path .. ".high", ("more than low (%g)"):format(p.low), p.high) end
  if p.start < p.low or p.start > p.high then refuse(path .. ".start", ("%g to %g"):format(p.low, p.high), p.start) end
end

return function(t, by)
  call = by or "identify"
  local seen = {}
  for i, p in ipairs(t.parameters) do check_parameter(("parameters[%d]"):format(i), p, seen) end
  if #t.parameters == 0 then refuse("parameters", "at least one", 0) end
  if #t.tests == 0 then refuse("tests", "at least one", 0) end
  seen = {}
  for i, test in ipairs(t.tests) do check_test(("tests[%d]"):format(i), test, seen, test_rows) end
  for i, test in ipairs(t.further or {}) do check_test(("further[%d]"):format(i), test, seen, further_rows) end
end
