-- Flat cloth in a solid that gives way: where its nodes are no farther apart than twice the range of contact they alone carry the law, whose force on the
-- whole cloth is then the pressure at its depth times its area, wherever the facets of the solid lie. Larger elements keep vertices and edges, too, and the run says so,
-- but for those inside flat parts.
-- What is smaller than an element does not pass between its nodes.
local fabric = require "fabric"
local mm = fabric.units.mm
local gap, stiffness, floor = 6.2 * mm, 2.5e6, 0.0747333 * mm -- the floor is half of the thickness of the fibres alone

local function cloth(cells, side, height, card)
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = cells, ny = cells, origin = { -side / 2, -side / 2, height } }
  return fabric.model { mesh = mesh, card = card or fabric.card "blend", warp = 0 }
end

-- The force over that of the law.
local function share(cells, depth, uneven)
  local side = 0.12
  local m = cloth(cells, side, gap - depth)
  local plate = fabric.mesh.rectangle { width = 0.146, height = 0.146, nx = 20, ny = 20, origin = { -0.073, -0.073, 0 } }
  if uneven then plate = plate:map(function(x, y) return x, y, 1e-6 * math.sin(1e3 * x) * math.cos(1.3e3 * y) end) end
  local body = fabric.rigid.surface { mesh = plate }
  m:contact { between = { body, "all" }, friction = 0, thickness = 2 * gap, stiffness = stiffness }:fix("all", "x y z")
  local a = fabric.dynamic { model = m, duration = 1e-6 }
  a:solve()
  local _, _, force = a:reaction(body)
  local onset = 0.2 * (gap - floor)
  local pressure = depth < onset and stiffness * depth ^ 2 / (2 * onset) or stiffness * (depth - onset / 2)
  local told = 0
  for _, w in ipairs(a.warnings) do if w.code == "nodes" then told = told + 1 end end
  return math.abs(force) / (pressure * side ^ 2), told
end

local checks = {}
for _, depth in ipairs { 0.5 * mm, 2 * mm, 4 * mm } do
  checks[#checks + 1] = { ("nodes 6 mm apart, %g mm deep"):format(depth / mm), (share(20, depth)), 1, relative = 1e-3 }
end
local apart, told = share(12, 2 * mm)
checks[#checks + 1] = { "nodes 10 mm apart", apart, 1, relative = 1e-3 }
checks[#checks + 1] = { "told", told, 0, absolute = 0 }
apart, told = share(8, 2 * mm)
checks[#checks + 1] = { "15 mm apart on a plane", apart, 1, relative = 1e-3 }
checks[#checks + 1] = { "told", told, 0, absolute = 0 }
apart, told = share(8, 2 * mm, true)
checks[#checks + 1] = { "with vertices and edges, 15 mm apart", apart, 1.58, relative = 0.05 }
checks[#checks + 1] = { "told", told, 1, absolute = 0 }

-- A disc smaller than an element is pushed up between four nodes, in both schemes.
for _, scheme in ipairs { "explicit", "implicit" } do
  local m = cloth(9, 9 * 6 * mm, 7 * mm)
  local disc = fabric.rigid.disc { centre = { 0, 0, 0 }, normal = { 0, 0, 1 }, radius = 1.5 * mm, edge = 0.5 * mm }
  m:contact { between = { disc, "all" }, friction = 0.3, thickness = 2 * gap, stiffness = stiffness }:fix("boundary", "x y z")
  m:move(disc, { z = fabric.ramp(8 * mm, 0.02) })
  local a = fabric.dynamic { model = m, duration = 0.02, scheme = scheme, step = scheme == "implicit" and 1e-3 or nil, damping = { mass = 100 } }
  a:solve()
  local z, highest = a:field "z", 0
  for _, height in ipairs(z) do highest = math.max(highest, height) end
  checks[#checks + 1] = { scheme .. ": the cloth lies above the disc, m", highest - 8 * mm, 3 * mm, absolute = 2.5 * mm }
  checks[#checks + 1] = { scheme .. ": a gap stays", a:gap() > 0 and 1 or 0, 1, absolute = 0 }
  checks[#checks + 1] = { scheme .. ": ledger", a.energy.error, 0, absolute = 1e-2 }
end
fabric.expect(checks)
