-- The tables of a file as specimens: a column that names the specimen parts its rows; headings that occur again in the same line stand above specimens side by
-- side; a heading that occurs again below, or another sheet of a spreadsheet, begins another specimen, unless the time goes on, as frames write that repeat
-- the heading above each block.
local house = require "fabric.lab.record.words"
local fabric = require "fabric"
local lists = require "fabric.lists"
local specimens = {}

-- Seconds of a time as minutes and seconds (3:07.5) or hours, minutes and seconds; nil of anything else.
local function seconds(word)
  local whole, last = word:match "^(%d+:?%d*):(%d+[.,]?%d*)$"
  if not whole then return end
  local hours, minutes = whole:match "^(%d+):(%d+)$"
  local s = tonumber((last:gsub(",", ".")))
  if s >= 60 or hours and tonumber(minutes) >= 60 then return end
  return 3600 * (tonumber(hours) or 0) + 60 * tonumber(minutes or whole) + s
end

-- A column of times as clocks show them becomes one of seconds.
function specimens.clock(column)
  local out = {}
  for i, word in ipairs(column.words or {}) do
    out[i] = seconds(word)
    if not out[i] then return end
  end
  if #out == 0 then return end
  column.values, column.words, column.trouble, column.unit = out, nil, nil, "s"
end

-- Whether the name of a column is that of the specimens: "Specimen", "Sample no.", "Probe Nr".
local function names_specimens(name)
  local found = false
  for word in house.plain(name):gmatch "[^%s_%-:]+" do
    word = word:gsub("%.$", "")
    local known = false
    for _, list in ipairs { house.specimens, house.tests } do
      for _, own in ipairs(list) do known = known or word == own end
    end
    if not known and not house.beside_specimen[word] then return false end
    found = found or known
  end
  return found
end

-- The rows of a table as one of its own, with all columns or those at `places`.
local function part(file, rows, places)
  local out, columns = {}, file
  for key, value in pairs(file) do
    if type(key) ~= "number" then out[key] = value end
  end
  if places then
    columns = {}
    for i, place in ipairs(places) do columns[i] = file[place] end
  end
  for i, column in ipairs(columns) do
    out[i] = {}
    for key, value in pairs(column) do out[i][key] = value end
    out[i].values, out[i].words = {}, column.words and {}
    for k, row in ipairs(rows) do
      out[i].values[k] = column.values[row]
      if column.words then out[i].words[k] = column.words[row] end
    end
    -- a bad cell in the rows of another specimen is none of this one's
    local bad = false
    for _, value in ipairs(out[i].values) do bad = bad or value ~= value end
    if not bad then out[i].trouble, out[i].words = nil, nil end
  end
  out.lines = {}
  for k, row in ipairs(rows) do out.lines[k] = file.lines[row] end
  return out
end

local function label_of(value) return type(value) == "number" and ("%.14g"):format(value) or value end

-- A specimen for each value of the column that names them; fewer than three rows are none.
local function by_column(t, file)
  for _, column in ipairs(file.header and file or {}) do
    if names_specimens(column.name) then
      local cells, order, rows = column.words or column.values, {}, {}
      for row, cell in ipairs(cells) do
        local key = label_of(cell)
        if not rows[key] then rows[key], order[#order + 1] = {}, key end
        table.insert(rows[key], row)
      end
      if #order > 1 and #order * 2 <= #cells then
        local out = {}
        for _, key in ipairs(order) do
          if #rows[key] < 3 then
            fabric.warn(("read: %s:%d: specimen '%s' has %d row%s, which is no record, and is left out"):format(file.name, file.lines[rows[key][1]], key,
              #rows[key], #rows[key] == 1 and "" or "s"))
          else
            out[#out + 1] = part(file, rows[key])
            out[#out].specimen = key
          end
        end
        return out
      elseif #order == 1 then
        file.specimen = order[1]
      elseif #order > 1 then
        fabric.warn(("read: %s: column '%s' has %d different values in %d rows and is not taken for the names of specimens"):format(file.name, column.name,
          #order, #cells))
      end
      return { file }
    end
  end
  return { file }
end

-- A specimen's own name in "Specimen A7" or "Probe: 3"; nil in other words.
local function named_in(words)
  local word, rest = house.plain(words):match "^([^%s:;,%d_]+)[%s:;,_#%.]*(.-)[%s;,]*$"
  for _, own in ipairs(house.specimens) do
    if word == own and rest ~= "" and #rest < 40 then return words:match "^[^%s:;,%d_]+[%s:;,_#%.]*(.-)[%s;,]*$" end
  end
end

-- The line above a heading that names the specimen: "Specimen 2", "Probe: A3".
local function named_above(file)
  for i = #file.preamble, 1, -1 do
    local name = named_in((file.preamble[i]:gsub('["\']', "")))
    if name then return name end
  end
end

-- --- side by side

-- A heading without the number of a specimen at its end: "Load 2", "Load_2", "Load.2", "Load (2)", "Load [2]".
local function stem(column) return (house.plain(column.bare or column.name):gsub("[%s_%.%-#]*[%(%[]?%d+[%)%]]?$", "")) end

-- Places of the columns that all specimens share and of those of each, where headings occur again in the same order; nil if they do not.
local function groups_of(file)
  local places = lists.collect(file, function(column, i) if column.name ~= "" then return i end end)
  for shared = 0, 1 do
    local own = #places - shared
    for size = 2, own // 2 do
      local same = own % size == 0
      for k = shared + 1, #places - size do same = same and stem(file[places[k]]) == stem(file[places[k + size]]) end
      if same then
        local groups = {}
        for first = shared + 1, #places, size do
          groups[#groups + 1] = table.move(places, first, first + size - 1, shared + 1, table.move(places, 1, shared, 1, {}))
        end
        return groups, shared
      end
    end
  end
end

-- The cells of a line above a heading, which ends with as many signs between cells as there are columns, or with the last name.
local function cells_of(line, sign)
  local cells = {}
  for cell in (line .. sign):gmatch("(.-)" .. sign) do cells[#cells + 1] = cell:gsub('"', ""):match "^%s*(.-)%s*$" end
  return cells
end

-- Names of specimens in a line above the headings: a cell above the first column of each, with nothing or the same beside it.
local function names_above(file, groups, shared)
  for i = #file.preamble, 1, -1 do
    for _, sign in ipairs { "\t", ";", "," } do
      local cells, names, seen = cells_of(file.preamble[i], sign), {}, {}
      for k, group in ipairs(groups) do
        local cell, beside = cells[group[shared + 1]], cells[group[shared + 2]] or ""
        if not cell or cell == "" or seen[cell] or beside ~= "" and beside ~= cell then break end
        names[k], seen[cell] = named_in(cell) or cell, true
      end
      if #names == #groups then return names end
    end
  end
end

-- A table for each specimen of those that stand side by side, each to its own end; is_pull(table) says whether one can be a record.
local function by_place(file, is_pull)
  local groups, shared = groups_of(file)
  if not groups or not is_pull(part(file, {}, groups[1])) then return { file } end
  local names, out = names_above(file, groups, shared), {}
  for k, group in ipairs(groups) do
    local last = 0
    for i = shared + 1, #group do
      local column = file[group[i]]
      for row = #column.values, last + 1, -1 do
        if column.values[row] == column.values[row] or column.words and column.words[row] ~= "" then last = row break end
      end
    end
    local rows = lists.of(last, function(row) return row end)
    out[k] = part(file, rows, group)
    out[k].specimen = names and names[k] or tostring(k)
  end
  return out
end

-- A table for each run of rows behind a blank line at which the time, or else the displacement, begins anew.
local function by_gap(file, along)
  local v = along and not along.trouble and along.values or {}
  local starts, low, high = { 1 }, v[1], v[1]
  for row = 2, #v do
    if file.lines[row] > file.lines[row - 1] + 1 and v[row - 1] - v[row] > 0.25 * (high - low) and v[row] - v[1] <= 0.05 * (high - low) then starts[#starts + 1] = row end
    low, high = math.min(low, v[row]), math.max(high, v[row])
  end
  if #starts == 1 then return { file } end
  local out = {}
  for k, first in ipairs(starts) do
    local rows = {}
    for row = first, (starts[k + 1] or #v + 1) - 1 do rows[#rows + 1] = row end
    out[k] = part(file, rows)
  end
  return out
end

local function append(file, more)
  for i, column in ipairs(file) do
    local other = more[i]
    if column.words or other.words then
      column.words = column.words or table.move(column.values, 1, #column.values, 1, {})
      table.move(other.words or other.values, 1, #other.values, #column.words + 1, column.words)
    end
    column.trouble = column.trouble or other.trouble
    table.move(other.values, 1, #other.values, #column.values + 1, column.values)
  end
  table.move(more.lines, 1, #more.lines, #file.lines + 1, file.lines)
  table.move(more.left_out, 1, #more.left_out, #file.left_out + 1, file.left_out)
end

-- Whether a table continues the one before: the same headings, and a time that goes on.
local function goes_on(before, file, time_of)
  if before.sheet ~= file.sheet or #before ~= #file then return false end
  for i, column in ipairs(file) do
    if column.name ~= before[i].name or column.unit ~= before[i].unit then return false end
  end
  local one, other = time_of(before), time_of(file)
  return one and other and not one.trouble and not other.trouble and one.values[#one.values] <= other.values[1]
end

-- The tables of a file, one for each specimen, with `specimen` where something names it. column_of(table, quantity) gives the column of a quantity,
-- is_pull(table) says whether the columns are those of a record.
function specimens.of(t, tables, column_of, is_pull)
  local function time_of(file) return column_of(file, "time") end
  local joined = {}
  for _, file in ipairs(tables) do
    local before = joined[#joined]
    if before and goes_on(before, file, time_of) then append(before, file) else joined[#joined + 1] = file end
  end
  local out = {}
  for _, file in ipairs(joined) do
    local chosen = t.columns and (t.columns.displacement or t.columns.force or t.columns.strain)
    local parted = not chosen and file.header and by_place(file, is_pull) or { file }
    if #parted == 1 then parted = by_gap(file, time_of(file) or column_of(file, "displacement")) end
    for _, one in ipairs(#parted > 1 and parted or by_column(t, file)) do
      local above = not one.specimen and named_above(one)
      one.specimen = one.specimen or above or nil
      if #joined > 1 and one.sheet and not above then one.specimen = one.specimen and one.sheet .. " " .. one.specimen or one.sheet end
      out[#out + 1] = one
    end
  end
  return out
end

return specimens
