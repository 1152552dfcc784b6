-- fabric.lab.tear: a cut specimen is torn on.
--
--   trouser, tongue:                        trapezoid:
--
--      | leg 1, gripped, pulled up                x -->      clamps along the oblique sides,
--      |                                        ___---       laid parallel before the test
--      +=======  specimen, cut to the tip     _|-  cut  |
--      |                                       |_        |    the tear runs along x
--      | leg 2, pulled down                      ---___  |
--
--   wing: as trouser, but the legs are gripped along lines that meet the cut at 55 degrees, outwards towards the tip, and both grips are laid along
--   the tear. The distance from the tip to a grip grows by a sin 55 as the tear grows by a, at the same place along both grips.
--
-- The specimen is a membrane: the folds at the tip are sharper than any element, and what bending costs there is far below what
-- breaking yarns does. Without bending an uncut end that is free gathers into a bundle, and each fold that snaps takes energy: in a trouser or tongue
-- test it is therefore held flat and a little taut along the tear. Yarns break on the line of the cut alone.
local fabric = require "fabric"
local define = require "fabric.define"
local rupture = require "fabric.lab.rupture.rupture"
local trapezoid = require "fabric.lab.rupture.trapezoid"
local mm = fabric.units.mm

local inertia = 2e-3 -- areal mass times a leg's width times the square of the speed, over the force that is expected
-- Damping over the frequency (rad/s) at which a leg swings: what legs and uncut end lose on their steady way is below a hundredth of the work. The uncut
-- end of a wing is free, and swings.
local calm = { trouser = 0.05, tongue = 0.05, wing = 0.1 }
local taut = 0.3     -- force along the tear on the uncut end, over the force that legs which do not stretch tear at
local held = 2e-3    -- s, in which it grows to that
local spread = 4     -- elements along the tear over which yarns are breaking at least: with fewer the force jumps, and energy is lost
local growth = 1.4   -- of elements from the tear outwards
local haste = 3      -- speed of the legs while they are turned into place, over that of the pull
local skipped = 0.25 -- of the record, before the mean is taken
local wing = math.rad(55) -- between the grips of a wing specimen and the cut

-- Specimens of the standards, m: width, length of the legs between jaw and tip, way to be torn (of the 75 mm of the standards: the
-- rest is alike), and how the standard takes peaks: their mean, and which rise counts.
local specimens = {
  trouser = { width = 50 * mm, leg = 50 * mm, tear = 50 * mm, mean = "iso", rise = 0.1 },
  tongue = { width = 75 * mm, leg = 37.5 * mm, tear = 50 * mm, mean = "astm", rise = 0.01 },
  wing = { width = 100 * mm, leg = 50 * mm / math.sin(wing), tear = 40 * mm, mean = "iso", rise = 0.1 },
  trapezoid = { width = 75 * mm, short = 25 * mm, long = 100 * mm, cut = 15 * mm, tear = 50 * mm, mean = "astm", rise = 0.01 },
}

-- The strength with which yarns break over `spread` elements when the legs part at right angles: the crack faces are 2 a apart at a distance a
-- behind the tip, and carry nothing from 2 G / f on.
local function strengths(t, yarn, broken)
  local most = broken.energy / (spread * t.h)
  if broken.strength <= most then return t.card end
  local fine = broken.energy / (spread * broken.strength)
  if t.coarse == "refuse" then
    define.fail(("tear: field 'h': elements of %.3g m are coarse for %s yarns of %.4g N/m and %.4g J/m: expected at most %.3g m, or coarse='lower' (a strength of %.4g N/m)"):format(
      t.h, yarn, broken.strength, broken.energy, fine, most))
  end
  fabric.warn(("tear: elements of %.3g m are coarse for %s yarns of %.4g N/m and %.4g J/m, which want %.3g m: the strength is lowered to %.4g N/m, with which "
    .. "breaking takes as much; the beginning of the tear and its peaks are not those of single yarns, and legs dissipate less than beside yarns of full strength"):format(t.h, yarn, broken.strength, broken.energy, fine, most))
  return t.card:with { rupture = { [yarn] = { strength = most } } }
end

-- A rectangle with the tear along y in its middle, cut from y = 0 to the tip, fine about the tear.
local function specimen(t)
  local x, y = t.width / 2, t.leg
  local mesh = fabric.mesh.rectangle { width = t.width, height = t.leg + t.tear + t.rest, grading = {
    x = rupture.lines(t.width, x - 2 * t.h, x + 2 * t.h, t.h, 6 * t.h, growth),
    y = rupture.lines(t.leg + t.tear + t.rest, y - 2 * t.h, y + t.tear, t.h, 4 * t.h, growth) } }
  local near = 0.01 * t.h
  -- Legs of a wing end along their grips; about the tip the mesh stays along the yarns.
  local straight = y - 2 * t.h
  if t.method == "wing" then
    local least = x / math.tan(wing) + 2 * t.h
    if y <= least then define.fail(("tear: field 'leg': expected more than %.4g m for a wing %.4g m wide with elements of %.3g m, got %.4g"):format(least, t.width, t.h, y)) end
    mesh:map(function(px, py) return px, py + math.max(0, 1 - py / straight) * math.abs(px - x) / math.tan(wing), 0 end)
  end
  mesh:slit { from = { x, 0 }, to = { x, y }, left = "left face", right = "right face" }
  local face = {}
  for i, name in ipairs { "left face", "right face" } do
    for _, n in ipairs(mesh:set(name)) do face[n] = mesh.nodes[n][2] < y - near and i or nil end
  end
  for i, name in ipairs { "leg 1", "leg 2" } do
    local ids = {}
    for n = 1, #mesh.nodes do
      local p = mesh.nodes[n]
      local side, from = face[n] or (p[1] < x and 1 or 2), t.method == "wing" and math.abs(p[1] - x) / math.tan(wing) or 0
      if p[2] < from + near and side == i then ids[#ids + 1] = n end
    end
    mesh:set(name, ids)
  end
  mesh:set("zone", function(px, py) return math.abs(px - x) < t.h + near and py > y - t.h - near end)
  mesh:set("path", function(px, py) return math.abs(px - x) < near and py > y - near end)
  return mesh
end

-- A leg turns through a right angle about the line through the tip that is parallel to its grip, and is then pulled away from the other one.
local function straight_legs(t, model, angle, apart)
  for i, sign in ipairs { 1, -1 } do
    model:fix("leg " .. i, "x")
    model:move("leg " .. i, {
      y = function(time) return t.leg * (1 - math.cos(angle(time))) end,
      z = function(time) return sign * (t.leg * math.sin(angle(time)) + apart(time) / 2) end,
    })
  end
  model:fix("top", "x z"):force("top", { y = fabric.ramp(taut * t.rigid, held) })
end

-- The legs of a wing turn about the tip in their plane as well, until both grips lie along the tear. A node of a grip has the distance `arm` from
-- the line through the tip that is parallel to the grip, and the coordinate s along it.
local function wing_legs(t, model, mesh, angle, apart)
  local arm, tip = t.leg * math.sin(wing), { t.width / 2, t.leg }
  for i, sign in ipairs { 1, -1 } do
    for k, n in ipairs(mesh:set("leg " .. i)) do
      local p, set = mesh.nodes[n], ("leg %d, %d"):format(i, k)
      local s = -sign * (p[1] - tip[1]) * math.sin(wing) + (p[2] - tip[2]) * math.cos(wing)
      local function slant(time) return wing * (1 - angle(time) / (math.pi / 2)) end
      local function flat(time) return arm * math.cos(angle(time)) end
      mesh:set(set, { n })
      model:move(set, {
        x = function(time) return tip[1] - p[1] - sign * (s * math.sin(slant(time)) + flat(time) * math.cos(slant(time))) end,
        y = function(time) return tip[2] - p[2] + s * math.cos(slant(time)) - flat(time) * math.sin(slant(time)) end,
        z = function(time) return sign * (arm * math.sin(angle(time)) + apart(time) / 2) end,
      })
    end
  end
end

local function legs(t, model, mesh)
  local arm = t.leg * math.sin(t.slant)
  local turning = 2 * arm / (haste * t.speed)
  local function angle(time) return time < turning and math.pi / 4 * (1 - math.cos(math.pi * time / turning)) or math.pi / 2 end
  local gently = 0.1 * t.tear / t.speed
  local way = fabric.history(rupture.way(gently, 2 * t.far / t.speed, t.speed))
  local function apart(time) return way:value(math.max(0, time - turning)) end
  if t.method == "wing" then
    wing_legs(t, model, mesh, angle, apart)
  else
    straight_legs(t, model, angle, apart)
  end
  return turning, apart, turning + gently
end

-- The first row beyond the first quarter of the tear, and the last one; nil if the tear did not come so far.
local function steady(curve, cut)
  local last = #curve
  for i, row in ipairs(curve) do
    if row.torn > skipped * cut then return row.displacement < curve[last].displacement and i or nil, last end
  end
end

-- Work over way in blocks of equal way, two openings of joints in each at least: the scatter of their means, and from it a band of 95 % of the mean of all.
local function band(curve, first, last, middle)
  local count = math.min(8, (curve[last].open - curve[first].open) // 2)
  if count < 3 then return end
  local from, way = curve[first].displacement, curve[last].displacement - curve[first].displacement
  local squares, begin, used = 0, first, 0
  for i = first + 1, last do
    if curve[i].displacement >= from + way * (used + 1) / count * (1 - 1e-12) then
      local force = (curve[i].external - curve[begin].external) / (curve[i].displacement - curve[begin].displacement)
      squares, begin, used = squares + (force - middle) ^ 2, i, used + 1
    end
  end
  if used < 3 then return end
  local deviation = math.sqrt(squares / (used - 1))
  local half = fabric.lab.student(0.975, used - 1) * deviation / math.sqrt(used)
  return { middle - half, middle + half, deviation = deviation, blocks = used }
end

local apart = 0.25 -- of the energy of breaking: joints that have opened with so much less or more spent are no steady tear
local idle = 0.01  -- of the work: more in motion and damping is said

local function doubt(balance, energy)
  if math.abs(balance.fracture / energy - 1) > apart then
    fabric.warn(("tear: breaking took %.3g J per metre of tear where the card has %.3g J/m: joints opened whose yarns still hold, and the tear is not steady; "
      .. "try other elements, or a smaller speed"):format(balance.fracture, energy))
  end
  local damping, motion = balance.damping / balance.work, balance.kinetic / balance.work
  if damping + motion > idle then
    fabric.warn(("tear: damping takes %.2g %% and motion %.2g %% of the work, expected at most %g %% together: the mean force is as much above that of the tear, and `expected` "
      .. "has it; legs that carry compression snap at the tip, which less damping does not cure: joints then open that would hold"):format(100 * damping, 100 * motion, 100 * idle))
  end
end

-- Mean force after the first quarter of the tear, from the work; its band; and where that work went, per metre of tear.
local function evaluate(result, cut, energy)
  local first, last
  if result.whole then first, last = steady(result.curve, cut) end
  if not first then return end
  local a, b = result.curve[first], result.curve[last]
  local torn, way, work = b.torn - a.torn, b.displacement - a.displacement, b.external - a.external
  result.mean = work / way
  result.band = band(result.curve, first, last, result.mean)
  if not (torn > 0) then return end
  local function spent(account) return (b[account] - a[account]) / torn end
  local balance = { torn = torn, way = way / torn, work = work / torn, fracture = spent "fracture", hysteresis = spent "dissipated" - spent "fracture",
    damping = spent "damping", stored = spent "stored", kinetic = spent "kinetic" }
  result.balance = balance
  if b.open - a.open >= 8 then doubt(balance, energy) end
  result.expected = (energy + balance.hysteresis + balance.damping + balance.stored + balance.kinetic) / balance.way
end

local function trouser(t)
  t.h = t.tear / math.ceil(t.tear / t.h - 1e-9) -- a line of nodes at the tip and at the end of the tear
  for _, least in ipairs { { "width", 4 * t.h }, { "leg", 2 * t.h } } do
    local name, length = least[1], least[2]
    if t[name] < length then
      define.fail(("tear: field '%s': expected at least %.4g m with elements of %.3g m, got %.4g"):format(name, length, t.h, t[name]))
    end
  end
  local yarn = rupture.other(t.along)
  local broken = rupture.of("tear", t.card, yarn)
  local card = strengths(t, yarn, broken)
  t.slant = t.method == "wing" and wing or math.pi / 2
  t.rigid = broken.energy / 2 / math.sin(t.slant)
  local areal = card.density * card.thickness
  local c = math.sqrt(t.rigid / (areal * t.width / 2)) -- of waves across a taut leg
  t.speed = t.speed or math.sqrt(inertia) * c
  t.damping = t.damping or calm[t.method] * math.pi * c / (t.leg + t.tear / 2)
  t.rest, t.far = math.max(10 * t.h, t.width / 2), 1.25 * t.tear * math.sin(t.slant)
  local mesh = specimen(t)
  local model = fabric.model { mesh = mesh, card = card, warp = t.along == "warp" and 90 or 0, membrane = true }
  model:tearable("zone", { coarse = t.coarse, seed = t.seed, path = "path" })
  local turning, apart, from = legs(t, model, mesh)
  local duration = turning + 2 * t.far / t.speed
  local a = fabric.dynamic { model = model, duration = duration, damping = { mass = t.damping }, ledger_limit = t.ledger_limit }
  local every = math.min(duration / 50, t.rows and duration / t.rows or t.h / 4 / t.speed)
  local result = rupture.run(t, a, apart, {
    stem = "tear", model = model, mesh = mesh, from = from, every = every, more = { "torn" },
    reading = function(_, row) row.torn = row.open * t.h end,
    counts = function(row) return row.torn > 0 end,
    ends = function(row) return row.torn > t.tear - t.h / 2 end,
  })
  evaluate(result, t.tear, broken.energy)
  local standard = specimens[t.method]
  result.rigid = t.rigid
  return rupture.peaks(result, standard.mean, standard.rise)
end

local function pulled_apart(t)
  local yarn = rupture.other(t.along)
  local broken = rupture.of("tear", t.card, yarn)
  local result = trapezoid.run(t, yarn, broken)
  evaluate(result, t.tear, broken.energy)
  return rupture.peaks(result, specimens.trapezoid.mean, specimens.trapezoid.rise)
end

local methods = { trouser = trouser, tongue = trouser, wing = trouser, trapezoid = pulled_apart }

local function run(t)
  for name, value in pairs(specimens[t.method]) do t[name] = t[name] or value end
  t.coarse = t.coarse or "lower"
  rupture.check_lengths("tear", t)
  return methods[t.method](t)
end

define {
  name = "fabric.lab.tear",
  arguments = rupture.rows {
    { name = "card", of = "card", sentence = "the fabric, with rupture" },
    { name = "method", kind = "text", choices = { "trouser", "tongue", "wing", "trapezoid" }, default = "trouser", sentence = "ISO 13937-2, ASTM D2261, ISO 13937-3, ASTM D5587" },
    { name = "along", kind = "text", choices = { "warp", "weft" }, default = "warp", sentence = "yarns along which the tear runs: the others break" },
    { name = "h", kind = "number", unit = "m", above = 0, default = 3 * mm, sentence = "size of the elements along the tear, at most" },
    { name = "width", kind = "number", unit = "m", above = 0, optional = true, sentence = "of the specimen, for a trapezoid along the tear; default: the standard's" },
    { name = "leg", kind = "number", unit = "m", above = 0, optional = true, sentence = "trouser, tongue, wing: from jaw to tip along the cut; default: half of the standard's gauge length, for a wing at right angles to the grip" },
    { name = "short", kind = "number", unit = "m", above = 0, optional = true, sentence = "trapezoid: the short side; default: the standard's" },
    { name = "long", kind = "number", unit = "m", above = 0, optional = true, sentence = "trapezoid: the long side; default: the standard's" },
    { name = "cut", kind = "number", unit = "m", above = 0, optional = true, sentence = "trapezoid: length of the cut; default: the standard's" },
    { name = "tear", kind = "number", unit = "m", above = 0, optional = true, sentence = "how far it is torn; default: 50 mm" },
    { name = "ledger_limit", kind = "number", above = 0, default = 0.05, sentence = "as for fabric.dynamic" },
  },
  sentence = "A cut specimen is torn on: trouser [iso_13937_2], tongue (single rip) [astm_d2261], wing [iso_13937_3] or trapezoid [astm_d5587]; a membrane whose yarns break on the line of the "
    .. "cut. Returns mean (N, the work over the way of the grips after the first quarter of the tear), band ({low, high} of 95 % of that mean, from the scatter over the tear; nil of a short one), balance (where "
    .. "that work went, J per metre of tear: fracture, hysteresis, damping, stored, kinetic, together work; way of the grips per metre of tear; torn, m), expected (N, the energy of breaking and the other parts of "
    .. "the balance, over the way), rigid (N, half of the energy, for a wing over sin 55: with legs that neither stretch nor dissipate; not for a trapezoid), "
    .. "mean_of_peaks (N, as the standard takes it; nil where the record has no peaks), peaks, peak (N), curve (a list of "
    .. "time, displacement, force: N, work over way from row to row, torn: m, open: joints, and the energies of analysis.energy), energy (J), fracture (J), kinetic (kinetic "
    .. "energy over work at the peak), series (VTK), analysis, model and mesh.",
  example = "local sheet = fabric.svk{ young=1e8, poisson=0, density=500, thickness=5e-4, through_thickness=true }\n"
    .. "local card = sheet:with{ rupture={ weft={ strength=1250, energy=20 } } }\n"
    .. "local test = fabric.lab.tear{ card=card, h=0.004, width=0.024, leg=0.012, tear=0.05 }\n"
    .. "assert(test.rigid == 10 and math.abs(test.mean / test.expected - 1) < 0.1)",
  run = run,
}
