-- Systems of units for decks of other solvers, which do not know units and only require that all numbers are consistent.
local units = {}

-- The size of one SI unit in the system: a value in SI times this factor is the value to write.
local systems = {
  ["SI"] = { length = 1, mass = 1, time = 1, words = "m, kg, s, N, Pa" },
  ["mm-t-s"] = { length = 1e3, mass = 1e-3, time = 1, words = "mm, t, s, N, MPa" },
  ["mm-kg-ms"] = { length = 1e3, mass = 1, time = 1e3, words = "mm, kg, ms, kN, GPa" },
}
units.names = { "mm-t-s", "mm-kg-ms", "SI" }

local function complete(s, name)
  return {
    name = name, words = s.words, length = s.length, mass = s.mass, time = s.time,
    stress = s.mass / (s.length * s.time ^ 2), density = s.mass / s.length ^ 3, force = s.mass * s.length / s.time ^ 2,
    moment = s.mass * s.length ^ 2 / s.time ^ 2, acceleration = s.length / s.time ^ 2, velocity = s.length / s.time,
  }
end

-- The system of that name: factors of length, mass, time, stress, density, force, rigidity (N.m), acceleration, velocity; name,
-- words.
function units.of(name) return complete(systems[name], name) end

local sizes = {
  mass = { kg = 1, g = 1e-3, mg = 1e-6, Mg = 1e3, t = 1e3, ton = 1e3, lb = 0.45359237 },
  length = { m = 1, mm = 1e-3, cm = 1e-2, km = 1e3, ["in"] = 0.0254, ft = 0.3048 },
  time = { s = 1, ms = 1e-3, mus = 1e-6, us = 1e-6 },
}

-- The quantity that a word is a unit of: "mass", "length" or "time"; nil: of none of them.
function units.quantity_of(word)
  for quantity, known in pairs(sizes) do
    if known[word] then return quantity end
  end
end

-- Whether two systems have the same mass, length and time.
function units.same(a, b)
  for quantity in pairs(sizes) do
    if math.abs(a[quantity] / b[quantity] - 1) > 1e-9 then return false end
  end
  return true
end

-- The system of Radioss' words for mass, length and time, such as "Mg", "mm", "s", or their sizes in SI as numbers; nil if one is unknown.
function units.of_words(mass, length, time)
  local s = { words = ("%s, %s, %s"):format(mass, length, time) }
  for quantity, word in pairs { mass = mass, length = length, time = time } do
    local size = sizes[quantity][word] or tonumber(word)
    if not size or size <= 0 then return end
    s[quantity] = 1 / size
  end
  local name = s.words
  for known, other in pairs(systems) do
    if units.same(s, other) then name, s = known, other end
  end
  return complete(s, name)
end

-- A number with as many digits as fit into `width` characters; never wider.
function units.fixed(x, width)
  if math.type(x) == "integer" then return ("%" .. width .. "d"):format(x) end
  for digits = math.min(12, width), 1, -1 do
    local text = ("%." .. digits .. "g"):format(x)
    if #text < width then return (" "):rep(width - #text) .. text end
  end
  error(("a number that %d columns can't hold: %s"):format(width, x))
end

-- The shortest text that reads back as the same number.
function units.exact(x)
  for digits = 10, 17 do
    local text = ("%." .. digits .. "g"):format(x)
    if tonumber(text) == x then return text end
  end
end

-- The same in `width` characters, with a blank before it; where it is longer, with as many digits as fit.
function units.fitting(x, width)
  local text = units.exact(x)
  for digits = 17, 1, -1 do
    if #text < width then return (" "):rep(width - #text) .. text end
    text = ("%." .. digits .. "g"):format(x)
  end
  return units.fixed(x, width)
end

-- A line of fields of equal width.
function units.line(width, values)
  local out = {}
  for i, v in ipairs(values) do out[i] = v == "" and (" "):rep(width) or units.fixed(v, width) end
  return table.concat(out)
end

return units
