-- The cost of a flat sheet of n x n elements in an explicit run: time to be ready, time of a step, memory.
--
--   fabricsh scripts/long/speed_sheet.lua [n]      usually 316, which is 1e5 elements
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local n, steps = tonumber(arg[1] or 316), 5
local start = os.clock()
local mesh = fabric.mesh.rectangle { width = n / 100, height = n / 100, nx = n, ny = n }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 0 }
m:fix("left", "x y z"):gravity { 0, 0, -9.81 }
local a = fabric.dynamic { model = m, duration = 1 }
a:step()
local ready = os.clock()
for _ = 1, steps do a:step() end
local each = (os.clock() - ready) / steps / n ^ 2
local peak = 0
for line in io.lines "/proc/self/status" do peak = tonumber(line:match "VmHWM:%s+(%d+)") or peak end
print(("%7d elements: ready, with the first step, in %.2f s; then %.0f ns an element and step; %.0f MB at most, %.2f kB an element"):format(
  n ^ 2, ready - start, 1e9 * each, peak * 1.024e-3, peak * 1.024 / n ^ 2))
fabric.expect { { "steps", #a.steps, steps + 1, absolute = 0 } }
