-- fabric.lab.seam_strength and .seam_slippage: a specimen with a seam across it is pulled until the seam bursts, or until it gapes.
--
--     strip, ISO 13935-1        grab, ISO 13935-2 and 13936
--        +------+               +----+====+----+
--        | high |               |    |jaw |    |
--        +~~~~~~+  the seam     |~~~~~~~~~~~~~~|     pulled along y, the yarns of `yarn` along the pull
--        | low  |               |    |jaw |    |
--        +------+               +----+====+----+
local fabric = require "fabric"
local define = require "fabric.define"
local rupture = require "fabric.lab.rupture.rupture"
local lists = require "fabric.lists"
local mm = fabric.units.mm

local transits, start, ended = 100, 10, 0.02 -- as in fabric.lab.strip_rupture

local function fail(call, field, words) define.fail(("%s: field '%s': %s"):format(call, field, words)) end

-- Lines of nodes across and along: of a grab specimen with nodes at the edges of the jaws, which are as deep as wide.
local function lines(parts, h)
  local out, at = { 0 }, 0
  for _, part in ipairs(parts) do
    local n = math.max(1, math.floor(part / h + 0.5))
    for i = 1, n do out[#out + 1] = at + part * i / n end
    at = at + part
  end
  return out
end

-- The two pieces of a specimen, sewn, or (for comparison) as one piece of cloth: its model, held by "low.grip" and "high.grip".
local function specimen(t, sewn)
  local side = t.jaw and (t.width - t.jaw) / 2 or 0
  local across = lines(t.jaw and { side, t.jaw, side } or { t.width }, t.h)
  local function piece(from, to, jaw_at)
    local mesh = fabric.mesh.rectangle { width = t.width, height = to - from, origin = { 0, from, 0 },
      grading = { x = across, y = lines(t.jaw and (jaw_at == from and { t.jaw, to - from - t.jaw } or { to - from - t.jaw, t.jaw }) or { to - from }, t.h) } }
    local near = 0.01 * t.h
    mesh:set("grip", function(x, y)
      if not t.jaw then return math.abs(y - jaw_at) < near end
      return math.abs(x - t.width / 2) < t.jaw / 2 + near and math.abs(y - jaw_at) < t.jaw + near
    end)
    return mesh
  end
  local whole = t.length + (t.jaw and 2 * t.jaw or 0)
  local warp = t.yarn == "warp" and 90 or 0
  local m = fabric.model { points = 1, membrane = true, bodies = {
    { name = "low", mesh = piece(0, whole / 2, 0), card = t.card, warp = warp },
    { name = "high", mesh = piece(whole / 2, whole, whole), card = t.card, warp = warp } } }
  m:seam { "low.top", "high.bottom", stiffness = sewn and t.stiffness or nil, strength = sewn and t.strength or nil, energy = sewn and t.energy or nil }
  for _, body in ipairs { "low", "high" } do m:fix(body .. ".all", "z") end
  m:fix("low.grip", "x y"):fix("high.grip", "x")
  return m
end

local function check(call, t)
  rupture.check_lengths(call, t)
  if t.jaw and t.jaw >= t.width then fail(call, "jaw", ("expected jaws narrower than the specimen of %g m, got %g m"):format(t.width, t.jaw)) end
end

-- --- bursting

local function seam_strength(t)
  t.jaw = t.method == "grab" and (t.jaw or 25 * mm) or nil
  t.width, t.length = t.width or (t.jaw and 100 * mm or 50 * mm), t.length or (t.jaw and 100 * mm or 200 * mm)
  check("seam_strength", t)
  local strain, c = rupture.strain(t.card, t.yarn, t.strength)
  local transit = t.length / c
  local reach = strain * t.length + (t.stiffness and t.strength / t.stiffness or 0)
  t.speed = t.speed or reach / (transits * transit)
  t.damping = t.damping or 1 / (4 * transit)
  local to = start * transit / 2 + (1.5 * reach + 2 * t.energy / t.strength) / t.speed
  local model = specimen(t, true)
  local history = fabric.history(rupture.way(start * transit, to, t.speed))
  model:move("high.grip", { y = history })
  local a = fabric.dynamic { model = model, duration = to, damping = { mass = t.damping }, ledger_limit = t.ledger_limit }
  local result = rupture.run(t, a, function(now) return history:value(now) end, {
    stem = "seam_strength", model = model, every = to / (t.rows or 400), more = { "closed" },
    reading = function(run, row)
      row.closed = run.joints.closed
      row.tension = 0
      for _, value in ipairs(run:field("tension_" .. t.yarn)) do row.tension = math.max(row.tension, value) end
    end,
    ends = function(row, peak) return row.fracture > 0 and row.force < ended * peak end,
  })
  if not result.whole then return result end
  local tension = 0
  for _, row in ipairs(result.curve) do tension = math.max(tension, row.tension) end
  result.strength = result.peak / (t.jaw or t.width)
  result.tension = tension
  local given = t.card.rupture and t.card.rupture[t.yarn]
  result.cloth = given and tension / given.strength or nil
  if result.cloth and result.cloth > 1 then
    fabric.warn(("seam_strength: the cloth is pulled with %.2f of its own strength before the seam bursts: it would tear first"):format(result.cloth))
  end
  return result
end

-- --- gaping

local function curve_of(t, sewn, reach)
  local m = specimen(t, sewn)
  m:move("high.grip", { y = fabric.ramp(reach, 1) })
  local a = fabric.static { model = m, duration = 1, step = 1 / (t.rows or 40) }
  local curve = { { displacement = 0, force = 0 } }
  a:every("step", function(run) curve[#curve + 1] = { displacement = reach * run.time, force = select(2, run:reaction "high.grip") } end)
  if t.prepare then t.prepare(a) end
  a:solve()
  return curve, a
end

-- The displacement at a force, on the rising part of a curve; nothing where it is not reached.
local function at_force(curve, force)
  for i = 2, #curve do
    local a, b = curve[i - 1], curve[i]
    if b.force >= force then return a.displacement + (b.displacement - a.displacement) * (force - a.force) / (b.force - a.force) end
  end
end

local function seam_slippage(t)
  check("seam_slippage", t)
  -- As far as cloth of the jaws' width and the seam stretch at the largest force that is asked for.
  local force = math.max(t.load, t.stiffness * t.opening * t.jaw)
  local strain = rupture.strain(t.card, t.yarn, force / t.jaw)
  local reach = 1.3 * (strain * t.length + force / (t.stiffness * t.jaw))
  local result = {}
  result.sewn, result.analysis = curve_of(t, true, reach)
  result.plain = curve_of(t, false, reach)
  local function gape(f)
    local a, b = at_force(result.sewn, f), at_force(result.plain, f)
    return a and b and a - b
  end
  result.opening = gape(t.load)
  for i = 2, #result.sewn do
    local low, high = result.sewn[i - 1].force, result.sewn[i].force
    local g0, g1 = gape(low), gape(high)
    if g0 and g1 and g1 >= t.opening and high > low then
      result.force = low + (high - low) * (t.opening - g0) / (g1 - g0)
      break
    end
  end
  if fabric.checking() then result.opening, result.force = result.opening or 0, result.force or 0 end
  return result
end

local function rows(own)
  return lists.joined({
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "yarn", kind = "text", choices = { "warp", "weft" }, default = "warp", sentence = "that is pulled, across the seam" },
    { name = "h", kind = "number", unit = "m", above = 0, default = 5 * mm, sentence = "size of the elements" },
  }, own)
end

local of_tests = lists.collect(rupture.arguments, function(row) if row.name ~= "coarse" and row.name ~= "seed" then return row end end)

local strength_rows = lists.joined(rows {
  { name = "strength", kind = "number", unit = "N/m", above = 0, sentence = "of the seam" },
  { name = "energy", kind = "number", unit = "J/m", above = 0, sentence = "that bursting takes, per metre of seam" },
  { name = "stiffness", kind = "number", unit = "N/m^2", above = 0, optional = true, sentence = "of the seam, where it gives way" },
  { name = "method", kind = "text", choices = { "strip", "grab" }, default = "strip", sentence = "ISO 13935-1 or -2" },
  { name = "width", kind = "number", unit = "m", above = 0, optional = true, sentence = "of the specimen; default 50 mm, grab 100 mm" },
  { name = "length", kind = "number", unit = "m", above = 0, optional = true, sentence = "between the jaws; default 200 mm, grab 100 mm" },
  { name = "jaw", kind = "number", unit = "m", above = 0, optional = true, sentence = "grab: width and depth of the jaws, default 25 mm" },
  { name = "ledger_limit", kind = "number", above = 0, default = 0.05, sentence = "as for fabric.dynamic" },
}, of_tests)

define {
  name = "fabric.lab.seam_strength",
  arguments = strength_rows,
  sentence = "A specimen with a seam across it is pulled until the seam bursts, as in ISO 13935 [iso_13935_1; iso_13935_2]. Returns peak (N, the largest force), elongation (m) there, strength (N/m, over the width of "
    .. "the specimen, or of the jaws), tension (N/m, the largest in the cloth along the pull) and cloth, its share of the strength that the card has in rupture (above 1 the cloth would tear first, which a warning says), "
    .. "curve (a list of time, displacement, force: N, closed: stitches, and the energies of analysis.energy), energy (J), fracture (J), kinetic (kinetic energy over work at the peak), series (VTK), analysis and model.",
  example = "local test = fabric.lab.seam_strength{ card=fabric.card 'blend', strength=4e3, energy=20, width=0.01, length=0.02, h=0.0025 }\n"
    .. "assert(math.abs(test.strength / 4e3 - 1) < 0.01)",
  run = seam_strength,
}

define {
  name = "fabric.lab.seam_slippage",
  arguments = rows {
    { name = "stiffness", kind = "number", unit = "N/m^2", above = 0, sentence = "of the seam: force per metre of it and metre of opening" },
    { name = "opening", kind = "number", unit = "m", above = 0, default = 6 * mm, sentence = "ISO 13936-1: at which the force is wanted" },
    { name = "load", kind = "number", unit = "N", above = 0, default = 120, sentence = "ISO 13936-2: at which the opening is wanted" },
    { name = "width", kind = "number", unit = "m", above = 0, default = 100 * mm, sentence = "of the specimen" },
    { name = "length", kind = "number", unit = "m", above = 0, default = 100 * mm, sentence = "between the jaws" },
    { name = "jaw", kind = "number", unit = "m", above = 0, default = 25 * mm, sentence = "width and depth of the jaws" },
    { name = "rows", kind = "integer", low = 10, optional = true, sentence = "of the curves, default 40" },
    { name = "prepare", kind = "function", optional = true, sentence = "function(analysis), called before each of the two runs" },
  },
  sentence = "How far a seam gapes, as in ISO 13936 [iso_13936_1; iso_13936_2]: a specimen with a seam and one without are pulled by jaws in their middle, in static steps. Returns force (N, at which the one with the seam is "
    .. "longer by `opening`; nil: not reached), opening (m, by which it is longer at `load`), sewn and plain (the curves, lists of displacement and force), and analysis.",
  example = "local test = fabric.lab.seam_slippage{ card=fabric.card 'blend', stiffness=5e5, opening=1e-3, load=5, width=0.02, jaw=0.01, length=0.02, h=0.005 }\n"
    .. "assert(test.force > 0 and test.opening > 0)",
  run = seam_slippage,
}
