-- A ball is pressed into a disc that was drawn tight: force against depth. For small slopes, T the tension, R the ball, a the disc, c where
-- the disc leaves the ball: F = 2 pi T c^2/R, depth = c^2/(2R) + F/(2 pi T) ln(a/c).
--
--   fabricsh scripts/contact/disc.lua               a core of 8 x 8 elements and its rings
--   fabricsh scripts/contact/disc.lua 8 16 24       three meshes; scripts/long/contact/disc.lua has what they are to show
-- warns: real cloth has 5 to 20 uN.m
local fabric = require "fabric"
local young, thickness, stretch, reference = 1e6, 0.4e-3, 1.2, 0.05
local card = fabric.svk { young = young, poisson = 0, density = 600, thickness = thickness, bending = { warp = 1e-9, weft = 1e-9, twist = 1e-9 }, name = "membrane" }
-- The ball as the middle of the sheet sees it; a thin contact that hardly gives.
local radius, deepest, wide = 0.2, 2e-3, 1e-4
local tension, a = young * (stretch ^ 2 - 1) / 2 * thickness, stretch * reference

local function closed_form(depth)
  local low, high = 1e-9, a
  for _ = 1, 100 do
    local c = (low + high) / 2
    if c ^ 2 / (2 * radius) + c ^ 2 / radius * math.log(a / c) < depth then low = c else high = c end
  end
  return 2 * math.pi * tension * low ^ 2 / radius, low
end

-- Force at the given depths over the closed form's, a list.
local function press(cells, depths)
  local mesh = fabric.mesh.disk { radius = reference, cells = cells }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  for _, i in ipairs(mesh:set "boundary") do
    mesh:set("rim " .. i, { i })
    local x, y = mesh.nodes[i][1], mesh.nodes[i][2]
    m:move("rim " .. i, { x = fabric.history { { 0, 0 }, { 1, (stretch - 1) * x } }, y = fabric.history { { 0, 0 }, { 1, (stretch - 1) * y } } })
  end
  m:fix("boundary", "z rotation")
  local clear = 1e-6 -- above the sheet at first
  local ball = fabric.rigid.sphere { radius = radius - wide / 2, centre = { 0, 0, radius + clear }, name = "ball" }
  m:contact { between = { ball, "all" }, thickness = wide, stiffness = 1e11 }
  m:move(ball, { z = fabric.history { { 0, 0 }, { 1, 0 }, { 2, -deepest - clear } } })
  local run = fabric.static { model = m, duration = 2, step = 0.25, max_cuts = 20 }
  local ratios = {}
  for i, depth in ipairs(depths) do
    run:advance(1 + (depth + clear) / (deepest + clear))
    local force, c = closed_form(depth)
    local _, _, fz = run:reaction(ball)
    ratios[i] = fabric.checking() and 1 or -fz / force
    print(string.format("%5d elements  depth %.2f mm  contact to %5.2f mm  F %.5f N, closed form %.5f N  %+.2f %%", #mesh.elements, 1e3 * depth, 1e3 * c, -fz, force, 100 * (ratios[i] - 1)))
  end
  return ratios
end

local meshes = #arg > 0 and arg or { 8 }
for _, cells in ipairs(meshes) do
  local ratios = press(math.tointeger(cells), { 1e-3, 2e-3 })
  -- The border of the contact falls between nodes; and slopes are up to 0.07, of which the closed form leaves out half of the square.
  fabric.expect { { cells .. " cells: force over the closed form at 2 mm", ratios[#ratios], 1, absolute = 3 / cells ^ 2 + 0.0026 } }
end
