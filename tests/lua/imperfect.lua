-- Sheets in motion that stay flat because nothing breaks their symmetry: said; imperfection= breaks it.
-- warns: the sheet is flat, but not stable
-- warns: the ledger's error is
-- warns: folds there, and results are too stiff
local fabric = require "fabric"
local mm = fabric.units.mm
local B = 2e-6
local cloth = fabric.svk { young = 4e6, poisson = 0.1, density = 500, thickness = 0.3 * mm, name = "cloth", bending = { warp = B, weft = B, twist = B / 2 } }

local function said(a)
  for _, w in ipairs(a.warnings) do if w.code == "unstable" then return w end end
end

local long = os.getenv "FABRICSH_TEST_LONG"
-- pressed: its ends come nearer; sheared: one goes sideways; pulled: apart
local ways = { pressed = { x = -0.6 * mm }, sheared = { y = 4 * mm }, pulled = { x = 0.6 * mm } }
local function smooth(most) return function(t) return most * (1 - math.cos(math.pi * math.min(t, 0.3) / 0.3)) / 2 end end
local function move(way, o)
  local mesh = fabric.mesh.rectangle { width = 80 * mm, height = 30 * mm, nx = 16, ny = 6, triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = cloth, warp = 0, imperfection = o.imperfection }
  m:fix("left", "x y z rotation"):fix("right", "z rotation")
  if way == "pulled" then m:fix("all", "y") end
  local to = ways[way]
  m:move("right", { x = smooth(to.x or 0), y = way ~= "pulled" and smooth(to.y or 0) or nil })
  local a = fabric.dynamic { model = m, duration = 0.4, scheme = o.scheme, step = o.scheme == "implicit" and 2e-3 or nil, damping = { mass = 60 } }
  a:solve()
  local w = 0
  for i = 1, #mesh.nodes do w = math.max(w, math.abs(a:node(i).z - mesh.nodes[i][3])) end
  return a, w
end
for _, triangles in ipairs { false, true } do
  -- the short form has triangles in implicit, quadrilaterals in explicit runs
  for _, scheme in ipairs(long and { "implicit", "explicit" } or { triangles and "implicit" or "explicit" }) do
    for _, way in ipairs { "pressed", "sheared" } do
      local flat, w = move(way, { scheme = scheme, triangles = triangles })
      local warning = said(flat)
      assert(w < 1e-9 and warning and warning.serious and warning.text:find "imperfection=3e%-06", way)
      local bent, out = move(way, { scheme = scheme, triangles = triangles, imperfection = 3e-6 })
      assert(out > 1 * mm and not said(bent), ("%s %s: %g mm"):format(way, scheme, 1e3 * out))
      assert(bent.energy.stored < (way == "pressed" and 0.01 or 0.6) * flat.energy.stored, way)
    end
  end
end
-- a pulled sheet is stable, and stays as quiet as it is
assert(not said((move("pulled", { scheme = "implicit" }))))

-- The pattern depends on nothing but the places: the same for quadrilaterals and triangles, and each time; it is as large as asked for, and
-- the mesh of the deck stays.
local function shape(triangles, amplitude)
  local mesh = fabric.mesh.rectangle { width = 80 * mm, height = 30 * mm, nx = 16, ny = 6, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = cloth, warp = 0, imperfection = amplitude }
  m:fix("left", "x y z")
  local a, most, z = fabric.static { model = m, duration = 1 }, 0, {}
  for i = 1, #mesh.nodes do
    assert(mesh.nodes[i][3] == 0)
    z[i] = a:node(i).z
    most = math.max(most, math.abs(z[i]))
  end
  return z, most
end
local quads, most = shape(false, 2e-5)
local triangles = shape(true, 2e-5)
local sum = 0
for i = 1, #quads do sum = sum + math.abs(quads[i] - triangles[i]) end
fabric.expect { { "amplitude, m", most, 2e-5, relative = 1e-12 }, { "quads as triangles", sum, 0, absolute = 1e-18 } }
local ok, message = pcall(shape, false, 0.1)
assert(not ok and message:find("field 'imperfection': expected at most a tenth of the size of the mesh", 1, true), message)
