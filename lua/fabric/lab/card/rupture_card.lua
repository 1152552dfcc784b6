-- fabric.lab.rupture: from records of strips to break, and of a tear, to a card's `rupture`.
--
-- Strength is the largest force over the width. Its scatter is given as the modulus m of a Weibull distribution, by the greatest likelihood:
--   sum f^m ln f / sum f^m - 1/m = mean of ln f,
-- with a band from the variance of ln m, 0.608 / n for n strips [thoman1969]. It is that of strips, hundreds of yarns side by side and in a row,
-- and so no part of the card, whose scatter is that of the places of a mesh.
-- Energy is twice the mean force of a trouser or tongue tear [rivlin1953]: what the grips do on the way 2 a breaks the yarns of the length a. Legs that
-- stretch and dissipate take their part of that work: how much, a virtual tear of the card with twice the force says, and the energy is less in that ratio.
local fabric = require "fabric"
local define = require "fabric.define"
local check = require "fabric.lab.common.check"
local peaks = require "fabric.lab.common.peaks"
local iso = require "fabric.lab.record.breaking_standards"["ISO 13934-1"]
local lists = require "fabric.lists"
local mm = fabric.units.mm
local fail = define.fail

local variance = 0.608 -- of ln m, times the number of strips
local far = 1.96      -- standard deviations of a band of 95 %

-- Band of 95 % of the mean of a list, by Student's t; nil of one value.
local function band(list)
  if #list < 2 then return end
  local middle, sum = lists.mean(list), 0
  for _, x in ipairs(list) do sum = sum + (x - middle) ^ 2 end
  local half = fabric.lab.student(0.975, #list - 1) * math.sqrt(sum / (#list - 1) / #list)
  return { middle - half, middle + half }
end

-- Weibull modulus of a list of strengths; nil if they are all alike.
local function modulus(list)
  local top, logs = 0, {}
  for _, f in ipairs(list) do top = math.max(top, f) end
  for i, f in ipairs(list) do logs[i] = math.log(f / top) end
  local middle = lists.mean(logs)
  if middle > -1e-9 then return end
  local function excess(m)
    local sum, weighted = 0, 0
    for _, l in ipairs(logs) do
      sum, weighted = sum + math.exp(m * l), weighted + l * math.exp(m * l)
    end
    return weighted / sum - 1 / m - middle
  end
  local low, high = 1e-2, 1e6
  for _ = 1, 200 do
    local m = math.sqrt(low * high)
    if excess(m) > 0 then high = m else low = m end
  end
  return math.sqrt(low * high)
end

local function positive(force, where)
  if not (force > 0 and force < math.huge) then fail(("rupture: field '%s': expected a positive force in N, got %g"):format(where, force)) end
  return force
end

-- The largest force of a strip: a number, a record, or a result of fabric.lab.tensile.
local function peak_of(strip, where)
  if type(strip) == "number" then return positive(strip, where) end
  if type(strip) ~= "table" or type(strip.force) ~= "table" then
    fail(("rupture: field '%s': expected a force in N, a record { displacement=, force= } or a result of fabric.lab.tensile, got %s"):format(where, type(strip)))
  end
  if strip.beyond then strip = strip.beyond end -- the extensometer was taken off before it broke
  check.numbers("rupture", where .. ".force", strip.force)
  local top = 0
  for _, f in ipairs(strip.force) do top = math.max(top, f) end
  if #strip.force > 0 and strip.force[#strip.force] > 0.8 * top then
    fail(("rupture: field '%s': the force ends at %.4g N of at most %.4g N: expected a strip that was pulled until it broke"):format(where, strip.force[#strip.force], top))
  end
  return top
end

-- The forces of strips that count: breaks at the jaws by ISO 13934-1, and of a group of fabric.lab.breaking_strength those that counted there.
local function counted(strips, name)
  local breaks, forces, left_out = {}, {}, {}
  for i, strip in ipairs(strips.specimens or strips) do
    if not (strips.specimens and not strip.counted) then
      local force = strips.specimens and strip.force or strip
      breaks[#breaks + 1] = { place = i, force = peak_of(force, ("%s.strips[%d]"):format(name, i)), jaw = not strips.specimens and type(strip) == "table" and strip.jaw }
    end
  end
  local out, has_mean = iso.left_out(breaks)
  if #breaks > 0 and not has_mean then
    fabric.warn(("rupture: every strip of '%s' broke at a jaw: what is taken for the strength is that of the grips, and the cloth's is larger"):format(name))
  end
  for k, b in ipairs(breaks) do
    if out[k] then
      left_out[#left_out + 1] = b.place
      fabric.warn(("rupture: %s.strips[%d] broke at the jaw at %.4g N and is left out: %s"):format(name, b.place, b.force, out[k]))
    else
      forces[#forces + 1] = b.force
    end
  end
  return forces, left_out
end

local function strength(part, name)
  local forces, left_out = counted(part.strips, name)
  if #forces == 0 then fail(("rupture: field '%s.strips': expected at least one strip, got none"):format(name)) end
  local list = lists.map(forces, function(f) return f / part.width end)
  local out = { strength = lists.mean(list), strengths = list, left_out = left_out, bands = {} }
  out.bands.strength = band(list)
  if #list > 1 then
    out.modulus = modulus(list)
    if out.modulus then
      local factor = math.exp(far * math.sqrt(variance / #list))
      out.bands.modulus = { out.modulus / factor, out.modulus * factor }
    end
  end
  return out
end

-- Mean force of a tear record after its first quarter, over the displacement.
local function tear_force(tear, where)
  if type(tear) == "number" then return positive(tear, where) end
  if type(tear) ~= "table" then fail(("rupture: field '%s': expected a mean force in N or a record { displacement=, force= }, got %s"):format(where, type(tear))) end
  local n, m = check.numbers("rupture", where .. ".displacement", tear.displacement), check.numbers("rupture", where .. ".force", tear.force)
  if n ~= m or n < 3 then fail(("rupture: field '%s': expected displacement and force of one length, 3 rows at least, got %d and %d"):format(where, n, m)) end
  local middle = peaks.mean_force(tear.displacement, tear.force)
  if not middle then fail(("rupture: field '%s': expected a displacement that grows"):format(where)) end
  return middle
end

-- The energy of a family, J/m, and where it comes from.
local function energy(part, name)
  if (part.tears == nil) == (part.energy == nil) then
    fail(("rupture: field '%s': expected either tears (records or mean forces) or energy in J/m, got %s"):format(name, part.tears and "both" or "neither"))
  end
  if part.energy then return part.energy, nil, "assumed: energy given by the deck" end
  local forces = lists.map(part.tears, function(tear, i) return tear_force(tear, ("%s.tears[%d]"):format(name, i)) end)
  if #forces == 0 then fail(("rupture: field '%s.tears': expected at least one, got none"):format(name)) end
  return 2 * lists.mean(forces), lists.mean(forces), ("energy twice the mean force of %d tear%s"):format(#forces, #forces == 1 and "" or "s"), band(forces)
end

local specimen = { h = 2.5 * mm, width = 30 * mm, leg = 25 * mm, tear = 30 * mm }
local elements = 4 -- over which yarns are breaking at least, so that the strength is lowered here and not with a warning for each call

-- The energy, J/m, at which a trouser tear of the card has this mean force (N): the virtual tear with twice the force for it has another one, in nearly the
-- same ratio. Returns also what the legs did; nil where the card cannot be torn.
local function of_legs(card, name, found)
  local guess = 2 * found.tear
  local given = { strength = math.min(found.strength, guess / (elements * specimen.h)), energy = guess }
  local ok, test = pcall(fabric.lab.tear, { card = card:with { rupture = { [name] = given } }, along = name == "warp" and "weft" or "warp", h = specimen.h,
    width = specimen.width, leg = specimen.leg, tear = specimen.tear })
  local b = ok and test.balance
  if not b then
    fabric.warn(("rupture: the card '%s' with what was found for its %s cannot be torn (%s): its energy is twice the mean force, with what legs dissipate"):format(card.name or "", name,
      ok and "no yarn broke" or tostring(test)))
    return
  end
  local force = (guess + b.hysteresis + b.stored) / b.way -- without motion and damping, which are the test's
  return guess * found.tear / force, { hysteresis = b.hysteresis / guess, way = b.way, force = force / found.tear, band = test.band and (test.band[2] - test.band[1]) / 2 / test.mean or 0 }
end

-- Takes out of a found energy what legs of this card dissipate.
local function take_out_legs(t, name, found)
  if not found.tear or not t.legs or t.card.kind ~= "woven" then return "" end
  local energy, legs = of_legs(t.card, name, found)
  if not energy then return "" end
  found.energy, found.legs = energy, legs
  local band = found.bands.energy
  if band then
    local half = math.sqrt(((band[2] - band[1]) / 2 / (2 * found.tear)) ^ 2 + legs.band ^ 2) * energy
    found.bands.energy = { energy - half, energy + half }
  end
  return (" over %.3f, since legs of this card dissipate %.1f %% of it and stretch"):format(legs.force, 100 * legs.hysteresis)
end

local function run(t)
  if not t.warp and not t.weft then fail "rupture: field 'warp': expected warp, weft or both, got neither" end
  local result, given = {}, {}
  for _, name in ipairs { "warp", "weft" } do
    local part = t[name]
    if part then
      local found = strength(part, name)
      local how, tears
      found.energy, found.tear, how, tears = energy(part, name)
      found.bands.energy = tears and { 2 * tears[1], 2 * tears[2] }
      how = how .. take_out_legs(t, name, found)
      found.words = ("%s%d strip%s of %g mm, %s%s"):format(how:find "^assumed" and "assumed: strength of " or "fitted to ", #found.strengths, #found.strengths == 1 and "" or "s",
        part.width / mm, how:gsub("^assumed: ", ""), t.source ~= "" and " (" .. t.source .. ")" or "")
      result[name] = found
      given[name] = { strength = found.strength, energy = found.energy }
    end
  end
  local provenance = lists.copy(t.card.provenance or {})
  for name in pairs(given) do provenance["rupture." .. name] = result[name].words end
  result.card = t.card:with { rupture = given, provenance = provenance }
  return result
end

local function part_rows()
  return {
    { name = "strips", kind = "table", sentence = "strips pulled until they broke: largest forces (N), records { displacement=, force= }, or results of fabric.lab.tensile (breaks at the jaws count as in "
      .. "ISO 13934-1); or a group of fabric.lab.breaking_strength" },
    { name = "width", kind = "number", unit = "m", above = 0, sentence = "of the strips" },
    { name = "tears", kind = "table", optional = true,
      sentence = "trouser or tongue tears in which these yarns broke: mean forces (N) or records { displacement=, force= }" },
    { name = "energy", kind = "number", unit = "J/m", above = 0, optional = true, sentence = "in their place, from elsewhere" },
  }
end

define {
  name = "fabric.lab.rupture",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "warp", kind = "fields", optional = true, rows = part_rows(), sentence = "what was measured on the warp" },
    { name = "weft", kind = "fields", optional = true, rows = part_rows(), sentence = "the same of the weft" },
    { name = "source", kind = "text", default = "", sentence = "who measured, when" },
    { name = "legs", kind = "boolean", default = true,
      sentence = "of woven cards: a virtual trouser tear (some seconds for each family) says what legs take of the work, which is taken out of the energy; false: the energy is twice the mean force" },
  },
  sentence = "From strips pulled to break and tears to a card that breaks. Returns card (with rupture, and its origin in card.provenance), and warp and weft: strength (N/m) and "
    .. "energy (J/m, twice the mean force of the tears after their first quarter, less what legs of a woven card take of it), legs (of that: hysteresis over twice the force, way of the grips per metre of tear, "
    .. "force of a virtual tear with twice the force as energy, over the force, and the band of that, relative), strengths (of the strips that count), left_out (places of breaks at the jaws), tear (N, mean force), modulus (Weibull's, of strips: no part of "
    .. "the card), bands of 95 % for strength, modulus and energy.",
  example = "local r = fabric.lab.rupture{ card=fabric.card 'blend', weft={ strips={ 520, 561, 498, 540, 533 }, width=0.05, tears={ 11.2, 10.6 } }, legs=false }\n"
    .. "assert(math.abs(r.card.rupture.weft.energy - 21.8) < 1e-9 and r.weft.modulus > 10)",
  run = run,
}
