-- A square of muslin falls onto a ball and folds about it; it touches the ball, itself and, would it get there, the floor.
--
--   fabricsh scripts/gallery/fall.lua [out] [elements along an edge] [frames]      10, none; the movie in share/doc: 28, 36
-- warns: is turned inside out
local fabric, out, cells, frames = require "fabric", arg[1] or "out/gallery", tonumber(arg[2]) or 10, tonumber(arg[3])
local mm = fabric.units.mm
local mesh = fabric.mesh.rectangle { width = 0.3, height = 0.3, nx = cells, ny = cells }
local model = fabric.model { mesh = mesh, card = fabric.card("muslin", { bending = "estimated" }), points = 1, warp = 0 }
model:gravity { 0, 0, -9.81 }
local ball = fabric.rigid.sphere { radius = 60 * mm, centre = { 0.15, 0.15, -62 * mm }, name = "ball" }
local floor = fabric.rigid.disc { radius = 190 * mm, centre = { 0.15, 0.15, -230 * mm }, normal = { 0, 0, 1 }, edge = 2 * mm, name = "floor" }
model:contact { between = { ball, "all" }, friction = 0.4, thickness = 2 * mm }:contact { between = { floor, "all" } }
model:contact { self = "all", friction = 0.4, thickness = 1 * mm }
local run = fabric.dynamic { model = model, duration = 0.3, damping = { mass = 6 } }

local function draw(file, width, height, edges)
  fabric.render { file = file, run = run, field = "uz", range = { -180, 0 }, view = { 30, 18 }, width = width, height = height, smooth = true, edges = edges, axes = false }
end
local count = 0
if frames then
  run:every(run.duration / frames, function()
    draw(("%s/fall_%03d.png"):format(out, count), 720, 480, true)
    count = count + 1
  end)
end
run:solve()
if fabric.checking() then return end
draw(out .. "/fall_end.png", 1600, 1100, true)
print(("nothing has passed through: %s; the ledger's error is %.0e"):format(run:gap() > 0, run.energy.error))
fabric.expect { { "nothing has passed through (1: yes)", run:gap() > 0 and 1 or 0, 1, absolute = 0 }, { "the ledger's error", run.energy.error, 0, absolute = 1e-2 } }
