-- A slow or damped step of implicit motion ends in a minimum of its potential, not on a saddle, however long it is: cloth pressed beyond its buckling load leaves its shape where
-- something leads it out, and has the force of the static shape. With Newton's method alone these columns stood straight, up to 30,000 times too stiff.
-- warns: bending.warp
-- warns: has become unstable
-- warns: the ledger's error is
-- warns: loads do 0 J
local fabric = require "fabric"
local long = os.getenv "FABRICSH_TEST_LONG"

local function aside(a, mesh, component)
  local most = 0
  for i = 1, #mesh.nodes do most = math.max(most, math.abs(a:node(i)[component])) end
  return most
end
local function told(a)
  for _, w in ipairs(a.warnings) do
    if w.code == "unstable" then return 1 end
  end
  return 0
end
local schemes = { { "slow, 20 ms", step = 0.02, slow = true }, { "slow, 100 ms", step = 0.1, slow = true }, { "spectral_radius=0.1, 10 ms", step = 0.01, radius = 0.1 } }
if long then schemes[#schemes + 1] = { "slow, 5 ms", step = 5e-3, slow = true } end
local function run(m, o) return fabric.dynamic { model = m, duration = o.duration or 1, scheme = "implicit", step = o.step, slow = o.slow, spectral_radius = o.radius, damping = o.damping } end

-- A strip that is held flat and buckles in its own plane, symmetric to rounding.
local function in_plane(triangles)
  local card = fabric.svk { density = 500, thickness = 1e-3, warp = 1e8, weft = 1e8, shear = 4e7, poisson = 0 }
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.01, nx = 20, ny = 2, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("all", "z rotation"):fix("left", "x y"):fix("right", "y"):move("right", { x = fabric.ramp(-0.02, 1) })
  return m, mesh
end
for _, triangles in ipairs { false, true } do
  local static = fabric.static { model = in_plane(triangles), duration = 1, step = 0.05 }
  static:solve()
  local force = static:reaction "right"
  for _, o in ipairs(schemes) do
    local m, mesh = in_plane(triangles)
    local a = run(m, o)
    a:solve()
    local text = ("%s in its plane, %s: "):format(triangles and "triangles" or "quadrilaterals", o[1])
    print(text, a:reaction "right", force, 1e3 * aside(a, mesh, "uy"))
    fabric.expect {
      { text .. "force of the static shape", a:reaction "right", force, relative = 0.01 },
      { text .. "told", told(a), 0, absolute = 0 },
    }
  end
end

-- A column with a side force of a fiftieth of Euler's load, whose end is moved in.
local function column(triangles)
  local B = 5e-4
  local card = fabric.svk { density = 500, thickness = 1e-3, warp = 1e8, weft = 1e8, shear = 4e7, poisson = 0, bending = { warp = B, weft = B, twist = B / 2 } }
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.02, nx = 20, ny = 2, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  mesh:set("middle", function(x) return math.abs(x - 0.1) < 1e-6 end)
  m:fix("left", "x y z rotation"):fix("right", "y z"):move("right", { x = fabric.ramp(-0.02, 1) }):force("middle", { z = 1e-4 })
  return m, mesh
end
for _, triangles in ipairs { false, true } do
  for _, o in ipairs(schemes) do
    local m, mesh = column(triangles)
    local a = run(m, o)
    a:solve()
    local text = ("column of %s, %s: "):format(triangles and "triangles" or "quadrilaterals", o[1])
    print(text, a:reaction "right", 1e3 * aside(a, mesh, "uz"))
    fabric.expect {
      { text .. "way aside, mm", 1e3 * aside(a, mesh, "uz"), 38, relative = 0.01 }, -- statics 37.98
      { text .. "force, N", a:reaction "right", -0.0054, absolute = 1.2e-3 },
    }
  end
end

-- A cantilever under three times Euler's load, with the imperfection that `unstable` advises: the elastica's end is 0.708 lengths aside.
do
  local B = 2e-5
  local card = fabric.svk { density = 500, thickness = 0.5e-3, warp = 1e7, weft = 1e7, shear = 4e6, poisson = 0, bending = { warp = B, weft = B, twist = B / 2 } }
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.02, nx = 20, ny = 2 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0, imperfection = 5e-6 }
  local load = 3 * math.pi ^ 2 * B * 0.02 / 4 / 0.01
  m:fix("left", "x y z rotation"):force("right", { x = fabric.ramp(-load, 0.5) })
  local a = run(m, { step = 0.5, duration = 5, slow = true })
  a:solve()
  print("cantilever", aside(a, mesh, "uz") / 0.1)
  fabric.expect { { "cantilever in steps of 0.5 s, way aside over its length", aside(a, mesh, "uz") / 0.1, 0.7078, absolute = 5e-3 }, { "told", told(a), 0, absolute = 0 } }
end
