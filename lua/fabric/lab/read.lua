-- fabric.lab.read: the record of a testing machine in SI units, whatever the names of its columns.
local fabric = require "fabric"
local define = require "fabric.define"
local fail = define.fail

local check = require "fabric.lab.check"
local house = require "fabric.lab.words"
local plain = house.plain

local function keys(t)
  local names = {}
  for name in pairs(t) do names[#names + 1] = name end
  table.sort(names)
  return table.concat(names, ", ")
end

-- The quantity given by a name: first by the user's words, then by the built-in letters and words.
local function quantity_of(vocabulary, name)
  name = plain(name)
  for _, own in ipairs(vocabulary.own or {}) do
    if name:find(own[1], 1, true) then return own[2] end
  end
  local short = vocabulary.letters[(name:gsub("%.$", ""))]
  if short then return short end
  for _, quantity in ipairs(vocabulary.quantities) do
    for _, word in ipairs(vocabulary.names[quantity]) do
      if name:find(word, 1, true) then return quantity end
    end
  end
end

-- SI size of a unit and the quantity that it measures: an elongation in per cent is a strain, a force may be one per width.
local also = { displacement = { "displacement", "strain" }, force = { "force", "force per width" }, time = { "time" }, strain = { "strain" } }
local function unit_of(vocabulary, quantity, unit)
  for _, meant in ipairs(also[quantity]) do
    local factor = vocabulary.units[meant][unit] or vocabulary.units[meant][vocabulary.aliases[unit] or unit]
    if factor then return factor, meant end
  end
  local factor = quantity == "force" and house.per_width(vocabulary, unit)
  if factor then return factor, "force per width" end
end

-- Splits a unit without brackets from a name: "Extension mm", "displacement_mm".
local function split_unit(vocabulary, column)
  if column.unit ~= "" then return end
  local name, unit = column.name:match "^(.-)[%s_]+(%S+)$"
  local quantity = name and quantity_of(vocabulary, name)
  if quantity and (unit_of(vocabulary, quantity, unit) or quantity == "strain" and unit_of(vocabulary, "displacement", unit)) then column.unit, column.bare = unit, name end
end

-- The quantity in a column, from its name and unit: an elongation in per cent is a strain, a strain in mm a displacement.
local function held(vocabulary, column)
  local quantity = quantity_of(vocabulary, column.bare or column.name)
  if quantity ~= "displacement" and quantity ~= "strain" then return quantity end
  local _, meant = unit_of(vocabulary, "displacement", column.unit)
  return meant or quantity
end

-- The number of words in the name with another meaning: "Maximum load" is not the load.
local function others(vocabulary, column)
  local count, quantity = 0, quantity_of(vocabulary, column.bare or column.name)
  for word in plain(column.bare or column.name):gmatch "[^%s_%-]+" do
    local known = vocabulary.letters[(word:gsub("%.$", ""))] == quantity
    for _, w in ipairs(vocabulary.names[quantity]) do known = known or word:find(w, 1, true) end
    if not known then count = count + 1 end
  end
  return count
end

-- The columns whose headings state the quantity with the fewest other words.
local function candidates(vocabulary, file, quantity)
  local best, least = {}, math.huge
  for _, column in ipairs(file.header and file or {}) do
    if held(vocabulary, column) == quantity then
      local count = others(vocabulary, column)
      if count < least then best, least = {}, count end
      if count == least then best[#best + 1] = column end
    end
  end
  return best
end

-- The column that the deck gives (by name or number) for a quantity.
local function named_column(t, file, quantity, wanted)
  if file[wanted] then return file[wanted] end
  local names, found = {}, nil
  for i, column in ipairs(file) do
    names[i] = "'" .. column.name .. "'"
    if column.name == wanted or column.bare == wanted then
      if found then
        fail(("read: %s: two columns are called '%s'; give the place of the %s: columns={ %s=%d } or %d"):format(t.file, wanted, quantity,
          quantity, found, i))
      end
      found = i
    end
  end
  if found then return file[found] end
  local place = math.type(wanted) == "integer" and ("a place from 1 to %d"):format(#file) or ("a column '%s'"):format(wanted)
  fail(("read: %s: expected %s for the %s, there are %s%s"):format(t.file, place, quantity, table.concat(names, ", "),
    math.type(wanted) == "integer" and (", got %d"):format(wanted) or ""))
end

-- The column of a quantity. needed: an error if there is none, or if two are possible.
local function find_column(vocabulary, t, file, quantity, needed)
  local wanted = (t.columns or {})[quantity]
  if wanted then return named_column(t, file, quantity, wanted) end
  local found = candidates(vocabulary, file, quantity)
  if #found > 1 and needed then
    local names, places = {}, {}
    for i, column in ipairs(found) do
      names[i] = "'" .. column.name .. "'"
      for k, c in ipairs(file) do places[i] = c == column and k or places[i] end
    end
    fail(("read: %s: columns %s (%s) may each be the %s; give columns={ %s=place }"):format(t.file, table.concat(names, " and "),
      table.concat(places, ", "), quantity, quantity))
  end
  return #found == 1 and found[1] or nil
end

-- SI size of the column's unit and the quantity it measures; nil if not known.
local function known_factor(vocabulary, t, quantity, column)
  local unit = (t.units or {})[quantity] or column.unit
  if unit == "" then unit = (t.default_units or {})[quantity] or "" end
  if unit == "" and quantity == "strain" then return 1, "strain" end
  return unit_of(vocabulary, quantity, unit)
end

-- The units that a quantity may have, in words.
local function choice(vocabulary, quantity)
  local all = keys(vocabulary.units[quantity])
  if quantity ~= "force" then return all end
  local own = keys(vocabulary.units["force per width"])
  return all .. "; per width one of these over a length, as N/mm or kgf/5cm" .. (own == "" and "" or ", and " .. own)
end

-- Says that a unit of mass was taken for the force of its weight.
local function tell_mass(vocabulary, t, column, unit)
  local _, force = house.per_width(vocabulary, unit)
  force = force or unit
  if house.masses[force] and not vocabulary.units.force[force] then
    fabric.warn(("read: %s: column '%s': '%s' is a unit of mass; it is taken for the force %s"):format(t.file, column.name, force, house.aliases[force]))
  end
end

local function factor_of(vocabulary, t, quantity, column)
  local factor, meant = known_factor(vocabulary, t, quantity, column)
  if factor then return factor, meant end
  local unit = (t.units or {})[quantity] or column.unit
  if unit == "" then unit = (t.default_units or {})[quantity] or "" end
  local weight = quantity == "force" and house.weights[unit]
  if weight then
    fail(("read: %s: column '%s': '%s' is a unit of mass, expected one of force; for the weight of that mass give units={ force='%s' }"):format(
      t.file, column.name, unit, weight))
  end
  local got = unit == "" and "the heading says none" or "got '" .. tostring(unit) .. "'"
  fail(("read: %s: column '%s': expected the unit of the %s (one of %s), %s; give units={ %s='...' }"):format(
    t.file, column.name, quantity, choice(vocabulary, quantity), got, quantity))
end

local function scaled(values, factor)
  if factor == 1 then return values end
  for i = 1, #values do values[i] = values[i] * factor end
  return values
end

-- The built-in words, preceded by those of the user: a table, or a Lua file that returns one.
local function vocabulary_of(t)
  if not t.vocabulary then return house end
  local more, from = t.vocabulary, "read: field 'vocabulary'"
  if type(more) == "string" then
    local chunk, trouble = loadfile(more, "t", {})
    if not chunk then fail("read: field 'vocabulary': " .. trouble) end
    local ok, made = pcall(chunk)
    if not ok or type(made) ~= "table" then
      fail(("read: field 'vocabulary': %s: expected 'return { force={...}, ... }', got %s"):format(t.vocabulary, tostring(made)))
    end
    more, from = made, "read: " .. t.vocabulary
  end
  return house.with(more, from, fail)
end

local function check_names(t)
  for _, field in ipairs { "columns", "units", "default_units" } do
    for quantity, value in pairs(t[field] or {}) do
      local known = quantity == "displacement" or quantity == "force" or quantity == "time" or quantity == "strain"
      local kind = type(value)
      if not known then
        fail(("read: field '%s': expected displacement, force, time or strain, got '%s'"):format(field, tostring(quantity)))
      elseif kind ~= "string" and (field ~= "columns" or math.type(value) ~= "integer") then
        fail(("read: field '%s.%s': expected %s, got %s"):format(field, quantity, field ~= "columns" and "a unit" or "a heading or a place", tostring(value)))
      end
    end
  end
end

-- A unit for headings without one must be known, whether a heading needs it or not.
local kinds = { displacement = "length", force = "force", time = "time", strain = "strain" }
local function check_defaults(vocabulary, t)
  for quantity, unit in pairs(t.default_units or {}) do
    if not unit_of(vocabulary, quantity, unit) then
      fail(("read: %s: field 'default_units.%s': '%s' is no unit of %s known: expected one of %s"):format(t.file, quantity, unit, kinds[quantity],
        choice(vocabulary, quantity)))
    end
  end
end

-- A strain without a unit is a number; one beyond 1 is rather in per cent, or an elongation in mm.
local function check_strain(t, column)
  if column.unit ~= "" or (t.units or {}).strain or (t.default_units or {}).strain then return end
  local most = 0
  for _, e in ipairs(column.values) do most = math.max(most, math.abs(e)) end
  if most > 1 then
    fail(("read: %s: column '%s': the strain runs to %.4g and its heading names no unit: is it in %%? give units={ strain='%%' }, or units={ strain='-' } for a number"):format(
      t.file, column.name, most))
  end
end

-- Copies a column in SI to the record; its unit determines what it measures.
local function take(vocabulary, t, record, quantity, column)
  local factor, meant = factor_of(vocabulary, t, quantity, column)
  if column.trouble then fail("read: " .. column.trouble) end
  if quantity == "force" then
    local unit = (t.units or {}).force or column.unit
    tell_mass(vocabulary, t, column, unit ~= "" and unit or (t.default_units or {}).force)
  end
  if meant == "force per width" then
    if not t.width then
      fail(("read: %s: column '%s' is a force per width: expected field 'width' of the specimen in m"):format(t.file, column.name))
    end
    check.lengths("read", { width = t.width })
    factor = factor * t.width
  end
  if quantity == "strain" then check_strain(t, column) end
  record[meant == "strain" and "strain" or quantity] = scaled(column.values, factor)
end

-- For a record with strain but no displacement: the displacement of the gauge length.
local function from_strain(t, record)
  if record.displacement or not record.strain then return end
  if not t.gauge_length then
    fail(("read: %s: a strain but no displacement: expected field 'gauge_length' in m, from which the displacement follows"):format(t.file))
  end
  check.lengths("read", { gauge_length = t.gauge_length })
  record.displacement, record.from_strain = {}, true
  for i, e in ipairs(record.strain) do record.displacement[i] = e * t.gauge_length end
end

local function missing(t, record, quantity)
  -- the line above the numbers names half as many columns: each comma of a decimal was taken for one between cells
  local above = record.preamble[#record.preamble] or ""
  local commas = select(2, above:gsub(",", "")) + 1
  local hint = commas > 1 and #record.names == 2 * commas
    and (" (the line above has %d words for %d cells: are there decimal commas between commas? put such numbers in quotes, or save with semicolons)"):format(commas, #record.names) or ""
  fail(("read: %s:1: expected a column of the %s, there are %s%s; give columns={ %s=name or place }"):format(
    t.file, quantity, table.concat(record.names, ", "), hint, quantity))
end

-- Displacement (or strain), force and the columns given by the deck must exist; time and strain are optional.
local function read(t)
  check_names(t)
  local vocabulary = vocabulary_of(t)
  check_defaults(vocabulary, t)
  local file = fabric.table { file = t.file, separator = t.separator, decimal = t.decimal, lenient = true }
  local record = { file = t.file, rows = #file[1].values, preamble = file.preamble, names = {} }
  for i, column in ipairs(file) do
    record.names[i] = column.name
    split_unit(vocabulary, column)
  end
  for i, quantity in ipairs(vocabulary.quantities) do
    local named = (t.columns or {})[quantity] or (t.units or {})[quantity]
    local column = find_column(vocabulary, t, file, quantity, i <= 2 or named)
    if column and (i <= 2 or named) then
      take(vocabulary, t, record, quantity, column)
    elseif column and not column.trouble and known_factor(vocabulary, t, quantity, column) then
      record[quantity] = scaled(column.values, (known_factor(vocabulary, t, quantity, column)))
    elseif column and column.trouble and quantity == "time" then
      fabric.warn(("read: %s: the time is left out, since its column cannot be read: %s"):format(t.file, column.trouble))
    elseif column and quantity == "strain" and not record.displacement then -- nothing else says how far the specimen was pulled
      take(vocabulary, t, record, quantity, column)
    elseif quantity == "force" or quantity == "displacement" and not find_column(vocabulary, t, file, "strain", false) then
      missing(t, record, quantity)
    end
  end
  if record.strain and not record.displacement then check_strain(t, find_column(vocabulary, t, file, "strain", true)) end
  from_strain(t, record)
  return record
end

define {
  name = "fabric.lab.read",
  arguments = {
    { name = "file", kind = "text", sentence = "of the load frame: CSV, TSV or the like" },
    { name = "columns", kind = "table", optional = true,
      sentence = "{displacement=, force=, time=, strain=}: heading or place of the column; default: known by the heading" },
    { name = "units", kind = "table", optional = true, sentence = "{displacement='mm', force='N'}; default: those of the headings" },
    { name = "default_units", kind = "table", optional = true, sentence = "the same, for columns whose heading says none" },
    { name = "gauge_length", kind = "number", unit = "m", above = 0, optional = true, sentence = "for a record of strains: the displacement follows" },
    { name = "width", kind = "number", unit = "m", above = 0, optional = true, sentence = "for a record of forces per width: the force follows" },
    { name = "vocabulary", kind = "table|text", optional = true,
      sentence = "words of your frame: {force={'siua'}, displacement={...}, time=, strain=, units={force={dyn=1e-5}}}, or a Lua file that returns them" },
    { name = "separator", kind = "text", choices = { "auto", ",", ";", "tab", "blank" }, default = "auto", sentence = "between cells" },
    { name = "decimal", kind = "text", choices = { "auto", ".", "," }, default = "auto", sentence = "decimal sign" },
  },
  sentence = "A load frame's record in SI: displacement, force, and time and strain where there are such columns that can be read; "
    .. "rows, names, preamble, file.",
  example = "local path = os.tmpname()\n"
    .. "local f = io.open(path, 'w') f:write 'Extension (mm),Load (kN)\\n0,0\\n2,0.001\\n' f:close()\n"
    .. "local r = require 'fabric'.lab.read{ file=path }\nos.remove(path)\n"
    .. "assert(r.displacement[2] == 0.002 and r.force[2] == 1)",
  run = read,
}
