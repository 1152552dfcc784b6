-- Identification: an interrupted search goes on from its checkpoint, a failed simulation is walked around, a wrong problem refused.
local fabric = require "fabric"
local lab = fabric.lab

local function fails(words, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end

local calls, stop_at = 0, math.huge
local function decay(p)
  calls = calls + 1
  if calls > stop_at then error("the lights went out", 0) end
  if p.rate > 2.9 then error("no such rate", 0) end
  local out = {}
  for i = 1, 20 do out[i] = p.size * math.exp(-p.rate * i / 10) end
  return out
end
local truth = decay { size = 2, rate = 1.3 }
local path = os.tmpname()
os.remove(path)
local function search(more)
  local t = { parameters = { { name = "size", start = 1, low = 0.1, high = 10 }, { name = "rate", start = 0.4, low = 0, high = 3 } },
    tests = { { name = "decay", measured = truth, predict = decay } }, processes = 1, checkpoint = path, tolerance = 1e-10, difference = 1e-5 }
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
assert(calls == 0)
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
