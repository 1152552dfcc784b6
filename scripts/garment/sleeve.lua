-- A sleeve on an arm that bends and straightens twice: cut flat, wrapped around the straight arm, sewn, come to rest, and worn. It is held at the
-- shoulder, as by a bodice. Printed are the largest pressures on parts of the arm, and the work of the arm in each cycle with what became of it.
--
--   fabricsh sleeve.lua [blend|duck|muslin|denim] [size of elements, mm] [bend, degrees] [time of a bend, s] [folder of checkpoint and series]
--
-- The short form bends by 30 degrees. Elements have to be smaller than the folds at the elbow: beyond about 40 degrees those of 20 mm crease, which the program says.
local fabric = require "fabric"
local mm = fabric.units.mm
local cloth, size, bend, stroke, out = arg[1] or "blend", (tonumber(arg[2]) or 20) * mm, tonumber(arg[3]) or 30, tonumber(arg[4]) or 0.02, arg[5]
local card = fabric.card(cloth, { bending = "estimated" })
local dressed, cycles = 0.01, 2 -- s: the sleeve rests
local duration = dressed + 2 * cycles * stroke

-- The arm: from the shoulder downwards, its forearm bends towards +x with the speed of a sine.
local upper, lower, radii, joint = 0.26, 0.24, { 50 * mm, 43 * mm, 31 * mm }, 95 * mm
local function angle(t) return bend * (1 - math.cos(math.pi * math.max(0, (t - dressed) / stroke))) / 2 end
local arm = fabric.rigid.limb {
  upper = upper, lower = lower, radii = radii, joint = joint, bend = angle, duration = duration, name = "arm",
  around = 4 * math.max(4, math.floor(math.pi * radii[2] / size / 2 + 0.5)), axis = { 0, 0, -1 }, towards = { 1, 0, 0 },
}

-- The sleeve: a cone with some room around the arm, from s = `top` to s = `hem` of the arm's middle line. It is cut from the part of a ring.
local top, hem, room = 0.05, 0.44, 4 * mm
local taper = math.atan((radii[1] - radii[3]) / (upper + lower))
local wide = radii[1] + room                           -- radius at the upper edge
local narrow = wide - (hem - top) * math.tan(taper)    -- and at the hem
local apex, long = narrow / math.sin(taper), (hem - top) / math.cos(taper) -- along the surface: from the apex to the hem, and on
local function on_ring(rho, share)
  local turn = 2 * math.pi * math.sin(taper) * (share - 0.5)
  return { rho * math.sin(turn), rho * math.cos(turn) - apex }
end
local right = on_ring(apex + long, 1)
local panel = fabric.mesh.panel { size = size, grain = 90, outline = {
  on_ring(apex, 0),
  { arc = { through = on_ring(apex, 0.5), to = on_ring(apex, 1) }, name = "hem" },
  { right[1], right[2], name = "right" },
  { arc = { through = on_ring(apex + long, 0.5), to = on_ring(apex + long, 0) }, name = "top" },
  { name = "left" },
} }
panel:wrap { cone = { radius = narrow, angle = math.deg(taper), axis = { 0, 0, 1 }, from = { 0, 0, -hem }, towards = { 0, 1, 0 } } }

local m = fabric.model { mesh = panel, card = card, points = 1 }
m:gravity { 0, 0, -9.81 }:fix("top", "x y z"):seam { "left", "right" }
-- Skin gives way: contact with the arm begins a little farther out than the cloth is thick.
m:contact { between = { arm, "all" }, friction = 0.3, thickness = math.max(card.thickness, 1.6 * mm) }:contact { self = "all", friction = 0.3 }
local a = fabric.dynamic { model = m, duration = duration, damping = { mass = 30 } }
local peak = { upper = 0, joint = 0, lower = 0, gap = math.huge } -- Pa; m
if out then a:checkpoint(out .. "/run.ckpt", { minutes = 2, keep = peak }):vtk(out .. "/sleeve", { every = stroke / 10 }) end

-- s of a place of the arm at the time t: below, in, or beyond the arc of the joint.
local function along(x, z, t)
  local theta, begins = math.rad(angle(t)), upper - joint / 2
  if -z < begins or theta == 0 then return -z end
  local r = joint / theta
  local phi = math.atan(-z - begins, r - x)
  if phi < theta then return begins + r * phi end
  return begins + joint + (-z - begins) * math.cos(theta) - (r - x) * math.sin(theta)
end
local area = {} -- m2, of the cloth about each node
for _, corners in ipairs(panel.elements) do
  local o = panel.nodes[corners[1]]
  for k = 3, #corners do
    local u, v = {}, {}
    for c = 1, 3 do u[c], v[c] = panel.nodes[corners[k - 1]][c] - o[c], panel.nodes[corners[k]][c] - o[c] end
    local whole = math.sqrt((u[2] * v[3] - u[3] * v[2]) ^ 2 + (u[3] * v[1] - u[1] * v[3]) ^ 2 + (u[1] * v[2] - u[2] * v[1]) ^ 2) / 2
    for _, n in ipairs { corners[1], corners[k - 1], corners[k] } do area[n] = (area[n] or 0) + whole / 3 end
  end
end
a:every(stroke / 20, function(run)
  local x, z, p = run:field "x", run:field "z", run:field "contact_pressure"
  local force, on = { upper = 0, joint = 0, lower = 0 }, { upper = 0, joint = 0, lower = 0 }
  for i = 1, #x do
    local s = along(x[i], z[i], run.time)
    local part = s < upper - joint / 2 and "upper" or s < upper + joint / 2 and "joint" or "lower"
    force[part], on[part] = force[part] + p[i] * area[i], on[part] + area[i]
  end
  for part, f in pairs(force) do peak[part] = math.max(peak[part], f / math.max(on[part], 1e-9)) end
  peak.gap = math.min(peak.gap, (run:gap()))
end)

-- It hangs loosely and stores next to nothing, so that what moves is what counts.
local rest = fabric.lab.dress { analysis = a, at = dressed, window = 5e-3, calm = 1 }
local last, work = a.energy, {}
for cycle = 1, cycles do
  a:advance(dressed + 2 * cycle * stroke)
  local e = a.energy
  work[cycle] = e.external - last.external
  print(("%s, cycle %d: work of the arm %.1f mJ; cloth has taken %.1f mJ, friction %.1f mJ, air and impact %.1f mJ"):format(cloth, cycle, 1e3 * work[cycle],
    1e3 * (e.dissipated - last.dissipated), 1e3 * (e.friction - last.friction), 1e3 * (e.damping + e.impact - last.damping - last.impact)))
  last = e
end
if fabric.checking() then return end
print(("%d elements of %.0f mm; largest mean pressures: upper arm %.0f Pa, elbow %.0f Pa, forearm %.0f Pa; smallest gap above the floor %.3f mm; ledger %.1e"):format(
  #panel.elements, size / mm, peak.upper, peak.joint, peak.lower, peak.gap / mm, a.energy.error))
fabric.expect {
  { "at rest before it bends", rest.at_rest and 1 or 0, 1, absolute = 0 },
  { "the second cycle takes less work", work[2] < work[1] and 1 or 0, 1, absolute = 0 },
  { "nothing passes through anything: a gap stays", peak.gap > 0 and 1 or 0, 1, absolute = 0 },
  { "ledger", a.energy.error, 0, absolute = 1e-2 },
}
