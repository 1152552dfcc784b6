-- fabric.lab.breaking_strength: the table of a folder of pulls to rupture, as ISO 13934-1 or ASTM D5035 ask for it.
local fabric = require "fabric"
local define = require "fabric.define"
local check = require "fabric.lab.common.check"
local largest_row = require("fabric.lab.record.doubts").largest_row
local rows_of = require "fabric.lab.record.breaking_table"
local lists = require "fabric.lists"
local standards = require "fabric.lab.record.breaking_standards"
local fail = define.fail

local function stop(words) fail("breaking_strength: " .. words) end

-- Says something of a specimen, a group or the folder, and keeps it in result.warnings.
local function tell(result, code, words, specimen)
  result.warnings[#result.warnings + 1] = { code = code, text = words, specimen = specimen }
  fabric.warn("breaking_strength: " .. words)
end

-- --- the files ---

local kinds = { csv = true, tsv = true, txt = true, dat = true, xlsx = true }

-- The group of a file is its name without the number at the end: "warp" of warp-3.csv; and whether there is such a number.
local function group_of(stem)
  local group, digits = stem:match "^(.-)[%s_%-]*(%d+)$"
  if not digits then return stem, false end
  return group ~= "" and group or "all", true
end

-- The files of the folder that may be records.
local function files_of(t)
  local out, breaks, table_file = {}, type(t.breaks) == "string" and t.breaks:match "[^/]*$", t.file and t.file:match "[^/]*$"
  for _, name in ipairs(fabric.folder(t.folder)) do
    local stem, kind = name:match "^(.+)%.(%w+)$"
    if kind and kinds[kind:lower()] and name ~= breaks and name ~= table_file and not stem:find "%-markers$" and not stem:find "%-frames$" then
      out[#out + 1] = { name = name, stem = stem }
    end
  end
  if #out == 0 then stop(("field 'folder': %s: expected files of pulls, such as warp-1.csv, got none"):format(t.folder)) end
  return out
end

-- The records of a file; nil for one without a number in its name that is no record.
local function records_of(t, result, file, numbered)
  local ok, found = pcall(fabric.lab.read, { file = t.folder .. "/" .. file.name, columns = t.columns, units = t.units, default_units = t.default_units,
    vocabulary = t.vocabulary, thousands = t.thousands, reverse = t.reverse, restarts = t.restarts, gauge_length = t.gauge_length, width = t.width })
  if not ok then
    local words = tostring(found):gsub("^.-: read: ", "")
    if numbered then stop(words) end
    tell(result, "left-out", ("%s is left out, since it is no record (%s)"):format(file.name, words))
    return {}
  end
  return #found > 0 and found or { found }
end

-- --- one specimen ---

-- The last row before the force falls below `kept` of the largest and stays there; nil if it does not, or falls because the jaws come back.
local back = 0.01 -- of the way to the largest force
local function break_row(u, F, top, kept)
  local row = #F
  while row > top and F[row] < kept * F[top] do row = row - 1 end
  return row < #F and u[row + 1] >= u[top] - back * (u[top] - u[1]) and row or nil
end

-- The displacement at which the force first reaches the pretension.
local function start_of(u, F, pretension)
  if not pretension or F[1] >= pretension then return u[1] end
  for i = 2, #F do
    if F[i] >= pretension then return u[i - 1] + (u[i] - u[i - 1]) * (pretension - F[i - 1]) / (F[i] - F[i - 1]) end
  end
  return u[1]
end

-- Speed of the jaws on the way to the largest force, m/s; nil without a time.
local function speed_of(test, top)
  if not test.time then return end
  local list = {}
  for i = 2, top do
    local dt = test.time[i] - test.time[i - 1]
    if dt > 0 then list[#list + 1] = (test.displacement[i] - test.displacement[i - 1]) / dt end
  end
  return #list > 2 and lists.median(list) or nil
end

-- The record with its beginning taken off: the crosshead's position, and an offset of the load cell unless that is the pretension.
local function from_zero(t, record)
  if not t.zero then return record end
  local out = { displacement = {}, force = record.force, time = record.time, specimen = record.specimen, lines = record.lines, warnings = record.warnings }
  for i, u in ipairs(record.displacement) do out.displacement[i] = u - record.displacement[1] end
  if t.pretension then return out end
  out.force = {}
  for i, F in ipairs(record.force) do out.force[i] = F - record.force[1] end
  return out
end

-- A specimen whose extensometer was taken off before the largest force, which is known, while the elongation there is not.
local function without_elongation(t, test, name)
  local F = test.beyond.force
  local top, row = largest_row(F), #F
  while row > top and F[row] < t.kept * F[top] do row = row - 1 end
  return { name = name, force = F[top], broken = row < #F, speed = speed_of(test, #test.force), warnings = test.warnings or {} }
end

-- A specimen {name, force, elongation, elongation_at_break?, speed?, warnings}. Slack mounting lengthens the specimen by the way to the pretension.
local function specimen_of(t, record, name)
  record = from_zero(t, record)
  -- stress is not asked for: any thickness will do
  local ok, test = pcall(fabric.lab.tensile, { record = record, gauge_length = t.gauge_length, width = t.width, thickness = 1e-3, plies = 1, pretension = t.pretension, outliers = t.outliers })
  if not ok then stop(name .. ": " .. tostring(test):gsub("^.-tensile: ", "")) end
  local u, F = test.displacement, test.force
  if test.extensometer then return without_elongation(t, test, name) end
  local top = largest_row(F)
  local start = start_of(u, F, t.pretension)
  local slack = t.pretension and start - u[1] or 0
  local function elongation(row) return (u[row] - start) / (t.gauge_length + slack) end
  local last = break_row(u, F, top, t.kept)
  return { name = name, force = F[top], elongation = elongation(top), elongation_at_break = last and elongation(last), broken = last ~= nil, speed = speed_of(test, top),
    warnings = test.warnings or {} }
end

-- All specimens of the folder, by group, in the order of the folder.
local function specimens_of(t, result)
  local names, groups = {}, {}
  for _, file in ipairs(files_of(t)) do
    local group, numbered = group_of(file.stem)
    local records = records_of(t, result, file, numbered)
    for _, record in ipairs(records) do
      if not groups[group] then names[#names + 1], groups[group] = group, { specimens = {}, notes = {} } end
      local name = #records > 1 and ("%s:%s"):format(file.stem, record.specimen) or file.stem
      table.insert(groups[group].specimens, specimen_of(t, record, name))
    end
  end
  if #names == 0 then stop(("field 'folder': %s: expected records of pulls, got none"):format(t.folder)) end
  return names, groups
end

-- --- what is said of single specimens ---

-- The lines of a file of two columns as pairs of words; a comma, a semicolon or a tab between them.
local function pairs_in(path)
  local file, trouble = io.open(path)
  if not file then stop(("field 'breaks': %s"):format(trouble)) end
  local out = {}
  for line in file:lines() do
    local name, value = line:gsub("\r$", ""):match '^%s*"?([^,;\t"]-)"?%s*[,;\t]%s*"?(.-)"?[%s;]*$'
    if name then out[#out + 1] = { name, value } end
  end
  file:close()
  return out
end

-- Distances of the breaks from the nearer jaw in a file of two columns: the specimen, and a length or 'jaw'.
local function breaks_in(path)
  local lines, out = pairs_in(path), {}
  local heading = lines[1] and lines[1][2] or ""
  local unit = require("fabric.lab.record.words").units.displacement[heading:match "[%(%[]%s*(%a+)%s*[%)%]]$"]
  if not unit then stop(("field 'breaks': %s:1: expected a heading of two columns with a unit of length, as 'specimen,distance (mm)', got '%s'"):format(path, heading)) end
  for i = 2, #lines do
    local name, value = table.unpack(lines[i])
    local way = tonumber((value:gsub(",", ".")))
    if value ~= "" then out[name] = way and way * unit or value end
  end
  return out
end

-- Checks that each name is that of a specimen.
local function check_named(field, list, known)
  for _, name in ipairs(lists.keys(list)) do
    if not known[name] then
      local near = define.registry.nearest(tostring(name), lists.keys(known))
      stop(("field '%s': there is no specimen '%s'%s"):format(field, name, near and (", did you mean '" .. near .. "'?") or ""))
    end
  end
end

local function check_breaks(breaks)
  for _, name in ipairs(lists.keys(breaks)) do
    local way = breaks[name]
    if way ~= "jaw" and not (type(way) == "number" and way >= 0 and way < 2) then
      stop(("field 'breaks.%s': expected the distance from the jaw in m, or 'jaw', got %s"):format(name, type(way) == "string" and "'" .. way .. "'" or tostring(way)))
    end
  end
end

-- Adds from_jaw, jaw and faulty to the specimens.
local function mark(t, standard, result)
  local known = {}
  for _, group in pairs(result.groups) do
    for _, s in ipairs(group.specimens) do known[s.name] = s end
  end
  local breaks = type(t.breaks) == "string" and breaks_in(t.breaks) or t.breaks or {}
  check_named("breaks", breaks, known)
  check_breaks(breaks)
  check_named("faulty", t.faulty or {}, known)
  for name, way in pairs(breaks) do
    known[name].from_jaw, known[name].jaw = way, way == "jaw" or way <= standard.near_jaw + 1e-9
  end
  for name, why in pairs(t.faulty or {}) do known[name].faulty = tostring(why) end
  if not t.breaks then tell(result, "breaks", "where the specimens broke is in no record, so no break at a jaw is known: breaks={ ['warp-1']=3*mm } names the distances") end
end

-- --- a group ---

-- Signs of slip and of the grips in the record of a specimen, in short.
local function seen_in(standard, s)
  local out = {}
  for _, w in ipairs(s.warnings) do
    local beyond = w.way and standard.slip and w.way > standard.slip + 1e-9
    out[#out + 1] = w.code == "slip" and ("slip by %.2g mm at most%s, or yarns that broke one by one"):format(1e3 * w.way, beyond and ", beyond 2 mm" or "")
      or w.code == "late-grip" and "gripped late, or slack" or w.code == "outliers" and "outlying readings left out" or w.code == "preload" and "force at the beginning"
      or w.code == "extensometer" and "extensometer taken off, no elongation" or w.code == "restart" and "begins anew: another specimen?" or w.code
  end
  return table.concat(out, "; ")
end

local function joined(...)
  local out = lists.collect({ ... }, function(words) if words ~= "" then return words end end)
  return table.concat(out, "; ")
end

-- Mean, standard deviation, coefficient of variation and the interval of the mean by Student's t; of one value the mean alone.
local function statistics(list, level)
  local n, sum, squares = #list, 0, 0
  for _, v in ipairs(list) do sum = sum + v end
  local mean = sum / n
  for _, v in ipairs(list) do squares = squares + (v - mean) ^ 2 end
  if n < 2 then return { n = n, mean = mean } end
  local deviation = math.sqrt(squares / (n - 1))
  local half = fabric.lab.student(0.5 + level / 2, n - 1) * deviation / math.sqrt(n)
  return { n = n, mean = mean, deviation = deviation, cv = deviation / mean, low = mean - half, high = mean + half }
end

-- Which specimens count, with the reason for each that does not.
local function choose(t, standard, result, group)
  local breaks, why, remarks = {}, {}, {}
  for i, s in ipairs(group.specimens) do
    if s.faulty then
      why[i] = "left out as faulty: " .. s.faulty
    elseif not s.broken and not t.cut_at_break then
      why[i] = "left out: the record shows no break"
    else
      breaks[#breaks + 1] = { force = s.force, jaw = s.jaw, place = i }
    end
  end
  local left_out, has_mean, reason = standard.left_out(breaks)
  for k, b in ipairs(breaks) do
    if left_out[k] then why[b.place] = "break at the jaw, left out: " .. left_out[k] elseif b.jaw then remarks[b.place] = "break at the jaw, counts" end
  end
  for i, s in ipairs(group.specimens) do
    s.counted = not why[i]
    s.remark = joined(why[i] or remarks[i] or "", s.broken and "" or why[i] and "" or "the record ends at the break", seen_in(standard, s))
    if not s.broken and not s.faulty and not t.cut_at_break then
      tell(result, "unbroken", ("%s: the record ends without a fall below %g of the largest force, so nothing says that the specimen broke; cut_at_break=true counts records that end there"):format(s.name,
        t.kept), s.name)
    end
  end
  return has_mean, reason
end

local function evaluate(t, standard, result, name, group)
  local has_mean, reason = choose(t, standard, result, group)
  local values = { force = {}, elongation = {}, elongation_at_break = {} }
  local speeds = {}
  for _, s in ipairs(group.specimens) do
    for field, list in pairs(values) do
      if s.counted and s[field] then list[#list + 1] = s[field] end
    end
    if s.counted then speeds[#speeds + 1] = s.speed end
  end
  group.name, group.counted = name, #values.force
  if not has_mean and group.counted > 0 then group.notes[#group.notes + 1] = reason end
  if has_mean and group.counted > 0 then
    for field, list in pairs(values) do group[field] = #list > 0 and statistics(list, t.level) or nil end
    group.per_width = group.force.mean / t.width
  end
  local wanted = name:lower():find "we?ft" and standard.specimens_weft or name:lower():find "fill" and standard.specimens_weft or standard.specimens
  if group.counted < wanted then group.notes[#group.notes + 1] = ("the standard asks for %d specimens, %d count"):format(wanted, group.counted) end
  local elongation = group.elongation and group.elongation.mean or 0
  for _, departure in ipairs(standard.departures(t.width, t.gauge_length, elongation, #speeds > 0 and lists.median(speeds) or nil)) do
    group.notes[#group.notes + 1] = "the standard asks for " .. departure
  end
  for _, note in ipairs(group.notes) do tell(result, "standard", name .. ": " .. note) end
end

local function run(t)
  local standard = standards[t.standard]
  check.lengths("breaking_strength", t)
  t.folder = t.folder:gsub("/$", "")
  local result = { standard = t.standard, warnings = {} }
  result.names, result.groups = specimens_of(t, result)
  mark(t, standard, result)
  for _, name in ipairs(result.names) do evaluate(t, standard, result, name, result.groups[name]) end
  result.text = rows_of.text(standard, result)
  if t.file then
    fabric.write(t.file, rows_of.csv(result))
    result.file = t.file
  end
  return result
end

define {
  name = "fabric.lab.breaking_strength",
  arguments = {
    { name = "folder", kind = "text", sentence = "of records of pulls to rupture; specimens whose names differ by the number at the end (warp-1.csv, warp-2.csv) are a group, and so are those in one file" },
    { name = "standard", kind = "text", choices = { "ISO 13934-1", "ASTM D5035" }, default = "ISO 13934-1", sentence = "which says what counts" },
    { name = "gauge_length", kind = "number", unit = "m", above = 0, sentence = "between the jaws" },
    { name = "width", kind = "number", unit = "m", above = 0, sentence = "of the strips" },
    { name = "pretension", kind = "number", unit = "N", above = 0, optional = true, sentence = "elongations count from where the force first reaches it, and slack up to there lengthens the specimen; default: from the first row" },
    { name = "breaks", kind = "table|text", optional = true,
      sentence = "{ ['warp-2']=3e-3, ['warp-4']='jaw' }: distance of the break from the nearer jaw, m; or a table in a file: specimen, distance (mm). Within 5 mm it is a break at the jaw" },
    { name = "faulty", kind = "table", optional = true, sentence = "{ ['warp-3']='slipped' }: specimens to leave out, and why" },
    { name = "cut_at_break", kind = "boolean", default = false, sentence = "the machine ends its record at the break: one that ends near its largest force is of a specimen that broke" },
    { name = "kept", kind = "number", above = 0, high = 1, default = 0.8, sentence = "broken: the force falls below this part of the largest and stays there" },
    { name = "level", kind = "number", above = 0, high = 0.999, default = 0.95, sentence = "of confidence of the interval of the mean" },
    { name = "zero", kind = "boolean", default = false, sentence = "the displacement of the first row is taken off, and its force unless there is a pretension" },
    { name = "outliers", kind = "text", choices = { "tell", "drop", "keep" }, default = "tell", sentence = "as in fabric.lab.tensile" },
    { name = "columns", kind = "table", optional = true, sentence = "as in fabric.lab.read" },
    { name = "units", kind = "table", optional = true, sentence = "as in fabric.lab.read" },
    { name = "default_units", kind = "table", optional = true, sentence = "as in fabric.lab.read" },
    { name = "vocabulary", kind = "table|text", optional = true, sentence = "as in fabric.lab.read" },
    { name = "thousands", kind = "text", choices = { "auto", ".", ",", "none" }, default = "auto", sentence = "as in fabric.lab.read" },
    { name = "reverse", kind = "text", choices = { "none", "both", "displacement", "force" }, default = "none", sentence = "as in fabric.lab.read" },
    { name = "restarts", kind = "text", choices = { "tell", "specimens", "cycles" }, default = "tell", sentence = "as in fabric.lab.read" },
    { name = "file", kind = "text", optional = true, sentence = "the table as CSV" },
  },
  sentence = "The table of a folder of pulls to rupture after ISO 13934-1 or ASTM D5035. Returns names (of the groups), groups { name={ specimens={ {name, force, elongation, "
    .. "elongation_at_break, from_jaw, jaw, counted, remark, warnings}, ... }, counted, force, elongation and elongation_at_break (each n, mean, deviation, cv, low, high: the interval of "
    .. "the mean), per_width (N/m), notes } }, text (the table), warnings {code, text, specimen}, file. Elongations are numbers, not per cent.",
  example = "local folder, names = os.tmpname(), {}\nos.remove(folder)\n"
    .. "for k, last in ipairs{ 4, 5, 6, 5, 5 } do\n  local lines = { 'Extension (mm),Load (N)' }\n"
    .. "  for i = 0, 10 * last do lines[#lines + 1] = ('%g,%g'):format(i, 2 * i) end\n"
    .. "  lines[#lines + 1] = ('%d,0'):format(10 * last + 1)\n  names[k] = ('%s/warp-%d.csv'):format(folder, k)\n  fabric.write(names[k], table.concat(lines, '\\n') .. '\\n')\nend\n"
    .. "local r = fabric.lab.breaking_strength{ folder=folder, gauge_length=0.2, width=0.05, breaks={} }\n"
    .. "assert(math.abs(r.groups.warp.force.mean - 100) < 1e-9 and math.abs(r.groups.warp.force.deviation^2 - 200) < 1e-9)\n"
    .. "for _, name in ipairs(names) do os.remove(name) end\nos.remove(folder)",
  run = run,
}
