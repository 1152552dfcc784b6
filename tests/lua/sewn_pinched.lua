-- Sewn cloth that is pressed deep into the barrier of contact: its explicit steps stay as planned, though nodes at its seam follow others. Two sheets
-- that a pressure holds together in flight keep their momentum, and one between a floor and a plate has the pressure of the law, with a seam node to node
-- and with nodes between those of the other edge; and a restart there has the same bits.
-- warns: guard
-- warns: a barrier keeps them apart
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local mm = fabric.units.mm
local card = fabric.card("blend", { bending = "estimated" })
local floor, stiffness = 0.0747333 * mm, 2e9 -- m, of a sheet on a body; Pa/m, less than the default, which depends on the elements

-- Two pieces that are sewn along x = 0, of `left` and `right` elements along the seam.
local function pieces(left, right, z)
  local function piece(name, n, x)
    local mesh = fabric.mesh.rectangle { width = 0.015, height = 0.02, nx = 2, ny = n, origin = { x, -0.01, z } }
    return { name = name, mesh = mesh, card = card, warp = 0 }
  end
  return piece("left", left, -0.015), piece("right", right, 0)
end

local function pressed(left, right)
  local high = fabric.mesh.rectangle { width = 0.03, height = 0.02, nx = 3, ny = 2, origin = { -0.015, -0.01, 0.37 * mm } }
  local one, other = pieces(left, right, 0)
  local m = fabric.model { bodies = { one, other, { name = "high", mesh = high, card = card, warp = 0 } }, points = 1 }
  m:seam { "left.right", "right.left" }
  local function rising(way) return fabric.history { { 0, 0 }, { 3e-3, way * 7e5 }, { 1, way * 7e5 } } end
  for _, name in ipairs { "left", "right", "high" } do
    if name ~= "high" then m:contact { between = { name, "high" }, friction = 0.3 } end
    m:pressure(rising(name == "high" and -1 or 1), name .. ".all"):fix(name .. ".all", "x y rotation"):velocity(name .. ".all", { z = 5 })
  end
  local a = fabric.dynamic { model = m, duration = 6e-3 }
  a:advance(4e-3)
  local mass, nodes = {}, 0
  for _, mesh in ipairs { one.mesh, other.mesh, high } do
    for _, e in ipairs(mesh.elements) do
      local p, r = mesh.nodes[e[1]], mesh.nodes[e[3]]
      for _, i in ipairs(e) do mass[nodes + i] = (mass[nodes + i] or 0) + (r[1] - p[1]) * (r[2] - p[2]) / 4 end
    end
    nodes = nodes + #mesh.nodes
  end
  assert(a.energy.guard > 0)
  check.same_after_restore(a, nodes, 4.1e-3, function() return a.energy.guard, a.energy.impact, a.energy.external end)
  a:solve()
  local sum, momentum = 0, 0
  for i, v in ipairs(a:field "velocity") do
    sum = sum + mass[i]
    momentum = momentum + mass[i] * v[3]
  end
  print(("two sheets, %d on %d: %d steps, planned %.0f, guard %.2g J, ledger %.1g"):format(left, right, #a.steps, 6e-3 / a.step_size, a.energy.guard, a.energy.error))
  fabric.expect {
    { "speed of the centre, m/s", momentum / sum, 5, relative = 1e-10 },
    { "ledger", a.energy.error, 0, absolute = 1e-4 },
    { "steps", #a.steps, 6e-3 / a.step_size, relative = 0.02 },
  }
end
pressed(2, 2)
pressed(3, 2)

-- --- pressed flat: the law of share/doc/contact.md
for _, n in ipairs { 2, 3 } do
  local one, other = pieces(n, 2, 0)
  local m = fabric.model { bodies = { one, other }, points = 1 }
  local ground = fabric.rigid.plane { point = { 0, 0, -0.2 * mm }, normal = { 0, 0, 1 }, name = "ground" }
  local plate = fabric.rigid.plane { point = { 0, 0, 0.3 * mm }, normal = { 0, 0, -1 }, name = "plate" }
  local down = 0.345 * mm
  m:seam { "left.right", "right.left" }:contact { between = { ground, "all" }, stiffness = stiffness }:contact { between = { plate, "all" }, stiffness = stiffness }
  m:move(plate, { z = fabric.history { { 0, 0 }, { 5e-3, -down }, { 1, -down } } })
  local a = fabric.dynamic { model = m, duration = 7e-3, damping = { mass = 2000 } }
  local planned = a.step_size
  a:solve()
  local range = 0.19 * mm - floor
  local quarter, depth = range / 4, 0.19 * mm - (0.5 * mm - down) / 2
  local y = (range - depth) / quarter
  local pressure = stiffness * (depth - 0.1 * range) + stiffness * quarter * (1 - y) ^ 2 * (1 + 2 * y) / y ^ 2
  local _, _, up = a:reaction(plate)
  print(("a floor and a plate, %d on 2: %d steps, planned %.0f, %.4g N"):format(n, #a.steps, 7e-3 / planned, up))
  fabric.expect {
    { "pressure of the law at that height, N", math.abs(up), 0.03 * 0.02 * pressure, relative = 0.02 },
    { "steps", #a.steps, 7e-3 / planned, relative = 0.02 },
    { "ledger", a.energy.error, 0, absolute = 1e-3 },
  }
end
