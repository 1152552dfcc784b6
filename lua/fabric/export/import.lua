-- fabric.import.card: a card from another solver's material, with the same report of what is lost.
local fabric = require "fabric"
local define = require "fabric.define"
local units = require "fabric.export.units"
local curves = require "fabric.export.curves"
local laws = require "fabric.export.laws"
local loss = require "fabric.export.loss"
local sampled = require "fabric.export.sampled"
local read = require "fabric.export.read_deck"
local fail = define.fail

local kinds = {
  openradioss = { read = function(path, u) return read.law58(path, u, laws.value) end, measure = "nominal_degrees", law = laws.law58, name = "LAW58", ending = "rad" },
  law19 = { read = function(path, u) return require "fabric.export.read_more".law19(path, read.law19_block(path), u, read.columns) end, measure = "green", law = laws.law19, name = "LAW19" },
  ["ls-dyna"] = { read = function(path, u) return require "fabric.export.read_more".mat_034(path, u) end, measure = "green", law = laws.mat_034, name = "*MAT_034" },
  abaqus = { read = read.fabric, measure = "nominal_radians", law = laws.fabric, name = "*FABRIC", ending = "inp", shifted = true },
}

-- Points {E, S} of the loading curve in the card's measures, as far as the file has data. A file's law is straight between its points: of a
-- curve of few, there are more on those lines, since the card's curve is smooth.
local function points(back, part)
  local c, out = part.loading, { { 0, 0 } }
  local longest = #c.x < 40 and c.x[#c.x] / 200 or math.huge
  for i = 2, #c.x do
    local n = math.max(1, math.ceil((c.x[i] - c.x[i - 1]) / longest - 1e-9))
    for k = 1, n do
      local s = k / n
      local E, S = back(c.x[i - 1] + s * (c.x[i] - c.x[i - 1]), c.y[i - 1] + s * (c.y[i] - c.y[i - 1]))
      out[#out + 1] = { E, S }
    end
  end
  return out
end

-- The steepest tangent up to a strain of the smooth curve that a card lays through points. It is asked of a card that unloads more steeply than any
-- such curve can rise, whose stress in a first pull is that curve; its stresses are scaled to those of a usual cloth.
local function steepest(name, list, upto)
  local most, scaled = 0, {}
  for i = 2, #list do most = math.max(most, (list[i][2] - list[i - 1][2]) / (list[i][1] - list[i - 1][1])) end
  local usual = 1e7
  for i, p in ipairs(list) do scaled[i] = { p[1], p[2] * usual / most } end
  local function part(axis) return { loading = axis == name and scaled or { usual }, unloading = 10 * usual, poisson = axis ~= "shear" and 0 or nil } end
  local point = fabric.point(fabric.woven { name = name, density = 600, thickness = 1e-3, warp = part "warp", weft = part "weft", shear = part "shear",
    tested = { [name] = upto } })
  local slope, E0, S0 = 0, 0, 0
  for i = 2, #list do
    for k = 1, 8 do
      local E = list[i - 1][1] + (list[i][1] - list[i - 1][1]) * k / 8
      if E0 >= upto then return slope * most / usual end
      local S = name == "shear" and point:strain({ E12 = E }).S12 or point:uniaxial(name, E).S
      slope, E0, S0 = math.max(slope, (S - S0) / (E - E0)), E, S
    end
  end
  return slope * most / usual
end

-- The unloading curve of the file as points {E, S} in the card's measures, from the reversal down to `share` of its stress.
local function unloading_points(back, part, shifted, share)
  local c, top = part.unloading, part.meet
  local inverse = { x = c.y, y = c.x }
  local offset = shifted and top[1] - laws.value(inverse, top[2]) or 0
  local out, n = {}, 20
  for i = 0, n do
    local y = top[2] * (1 - (1 - share) * i / n)
    local E, S = back(i == 0 and top[1] or laws.value(inverse, y) + offset, y)
    out[i + 1] = { E, S }
  end
  return out
end

local function slope(list)
  local a, b = list[1], list[#list]
  return (a[2] - b[2]) / (a[1] - b[1])
end

-- How far a curve is from the straight line between its ends: largest difference of stress, as a share of the first.
local function sag(list)
  local most, G = 0, slope(list)
  for _, p in ipairs(list) do most = math.max(most, math.abs(p[2] - list[1][2] - G * (p[1] - list[1][1]))) end
  return most / list[1][2]
end

local straight = 0.03  -- of the stress at the reversal; up to this a curve counts as a straight line

-- The unloading modulus: of a straight curve between the reversal and a fifth of its stress below, of a curved one that of the line from the
-- reversal to (nearly) no stress, as long as it is steeper than `least`; nil for an elastic curve.
local function modulus(name, back, part, shifted, least, notes)
  if part.elastic then return end
  local begins, whole = slope(unloading_points(back, part, shifted, 0.8)), unloading_points(back, part, shifted, 0.02)
  local a, b = whole[#whole - 1], whole[#whole]
  whole[#whole + 1] = { b[1] - b[2] * (a[1] - b[1]) / (a[2] - b[2]), 0 } -- to zero stress in a straight line: the tail of a LAW58 curve runs nearly flat to zero strain
  local off = sag(whole)
  if off <= straight then return begins end
  local used = slope(whole) > least and slope(whole) or begins
  notes[#notes + 1] = ("%s: the file unloads along a curve, %.3g %% of its peak stress off the straight line from the reversal to zero stress; the card unloads along a straight "
    .. "line at %.4g MPa (the file's curve begins with %.4g MPa), and a stress-strain loop is lost%s"):format(name, 100 * off, used / 1e6, begins / 1e6,
    name == "shear" and "" or (": card:with{ %s={ loop={...} } gives one"):format(name))
  return used
end

-- A card's unloading modulus may not lie below any tangent of its loading; between the samples of that there may be a little more.
local margin = 1.05

-- The part of a card, and the strain up to which it was tested. wanted: its unloading modulus, instead of the file's; nil: not asked for.
local function part_of(name, from, kind, wanted, notes)
  local measure = curves.measures[kind.measure]
  local back = name == "shear" and measure.shear_back or measure.axis_back
  local list = points(back, from)
  local tested = back(from.meet[1], from.meet[2])
  local least = margin * steepest(name, list, tested)
  if wanted then
    if wanted < least / margin then
      fail(("card: field 'unloading.%s': expected at least the steepest slope of the loading, %.4g MPa, got %.4g MPa"):format(name, least / margin / 1e6, wanted / 1e6))
    end
    return { loading = list, unloading = wanted }, tested
  end
  local unloading = modulus(name, back, from, kind.shifted, least, notes)
  if not unloading then
    unloading = least
    notes[#notes + 1] = ("%s: the file unloads along its loading curve; the card's unloading modulus is 1.05 times the steepest slope, so some energy is lost that the file keeps; unloading={ %s=... } gives another"):format(name, name)
  elseif unloading < least then
    notes[#notes + 1] = ("%s: the unloading modulus of %.4g MPa is raised to 1.05 times the steepest slope of the loading, %.4g MPa, below which a card's may not lie; unloading={ %s=... } gives another")
      :format(name, unloading / 1e6, least / 1e6, name)
    unloading = least
  end
  return { loading = list, unloading = unloading }, tested
end

local components = { warp = "E11", weft = "E22", shear = "E12" }

-- The strain (Green-Lagrange, E12 in shear) up to which the curve counts as measured, and at which unloading begins; `said`: where it stands.
local function turn_at(part, name, E, kind, said)
  local measure = curves.measures[kind.measure]
  local x = (name == "shear" and measure.shear or measure.axis)(E, 0)
  local last = part.loading.x[#part.loading.x]
  if x > last * (1 + 1e-6) then
    local most = (name == "shear" and measure.shear_back or measure.axis_back)(last, 0)
    fail(("card: %s: expected a strain of the %s on the file's curve, which ends at %s = %.4g, got %.4g"):format(said, name, components[name], most, E))
  end
  part.meet = { x, laws.value(part.loading, x) }
end

-- The note for a part that the file's comment calls untested, although its unloading has to start somewhere.
local function not_tested(name, line, E)
  return ("%s: line %d of the file says that it was not tested; its curve was taken as measured up to %s = %.4g, where fabric.export starts its unloading")
    :format(name, line, components[name], E)
end

-- Unloading starts where the curves cross; a comment of the file that states another strain is noted.
local function crossed(part, name, kind, stated, line, notes)
  local measure = curves.measures[kind.measure]
  local E = (name == "shear" and measure.shear_back or measure.axis_back)(part.meet[1], part.meet[2])
  if stated == 0 then
    notes[#notes + 1] = not_tested(name, line, E)
  elseif math.abs(E / stated - 1) > 0.01 then
    notes[#notes + 1] = ("%s: line %d of the file says that it was tested up to %s = %.4g; its curves of loading and unloading cross at %.4g, which was taken; "
      .. "tested={ %s=... } gives another"):format(name, line, components[name], stated, E, name)
  end
end

-- Where the curves of the file do not show at which strain unloading starts: the strains asked for, else those that the file
-- states in a comment, else the curves' ends, which a note says.
local function turn_all(t, p, kind, notes)
  local stated, line = read.tested(t.file)
  local ended = {}
  for _, name in ipairs { "warp", "weft", "shear" } do
    local E, said = t.tested and t.tested[name] or 0, ("field 'tested.%s'"):format(name)
    if p[name].ended and E == 0 and stated then
      E, said = stated[name], ("%s:%d"):format(t.file, line)
      if E == 0 then
        E = sampled.untested[name]
        notes[#notes + 1] = not_tested(name, line, E)
      end
    elseif not p[name].ended and E == 0 and stated then
      crossed(p[name], name, kind, stated[name], line, notes)
    end
    if p[name].ended and E > 0 then turn_at(p[name], name, E, kind, said) elseif p[name].ended then ended[#ended + 1] = name end
  end
  if #ended > 0 then
    notes[#notes + 1] = ("tested: neither the file (in a comment 'Tested up to E11 = ...') nor tested= says up to which strains %s was measured; the ends of the curves were taken, "
      .. "and unloading starts there"):format(table.concat(ended, ", "))
  end
end

-- The units of the file: those asked for, or those that it states; both have to agree.
local function units_of(t, notes)
  local said, where, unclear = read.units(t.file)
  if not t.units then
    if unclear then
      fail(("card: field 'units': %s states units that were not understood (%s); expected such as 'Units: mm, t, s (mm-t-s)', or the field"):format(t.file, unclear))
    end
    if not said then notes[#notes + 1] = "units: the file states none (in a comment 'Units: ... (mm-t-s)', in /BEGIN or in a /UNIT/n that the material names); mm, t, s, N, MPa were taken, units= gives others" end
    return said or units.of "mm-t-s"
  end
  if said and said.name ~= t.units then
    fail(("card: field 'units': expected the units that %s states, '%s' (%s), got '%s'; without the field they are taken from there"):format(
      t.file, said.name, where, t.units))
  end
  return units.of(t.units)
end

-- The argument in [low, high] with the least value of a function that has one minimum there, by golden section.
local function least_of(f, low, high)
  local golden = (math.sqrt(5) - 1) / 2
  local a, b = high - golden * (high - low), low + golden * (high - low)
  local fa, fb = f(a), f(b)
  for _ = 1, 14 do
    if fa < fb then
      high, b, fb = b, a, fa
      a = high - golden * (high - low)
      fa = f(a)
    else
      low, a, fa = a, b, fb
      b = low + golden * (high - low)
      fb = f(b)
    end
  end
  return fa < fb and a or b
end

-- Poisson's ratios with which the card does best what the deck's law does in 1:1 biaxial strain and in a bias pull: sqrt(nu12 nu21) first, then
-- nu12 / nu21, then the first again.
local function fit_ratios(fields, make)
  local wanted = {}
  for _, path in ipairs(sampled.paths(fabric.woven(fields))) do
    if path.name == "biaxial" or path.name == "bias" then
      local lists, peak = { laws.along(make(), path) }, 0
      for _, list in ipairs(lists) do
        for _, S in ipairs(list) do peak = math.max(peak, math.abs(S)) end
      end
      wanted[#wanted + 1] = { path = path, lists = lists, peak = peak }
    end
  end
  local function misfit(mean, lean)
    fields.warp.poisson, fields.weft.poisson = mean * math.exp(lean), mean * math.exp(-lean)
    local card, sum = fabric.woven(fields), 0
    for _, w in ipairs(wanted) do
      for k, list in ipairs { sampled.along(card, w.path) } do
        for i, S in ipairs(list) do sum = sum + ((S - w.lists[k][i]) / w.peak) ^ 2 / #list end
      end
    end
    return sum
  end
  local mean, lean = 0, 0
  for _ = 1, 2 do
    mean = least_of(function(m) return misfit(m, lean) end, 0, 0.98)
    lean = least_of(function(l) return misfit(mean, l) end, -1, 1)
  end
  misfit(mean, lean)
end

-- A card that does not do what the deck's law does is another material: it is refused, unless the deck says how large a misfit it takes. Cycles are
-- compared, but a card has its own way of unloading. LAW19 loses its compression, which the bias pull shows: it is no more than reported.
local most = 25 -- per cent of the peak stress
local function judge(t, kind, rows)
  local off, largest = {}, 0
  for _, r in ipairs(rows) do
    if not r.path:find "^cyclic" and not (kind.name == "LAW19" and r.path == "bias") and not (r.worst <= most) then
      off[#off + 1] = ("%s up to %.0f %% (rms %.0f %%, work %+.0f %%)"):format(r.words, r.worst, r.rms, r.work)
      largest = math.max(largest, r.worst)
    end
  end
  if #off == 0 then return end
  local words = table.concat(off, "; ")
  if largest <= (t.misfit or most) then
    return fabric.warn(("import: %s: the card differs from the deck's law, in per cent of the peak stress: %s; the report has all paths"):format(t.file, words))
  end
  fail(("card: %s: no card of this program does what this material does, in per cent of the peak stress: %s; misfit=%.0f takes it all the same"):format(
    t.file, words, math.ceil(largest)))
end

-- The keywords of the materials that are read, by solver.
local keywords = {
  openradioss = { "^/MAT/LAW58/", "^/MAT/FABR_A/", "^/MAT/LAW19/", "^/MAT/FABRI/" }, ["ls-dyna"] = { "^%*MAT_FABRIC", "^%*MAT_034" }, abaqus = { "^%*FABRIC" },
}

-- Says that the file has further materials: one is read, LAW58 before LAW19, the first of each.
local function tell_further(t, from, name, notes)
  local places = {}
  for i, line in ipairs(read.lines_of(t.file)) do
    for _, pattern in ipairs(keywords[from]) do
      if line:upper():find(pattern) then places[#places + 1] = i end
    end
  end
  if #places < 2 then return end
  local words = ("%d materials of this kind are in the file (lines %s); '%s' is read: give each of the others a file of its own"):format(#places, table.concat(places, ", "), name)
  notes[#notes + 1] = "materials: " .. words
  fabric.warn(("import: %s: %s"):format(t.file, words))
end

-- Keywords that change what a material does, and that no reader of this program takes.
local lost_keywords = {
  openradioss = { "^/LEAK", "^/FAIL", "^/VISC", "^/EOS", "^/THERM", "^/HEAT", "^/NONLOCAL", "^/DAMP", "^/ALE", "^/EULER", "^/XFEM", "^/MAT/" },
  ["ls-dyna"] = { "^%*MAT_", "^%*DAMPING", "^%*EOS", "^%*AIRBAG_SHELL_REFERENCE", "^%*INITIAL_FOAM", "^%*DEFINE_FABRIC" },
  abaqus = { "^%*DAMPING", "^%*EXPANSION", "^%*DAMAGE", "^%*ELASTIC", "^%*PLASTIC", "^%*VISCO", "^%*HYSTERESIS", "^%*FAIL", "^%*DEPVAR", "^%*USER", "^%*CREEP", "^%*HYPER" },
}

-- Says which of them the file has: what they do is lost.
local function tell_lost(t, from, notes)
  local names, lines, seen = {}, {}, {}
  for i, line in ipairs(read.lines_of(t.file)) do
    local upper, own, known = line:upper(), false, false
    for _, pattern in ipairs(lost_keywords[from]) do own = own or upper:find(pattern) ~= nil end
    for _, pattern in ipairs(keywords[from]) do known = known or upper:find(pattern) ~= nil end
    if own and not known then
      local name = from == "abaqus" and upper:match "^[^,]*" or from == "openradioss" and upper:match "^/[%u_]+/?[%u_]*%d*[%u_]*" or upper:match "^%S+"
      name = name:match "^(.-)[%s/]*$"
      if not seen[name] then names[#names + 1], seen[name] = name, true end
      lines[#lines + 1] = tostring(i)
    end
  end
  if #names == 0 then return end
  local words = ("%s of the file (line%s %s) %s not read, and what %s lost"):format(table.concat(names, ", "), #lines > 1 and "s" or "", table.concat(lines, ", "),
    #names > 1 and "are" or "is", #names > 1 and "they do to the material is" or "it does to the material is")
  notes[#notes + 1] = "cards: " .. words
  fabric.warn(("import: %s: %s"):format(t.file, words))
end

local function run(t)
  local from = t.from or (t.file:match "%.rad$" and "openradioss") or (t.file:match "%.inp$" and "abaqus") or (t.file:match "%.k$" or t.file:match "%.key$") and "ls-dyna"
  local solver = from
  if from == "openradioss" and read.law19_block(t.file) then from = "law19" end
  local kind = kinds[from]
  if not kind then fail(("card: field 'file': expected a name that ends in .rad, .k or .inp, or field 'from', got '%s'"):format(t.file)) end
  local notes = {}
  local p = kind.read(t.file, units_of(t, notes))
  tell_further(t, solver, p.name, notes)
  tell_lost(t, solver, notes)
  local thickness = t.thickness or p.thickness
  if not thickness then fail(("card: field 'thickness': expected a positive number in m (%s has no section), got nil"):format(t.file)) end
  local density = t.density or p.density
  if not density or density <= 0 then fail(("card: field 'density': expected a positive number in kg/m^3 (%s has none), got nil"):format(t.file)) end
  local poisson = t.poisson or p.poisson or { 0, 0 }
  if #poisson ~= 2 or poisson[1] * poisson[2] >= 1 then
    fail(("card: field 'poisson': expected {nu12, nu21} with a product below 1, got {%s}"):format(table.concat(poisson, ", ")))
  end
  local fields = { name = t.name or p.name, density = density, thickness = thickness, tested = {},
    source = ("%s of %s"):format(kind.name, t.file:match "[^/]*$") }
  local sheet = from == "openradioss" and require "fabric.export.crimp".straightened(p) or p
  turn_all(t, sheet, kind, notes)
  for _, name in ipairs { "warp", "weft", "shear" } do
    fields[name], fields.tested[name] = part_of(name, sheet[name], kind, t.unloading and t.unloading[name], notes)
  end
  fields.warp.poisson, fields.weft.poisson = poisson[1], poisson[2]
  if sheet ~= p and not t.poisson then
    fit_ratios(fields, function() return kind.law(p) end)
    notes[#notes + 1] = ("poisson: nu12 = %.3f and nu21 = %.3f are fitted to what the deck's law does in 1:1 biaxial strain and in a bias pull"):format(
      fields.warp.poisson, fields.weft.poisson)
  elseif not t.poisson and not p.poisson then notes[#notes + 1] = p.note or "poisson: the file has no ratios; 0 was taken, poisson={nu12, nu21} gives them" end
  if sheet ~= p then
    notes[#notes + 1] = ("crimp: S1 = %g and S2 = %g (0.1 where the file leaves them blank) let the yarns straighten first; the card's curves are those of the sheet, "
      .. "pulled along a yarn and free across"):format(p.S1, p.S2)
  end
  local card = fabric.woven(fields)
  local rows = loss.rows(card, function() return kind.law(p) end)
  local lost = {}
  for _, r in ipairs(rows) do lost[r.path] = r end
  judge(t, kind, rows)
  local lines = { ("%s, read as card '%s'; the file's law beside the card's:"):format(fields.source, fields.name) }
  for _, l in ipairs(loss.lines(rows)) do lines[#lines + 1] = "  " .. l end
  for _, n in ipairs(notes) do lines[#lines + 1] = "- " .. n end
  local result = { card = card, losses = rows, lost = lost, notes = notes, report = table.concat(lines, "\n"), parameters = p }
  return setmetatable(result, { __tostring = function(r) return r.report end })
end

define {
  name = "fabric.import.card",
  arguments = {
    { name = "file", kind = "text", sentence = "a starter deck with LAW58 or LAW19, an LS-DYNA deck with *MAT_034, or an Abaqus deck with *FABRIC test data" },
    { name = "from", kind = "text", choices = { "openradioss", "ls-dyna", "abaqus" }, optional = true, sentence = "default: by the file's ending, .rad, .k (.key) or .inp" },
    { name = "units", kind = "text", choices = units.names, optional = true,
      sentence = "that the file is written in; default: those that it states in a comment 'Units: ... (mm-t-s)', in /BEGIN or in the /UNIT/n that the material names, else mm-t-s" },
    { name = "name", kind = "text", optional = true, sentence = "of the card; default: the material's" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "default: that of a section in the file" },
    { name = "density", kind = "number", unit = "kg/m^3", above = 0, optional = true, sentence = "default: the file's" },
    { name = "poisson", kind = "numbers", low = 0, optional = true, sentence = "{nu12, nu21}, which such files do not hold; default {0, 0}, of crimped yarns of LAW58 those that fit its law best" },
    { name = "misfit", kind = "number", unit = "%", above = 0, default = most, sentence = "largest difference from the deck's law on any path but cycles, per cent of the peak stress" },
    { name = "tested", kind = "fields", optional = true, sentence = "strains up to which the curves count as measured; default: LAW58 where loading and unloading cross, else those that the file states in a comment 'Tested up to E11 = ...', else the curves' ends",
      rows = { { name = "warp", kind = "number", low = 0, high = 10, optional = true, sentence = "largest E11; 0: not known, as in a card" },
        { name = "weft", kind = "number", low = 0, high = 10, optional = true, sentence = "largest E22; 0: not known, as in a card" },
        { name = "shear", kind = "number", low = 0, below = 0.5, optional = true, sentence = "largest E12 (tensor); 0: not known" } } },
    { name = "unloading", kind = "fields", optional = true, sentence = "unloading moduli, Pa, instead of those of the file's curves",
      rows = { { name = "warp", kind = "number", unit = "Pa", above = 0, optional = true, sentence = "of the warp" },
        { name = "weft", kind = "number", unit = "Pa", above = 0, optional = true, sentence = "of the weft" },
        { name = "shear", kind = "number", unit = "Pa", above = 0, optional = true, sentence = "of S12 over E12 (tensor)" } } },
  },
  sentence = "A woven card out of another solver's material: its curves as measured points, its unloading as a modulus. Returns card, report (text), losses and "
    .. "lost (as fabric.export.card, the file's law beside the card's), notes. A material that no card follows within `misfit` is refused.",
  example = "local path = os.tmpname()..'.rad'\n"
    .. "fabric.export.card{ card=fabric.card 'blend', to='openradioss', file=path }\n"
    .. "local r = fabric.import.card{ file=path, thickness=0.38e-3, poisson={0.25, 0.42} }\n"
    .. "os.remove(path)\n"
    .. "assert(r.lost.warp.worst < 0.5 and math.abs(r.card.density / 590 - 1) < 1e-9)",
  run = run,
}
