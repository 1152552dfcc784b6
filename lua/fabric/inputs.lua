-- fabric.sobol and fabric.latin_hypercube: cases of a study that fill the ranges of their inputs evenly.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local fail = define.fail
local random = require "fabric.lab.random"

local function is_number(v) return type(v) == "number" and v == v and math.abs(v) < math.huge end

-- An input: {low, high} is uniform, {mean=, deviation=} normal.
local function check_input(call, name, spec)
  if type(name) ~= "string" then fail(("%s: expected name={low, high} or name={mean=, deviation=}, got an entry %s"):format(call, tostring(name))) end
  local uniform = type(spec) == "table" and is_number(spec[1]) and is_number(spec[2]) and spec[1] <= spec[2] and #spec == 2 and spec.mean == nil
  local normal = type(spec) == "table" and is_number(spec.mean) and is_number(spec.deviation) and spec.deviation >= 0 and #spec == 0
  if not (uniform or normal) then
    fail(("%s: field '%s': expected {low, high} with low <= high, or {mean=, deviation=} with a deviation of 0 or more"):format(call, name))
  end
end

-- The value of an input at a probability p, between 0 and 1.
local function value_at(spec, p)
  if spec.mean then return spec.mean + spec.deviation * fabric.lab.normal(p) end
  return spec[1] + (spec[2] - spec[1]) * p
end

local function whole(call, t, name, default, low, high)
  local value = t[name]
  if value == nil and default then return default end
  if math.type(value) ~= "integer" or value < low or value > high then
    fail(("%s: field '%s': expected a whole number from %d to %d, got %s"):format(call, name, low, high, tostring(value)))
  end
  return value
end

-- The inputs by name, and their names in alphabetical order.
local function read(call, t)
  local specs, names = {}, {}
  for name, spec in pairs(t) do
    if name ~= "n" and name ~= "seed" then
      check_input(call, name, spec)
      specs[name], names[#names + 1] = spec, name
    end
  end
  if #names == 0 then fail(call .. ": expected at least one input name={low, high} or name={mean=, deviation=}") end
  table.sort(names)
  return specs, names, whole(call, t, "n", nil, 1, 1000000), whole(call, t, "seed", 1, 0, math.maxinteger)
end

local function cases(specs, names, n, probability)
  local list = {}
  for i = 1, n do
    local case = {}
    for k, name in ipairs(names) do case[name] = value_at(specs[name], probability(i, k)) end
    list[i] = case
  end
  return list
end

local function sobol(t)
  local specs, names, n, seed = read("sobol", t)
  local points = kernels.sobol_points(n, #names, seed)
  return cases(specs, names, n, function(i, k) return points[(i - 1) * #names + k] end)
end

-- Each input has one value in each of n equally probable parts of its range, in an order of its own [mckay1979].
local function latin_hypercube(t)
  local specs, names, n, seed = read("latin_hypercube", t)
  local draw, columns = random(seed), {}
  for k = 1, #names do
    local order = {}
    for i = 1, n do order[i] = i end
    for i = n, 2, -1 do
      local j = math.min(i, 1 + math.floor(i * draw.uniform()))
      order[i], order[j] = order[j], order[i]
    end
    for i = 1, n do order[i] = (order[i] - draw.uniform()) / n end
    columns[k] = order
  end
  return cases(specs, names, n, function(i, k) return columns[k][i] end)
end

local inputs = "{ name={low, high} or {mean=, deviation=}, ..., n=cases, seed=1 }: uniform or normal inputs by name"
define {
  name = "fabric.sobol",
  positional = true,
  arguments = { { name = "inputs", kind = "table", sentence = inputs .. "; seed 0: the sequence as it is, others shift it" } },
  sentence = "Cases for fabric.study{ sample= } at the points of Sobol's sequence [joe2008]: a list of { name=value }. Means over n such cases are closer than over n random ones; best with n a power of 2.",
  example = "local cases = require 'fabric'.sobol{ friction={0.1, 0.4}, width={mean=0.05, deviation=0.001}, n=16 }\n"
    .. "assert(#cases == 16 and cases[1].friction > 0.1 and cases[1].friction < 0.4)",
  run = sobol,
}
define {
  name = "fabric.latin_hypercube",
  positional = true,
  arguments = { { name = "inputs", kind = "table", sentence = inputs } },
  sentence = "Cases for fabric.study{ sample= } by Latin hypercube sampling [mckay1979]: each input has one value in each of n equally probable parts of its range.",
  example = "local cases = require 'fabric'.latin_hypercube{ friction={0, 1}, n=4 }\nlocal seen = {}\n"
    .. "for _, c in ipairs(cases) do seen[math.floor(4 * c.friction)] = true end\nassert(seen[0] and seen[1] and seen[2] and seen[3])",
  run = latin_hypercube,
}
