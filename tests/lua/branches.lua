-- A static run that leaves an unstable shape a second time has several stable ones before it, and says so; what buckles once does not.
-- warns: the shape has become unstable
-- warns: has several stable shapes
local fabric = require "fabric"
local mm = fabric.units.mm

local function said(m, step)
  local a = fabric.static { model = m, duration = 1, step = step }:solve()
  for _, w in ipairs(a.warnings) do
    if w.code == "branches" then return true, w end
  end
  for _, w in ipairs(a.warnings) do
    if w.code == "pivots" then return false end
  end
  error "it has not buckled"
end

-- Sheared sheets: the diagonal wrinkles, and wrinkles again.
for _, step in ipairs { 0.1, 0.05 } do
  local mesh = fabric.mesh.rectangle { width = 170 * mm, height = 170 * mm, nx = 8, ny = 8 }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), warp = 0 }
  m:fix("bottom", "x y z rotation"):fix("top", "y z rotation"):move("top", { x = fabric.ramp(8 * mm, 1) })
  local yes, w = said(m, step)
  assert(yes and not w.serious and w.time > 0 and w.time <= 0.2, "a sheared sheet")
end

-- Columns, a strip between clamps and a cantilever on edge have one bifurcation, however far beyond it they are.
local B, twist = 9e-5, 2.5e-5
local soft = fabric.svk { young = 1e8, poisson = 0.2, density = 450, thickness = 0.45 * mm, bending = { warp = B, weft = B, twist = twist } }
local long, wide = 160 * mm, 18 * mm
local function strip(triangles) return fabric.mesh.rectangle { width = long, height = wide, nx = 20, ny = 2, triangles = triangles } end
for _, step in ipairs { 0.5, 0.125 } do
  for _, times in ipairs { 1.2, 2.6 } do
    local m = fabric.model { mesh = strip(times > 2), card = soft, warp = 0 }
    m:fix("left", "x y z rotation"):force("right", { x = fabric.ramp(-times * math.pi ^ 2 / 4 * B * wide / long ^ 2, 1) })
    assert(not said(m, step), "a column")
  end
  local m = fabric.model { mesh = strip(), card = soft, warp = 0 }
  m:fix("left", "x y z rotation"):fix("right", "y z rotation"):move("right", { x = fabric.ramp(-7 * mm, 1) })
  assert(not said(m, step), "a strip between clamps")
  local edge = fabric.model { mesh = strip(), card = soft, warp = 0 }
  edge:fix("left", "x y z rotation"):force("right", { y = fabric.ramp(-1.6 * 4.013 * math.sqrt(B * wide * 4 * twist * wide) / long ^ 2, 1) })
  assert(not said(edge, step), "a cantilever on edge")
end
