-- Two discs of cloth, one cut into 24 sides and one into 32, are drawn together at the rim, sewn and blown up to a cushion. By symmetry it is twice one
-- disc whose rim stays in its plane, which a static run computes.
-- warns: carries without folding within it
local fabric, out = require "fabric", arg[1] or "out/garment"
local R, pressure, apart, sewn, blown = 0.1, 100, 0.02, 0.05, 0.15
local card = fabric.svk { young = 1e6, poisson = 0.3, density = 500, thickness = 0.5e-3 }
local function disc(cells)
  local mesh = fabric.mesh.disk { radius = R, cells = cells }
  mesh:set("east", function(x) return x > R * (1 - 1e-6) end)
  return mesh
end

local half = disc(8)
local one = fabric.model { mesh = half, card = card, warp = 0 }
one:fix("boundary", "z"):fix("centre", "x y"):fix("east", "y"):pressure(fabric.ramp(pressure, 1))
local still = fabric.static { model = one, duration = 1, step = 0.05 }:solve()

local top, bottom = disc(6), disc(8)
bottom:map(function(x, y) return x, -y, -apart end) -- its normal points down
local m = fabric.model { bodies = { { name = "top", mesh = top, card = card, warp = 0 }, { name = "bottom", mesh = bottom, card = card, warp = 0 } } }
m:fix("top.centre", "x y"):fix("bottom.centre", "x y"):fix("bottom.east", "y")
local blow = fabric.history { { 0, 0 }, { sewn, 0 }, { blown, pressure } }
m:pressure(blow, "top.all"):pressure(blow, "bottom.all")
m:seam { "top.boundary", "bottom.boundary", over = sewn }
local run = fabric.dynamic { model = m, duration = 0.4, damping = { mass = 60 } }
run:solve()
if fabric.checking() then return end

local function height(a, first, mesh)
  local low, high = math.huge, -math.huge
  for i = first + 1, first + #mesh.nodes do
    low, high = math.min(low, a:node(i).z), math.max(high, a:node(i).z)
  end
  return high - low
end
local cushion, twice = height(run, 0, top) + height(run, #top.nodes, bottom), 2 * height(still, 0, half)
print(("%d stitches; the cushion is %.1f mm high, twice the half of it %.1f mm"):format(run.joints.closed, cushion * 1e3, twice * 1e3))
fabric.render { file = out .. "/cushion.png", run = run, field = "z", view = { 30, 20 }, width = 1200, height = 800, smooth = true }
fabric.expect {
  { "height of the cushion, m", cushion, twice, relative = 0.02 },
  { "energy stored, J", run.energy.stored, 2 * still.energy.stored, relative = 0.02 },
}
