-- The cyclic tensile test of a woven strip, 25.4 x 76.2 mm, 27 elements [williams2010, section 7.2].
--
--   fabricsh scripts/thesis/uniaxial.lua [fabric] [direction] [grips] [steps] [folder]
--
-- Pulled to the displacement of table 3.4, then unloaded until the grip lets go (fig. 3-17). Writes into the folder
-- curve.csv, strip.pvd for ParaView, run.json and curve.svg: the computed curve beside the card's P(E).
local fabric = require "fabric"
local MPa, mm = fabric.units.MPa, fabric.units.mm

local usage = [[
usage: fabricsh uniaxial.lua [fabric] [direction] [grips] [steps] [folder]
  fabric     blend (default), duck, muslin, denim, or the path of a card
  direction  warp (default) or weft
  grips      free (default): the ends contract; clamped: they keep their width
  steps      80 (default), an even number of at least 4
  folder     out/uniaxial-<fabric>-<direction>-<grips> (default)]]

local function refuse(why) error("uniaxial: " .. why .. "\n" .. usage, 0) end

local function choice(place, name, words)
  local word = arg[place] or words[1]
  for _, known in ipairs(words) do
    if word == known then return word end
  end
  refuse(("argument %d (%s): expected %s, got '%s'"):format(place, name, table.concat(words, " or "), word))
end

if #arg > 5 then refuse("expected at most 5 arguments, got " .. #arg) end
local name = arg[1] or "blend"
if name == "-h" or name == "--help" then
  print(usage)
  return
end
local card = fabric.card(name, { bending = "thickness" })
local direction = choice(2, "direction", { "warp", "weft" })
local grips = choice(3, "grips", { "free", "clamped" })
local steps = math.tointeger(tonumber(arg[4] or 80))
if not steps or steps < 4 or steps % 2 ~= 0 then
  refuse(("argument 4 (steps): expected an even integer of at least 4, got '%s'"):format(arg[4]))
end
local folder = arg[5] or ("out/uniaxial-%s-%s-%s"):format(card.name, direction, grips)

-- The closed forms: P(E), its integral U(E), and where unloading from m ends.
local yarn = card[direction]
local function P(E)
  local sum = 0
  for i, d in ipairs(yarn.loading) do sum = sum + d * E ^ i / i end
  return sum
end
local function U(E)
  local sum = 0
  for i, d in ipairs(yarn.loading) do sum = sum + d * E ^ (i + 1) / (i * (i + 1)) end
  return sum
end

local test = fabric.lab.uniaxial { card = card, direction = direction, grips = grips, steps = steps, out = folder }
if fabric.checking() then return end

-- The table: about twenty lines of the curve.
local curve = test.curve
print(("%s, pulled along the %s to %.4g mm, ends %s, %d steps"):format(card.name, direction, test.displacement / mm, grips, steps))
print(("%8s %12s %10s %10s %12s %12s %12s"):format("time s", "displ. mm", "force N", "E", "S MPa", "P(E) MPa", "E lateral"))
local stride = math.max(1, #curve // 20)
for i, row in ipairs(curve) do
  if (i - 1) % stride == 0 or i == #curve then
    local backbone = row.time <= 1 and ("%12.5f"):format(P(row.E) / MPa) or ("%12s"):format ""
    print(("%8.4f %12.4f %10.3f %10.5f %12.5f %s %12.5f"):format(
      row.time, row.displacement / mm, row.force, row.E, row.S / MPa, backbone, row.E_lateral))
  end
end

-- The figure.
local figure = { E = {}, S = {}, backbone = {} }
for i, row in ipairs(curve) do
  figure.E[i], figure.S[i] = row.E, row.S / MPa
  figure.backbone[i] = row.time <= 1 and P(row.E) / MPa or 0 / 0
end
local drawn = fabric.plot {
  file = folder .. "/curve.svg",
  title = ("%s, %s, ends %s"):format(card.name, direction, grips),
  xlabel = "Green-Lagrange strain E",
  ylabel = "second Piola-Kirchhoff stress S, MPa",
  curves = {
    { x = figure.E, y = figure.S, label = "computed" },
    { x = figure.E, y = figure.backbone, label = "P(E) of the card", style = "dashed" },
  },
}
print(("\ncurve   %s/curve.csv\nfigure  %s\nseries  %s/strip.pvd (ParaView)\n"):format(
  folder, drawn and folder .. "/curve.svg" or "none: gnuplot is not installed", folder))

-- Checks. Every wanted value is a closed form of the card.
local peak, last = nil, curve[#curve]
local off_curve, off_ratio, off_slope = 0, 0, 0
for i, row in ipairs(curve) do
  if row.time <= 1 and row.E > 0 then
    off_curve = math.max(off_curve, math.abs(row.S / P(row.E) - 1))
    peak = row
  elseif row.time > 1 and i < #curve then -- the last row is the release: it may lie on the slack side of zero force
    local slope = (peak.S - row.S) / (peak.E - row.E)
    off_slope = math.max(off_slope, math.abs(slope / yarn.unloading - 1))
  end
  if row.E > 0 then off_ratio = math.max(off_ratio, math.abs(row.E_lateral / row.E + yarn.poisson)) end
end
local e = test.displacement / (76.2 * mm)
local m = e + e * e / 2
local checks = {
  { "largest strain E", peak.E, m, relative = 1e-12 },
  -- The grip lets go where the force is zero to 1e-6 of the peak.
  { "force at release / peak force", last.force / peak.force, 0, absolute = 1e-6 },
}
local function check(row) checks[#checks + 1] = row end
if grips == "free" then
  local energy = test.analysis.energy
  check { "S / P(E) - 1, worst of the loading steps", off_curve, 0, absolute = 1e-8 }
  check { "lateral ratio - nu, worst while loading or not", off_ratio, 0, absolute = 1e-8 }
  check { "unloading slope / Du - 1, worst step", off_slope, 0, absolute = 1e-8 }
  check { "peak force, N", peak.force, P(m) * 25.4 * mm * card.thickness * (1 + e), relative = 1e-8 }
  -- The release is located to 1e-6 of the peak force. A yarn that has just gone slack has the small modulus h under
  -- uniaxial stress, so the strain there is known to 1e-6 P(m) (1 + e) / h only.
  local nu12, nu21 = card.warp.poisson, card.weft.poisson
  local h = math.min(nu21 * card.warp.loading[1], nu12 * card.weft.loading[1]) / (direction == "warp" and nu21 or nu12)
  check { "residual strain", last.E, m - P(m) / yarn.unloading, absolute = 1e-6 * P(m) * (1 + e) / h }
  check { "dissipated energy, J", energy.dissipated, test.volume * (U(m) - P(m) ^ 2 / (2 * yarn.unloading)), relative = 1e-8 }
else
  -- Clamped ends stiffen the strip, by no more than 5 %, and never soften it.
  check { "peak S / P(E)", peak.S / P(m), 1.025, absolute = 0.025 }
end
fabric.expect(checks)
