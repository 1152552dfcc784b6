-- Shared by the virtual tests in which cloth breaks: what the card must say, how fast is slow, the run, and what it gives.
--
-- Cloth breaks in explicit motion. The grips move at a speed at which kinetic energy is a small share of the work (`kinetic`; a warning
-- beyond 5 %); the force is the work of the grips over their way from row to row, so that its sum is the work exactly and the
-- oscillations of single steps are averaged.
local define = require "fabric.define"
local peaks = require "fabric.lab.common.peaks"
local sheet = require "fabric.lab.virtual.sheet"
local fabric = require "fabric"
local lists = require "fabric.lists"
local rupture = {}

local slow = 0.05 -- kinetic energy over the work, at the largest force

-- Strength and energy of these yarns of a card: an error says what it lacks.
function rupture.of(call, card, yarn)
  local given = card.rupture and card.rupture[yarn]
  if given then return given end
  define.fail(("%s: field 'card': the card '%s' does not say when its %s breaks: expected rupture.%s, as in card:with{ rupture={ %s={ strength=15e3, energy=20 } } }, "
    .. "with the force per width in N/m and the energy per metre of tear in J/m, measured or from the literature"):format(call, card.name or "", yarn, yarn, yarn))
end

-- Refuses lengths of which h would make more elements than any of these tests can have.
function rupture.check_lengths(call, t)
  local most = 2000 * t.h
  for _, name in ipairs { "width", "length", "side", "ring", "jaw", "leg", "tear", "short", "long", "cut" } do
    local length = t[name]
    if length and not (length <= most) then
      define.fail(("%s: field '%s': expected at most %g m, 2000 elements of h=%g m, got %g m"):format(call, name, most, t.h, length))
    end
  end
end

-- The other family of yarns.
function rupture.other(yarn) return yarn == "warp" and "weft" or "warp" end

-- Strain at which yarns reach their strength in a pull along them with free edges, the speed (m/s) of a wave with the secant stiffness
-- there, and the energy per area (J/m^2) that is spent until then.
function rupture.strain(card, yarn, strength)
  local point, step = fabric.point(card), 1e-3
  local E, last, work, stretch_last = 0, 0, 0, 1
  while E < 1.5 do
    E = E + step
    local ok, now = pcall(point.uniaxial, point, yarn, E)
    if not ok then break end
    local stretch = math.sqrt(1 + 2 * E)
    local force = now.S * stretch * card.thickness
    work, last, stretch_last = work + (force + last) / 2 * (stretch - stretch_last), force, stretch
    if force >= strength then break end
  end
  local nominal = stretch_last - 1
  return nominal, math.sqrt(strength / (nominal * card.thickness) / card.density), work
end

-- From rest to the speed 1 within the time `from`, without a jump of the speed: the way as a list of points for fabric.history.
function rupture.way(from, to, speed)
  local points, n = {}, 20
  for i = 0, n do points[i + 1] = { from * i / n, speed * from / 2 * (i / n) ^ 2 } end
  points[#points + 1] = { to, speed * (to - from / 2) }
  return points
end

-- Positions of lines of nodes from 0 to `to` with elements of `h` between `low` and `high`, and outside growing by `growth` from one to
-- the next up to `most`, m. low and high are on lines.
function rupture.lines(to, low, high, h, most, growth)
  local inner = math.max(1, math.floor((high - low) / h + 0.5))
  local function outwards(length) -- sizes from the fine part to the end
    local sizes, sum, size = {}, 0, h
    while sum < length * (1 - 1e-9) do
      size = math.min(size * growth, most)
      sizes[#sizes + 1], sum = size, sum + size
    end
    for i, s in ipairs(sizes) do sizes[i] = s * length / sum end
    return sizes
  end
  local before, after, out, x = outwards(low), outwards(to - high), { 0 }, 0
  for i = #before, 1, -1 do
    x = x + before[i]
    out[#out + 1] = i == 1 and low or x
  end
  for i = 1, inner do out[#out + 1] = low + (high - low) * i / inner end
  x = high
  for i = 1, #after do
    x = x + after[i]
    out[#out + 1] = i == #after and to or x
  end
  return out
end

local columns = { "displacement", "force", "open", "kinetic", "stored", "fracture", "dissipated", "damping", "external", "error" }

-- Runs a test. way(time): displacement of the grips, m; options: from, the time from which on rows have a force (s), every (s), stem,
-- ends(row, peak): whether the test is over, more: names of further columns, reading(run, row): sets them, counts(row): whether the
-- row may be the peak.
function rupture.run(t, a, way, options)
  local names = lists.joined(columns, options.more or {})
  local from, result, curve = options.from or 0, {}, nil
  local function reading(run)
    local e, last = run.energy, curve and curve[#curve]
    local row = { displacement = way(run.time), force = 0, open = run.joints.open, error = e.error }
    for _, name in ipairs(columns) do row[name] = row[name] or e[name] end
    if last and row.displacement > last.displacement and run.time > from then
      row.force = (row.external - last.external) / (row.displacement - last.displacement)
    end
    if options.reading then options.reading(run, row) end
    return row
  end
  local function highest()
    local peak, at = 0, nil
    for _, row in ipairs(curve) do
      if row.force > peak and (not options.counts or options.counts(row)) then peak, at = row.force, row end
    end
    return peak, at
  end
  local complete
  curve, complete = sheet.observe(a, names, t.out, options.stem, reading, options.every, t.state)
  if options.ends then
    a:every(options.every, function(run)
      if options.ends(curve[#curve], (highest())) then run:stop(options.stem .. " is over") end
    end)
  end
  if t.prepare then t.prepare(a) end
  a:solve()
  complete()
  result.curve, result.analysis, result.model, result.mesh = curve, a, options.model, options.mesh
  result.energy, result.fracture = a.energy.external, a.energy.fracture
  result.series = t.out and t.out .. "/" .. options.stem .. ".pvd" or nil
  result.whole = sheet.is_whole(a, curve, options.every, options.stem)
  if not result.whole then return result end
  local peak, at = highest()
  result.peak, result.elongation = peak, at and at.displacement
  result.kinetic = at and at.kinetic / math.max(at.external, 1e-300) or 0
  if result.kinetic > slow then
    fabric.warn(("%s: the kinetic energy is %.2g of the work at the largest force: expected at most %g in a slow test; give a smaller speed (now %.3g m/s)"):format(
      options.stem, result.kinetic, slow, t.speed))
  end
  return result
end

-- Adds peaks (a list of rows) and mean_of_peaks by a standard, of the record from the first broken yarn on.
function rupture.peaks(result, by, share)
  local record = result.whole and lists.collect(result.curve, function(row) if row.torn > 0 then return row end end) or {}
  result.peaks = #record > 0 and peaks.of(record, share) or {}
  result.mean_of_peaks, result.by, result.rise = peaks[by](result.peaks), by, share
  return result
end

rupture.state = { name = "state", kind = "table", optional = true,
  sentence = "an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it; without it peaks and means are nil then" }

rupture.arguments = {
  { name = "speed", kind = "number", unit = "m/s", above = 0, optional = true,
    sentence = "of the grips apart; default: kinetic energy stays a small share of the work" },
  { name = "damping", kind = "number", unit = "1/s", low = 0, optional = true, sentence = "of the masses" },
  { name = "coarse", kind = "text", choices = { "lower", "refuse", "keep" }, optional = true, sentence = "as for model:tearable" },
  { name = "seed", kind = "integer", low = 0, default = 1, sentence = "of the scatter of strengths" },
  { name = "rows", kind = "integer", low = 10, optional = true, sentence = "of the curve, at equal times" },
  { name = "out", kind = "text", optional = true, sentence = "folder for curve.csv and the VTK series" },
  { name = "prepare", kind = "function", optional = true, sentence = "function(analysis), called before the run: for hooks, records and checkpoints of your own" },
  rupture.state,
}

-- The rows of a test: its own, and those of all.
function rupture.rows(own)
  return lists.joined(own, rupture.arguments)
end

return rupture
