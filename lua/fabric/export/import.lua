-- fabric.import.card: a card from another solver's material, with the same report of what is lost.
local fabric = require "fabric"
local define = require "fabric.define"
local units = require "fabric.export.units"
local curves = require "fabric.export.curves"
local laws = require "fabric.export.laws"
local loss = require "fabric.export.loss"
local read = require "fabric.export.read_deck"
local fail = define.fail

local kinds = {
  openradioss = { read = function(path, u) return read.law58(path, u, laws.value) end, measure = "nominal_degrees", law = laws.law58, name = "LAW58", ending = "rad" },
  abaqus = { read = read.fabric, measure = "nominal_radians", law = laws.fabric, name = "*FABRIC", ending = "inp", shifted = true },
}

-- Points {E, S} of the loading curve in the card's measures, up to `tested`, and beyond as far as the file has data.
local function points(back, part)
  local out = {}
  for i = 1, #part.loading.x do
    local E, S = back(part.loading.x[i], part.loading.y[i])
    out[i] = { E, S }
  end
  return out
end

local function steepest(list, upto)
  local most = 0
  for i = 2, #list do
    if list[i - 1][1] < upto then most = math.max(most, (list[i][2] - list[i - 1][2]) / (list[i][1] - list[i - 1][1])) end
  end
  return most
end

-- The unloading modulus between the reversal and a fifth of its stress below; nil for an elastic curve.
local function modulus(back, part, shifted)
  if part.elastic then return end
  local c, top = part.unloading, part.meet
  local inverse = { x = c.y, y = c.x }
  local offset = shifted and top[1] - laws.value(inverse, top[2]) or 0
  local y = 0.8 * top[2]
  local E1, S1 = back(top[1], top[2])
  local E0, S0 = back(laws.value(inverse, y) + offset, y)
  return (S1 - S0) / (E1 - E0)
end

-- The card's curve passes smoothly through the points and is a little steeper between them, so the modulus has a margin.
local margin = 1.05

local function part_of(name, from, kind, notes)
  local measure = curves.measures[kind.measure]
  local back = name == "shear" and measure.shear_back or measure.axis_back
  local list = points(back, from)
  local tested = back(from.meet[1], from.meet[2])
  local most, unloading = steepest(list, tested), modulus(back, from, kind.shifted)
  if not unloading then
    unloading = margin * most
    notes[#notes + 1] = ("%s: the file unloads along its loading curve; the card's unloading modulus is 1.05 times the steepest slope, so some energy is lost that the file keeps"):format(name)
  elseif unloading < margin * most then
    notes[#notes + 1] = ("%s: the unloading modulus of %.4g MPa is raised to 1.05 times the steepest slope of the loading, %.4g MPa, below which a card's may not lie")
      :format(name, unloading / 1e6, margin * most / 1e6)
    unloading = margin * most
  end
  return { loading = list, unloading = unloading }, tested
end

-- The strain (Green-Lagrange, E12 in shear) up to which the curve counts as measured, and at which unloading begins.
local function turn_at(part, name, E, kind)
  local measure = curves.measures[kind.measure]
  local x = (name == "shear" and measure.shear or measure.axis)(E, 0)
  if kind.shifted or part.elastic then part.meet = { x, laws.value(part.loading, x) } end
end

local function run(t)
  local from = t.from or (t.file:match "%.rad$" and "openradioss") or (t.file:match "%.inp$" and "abaqus")
  local kind = kinds[from]
  if not kind then fail(("card: field 'file': expected a name that ends in .rad or .inp, or field 'from', got '%s'"):format(t.file)) end
  local p, notes = kind.read(t.file, units.of(t.units)), {}
  local thickness = t.thickness or p.thickness
  if not thickness then fail(("card: field 'thickness': expected a positive number in m (%s has no section), got nil"):format(t.file)) end
  local density = t.density or p.density
  if not density or density <= 0 then fail(("card: field 'density': expected a positive number in kg/m^3 (%s has none), got nil"):format(t.file)) end
  local poisson = t.poisson or { 0, 0 }
  local fields = { name = t.name or p.name, density = density, thickness = thickness, tested = {},
    source = ("%s of %s"):format(kind.name, t.file:match "[^/]*$") }
  for _, name in ipairs { "warp", "weft", "shear" } do
    if t.tested and t.tested[name] then turn_at(p[name], name, t.tested[name], kind) end
    fields[name], fields.tested[name] = part_of(name, p[name], kind, notes)
  end
  fields.warp.poisson, fields.weft.poisson = poisson[1], poisson[2]
  if not t.poisson then notes[#notes + 1] = "poisson: the file has no ratios; 0 was taken, poisson={nu12, nu21} gives them" end
  if from == "openradioss" and math.max(p.S1, p.S2) > 1e-3 then
    notes[#notes + 1] = ("crimp: S1 = %g and S2 = %g tie warp to weft in the file; the card's curves are those of the yarns alone"):format(p.S1, p.S2)
  end
  local card = fabric.woven(fields)
  local rows = loss.rows(card, function() return kind.law(p) end)
  local lost = {}
  for _, r in ipairs(rows) do lost[r.path] = r end
  local lines = { ("%s, read as card '%s'; the file's law beside the card's:"):format(fields.source, fields.name) }
  for _, l in ipairs(loss.lines(rows)) do lines[#lines + 1] = "  " .. l end
  for _, n in ipairs(notes) do lines[#lines + 1] = "- " .. n end
  local result = { card = card, losses = rows, lost = lost, notes = notes, report = table.concat(lines, "\n"), parameters = p }
  return setmetatable(result, { __tostring = function(r) return r.report end })
end

define {
  name = "fabric.import.card",
  arguments = {
    { name = "file", kind = "text", sentence = "a starter deck with LAW58, or an Abaqus deck with *FABRIC test data" },
    { name = "from", kind = "text", choices = { "openradioss", "abaqus" }, optional = true, sentence = "default: by the file's ending, .rad or .inp" },
    { name = "units", kind = "text", choices = units.names, default = "mm-t-s", sentence = "that the file is written in" },
    { name = "name", kind = "text", optional = true, sentence = "of the card; default: the material's" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "default: that of a section in the file" },
    { name = "density", kind = "number", unit = "kg/m^3", above = 0, optional = true, sentence = "default: the file's" },
    { name = "poisson", kind = "numbers", low = 0, optional = true, sentence = "{nu12, nu21}, which such files do not hold; default {0, 0}" },
    { name = "tested", kind = "fields", optional = true, sentence = "strains up to which the curves count as measured; default: LAW58 where loading and unloading cross, else the curves' ends",
      rows = { { name = "warp", kind = "number", above = 0, high = 10, optional = true, sentence = "largest E11" },
        { name = "weft", kind = "number", above = 0, high = 10, optional = true, sentence = "largest E22" },
        { name = "shear", kind = "number", above = 0, below = 0.5, optional = true, sentence = "largest E12 (tensor)" } } },
  },
  sentence = "A woven card out of another solver's material: its curves as measured points, its unloading as a modulus. Returns card, report (text), losses and "
    .. "lost (as fabric.export.card, the file's law beside the card's), notes.",
  example = "local fabric = require 'fabric'\n"
    .. "local path = os.tmpname()..'.rad'\n"
    .. "fabric.export.card{ card=fabric.card 'blend', to='openradioss', file=path }\n"
    .. "local r = fabric.import.card{ file=path, thickness=0.38e-3, poisson={0.25, 0.42} }\n"
    .. "os.remove(path)\n"
    .. "assert(r.lost.warp.worst < 0.5 and math.abs(r.card.density / 590 - 1) < 1e-9)",
  run = run,
}
