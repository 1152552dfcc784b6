-- The simulations of an identification so far: for each point of the parameters the predictions of the tests, or the message of a
-- failure. They are kept in a file, so that an interrupted run can continue: the search takes the same path again, and known
-- points cost nothing. The noise is not stored, because the predictions do not depend on it.
local fabric = require "fabric"
local fail = require "fabric.define".fail
local lists = require "fabric.lists"

local store = {}

function store.key_of(point)
  local words = lists.map(point, function(x) return ("%.17g"):format(x) end)
  return table.concat(words, " ")
end

local function numbers_of(words)
  local list = {}
  for word in words:gmatch "%S+" do list[#list + 1] = tonumber(word) end
  return list
end

-- The subject of the file in one line.
function store.signature(t)
  local words = lists.collect(t.parameters, function(p) return ("%s %.17g %.17g"):format(p.name, p.low, p.high) end)
  for _, test in ipairs(t.tests) do words[#words + 1] = test.name .. " " .. store.key_of(test.measured) end
  if t.key then words[#words + 1] = "key " .. t.key end
  return ("identify 2: " .. table.concat(words, "; ")):gsub("%s+", " ")
end

local function read(cache, f, count)
  for line in f:lines() do
    local point, message = line:match "^(.-) failed: (.*)$"
    if point then
      cache.add(numbers_of(point), { trouble = message })
    else
      local values
      point, values = line:match "^(.-) : (.*)$"
      values = numbers_of(values or "")
      if #values == count then cache.add(numbers_of(point), values) end
    end
  end
end

-- values: by key, the predicted numbers in the order of the tests, or {trouble=}; points: in the order of their computation.
-- count: numbers per point.
function store.open(path, signature, count)
  local cache = { values = {}, points = {} }
  function cache.add(point, values)
    local key = store.key_of(point)
    if not cache.values[key] then cache.points[#cache.points + 1] = point end
    cache.values[key] = values
  end
  function cache.save()
    if not path then return end
    local lines = { signature }
    for _, point in ipairs(cache.points) do
      local key = store.key_of(point)
      local values = cache.values[key]
      lines[#lines + 1] = key .. (values.trouble and " failed: " .. values.trouble:gsub("%s+", " ") or " : " .. store.key_of(values))
    end
    fabric.write(path, table.concat(lines, "\n") .. "\n")
  end
  local f = path and io.open(path)
  if f then
    if f:read "l" ~= signature then
      f:close()
      fail(("identify: field 'checkpoint': '%s' is of another problem (other parameters, tests, data or key)"):format(path))
    end
    read(cache, f, count)
    f:close()
  end
  return cache
end

return store
