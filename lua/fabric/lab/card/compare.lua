-- fabric.lab.compare: a measured curve compared with that of a test, point by point.
local fabric = require "fabric"
local define = require "fabric.define"
local check = require "fabric.lab.common.check"
local curve = require "fabric.lab.common.curve"
local peaks = require "fabric.lab.common.peaks"
local windowed = require "fabric.window"
local lists = require "fabric.lists"
local fail = define.fail

local labels = { E = "Green-Lagrange strain E", E12 = "shear strain E12", E12_centre = "shear strain E12", displacement = "displacement", S = "second Piola-Kirchhoff stress",
  S12 = "S12", force = "force" }
local units = { displacement = "mm", S = "MPa", S12 = "MPa", force = "N" }

-- The lists of a measured table up to failure; only virgin loading, if its branches identify the rows.
local function measured_lists(t, xname, yname)
  local x, y = t.measured[xname], t.measured[yname]
  if type(x) ~= "table" or type(y) ~= "table" or #x ~= #y or #x < 2 then
    fail(("compare: field 'measured': expected lists %s and %s of one length (a result of fabric.lab.tensile, or a record)"):format(xname, yname))
  end
  check.numbers("compare", "measured." .. xname, x)
  check.numbers("compare", "measured." .. yname, y)
  if t.all or type(t.measured.branches) ~= "table" then return x, y end
  check.test("compare", 1, { E = x, S = y, branches = t.measured.branches, failure = t.measured.failure }, "measured")
  local out_x, out_y, stop = {}, {}, t.measured.failure or #x
  for _, branch in ipairs(t.measured.branches) do
    if branch.kind == "loading" then
      for i = branch.first, math.min(branch.last, stop) do out_x[#out_x + 1], out_y[#out_y + 1] = x[i], y[i] end
    end
  end
  if #out_x == 0 then fail "compare: field 'measured.branches': expected rows of loading (or give all=true), there are none" end
  return out_x, out_y
end

-- Times of the rows of a test's curve, which increase.
local function times_of(rows)
  local times = {}
  for i, row in ipairs(rows) do
    times[i] = tonumber(row.time)
    if not times[i] or (i > 1 and not (times[i] > times[i - 1])) then
      fail(("compare: field 'window': expected a test whose curve has times that increase, row %d has %s"):format(i, tostring(row.time)))
    end
  end
  return times
end

-- The lists of a test: from the rows of its curve, or given as lists like the measured ones.
local function test_lists(t, xname, yname)
  local rows = t.test.curve or t.test
  if type(rows) == "table" and type(rows[1]) == "table" then
    local x, y = {}, {}
    for i, row in ipairs(rows) do
      x[i], y[i] = tonumber(row[xname]), tonumber(row[yname])
      if not x[i] or not y[i] then
        fail(("compare: field 'test': expected %s and %s in each row of the curve, row %d has none"):format(xname, yname, i))
      end
    end
    check.numbers("compare", "test." .. xname, x)
    check.numbers("compare", "test." .. yname, y)
    return x, t.window and windowed(times_of(rows), y, t.window) or y
  end
  if t.window then fail "compare: field 'window': expected a result of a test, whose curve has times, got lists" end
  local x, y = type(rows) == "table" and rows[xname], type(rows) == "table" and rows[yname]
  if type(x) ~= "table" or type(y) ~= "table" or #x ~= #y then
    fail(("compare: field 'test': expected a result of a test with a curve, or lists %s and %s of one length"):format(xname, yname))
  end
  check.numbers("compare", "test." .. xname, x)
  check.numbers("compare", "test." .. yname, y)
  if #x < 2 then fail(("compare: field 'test.%s': expected two points or more, got %d"):format(xname, #x)) end
  return x, y
end

-- The pair of columns to compare: as given, or the first pair that both have.
local pairs_of_columns = { { "E", "S" }, { "displacement", "force" } }
local function columns_of(t)
  if t.x or t.y then
    if not (t.x and t.y) then fail "compare: field 'y': expected both x and y, or neither" end
    return t.x, t.y
  end
  local rows = t.test.curve or t.test
  local first = type(rows) == "table" and (type(rows[1]) == "table" and rows[1] or rows) or {}
  for _, pair in ipairs(pairs_of_columns) do
    if t.measured[pair[1]] and t.measured[pair[2]] and first[pair[1]] and first[pair[2]] then return pair[1], pair[2] end
  end
  fail "compare: field 'measured': expected lists E and S, or displacement and force, as the test has them"
end

local function from_slack(t, xname, x, y)
  if t.slack == 0 then return x, y end
  local out_x, out_y = {}, {}
  for i = 1, #x do
    if xname == "E" then
      out_x[i], out_y[i] = curve.from_contact(x[i], y[i], 1 + t.slack)
    else
      out_x[i], out_y[i] = x[i] - t.slack, y[i]
    end
  end
  return out_x, out_y
end

-- The slack of the measured curve itself, from a polynomial that finds its first contact (fabric.lab.backbone). A slack fitted to the test
-- would make a soft specimen pass for a slack one. A displacement is scaled to so small a strain that stretch and shift are equal.
local small = 1e-3
local function found_slack(xname, x, y)
  local ex, ey = curve.envelope(x, y)
  if #ex < 6 or not (ex[#ex] > 0) then fail(("compare: field 'slack': expected at least 6 rising points to find it, got %d: give a number"):format(#ex)) end
  local scale = xname == "E" and 1 or small / math.max(math.abs(ex[1]), math.abs(ex[#ex]))
  local found = fabric.lab.backbone { curves = { { E = lists.scaled(ex, scale), S = ey } }, find_slack = true }
  if not found.chosen then fail "compare: field 'slack': no first contact is found in this curve (no polynomial rises from zero): give a number" end
  return math.max(0, found[found.chosen].specimens[1].slack) / scale
end

-- The band of the next specimen: its limits for the figure, and the share of the compared points within it.
local function band_of(t, out)
  local band = t.spread
  if not band then return {} end
  local inside, n = 0, 0
  for i, x in ipairs(out.x) do
    local low, high = curve.interpolate(band.E, band.next_low, x), curve.interpolate(band.E, band.next_high, x)
    if low then
      n = n + 1
      if low <= out.measured[i] and out.measured[i] <= high then inside = inside + 1 end
    end
  end
  if n == 0 then fail "compare: field 'spread': expected a band where there are measured points" end
  out.inside = inside / n
  out.text = out.text .. ("; %.0f %% of the points lie in the band of the next specimen"):format(100 * out.inside)
  return { { x = band.E, band = { low = band.next_low, high = band.next_high }, colour = "grey",
    label = ("%g %% of the next specimens"):format(100 * band.level) } }
end

-- A tear goes up and down with each yarn, and the next specimen does so elsewhere: its mean and that of its peaks, as the test's standard takes them,
-- are what can be compared.
local function tears_of(t, out, x, y)
  if not (t.test.by and t.test.peaks) then return end
  local rows = lists.of(#x, function(i) return { displacement = x[i], force = y[i] } end)
  local high = peaks.of(rows, t.test.rise)
  out.tear = { measured = { mean = peaks.mean_force(x, y), mean_of_peaks = peaks[t.test.by](high), peaks = #high },
    simulated = { mean = t.test.mean, mean_of_peaks = t.test.mean_of_peaks, peaks = #t.test.peaks } }
  local m, s = out.tear.measured, out.tear.simulated
  local function number(v) return v and ("%.4g N"):format(v) or "none" end
  out.text = ("mean force measured %s, simulated %s; mean of peaks %s (%d), %s (%d); point by point: %s"):format(number(m.mean), number(s.mean), number(m.mean_of_peaks), m.peaks,
    number(s.mean_of_peaks), s.peaks, out.text)
end

local function draw(t, xname, yname, x, y, tx, ty, edges)
  local file = t.measured.file
  local name = t.label or type(file) == "string" and file:match "[^/]*$" or nil
  local curves = { { x = x, y = y, label = name and name .. ", measured" or "measured", style = "points" }, { x = tx, y = ty, label = "simulated" } }
  table.move(edges, 1, #edges, 3, curves)
  fabric.plot { file = t.file, title = t.title, xlabel = labels[xname] or xname, xunit = units[xname],
    ylabel = labels[yname] or yname, yunit = units[yname], curves = curves }
end

local function check_spread(t, xname, yname)
  if not t.spread then return end
  if xname ~= "E" or yname ~= "S" then fail(("compare: field 'spread': a band of S over E, got %s over %s to compare"):format(yname, xname)) end
  for _, name in ipairs { "E", "next_low", "next_high" } do
    if type(t.spread[name]) ~= "table" then fail "compare: field 'spread': expected a result of fabric.lab.spread" end
    if check.numbers("compare", "spread." .. name, t.spread[name]) ~= #t.spread.E then fail "compare: field 'spread': expected E, next_low and next_high of one length" end
  end
end

local function compare(measured, test, options)
  local t = { measured = measured, test = test }
  for name, value in pairs(options or {}) do t[name] = value end
  t.slack = t.slack or 0
  local xname, yname = columns_of(t)
  check_spread(t, xname, yname)
  local x, y = measured_lists(t, xname, yname)
  local tx, ty = test_lists(t, xname, yname)
  local ex, ey = curve.envelope(tx, ty)
  if t.slack == "find" then t.slack = found_slack(xname, x, y) end
  x, y = from_slack(t, xname, x, y)
  local out = { x = {}, measured = {}, simulated = {}, residual = {}, outside = 0, columns = { xname, yname }, slack = t.slack }
  local peak, squares = 0, 0
  for _, value in ipairs(y) do peak = math.max(peak, math.abs(value)) end
  if peak == 0 then fail(("compare: field 'measured.%s': expected values that are not all zero"):format(yname)) end
  for i = 1, #x do
    local model = curve.interpolate(ex, ey, x[i])
    if model then
      local n = #out.x + 1
      out.x[n], out.measured[n], out.simulated[n], out.residual[n] = x[i], y[i], model, y[i] - model
      squares = squares + out.residual[n] ^ 2
      if not out.largest or math.abs(out.residual[n]) > math.abs(out.largest.residual) then out.largest = { x = x[i], residual = out.residual[n] } end
    else
      out.outside = out.outside + 1
    end
  end
  if #out.x == 0 then
    fail(("compare: expected measured points within the test's %s, %.4g to %.4g; they lie at %.4g to %.4g"):format(xname, ex[1], ex[#ex],
      math.min(x[1], x[#x]), math.max(x[1], x[#x])))
  end
  out.peak, out.rms = peak, math.sqrt(squares / #out.x) / peak
  out.worst = math.abs(out.largest.residual) / peak
  out.text = ("%d points, %d outside of the test; measured less simulated: rms %.2f %%, largest %.2f %% of the peak (%s %.4g)"):format(#out.x, out.outside,
    100 * out.rms, 100 * out.worst, xname, out.largest.x)
  tears_of(t, out, x, y)
  local edges = band_of(t, out)
  if t.file then draw(t, xname, yname, x, y, tx, ty, edges) end
  return out
end

define {
  name = "fabric.lab.compare",
  positional = true,
  arguments = {
    { name = "measured", kind = "table", sentence = "result of fabric.lab.tensile or shear_from_bias, or a record with lists of the columns" },
    { name = "test", kind = "table", sentence = "result of a virtual test (fabric.lab.uniaxial and so on), its curve, or lists likewise" },
    { name = "options", kind = "fields", optional = true, sentence = "what is compared, and the file of the figure", rows = {
      { name = "x", kind = "text", optional = true, sentence = "column of both; default E, else displacement" },
      { name = "y", kind = "text", optional = true, sentence = "column of both; default S, else force" },
      { name = "slack", kind = "number|text", choices = { "find" }, optional = true,
        sentence = "of first contact: a stretch as in fit.specimens[i].slack where x is E, else of the unit of x; default 0; find: where a "
          .. "polynomial through the measured curve meets zero" },
      { name = "spread", kind = "table", optional = true, sentence = "result of fabric.lab.spread: the band of the next specimen is drawn, and `inside` "
        .. "says what part of the points lies in it" },
      { name = "all", kind = "boolean", optional = true, sentence = "unloading too; default: virgin loading up to failure" },
      { name = "file", kind = "text", optional = true, sentence = "of the figure with both curves: .svg, .pdf, .eps or .png" },
      { name = "label", kind = "text", optional = true, sentence = "of what was measured, in the key; default: the name of its file" },
      { name = "title", kind = "text", optional = true, sentence = "of the figure" },
      { name = "window", kind = "number", unit = "s", above = 0, optional = true,
        sentence = "each point of the test is the mean over so long a time about it: where friction or contact chatters from step to step" },
    } },
  },
  sentence = "A measured curve beside a test's: x, measured, simulated (between the test's points in virgin loading), residual = measured less "
    .. "simulated; rms and worst as parts of the measured peak, largest {x, residual}, outside (points beyond the test), slack, inside, text. For a result of fabric.lab.tear also tear = { measured=, simulated= }, each with "
    .. "mean (N, after the first quarter of the record), mean_of_peaks (N, as the test's standard takes it) and peaks (their number).",
  example = "local lab = require 'fabric'.lab\n"
    .. "local c = lab.compare({ displacement={0, 1, 2}, force={0, 1.1, 2} }, { displacement={0, 2}, force={0, 2} })\n"
    .. "assert(#c.x == 3 and math.abs(c.worst - 0.05) < 1e-12 and c.largest.x == 1)",
  run = compare,
}
