-- fabric.lab.kes_...: the numbers of Kawabata's instruments [kawabata1980] from curves, and a card from the numbers. Curves are
-- in SI; the numbers are in the instruments' units: gf/(cm deg), gf/cm, gf cm^2/cm, gf cm/cm, gf cm/cm^2, per cent.
local fabric = require "fabric"
local define = require "fabric.define"

local gf, cm = 9.80665e-3, 1e-2

-- Value at x where the curve passes it within rows first..last; nil when it does not.
local function crossing(xs, ys, x, first, last)
  for i = first, last - 1 do
    local a, b = xs[i], xs[i + 1]
    if (a - x) * (b - x) <= 0 and a ~= b then return ys[i] + (ys[i + 1] - ys[i]) * (x - a) / (b - a) end
  end
end

local function extremes(xs)
  local high, low = 1, 1
  for i, x in ipairs(xs) do
    if x > xs[high] then high = i end
    if x < xs[low] then low = i end
  end
  return high, low
end

-- Slope between a and b going up, and the height of the loop at each of `widths`, on the positive side of a cycle 0, +, -, (0 or +).
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

define {
  name = "fabric.lab.kes_shear",
  arguments = {
    { name = "angle", kind = "numbers", unit = "degrees", sentence = "of a cycle 0 to 8, to -8, to 0" },
    { name = "force", kind = "numbers", unit = "N/m", sentence = "shear force per width" },
  },
  sentence = "G (slope from 0.5 to 2.5 degrees, gf/(cm deg)), 2HG and 2HG5 (gf/cm, height of the loop at 0.5 and 5 degrees).",
  example = "local k = require 'fabric'.lab.kes_shear{ angle={0, 8, 7.9, -8, 0}, force={0, 8, 6.9, -8, 0} }\nassert(k.G > 0 and k['2HG'] > 0)",
  run = function(t)
    local l = loop(t.angle, t.force, 0.5, 2.5, { 0.5, 5 }, "kes_shear", "angle", "force")
    return { G = l.slope * cm / gf, ["2HG"] = l[1] * cm / gf, ["2HG5"] = l[2] * cm / gf }
  end,
}

define {
  name = "fabric.lab.kes_bending",
  arguments = {
    { name = "curvature", kind = "numbers", unit = "1/m", sentence = "of a cycle 0 to 250, to -250, to 0" },
    { name = "moment", kind = "numbers", unit = "N", sentence = "per width" },
    { name = "at", kind = "number", unit = "1/m", above = 0, default = 50, sentence = "curvature of 2HB: 50 or 100, laboratories differ" },
  },
  sentence = "B (slope from 50 to 150 1/m, gf cm^2/cm) and 2HB (gf cm/cm, height of the loop).",
  example = "local k = require 'fabric'.lab.kes_bending{ curvature={0, 250, 240, -250, 0}, moment={0, 2.5e-3, 2e-3, -2.5e-3, 0} }\nassert(k.B > 0 and k['2HB'] > 0)",
  run = function(t)
    local l = loop(t.curvature, t.moment, 50, 150, { t.at }, "kes_bending", "curvature", "moment")
    return { B = l.slope / (gf * cm), ["2HB"] = l[1] / gf }
  end,
}

local function area(xs, ys, first, last)
  local sum = 0
  for i = first, last - 1 do sum = sum + (ys[i] + ys[i + 1]) / 2 * (xs[i + 1] - xs[i]) end
  return sum
end

define {
  name = "fabric.lab.kes_tensile",
  arguments = {
    { name = "stretch", kind = "numbers", sentence = "elongation over length, up to the largest load and back" },
    { name = "force", kind = "numbers", unit = "N/m", sentence = "per width; KES goes to 500 gf/cm" },
  },
  sentence = "EMT (per cent at the largest load), WT (gf cm/cm^2), LT = WT over that of a straight line, RT (per cent of the work that comes back).",
  example = "local k = require 'fabric'.lab.kes_tensile{ stretch={0, 0.05, 0.04}, force={0, 490, 0} }\nassert(math.abs(k.LT - 1) < 1e-12 and math.abs(k.RT - 20) < 1e-9)",
  run = function(t)
    if #t.stretch ~= #t.force then
      define.fail(("kes_tensile: field 'force': expected %d numbers, one per stretch, got %d"):format(#t.stretch, #t.force))
    end
    local top = extremes(t.stretch)
    if top == 1 or t.stretch[top] <= 0 or t.force[top] <= 0 then define.fail "kes_tensile: field 'stretch': expected a pull up to a largest load and back" end
    local work, back = area(t.stretch, t.force, 1, top), -area(t.stretch, t.force, top, #t.stretch)
    return { EMT = 100 * t.stretch[top], WT = work / (gf / cm), LT = work / (t.force[top] * t.stretch[top] / 2), RT = 100 * back / work }
  end,
}

-- S = d0 E + d1 E^2/2 with the largest load F (N/m) at EMT and the work WT: force (1+e) t S, work t (d0 E^2/2 + d1 E^3/6).
local function yarn_of(k, thickness, poisson, name)
  local e, F, work = k.EMT / 100, 500 * gf / cm, k.WT * gf / cm
  local E = e + e * e / 2
  local S, U = F / (thickness * (1 + e)), work / thickness
  local d1 = (S * E / 2 - U) * 12 / E ^ 3
  local d0 = S / E - d1 * E / 2
  if d0 <= 0 then
    define.fail(("kes_card: field '%s': WT is too small for a curve with one bend (LT below 2/3): expected at least %.3g, got %.3g"):format(
      name, S * E / 3 * thickness * cm / gf, k.WT))
  end
  return { loading = { d0, d1 }, unloading = S * S / (2 * U * k.RT / 100), poisson = poisson }, E
end

-- Height of the loop at x of a straight backbone of slope D that goes to `reach` and back to the strain r without stress: below r the
-- other side's backbone has begun, D r; above it still unloads.
local function height(D, reach, r, x)
  if x <= r then return D * r end
  return D * r / (reach - r) * (reach - x)
end

-- The strain without stress whose loop misses the given heights least, in squares of their logarithms.
local function residual_strain(D, reach, wanted)
  local function miss(r)
    local sum = 0
    for _, w in ipairs(wanted) do sum = sum + math.log(height(D, reach, r, w.x) / w.height) ^ 2 end
    return sum
  end
  local best, n = 1, 2000
  for i = 1, n - 1 do
    if miss(reach * i / n) < miss(reach * best / n) then best = i end
  end
  -- Golden section: the height at either place rises with r.
  local golden = (math.sqrt(5) - 1) / 2
  local low, high = reach * (best - 1) / n, reach * (best + 1) / n
  for _ = 1, 80 do
    local left, right = high - golden * (high - low), low + golden * (high - low)
    if miss(left) < miss(right) then high = right else low = left end
  end
  return (low + high) / 2
end

-- A straight backbone of slope D (tensor) cycled to E12 of 8 degrees. It has one number for the loop: 2HG alone is met, 2HG and
-- 2HG5 as well as can be. Returns the part, its reach, and what it shows in words.
local function shear_of(k, thickness)
  local D = 2 * k.G * gf / cm * math.deg(1) / thickness
  local function strain(degrees) return math.sin(math.rad(degrees)) / 2 end
  local function stress(number) return number * gf / cm / thickness end
  local reach, near, far = strain(8), strain(0.5), strain(5)
  local h = stress(k["2HG"])
  if h >= D * reach then
    define.fail(("kes_card: field 'shear.2HG': expected below G times 8 degrees (%.3g), got %.3g"):format(8 * k.G, k["2HG"]))
  end
  local r = h / D
  if k["2HG5"] then
    r = residual_strain(D, reach, { { x = near, height = h }, { x = far, height = stress(k["2HG5"]) } })
  elseif r < near then
    r = reach * h / (D * (reach - near) + h)
  end
  local function shown(x) return height(D, reach, r, x) * thickness * cm / gf end
  local words = ("straight shear shows 2HG %.3g (given %.3g), 2HG5 %.3g (%s)"):format(shown(near), k["2HG"], shown(far),
    k["2HG5"] and ("given %.3g"):format(k["2HG5"]) or "not given")
  return { loading = { D }, unloading = D * reach / (reach - r), measure = "tensor" }, reach, words
end

local function bending_of(b)
  local out = {}
  for _, name in ipairs { "warp", "weft" } do
    out[name] = b[name].B * gf * cm
    if b[name]["2HB"] then out["friction_" .. name] = { moment = b[name]["2HB"] * gf / 2, curvature = b.build_up or 10 } end
  end
  out.twist = b.twist or math.sqrt(out.warp * out.weft) / 2 -- as a plate without contraction twists
  return out
end

local function row(name, unit, sentence, more)
  local out = { name = name, kind = "number", unit = unit, above = 0, sentence = sentence }
  for key, value in pairs(more or {}) do out[key] = value end
  return out
end
local pull_rows = { row("EMT", "per cent", "stretch at 500 gf/cm"), row("WT", "gf cm/cm^2", "work"), row("RT", "per cent", "of it that comes back", { high = 100 }) }
local bend_rows = { row("B", "gf cm^2/cm", "rigidity"), row("2HB", "gf cm/cm", "height of the loop", { optional = true }) }

define {
  name = "fabric.lab.kes_card",
  arguments = {
    { name = "name", kind = "text", sentence = "of the fabric" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "of the cloth" },
    { name = "density", kind = "number", unit = "kg/m^3", above = 0, sentence = "mass over volume" },
    { name = "warp", kind = "fields", rows = pull_rows, sentence = "pull along the warp" },
    { name = "weft", kind = "fields", rows = pull_rows, sentence = "pull along the weft" },
    { name = "shear", kind = "fields", sentence = "2HG and 2HG5 are met as well as one unloading modulus can",
      rows = { row("G", "gf/(cm deg)", "slope"), row("2HG", "gf/cm", "height of the loop at 0.5 degrees"),
        row("2HG5", "gf/cm", "at 5 degrees", { optional = true }) } },
    { name = "bending", kind = "fields", optional = true, sentence = "without it as of the thickness",
      rows = { { name = "warp", kind = "fields", rows = bend_rows, sentence = "along the warp" }, { name = "weft", kind = "fields", rows = bend_rows, sentence = "along the weft" },
        row("twist", "N.m", "rigidity; default: half of the mean", { optional = true }), row("build_up", "1/m", "curvature over which friction builds up", { default = 10 }) } },
    { name = "poisson", kind = "fields", sentence = "KES does not measure them",
      rows = { { name = "warp", kind = "number", sentence = "as in fabric.woven" }, { name = "weft", kind = "number", sentence = "as in fabric.woven" } } },
  },
  sentence = "A card that shows the given KES numbers: tensile curve with one bend, straight shear, whose source says what of 2HG and 2HG5 is left.",
  example = "local c = require 'fabric'.lab.kes_card{ name='shirt', thickness=4e-4, density=400, warp={EMT=4, WT=9, RT=55}, weft={EMT=6, WT=13, RT=50},\n"
    .. "  shear={G=0.8, ['2HG']=1.5}, poisson={warp=0.2, weft=0.2} }\nassert(c:check().ok)",
  run = function(t)
    local warp, warp_reach = yarn_of(t.warp, t.thickness, t.poisson.warp, "warp")
    local weft, weft_reach = yarn_of(t.weft, t.thickness, t.poisson.weft, "weft")
    local shear, shear_reach, loop_words = shear_of(t.shear, t.thickness)
    return fabric.woven { name = t.name, source = "from KES numbers; Poisson ratios given; " .. loop_words, density = t.density, thickness = t.thickness, warp = warp,
      weft = weft, shear = shear, tested = { warp = warp_reach, weft = weft_reach, shear = shear_reach }, bending = t.bending and bending_of(t.bending) }
  end,
}
