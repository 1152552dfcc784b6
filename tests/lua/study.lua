-- fabric.study: order, what is kept, what failed, and that a table does not depend on how many work on it.
local fabric = require "fabric"
local here = "study-test"
os.execute("rm -rf " .. here)

local function content(path)
  local f <close> = assert(io.open(path))
  return f:read "a"
end

-- Every case leaves a line in a file of its own, so that each time it runs can be seen.
local function counted(log, run)
  return function(p)
    local f = assert(io.open(here .. "/" .. log .. ".log", "a"))
    f:write "ran\n"
    f:close()
    return run(p)
  end
end
local function runs(log)
  local f = io.open(here .. "/" .. log .. ".log")
  if not f then return 0 end
  local _, n = f:read("a"):gsub("\n", "")
  f:close()
  return n
end
fabric.write(here .. "/begun", "")

-- A grid: names by the alphabet, the last one fastest; the same table for any number of workers.
local grid = { b = { 1, 2, 3 }, a = { "x", "y" }, c = { true } }
local function values(p) return { third = p.b / 3, name = p.a .. "," .. p.b, whole = p.b, good = p.b > 1, none = p.b == 2 and 0 / 0 or 1 / 0 } end
local tables = {}
for workers = 1, 4 do
  local s = fabric.study { parameters = grid, run = counted("grid" .. workers, values), folder = here .. "/grid" .. workers, workers = workers }
  assert(s.complete and s.failed == 0 and s.missing == 0 and #s == 6 and runs("grid" .. workers) == 6)
  tables[workers] = content(s.file)
  assert(tables[workers] == tables[1])
  local order = { "x1", "x2", "x3", "y1", "y2", "y3" }
  for i, case in ipairs(s) do
    assert(case.parameters.a .. case.parameters.b == order[i] and case.parameters.c == true)
    assert(case.values.third == case.parameters.b / 3 and math.type(case.values.whole) == "integer" and case.values.good == (case.parameters.b > 1))
    assert(case.values.none == 1 / 0 or case.values.none ~= case.values.none)
  end
end
assert(tables[1]:find("case,a,b,c,good,name,none,third,whole,warnings,trouble\n1,x,1,true,false,\"x,1\",inf,0.333333333333333", 1, true) == 1)

-- Again: nothing runs. More values: only the new ones do, and the old table is not mixed up.
local again = fabric.study { parameters = grid, run = counted("grid1", values), folder = here .. "/grid1" }
assert(runs "grid1" == 6 and content(again.file) == tables[1])
grid.b[4] = 4
assert(#fabric.study { parameters = grid, run = counted("grid1", values), folder = here .. "/grid1" } == 8 and runs "grid1" == 8)

-- A list of cases, one of which fails, one returns what cannot be kept, one is killed.
local list = { { n = 1 }, { n = 2 }, { n = 3, how = "odd\nname\t\\" }, { n = 4 }, { n = 5 } }
local alive = false
local function risky(p)
  if p.n == 2 then error "no such\ncloth" end
  if p.n == 3 then return { list = {} } end
  if p.n == 4 and not alive then os.execute "kill -9 $PPID" end
  return { square = p.n ^ 2 }
end
local function risk(more)
  local t = { parameters = list, run = counted("risky", risky), folder = here .. "/risky", workers = 2 }
  for k, v in pairs(more or {}) do t[k] = v end
  return fabric.study(t)
end
local s = risk()
assert(not s.complete and s.failed == 2 and s.missing == 1 and not io.open(s.file) and s[1].values.square == 1 and s[5].values.square == 25)
assert(s[2].trouble:find "no such\ncloth" and s[2].values == nil)
assert(s[3].trouble:find "field 'list': expected a number, a string or true or false, got a table", s[3].trouble)
assert(s[4].trouble == "the process was ended by signal 9 (Killed)")
alive = true
s = risk()  -- what was killed left nothing and runs again; what failed keeps its message
assert(s.complete and s[4].values.square == 16 and s.failed == 2 and runs "risky" == 6)
assert(content(s.file):find('"tests', 1, true) == nil and content(s.file):find('no such\ncloth"\n', 1, true))
assert(risk { again = true }.failed == 2 and runs "risky" == 8)

-- A case's file that is not whole does not count.
for _, name in ipairs(fabric.folder(here .. "/risky")) do
  local path = here .. "/risky/" .. name
  if name:find "^case" then
    local text = content(path)
    fabric.write(path, text:sub(1, #text - 3))
  end
end
alive = false
s = risk()
assert(s.failed == 2 and s.missing == 1 and runs "risky" == 13)

-- A case that calls os.exit: missing, and what this process had to write is written once.
local log = assert(io.open(here .. "/once.log", "w"))
log:write "once\n"
s = fabric.study { parameters = { n = { 1, 2, 3 } }, folder = here .. "/leaving", workers = 2, run = function(p)
  if p.n < 3 then os.exit(p.n == 1) end
  return { n = p.n }
end }
log:close()
assert(s.missing == 2 and s.failed == 0 and s[3].values.n == 3 and s[1].trouble == "the work called os.exit" and s[2].trouble == s[1].trouble)
assert(content(here .. "/once.log") == "once\n")

-- Errors that are no texts are told without an address.
local odd = { { b = 2, a = "x", [1] = true, deeper = {} }, {}, setmetatable({}, { __tostring = function() return "own words" end }), print, 7 }
s = fabric.study { parameters = { n = { 1, 2, 3, 4, 5 } }, folder = here .. "/odd", run = function(p) error(odd[p.n]) end }
local told = { "an error that is a table: 1=true, a=x, b=2", "an error that is a table", "own words", "an error that is a function", "7" }
for i, words in ipairs(told) do assert(s[i].trouble == words, s[i].trouble) end
assert(s.complete and s.failed == 5)
local answers = fabric.lab.parallel { count = 1, isolated = true, work = function() error {} end }
assert(answers[1].trouble == "an error that is a table" and not answers[1].died)

-- The folder of another deck.
local owner = content(here .. "/risky/study.txt")
fabric.write(here .. "/risky/study.txt", owner .. "x")
local good, why = pcall(risk)
assert(not good and why:find "holds results of another deck", why)

-- The same, written as one case twice; what is no list of values.
local function refused(parameters, words)
  local ok, message = pcall(fabric.study, { parameters = parameters, run = values, folder = here .. "/no" })
  assert(not ok and message:find(words, 1, true), message)
end
refused({ { a = 1 }, { a = 2 }, { a = 1 } }, "cases 1 and 3 are the same (a = 1)")
refused({ a = { 1, 1 } }, "cases 1 and 2 are the same (a = 1)")
refused({ a = {} }, "field 'parameters.a': expected a list of values, got an empty table")
refused({ a = 1 }, "field 'parameters.a': expected a list of values, got 1")
refused({ a = { {} } }, "field 'parameters.a[1]': expected a number, a string or true or false, got a table")
refused({ { 1 } }, "field 'parameters[1]': expected names, got '1'")
refused({}, "got an empty table")
-- Names that study.csv has already.
local clash = fabric.study { parameters = { a = { 1, 2 } }, run = function(p) return p.a == 1 and { case = 7 } or { a = 1, b = 1 } end, folder = here .. "/clash" }
assert(clash.failed == 2 and clash[1].trouble:find("no result can be named 'case': study.csv has a column of that name", 1, true), clash[1].trouble)
assert(clash[2].trouble:find("no result can be named 'a': a parameter has that name", 1, true), clash[2].trouble)
local echo = fabric.study { parameters = { a = { 1, 2 } }, run = function(p) return { a = p.a, b = 2 * p.a } end, folder = here .. "/echo" }
assert(content(echo.file) == "case,a,b,warnings,trouble\n1,1,2,,\n2,2,4,,\n", content(echo.file))
local good, message = pcall(fabric.study, { parameters = { trouble = { 1 } }, run = values, folder = here .. "/clash2" })
assert(not good and tostring(message):find("no parameter can be named 'trouble'", 1, true), message)
os.execute("rm -rf " .. here)
