-- fabric.lab.read: a record of a load frame in SI units, whatever the laboratory calls its columns.
local fabric = require "fabric"
local define = require "fabric.define"
local fail = define.fail

local inch, pound = 0.0254, 4.4482216152605
local units = {
  displacement = { m = 1, mm = 1e-3, cm = 1e-2, um = 1e-6, ["in"] = inch },
  force = { N = 1, kN = 1e3, mN = 1e-3, cN = 1e-2, gf = 9.80665e-3, kgf = 9.80665, lbf = pound },
  time = { s = 1, ms = 1e-3, min = 60, h = 3600 },
  strain = { ["-"] = 1, ["%"] = 1e-2, ["mm/mm"] = 1, ["1"] = 1 },
}
local aliases = { MM = "mm", CM = "cm", inch = "in", inches = "in", ["in."] = "in", ['"'] = "in", KN = "kN", kp = "kgf", lb = "lbf", lbs = "lbf", S = "s", sec = "s",
  ["\u{b5}m"] = "um", ["\u{3bc}m"] = "um", ["\xb5m"] = "um" }

-- Words that the name of a column holds, in lower case without accents, or one letter that it is.
local words = {
  displacement = { "displacement", "extension", "elongation", "crosshead", "stroke", "position", "travel", "weg", "deplacement" },
  force = { "force", "load", "kraft", "charge" },
  time = { "time", "zeit", "temps" },
  strain = { "strain", "dehnung" },
}
local quantities = { "displacement", "force", "time", "strain" }
local letters = { u = "displacement", dl = "displacement", p = "force", f = "force", t = "time" }

local function keys(t)
  local names = {}
  for name in pairs(t) do names[#names + 1] = name end
  table.sort(names)
  return table.concat(names, ", ")
end

local function plain(name)
  name = name:gsub("\u{e9}", "e"):gsub("\u{c9}", "e"):gsub("[\xe9\xc9]", "e")
  return name:lower()
end

local function quantity_of(name)
  name = plain(name)
  if letters[name] then return letters[name] end
  for _, quantity in ipairs(quantities) do
    for _, word in ipairs(words[quantity]) do
      if name:find(word, 1, true) then return quantity end
    end
  end
end

-- A unit behind the name without brackets: "Extension mm", "displacement_mm".
local function split_unit(column)
  if column.unit ~= "" then return end
  local name, unit = column.name:match "^(.-)[%s_]+(%S+)$"
  local quantity = name and quantity_of(name)
  if quantity and units[quantity][aliases[unit] or unit] then column.unit, column.bare = unit, name end
end

-- How many words of the name say something else: "Maximum load" is not the load.
local function others(column, quantity)
  local count = 0
  for word in plain(column.bare or column.name):gmatch "[^%s_%-]+" do
    local known = letters[word] == quantity
    for _, w in ipairs(words[quantity]) do known = known or word:find(w, 1, true) end
    if not known then count = count + 1 end
  end
  return count
end

-- The columns whose headings give the quantity away with fewest other words.
local function candidates(file, quantity)
  local best, least = {}, math.huge
  for _, column in ipairs(file.header and file or {}) do
    if quantity_of(column.bare or column.name) == quantity then
      local count = others(column, quantity)
      if count < least then best, least = {}, count end
      if count == least then best[#best + 1] = column end
    end
  end
  return best
end

-- The column that the deck names (by name or place) for a quantity.
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
  fail(("read: %s: expected a column '%s' for the %s, there are %s"):format(t.file, wanted, quantity, table.concat(names, ", ")))
end

-- The column of a quantity; needed: a file without it, or with two that might be it, is an error.
local function find_column(t, file, quantity, needed)
  local wanted = (t.columns or {})[quantity]
  if wanted then return named_column(t, file, quantity, wanted) end
  local found = candidates(file, quantity)
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

-- SI per unit of the column; nil where it is not known.
local function known_factor(t, quantity, column)
  local unit = (t.units or {})[quantity] or column.unit
  if unit == "" and quantity == "strain" then return 1 end
  return units[quantity][aliases[unit] or unit], unit
end

local function factor_of(t, quantity, column)
  local factor, unit = known_factor(t, quantity, column)
  if factor then return factor end
  local got = unit == "" and "the heading says none" or "got '" .. unit .. "'"
  fail(("read: %s: column '%s': expected the unit of the %s (one of %s), %s; give units={ %s='...' }"):format(
    t.file, column.name, quantity, keys(units[quantity]), got, quantity))
end

local function scaled(values, factor)
  if factor == 1 then return values end
  for i = 1, #values do values[i] = values[i] * factor end
  return values
end

-- Displacement and force must be there, and what the deck names; time and strain are read where they can be.
local function read(t)
  local file = fabric.table { file = t.file, separator = t.separator, decimal = t.decimal, lenient = true }
  local record = { file = t.file, rows = #file[1].values, preamble = file.preamble, names = {} }
  for i, column in ipairs(file) do
    record.names[i] = column.name
    split_unit(column)
  end
  for i, quantity in ipairs(quantities) do
    local needed = i <= 2 or (t.columns or {})[quantity] or (t.units or {})[quantity]
    local column = find_column(t, file, quantity, needed)
    if column and needed then
      local factor = factor_of(t, quantity, column)
      if column.trouble then fail("read: " .. column.trouble) end
      record[quantity] = scaled(column.values, factor)
    elseif column and not column.trouble and known_factor(t, quantity, column) then
      record[quantity] = scaled(column.values, (known_factor(t, quantity, column)))
    elseif i <= 2 then
      fail(("read: %s:1: expected a column of the %s, there are %s; give columns={ %s=name or place }"):format(
        t.file, quantity, table.concat(record.names, ", "), quantity))
    end
  end
  return record
end

define {
  name = "fabric.lab.read",
  arguments = {
    { name = "file", kind = "text", sentence = "of the load frame: CSV, TSV or the like" },
    { name = "columns", kind = "table", optional = true,
      sentence = "{displacement=, force=, time=, strain=}: heading or place of the column; default: known by the heading" },
    { name = "units", kind = "table", optional = true, sentence = "{displacement='mm', force='N'}; default: those of the headings" },
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
