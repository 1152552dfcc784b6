-- A piece wrapped around an arm is sewn and comes to rest: the rule of rest, the same bits on two threads and after a restart, and what starts through the body.
local fabric = require "fabric"
local mm = fabric.units.mm
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local fails = check.fails
local card = fabric.card("blend", { bending = "estimated" })
local long, open = 80 * mm, 8 * mm -- of the sleeve; between its edges at first
local function sleeve(t)
  local arm = fabric.rigid.limb { upper = 0.1, lower = 0.1, radii = { 30 * mm, 30 * mm, 28 * mm }, around = 24, from = { -0.1, 0, 0 }, axis = { 1, 0, 0 }, towards = { 0, 0, 1 }, name = "arm" }
  local r = t.radius or 33 * mm
  local wide = 2 * math.pi * r - (t.closed and 0 or open)
  local panel = fabric.mesh.panel { size = 13 * mm, grain = 90, outline = { { 0, 0 }, { wide, 0 }, { wide, long, name = "right" }, { 0, long }, { name = "left" } } }
  panel:wrap { cylinder = { radius = r, axis = { 1, 0, 0 }, from = { t.from or -long / 2, 0, t.up or 0 }, towards = { 0, 0, -1 } } }
  local m = fabric.model { mesh = panel, card = card, points = 1 }
  m:gravity { 0, 0, -9.81 }
  if t.closed then m:seam { "left", "right" } else m:seam { "left", "right", over = t.over or 0.015, hinge = true } end
  if not t.apart then m:contact { between = { arm, "all" }, friction = 0.3 }:contact { self = "all", friction = 0.3 } end
  return fabric.dynamic { model = m, duration = t.duration or 0.12, damping = { mass = 100 } }, panel
end

-- As a child: the positions after sewing, whole or taken up from a checkpoint in the middle of it, with as many threads as the parent says.
if arg[1] then
  local a = sleeve { duration = 8e-3, over = 6e-3 }
  a:checkpoint("dress.ckpt", { every = 1 })
  if arg[1] == "half" then return a:advance(3e-3) end
  fabric.lab.dress { analysis = a, at = 8e-3, window = 1e-3, still = 1, calm = 1e9 }
  local rows = {}
  for i, u in ipairs(a:field "displacement") do rows[i] = ("%a %a %a"):format(u[1], u[2], u[3]) end
  return print(table.concat(rows, "\n"))
end

local a, panel = sleeve { duration = 0.08 }
-- Just sewn it does not rest, which a warning says.
local early = fabric.lab.dress { analysis = a, at = 0.02, window = 5e-3, still = 0.1 * mm }
assert(not early.at_rest and early.moved > 0.1 * mm and early.open == 0 and early.stitches == #panel:set "left")
local kept = {}
local dressed = fabric.lab.dress { analysis = a, at = 0.08, state = kept }
assert(dressed.at_rest and dressed.open == 0 and dressed.time == 0.08 and a.time == 0.08)
assert(dressed.moved < 1 * mm and dressed.kinetic < 1e-2 and dressed.gap > 0 and a.energy.error < 1e-2)

-- Behind the window nothing is known of rest, unless a state has it.
local late = fabric.lab.dress { analysis = a, at = 0.02, window = 5e-3 }
assert(late.at_rest == nil and late.moved == nil)
local again = fabric.lab.dress { analysis = a, at = 0.08, state = kept }
assert(again.at_rest and again.moved == dressed.moved and again.gap == dressed.gap)

local one = check.child("--threads 1", "whole")
assert(#one > 1000 and one == check.child("--threads 2", "whole"), "bits on two threads")
check.child("--threads 1", "half")
assert(one == check.child("--threads 2 --restart dress.ckpt", "whole"), "bits after a restart in the middle of sewing")

-- Edges that meet are sewn from the start; the cloth on either side of them may touch itself.
assert(sleeve { closed = true, duration = 1e-3 }:solve().joints.closed == 7)

-- A sleeve that starts through the arm, inside it, or too near to it.
fails("overlap at the start", sleeve, { radius = 30 * mm, up = 8 * mm })
fails("starts inside the arm, which bounds a solid", sleeve, { radius = 24 * mm })
fails("dress: the model has no contact", function() fabric.lab.dress { analysis = sleeve { apart = true }, at = 0.1 } end)
