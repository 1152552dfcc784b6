-- Limp sheets of quadrilaterals whose rotations are held at their edges, blown up: an even number of elements between does not zigzag. Beside the same
-- sheet with free rotations: how the edges are held matters to a third of a millimetre, sqrt(B / N). Flat and distorted meshes, statics, relaxation, motion.
local fabric = require "fabric"
local mm = fabric.units.mm
local checks = {}
local side, pressure = 100 * mm, 1000
local card = fabric.svk { young = 10e6, poisson = 0.3, density = 500, thickness = 0.5 * mm, bending = { warp = 20e-6, weft = 20e-6, twist = 10e-6 } }

local function middle(n, hold, o)
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n }
  if o.distorted then
    -- Nodes inside move by up to a quarter of an element; the one in the middle stays.
    mesh:map(function(x, y, z)
      local i, j = math.floor(x / side * n + 0.5), math.floor(y / side * n + 0.5)
      local inside = i > 0 and i < n and j > 0 and j < n and not (2 * i == n and 2 * j == n)
      local move = inside and side / n / 4 or 0
      return x + move * math.sin(7 * i + 3 * j), y + move * math.cos(5 * i - 2 * j), z
    end)
  end
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("boundary", hold)
  local a
  if o.motion then
    m:pressure(fabric.ramp(pressure, 0.05))
    a = fabric.dynamic { model = m, duration = 1, scheme = "implicit", step = 2.5e-3, damping = { mass = 30 }, until_rest = { window = 0.1 } }
  else
    m:pressure(fabric.ramp(pressure, 1))
    a = fabric.static { model = m, duration = 1, step = 0.1, method = o.method }
  end
  a:solve()
  return a:node((n // 2) * (n + 1) + n // 2 + 1).uz
end
local held, free = "x y z rotation", "x y z"

local limit = middle(8, free, {})
for _, o in ipairs { { name = "flat" }, { name = "distorted", distorted = true } } do
  for n, most in pairs { [4] = 0.04, [8] = 0.015 } do
    local got = middle(n, held, o)
    checks[#checks + 1] = { ("%s, %d x %d: beside free rotations on 8 x 8"):format(o.name, n, n), got, limit, relative = most }
    checks[#checks + 1] = { ("%s, %d x %d: beside free rotations on this mesh"):format(o.name, n, n), got, middle(n, free, o), relative = most / 2 }
  end
end
local static = middle(8, held, {})
checks[#checks + 1] = { "relaxation", middle(8, held, { method = "relaxation" }), static, relative = 1e-3 }
checks[#checks + 1] = { "implicit motion until rest", middle(8, held, { motion = true }), static, relative = 2e-3 }
fabric.expect(checks)
