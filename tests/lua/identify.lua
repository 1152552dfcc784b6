-- Identification: an interrupted search goes on from its checkpoint, a failed simulation is walked around, a wrong problem refused.
local fabric = require "fabric"
local lab = fabric.lab

local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails

local calls, stop_at = 0, math.huge
local function decay(p)
  calls = calls + 1
  if calls > stop_at then error("the lights went out", 0) end
  if p.rate > 2.9 then error("no such rate", 0) end
  local out = {}
  for i = 1, 20 do out[i] = p.size * math.exp(-p.rate * i / 10) end
  return out
end
local reference = decay { size = 2, rate = 1.3 }
local path = os.tmpname()
os.remove(path)
local function search(more)
  local t = { parameters = { { name = "size", start = 1, low = 0.1, high = 10 }, { name = "rate", start = 0.4, low = 0, high = 3 } },
    tests = { { name = "decay", measured = reference, predict = decay } }, processes = 1, checkpoint = path, tolerance = 1e-10, difference = 1e-5 }
  for k, v in pairs(more or {}) do t[k] = v end
  return lab.identify(t)
end

calls = 0
local whole = search { checkpoint = path .. ".whole" }
local needed = calls
assert(math.abs(whole.parameters.size - 2) < 1e-6 and math.abs(whole.parameters.rate - 1.3) < 1e-6, whole.text)
assert(whole.misses.decay.worst < 1e-6 and whole.simulations == needed)
os.remove(path .. ".whole")

-- interrupted: only what is new is simulated after
calls = 0
search { iterations = 2, settle = 0 }
local before = calls
assert(before < needed)
calls = 0
local resumed = search()
assert(calls > 0 and calls <= needed - before + 3, calls .. " of " .. needed)
assert(resumed.parameters.size == whole.parameters.size and resumed.parameters.rate == whole.parameters.rate)
calls = 0
search()
assert(calls == 1) -- one stored point again, to see that it is still the same problem
fails("is of another problem", search, { parameters = { { name = "size", start = 1, low = 0.1, high = 11 }, { name = "rate", start = 0.4, low = 0, high = 3 } } })
os.remove(path)

-- a start that cannot be simulated is an error, a point on the way is not
fails("the start cannot be simulated: no such rate", search,
  { parameters = { { name = "size", start = 1, low = 0.1, high = 10 }, { name = "rate", start = 2.95, low = 0, high = 3 } } })
fails("parameters[1].low", search, { parameters = { { name = "size", start = 1 } } })
os.remove(path)

-- two processes come to the same
local shared = search { processes = 2 }
assert(shared.parameters.size == whole.parameters.size)
os.remove(path)

-- --- the checkpoint ---

-- another noise has the same predictions and other residuals: as if there had been no checkpoint
local crooked = table.move(reference, 1, #reference, 1, {})
for i = 1, #crooked do crooked[i] = crooked[i] + (i % 3 - 1) * 0.05 * i end
local function weighed(noise, checkpoint)
  local list = {}
  for i = 1, #reference do list[i] = noise(i) end
  return search { checkpoint = checkpoint, tests = { { name = "decay", measured = crooked, noise = list, predict = decay } } }
end
local function late(i) return 0.01 * i ^ 2 end
local fresh = weighed(late, path .. ".fresh")
weighed(function() return 0.1 end, path)
local resumed_so = weighed(late, path)
assert(math.abs(resumed_so.parameters.rate - fresh.parameters.rate) < 1e-5 and math.abs(resumed_so.chi2 / fresh.chi2 - 1) < 1e-6)
os.remove(path .. ".fresh")
os.remove(path)

-- an input of predict changes without being said: one stored point tells; said by key: refused at once
search()
local function twice(p)
  local out = decay(p)
  for i, y in ipairs(out) do out[i] = 1.01 * y end
  return out
end
fails("is of another problem: at size=1, rate=0.4 number 1 of test 'decay' is 0.970", search, { tests = { { name = "decay", measured = reference, predict = twice } } })
fails("other parameters, tests, data or key", search, { key = "6 cells" })
os.remove(path)
search { key = 6 }
fails("other parameters, tests, data or key", search, { key = 7 })
calls = 0
search { key = 6 }
assert(calls == 1)
os.remove(path)

-- a process that is stopped from outside says nothing of the point: tried again, and then an error; never kept
local marker = os.tmpname()
local function dies_at(points)
  return function(p)
    if p.rate > 0.4 and points(p) then os.execute "kill -9 $PPID" end
    return decay(p)
  end
end
local once = search { processes = 2, tests = { { name = "decay", measured = reference, predict = dies_at(function()
  local there = io.open(marker)
  if there then there:close() os.remove(marker) end
  return there
end) } } }
assert(not io.open(marker) and once.parameters.size == whole.parameters.size, once.text)
os.remove(path)
fails("ended twice without an answer: the process was ended by signal 9", search,
  { processes = 2, tests = { { name = "decay", measured = reference, predict = dies_at(function() return true end) } } })
for stored in io.lines(path) do assert(not stored:find " failed: ", stored) end
calls = 0
assert(search().parameters.size == whole.parameters.size)
os.remove(path)
-- a failure of predict itself is kept, and is none of the numbers
search { parameters = { { name = "size", start = 1, low = 0.1, high = 10 }, { name = "rate", start = 2.899, low = 0, high = 3 } }, difference = 1e-2, iterations = 1,
  settle = 0, tests = { { name = "decay", measured = reference, predict = function(p) return p.rate > 2.9 and { 0 / 0 } or decay(p) end } } }
os.remove(path)
fails("the start cannot be simulated: test 'decay': expected predict to return finite numbers, got ", search,
  { tests = { { name = "decay", measured = reference, predict = function() local out = decay { size = 1, rate = 1 } out[3] = 0 / 0 return out end } } })
fails("expected 20 predicted numbers, got 1", search, { tests = { { name = "decay", measured = reference, predict = function() return { 1 } end } } })
os.remove(path)

-- --- what it says ---

local function line(parameters, measured, predict, more)
  local t = { parameters = parameters, tests = { { name = "line", measured = measured, noise = 0.01, predict = predict } }, processes = 1 }
  for k, v in pairs(more or {}) do t[k] = v end
  return lab.identify(t)
end
local function a_and_b(p) return { p.a + p.b, p.a + 2 * p.b, p.a + 3 * p.b } end
local held = line({ { name = "a", start = 1, low = 0, high = 4 }, { name = "b", start = 1, low = 0, high = 2.5 } }, { 4, 7, 10 }, a_and_b)
assert(held.text:find("b lies on its bound 2.5: no error bar", 1, true), held.text)
assert(held.on_bound.b == 2.5 and not held.on_bound.a and held.deviation[2] ~= held.deviation[2])
-- a quarter of a unit's miss at both ends, in noise of 0.01: said, with what it is
assert(held.text:find("chi^2 per degree of freedom", 1, true) and held.text:find("line: largest miss", 1, true) and held.chi2 > 100
  and held.text:find "error bars are widened", held.text)
local free = line({ { name = "a", start = 0, low = -4, high = 4 }, { name = "b", start = 1, low = 0, high = 5 } }, { 4, 7, 10 }, a_and_b)
assert(next(free.on_bound) == nil and not free.text:find "bound" and free.chi2 < 1e-6, free.text)
-- correlation of 0.97 with both known: hang together; a sum alone: cannot be told apart, each within its bounds
local function far(p) return { p.a + 4 * p.b, p.a + 5 * p.b, p.a + 6 * p.b } end
local pair = line({ { name = "a", start = 0, low = -4, high = 4 }, { name = "b", start = 1, low = 0, high = 5 } }, { 13, 16, 19 }, far)
assert(pair.text:find "a and b are correlated" and not pair.text:find "told apart", pair.text)
local function sum(p) return { p.a + p.b, p.a + p.b, 2 * (p.a + p.b) } end
local blind = line({ { name = "a", start = 0, low = -4, high = 4 }, { name = "b", start = 1, low = 0, high = 5 } }, { 3, 3, 6 }, sum,
  { further = { { name = "the same", noise = 0.01, predict = sum } } })
assert(blind.text:find "a and b cannot be told apart", blind.text)
assert(blind.deviation[1] == 8 and blind.deviation[2] == 5 and blind.weakest_deviation == 1 and blind.further[1].weakest_deviation == 1, blind.text)

-- --- what is refused ---

local function refused(words, test, where)
  local t = { name = "decay", measured = reference, predict = decay }
  for k, v in pairs(test) do t[k] = v end
  fails(words, search, { [where or "tests"] = { t } })
end
refused("unknown field 'tests[1].mesured', did you mean 'tests[1].measured'?", { mesured = reference })
refused("field 'tests[1].name': expected a string, got 5", { name = 5 })
refused("field 'tests[1].predict': expected a function, got 3", { predict = 3 })
refused("field 'tests[1].measured': expected a table of numbers, got 3", { measured = 3 })
refused("field 'tests[1].measured': expected a table of numbers, got 'x' at place 2", { measured = { 1, "x" } })
refused("field 'tests[1].noise': expected 20 numbers, one per measured one, got 2", { noise = { 1, 2 } })
refused("field 'tests[1].noise': expected a positive number or a table of numbers above 0, got 0", { noise = 0 })
refused("unknown field 'further[1].measured'", {}, "further")
fails("unknown field 'parameters[1].strat', did you mean 'parameters[1].start'?", search, { parameters = { { name = "size", strat = 1 } } })
fails("field 'parameters[1].start': expected 2 to 3, got 1", search, { parameters = { { name = "size", start = 1, low = 2, high = 3 } } })
os.remove(path)
