-- A skirt of four panels with darts and a waist band, worn by hips with two legs that walk: cut flat, wrapped around the hips, sewn at the sides, darts
-- drawn together, held by an elastic waist band, brought to rest, and walked in. Printed is what it does to the body and its wearer.
--
--   fabricsh skirt.lua [blend|duck|muslin|denim] [size of elements, mm] [steps walked] [time of a step, s] [folder, or -] [swing of the legs, degrees]
--
-- Beyond some 28 degrees the legs reach the cloth: give them time, as in `skirt.lua duck 40 1 0.4 - 32`.
-- warns: a finer mesh folds
local fabric = require "fabric"
local mm = fabric.units.mm
local cloth, size, steps, stroke, out = arg[1] or "blend", (tonumber(arg[2]) or 60) * mm, tonumber(arg[3]) or 1, tonumber(arg[4]) or 0.06, arg[5] ~= "-" and arg[5] or nil
local card = fabric.card(cloth, { bending = "estimated" })
local dressed, swing = 0.07, tonumber(arg[6]) or 20 -- s: the skirt rests; degrees: of a leg, to the front and to the back
local duration = dressed + steps * stroke

-- The wearer stands along z, the front is -y. Hips from the waist (z = 0) downwards; each leg is a cone that turns about its hip joint.
local waist, hip, drop = 0.105, 0.150, 0.20 -- radii of waist and hips; hips below the waist, m
local hips, hips_mesh = fabric.rigid.torso { name = "hips", around = 32, sections = {
  { -drop - 0.05, 0.145, 0.145 }, { -drop, hip, hip }, { -0.08, 0.128, 0.128 }, { 0, waist, waist }, { 0.08, waist, waist } } }
hips_mesh:set("waist", function(_, _, z) return z > -0.04 and z < 0.04 end)
hips_mesh:set("hip", function(_, _, z) return z < -0.1 end)
local legs, leg_mesh = {}, {}
for k, x in ipairs { -0.075, 0.075 } do
  legs[k], leg_mesh[k] = fabric.rigid.torso { name = k == 1 and "right leg" or "left leg", around = 24, from = { x, 0, -drop }, axis = { 0, 0, -1 },
    sections = { { 0, 0.07, 0.07 }, { 0.3, 0.06, 0.06 }, { 0.6, 0.045, 0.045 } } }
  leg_mesh[k]:set("front of the thigh", function(_, y, z) return y < 0 and z > -drop - 0.3 end)
end

-- Each panel is the fourth part of a cone from waist to hem. The cone is wider than the waist by what the darts take in.
local long, flare = 0.5, 9 -- m, along the surface; degrees
local ease, dart_deep = 7 * mm + size / 20 + size ^ 2 / 8 / hip, 0.11 -- room between hips and cone, chords of elements included
local narrow = hip + ease - (drop - 0.02) * math.tan(math.rad(flare)) -- radius of the cone at the waist
local taken = math.pi / 2 * (narrow - waist - 1 * mm - size ^ 2 / 8 / waist) / 2 -- width of a dart, two in each panel; chords of elements are inside of their arcs
local apex = narrow / math.sin(math.rad(flare))
local function on_ring(rho, share) -- share of the panel's width, 0 to 1
  local turn = math.pi / 2 * math.sin(math.rad(flare)) * (share - 0.5)
  return { rho * math.sin(turn), apex - rho * math.cos(turn) }
end
local function dart(share)
  local half = taken / 2 / (math.pi / 2 * narrow)
  return { from = on_ring(apex, share - half), tip = on_ring(apex + dart_deep, share), to = on_ring(apex, share + half), name = share < 0.5 and "dart_a" or "dart_b" }
end
local function panel(azimuth)
  local mesh = fabric.mesh.panel { size = size, grain = 90, darts = { dart(0.3), dart(0.7) }, outline = {
    on_ring(apex, 0),
    { arc = { through = on_ring(apex, 0.5), to = on_ring(apex, 1) }, name = "waist" },
    { on_ring(apex + long, 1)[1], on_ring(apex + long, 1)[2], name = "right" },
    { arc = { through = on_ring(apex + long, 0.5), to = on_ring(apex + long, 0) }, name = "hem" },
    { name = "left" },
  } }
  local turn = math.rad(azimuth)
  return mesh:wrap { cone = { radius = narrow, angle = -flare, axis = { 0, 0, 1 }, from = { 0, 0, -0.02 }, towards = { math.cos(turn), math.sin(turn), 0 } } }
end
local names, bodies = { "right_back", "left_back", "left_front", "right_front" }, {} -- clockwise, seen from above
for k, name in ipairs(names) do bodies[k] = { name = name, mesh = panel(180 - 45 - 90 * (k - 1)), card = card } end

local m = fabric.model { bodies = bodies, points = 1 }
m:gravity { 0, 0, -9.81 }
for k, name in ipairs(names) do
  m:seam { name .. ".left", names[k % 4 + 1] .. ".right" }
  for _, d in ipairs { "dart_a", "dart_b" } do m:seam { name .. "." .. d .. "_in", name .. "." .. d .. "_out", over = 0.04, hinge = true } end
  -- The waist band is elastic, in the three parts that the darts make of each panel's edge.
  for part = 1, 3 do m:band { set = name .. ".waist_" .. part, stiffness = 40, ease = 0.06, over = 0.04 } end
end
-- Skin gives way: contact with the body begins farther out than the cloth is thick, and softly enough for elements of this size.
local thick = math.max(card.thickness, size / 10)
m:contact { between = { hips, "all" }, friction = 0.4, thickness = thick }:contact { self = "all", friction = 0.3 }
for k, leg in ipairs(legs) do
  m:contact { between = { leg, "all" }, friction = 0.3, thickness = thick }
  local way = k == 1 and 1 or -1
  m:move(leg, { turn = { axis = { 1, 0, 0 }, centre = { 0, 0, -drop }, angle = function(t)
    return way * swing * math.sin(2 * math.pi * math.max(0, t - dressed) / stroke) * math.min(1, math.max(0, t - dressed) / (0.25 * stroke)) ^ 2
  end } })
end
local a = fabric.dynamic { model = m, duration = duration, damping = { mass = 25 } }
local state = {}
if out then a:checkpoint(out .. "/run.ckpt", { minutes = 2, keep = state }) end
local rest = fabric.lab.dress { analysis = a, at = dressed, window = 0.02, still = 5 * mm, calm = 1, state = state }
local times = { dressed }
for k = 1, steps do times[k + 1] = dressed + k * stroke end
local worn = fabric.lab.wear { analysis = a, body = hips, mesh = hips_mesh, times = times, state = state, out = out }
if fabric.checking() then return end
local elements = 0
for _, b in ipairs(bodies) do elements = elements + #b.mesh.elements end
print(("%s: %d elements; at rest %s; %d of %d stitches closed"):format(cloth, elements, rest.at_rest, rest.stitches - rest.open, rest.stitches))
print(worn.text)
if out then fabric.render { file = out .. "/skirt.png", run = a, field = "shear_angle", view = { 205, 8 }, width = 1000, height = 1200, smooth = true, edges = false, axes = false } end
fabric.expect {
  { "all stitches are closed", rest.open, 0, absolute = 0 },
  { "nothing passes through anything: a gap stays", worn.gap > 0 and 1 or 0, 1, absolute = 0 },
  { "the waist band presses", worn.regions.waist.usual > 0 and 1 or 0, 1, absolute = 0 },
  { "ledger", a.energy.error, 0, absolute = 1e-2 },
}
