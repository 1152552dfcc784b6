-- Wrong values deep inside the tables that the laboratory takes: every complaint names the deck's line and none is the library's own
-- stumble over them. The arguments are those of the rows' examples, one value at a time put wrong. The short form puts one of the twelve
-- values at each place, another one at the next, the long one all.
local fabric = require "fabric"
local registry = require "fabric.define".registry

-- Whole simulations, whose arguments are all rows: tests/lua/errors has their cases.
local simulations = { uniaxial = true, bias = true, shear = true, biaxial = true, drape = true, poke = true, bias_extension = true, mesh_error = true,
  identify = true, pool = true, parallel = true, synthetic = true }

local function copy(value)
  if type(value) ~= "table" then return value end
  local out = {}
  for k, v in pairs(value) do out[k] = copy(v) end
  return out
end

-- The calls of a function that its example makes: copies of its arguments.
local function calls_of(row, word)
  local taken, real = {}, fabric.lab[word]
  fabric.lab[word] = function(t)
    taken[#taken + 1] = copy(t)
    return real(t)
  end
  assert(load(row.example))()
  fabric.lab[word] = real
  return taken, real
end

-- Every place in a table, three deep, of a list its first and last entry.
local function places(t, path, out)
  for key, value in pairs(t) do
    if type(key) ~= "number" or key == 1 or key == #t then
      local here = { table.unpack(path) }
      here[#here + 1] = key
      out[#out + 1] = here
      if type(value) == "table" and #here < 4 then places(value, here, out) end
    end
  end
  return out
end

local apart = os.getenv "FABRICSH_TEST_LONG" and 1 or 12
local wrong = { false, true, "x", {}, { {} }, { "x" }, -1, 0.0, 0 / 0, 1e300, print, "nothing" }

-- A copy of the arguments with another value at a place.
local function changed(arguments, path, value)
  local out = copy(arguments)
  local at = out
  for i = 1, #path - 1 do at = at[path[i]] end
  at[path[#path]] = value
  return out
end

local here, tried, refused = arg[0], 0, 0
fabric.warn = function() end
local function try(word, f, arguments, path, value)
  if value == "nothing" then value = nil end
  local t = changed(arguments, path, value)
  local ok, message = pcall(f, t)
  tried = tried + 1
  if ok then return end
  refused = refused + 1
  message = tostring(message)
  local own = message:sub(1, #here + 1) == here .. ":" or message:find("^%[C%]") or message:find "^lab_wrong"
  if not own or message:find "internal error" or message:find "attempt to" then
    error(("%s: %s = %s: %s"):format(word, table.concat(path, "."), tostring(value), message), 0)
  end
end

local troubles = {}
for _, row in ipairs(registry.rows()) do
  local word = row.name:match "^fabric%.lab%.([%w_]+)$"
  if word and row.style == "fields" and not simulations[word] then
    local calls, f = calls_of(row, word)
    for _, arguments in ipairs(calls) do
      for k, path in ipairs(places(arguments, {}, {})) do
        for i, value in ipairs(wrong) do
          if (i + k) % apart == 0 then
            local ok, trouble = pcall(try, word, f, arguments, path, value)
            if not ok then troubles[#troubles + 1] = trouble end
          end
        end
      end
    end
  end
end
print(tried .. " calls, " .. refused .. " refused")
assert(#troubles == 0, #troubles .. " without the deck's line or in the library's own words:\n" .. table.concat(troubles, "\n"))
