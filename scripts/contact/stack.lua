-- A stack of layers at rest on a plane: four fabrics and one of two plies, quadrilaterals and triangles, each turned a little more than the one
-- below, so that no mesh lies in line with another. The plane carries the weight of all, and each gap that of what lies above it.
--
--   fabricsh scripts/contact/stack.lua             layers of 4 x 4 elements
--   fabricsh scripts/contact/stack.lua 12 out      of 12 x 12, with files for ParaView in out
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local brute = dofile((arg[0]:gsub("[^/]*$", "brute.lua")))
local cells, out = tonumber(arg[1] or 4), arg[2]
local side, g = 0.06, 9.81

local names = { "blend", "denim", "duck", "muslin" }
local bodies, weight, top = {}, 0, 0
for i = 1, 5 do
  local card = fabric.card(names[i] or "blend")
  local plies = i == 5 and { { card = card, warp = 0 }, { card = fabric.card "muslin", warp = 45 } }
  local thickness, areal = card.thickness, card.thickness * card.density
  if plies then
    local other = plies[2].card
    thickness, areal = thickness + other.thickness, areal + other.thickness * other.density
  end
  local z = top + 0.495 * thickness -- a hair into the sheet below: contact has no stiffness where it begins
  top = z + 0.495 * thickness
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = cells, ny = cells, triangles = i % 2 == 0, origin = { -side / 2, -side / 2, 0 } }
  local turn = math.rad(9 * (i - 1))
  mesh:map(function(x, y) return x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), z end)
  bodies[i] = { name = i == 5 and "two_plies" or names[i], mesh = mesh, card = not plies and card or nil, layers = plies or nil, warp = math.deg(turn) }
  weight = weight + areal * side ^ 2 * g
end
local m = fabric.model { bodies = bodies }
local ground = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 }, name = "ground" }
-- Every two of them touch, each pair with its own thickness; self = "all" would take the thickest for all.
local sheets = {}
for i, body in ipairs(bodies) do sheets[i] = body.name .. ".all" end
m:contact { between = { ground, sheets[1] }, friction = 0.4, stiffness = 1e9 }:contact { between = sheets, friction = 0.3, stiffness = 1e9 }
m:fix("all", "x y rotation"):gravity { 0, 0, fabric.history { { 0, 0 }, { 1, -g } } }
local a = fabric.static { model = m, duration = 1, step = 0.25 }
if out then a:vtk(out .. "/stack", { fields = { "displacement", "gap", "contact_pressure" } }) end
a:solve()

local _, _, carried = a:reaction(ground)
local heights, first, below = a:field "z", 1, -math.huge
local rows = {
  { "what the plane carries, N", carried, weight, relative = 1e-8 },
  { "something has passed", #brute.watch(m.mesh, {}, { { point = { 0, 0, 0 }, normal = { 0, 0, 1 } } })(a), 0, absolute = 0 },
  { "the gap stays open", a:gap() > 0 and 1 or 0, 1, absolute = 0 },
}
for i, body in ipairs(bodies) do
  local mean, n = 0, #body.mesh.nodes
  for k = first, first + n - 1 do mean = mean + heights[k] / n end
  print(string.format("%-10s at %.4f mm", body.name, 1e3 * mean))
  rows[#rows + 1] = { body.name .. " lies above what is below it", mean > below and 1 or 0, 1, absolute = 0 }
  first, below = first + n, mean
end
fabric.expect(rows)
