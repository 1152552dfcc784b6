-- fabric.export.model: mesh, sets, supports, loads and card as a deck of another solver.
local fabric = require "fabric"
local define = require "fabric.define"
local units = require "fabric.export.units"
local targets = require "fabric.export.targets"
local gather = require "fabric.export.gather"
local card = require "fabric.export.card"
local fail = define.fail

local writers = { ["ls-dyna"] = require "fabric.export.deck_dyna", openradioss = require "fabric.export.deck_radioss", abaqus = require "fabric.export.deck_abaqus" }
local endings = { ["ls-dyna"] = "k", openradioss = "rad", abaqus = "inp" }

local function run(t)
  local by_name = t.file and ({ k = "ls-dyna", rad = "openradioss", inp = "abaqus" })[t.file:match "%.(%w+)$"]
  local to = t.to or by_name
  if not to then
    fail(("model: field 'file': expected a name that ends in .inp, .k or .rad, or field 'to', got %s"):format(t.file and "'" .. t.file .. "'" or "nil"))
  end
  if by_name ~= to and t.file then
    fail(("model: field 'file': expected a name that ends in .%s for %s, got '%s'"):format(endings[to], to, t.file))
  end
  local m = gather.model(t)
  local r = card.run { card = m.card, to = to, material = t.material, units = t.units, id = 1, axis = m.warp, element = t.element }
  local target, u = targets.find(to, r.material, m.card.kind), units.of(t.units)
  m.name = card.name(m.card)
  local notes = #m.notes > 0 and target.comment(m.notes) .. "\n" or ""
  local text = writers[to](m, notes .. r.body, target, u)
  if t.file then fabric.write(t.file, text) end
  return { text = text, to = to, material = r.material, notes = m.notes, card = r, file = t.file }
end

define {
  name = "fabric.export.model",
  arguments = {
    { name = "model", of = "model", sentence = "one sheet of one card, with fix, move, force and gravity" },
    { name = "warp", kind = "number|numbers", unit = "degrees", optional = true, sentence = "the model's warp: its angle from x, or its direction {x, y, z}; needed only where it differs from place to place in the model" },
    { name = "file", kind = "text", optional = true, sentence = "that ends in .inp, .k or .rad (name it NAME_0000.rad for the starter); default: the text is only returned" },
    { name = "to", kind = "text", choices = targets.solvers, optional = true, sentence = "the solver; default: by the file's name" },
    { name = "material", kind = "text", optional = true, sentence = "as for fabric.export.card" },
    card.arguments[1],
    { name = "element", kind = "number", unit = "m", above = 0, optional = true, sentence = "as for fabric.export.card" },
    { name = "histories", kind = "table", optional = true, sentence = "{ ['top.y']={{t, v}, ...} }: points {t, v}, in s and SI, to be written for a motion or force of a set along an axis, in place of the model's own" },
    { name = "error", kind = "number", above = 0, high = 0.1, default = 1e-4, sentence = "of functions of time, which are written as points: largest difference over their range" },
    { name = "duration", kind = "number", unit = "s", above = 0, optional = true, sentence = "of the run; default: the last corner of a history, at least 1 s" },
  },
  sentence = "A model as a deck of another solver: nodes, elements, sets, supports, loads, section and material. Returns text, material, card (what "
    .. "fabric.export.card returns, with the losses), and notes on what the deck states differently (functions of time, with the difference). Histories are written with all their points and digits (LS-DYNA, OpenRadioss: those that 20 columns hold). Abaqus and CalculiX: shells S4 and *STATIC with NLGEOM for "
    .. "*ELASTIC, membranes and *DYNAMIC, EXPLICIT for *FABRIC.",
  example = "local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=3, ny=9 }\n"
    .. "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n"
    .. "m:fix('bottom', 'x y z rotation'):move('top', { y=fabric.ramp(0.01, 1) })\n"
    .. "local r = fabric.export.model{ model=m, warp=90, to='ls-dyna' }\n"
    .. "assert(r.text:find '*BOUNDARY_PRESCRIBED_MOTION_SET' and #r.notes == 0)",
  run = run,
}
