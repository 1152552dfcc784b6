-- Static runs end in stable shapes where tangents are not symmetric, too: with laws that have no energy and with sliding friction. A flat strip that is shortened
-- stays flat for ever as far as its forces tell; only its tangent says that it would leave.
local fabric = require "fabric"
local length, short = 0.06, 4e-3
local checks = {}

-- The elastica: an inextensible strip, clamped at both ends, of the elliptic modulus k is shorter by 2 - 2 E / K of its length and bows by k / K of it.
local elliptic = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).elliptic
local low, high = 0, 0.9
for _ = 1, 60 do
  local k = (low + high) / 2
  local K, E = elliptic(k)
  if 2 - 2 * E / K < short / length then low = k else high = k end
end
local bow = length * low / elliptic(low)

local function strip(given)
  local mesh = fabric.mesh.rectangle { width = length, height = 0.02, nx = 16, ny = 1, triangles = given.triangles }
  local m = fabric.model { mesh = mesh, card = given.card, warp = 0 }
  -- Its lowest mode is a twist, since its shear is soft; without room across it bends.
  m:fix("all", "y"):fix("left", "x z rotation"):fix("right", "z rotation"):move("right", { x = fabric.ramp(-short, 1) })
  if given.beside then m:contact { between = { given.beside, "all" }, friction = 0.3 } end
  local a = fabric.static { model = m, duration = 1, step = given.step }:solve()
  local most = 0
  for _, z in ipairs(a:field "uz") do most = math.max(most, math.abs(z)) end
  return most
end

-- Thin, so that it bends long before it is shortened.
local blend = fabric.card("blend"):with { thickness = 0.05e-3, bending = false }
for _, law in ipairs { "incremental", "thesis" } do
  for _, step in ipairs { 0.5, 0.1 } do
    local got = strip { card = blend:with { law = law }, step = step, triangles = step == 0.1 }
    checks[#checks + 1] = { ("%s, step %g: bow, m"):format(law, step), got, bow, relative = 0.03 }
  end
end
-- A rod lies beside the strip, with friction, and is not touched.
local rod = fabric.rigid.cylinder { radius = 2e-3, from = { 0.02, -0.01, 0.02 }, to = { 0.02, 0.03, 0.02 } }
for _, step in ipairs { 0.5, 0.1 } do
  local got = strip { card = fabric.card("blend", { bending = "estimated" }), step = step, beside = rod }
  checks[#checks + 1] = { ("beside a rod with friction, step %g: bow, m"):format(step), got, bow, relative = 0.03 }
end
fabric.expect(checks)
