-- fabric.lab.read: the record of a testing machine in SI units, whatever the names of its columns.
local fabric = require "fabric"
local define = require "fabric.define"
local fail = define.fail

local check = require "fabric.lab.common.check"
local doubts = require "fabric.lab.record.doubts"
local house = require "fabric.lab.record.words"
local function specimens() return require "fabric.lab.record.specimens" end -- loaded when a file is read
local lists = require "fabric.lists"
local plain = house.plain

local function keys(t) return table.concat(lists.keys(t), ", ") end

-- The quantity given by a name: first by the user's words, then by the built-in letters and words.
local function quantity_of(vocabulary, name)
  for _, known in ipairs(house.bytes) do
    if not utf8.len(name) and name:lower():find(known[1], 1, true) then return known[2] end
  end
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

-- Splits a unit without brackets from a name: "Extension mm", "displacement_mm", "Load/N", "Axial strain mm/mm", at the first place that leaves a quantity and a unit.
local function split_unit(vocabulary, column)
  if column.unit ~= "" then return end
  for place in column.name:gmatch "()[%s_,/]+%S" do
    local name, unit = column.name:sub(1, place - 1), column.name:sub(place):match "^[%s_,/]+(%S+)$"
    local quantity = unit and quantity_of(vocabulary, name)
    if quantity and (unit_of(vocabulary, quantity, unit) or quantity == "strain" and unit_of(vocabulary, "displacement", unit)) then
      column.unit, column.bare = unit, name
      return
    end
  end
end

-- The quantity in a column, from its name and unit: an elongation in per cent is a strain, a strain in mm a displacement.
local function held(vocabulary, column)
  local quantity = quantity_of(vocabulary, column.bare or column.name)
  if quantity ~= "displacement" and quantity ~= "strain" then return quantity end
  local _, meant = unit_of(vocabulary, "displacement", column.unit)
  return meant or quantity
end

-- The number of words in the name with another meaning: "Maximum load" is not the load. The part of the machine that moves is the name of a column only where
-- it stands alone: "Traverse", but not "Displacement of the traverse" beside "Elongation".
local function others(vocabulary, column)
  local count, parts, quantity = 0, 0, quantity_of(vocabulary, column.bare or column.name)
  local words = 0
  for word in plain(column.bare or column.name):gmatch "[^%s_%-]+" do
    local known, part = vocabulary.letters[(word:gsub("%.$", ""))] == quantity, false
    for _, w in ipairs(vocabulary.names[quantity]) do known = known or word:find(w, 1, true) end
    for _, w in ipairs(house.parts) do part = part or word:find(w, 1, true) end
    words = words + 1
    if part then parts = parts + 1 elseif not known then count = count + 1 end
  end
  return parts < words and count + parts or count
end

-- The columns whose headings state the quantity with the fewest other words; and those with more.
local function candidates(vocabulary, file, quantity)
  local best, rest, least = {}, {}, math.huge
  for _, column in ipairs(file.header and file or {}) do
    if held(vocabulary, column) == quantity then
      local count = others(vocabulary, column)
      if count < least then
        table.move(best, 1, #best, #rest + 1, rest)
        best, least = {}, count
      end
      table.insert(count == least and best or rest, column)
    end
  end
  return best, rest
end

-- Says which column was taken where another, with numbers in a unit of the same kind, might be meant; a largest or mean value is not.
local function is_summary(name) return name:find "max" or name:find "min" or name:find "peak" or name:find "mean" or name:find "average" end
local function warn_choice(vocabulary, t, quantity, column, rest)
  local names = {}
  for _, other in ipairs(rest) do
    if not other.trouble and not is_summary(plain(other.name)) and unit_of(vocabulary, quantity, other.unit) then names[#names + 1] = "'" .. other.name .. "'" end
  end
  if #names > 0 then
    fabric.warn(("read: %s: the %s is column '%s'; %s might be it too: columns={ %s='...' } chooses"):format(t.file, quantity, column.name,
      table.concat(names, ", "), quantity))
  end
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
  if wanted == false then return end
  if wanted then return named_column(t, file, quantity, wanted) end
  local found, rest = candidates(vocabulary, file, quantity)
  if #found == 1 and needed then warn_choice(vocabulary, t, quantity, found[1], rest) end
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
local function warn_mass(vocabulary, t, column, unit)
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
      elseif kind ~= "string" and (field ~= "columns" or math.type(value) ~= "integer" and not (value == false and (quantity == "time" or quantity == "strain"))) then
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

-- Says something worth knowing of a record, and keeps it with it.
local function tell(t, record, one)
  record.warnings = record.warnings or {}
  for _, known in ipairs(record.warnings) do
    if known.text == one.text then return end
  end
  table.insert(record.warnings, one)
  fabric.warn(("read: %s: %s%s"):format(t.file, record.specimen and "specimen " .. record.specimen .. ": " or "", one.text))
end

-- A strain without a unit is a number; one beyond 1 is rather in per cent, or an elongation in mm, and a large one may be. Per cent below a tenth would be no pull.
local large_strain = 0.1
local function check_strain(t, record, column)
  if column.unit ~= "" or (t.units or {}).strain or (t.default_units or {}).strain then return end
  local most = 0
  for _, e in ipairs(column.values) do most = math.max(most, math.abs(e)) end
  if most > large_strain and most <= 1 then
    tell(t, record, { code = "strain-unit", text = ("column '%s': the strain runs to %.4g and its heading names no unit: it is read as a number, %.4g %%; units={ strain='-' } says that it is one, units={ strain='%%' } that it is in per cent")
      :format(column.name, most, 100 * most) })
  elseif most > 1 then
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
    warn_mass(vocabulary, t, column, unit ~= "" and unit or (t.default_units or {}).force)
  end
  if meant == "force per width" then
    if not t.width then
      fail(("read: %s: column '%s' is a force per width: expected field 'width' of the specimen in m"):format(t.file, column.name))
    end
    check.lengths("read", { width = t.width })
    factor = factor * t.width
  end
  if quantity == "strain" then check_strain(t, record, column) end
  if column.doubt then tell(t, record, { code = "signs", text = ("column '%s': %s"):format(column.name, column.doubt) }) end
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

-- Says why an optional column with numbers is not read: nothing is dropped without a word.
local function warn_dropped(vocabulary, t, file, quantity, column)
  if (t.columns or {})[quantity] == false then return end
  if column and column.trouble then
    fabric.warn(("read: %s: the %s is left out, since its column cannot be read: %s"):format(t.file, quantity, column.trouble))
  elseif column then
    fabric.warn(("read: %s: the %s is left out, since the unit of column '%s' is not known: '%s'; give units={ %s='...' }"):format(t.file, quantity,
      column.name, column.unit, quantity))
  elseif #candidates(vocabulary, file, quantity) > 1 then
    fabric.warn(("read: %s: the %s is left out, since several columns may be it; give columns={ %s=name or place }"):format(t.file, quantity, quantity))
  end
end

-- The time may not go back: then rows are out of order, or totals or another specimen stand below the record.
local function check_time(t, record, lines)
  local time = record.time
  for row = 2, time and #time or 0 do
    if time[row] < time[row - 1] then
      fail(("read: %s:%d: the time goes back from %.6g to %.6g s: are rows out of order, or is this a total or another specimen? Mend the file, or "
        .. "leave the time out by columns={ time=false }"):format(t.file, lines[row], time[row - 1], time[row]))
    end
  end
end

-- The first row at which a displacement leaps, and its largest step and range before: back by a quarter of its range so far and by five times more than it ever
-- moved in a row before, or, in the last three rows, forward by more than its range and five such steps, as a sum does.
local function leap_in(u, timed)
  local low, high, most = u[1], u[1], 0
  for row = 2, #u do
    local step = u[row] - u[row - 1]
    local back, on = not timed and row > 0.1 * #u and -step > 0.25 * (high - low), row > #u - 3 and step > high - low
    if row > 8 and (back or on) and math.abs(step) > 5 * most then return row, most, high - low end
    low, high, most = math.min(low, u[row]), math.max(high, u[row]), math.max(most, math.abs(step))
  end
end

-- A leap to a place that is not the beginning is a total; to the beginning, another specimen (if a blank line stands before it), or a way back that was not
-- recorded. Where there is a time, that tells what goes back.
local function check_leap(t, record, lines)
  local u = record.displacement
  local row, most, range = leap_in(u, record.time)
  if not row then return end
  local words = ("read: %s:%d: the displacement leaps %s from %.6g to %.6g m in one row, before by %.3g m at most: "):format(t.file, lines[row],
    u[row] < u[row - 1] and "back" or "on", u[row - 1], u[row], most)
  if math.abs(u[row] - u[1]) > 0.05 * range then
    fail(words .. "are totals below the record? Take them out of the file")
  elseif row < #u then
    fabric.warn(words .. "does another specimen begin here? It is read as the same")
  end
end

-- The last row in which one of the columns has something.
local function last_row(columns)
  local last = #columns[1].values
  local function is_empty(row)
    for _, column in ipairs(columns) do
      if not column.words or column.words[row] ~= "" then return false end
    end
    return true
  end
  while last > 0 and is_empty(last) do last = last - 1 end
  return last
end

local function shorten(column, last)
  local bad = false
  for row = #column.values, last + 1, -1 do
    column.values[row] = nil
    if column.words then column.words[row] = nil end
  end
  for _, value in ipairs(column.values) do bad = bad or value ~= value end
  if not bad then column.trouble, column.words = nil, nil end
end

-- Takes off the rows at the end in which no column that the deck names has anything: those below the shorter of specimens that stand side by side.
local function end_with_numbers(file, named)
  local last = #named > 0 and last_row(named) or 0
  if last == 0 or last == #file[1].values then return end
  for _, column in ipairs(file) do shorten(column, last) end
  for row = #file.lines, last + 1, -1 do file.lines[row] = nil end
end

-- The columns of the quantities that the deck names by `columns`, each once.
local function named_columns(t, file)
  local out, seen = {}, {}
  for quantity, wanted in pairs(t.columns or {}) do
    local column = wanted and named_column(t, file, quantity, wanted)
    if column and not seen[column] then out[#out + 1], seen[column] = column, true end
  end
  return out
end

-- The record of one table. Displacement (or strain), force and the columns given by the deck must exist; time and strain are optional.
local function record_of(vocabulary, t, file)
  end_with_numbers(file, named_columns(t, file))
  local record = { file = t.file, rows = #file[1].values, preamble = file.preamble, names = {}, specimen = file.specimen, lines = file.lines }
  if #file.left_out > 0 then record.left_out = file.left_out end
  for i, column in ipairs(file) do record.names[i] = column.name end
  for i, quantity in ipairs(vocabulary.quantities) do
    local named = (t.columns or {})[quantity] or (t.units or {})[quantity]
    local column = find_column(vocabulary, t, file, quantity, i <= 2 or named)
    if column and (i <= 2 or named) then
      take(vocabulary, t, record, quantity, column)
    elseif column and not column.trouble and known_factor(vocabulary, t, quantity, column) then
      record[quantity] = scaled(column.values, (known_factor(vocabulary, t, quantity, column)))
      if column.doubt then tell(t, record, { code = "signs", text = ("column '%s': %s"):format(column.name, column.doubt) }) end
    elseif column and not column.trouble and quantity == "strain" and not record.displacement then -- nothing else says how far the specimen was pulled
      take(vocabulary, t, record, quantity, column)
    elseif quantity == "force" or quantity == "displacement" and not find_column(vocabulary, t, file, "strain", false) then
      missing(t, record, quantity)
    elseif quantity == "strain" and column and not record.displacement then
      take(vocabulary, t, record, quantity, column)
    elseif quantity ~= "displacement" then
      warn_dropped(vocabulary, t, file, quantity, column)
    end
  end
  if record.strain and not record.displacement then check_strain(t, record, find_column(vocabulary, t, file, "strain", true)) end
  from_strain(t, record)
  check_time(t, record, file.lines)
  doubts.reverse(record, t.reverse)
  record.restarts = doubts.restarts(record.displacement, record.force)
  if #record.restarts == 0 then
    record.restarts = nil
    check_leap(t, record, file.lines)
  end
  for _, one in ipairs(doubts.of(record, t.restarts)) do tell(t, record, one) end
  return record
end

-- The rows of a record from one at which another specimen begins to the next, as records of their own.
local function parted(record)
  local out, starts = {}, { 1 }
  table.move(record.restarts, 1, #record.restarts, 2, starts)
  for k, first in ipairs(starts) do
    local last, part = (starts[k + 1] or #record.force + 1) - 1, {}
    for name, values in pairs(record) do
      part[name] = type(values) == "table" and #values == #record.force and table.move(values, first, last, 1, {}) or values
    end
    part.rows, part.restarts, part.specimen = last - first + 1, nil, record.specimen and ("%s.%d"):format(record.specimen, k) or tostring(k)
    out[k] = part
  end
  return out
end

-- The cell of a line of headings without brackets around it, and what stands in brackets behind its words.
local function head_of(cell)
  local name, unit = cell:match "^(.-)%s*[%(%[<{]([^%(%[<{]*)[%)%]>}]$"
  if not name then return cell, "" end
  if name == "" then return unit, unit end
  return name, unit
end

-- Of three lines of headings and more, the names are those of the line in which most columns are known, the units those of the line with most units of them.
local function relabel(vocabulary, file)
  local lines = file[1] and file[1].heads and #file[1].heads or 0
  local best, names = 0, nil
  for line = 1, lines do
    local known = 0
    for _, column in ipairs(file) do
      if quantity_of(vocabulary, (head_of(column.heads[line]))) then known = known + 1 end
    end
    if known > best then best, names = known, line end
  end
  if best < 2 then return end
  local most, units = 0, nil
  for line = 1, lines do
    local known = 0
    for _, column in ipairs(file) do
      local quantity = quantity_of(vocabulary, (head_of(column.heads[names])))
      local word, unit = head_of(column.heads[line])
      if line == names then word = unit end
      if quantity and unit_of(vocabulary, quantity, word) then known = known + 1 end
    end
    if known > most then most, units = known, line end
  end
  for _, column in ipairs(file) do
    local word, unit = head_of(column.heads[names])
    column.name, column.unit, column.bare = word, unit, nil
    if units and units ~= names and unit == "" then column.unit = (head_of(column.heads[units])) end
  end
end

-- Whether a table has the columns of a pull.
local function is_pull(vocabulary, t, file)
  local columns = t.columns or {}
  local function has(quantity) return columns[quantity] ~= nil or #candidates(vocabulary, file, quantity) > 0 end
  return has "force" and (has "displacement" or has "strain")
end

-- Whether a table of several is a record: three rows with what a pull needs.
local function is_record(vocabulary, t, file) return #file[1].values >= 3 and is_pull(vocabulary, t, file) end

-- The tables that are records; the others are reported.
local function records_among(vocabulary, t, files)
  if #files == 1 then return files end
  local out = lists.collect(files, function(file) if is_record(vocabulary, t, file) then return file end end)
  if #out == 0 then return { files[1] } end
  for _, file in ipairs(files) do
    if not is_record(vocabulary, t, file) then
      fabric.warn(("read: %s:%d: the table that begins here is no record of a force and a displacement, and is left out"):format(file.name, file.lines[1]))
    end
  end
  return out
end

-- A record, or a list of them if the file has several specimens.
local function read(t)
  check_names(t)
  local vocabulary = vocabulary_of(t)
  check_defaults(vocabulary, t)
  local tables = fabric.table { file = t.file, separator = t.separator, decimal = t.decimal, thousands = t.thousands, lenient = true, blocks = true }
  local function column_of(file, quantity) return find_column(vocabulary, t, file, quantity, false) end
  for _, file in ipairs(tables) do
    if not is_pull(vocabulary, {}, file) then relabel(vocabulary, file) end
    for _, column in ipairs(file) do
      split_unit(vocabulary, column)
      if quantity_of(vocabulary, column.bare or column.name) == "time" then specimens().clock(column) end
    end
  end
  local files, records = records_among(vocabulary, t, specimens().of(t, tables, column_of, function(file) return is_pull(vocabulary, t, file) end)), {}
  for i, file in ipairs(files) do
    if #files > 1 then file.specimen = file.specimen or tostring(i) end
    local record = record_of(vocabulary, t, file)
    local parts = record.restarts and t.restarts == "specimens" and parted(record) or { record }
    for _, one in ipairs(#parts > 1 and parts or {}) do
      one.warnings = nil
      for _, sign in ipairs(doubts.of(one)) do tell(t, one, sign) end
    end
    table.move(parts, 1, #parts, #records + 1, records)
  end
  if #records == 1 then return records[1] end
  records.file = t.file
  return records
end

define {
  name = "fabric.lab.read",
  arguments = {
    { name = "file", kind = "text", sentence = "of the load frame: CSV, TSV or the like, or a spreadsheet (.xlsx)" },
    { name = "columns", kind = "table", optional = true,
      sentence = "{displacement=, force=, time=, strain=}: heading or place of the column, false: no time, no strain; default: known by the heading" },
    { name = "units", kind = "table", optional = true, sentence = "{displacement='mm', force='N'}; default: those of the headings" },
    { name = "default_units", kind = "table", optional = true, sentence = "the same, for columns whose heading says none" },
    { name = "gauge_length", kind = "number", unit = "m", above = 0, optional = true, sentence = "for a record of strains: the displacement follows" },
    { name = "width", kind = "number", unit = "m", above = 0, optional = true, sentence = "for a record of forces per width: the force follows" },
    { name = "vocabulary", kind = "table|text", optional = true,
      sentence = "words of your frame: {force={'siua'}, displacement={...}, time=, strain=, units={force={dyn=1e-5}}}, or a Lua file that returns them" },
    { name = "separator", kind = "text", choices = { "auto", ",", ";", "tab", "blank" }, default = "auto", sentence = "between cells" },
    { name = "decimal", kind = "text", choices = { "auto", ".", "," }, default = "auto", sentence = "decimal sign" },
    { name = "thousands", kind = "text", choices = { "auto", ".", ",", "none" }, default = "auto",
      sentence = "sign between thousands; auto: where it cannot be the decimal sign; none: no sign stands there" },
    { name = "reverse", kind = "text", choices = { "none", "both", "displacement", "force" }, default = "none", sentence = "whose sign is changed, for a frame that counts a pull negative" },
    { name = "restarts", kind = "text", choices = { "tell", "specimens", "cycles" }, default = "tell",
      sentence = "where displacement and force leap back to their beginning. tell: a warning, read as one specimen; specimens: another begins there; cycles: one specimen whose way back was not recorded" },
  },
  sentence = "A load frame's record in SI: displacement, force, and time and strain where there are such columns that can be read; "
    .. "rows, names, preamble, file, lines (of the file, of each row), left_out (lines below the rows), specimen where the file names it, warnings (each {code, text, row}: reversed, restart, "
    .. "extensometer, drift, strain-unit, signs; or nil). A file "
    .. "with several specimens (headings that occur again, below or side by side, a column that names the specimen, sheets of a spreadsheet) gives a list of records.",
  example = "local path = os.tmpname()\n"
    .. "local f = io.open(path, 'w') f:write 'Extension (mm),Load (kN)\\n0,0\\n2,0.001\\n' f:close()\n"
    .. "local r = require 'fabric'.lab.read{ file=path }\nos.remove(path)\n"
    .. "assert(r.displacement[2] == 0.002 and r.force[2] == 1)",
  run = read,
}
