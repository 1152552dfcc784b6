-- A sleeve on an arm that bends and straightens twice: cut flat, wrapped around the straight arm, sewn, come to rest, and worn. It is held at the
-- shoulder, as by a bodice. Printed are the pressures on parts of the arm, and the work of the arm in each cycle with what became of it.
--
--   fabricsh sleeve.lua [blend|duck|muslin|denim] [size of elements, mm] [bend, degrees] [time of a bend, s] [folder of checkpoint and series, or -] [flesh, mm] [field or -] [implicit step, ms]
--
-- With `flesh` the arm gives way by that much below its skin, with the stiffness of 50 kPa over 20 mm (initial moduli of 0.2 to 58 kPa were measured on limbs
-- [zheng1999]); without it, on a hard arm, the folds of elements below some 10 mm are pinched.
--
-- With `field`, the word itself, yarns that are shortened carry nothing (fabric.lab.tension_field): for elements larger than the folds.
--
-- Implicit steps end where shapes of the arm follow on each other, and are cut where loose cloth buckles.
--
-- warns: a finer mesh folds
-- The short form bends by 20 degrees. Elements have to be smaller than the folds at the elbow: beyond about 30 degrees those of 20 mm crease or turn a director over, which the program says.
-- warns: carries without folding within it
local fabric = require "fabric"
local mm = fabric.units.mm
local cloth, size, bend, stroke, out = arg[1] or "blend", (tonumber(arg[2]) or 20) * mm, tonumber(arg[3]) or 20, tonumber(arg[4]) or 0.02, arg[5] ~= "-" and arg[5] or nil
local flesh = tonumber(arg[6]) and tonumber(arg[6]) * mm
local card = fabric.card(cloth, { bending = "estimated" })
if arg[7] == "field" then card = fabric.lab.tension_field { card = card } end
local dressed, cycles = 0.01, 2 -- s: the sleeve rests
local duration = dressed + 2 * cycles * stroke

-- The arm: from the shoulder downwards, its forearm bends towards +x with the speed of a sine.
local upper, lower, radii, joint = 0.26, 0.24, { 50 * mm, 43 * mm, 31 * mm }, 95 * mm
local function angle(t) return bend * (1 - math.cos(math.pi * math.max(0, (t - dressed) / stroke))) / 2 end
local deep = flesh or 0
local arm, shapes = fabric.rigid.limb {
  upper = upper, lower = lower, radii = { radii[1] - deep, radii[2] - deep, radii[3] - deep }, joint = joint, bend = angle, duration = duration, name = "arm",
  around = flesh and 32 or 4 * math.max(4, math.floor(math.pi * radii[2] / size / 2 + 0.5)), axis = { 0, 0, -1 }, towards = { 1, 0, 0 },
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
local thickness, stiffness = math.max(card.thickness, 1.6 * mm), nil
if flesh then thickness, stiffness = card.thickness + 2 * flesh, 50e3 / (20 * mm) end
m:contact { between = { arm, "all" }, friction = 0.3, thickness = thickness, stiffness = stiffness }:contact { self = "all", friction = 0.3 }
local step = tonumber(arg[8]) and tonumber(arg[8]) * 1e-3 -- s
local a = fabric.dynamic { model = m, duration = duration, damping = { mass = 30 }, scheme = step and "implicit" or "explicit", step = step }
local state = {}
if out then
  a:checkpoint(out .. "/run.ckpt", { minutes = 2, keep = state })
  -- A picture when it is bent for the first time.
  a:every(dressed + stroke, function()
    if state.drawn or a.time == 0 then return end
    fabric.render { file = out .. "/sleeve.png", run = a, field = "shear_angle", view = { 20, 10 }, width = 1000, height = 1200, smooth = true, edges = false, axes = false }
    state.drawn = true
  end)
end

-- It hangs loosely and stores next to nothing, so that what moves is what counts.
local rest = fabric.lab.dress { analysis = a, at = dressed, window = 5e-3, calm = arg[7] == "field" and 1e4 or 1, state = state }
local times = { dressed }
for cycle = 1, cycles do times[cycle + 1] = dressed + 2 * cycle * stroke end
local worn = fabric.lab.wear { analysis = a, body = arm, mesh = shapes[1], times = times, state = state, out = out }
if fabric.checking() then return end
print(("%s: %d elements of %.0f mm"):format(cloth, #panel.elements, size / mm))
print(worn.text)
fabric.expect {
  { "at rest before it bends", rest.at_rest and 1 or 0, 1, absolute = 0 },
  { "the second cycle takes less work", worn.cycles[2].work < worn.cycles[1].work and 1 or 0, 1, absolute = 0 },
  { "nothing passes through anything: a gap stays", worn.gap > 0 and 1 or 0, 1, absolute = 0 },
  { "ledger", worn.ledger, 0, absolute = 1e-2 },
}
