-- Hooks after a restart: each has the clock of the hook that was called as often, also where a deck has fewer of them.
local fabric = require "fabric"

local file = os.tmpname()
local function strip()
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 2, ny = 2 }, card = fabric.card("blend", { bending = "estimated" }) }
  m:fix("left", "x y z rotation"):gravity { 0, 0, -9.81 }
  return fabric.dynamic { model = m, duration = 0.01 }
end

local a = strip()
a:checkpoint(file, { every = 0.005 })
a:every(0.001, function() end)
a:every(0.0025, function() end)
a:advance(0.005)

local function times_of(...)
  local b, times = strip(), {}
  b:restart(file)
  for _, interval in ipairs { ... } do
    times[#times + 1] = {}
    local list = times[#times]
    b:every(interval, function(now) list[#list + 1] = ("%.4f"):format(now.time) end)
  end
  b:solve()
  for i, list in ipairs(times) do times[i] = table.concat(list, " ") end
  return table.concat(times, "; ")
end

local fast, slow, other = "0.0060 0.0070 0.0080 0.0090 0.0100", "0.0075 0.0100", "0.0060 0.0080 0.0100"
assert(times_of(0.001, 0.0025) == fast .. "; " .. slow)
assert(times_of(0.0025) == slow)
assert(times_of(0.0025, 0.001) == slow .. "; " .. fast)
assert(times_of(0.002, 0.001) == other .. "; " .. fast)
os.remove(file)
