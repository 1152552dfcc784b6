-- fabric.lab.ball_drop: a rigid ball falls onto the middle of a clamped square, the last of the tests proposed in the
-- thesis [williams2010, section 8.2].
--
--            O   ball: free, from `height` above the sheet
--      ------------- rim: x y z and directors held; warp along x; gravity along -z
local define = require "fabric.define"
local motion = require "fabric.lab.virtual.motion"
local sheet = require "fabric.lab.virtual.sheet"
local fabric = require "fabric"
local lists = require "fabric.lists"

local clearance = 1e-4 -- m, from which on the fall is computed
local gravity = 9.81 -- m/s^2
local ledger = { "kinetic", "rigid", "stored", "contact", "guard", "dissipated", "friction", "damping", "external", "error" }

-- The ball starts a little above the distance at which contact begins, with the velocity that it has reached there.
local function ball_of(t, model)
  local above = t.card.thickness / 2 + clearance
  if t.height < clearance then
    define.fail(string.format("ball_drop: field 'height': expected at least the clearance of %g m, got %g m", clearance, t.height))
  end
  local ball = fabric.rigid.sphere { radius = t.radius, centre = { t.side / 2, t.side / 2, t.radius + above }, mass = t.mass, name = "ball" }
  model:contact { between = { ball, "all" }, friction = t.friction, stiffness = t.stiffness }
  model:velocity(ball, { z = -math.sqrt(2 * gravity * (t.height - clearance)) })
  return ball
end

local function run(t)
  local mesh = fabric.mesh.rectangle { width = t.side, height = t.side, nx = t.cells, ny = t.cells }
  local model = fabric.model { mesh = mesh, card = t.card, points = t.card.bending and 1 or t.points, warp = 0 }
  model:fix("boundary", "x y z rotation"):gravity { 0, 0, -gravity }
  local ball = ball_of(t, model)
  local a = motion.analysis(t, model)
  local middle = motion.node(t.cells, t.cells // 2, t.cells // 2)
  local columns = lists.joined({ "depth", "deflection", "force", "speed", "gap" }, ledger)
  local result = { depth = 0, deflection = 0, force = 0, gap = math.huge }
  local curve = sheet.observe(a, columns, t.out, "ball_drop", function(r)
    local _, _, z, _, _, vz = r:body(ball)
    local _, _, fz = r:reaction(ball)
    local row, e = { depth = t.radius - z, deflection = -r:node(middle).uz, force = -fz, speed = -vz, gap = (r:gap()) }, r.energy
    for _, name in ipairs(ledger) do row[name] = e[name] end
    result.depth, result.deflection = math.max(result.depth, row.depth), math.max(result.deflection, row.deflection)
    result.force, result.gap = math.max(result.force, row.force), math.min(result.gap, row.gap)
    return row
  end, t.every)
  a:solve()
  result.curve, result.analysis, result.model, result.mesh, result.ball = curve, a, model, mesh, ball
  return result
end

define {
  name = "fabric.lab.ball_drop",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "side", kind = "number", unit = "m", above = 0, default = 0.2, sentence = "of the clamped square" },
    { name = "radius", kind = "number", unit = "m", above = 0, default = 0.03, sentence = "of the ball" },
    { name = "mass", kind = "number", unit = "kg", above = 0, default = 0.1, sentence = "of the ball" },
    { name = "height", kind = "number", unit = "m", above = 0, default = 0.1, sentence = "that it falls from, of its lowest point above the sheet" },
    { name = "friction", kind = "number", low = 0, default = 0.2, sentence = "of ball and cloth" },
    { name = "stiffness", kind = "number", unit = "Pa/m", above = 0, optional = true, sentence = "of contact, as for model:contact" },
    { name = "cells", kind = "integer", low = 4, default = 20, sentence = "along an edge" },
    { name = "duration", kind = "number", unit = "s", above = 0, default = 0.03, sentence = "of the run" },
    { name = "step", kind = "number", unit = "s", above = 0, optional = true, sentence = "as for fabric.dynamic; default: \"auto\"" },
    { name = "scheme", kind = "text", choices = { "explicit", "implicit" }, default = "explicit", sentence = "as for fabric.dynamic" },
    { name = "points", kind = "integer", low = 1, default = 3, sentence = "through the thickness, where the card has no bending of its own" },
    { name = "damping", kind = "number", unit = "1/s", low = 0, default = 0, sentence = "of the masses" },
    { name = "every", kind = "number", unit = "s", above = 0, default = 5e-4, sentence = "time between rows and frames" },
    { name = "out", kind = "text", optional = true, sentence = "folder for curve.csv and the VTK series, cloth and ball" },
  },
  retired = { "clearance", "force", "ledger_limit", "inertia", "gravity" },
  sentence = "A rigid ball falls onto the middle of a clamped square. Returns curve (a list of time, depth of the ball's lowest point and deflection of the "
    .. "middle, m below the sheet at rest, force on the ball, N, its speed downwards, m/s, the smallest gap above the floor of contact, m, and the energies of analysis.energy), "
    .. "depth, deflection and force (the largest of all rows), gap (the smallest), analysis, model, mesh and ball.",
  example = "local test = fabric.lab.ball_drop{ card=fabric.card 'blend', cells=6, duration=0.002 }\n"
    .. "assert(test.deflection > 0 and test.gap > 0)",
  run = run,
}
