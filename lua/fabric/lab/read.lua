-- fabric.lab.read: a record of a load frame in SI units, whatever the laboratory calls its columns.
local fabric = require "fabric"
local define = require "fabric.define"
local fail = define.fail

local inch, pound = 0.0254, 4.4482216152605
local units = {
  displacement = { m = 1, mm = 1e-3, cm = 1e-2, um = 1e-6, ["in"] = inch, inch = inch, ['"'] = inch },
  force = { N = 1, kN = 1e3, mN = 1e-3, cN = 1e-2, gf = 9.80665e-3, kgf = 9.80665, kp = 9.80665, lbf = pound, lb = pound },
  time = { s = 1, sec = 1, ms = 1e-3, min = 60, h = 3600 },
  strain = { ["-"] = 1, ["%"] = 1e-2, ["mm/mm"] = 1, ["1"] = 1 },
}

-- Words that the name of a column holds, in lower case, or one letter that it is.
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

local function quantity_of(name)
  name = name:lower()
  if letters[name] then return letters[name] end
  for _, quantity in ipairs(quantities) do
    for _, word in ipairs(words[quantity]) do
      if name:find(word, 1, true) then return quantity end
    end
  end
end

-- The column that the deck names (by name or place) for a quantity, or that its heading gives away.
local function find_column(t, file, quantity, wanted)
  if not wanted then
    for _, column in ipairs(file) do
      if file.header and quantity_of(column.name) == quantity then return column end
    end
    return
  end
  if file[wanted] then return file[wanted] end
  local names = {}
  for _, column in ipairs(file) do
    if column.name == wanted then return column end
    names[#names + 1] = "'" .. column.name .. "'"
  end
  fail(("read: %s: expected a column '%s' for the %s, there are %s"):format(t.file, wanted, quantity, table.concat(names, ", ")))
end

local function factor_of(t, quantity, column)
  local unit = (t.units or {})[quantity] or column.unit
  local known = units[quantity]
  if unit == "" and quantity == "strain" then return 1 end
  if known[unit] then return known[unit] end
  local got = unit == "" and "the heading says none" or "got '" .. unit .. "'"
  fail(("read: %s: column '%s': expected the unit of the %s (one of %s), %s; give units={ %s='...' }"):format(
    t.file, column.name, quantity, keys(known), got, quantity))
end

local function scaled(values, factor)
  if factor == 1 then return values end
  for i = 1, #values do values[i] = values[i] * factor end
  return values
end

local function read(t)
  local file = fabric.table { file = t.file, separator = t.separator, decimal = t.decimal }
  local record = { file = t.file, rows = #file[1].values, preamble = file.preamble, names = {} }
  for i, column in ipairs(file) do record.names[i] = column.name end
  for _, quantity in ipairs(quantities) do
    local column = find_column(t, file, quantity, (t.columns or {})[quantity])
    if column then record[quantity] = scaled(column.values, factor_of(t, quantity, column)) end
  end
  for _, quantity in ipairs { "displacement", "force" } do
    if not record[quantity] then
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
  sentence = "A load frame's record in SI: displacement, force, and time and strain where there are such columns; rows, names, "
    .. "preamble, file.",
  example = "local path = os.tmpname()\n"
    .. "local f = io.open(path, 'w') f:write 'Extension (mm),Load (kN)\\n0,0\\n2,0.001\\n' f:close()\n"
    .. "local r = require 'fabric'.lab.read{ file=path }\nos.remove(path)\n"
    .. "assert(r.displacement[2] == 0.002 and r.force[2] == 1)",
  run = read,
}
