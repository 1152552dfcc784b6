-- fabric.lab.tensile: evaluates the file of a tensile test: stress and strain, branches, yield and failure.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local check = require "fabric.lab.common.check"
local doubts = require "fabric.lab.record.doubts"
local outliers = require "fabric.lab.record.outliers"
local lists = require "fabric.lists"
local fail, largest = define.fail, doubts.largest_row

local function record_of(t)
  if t.file and t.record then fail "tensile: expected either file or record, got both" end
  if t.record then
    for _, one in ipairs(type(t.record[1]) == "table" and t.record or { t.record }) do
      if type(one) ~= "table" then fail("tensile: field 'record': expected a list of records, got in it a " .. type(one)) end
      local n, m = check.numbers("tensile", "record.displacement", one.displacement), check.numbers("tensile", "record.force", one.force)
      if n ~= m or n == 0 then
        fail(("tensile: field 'record': expected displacement and force of one length, got %d and %d numbers"):format(n, m))
      end
    end
    return t.record
  end
  if not t.file then fail "tensile: field 'file': expected a file (or record: a table of displacement and force), got nil" end
  return fabric.lab.read { file = t.file, columns = t.columns, units = t.units, default_units = t.default_units,
    vocabulary = t.vocabulary, gauge_length = t.gauge_length, width = t.width, thousands = t.thousands, reverse = t.reverse, restarts = t.restarts }
end

-- Says something worth knowing of a record, and keeps it with the result: test.warnings, each {code, text, row}.
local function warn(test, record, t, sign)
  local from = t.file and t.file .. ": " or ""
  if record.specimen then from = ("%sspecimen %s: "):format(from, record.specimen) end
  test.warnings[#test.warnings + 1] = sign
  fabric.warn(("tensile: %s%s"):format(from, sign.text))
end

-- A rupture is permanent: the last rows of the loading are below the share of the peak that defines failure. If the force recovers,
-- it was a wrong reading, or slip in the grips.
local last_rows = 5
local function stays_down(S, kept)
  local tail, peak = {}, 0
  for _, s in ipairs(S) do peak = math.max(peak, s) end
  for i = math.max(1, #S - last_rows + 1), #S do tail[#tail + 1] = S[i] end
  table.sort(tail)
  return (tail[(#tail + 1) // 2] or 0) < kept * peak
end

-- Yield and failure are searched on the virgin loading of all cycles together.
local function mark(test, t)
  local rows, E, S = {}, {}, {}
  for _, branch in ipairs(test.branches) do
    if branch.kind == "loading" then
      for i = branch.first, branch.last do rows[#rows + 1], E[#E + 1], S[#S + 1] = i, test.E[i], test.S[i] end
    end
  end
  test.loading = { first = rows[1], last = rows[#rows] }
  local marks = kernels.marks { E = E, S = S, kept = t.kept }
  test.failure, test.yield = stays_down(S, t.kept) and rows[marks.failure] or nil, rows[marks.yield]
end

-- The record without isolated wrong forces; and their rows.
local function without_outliers(record, t)
  local bad = t.outliers ~= "keep" and outliers.find(record.force) or {}
  if #bad == 0 then return record, bad end
  local out, is_bad, n = {}, {}, #record.force
  for _, row in ipairs(bad) do is_bad[row] = true end
  for name, values in pairs(record) do
    out[name] = values
    if type(values) == "table" and #values == n then
      out[name] = {}
      for row, value in ipairs(values) do
        if not is_bad[row] then table.insert(out[name], value) end
      end
    end
  end
  if t.outliers == "drop" then return out, bad end
  local first = bad[1]
  return out, bad, { code = "outliers", row = first,
    text = ("%d of %d readings of the force are outliers and are left out (place %d: %.4g N between %.4g and %.4g); outliers='keep' leaves them in"):format(#bad, n,
      first, record.force[first], record.force[first - 1], record.force[first + 1]) }
end

-- A pull moves, and its force changes.
local function check_moves(record, t)
  for _, name in ipairs { "displacement", "force" } do
    local values = record[name]
    local low, high = math.huge, -math.huge
    for _, v in ipairs(values) do low, high = math.min(low, v), math.max(high, v) end
    if high == low then
      fail(("tensile: %s%s stays at %.4g %s%s: expected the rows of a pull"):format(t.file and t.file .. ": " or "", name, low, name == "force" and "N" or "m",
        #values == 1 and " in the only row" or (" in all %d rows"):format(#values)))
    end
  end
end

-- Tension must be positive and start at zero.
local function check_record(record, t, test)
  for _, name in ipairs { "displacement", "force" } do
    local values = record[name]
    local low, high = math.huge, -math.huge
    for _, v in ipairs(values) do low, high = math.min(low, v), math.max(high, v) end
    local unit = name == "force" and "N" or "m"
    local from = t.file and (t.file .. ": ") or ""
    if high <= 0 or -low > 2 * high then
      fail(("tensile: %s%s runs from %.4g to %.4g %s: a pull counts positive; %s"):format(from, name, low, high, unit,
        name == "displacement" and values[#values] > values[1] and "zero=true counts it from the beginning" or ("change the sign of the record (reverse='%s')"):format(name)))
    end
    local first = values[1]
    local meant = name == "force" and t.pretension and math.abs(first) <= t.pretension
    if not meant and math.abs(first) > 0.02 * (high - low) then
      warn(test, record, t, { code = name == "force" and "preload" or "origin", row = 1,
        text = ("%s begins at %.4g %s, of a range of %.4g: take it off with zero=true?"):format(name, first, unit, high - low) })
    end
  end
end

-- Subtracts the first row from the record.
local function zeroed(record)
  local out = lists.copy(record)
  for _, name in ipairs { "displacement", "force" } do
    out[name] = {}
    for i, v in ipairs(record[name]) do out[name][i] = v - record[name][1] end
  end
  return out
end

-- Marks where the specimen broke, as it was seen: at a jaw within the distance of the standards.
local near_jaw = require "fabric.lab.record.breaking_standards"["ISO 13934-1"].near_jaw
local function mark_break(test, record, t, warnings, from_jaw)
  if not from_jaw then return end
  if not test.failure then fail "tensile: field 'from_jaw': expected a record that shows a break, this one does not fall below `kept` of its largest force and stay there" end
  test.from_jaw, test.jaw = from_jaw, from_jaw <= near_jaw + 1e-9
  if test.jaw then
    warn(warnings, record, t, { code = "jaw", row = test.failure, text = ("the specimen broke %.3g mm from a jaw: a break at the jaw, which says little of the cloth"):format(1e3 * from_jaw) })
  end
end

-- Doubts about the record from when it was read, or about a record of the deck's own; the row behind which its displacement says nothing.
local function doubt(record, t, warnings)
  local found = record.warnings or {}
  if not record.lines then found = doubts.of(record, t.restarts) end
  for _, one in ipairs(found) do
    if one.code == "reversed" then fail(("tensile: %s%s"):format(t.file and t.file .. ": " or "", one.text)) end
    if record.lines then table.insert(warnings.warnings, one) else warn(warnings, record, t, one) end
  end
  return doubts.end_of(found)
end

local function test_of(record, t, from_jaw)
  local warnings = { warnings = {} }
  if t.zero then record = zeroed(record) end
  check_moves(record, t)
  local ends = doubt(record, t, warnings)
  check_record(record, t, warnings)
  if ends then record = doubts.cut(record, ends) end
  local bad, sign
  record, bad, sign = without_outliers(record, t)
  if sign then warn(warnings, record, t, sign) end
  local top = largest(record.force)
  local test = fabric.lab.reduce {
    displacement = record.displacement, force = record.force, gauge_length = t.gauge_length, width = t.width,
    thickness = t.thickness, plies = t.plies, compliance = t.compliance, slip = t.slip,
    slack = type(t.slack) == "number" and t.slack or nil,
    contact = t.slack == "contact" and (t.contact or 0.01 * record.force[top]) or nil,
  }
  test.contact_found, test.compliance, test.slip = t.slack == "contact" or nil, t.compliance, t.slip
  test.force, test.time, test.file, test.specimen = record.force, record.time, record.file, record.specimen
  test.extensometer, test.beyond = ends, record.beyond
  local reach = record.displacement[largest(record.displacement)]
  test.branches = fabric.lab.branches { displacement = record.displacement, tolerance = t.tolerance or 0.01 * reach }
  mark(test, t)
  mark_break(test, record, t, warnings, from_jaw)
  if record.strain then test.measured_strain = record.strain end
  if #bad > 0 then test.outliers = bad end
  for _, found in ipairs(require "fabric.lab.record.signs".of(record.displacement, record.force, test.failure or top, t)) do warn(warnings, record, t, found) end
  if #warnings.warnings > 0 then test.warnings = warnings.warnings end
  return test
end

-- A copy with the signs changed: the deck's own record stays as it is.
local function reversed(record, which)
  local out = {}
  for name, values in pairs(record) do out[name] = type(values) == "table" and table.move(values, 1, #values, 1, {}) or values end
  out.lines, out.warnings = nil, nil
  return doubts.reverse(out, which)
end

-- A test, or a list of them for a file with several specimens.
local function tensile(t)
  local record = record_of(t)
  local single, given = type(record[1]) ~= "table", t.from_jaw
  local from = type(given) == "table" and given or { given }
  if given and #from ~= (single and 1 or #record) then
    fail(("tensile: field 'from_jaw': expected a distance for each specimen, %d, got %d"):format(single and 1 or #record, #from))
  end
  if t.record and t.reverse ~= "none" then
    local turned = lists.map(single and { record } or record, function(one) return reversed(one, t.reverse) end)
    record = single and turned[1] or turned
  end
  if single then return test_of(record, t, from[1]) end
  return lists.map(record, function(one, i) return test_of(one, t, from[i]) end)
end

define {
  name = "fabric.lab.tensile",
  arguments = {
    { name = "file", kind = "text", optional = true, sentence = "of the load frame" },
    { name = "record", kind = "table", optional = true, sentence = "{displacement=, force=} in SI, or a list of such, instead of a file" },
    { name = "columns", kind = "table", optional = true, sentence = "as in fabric.lab.read" },
    { name = "units", kind = "table", optional = true, sentence = "as in fabric.lab.read" },
    { name = "default_units", kind = "table", optional = true, sentence = "as in fabric.lab.read" },
    { name = "vocabulary", kind = "table|text", optional = true, sentence = "as in fabric.lab.read" },
    { name = "thousands", kind = "text", choices = { "auto", ".", ",", "none" }, default = "auto", sentence = "as in fabric.lab.read" },
    { name = "reverse", kind = "text", choices = { "none", "both", "displacement", "force" }, default = "none", sentence = "as in fabric.lab.read" },
    { name = "restarts", kind = "text", choices = { "tell", "specimens", "cycles" }, default = "tell", sentence = "as in fabric.lab.read; a record of the deck's own stays one specimen" },
    { name = "gauge_length", kind = "number", unit = "m", above = 0, sentence = "between the grips" },
    { name = "width", kind = "number", unit = "m", above = 0, sentence = "of the specimen" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "of one ply" },
    { name = "plies", kind = "integer", low = 1, sentence = "layers that bear load: 1, or 2 for a sewn loop on two pins" },
    { name = "compliance", kind = "number", unit = "m/N", low = 0, default = 0, sentence = "of frame and load cell" },
    { name = "slip", kind = "number", unit = "m/N", low = 0, default = 0, sentence = "in the grips, over the largest force so far" },
    { name = "zero", kind = "boolean", default = false, sentence = "displacement and force of the first row are taken off: a crosshead's position, an offset of the load cell" },
    { name = "pretension", kind = "number", unit = "N", above = 0, optional = true,
      sentence = "the pretension of a standard: a record may begin with a force up to this" },
    { name = "slack", kind = "number|text", unit = "m", choices = { "none", "contact" }, default = "none",
      sentence = "displacement at first contact, or 'contact': found where the force rises above `contact`" },
    { name = "contact", kind = "number", unit = "N", above = 0, optional = true, sentence = "default 1 % of the largest force" },
    { name = "tolerance", kind = "number", unit = "m", above = 0, optional = true,
      sentence = "smallest way back that is a reversal; default 1 % of the largest displacement" },
    { name = "kept", kind = "number", above = 0, high = 1, default = 0.8, sentence = "failed below this part of the peak, if the force stays there" },
    { name = "from_jaw", kind = "number|numbers", unit = "m", low = 0, optional = true,
      sentence = "where the specimen broke: distance from the nearer jaw, a number for each specimen; within 5 mm it is a break at the jaw" },
    { name = "outliers", kind = "text", choices = { "tell", "drop", "keep" }, default = "tell",
      sentence = "single outlying readings of the force (a display that drops a digit). tell: left out with a warning; drop: left out silently; keep: kept" },
  },
  retired = { "softening" },
  sentence = "A pull as stress and strain (eqs. 3.1, 3.2): E, S, displacement, force, time, branches (kind, first, last), loading "
    .. "(first and last row of virgin loading), yield and failure (rows or nil, on the virgin loading of all cycles), slack, area, outliers (places in the "
    .. "record of what was left out, or nil), warnings (preload, slip in the jaws, a late grip, a break at the jaw, and what fabric.lab.read tells: each {code, text, row}; or nil), "
    .. "extensometer (the row at which it was taken off: the lists end there, and beyond={force, time} has all rows; or nil), "
    .. "from_jaw and jaw (whether it broke at one). A file with several specimens "
    .. "gives a list of tests, each with its specimen.",
  example = "local t = require 'fabric'.lab.tensile{ record={ displacement={0, 1e-3, 2e-3, 1e-3, 0}, force={0, 2, 5, 1, 0} },\n"
    .. "  gauge_length=0.0762, width=0.0254, thickness=0.38e-3, plies=2 }\n"
    .. "assert(t.branches[2].kind == 'unloading' and t.loading.last == 3 and not t.failure)",
  run = tensile,
}

define {
  name = "fabric.lab.density",
  arguments = {
    { name = "mass", kind = "numbers", unit = "kg", above = 0, sentence = "of each weighed piece" },
    { name = "area", kind = "number", unit = "m^2", above = 0, sentence = "of a piece" },
    { name = "thickness", kind = "numbers", unit = "m", above = 0, sentence = "measured" },
  },
  sentence = "Mass per area, thickness (means) and density = mass per area over thickness [williams2010, section 3.3.1].",
  example = "local d = require 'fabric'.lab.density{ mass={2.3e-3}, area=0.01, thickness={0.38e-3} }\n"
    .. "assert(math.abs(d.density - 605.26) < 0.01 and math.abs(d.mass_per_area - 0.23) < 1e-12)",
  run = function(t)
    local per_area, thickness = lists.mean(t.mass) / t.area, lists.mean(t.thickness)
    return { mass_per_area = per_area, thickness = thickness, density = per_area / thickness }
  end,
}
