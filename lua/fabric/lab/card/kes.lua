-- fabric.lab.kes_...: the numbers of Kawabata's instruments [kawabata1980] from curves, and a card from the numbers. Curves are in
-- SI; the numbers have the instruments' units: gf/(cm deg), gf/cm, gf cm^2/cm, gf cm/cm, gf cm/cm^2, per cent.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local filled = require "fabric.lab.card.filled"
local lists = require "fabric.lists"

local gf, cm = 9.80665e-3, 1e-2

-- Value at x where the curve first passes it within the rows first..last; nil if it does not.
local function crossing(xs, ys, x, first, last)
  for i = first, last - 1 do
    local a, b = xs[i], xs[i + 1]
    if (a - x) * (b - x) <= 0 and a ~= b then return ys[i] + (ys[i + 1] - ys[i]) * (x - a) / (b - a) end
  end
end

-- Places of the largest and the smallest value.
local function extremes(xs)
  local high, low = 1, 1
  for i, x in ipairs(xs) do
    if x > xs[high] then high = i end
    if x < xs[low] then low = i end
  end
  return high, low
end

-- On the positive side of a cycle 0, +, -, (0 or +): the loading slope between a and b, and the loop's height at each of `widths`. Errors
-- name the call (`what`) and its fields of xs and ys (`field`, `other`).
local function loop(xs, ys, a, b, widths, what, field, other)
  if #xs ~= #ys then define.fail(("%s: field '%s': expected %d numbers, one per %s, got %d"):format(what, other, #xs, field, #ys)) end
  local high, low = extremes(xs)
  local function passing(x, first, last)
    local y = crossing(xs, ys, x, first, last)
    if y then return y end
    define.fail(("%s: field '%s': expected a cycle from 0 beyond %g to the other side and back, got rows from %g to %g"):format(what, field,
      math.max(b, table.unpack(widths)), xs[low] or 0, xs[high] or 0))
  end
  local function up(x) return passing(x, 1, high) end
  local out = { slope = (up(b) - up(a)) / (b - a) }
  for i, x in ipairs(widths) do out[i] = up(x) - passing(x, high, math.max(low, high)) end
  return out
end

-- A cycle 0, reach, -reach, 0 with n rows per quarter.
local function cycle(reach, n)
  local out = {}
  for i = 0, 4 * n do out[i + 1] = reach * (i <= n and i or i <= 3 * n and 2 * n - i or i - 4 * n) / n end
  return out
end

-- Checks that there are measured rows, or a card in their place.
local function card_or(t, call, names)
  for _, name in ipairs(names) do
    if (t[name] == nil) == (t.card == nil) then
      define.fail(("%s: field '%s': expected measured rows, or a card in their place, got %s"):format(call, name, t.card and "both" or "neither"))
    end
  end
  return t.card
end

local by_card = { name = "card", of = "card", optional = true, sentence = "in place of the measured rows: what the instrument would show of it" }
local along = { name = "direction", kind = "text", choices = { "warp", "weft" }, default = "warp", sentence = "that the card is tested along" }

-- Yarns rotate without stretching: E12 = sin(angle) / 2, and the force per width is that of S12.
local function sheared(card)
  local angle, E12 = cycle(8, 800), {}
  for i, a in ipairs(angle) do E12[i] = math.sin(math.rad(a)) / 2 end
  local force = fabric.point(card):path({ E12 = E12 }, { "S12" }).S12
  for i, s in ipairs(force) do force[i] = s * card.thickness * math.cos(math.rad(angle[i])) end
  return angle, force
end

define {
  name = "fabric.lab.kes_shear",
  arguments = {
    { name = "angle", kind = "numbers", unit = "degrees", optional = true, sentence = "of a cycle 0 to 8, to -8, to 0" },
    { name = "force", kind = "numbers", unit = "N/m", optional = true, sentence = "shear force per width" },
    by_card,
  },
  sentence = "G (slope from 0.5 to 2.5 degrees, gf/(cm deg)), 2HG and 2HG5 (gf/cm, height of the loop at 0.5 and 5 degrees); of a card also its "
    .. "curve, angle and force.",
  example = "local k = require 'fabric'.lab.kes_shear{ angle={0, 8, 7.9, -8, 0}, force={0, 8, 6.9, -8, 0} }\nassert(k.G > 0 and k['2HG'] > 0)",
  run = function(t)
    local angle, force = t.angle, t.force
    if card_or(t, "kes_shear", { "angle", "force" }) then angle, force = sheared(t.card) end
    local l = loop(angle, force, 0.5, 2.5, { 0.5, 5 }, "kes_shear", "angle", "force")
    return { G = l.slope * cm / gf, ["2HG"] = l[1] * cm / gf, ["2HG5"] = l[2] * cm / gf, angle = t.card and angle, force = t.card and force }
  end,
}

-- Uniform bending of a piece of cloth, by the card's own bending.
local function bent(card, direction)
  local k, M, point = cycle(250, 500), {}, fabric.point(card)
  for i, x in ipairs(k) do M[i] = direction == "warp" and point:bend({ k11 = x }).M11 or direction == "weft" and point:bend({ k22 = x }).M22 end
  return k, M
end

define {
  name = "fabric.lab.kes_bending",
  arguments = {
    { name = "curvature", kind = "numbers", unit = "1/m", optional = true, sentence = "of a cycle 0 to 250, to -250, to 0" },
    { name = "moment", kind = "numbers", unit = "N", optional = true, sentence = "per width" },
    by_card, along,
    { name = "at", kind = "number", unit = "1/m", above = 0, default = 50, sentence = "curvature of 2HB: 50 or 100, laboratories differ" },
  },
  sentence = "B (slope from 50 to 150 1/m, gf cm^2/cm) and 2HB (gf cm/cm, height of the loop); of a card also its curve, curvature and moment.",
  example = "local k = require 'fabric'.lab.kes_bending{ curvature={0, 250, 240, -250, 0}, moment={0, 2.5e-3, 2e-3, -2.5e-3, 0} }\nassert(k.B > 0 and k['2HB'] > 0)",
  run = function(t)
    local curvature, moment = t.curvature, t.moment
    if card_or(t, "kes_bending", { "curvature", "moment" }) then curvature, moment = bent(t.card, t.direction) end
    local l = loop(curvature, moment, 50, 150, { t.at }, "kes_bending", "curvature", "moment")
    return { B = l.slope / (gf * cm), ["2HB"] = l[1] / gf, curvature = t.card and curvature, moment = t.card and moment }
  end,
}

local function area(xs, ys, first, last)
  local sum = 0
  for i = first, last - 1 do sum = sum + (ys[i] + ys[i + 1]) / 2 * (xs[i + 1] - xs[i]) end
  return sum
end

-- A pull along a yarn with free contraction, to 500 gf/cm and back to zero force.
local function pulled(card, direction)
  local load, rows = 500 * gf / cm, 1000
  local function force(e) return fabric.point(card):uniaxial(direction, e + e * e / 2).S * card.thickness * (1 + e) end
  local low, high = 0, 1e-3
  while force(high) < load do
    low, high = high, 2 * high
    if high > 10 then define.fail(("kes_tensile: field 'card': the %s does not reach 500 gf/cm at any stretch"):format(direction)) end
  end
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if force(middle) < load then low = middle else high = middle end
  end
  local stretch, E, out = {}, {}, {}
  for i = 0, 4 * rows do -- unloading in finer steps, because it is steep
    stretch[i + 1] = high * (i <= rows and i / rows or (4 * rows - i) / (3 * rows))
    E[i + 1] = stretch[i + 1] + stretch[i + 1] ^ 2 / 2
  end
  for i, S in ipairs(fabric.point(card):uniaxial(direction, E, { "S" }).S) do out[i] = math.max(0, S) * card.thickness * (1 + stretch[i]) end
  return stretch, out
end

define {
  name = "fabric.lab.kes_tensile",
  arguments = {
    { name = "stretch", kind = "numbers", optional = true, sentence = "elongation over length, up to the largest load and back" },
    { name = "force", kind = "numbers", unit = "N/m", optional = true, sentence = "per width; KES goes to 500 gf/cm" },
    by_card, along,
  },
  sentence = "EMT (per cent at the largest load), WT (gf cm/cm^2), LT = WT over that of a straight line, RT (per cent of the work that comes back).",
  example = "local k = require 'fabric'.lab.kes_tensile{ stretch={0, 0.05, 0.04}, force={0, 490, 0} }\nassert(math.abs(k.LT - 1) < 1e-12 and math.abs(k.RT - 20) < 1e-9)",
  run = function(t)
    if card_or(t, "kes_tensile", { "stretch", "force" }) then t.stretch, t.force = pulled(t.card, t.direction) end
    if #t.stretch ~= #t.force then
      define.fail(("kes_tensile: field 'force': expected %d numbers, one per stretch, got %d"):format(#t.stretch, #t.force))
    end
    local top = extremes(t.stretch)
    if top == 1 or t.stretch[top] <= 0 or t.force[top] <= 0 then define.fail "kes_tensile: field 'stretch': expected a pull up to a largest load and back" end
    local work, back = area(t.stretch, t.force, 1, top), -area(t.stretch, t.force, top, #t.stretch)
    return { EMT = 100 * t.stretch[top], WT = work / (gf / cm), LT = work / (t.force[top] * t.stretch[top] / 2), RT = 100 * back / work,
      stretch = t.card and t.stretch, force = t.card and t.force }
  end,
}

-- A toe that turns into a straight line, or (LT above 1) a line that bends over, from 0 to 1 in both coordinates, with the mean LT/2:
-- h(x) - h(0) with h = x - a + sqrt((x - a)^2 + b^2), where b is the sharpness of the bend. Returns its points and its largest slope.
local function toe(LT, b)
  local over = LT > 1
  local low = over and 2 - LT or LT
  local function h(x, a) return x - a + math.sqrt((x - a) ^ 2 + b * b) end
  local function at(x, a) return (h(x, a) - h(0, a)) / (h(1, a) - h(0, a)) end
  local function mean(a)
    local sum, n = 0, 200
    for i = 0, n do sum = sum + at(i / n, a) * (i % n == 0 and 1 or i % 2 == 1 and 4 or 2) / (3 * n) end
    return sum
  end
  local left, right = -50, 1
  if mean(right) > low / 2 then return end -- too round for so little work
  for _ = 1, 80 do
    local middle = (left + right) / 2
    if mean(middle) > low / 2 then left = middle else right = middle end
  end
  local a, points = (left + right) / 2, {}
  for i = 0, 40 do points[i + 1] = { i / 40, over and 1 - at(1 - i / 40, a) or at(i / 40, a) } end
  return points, (1 + (1 - a) / math.sqrt((1 - a) ^ 2 + b * b)) / (h(1, a) - h(0, a))
end

-- A loading curve that ends at (E, S) with the work U, for cloth that unloads with the modulus Du: S = d0 E + dn E^(n+1) / (n+1) with
-- the least possible n; otherwise a toe and a straight line, as points. The loading must not become stiffer than the unloading.
local function loading_of(E, S, U, Du, name, LT)
  for n = 1, 3 do
    local dn = (S * E / 2 - U) * 2 * (n + 1) * (n + 2) / (n * E ^ (n + 2))
    local d0 = S / E - dn * E ^ n / (n + 1)
    local steepest = math.max(d0, d0 + dn * E ^ n)
    if d0 > 0 and d0 + dn * E ^ n > 0 and (n == 1 or d0 > 0.02 * S / E) and steepest <= Du then
      local loading = { d0 }
      for k = 2, n do loading[k] = 0.0 end
      loading[n + 1] = dn
      return loading
    end
  end
  for _, b in ipairs { 0.4, 0.2, 0.1, 0.05, 0.02 } do
    local points, steepest = toe(2 * U / (S * E), b)
    if points and steepest * S / E <= 0.99 * Du then
      for _, p in ipairs(points) do p[1], p[2] = p[1] * E, p[2] * S end
      return points
    end
  end
  define.fail(("kes_card: field '%s': no curve has the work of LT %.3g and gives back RT of it: unloading would be softer than loading"):format(name, LT))
end

-- A yarn with the largest load F (N/m) at EMT and the work WT, or LT over that of a straight line: force (1+e) t S, work t int S dE.
local function yarn_of(k, thickness, poisson, name)
  local e, F = k.EMT / 100, 500 * gf / cm
  if (k.WT == nil) == (k.LT == nil) then
    local straight = 5 * k.EMT / 2 -- WT for LT = 1
    if k.WT == nil then define.fail(("kes_card: field '%s.WT': expected WT in gf cm/cm^2, or LT, got neither"):format(name)) end
    if math.abs(k.WT / (k.LT * straight) - 1) > 0.03 then
      define.fail(("kes_card: field '%s.LT': expected %.3g, as WT %.3g and EMT %.3g make it, got %.3g"):format(name, k.WT / straight, k.WT, k.EMT, k.LT))
    end
  end
  local work = k.WT and k.WT * gf / cm or k.LT * F * e / 2
  local E = e + e * e / 2
  local S, U = F / (thickness * (1 + e)), work / thickness
  local Du = S * S / (2 * U * k.RT / 100)
  return { loading = loading_of(E, S, U, Du, name, 2 * work / (F * e)), unloading = Du, poisson = poisson }, E
end

-- Height of the loop at x for a straight backbone of slope D that is loaded to `reach` and unloaded to zero stress at the strain r:
-- below r the backbone of the other side has begun, D r; above it the unloading continues.
local function height(D, reach, r, x)
  if x <= r then return D * r end
  return D * r / (reach - r) * (reach - x)
end

-- Elastic shear with a friction that increases (or decreases) with the angle: straight lines in E12 with the slope D and the limit Y0
-- + Y1 E12. The three measured numbers determine D, Y0 and Y1; the friction is reached within a quarter of a degree.
local function shear_with_friction(k, thickness)
  local function strain(degrees) return math.sin(math.rad(degrees)) / 2 end
  local function stress(number, degrees) return number * gf / cm / (thickness * math.cos(math.rad(degrees))) end
  local near, far, reach = strain(0.5), strain(5), strain(8)
  local at_near, at_far = stress(k["2HG"] / 2, 0.5), stress(k["2HG5"] / 2, 5)
  local growth = (at_far - at_near) / (far - near)
  local at_rest = at_near - growth * near
  local function limit(E) return at_rest + growth * E end
  if limit(reach) <= 0 or at_rest <= 0 then
    define.fail(("kes_card: field 'shear.2HG5': expected a loop that is open from 0 to 8 degrees, got 2HG %.3g and 2HG5 %.3g"):format(k["2HG"], k["2HG5"]))
  end
  -- In loading G = (F(2.5) - F(0.5)) / 2, F = t cos(angle) (D E + limit).
  local E1, E2, c1, c2 = near, strain(2.5), math.cos(math.rad(0.5)), math.cos(math.rad(2.5))
  local D = (2 * k.G * gf / cm / thickness - c2 * limit(E2) + c1 * limit(E1)) / (c2 * E2 - c1 * E1)
  if D <= math.abs(growth) then
    define.fail(("kes_card: field 'shear.2HG5': expected less than 2HG + 4.5 G (%.3g), beyond which cloth would pull itself back, got %.3g"):format(
      k["2HG"] + 4.5 * k.G, k["2HG5"]))
  end
  local sticks = math.max(limit(near / 2) / (near / 2), 2 * limit(reach) / strain(2), 3 * math.abs(growth))
  return { loading = { D }, unloading = D + sticks, measure = "tensor", friction = { stress = at_rest, growth = growth } }, reach,
    ("elastic shear with friction shows 2HG %.3g, 2HG5 %.3g as given"):format(k["2HG"], k["2HG5"])
end

-- A straight backbone of slope D (tensor) cycled to the E12 of 8 degrees, for data with 2HG only: one unloading modulus determines
-- the loop. Returns the part, its reach, and its description in words.
local function shear_of(k, thickness)
  if k["2HG5"] then return shear_with_friction(k, thickness) end
  local D = 2 * k.G * gf / cm * math.deg(1) / thickness
  local function strain(degrees) return math.sin(math.rad(degrees)) / 2 end
  local function stress(number) return number * gf / cm / thickness end
  local reach, near, far = strain(8), strain(0.5), strain(5)
  local h = stress(k["2HG"])
  if h >= D * reach then
    define.fail(("kes_card: field 'shear.2HG': expected below G times 8 degrees (%.3g), got %.3g"):format(8 * k.G, k["2HG"]))
  end
  local r = h / D
  if r < near then r = reach * h / (D * (reach - near) + h) end
  local function shown(x) return height(D, reach, r, x) * thickness * cm / gf end
  local words = ("straight shear shows 2HG %.3g (given %.3g), 2HG5 %.3g (not given)"):format(shown(near), k["2HG"], shown(far))
  return { loading = { D }, unloading = D * reach / (reach - r), measure = "tensor" }, reach, words
end

local function bending_of(b)
  local out = {}
  for _, name in ipairs { "warp", "weft" } do
    out[name] = b[name].B * gf * cm
    if b[name]["2HB"] then out["friction_" .. name] = { moment = b[name]["2HB"] * gf / 2, curvature = b.build_up or 10 } end
  end
  out.twist = b.twist or math.sqrt(out.warp * out.weft) / 2 -- as for a plate without lateral contraction
  return out
end

-- KES presses from 0.5 to 50 gf/cm^2; T is the thickness at the former.
local light, heavy = 0.5 * gf / cm ^ 2, 50 * gf / cm ^ 2

-- Points {gap, pressure} with the work WC and the linearity LC: from T on a toe and a straight line. fibres: what they alone fill, m.
local function compression_of(c, thickness, fibres)
  local way = 2 * c.WC * gf / cm / (c.LC * heavy)
  if thickness - way <= fibres then
    define.fail(("kes_card: field 'compression.WC': expected less than %.3g, at which LC %.3g leaves of T %.4g mm the %.3g mm that the fibres alone fill (W over fibre_density), got %.3g"):format(
      c.LC * heavy * (thickness - fibres) / 2 * cm / gf, c.LC, thickness * 1e3, fibres * 1e3, c.WC))
  end
  local start = light / heavy
  local mean = (c.LC / 2 - start) / (1 - start)
  -- The roundest toe has the steepest beginning, so that contact begins nearest to T: light pressure is all that is left there.
  for k = 0, 40 do
    local points = mean > 0 and toe(2 * mean, 3.2 * 0.87 ^ k)
    if points then
      for _, p in ipairs(points) do p[1], p[2] = thickness - way * p[1], light + (heavy - light) * p[2] end
      return points
    end
  end
  define.fail(("kes_card: field 'compression.LC': expected a linearity that a toe and a straight line from 0.5 to 50 gf/cm^2 can have, got %.3g"):format(c.LC))
end

-- Below the lightest pressure nothing is measured, and a soft beginning runs out far beyond T.
local function warn_far(card, c)
  local free, T = kernels.free_thickness(card), card.thickness
  if free > 1.5 * T then
    fabric.warn(("kes_card: field 'compression': contact begins at %.3g mm, %.2g times T: as soft as LC %.3g and WC %.3g have it at 0.5 gf/cm^2, pressure runs out only there"):format(
      free * 1e3, free / T, c.LC, c.WC))
  end
end

-- WC and LC of a card whose measured points span the instrument's pressures; nil otherwise. Contact gives back all of it.
local function compressed(card)
  local c = card.compression
  if not c then return end
  local gaps, pressures = {}, {}
  for i = #c, 1, -1 do gaps[#gaps + 1], pressures[#pressures + 1] = -c[i][1], c[i][2] end
  if pressures[1] > light * 1.001 or pressures[#pressures] < heavy * 0.999 then return end
  local from, to = crossing(pressures, gaps, math.max(light, pressures[1]), 1, #gaps), crossing(pressures, gaps, math.min(heavy, pressures[#gaps]), 1, #gaps)
  local xs, ys = { from }, { light }
  for i, x in ipairs(gaps) do
    if x > from and x < to then xs[#xs + 1], ys[#ys + 1] = x, pressures[i] end
  end
  xs[#xs + 1], ys[#ys + 1] = to, heavy
  local work = area(xs, ys, 1, #xs)
  return { WC = work * cm / gf, LC = work / (heavy * (to - from) / 2), RC = 100.0 }
end

local function compression_words(c)
  return c and ("; compression LC %.3g, WC %.3g as given, RC %.3g not: contact gives back all of it"):format(c.LC, c.WC, c.RC) or ""
end

-- --- what is not measured ---

-- Of two yarns the one that was pulled stands for the other; without pulls both are as the library's.
local function fill_yarn(fields, provenance, ranges, name, given, poisson)
  local other = name == "warp" and "weft" or "warp"
  if given[other] then
    fields[name], fields.tested[name] = { loading = fields[other].loading, unloading = fields[other].unloading }, fields.tested[other]
    provenance[name .. ".loading"], ranges[name .. ".loading"] = filled.source_as_other(other)
    provenance[name .. ".unloading"] = "assumed: as the " .. other .. "'s"
  else
    fields[name], fields.tested[name] = filled.part(name, fields.thickness)
    provenance[name .. ".loading"], ranges[name .. ".loading"] = filled.source(name)
    provenance[name .. ".unloading"] = filled.unloading_source
  end
  fields[name].poisson = poisson
end

-- Adds the parts for which the sheet has no numbers, and says of each number where it comes from.
local function fill(t, fields)
  local provenance, ranges, missing = {}, {}, {}
  for _, name in ipairs { "warp", "weft" } do
    if not t[name] then
      missing[#missing + 1] = name
      fill_yarn(fields, provenance, ranges, name, t, t.poisson and t.poisson[name] or filled.poisson)
    end
    if not t.poisson then
      provenance[name .. ".poisson"], ranges[name .. ".poisson"] = filled.poisson_source, filled.poisson_range
    end
  end
  if not t.shear then
    missing[#missing + 1] = "shear"
    fields.shear, fields.tested.shear = filled.part("shear", fields.thickness)
    provenance["shear.loading"], ranges["shear.loading"] = filled.source "shear"
    provenance["shear.unloading"] = filled.unloading_source
  end
  if #missing == 0 and t.poisson then return "" end
  for _, name in ipairs { "warp", "weft", "shear" } do
    provenance[name .. ".loading"] = provenance[name .. ".loading"] or "measured: KES"
    provenance[name .. ".unloading"] = provenance[name .. ".unloading"] or "measured: KES"
  end
  if t.bending then
    local loops = t.bending.warp["2HB"] and t.bending.weft["2HB"]
    provenance.bending = loops and "measured: B, 2HB" or "measured: B"
    if not t.bending.twist then provenance["bending.twist"] = "assumed: half of the mean" end
  end
  fields.provenance, fields.ranges = provenance, ranges
  return #missing == 0 and "" or ("; %s assumed: not on the sheet"):format(table.concat(missing, ", "))
end

local function row(name, unit, sentence, more)
  return lists.copy({ name = name, kind = "number", unit = unit, above = 0, sentence = sentence }, more)
end
local pull_rows = { row("EMT", "per cent", "stretch at 500 gf/cm"), row("WT", "gf cm/cm^2", "work; or LT", { optional = true }), row("LT", "", "work over that of a straight line, in place of WT", { optional = true, high = 2 }), row("RT", "per cent", "of the work that is recovered", { high = 100 }) }
local bend_rows = { row("B", "gf cm^2/cm", "rigidity"), row("2HB", "gf cm/cm", "height of the loop", { optional = true }) }

define {
  name = "fabric.lab.kes_card",
  arguments = {
    { name = "name", kind = "text", sentence = "of the fabric" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "of the cloth; or T" },
    { name = "density", kind = "number", unit = "kg/m^3", above = 0, optional = true, sentence = "mass over volume; or W" },
    row("T", "mm", "thickness at 0.5 gf/cm^2, in place of thickness", { optional = true }),
    row("W", "mg/cm^2", "weight, in place of density", { optional = true }),
    { name = "warp", kind = "fields", optional = true, rows = pull_rows, sentence = "pull along the warp; without it as of the weft, without both as of the library's cloths" },
    { name = "weft", kind = "fields", optional = true, rows = pull_rows, sentence = "pull along the weft, likewise" },
    { name = "shear", kind = "fields", optional = true, sentence = "with 2HG5 elastic shear with friction that grows with the angle; without it as of the library's cloths",
      rows = { row("G", "gf/(cm deg)", "slope"), row("2HG", "gf/cm", "height of the loop at 0.5 degrees"),
        row("2HG5", "gf/cm", "at 5 degrees", { optional = true }) } },
    { name = "bending", kind = "fields", optional = true, sentence = "without it as of the thickness",
      rows = { { name = "warp", kind = "fields", rows = bend_rows, sentence = "along the warp" }, { name = "weft", kind = "fields", rows = bend_rows, sentence = "along the weft" },
        row("twist", "N.m", "rigidity; default: half of the mean", { optional = true }), row("build_up", "1/m", "curvature over which friction builds up", { default = 10 }) } },
    { name = "compression", kind = "fields", optional = true, sentence = "what contact presses with; RC is kept in the card's source, since contact gives back all",
      rows = { row("LC", "", "linearity"), row("WC", "gf cm/cm^2", "work"), row("RC", "per cent", "of the work that is recovered", { high = 100 }) } },
    row("fibre_density", "kg/m^3", "of what the yarns are made of, as in fabric.woven: cloth is pressed no thinner than its fibres", { optional = true }),
    { name = "poisson", kind = "fields", optional = true, sentence = "KES does not measure them; default 0.4, assumed",
      rows = { { name = "warp", kind = "number", sentence = "as in fabric.woven" }, { name = "weft", kind = "number", sentence = "as in fabric.woven" } } },
  },
  sentence = "A card that reproduces the given KES numbers; its source says which it represents, and which not. fabric.lab.kes_sheet reads them back. Any part of the sheet will "
    .. "do, bending alone too: what is missing is taken from the cards of the library, marked assumed in card.provenance with the range in which it may lie, and varied by fabric.budget.",
  example = "local c = require 'fabric'.lab.kes_card{ name='shirt', thickness=4e-4, density=400, warp={EMT=4, WT=9, RT=55}, weft={EMT=6, WT=13, RT=50},\n"
    .. "  shear={G=0.8, ['2HG']=1.5}, poisson={warp=0.2, weft=0.2} }\nassert(c:check().ok)",
  run = function(t)
    for _, pair in ipairs { { "thickness", "m", "T" }, { "density", "kg/m^3", "W" } } do
      local field, unit, short = table.unpack(pair)
      if (t[field] == nil) == (t[short] == nil) then
        define.fail(("kes_card: field '%s': expected a positive number in %s, or field '%s', got %s"):format(field, unit, short, t[field] and "both" or "neither"))
      end
    end
    t.thickness = t.thickness or t.T * 1e-3
    t.density = t.density or t.W * 1e-2 / t.thickness
    if not (t.warp or t.weft or t.shear or t.bending) then
      define.fail "kes_card: expected the numbers of one test at least: warp, weft, shear or bending"
    end
    local fields = { name = t.name, density = t.density, thickness = t.thickness, tested = {}, bending = t.bending and bending_of(t.bending), fibre_density = t.fibre_density }
    for _, name in ipairs { "warp", "weft" } do
      if t[name] then fields[name], fields.tested[name] = yarn_of(t[name], t.thickness, t.poisson and t.poisson[name] or filled.poisson, name) end
    end
    local loop_words = ""
    if t.shear then
      fields.shear, fields.tested.shear, loop_words = shear_of(t.shear, t.thickness)
      loop_words = "; " .. loop_words
    end
    local assumed_words = fill(t, fields)
    fields.source = "from KES numbers; Poisson ratios " .. (t.poisson and "given" or "assumed") .. loop_words .. compression_words(t.compression) .. assumed_words
    local card = fabric.woven(fields)
    if not t.compression then return card end
    local _, fibres = kernels.free_thickness(card)
    fields.compression = compression_of(t.compression, t.thickness, fibres)
    card = fabric.woven(fields)
    warn_far(card, t.compression)
    return card
  end,
}

define {
  name = "fabric.lab.kes_sheet",
  arguments = { { name = "card", of = "card", sentence = "the fabric" } },
  sentence = "The KES sheet of a card by virtual tests, as fabric.lab.kes_card takes it: warp and weft (EMT LT WT RT), shear (G 2HG 2HG5), bending "
    .. "(warp and weft, B 2HB; where the card has its own), compression (LC WC RC; where the card's goes from 0.5 to 50 gf/cm^2), T (mm), W (mg/cm^2).",
  example = "local lab = require 'fabric'.lab\nlocal card = lab.kes_card{ name='shirt', T=0.4, W=16, warp={EMT=4, LT=0.5, RT=55}, weft={EMT=6, WT=10, RT=50},\n"
    .. "  shear={G=0.8, ['2HG']=1.5, ['2HG5']=3}, poisson={warp=0.2, weft=0.2} }\nlocal k = lab.kes_sheet{ card=card }\n"
    .. "assert(math.abs(k.warp.LT / 0.5 - 1) < 0.03 and math.abs(k.shear['2HG5'] / 3 - 1) < 0.03)",
  run = function(t)
    local card, out = t.card, {}
    local function numbers(r, names)
      local row = {}
      for _, name in ipairs(names) do row[name] = r[name] end
      return row
    end
    for _, name in ipairs { "warp", "weft" } do
      out[name] = numbers(fabric.lab.kes_tensile { card = card, direction = name }, { "EMT", "LT", "WT", "RT" })
      if card.bending then
        out.bending = out.bending or {}
        out.bending[name] = numbers(fabric.lab.kes_bending { card = card, direction = name }, { "B", "2HB" })
      end
    end
    out.shear = numbers(fabric.lab.kes_shear { card = card }, { "G", "2HG", "2HG5" })
    out.compression = compressed(card)
    out.T, out.W = card.thickness * 1e3, card.density * card.thickness * 1e2
    return out
  end,
}
