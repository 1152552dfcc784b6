-- A strip is folded sharply and cut along the fold: the director there stood on the mean of both sides, and leans on each of them when they part.
-- That makes no energy, in any scheme, and the sheet settles. A shell that is torn between two legs, whose fold is sharpest at the tip, keeps its ledger.
local fabric = require "fabric"
local mm = fabric.units.mm

local function folded(case)
  local card = fabric.svk { young = 1e7, poisson = 0, density = 400, thickness = 0.4 * mm }:with { bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6 } }
  local length = 20 * mm
  local mesh = fabric.mesh.rectangle { width = length, height = length, nx = 2, ny = 2, triangles = case.triangles }
  mesh:set("fold", function(x) return math.abs(x - length / 2) < 1e-6 end)
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local T, arm = case.time or 1, 0.98 * length / 2
  local function angle(time) return math.rad(case.angle) * (1 - math.cos(math.pi * math.min(1, time / T))) / 2 end
  m:fix("left", "x y z rotation"):fix("right", "y")
  m:move("right", { x = function(time) return arm * (math.cos(angle(time)) - 1) end, z = function(time) return arm * math.sin(angle(time)) end })
  m:tearable "all"
  if case.scheme == "static" then return fabric.static { model = m, duration = 1.3 * T, step = 0.004 * T }, T end
  local implicit = case.scheme == "implicit"
  return fabric.dynamic { model = m, duration = 1.3 * T, scheme = case.scheme, step = implicit and (case.step or 0.01) * T or nil, damping = { mass = implicit and 0 or 50 } }, T
end

for _, case in ipairs {
  { scheme = "explicit", angle = 100, time = 0.2 }, { scheme = "explicit", angle = 100, time = 0.2, triangles = true },
  { scheme = "implicit", angle = 80 }, { scheme = "implicit", angle = 90 }, { scheme = "implicit", angle = 110, triangles = true },
  { scheme = "implicit", angle = 80, triangles = true }, { scheme = "implicit", angle = 125, triangles = true },
  { scheme = "implicit", angle = 125, triangles = true, step = 0.04 },
  { scheme = "static", angle = 90 }, { scheme = "static", angle = 95, triangles = true },
} do
  local name = ("%s, %s"):format(case.scheme, case.triangles and "triangles" or "quadrilaterals")
  local run, T = folded(case)
  run:advance(T)
  local before = run.energy
  assert(run:cut { set = "fold" } == 3)
  local after = run.energy
  assert(before.stored > 1e-5 and math.abs(after.internal - before.internal) < 1e-12 * before.internal, name .. ": energy of the cut")
  assert(after.joints >= 0 and math.abs(after.error - before.error) < 1e-9, name)
  local there = run:snapshot()
  run:solve()
  assert(run.energy.error < after.error + 2e-2 and run.energy.stored < 0.2 * after.stored, name .. ": " .. run.energy.error)
  -- The directors do not go on turning.
  assert(case.scheme ~= "implicit" or run.energy.stored + run.energy.kinetic < 1e-3 * after.stored, name)
  local last = run:field "position"
  run:restore(there):solve()
  for i, x in ipairs(run:field "position") do
    for k = 1, 3 do assert(x[k] == last[i][k], name) end
  end
end

-- Two legs of a slit sheet that bends are pulled apart, up and down; it tears on between them.
local width, leg, tear, h, speed = 24 * mm, 20 * mm, 20 * mm, 4 * mm, 2
local card = fabric.svk { warp = 1e8, weft = 6e7, shear = 3e7, poisson = { 0, 0 }, density = 500, thickness = 0.5 * mm, through_thickness = true }
card = card:with { rupture = { weft = { strength = 1250, energy = 20 } }, bending = { warp = 1e-5, weft = 1e-5, twist = 5e-6 } }
local mesh = fabric.mesh.rectangle { width = width, height = leg + tear + 3 * h, nx = 6, ny = 13 }
mesh:slit { from = { width / 2, 0 }, to = { width / 2, leg }, left = "left face", right = "right face" }
local face = {}
for i, name in ipairs { "left face", "right face" } do
  for _, n in ipairs(mesh:set(name)) do face[n] = mesh.nodes[n][2] < leg - 0.01 * h and i or nil end
end
for i, name in ipairs { "leg 1", "leg 2" } do
  local ids = {}
  for n = 1, #mesh.nodes do
    local p = mesh.nodes[n]
    if p[2] < 0.01 * h and (face[n] or (p[1] < width / 2 and 1 or 2)) == i then ids[#ids + 1] = n end
  end
  mesh:set(name, ids)
end
mesh:set("zone", function(x, y) return math.abs(x - width / 2) < 1.01 * h and y > leg - 1.01 * h end)
mesh:set("path", function(x, y) return math.abs(x - width / 2) < 0.01 * h and y > leg - 0.01 * h end)
local m = fabric.model { mesh = mesh, card = card, warp = 90 }
m:tearable("zone", { coarse = "keep", path = "path" })
local turning = 2 * leg / (3 * speed)
local function angle(time) return time < turning and math.pi / 4 * (1 - math.cos(math.pi * time / turning)) or math.pi / 2 end
for i, sign in ipairs { 1, -1 } do
  m:fix("leg " .. i, "x"):move("leg " .. i, {
    y = function(time) return leg * (1 - math.cos(angle(time))) end,
    z = function(time) return sign * (leg * math.sin(angle(time)) + speed * math.max(0, time - turning) / 2) end,
  })
end
local run = fabric.dynamic { model = m, duration = turning + 1.6 * tear / speed, damping = { mass = 200 } }
run:solve()
assert(run.joints.open == 4 and run.energy.error < 1e-3, run.energy.error)
