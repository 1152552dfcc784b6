-- From records to intervals of what was not measured, for cloths whose curves are not those of the program's law: an exponential, crimp that is pulled straight
-- before the yarn stretches, and a soft toe with a shear that locks; in bending they become softer or stiffer with the curvature. Each is "measured" (three pulls along
-- warp and weft, three bias pulls, five cantilevers in each direction, with scatter between specimens, slack, noise and the give of the machine), reduced from files as
-- any laboratory's are, and put into budgets of other things: a strip held at both ends and blown by a pressure, the load of a longer strip, the force of a picture
-- frame, the angle of a given overhang. The true values come from the curves themselves.
--
--   fabricsh scripts/lab/other_references.lua [seeds] [samples] [out]      1 24; a figure in out; the table of share/doc/laboratory.md is of scripts/long/lab_other_references.lua
local fabric = require "fabric"
local lab = fabric.lab
local folder = require "fabric.lab.folder"
local random = require "fabric.lab.random"

local seeds, samples = math.tointeger(tonumber(arg[1] or 1)), math.tointeger(tonumber(arg[2] or 24))
if not seeds or seeds < 1 or not samples or samples < 8 then error("usage: fabricsh other_references.lua [seeds >= 1] [samples >= 8] [out]", 0) end
local out = arg[3] or "out/other_references"
local length, width, thickness, give = 0.2, 0.05, 4e-4, 1e-7
local share, specimens, reach = 0.05, 3, 0.1 -- deviation between specimens; largest strain of the pulls

-- Stress S in Pa at Green's strain E, of a crimped yarn: the way z of its wave against a spring, a straight yarn that stretches, force f per unit as parameter.
local function crimped(amplitude, resistance, stretch)
  local function strain(f)
    local z = 2 * amplitude * f / (resistance + 2 * f)
    local e = amplitude ^ 2 - (amplitude - z) ^ 2 + stretch * f
    return e + e * e / 2
  end
  return function(E)
    local low, high = 0, 1
    while strain(high) < E do high = 2 * high end
    for _ = 1, 60 do
      local f = (low + high) / 2
      if strain(f) < E then low = f else high = f end
    end
    return 1e6 * low
  end
end
local function soft_toe(D, at, over)
  return function(E) return D * (E - at + math.sqrt((E - at) ^ 2 + over ^ 2) - math.sqrt(at ^ 2 + over ^ 2) + at) / 2 end
end
local cloths = {
  { name = "exponential", warp = function(E) return 0.5e6 * (math.exp(24 * E) - 1) end, weft = function(E) return 0.9e6 * (math.exp(15 * E) - 1) end,
    shear = function(E) return 2.5e4 * (math.exp(6 * E) - math.exp(-6 * E)) / 2 end,
    curvature = function(M) return 75 * (math.exp(M / 9e-4) - math.exp(-M / 9e-4)) end },
  { name = "crimp", warp = crimped(0.2, 9, 8e-3), weft = crimped(0.26, 3, 12e-3), shear = function(E) return 1.2e4 * (1 - 2 / (math.exp(2 * E / 0.06) + 1)) + 6e4 * E end,
    curvature = function(M) return M / 4e-6 * (1 - 0.5 / (1 + M / 3e-4)) end },
  { name = "toe and lock", warp = soft_toe(150e6, 0.03, 0.01), weft = soft_toe(60e6, 0.02, 0.015), shear = function(E) return 5e4 * E + 8e5 * E ^ 3 end,
    curvature = function(M) return M / 3e-6 / math.sqrt(1 + M / 4e-4) end },
}

-- --- the true values ---
local function bisect(f, low, high)
  for _ = 1, 80 do
    local x = (low + high) / 2
    if f(x) < 0 then low = x else high = x end
  end
  return low
end
local pressure = 4e3
-- Height of the arc in which the tension per width, S h stretch, is the pressure times the radius.
local function blown(S)
  local half = bisect(function(a)
    local stretch = a / math.sin(a)
    return S((stretch ^ 2 - 1) / 2) * thickness * stretch - pressure * length / 2 / math.sin(a)
  end, 1e-3, 1.5)
  return length / 2 * math.tan(half / 2)
end
local asked_pull, asked_shear = 0.06, 0.2
local function load_of(S) return S(asked_pull) * 0.08 * thickness * math.sqrt(1 + 2 * asked_pull) end -- of a strip 80 mm wide
local frame = 0.2
local function way_of(E12) return 2 * frame * math.cos(math.pi / 4 - math.asin(2 * E12) / 2) - math.sqrt(2) * frame end
local function frame_force(card) return lab.picture_frame { displacement = { way_of(asked_shear / 2), way_of(asked_shear) }, card = card, thickness = thickness, frame = frame, cloth = 0.16 }.force[2] end
-- The force is that of the work: S12 times the derivative of 2 E12, the sine of the shear angle, over the way.
local function true_frame_force(S)
  local d = 1e-6
  return S(asked_shear) * 0.16 ^ 2 * thickness * 4 * d / (way_of(asked_shear + d) - way_of(asked_shear - d))
end

local mass, plane, asked_overhang = 0.2, 41.5, 0.028 -- kg/m^2; degrees; m
-- The angle (degrees) of the chord of an overhang: the moment per width is the weight beyond times its lever, integrated back from the tip, whose slope is found.
local function angle_of(curvature, overhang)
  local steps, x, z = 200, nil, nil
  bisect(function(tip)
    local slope, moment, ds = tip, 0, overhang / steps
    x, z = 0, 0
    for k = 1, steps do
      local dM = mass * 9.80665 * (k - 0.5) * ds * math.cos(slope) * ds
      slope = slope - curvature(moment + dM / 2) * ds
      x, z, moment = x + math.cos(slope) * ds, z + math.sin(slope) * ds, moment + dM
    end
    return slope
  end, 0, math.pi / 2)
  return math.deg(math.atan(z, x))
end
local function bending_length(curvature)
  return bisect(function(overhang) return angle_of(curvature, overhang) - plane end, 5e-3, 0.08) / 2
end

-- --- records ---
local function points(S, top)
  local out = {}
  for k = 0, 40 do out[k + 1] = { top * k / 40, S(top * k / 40) } end
  return out
end
local function write(path, rows)
  local f <close> = assert(io.open(path, "w"))
  f:write "Time (s),Extension (mm),Load (N)\n"
  for k, r in ipairs(rows) do f:write(("%.2f,%.5f,%.5f\n"):format(0.2 * k, 1e3 * r[1], r[2])) end
end
local function measured(cloth, place, draw, of_strips)
  assert(os.execute("mkdir -p '" .. place .. "'"))
  local strips = {} -- all directions alike: what is asked bends along the warp
  for _, direction in ipairs { "warp", "weft", "bias" } do
    local lengths = {}
    for i = 1, 5 do
      local factor = 1 + share * of_strips.normal()
      lengths[i] = ("%.6f"):format(bending_length(function(M) return cloth.curvature(M / factor) end) + 1e-4 * of_strips.normal())
    end
    strips[#strips + 1] = ("%s = { %s }"):format(direction, table.concat(lengths, ", "))
  end
  fabric.write(place .. "/laboratory.lua", ("return { name = '%s', source = 'made, not measured', gauge_length = %g, width = %g, thickness = %g, plies = 1, mass_per_area = %g, compliance = %g, bias = { yarns = 'inextensible' },\n  cantilevers = { %s } }\n"):format(
    cloth.name, length, width, thickness, mass, give, table.concat(strips, ", ")))
  for _, part in ipairs { "warp", "weft" } do
    for i = 1, specimens do
      local rows, factor, slack = {}, 1 + share * draw.normal(), 5e-4 * draw.uniform()
      local free = length + slack
      local function add(u, F) rows[#rows + 1] = { u + give * F + 3e-6 * draw.normal(), F + 0.1 * draw.normal() } end
      for k = 0, 4 do add(slack * k / 5, 0) end
      for k = 0, 80 do
        local stretch = 1 + (math.sqrt(1 + 2 * reach) - 1) * k / 80
        add(slack + free * (stretch - 1), factor * cloth[part]((stretch ^ 2 - 1) / 2) * width * thickness * stretch)
      end
      write(("%s/%s-%d.csv"):format(place, part, i), rows)
    end
  end
  -- Bias pulls by the kinematics of yarns that do not stretch; the card carries the true curve in shear from point to point.
  local carrier = lab.card { name = "carrier", density = 500, thickness = thickness, warp = { loading = { 8e6, 8e8 } }, weft = { loading = { 8e6, 8e8 } },
    shear = { loading = points(cloth.shear, 0.45) }, assume = true }
  local ways = {}
  for k = 0, 80 do ways[k + 1] = 0.026 * k / 80 end
  local F = lab.bias_shear { displacement = ways, card = carrier, width = width, length = length, limit = 60 }.force
  for i = 1, specimens do
    local rows, factor = {}, 1 + share * draw.normal()
    for k, u in ipairs(ways) do rows[k] = { u + 3e-6 * draw.normal(), factor * F[k] + 0.003 * draw.normal() } end
    write(("%s/bias-%d.csv"):format(place, i), rows)
  end
  return folder.reduce(place).card
end

-- --- what is asked of the card ---
local function height(card, cells)
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = length, height = width, nx = cells, ny = 2 }, card = card, warp = 0 }
  m:fix("left", "x y z"):fix("right", "x y z"):pressure(fabric.ramp(pressure, 1))
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local highest = 0
  for i = 1, 3 * (cells + 1) do highest = math.max(highest, math.abs(a:node(i).uz)) end
  return highest
end
local function asked(p)
  return { ["height, mm"] = 1e3 * height(p.card, p.mesh), ["load, N"] = lab.uniaxial { card = p.card, direction = "weft", displacement = 0.3 * (math.sqrt(1 + 2 * asked_pull) - 1), width = 0.08, length = 0.3, grips = "free",
    unload = false, cells = { 2, 3 }, steps = 4 }.peak.force, ["frame, N"] = frame_force(p.card),
    ["overhang, degrees"] = lab.cantilever { card = p.card, overhang = asked_overhang, cells = p.mesh }.angle }
end

if fabric.checking() then return end
local here = os.tmpname()
os.remove(here)
local quantities, rows, checks = { "height, mm", "load, N", "frame, N", "overhang, degrees" }, {}, {}
for _, cloth in ipairs(cloths) do
  for _, name in ipairs(quantities) do rows[#rows + 1] = { cloth = cloth.name, name = name, inside = 0, width = 0, reference = 0 } end
end
for seed = 1, seeds do
  local at = 0
  for c, cloth in ipairs(cloths) do
    local card = measured(cloth, ("%s/%d-%d"):format(here, seed, c), random(100 * seed + c), random(100 * seed + c + 50))
    local b = fabric.budget { card = card, mesh = { 4, 8, 16 }, samples = samples, shares = false, print = false, seed = seed, run = asked }
    local reference = { ["height, mm"] = 1e3 * blown(cloth.warp), ["load, N"] = load_of(cloth.weft), ["frame, N"] = true_frame_force(cloth.shear), ["overhang, degrees"] = angle_of(cloth.curvature, asked_overhang) }
    for _, name in ipairs(quantities) do
      at = at + 1
      local row, band = rows[at], b.band[name]
      row.reference, row.value, row.low, row.high = reference[name], b.value[name], band.low, band.high
      row.inside = row.inside + (band.low <= reference[name] and reference[name] <= band.high and 1 or 0)
      row.width = row.width + (band.high - band.low) / 2 / reference[name] / seeds
    end
  end
end
os.execute("rm -r '" .. here .. "'")

-- The last seed's intervals, relative to the true values.
local bars, names, inside = { x = {}, y = {}, xerror = { low = {}, high = {} }, style = "points" }, {}, 0
print "cloth          quantity             true    inside     half width   last: value, 95 % interval"
for i, row in ipairs(rows) do
  local place = #rows + 1 - i
  names[place], bars.x[i], bars.y[i] = row.cloth .. ", " .. row.name:match "^%a+", row.value / row.reference, place
  bars.xerror.low[i], bars.xerror.high[i] = row.low / row.reference, row.high / row.reference
  inside = inside + row.inside
  print(("%-14s %-17s %8.4g  %3d of %-3d  %8.1f %%   %.4g, %.4g to %.4g"):format(row.cloth, row.name, row.reference, row.inside, seeds, 100 * row.width, row.value, row.low, row.high))
  checks[#checks + 1] = { ("%s, %s: half the interval over the true value"):format(row.cloth, row.name), row.width, 0, absolute = 0.3 }
end
fabric.plot { file = out .. "/intervals.svg", xlabel = "computed over true", xunit = "%", ynames = names, curves = { bars, { x = { 1, 1 }, y = { 0.5, #rows + 0.5 }, style = "dashed", colour = "black" } },
  size = { 0.12, 0.075 } }
print(("%d of %d inside"):format(inside, #rows * seeds))
checks[#checks + 1] = { "true values outside of their intervals", #rows * seeds - inside, 0, absolute = math.floor(0.1 * #rows * seeds) }
fabric.expect(checks)
