-- Checks the tables passed to fabric.lab.identify (or to another function with the same ones: `by`) before any simulation.
local define = require "fabric.define"
local registry, fail = define.registry, define.fail

local call = "identify" -- the function that is called

local function refuse(path, wanted, got)
  local what = type(got) == "table" and "a table" or type(got) == "string" and "'" .. got .. "'" or registry.show(got)
  fail(("%s: field '%s': expected %s, got %s"):format(call, path, wanted, what))
end

local function only(path, t, names)
  if type(t) ~= "table" then refuse(path, "a table {" .. table.concat(names, "=, ") .. "=}", t) end
  for name in pairs(t) do
    local known = false
    for _, n in ipairs(names) do known = known or n == name end
    if not known then
      local near = registry.nearest(tostring(name), names)
      fail(("%s: unknown field '%s.%s'%s"):format(call, path, tostring(name), near and (", did you mean '" .. near .. "'?")
        or ("; expected " .. table.concat(names, ", "))))
    end
  end
end

local function finite(x) return type(x) == "number" and x == x and math.abs(x) < math.huge end

local function check_name(path, t, seen)
  if type(t.name) ~= "string" then refuse(path .. ".name", "a string", t.name) end
  if seen[t.name] then refuse(path .. ".name", "another name than those before", t.name) end
  seen[t.name] = true
end

local function check_numbers(path, list, positive, count)
  if type(list) ~= "table" or #list == 0 then refuse(path, "a list of numbers", list) end
  if count and #list ~= count then refuse(path, ("%d numbers, one per measured one"):format(count), #list) end
  for key in pairs(list) do
    if math.type(key) ~= "integer" or key < 1 or key > #list then refuse(path, ("a list of numbers without holes, 1 to %d"):format(#list), ("place %s"):format(key)) end
  end
  for i = 1, #list do
    local x = list[i]
    if not finite(x) or (positive and x <= 0) then refuse(("%s[%d]"):format(path, i), positive and "a positive number" or "a finite number", x) end
  end
end

local function check_test(path, test, seen, names)
  only(path, test, names)
  check_name(path, test, seen)
  if type(test.predict) ~= "function" then refuse(path .. ".predict", "a function", test.predict) end
  if names[3] == "measured" then check_numbers(path .. ".measured", test.measured) end
  if type(test.noise) == "table" then
    check_numbers(path .. ".noise", test.noise, true, test.measured and #test.measured)
  elseif test.noise ~= nil and not (finite(test.noise) and test.noise > 0) then
    refuse(path .. ".noise", "a positive number or a list of them", test.noise)
  end
end

local function check_parameter(path, p, seen)
  only(path, p, { "name", "start", "low", "high" })
  check_name(path, p, seen)
  for _, name in ipairs { "start", "low", "high" } do
    if not finite(p[name]) then refuse(path .. "." .. name, "a number", p[name]) end
  end
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
  for i, test in ipairs(t.tests) do check_test(("tests[%d]"):format(i), test, seen, { "name", "predict", "measured", "noise" }) end
  for i, test in ipairs(t.further or {}) do check_test(("further[%d]"):format(i), test, seen, { "name", "predict", "noise" }) end
end
