-- A folder of measurements, reduced to fits and a card. It contains laboratory.lua, which returns
--
--   { name=, source=, gauge_length=, width=, thickness=, plies=, density= | mass_per_area=, markers={rows, columns},
--     compliance=, slip=, shared= (relative uncertainty of all moduli together), units={...}, columns={...}, thousands=".", reverse="both", restarts="specimens" (as in fabric.lab.read), default_units={...} (where
--     a heading says none), vocabulary= (a table, or the file in this folder that returns it), degree=, rule=,
--     bias={width=, length=, yarns="inextensible"} (of bias specimens without markers, if their size differs; their yarns' stretch is left in), zero= (subtract the first row),
--     poisson={warp=, weft=}, assume={['warp.unloading']=, ...} (instead of the rules of fabric.lab.card),
--     bending={warp=, weft=, twist=} (N.m), or cantilevers={warp={...}, weft={...}, bias={...}} (bending lengths, m, of each strip; those at 45 degrees tell the twist),
--     viscous=true (bias tests at several speeds or with holds, whose records have seconds: the part of shear that relaxes),
--     loops=true (a card whose yarns unload along curves, where the records show it: fabric.lab.loops),
--     grips="free"|"clamped" (for the simulation: ends that can contract, such as loops on pins, or jaws; default free) }
--
-- and files whose names give their meaning; K is the specimen (a file may hold several, as fabric.lab.read finds them):
--   warp-K.csv, weft-K.csv   a testing machine's record            warp-K-markers.csv   frame, marker, x, y
--   bias-K-frames.csv        displacement and force at each photograph, with bias-K-markers.csv
--   bias-K.csv               a bias test without markers (shear up to 30 degrees is computed from the displacement), as are frames without theirs;
--                            left out, with a warning, where other bias tests have markers
--
-- A card is made from whichever of these exist; what no test shows is assumed and marked as such (fabric.lab.card).
local fabric = require "fabric"
local define = require "fabric.define"
local lab, registry = fabric.lab, define.registry
local check = require "fabric.lab.common.check"
local doubts = require "fabric.lab.record.doubts"
local check_pull = require("fabric.lab.card.frames").check_pull
local tests_for = require "fabric.lab.card.tests_for"
local told_of_loops = require("fabric.lab.card.loops").ready

-- Raises an error at the line of the deck's call.
local function stop(words) define.fail("laboratory: " .. words) end

local folder = {}

-- Extensions of measurement files; other files in the folder (pictures, copies, notes) are ignored.
local kinds = { csv = true, tsv = true, txt = true, dat = true }

local function specimens(path, pattern)
  local found, by_key = {}, {}
  for _, name in ipairs(fabric.folder(path)) do
    local key, kind = name:match(pattern .. "%.(%a+)$")
    if key and kinds[kind:lower()] then
      if by_key[key] then stop(("%s: expected one file for specimen %s, got %s and %s"):format(path, key, by_key[key], name)) end
      by_key[key] = name
      found[#found + 1] = { key = key, file = path .. "/" .. name, stem = path .. "/" .. name:match "^(%a+%-%w+)" }
    end
  end
  return found
end

-- The contents of a folder without a file of the expected names.
local function instead(path)
  local others = {}
  for _, name in ipairs(fabric.folder(path)) do
    local kind = name:match "%.(%a+)$"
    if kind and kinds[kind:lower()] then others[#others + 1] = name end
  end
  if #others == 0 then return "there is none" end
  local more = #others > 3 and (" and %d more"):format(#others - 3) or ""
  return ("got %s%s: rename them by the direction of the pull"):format(table.concat(others, ", ", 1, math.min(3, #others)), more)
end

local function exists(path)
  local f = io.open(path)
  if f then f:close() end
  return f ~= nil
end

local function options(about, more)
  if not math.tointeger(about.plies) or about.plies < 1 then
    stop(("%s: field 'plies': expected 1 (a strip in two clamps) or 2 (a loop on two pins), got %s"):format(about.file, tostring(about.plies)))
  end
  local out = { gauge_length = about.gauge_length, width = about.width, thickness = about.thickness, plies = about.plies,
                compliance = about.compliance, slip = about.slip }
  for k, v in pairs(more) do out[k] = v end
  return out
end

local function grid_of(about, path)
  if type(about.markers) ~= "table" or not math.tointeger(about.markers[1]) or not math.tointeger(about.markers[2]) then
    stop(("%s: field 'markers': expected {rows, columns} of the grid, for %s"):format(about.file, path))
  end
  return lab.tracks { file = path, rows = about.markers[1], columns = about.markers[2] }
end

-- Adds the spread of the specimens, if there are enough of them.
local function with_spread(part)
  if #part.tests >= 3 then part.spread = lab.spread { tests = part.tests, fit = part.fit } end
  return part
end

-- The tensile tests in a direction; nil if there are none.
local function along(about, path, direction)
  local tests, grids = {}, {}
  for _, s in ipairs(specimens(path, "^" .. direction .. "%-(%w+)")) do
    local made = lab.tensile(options(about, { file = s.file, columns = about.columns, units = about.units, default_units = about.default_units,
      vocabulary = about.vocabulary, thousands = about.thousands, reverse = about.reverse, restarts = about.restarts, zero = about.zero }))
    local markers = s.stem .. "-markers.csv"
    if #made > 0 and exists(markers) then stop(("%s: expected one specimen, whose markers are in %s, got %d"):format(s.file, markers, #made)) end
    table.move(#made > 0 and made or { made }, 1, math.max(1, #made), #tests + 1, tests)
    if exists(markers) then grids[#grids + 1] = grid_of(about, markers) end
  end
  if #tests == 0 then return end
  local fit = lab.fit { tests = tests, find_slack = "either", common = about.shared, degree = about.degree, rule = about.rule }
  local ratio = #grids > 0 and lab.poisson { specimens = grids, common = about.shared } or about.poisson and about.poisson[direction]
  return with_spread { tests = tests, fit = fit, ratio = ratio, loops = told_of_loops(tests, fit) and lab.loops { tests = tests, fit = fit } or nil }
end

-- The numbers of the photographs that belong to the rows of a record; nil without a column `frame`.
local function frame_numbers(file)
  for _, column in ipairs(fabric.table { file = file, lenient = true }) do
    if column.name:lower():match "^%s*(%a+)" == "frame" then return column.values end
  end
end

-- Record and markers for the photographs in both, by their numbers; if the record has no numbers, row by row.
local function paired(record, grid, file)
  local numbers = frame_numbers(file)
  if not numbers then
    local last = grid.numbers[#grid.numbers]
    if #record.force ~= grid.frames or last - grid.numbers[1] ~= grid.frames - 1 then
      stop(("%s: expected a column 'frame', since its %d rows are not those of the %d photographs, numbers %g to %g, of %s"):format(file,
        #record.force, grid.frames, grid.numbers[1], last, grid.file))
    end
    return record, grid
  end
  local row_of, markers = {}, grid.rows * grid.columns
  for row, number in ipairs(numbers) do row_of[number] = row end
  if not row_of[grid.numbers[1]] then
    stop(("%s: expected a row for frame %g, the first of %s, from which the strain counts"):format(file, grid.numbers[1], grid.file))
  end
  local both = { displacement = {}, force = {}, time = record.time and {} or nil }
  local kept = { rows = grid.rows, columns = grid.columns, file = grid.file, frames = 0, numbers = {}, x = {}, y = {} }
  for f, number in ipairs(grid.numbers) do
    local row = row_of[number]
    if row then
      kept.frames = kept.frames + 1
      kept.numbers[kept.frames], both.displacement[kept.frames], both.force[kept.frames] = number, record.displacement[row], record.force[row]
      if both.time then both.time[kept.frames] = record.time[row] end
      for _, name in ipairs { "x", "y" } do table.move(grid[name], (f - 1) * markers + 1, f * markers, #kept[name] + 1, kept[name]) end
    end
  end
  return both, kept
end

-- The records of a file of bias pulls: strains and forces per width count for the specimen's size.
local function records_of(about, file, width, length)
  local found = lab.read { file = file, columns = about.columns, units = about.units, default_units = about.default_units, vocabulary = about.vocabulary,
    thousands = about.thousands, reverse = about.reverse, restarts = about.restarts, width = width, gauge_length = length }
  found = #found > 0 and found or { found }
  for i, record in ipairs(found) do
    local ends = doubts.end_of(record.warnings)
    if ends then found[i] = doubts.cut(record, ends) end
  end
  return found
end

-- The record of one bias pull, whose photographs are in other files.
local function record_of(about, file, width, length)
  local found = records_of(about, file, width, length)
  if #found > 1 then stop(("%s: expected one specimen, whose photographs have files of their own, got %d"):format(file, #found)) end
  return found[1]
end

-- The seconds of a record from which the part of shear that relaxes is to be found.
local function seconds_of(record, file)
  if not record.time then stop(file .. ": expected a column of the time, since laboratory.lua says viscous=true") end
  return record.time
end

-- Bias tests with markers, and those without.
local function bias_tests(path)
  local marked, plain = {}, specimens(path, "^bias%-(%w+)")
  for _, s in ipairs(specimens(path, "^bias%-(%w+)%-frames")) do table.insert(exists(s.stem .. "-markers.csv") and marked or plain, s) end
  if #marked > 0 then
    for _, s in ipairs(plain) do
      fabric.warn(("laboratory: %s has no markers and is left out, since other bias tests have them (%s)"):format(s.file, marked[1].file))
    end
  end
  return marked, plain
end

-- The rows of a record up to its largest displacement.
local function rows_up(record)
  local largest, rows = 1, {}
  for k, d in ipairs(record.displacement) do
    if d > record.displacement[largest] then largest = k end
  end
  for k = 1, largest do rows[k] = k end
  return rows
end

local function in_shear(about, marked)
  local tests = {}
  for i, s in ipairs(marked) do
    local record, grid = paired(record_of(about, s.file, about.width, about.gauge_length), grid_of(about, s.stem .. "-markers.csv"), s.file)
    check.pull("laboratory: " .. s.file, "force", record.force, rows_up(record))
    tests[i] = lab.shear_from_bias(options(about, { markers = grid, force = record.force, displacement = record.displacement, warp = about.warp }))
    tests[i].file, tests[i].warnings = s.file, record.warnings
    if about.viscous then
      tests[i].name, tests[i].time = s.file, {}
      for k, frame in ipairs(tests[i].frames) do tests[i].time[k] = seconds_of(record, s.file)[frame] end
    end
  end
  if #tests == 0 then return end
  return with_spread { tests = tests, fit = lab.fit { tests = tests, common = about.shared, rule = "robust" },
    viscous = about.viscous and lab.viscous { tests = tests } or nil }
end

local told_stretch = 0.02 -- of the stress at the end of a bias pull

-- The curve of a yarn, of whose stretch a pull without markers is freed.
local function yarn_of(part) return part and { loading = part.fit.loading, unloading = part.fit.unloading, tested = part.fit.tested, poisson = part.ratio } end

-- A bias test without markers, evaluated by the kinematics of inextensible yarns, the stretch of which is taken out where both were pulled; and the pull, for what relaxes.
local function without_markers(about, record, file, width, length, yarns)
  local pull = { displacement = record.displacement, force = record.force, width = width, length = length, limit = 30, cut = true }
  check_pull("laboratory: " .. file, "force", pull)
  pull.thickness = about.thickness * (about.plies or 1)
  if yarns then pull.warp, pull.weft = yarns.warp, yarns.weft end
  local shear = lab.bias_shear(pull)
  if shear.taken_out and shear.taken_out > told_stretch then
    fabric.warn(("laboratory: %s: the yarns stretch in the bias pull, by their own curves: without their stretch S12 is %.0f %% more at its end; bias={ yarns='inextensible' } leaves it in"):format(file,
      100 * shear.taken_out))
  end
  local test = { E = shear.E12, S = shear.S12, file = file, specimen = record.specimen, without_markers = true, warnings = record.warnings, taken_out = shear.taken_out,
    branches = { { kind = "loading", first = 1, last = #shear.E12 } } }
  return test, about.viscous and { name = file, displacement = record.displacement, force = record.force, time = seconds_of(record, file), width = width, length = length }
end

local function in_shear_without_markers(about, plain, warp, weft)
  local tests, pulls, size = {}, {}, about.bias or {}
  if size.yarns and size.yarns ~= "inextensible" then stop(("laboratory.lua: field 'bias.yarns': expected 'inextensible' or nothing, got '%s'"):format(tostring(size.yarns))) end
  local yarns = not size.yarns and (warp or weft) and { warp = yarn_of(warp or weft), weft = yarn_of(weft or warp) }
  for _, s in ipairs(plain) do
    local width, length = size.width or about.width, size.length or about.gauge_length
    for _, record in ipairs(records_of(about, s.file, width, length)) do
      tests[#tests + 1], pulls[#tests + 1] = without_markers(about, record, s.file, width, length, yarns)
    end
  end
  if #tests == 0 then return end
  return with_spread { tests = tests, fit = lab.fit { tests = tests, common = about.shared }, without_markers = true,
    viscous = about.viscous and lab.viscous { tests = pulls, thickness = about.thickness * (about.plies or 1) } or nil }
end

local fields = { "name", "source", "gauge_length", "width", "thickness", "plies", "density", "mass_per_area", "markers", "compliance", "slip", "shared",
  "units", "default_units", "columns", "vocabulary", "thousands", "reverse", "restarts", "degree", "rule", "grips", "poisson", "bending", "cantilevers", "warp", "bias", "zero", "assume", "viscous", "loops" }

-- The content of laboratory.lua, checked before any file is read.
local function about_of(path)
  local file = path .. "/laboratory.lua"
  local chunk, trouble = loadfile(file, "t")
  if not chunk then stop(trouble) end
  local about = chunk()
  if type(about) ~= "table" then stop(("%s: expected 'return { name=, gauge_length=, ... }' at its end, got %s"):format(file, tostring(about))) end
  for name in pairs(about) do
    local known = false
    for _, field in ipairs(fields) do known = known or field == name end
    local near = not known and registry.nearest(tostring(name), fields)
    if not known then stop(("%s: unknown field '%s'%s"):format(file, tostring(name), near and (", did you mean '" .. near .. "'?") or "")) end
  end
  local function need(name, kind, what)
    if type(about[name]) ~= kind then stop(("%s: field '%s': expected %s, got %s"):format(file, name, what, tostring(about[name]))) end
  end
  need("name", "string", "the fabric's name")
  for _, name in ipairs { "gauge_length", "width", "thickness" } do need(name, "number", "a length in m") end
  if about.default_units ~= nil then need("default_units", "table", "{displacement='mm', force='N'}") end
  if not about.density and not about.mass_per_area then stop(file .. ": field 'density': expected density (kg/m^3) or mass_per_area (kg/m^2)") end
  for _, name in ipairs { "viscous", "loops" } do
    if about[name] ~= nil and type(about[name]) ~= "boolean" then need(name, "boolean", "true or false") end
  end
  about.file = file
  -- A file of words may lie beside the records.
  if type(about.vocabulary) == "string" and exists(path .. "/" .. about.vocabulary) then about.vocabulary = path .. "/" .. about.vocabulary end
  return about
end

-- Further tests that would determine the assumed fields.
local function further_of(card)
  local out = {}
  for field, words in pairs(card.provenance or {}) do
    if words:find "^assumed" and tests_for[field] then out[#out + 1] = { field = field, now = words, test = tests_for[field] } end
  end
  if not card.bending then
    out[#out + 1] = { field = "bending", now = "not measured: the card bends as a solid sheet of its thickness, far too stiffly for folds",
      test = tests_for.bending }
  end
  table.sort(out, function(a, b) return a.field < b.field end)
  return out
end

-- Bending of what laboratory.lua says: rigidities as they are, or those of cantilevers with their band.
local function bending_of(about)
  local strips = about.cantilevers
  if not strips then return about.bending end
  local sign = about.file .. ": field 'cantilevers': "
  if about.bending then stop(sign .. "expected either bending or cantilevers, got both") end
  if type(strips) ~= "table" then stop(sign .. "expected { warp={...}, weft={...}, bias={...} }, bending lengths in m, got " .. tostring(strips)) end
  for name, list in pairs(strips) do
    if name ~= "warp" and name ~= "weft" and name ~= "bias" then stop(("%sexpected warp, weft and bias, got '%s'"):format(sign, tostring(name))) end
    for _, c in ipairs(type(list) == "table" and list or { list }) do
      if type(c) ~= "number" or not (c > 1e-3 and c < 0.5) then stop(("%sexpected bending lengths of %s in m, 0.001 to 0.5 (half of the overhang), got %s"):format(sign, name, tostring(c))) end
    end
  end
  if not strips.warp or not strips.weft then stop(sign .. "expected strips along warp and weft, got those along one alone") end
  return lab.twist { warp = strips.warp, weft = strips.weft, bias = strips.bias, common = about.shared, areal_mass = about.mass_per_area or about.density * about.thickness }
end

-- Remarks on single records, and specimens unlike the others, a line each.
local function seen_in(found)
  local out = {}
  for _, name in ipairs { "warp", "weft", "shear" } do
    local part = found[name] or { tests = {} }
    for i, test in ipairs(part.tests) do
      local who = ("%s: specimen %d (%s%s): "):format(name, i, (test.file or ""):match "[^/]*$", test.specimen and ", " .. test.specimen or "")
      for _, sign in ipairs(test.warnings or {}) do out[#out + 1] = who .. sign.text end
      for _, odd in ipairs(part.spread and part.spread.unlike or {}) do
        if odd.specimen == i then
          out[#out + 1] = who .. ("unlike the others: %.0f %% of their stress, where they differ by %.1f %%"):format(100 * odd.ratio, 100 * odd.deviation)
        end
      end
    end
  end
  return out
end

-- Requests of laboratory.lua that no file can meet, a line each; they are warnings too.
local function missed_of(about, found)
  local out = {}
  if about.loops and not (found.warp and found.warp.loops or found.weft and found.weft.loops) then
    out[1] = "loops=true, but no record of a yarn's pull comes back, so there is no loop"
  end
  if about.viscous and not found.shear then out[#out + 1] = "viscous=true, but there is no bias pull, so that relaxation cannot be determined" end
  for _, words in ipairs(out) do fabric.warn(("laboratory: %s: %s"):format(about.file, words)) end
  return out
end

-- Returns warp, weft, shear: {tests, fit, ratio, spread} for existing files; card; further: tests that would determine what is assumed; missed: what was
-- asked for and cannot be had; seen: lines on single specimens (slip, a late grip, preload, one unlike the others); about.
function folder.reduce(path)
  if type(path) ~= "string" then stop(("expected the name of a folder, got %s"):format(tostring(path))) end
  path = path:gsub("/$", "")
  local about = about_of(path)
  local marked, plain = bias_tests(path)
  local out = { about = about, warp = along(about, path, "warp"), weft = along(about, path, "weft") }
  out.shear = in_shear(about, marked) or in_shear_without_markers(about, plain, out.warp, out.weft)
  if not out.warp and not out.weft and not out.shear then
    stop(path .. ": expected files of pulls named warp-1.csv, weft-1.csv or bias-1.csv, " .. instead(path))
  end
  local viscous = out.shear and out.shear.viscous
  local function fit(name) return out[name] and out[name].fit end
  local function yarn(name) return about.loops and out[name] and out[name].loops or fit(name) end
  out.card = lab.card {
    name = about.name, source = about.source, thickness = about.thickness,
    density = about.density or about.mass_per_area / about.thickness,
    warp = yarn "warp", weft = yarn "weft", shear = viscous and viscous.viscous and viscous.shear or fit "shear",
    viscous = viscous, assume = about.assume or true,
    poisson = { warp = out.warp and out.warp.ratio, weft = out.weft and out.weft.ratio }, bending = bending_of(about),
  }
  out.further, out.missed = further_of(out.card), missed_of(about, out)
  out.seen = seen_in(out)
  return out
end

return folder
