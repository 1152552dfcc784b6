-- Shared by the dynamic tests: a square sheet, its run, and the ledger as columns of the curve.
local sheet = require "fabric.lab.virtual.sheet"
local u = require("fabric").units
local fabric = require "fabric"
local lists = require "fabric.lists"
local motion = {}

local ledger = { "kinetic", "stored", "dissipated", "dissipated_warp", "dissipated_weft", "dissipated_shear", "dissipated_damage",
                 "dissipated_bending", "damping", "external", "created", "error" }

-- A square of n x n elements at the origin, warp along x; its model with gravity along -z.
function motion.square(t)
  local mesh = fabric.mesh.rectangle { width = t.size, height = t.size, nx = t.cells, ny = t.cells }
  local model = fabric.model { mesh = mesh, card = t.card, points = t.card.bending and 1 or t.points, warp = 0 }
  model:gravity { 0, 0, -9.81 }
  return mesh, model
end

function motion.analysis(t, model)
  return fabric.dynamic { model = model, duration = t.duration, step = t.step or "auto", scheme = t.scheme, force = t.force,
                          ledger_limit = t.ledger_limit, damping = t.damping > 0 and { mass = t.damping } or nil }
end

-- Runs to the end; every t.every seconds a row with reading(a) and the ledger. If the run fails, returns the rows so far and
-- the message `trouble`; t.strict raises it as an error.
function motion.run(t, a, names, stem, reading)
  local curve = sheet.observe(a, lists.joined(names, ledger), t.out, stem, function(run)
    local row, e = reading(run), run.energy
    for _, name in ipairs(ledger) do row[name] = e[name] end
    return row
  end, t.every)
  local ok, trouble = pcall(a.solve, a)
  if not ok and (t.strict or type(trouble) ~= "table") then error(trouble, 0) end
  return { curve = curve, analysis = a, trouble = not ok and tostring(trouble) or nil }
end

-- z of the lowest node, m, and the number of that node.
function motion.lowest(a, mesh)
  local least = math.huge
  for i = 1, #mesh.nodes do least = math.min(least, a:node(i).z) end
  return least
end

-- Number of the node at column i and row j (from 0) of an n x n sheet.
function motion.node(n, i, j) return j * (n + 1) + i + 1 end

motion.arguments = {
  { name = "card", of = "card", sentence = "the fabric" },
  { name = "cells", kind = "integer", low = 4, default = 20, sentence = "along an edge; 20 are those of the thesis, 1 to 2 for each fold of a square of 2 m by its weight (model:check())" },
  { name = "size", kind = "number", unit = "m", above = 0, default = 2, sentence = "of the square" },
  { name = "duration", kind = "number", unit = "s", above = 0, default = 0.5, sentence = "of the run" },
  { name = "step", kind = "number", unit = "s", above = 0, optional = true, sentence = "as for fabric.dynamic; default: \"auto\"" },
  { name = "scheme", kind = "text", choices = { "explicit", "implicit" }, default = "explicit", sentence = "as for fabric.dynamic" },
  { name = "points", kind = "integer", low = 1, default = 3, sentence = "through the thickness, where the card has no bending of its own" },
  { name = "damping", kind = "number", unit = "1/s", low = 0, default = 0, sentence = "of the masses" },
  { name = "every", kind = "number", unit = "s", above = 0, default = 5 * u.ms, sentence = "time between rows and frames" },
  { name = "force", kind = "boolean", default = false, sentence = "as for fabric.dynamic" },
  { name = "strict", kind = "boolean", default = true, sentence = "a run that fails is an error; false: its rows so far are returned, with `trouble`" },
  { name = "ledger_limit", kind = "number", above = 0, default = 0.05, sentence = "as for fabric.dynamic" },
  { name = "out", kind = "text", optional = true, sentence = "folder for curve.csv and the VTK series" },
}

motion.retired = { "gravity", "inertia" }

return motion
