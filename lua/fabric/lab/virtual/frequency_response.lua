-- fabric.lab.frequency_response: steady swings of a state under a support or a force that shakes, summed over its natural modes.
-- Structural damping is a stiffness K (1 + i eta), so that modes stay apart: q = load / (M (w0^2 (1 + i eta) - w^2)) of each.
local fabric = require "fabric"
local define = require "fabric.define"
local curves = require "fabric.columns"

local pi = math.pi
local axes = { "x", "y", "z" }
local reach, fewest, enough = 2, 10, 0.9 -- modes up to so many times the last frequency, at least so many; share of the load that they should have

local function fail(field, words, ...) define.fail(("frequency_response: field '%s': " .. words):format(field, ...)) end

-- The components of a vector that is given by names.
local function vector(given, field, unit)
  local v = { given.x or 0, given.y or 0, given.z or 0 }
  if v[1] == 0 and v[2] == 0 and v[3] == 0 then fail(field, "expected x=, y= or z= in %s other than zero, got none", unit) end
  return v
end

local function largest(v)
  local most = 1
  for i = 2, 3 do if math.abs(v[i]) > math.abs(v[most]) then most = i end end
  return most
end

local function loaded_nodes(t, mesh)
  local set = t.force.set
  if math.type(set) == "integer" then
    if set > #mesh.nodes then fail("force.set", "expected a node from 1 to %d, got %d", #mesh.nodes, set) end
    return { set }
  end
  return mesh:set(set)
end

-- The load on each mode over its own mass, for one unit of time: m of the base (times w^2), or N over kg.
local function loads(t, modes, mesh)
  local on = {}
  if t.base then
    local v = vector(t.base, "base", "m")
    for k, mode in ipairs(modes) do
      on[k] = mode.participation.x * v[1] + mode.participation.y * v[2] + mode.participation.z * v[3]
    end
    return on, v
  end
  local v = vector(t.force, "force", "N")
  local nodes = loaded_nodes(t, mesh)
  for k, mode in ipairs(modes) do
    local x, y, z, sum = mode.shape.x, mode.shape.y, mode.shape.z, 0
    for _, n in ipairs(nodes) do sum = sum + v[1] * x[n] + v[2] * y[n] + v[3] * z[n] end
    on[k] = sum / #nodes / mode.own_mass
  end
  return on, v
end

-- How much of the load the modes have: of a base their share of the mass that moves along it; of a force the share of the deflection
-- at rest that the lower half of them gives already.
local function covered(t, modes, on, v)
  local of, all = 0, 0
  if t.base then
    for i, axis in ipairs(axes) do
      all = all + v[i] ^ 2 * modes.mass[axis]
      for _, mode in ipairs(modes) do of = of + v[i] ^ 2 * mode.mass[axis] end
    end
    return of / all
  end
  for k, mode in ipairs(modes) do
    local part = mode.frequency > 0 and on[k] ^ 2 * mode.own_mass / mode.frequency ^ 2 or 0
    all = all + part
    if 2 * k <= #modes then of = of + part end
  end
  return all > 0 and of / all or 0
end

-- Evenly from the first to the last, and the tops of the modes with the places beside them where half the power is left.
local function frequencies(t, modes)
  local all = {}
  for i = 0, t.points - 1 do all[#all + 1] = t.lowest + (t.highest - t.lowest) * i / (t.points - 1) end
  for _, mode in ipairs(modes) do
    for side = -1, 1 do
      local f = mode.frequency * math.sqrt(1 + side * t.damping)
      if f > t.lowest and f < t.highest then all[#all + 1] = f end
    end
  end
  table.sort(all)
  return all
end

local function swing(t, modes, on, along, f)
  local re, im = 0, 0
  for k, mode in ipairs(modes) do
    local square, w0 = (2 * pi * f) ^ 2, (2 * pi * mode.frequency) ^ 2
    local a, b = w0 - square, t.damping * w0
    local q = along[k] * on[k] * (t.base and square or 1) / (a * a + b * b)
    re, im = re + q * a, im - q * b
  end
  return re, im
end

local function warn(words, ...) if not fabric.checking() then fabric.warn(("frequency_response: " .. words):format(...)) end end

-- The modes, and whether they are all that the model has.
local function find(t)
  local function modes_of(count, below) return fabric.modes { from = t.from, model = t.model, count = count, below = below } end
  local modes, count = not t.count and modes_of(nil, reach * t.highest), t.count or fewest
  if not modes or #modes < count then modes = modes_of(count) end
  for _, mode in ipairs(modes) do
    if mode.growth > 0 then define.fail("frequency_response: the state is not a stable equilibrium: expected one about which the cloth swings") end
  end
  return modes, #modes < count
end

local function run(t)
  if (t.from == nil) == (t.model == nil) then
    fail("from", "expected an analysis, or in its place model=, got %s", t.from and "both" or "neither")
  end
  if (t.base == nil) == (t.force == nil) then fail("base", "expected { x=, y=, z= } in m, or in its place force=, got %s", t.base and "both" or "neither") end
  if not (t.highest > t.lowest) then fail("highest", "expected more than lowest=%g Hz, got %g", t.lowest, t.highest) end
  local mesh = (t.model or t.from.model).mesh
  if t.node > #mesh.nodes then fail("node", "expected a node from 1 to %d, got %d", #mesh.nodes, t.node) end
  local modes, all = find(t)
  local on, v = loads(t, modes, mesh)
  local axis = t.along and ({ x = 1, y = 2, z = 3 })[t.along] or largest(v)
  local along = {}
  for k, mode in ipairs(modes) do along[k] = mode.shape[axes[axis]][t.node] end
  local r = { modes = modes, covered = t.force and all and 1 or covered(t, modes, on, v), curve = curves.made() }
  local base = t.base and v[axis] or 0
  for _, f in ipairs(frequencies(t, modes)) do
    local re, im = swing(t, modes, on, along, f)
    local row = { frequency = f, amplitude = math.sqrt((base + re) ^ 2 + im ^ 2), phase = 180 / pi * math.atan(im, base + re),
      relative = math.sqrt(re ^ 2 + im ^ 2) }
    r.curve[#r.curve + 1] = row
    if not r.peak or row.amplitude > r.peak.amplitude then r.peak = row end
  end
  if r.covered < enough then
    warn(t.base and "the modes that are taken, %d, have %.0f %% of the mass that moves with the supports: expected %.0f %%, by a larger count="
      or "the lower half of the modes that are taken, %d, gives %.0f %% of the deflection under the force at rest: expected %.0f %%, by a larger count=",
      #modes, 100 * r.covered, 100 * enough)
  end
  local last = modes[#modes].frequency
  if not all and last < 1.5 * t.highest then
    warn("the last of the modes that are taken, %d, swings at %.4g Hz: expected at least 1.5 times the last frequency, %.4g Hz, by a larger count=", #modes, last, 1.5 * t.highest)
  end
  return r
end

local function amplitudes(unit, first)
  local rows = { first }
  for _, axis in ipairs(axes) do rows[#rows + 1] = { name = axis, kind = "number", unit = unit, optional = true, sentence = "along " .. axis } end
  return rows
end

define {
  name = "fabric.lab.frequency_response",
  arguments = {
    { name = "from", of = "analysis", optional = true, sentence = "the state about which the cloth swings" },
    { name = "model", of = "model", optional = true, sentence = "in its place: the cloth as it is at time 0, without stress" },
    { name = "base", kind = "fields", rows = amplitudes "m", optional = true, sentence = "{ x=, y=, z= }, m: amplitudes of all supports, which shake together" },
    { name = "force", kind = "fields", optional = true,
      rows = amplitudes("N", { name = "set", kind = "text|integer", low = 1, sentence = "name of a node set, or a node" }), sentence = "{ set=, x=, y=, z= }, N: in its place the amplitudes of a force on a set, shared evenly by its nodes, or on a node" },
    { name = "damping", kind = "number", above = 0, high = 0.999, sentence = "structural: the stiffness is K (1 + i damping); twice the share of critical damping" },
    { name = "node", kind = "integer", low = 1, sentence = "whose motion is asked for" },
    { name = "along", kind = "text", choices = axes, optional = true, sentence = "which component of it; default the largest of what shakes" },
    { name = "lowest", kind = "number", unit = "Hz", above = 0, sentence = "the first frequency" },
    { name = "highest", kind = "number", unit = "Hz", above = 0, sentence = "the last frequency" },
    { name = "points", kind = "integer", low = 2, default = 201, sentence = "frequencies from the first to the last; those of the modes, and of half their power, are added" },
    { name = "count", kind = "integer", low = 1, high = 400, optional = true, sentence = "how many modes; default all below twice the last frequency, and at least 10" },
  },
  sentence = "Steady swings of a node about a state under supports or a force that shake, with structural damping, summed over the natural modes. Returns curve (rows of "
    .. "frequency, Hz; amplitude, m; phase, degrees, below 0 where the node lags; relative, m, of the motion beside the supports), peak (the row of the largest amplitude), modes (those of "
    .. "fabric.modes) and covered: of a base, the share that the modes have of the mass which moves; of a force, the share of the deflection at rest that the lower half of the modes gives.",
  example = "local mesh = fabric.mesh.rectangle{ width=0.2, height=0.05, nx=8, ny=2 }\n"
    .. "local card = fabric.svk{ density=1000, thickness=1e-3, warp=5e6, weft=5e6, shear=2e6, poisson=0,\n"
    .. "  bending={ warp=4e-4, weft=4e-4, twist=2e-4 } }\n"
    .. "local m = fabric.model{ mesh=mesh, card=card, warp=0 }:fix('left', 'x y z rotation')\n"
    .. "local r = fabric.lab.frequency_response{ model=m, base={ z=1e-4 }, damping=0.04, node=mesh:set('right')[1], lowest=0.1, highest=1, count=20 }\n"
    .. "assert(r.covered > 0.9 and math.abs(r.peak.frequency / r.modes[1].frequency - 1) < 0.01)\n"
    .. "assert(math.abs(r.peak.relative / (1.57 * 1e-4 / 0.04) - 1) < 0.02)  -- 1.57: of the tip of a cantilever",
  run = run,
}
