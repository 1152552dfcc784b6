-- fabric.lab.ball_burst and .impact: a ball is pushed slowly through cloth that is held in a ring, and shot through a clamped square.
--
--            O   ball                     burst: cloth held from the ring outwards, ball moved down
--      ====-----====  cloth: membrane     impact: the rim of the square held, ball free, with a speed
--
-- The cloth is a membrane: it folds about the ball, and yarns break where they reach their strength, warp and weft.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local rupture = require "fabric.lab.rupture.rupture"
local sheet = require "fabric.lab.virtual.sheet"
local lists = require "fabric.lists"
local mm = fabric.units.mm

local function both(call, card)
  for _, yarn in ipairs { "warp", "weft" } do rupture.of(call, card, yarn) end
end

-- A square with fine elements in its middle, and its model with a ball that nearly touches it.
local function setup(t, side, fine)
  local low, high = side / 2 - fine, side / 2 + fine
  local lines = rupture.lines(side, low, high, t.h, t.most or t.h, 1.25)
  local mesh = fabric.mesh.rectangle { width = side, height = side, grading = { x = lines, y = lines } }
  local model = fabric.model { mesh = mesh, card = t.card, warp = 0, membrane = true }
  local above = kernels.free_thickness(t.card) / 2 + 1e-2 * t.h
  local ball = fabric.rigid.sphere { radius = t.ball / 2, centre = { side / 2, side / 2, t.ball / 2 + above }, mass = t.mass, name = "ball" }
  model:contact { between = { ball, "all" }, friction = t.friction, stiffness = t.stiffness }
  return mesh, model, ball
end

local function burst(t)
  both("ball_burst", t.card)
  rupture.check_lengths("ball_burst", t)
  local most = t.ring - 2 * t.card.thickness
  if t.ball > most then
    define.fail(("ball_burst: field 'ball': expected at most %.4g m, the ring less the cloth on both sides, got %.4g"):format(most, t.ball))
  end
  local side = t.ring + 4 * t.h
  local mesh, model, ball = setup(t, side, side / 2 - 1.5 * t.h)
  local function beyond(x, y) return (x - side / 2) ^ 2 + (y - side / 2) ^ 2 end
  local ring = (t.ring / 2 - 0.25 * t.h) ^ 2
  mesh:set("ring", function(x, y) return beyond(x, y) >= ring end)
  model:fix("ring", "x y z"):tearable("all", { coarse = t.coarse, seed = t.seed })
  local strain, c = rupture.strain(t.card, "warp", t.card.rupture.warp.strength)
  t.speed = t.speed or c * math.max(strain, 0.05) / 100
  t.damping = t.damping or c / t.ring / 4
  local duration = 1.2 * t.ring / 2 / t.speed
  local history = fabric.history(rupture.way(0.05 * duration, duration, t.speed))
  model:move(ball, { z = function(time) return -history:value(time) end })
  local a = fabric.dynamic { model = model, duration = duration, damping = { mass = t.damping }, ledger_limit = t.ledger_limit }
  local result = rupture.run(t, a, function(now) return history:value(now) end, {
    stem = "ball_burst", model = model, mesh = mesh, every = duration / (t.rows or 300),
    ends = function(row, peak) return row.fracture > 0 and row.force < 0.3 * peak end,
  })
  result.ball = ball
  return result
end

-- The ball behind the cloth, or thrown back, is no longer pushed: then its speed is the residual one.
local function impact(t)
  both("impact", t.card)
  rupture.check_lengths("impact", t)
  -- Contact that stops cloth at twice the speed within half of its thickness.
  t.stiffness = t.stiffness or 4 * t.card.density * t.card.thickness * (2 * t.speed / kernels.free_thickness(t.card)) ^ 2
  local mesh, model, ball = setup(t, t.side, t.ball)
  model:fix("boundary", "x y z"):tearable("all", { coarse = t.coarse, seed = t.seed })
  model:velocity(ball, { z = -t.speed })
  local a = fabric.dynamic { model = model, duration = t.duration, ledger_limit = t.ledger_limit }
  local every = t.duration / (t.rows or 200)
  local names = { "depth", "speed", "force", "open", "kinetic", "rigid", "stored", "fracture", "friction", "dissipated", "external", "error" }
  local function reading(run)
    local _, _, z, _, _, vz = run:body(ball)
    local _, _, fz = run:reaction(ball)
    local row, e = { depth = t.ball / 2 - z, speed = -vz, force = -fz, open = run.joints.open, error = run.energy.error }, run.energy
    for _, name in ipairs { "kinetic", "rigid", "stored", "fracture", "friction", "dissipated", "external" } do row[name] = e[name] end
    return row
  end
  local curve, complete = sheet.observe(a, names, t.out, "impact", reading, every, t.state)
  local function away(row) return row and row.force == 0 and row.depth > 0 and (row.speed < 0 or row.depth > t.ball) end
  a:every(every, function(run)
    if away(curve[#curve]) and away(curve[#curve - 1]) then run:stop "the ball flies on" end
  end)
  if t.prepare then t.prepare(a) end
  a:solve()
  complete()
  local row = curve[#curve] or reading(a)
  local result = { curve = curve, analysis = a, model = model, mesh = mesh, ball = ball, residual = row.speed, fracture = row.fracture,
                   energy = t.mass * (t.speed ^ 2 - row.speed ^ 2) / 2, series = t.out and t.out .. "/impact.pvd" or nil }
  result.through = row.speed > 0 and row.force == 0 and row.depth > t.ball
  if sheet.is_whole(a, curve, every, "impact") then
    result.depth, result.peak = 0, 0
    for _, r in ipairs(curve) do result.depth, result.peak = math.max(result.depth, r.depth), math.max(result.peak, r.force) end
  end
  if not result.through and row.speed > 0 then
    fabric.warn(("impact: at %.3g s, the end of the run, the ball is still in the cloth and moves at %.3g m/s: expected a longer duration"):format(a.time, row.speed))
  end
  return result
end

local function rows(own, speed)
  return lists.joined({ { name = "card", of = "card", sentence = "the fabric, with rupture of warp and weft" } }, own, {
    { name = "stiffness", kind = "number", unit = "Pa/m", above = 0, optional = true, sentence = "of contact, as for model:contact" },
    { name = "friction", kind = "number", low = 0, default = 0.2, sentence = "of ball and cloth" },
    { name = "ledger_limit", kind = "number", above = 0, default = 0.05, sentence = "as for fabric.dynamic" },
  }, lists.collect(rupture.arguments, function(row)
    if row.name == "speed" then return speed or row end
    if row.name ~= "damping" or not speed then return row end
  end))
end

local sample = "local fabric = require 'fabric'\nlocal yarn = { strength=15e3, energy=20 }\n"
  .. "local card = fabric.card 'blend':with{ rupture={ warp=yarn, weft=yarn } }\n"

define {
  name = "fabric.lab.ball_burst",
  arguments = rows {
    { name = "ball", kind = "number", unit = "m", above = 0, default = 25.4 * mm, sentence = "diameter" },
    { name = "ring", kind = "number", unit = "m", above = 0, default = 44.45 * mm, sentence = "inner diameter" },
    { name = "h", kind = "number", unit = "m", above = 0, default = 2 * mm, sentence = "size of the elements" },
  },
  sentence = "A ball is pushed through cloth that is held in a ring, as in ASTM D3787 [astm_d3787], with contact and friction. Returns peak (N, the bursting "
    .. "strength), elongation (m, the ball's way there), curve (a list of time, displacement, force: N, work over way from row to row, open: joints, and the energies of "
    .. "analysis.energy), energy (J), fracture (J), kinetic (kinetic energy over work at the peak), series (VTK), analysis, model, mesh and ball.",
  example = sample .. "local test = fabric.lab.ball_burst{ card=card, h=0.006, speed=20, rows=30 }\nassert(test.peak > 0 and test.elongation > 0)",
  run = burst,
}

define {
  name = "fabric.lab.impact",
  arguments = rows({
    { name = "ball", kind = "number", unit = "m", above = 0, default = 5.56 * mm, sentence = "diameter" },
    { name = "mass", kind = "number", unit = "kg", above = 0, default = 0.7e-3, sentence = "of the ball; default: of steel" },
    { name = "side", kind = "number", unit = "m", above = 0, default = 100 * mm, sentence = "of the clamped square" },
    { name = "h", kind = "number", unit = "m", above = 0, default = 1 * mm, sentence = "size of the elements in the middle" },
    { name = "most", kind = "number", unit = "m", above = 0, default = 4 * mm, sentence = "size of the elements at the rim" },
    { name = "duration", kind = "number", unit = "s", above = 0, default = 1e-3, sentence = "at which a run ends that has not done so before" },
  }, { name = "speed", kind = "number", unit = "m/s", above = 0, sentence = "at which the ball strikes" }),
  sentence = "A ball is shot through the middle of a clamped square. Returns residual (m/s, its speed behind the cloth; negative: thrown back), through (whether it is "
    .. "behind the cloth), energy (J, what it lost), fracture (J), depth (m, the deepest), peak (N, the largest force), curve (a list of time, depth, speed, force, open: "
    .. "joints, and the energies of analysis.energy), series (VTK), analysis, model, mesh and ball.",
  example = sample .. "local test = fabric.lab.impact{ card=card, side=0.03, h=0.002, speed=300, duration=2e-5, rows=20 }\nassert(test.residual < 300)",
  run = impact,
}
