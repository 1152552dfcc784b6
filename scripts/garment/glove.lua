-- The finger of a glove: back, palm, and between them two fourchettes, cut flat, wrapped around the finger, sewn along its sides, drawn together over the
-- fingertip, and worn while the finger bends and straightens. Printed is where it presses and what it costs the wearer.
--
--   fabricsh glove.lua [blend|duck|muslin|denim] [size of elements, mm] [bend, degrees] [time of a bend, s] [folder]
--
-- Elements of 6 mm are coarse for the folds beside the fourchettes, where a director turns over as the finger straightens.
-- warns: is turned over
-- warns: a finer mesh folds
-- warns: locks where yarns are pulled
-- warns: carries without folding within it
local fabric = require "fabric"
local mm = fabric.units.mm
local cloth, size, bend, stroke, out = arg[1] or "muslin", (tonumber(arg[2]) or 6) * mm, tonumber(arg[3]) or 15, tonumber(arg[4]) or 0.01, arg[5]
local card = fabric.card(cloth, { bending = "estimated" })
local dressed = 0.012 -- s: sewn, and at rest
local duration = dressed + 2 * stroke

-- The finger points along +z, its palm is at -y; it bends towards the palm.
local upper, lower, radii, joint = 42 * mm, 34 * mm, { 9 * mm, 8.5 * mm, 7.5 * mm }, 20 * mm
local function angle(t) return bend * (1 - math.cos(math.pi * math.max(0, (t - dressed) / stroke))) / 2 end
local finger, shapes = fabric.rigid.limb { upper = upper, lower = lower, radii = radii, joint = joint, bend = angle, duration = duration, name = "finger",
  around = 24, axis = { 0, 0, 1 }, towards = { 0, -1, 0 } }

-- A panel goes straight along the finger, from `begins` to its end, and narrows from there on. Back and palm have round ends, which are sewn to each other;
-- fourchettes come to a point.
local r, begins = radii[1] + 2 * mm, 8 * mm
local straight, cap = upper + lower - begins, r * math.pi / 2
local along = math.floor(straight / size + 0.5)
local shoulder = 0.6 * cap -- beyond the finger's end: where the fourchettes end
local function panel(name, turn, azimuth, pointed)
  local half = r * math.rad(turn) / 2
  local function width(s) return half * (pointed and 1 - s / shoulder or math.cos(s / r)) end
  local right, left = {}, {}
  for k = 1, 4 do
    local s = shoulder * k / 4
    right[k] = { width(s), straight + s }
    left[5 - k] = { -width(s - shoulder / 4), straight + s - shoulder / 4 }
  end
  local outline = { { -half, 0 }, { half, 0, name = "wrist" }, { half, straight, name = "right", elements = along }, { spline = right, name = "tip_right" } }
  if not pointed then outline[#outline + 1] = { arc = { through = { 0, straight + 0.82 * cap }, to = { -width(shoulder), straight + shoulder } }, name = "end" } end
  outline[#outline + 1] = { spline = left, name = "tip_left" }
  outline[#outline + 1] = { name = "left", elements = along }
  local mesh = fabric.mesh.panel { size = size, grain = 90, outline = outline }
  local phi = math.rad(azimuth)
  mesh:wrap { cylinder = { radius = r, from = { 0, 0, begins }, axis = { 0, 0, 1 }, towards = { math.cos(phi), math.sin(phi), 0 } } }
  return { name = name, mesh = mesh, card = card }
end
local wide, narrow = 120, 60 -- degrees around the finger: back and palm, and fourchettes
local bodies = { panel("back", wide, 90), panel("fourchette_a", narrow, 180, true), panel("palm", wide, 270), panel("fourchette_b", narrow, 0, true) } -- counter-clockwise

local m = fabric.model { bodies = bodies, points = 1 }
for k, b in ipairs(bodies) do
  local beside = bodies[k % 4 + 1].name
  m:seam { b.name .. ".right", beside .. ".left", hinge = true }
  m:seam { b.name .. ".tip_right", beside .. ".tip_left", over = 0.006, hinge = true, ease = 0.15 }
  m:fix(b.name .. ".wrist", "x y z")
end
m:seam { "back.end", "palm.end", over = 0.006, hinge = true }
m:contact { between = { finger, "all" }, friction = 0.3, thickness = math.max(card.thickness, 0.6 * mm) }:contact { self = "all", friction = 0.3 }
local a = fabric.dynamic { model = m, duration = duration, damping = { mass = 300 } }
local state = {}
if out then a:checkpoint(out .. "/run.ckpt", { minutes = 2, keep = state }) end
local rest = fabric.lab.dress { analysis = a, at = dressed, window = 2e-3, still = 0.5 * mm, calm = 1, state = state }
local worn = fabric.lab.wear { analysis = a, body = finger, mesh = shapes[1], times = { dressed, duration }, patch = 4 * mm, state = state, out = out }
if fabric.checking() then return end
local elements = 0
for _, b in ipairs(bodies) do elements = elements + #b.mesh.elements end
print(("%s: %d elements; at rest %s; %d of %d stitches closed"):format(cloth, elements, rest.at_rest, rest.stitches - rest.open, rest.stitches))
print(worn.text)
if out then fabric.render { file = out .. "/glove.png", run = a, field = "shear_angle", view = { 60, 15 }, width = 1000, height = 1200, smooth = true, edges = false, axes = false } end
fabric.expect {
  { "all stitches are closed", rest.open, 0, absolute = 0 },
  { "nothing passes through anything: a gap stays", worn.gap > 0 and 1 or 0, 1, absolute = 0 },
  { "bending costs work", worn.cycles[1].work > 0 and 1 or 0, 1, absolute = 0 },
  { "ledger", a.energy.error, 0, absolute = 1e-2 },
}
