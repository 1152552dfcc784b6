-- A card for elements larger than the folds: next to nothing in compression, the same in tension, of constant moduli too; and a stretched sheet
-- that is bent in its plane, of which one side folds [stein1961]. The short form has one of the two cases: statics of triangles, explicit
-- motion of quadrilaterals.
local fabric = require "fabric"
local near = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).near
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails

for _, name in ipairs { "blend", "duck", "muslin", "denim" } do
  local plain = fabric.card(name)
  local card = fabric.lab.tension_field { card = plain }
  assert(card:check().ok and card.folds == "free")
  for _, yarn in ipairs { "warp", "weft" } do
    local function S(of, E) return fabric.point(of):uniaxial(yarn, E).S end
    for _, share in ipairs { 0.001, 0.1, 0.3, 0.6, 1 } do
      local E = share * plain.tested[yarn]
      near(S(card, E), S(plain, E), 1e-6, ("%s, %s at E = %g"):format(name, yarn, E))
    end
    assert(math.abs(S(card, -0.05)) < 2e-3 * math.abs(S(plain, -0.05)), name)
  end
end

-- Strips along x, without cross contraction: the strain is e - k y, and where that is negative nothing is carried. With c = h/2 + e/k of the height h
-- taut the force is E t k c^2 / 2, and its moment about the middle the force times h/2 - c/3.
local E, t, L, h = 5e7, 4e-4, 0.1, 0.1
local yarn = { loading = { E }, unloading = 2 * E, poisson = 0 }
local card = fabric.lab.tension_field { card = fabric.woven { name = "straight", density = 500, thickness = t, warp = yarn, weft = yarn, shear = { loading = { 2e6 }, unloading = 2e6 },
  tested = { warp = 0.02, weft = 0.02, shear = 0.1 } } }
local T = { static = 1, explicit = 0.01 }
local function analysis(scheme, m)
  if scheme == "static" then return fabric.static { model = m, duration = T[scheme], step = 0.25 } end
  return fabric.dynamic { model = m, duration = T[scheme], damping = { mass = 1000 } }
end
local function bent(scheme, triangles, e, k)
  local mesh = fabric.mesh.rectangle { width = L, height = h, nx = 4, ny = 40, origin = { 0, -h / 2 }, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0, membrane = true }
  mesh:set("middle", function(x, y) return x < 1e-9 and math.abs(y) < 1e-9 end)
  m:fix("all", "z"):fix("left", "x"):fix("middle", "y")
  for i, n in ipairs(mesh:set "right") do
    mesh:set("end " .. i, { n })
    m:move("end " .. i, { x = fabric.ramp((e - k * mesh.nodes[n][2]) * L, T[scheme]) })
  end
  local a = analysis(scheme, m):solve()
  local force, moment = 0, 0
  for i, n in ipairs(mesh:set "right") do
    local x = a:reaction("end " .. i)
    force, moment = force + x, moment - x * mesh.nodes[n][2]
  end
  assert(a.energy.error < 1e-2)
  return force, moment
end
for _, scheme in ipairs { "static", "explicit" } do
  for _, triangles in ipairs { false, true } do
    local cases = { { 2e-3, 0.01 }, { 1e-3, 0.06 } }
    if not os.getenv "FABRICSH_TEST_LONG" then cases = (scheme == "static") == triangles and { cases[2] } or {} end
    for _, case in ipairs(cases) do
      local e, k = table.unpack(case)
      local c = math.min(h, h / 2 + e / k)
      local want = c < h and E * t * k * c * c / 2 or E * t * e * h
      local what = ("%s, %s, e = %g, k = %g"):format(scheme, triangles and "triangles" or "quadrilaterals", e, k)
      local force, moment = bent(scheme, triangles, e, k)
      near(force, want, 0.02, "force: " .. what)
      near(moment, c < h and want * (h / 2 - c / 3) or E * t * k * h ^ 3 / 12, 0.03, "moment: " .. what)
    end
  end
end


-- An elastic card too; a law in the place of the springs has no energy that folds could make least.
local svk = fabric.lab.tension_field { card = fabric.svk { young = 1e6, poisson = 0.2, density = 500, thickness = 1e-3 } }
assert(math.abs(fabric.point(svk):uniaxial(30, -0.05).S) < 2)
fails("field 'folds': expected \"resolved\", or law = \"potential\", got \"free\"", fabric.point, fabric.card("blend"):with { law = "thesis", folds = "free" })
