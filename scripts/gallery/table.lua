-- A round cloth over a round table falls into folds. Damping brings it to rest; a disturbance of 0.1 mm tells it where to fold.
--
--   fabricsh scripts/gallery/table.lua [out] [elements around]      24; the picture in share/doc: 56
local fabric, out = require "fabric", arg[1] or "out/gallery"
local around = tonumber(arg[2]) or 24
local card = fabric.card("blend"):with { bending = { warp = 15e-6, weft = 15e-6, twist = 7e-6 } }
local mesh = fabric.mesh.annulus { inner = 0.09, outer = 0.15, around = around, across = around // 8 }
mesh:map(function(x, y, z) return x, y, z + 1e-4 * math.cos(6 * math.atan(y, x)) end)
local model = fabric.model { mesh = mesh, card = card, warp = 0 }
model:fix("inner", "x y z rotation"):gravity { 0, 0, -9.81 }
local run = fabric.dynamic { model = model, duration = 0.35, damping = { mass = 10 } }
run:solve()
if fabric.checking() then return end
local low, high = 0, -1
for _, i in ipairs(mesh:set "outer") do
  local z = run:node(i).uz
  low, high = math.min(low, z), math.max(high, z)
end
print(("the rim hangs %.0f to %.0f mm down"):format(-high * 1e3, -low * 1e3))
fabric.render { file = out .. "/table.png", run = run, field = "uz", view = { 30, 30 }, width = 1600, height = 900, smooth = true, edges = false }
fabric.expect { { "the rim hangs lower than half the overhang, no lower than all of it (1: yes)", low < -0.03 and low >= -0.06 and 1 or 0, 1, absolute = 0 } }
