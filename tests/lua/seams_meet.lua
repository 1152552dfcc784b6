-- Four panels that meet in one point, as under an arm, with self-contact: two pairs are sewn from the start, and are drawn together. Nodes of the point
-- that no stitch of their own connects become one joint, too, and do not push each other away before.
local fabric = require "fabric"
local mm = fabric.units.mm

local function panels(count, other, triangles, fold)
  local side, apart = 60 * mm, 14 * mm
  local function panel(x, y, n)
    local mesh = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = 3, origin = { x, y, 0 }, triangles = triangles }
    if fold then mesh:map(function(u, v) return u, v * math.cos(fold), math.abs(v) * math.sin(fold) end) end -- both pairs bent along their seams
    return mesh
  end
  local bodies = {}
  for i, at in ipairs { { "a", -side, 0, count }, { "b", -side, -side, count }, { "c", apart, 0, other }, { "d", apart, -side, other } } do
    bodies[i] = { name = at[1], mesh = panel(at[2], at[3], at[4]), card = fabric.card("blend", { bending = "estimated" }), warp = { 1, 0, 0 } }
  end
  local m = fabric.model { bodies = bodies, points = 1 }
  m:seam { "a.bottom", "b.top", hinge = true }:seam { "c.bottom", "d.top", hinge = true }
  m:seam { "a.right", "c.left", over = 0.02, hinge = true }:seam { "b.right", "d.left", over = 0.02, hinge = true }
  m:contact { self = "all", friction = 0.2 }
  return fabric.dynamic { model = m, duration = 0.03, damping = { mass = 50 } }
end

for _, case in ipairs { { 3, 3 }, { 4, 3 }, { 3, 3, true }, { 4, 3, false, 0.6 } } do
  local a = panels(table.unpack(case))
  a:solve()
  print(("%d and %d elements: %d of %d closed, %d steps of %.0f, guard %.3g J, ledger %.2g"):format(case[1], case[2], a.joints.closed, a.joints.stitches, #a.steps, 0.03 / a.step_size, a.energy.guard, a.energy.error))
  assert(a.joints.closed == a.joints.stitches)
  assert(#a.steps < 1.05 * 0.03 / a.step_size and a.energy.guard == 0 and a.energy.error < 1e-2)
end
