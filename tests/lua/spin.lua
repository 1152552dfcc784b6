-- A free sheet that turns, in implicit steps: it keeps its energy and angular momentum, or says what a step turns it by. Damping of high frequencies would take energy of the
-- turning, too, so that steps become shorter instead. The short form has two of the four sheets.
-- warns: the ledger's error is
-- warns: since the cloth turns by
local fabric = require "fabric"

local function cross(a, b) return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] } end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

-- The sheet turns `turns` times about its centre, `rate` times a second, in so many steps a turn.
local function spin(o)
  local w, h, nx, ny = 0.18, 0.24, 5, 6
  local mesh = fabric.mesh.rectangle { width = w, height = h, nx = nx, ny = ny, origin = { -w / 2, -h / 2, 0 }, triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = o.own or fabric.card(o.card, { bending = "estimated" }), warp = 0 }
  local omega = 2 * math.pi * o.rate
  local function velocity(x, y, z) return cross(o.axis, { omega * x, omega * y, omega * (z or 0) }) end
  m:velocity("all", function(x, y, z) local v = velocity(x, y, z) return { x = v[1], y = v[2], z = v[3] } end)
  local a = fabric.dynamic { model = m, duration = o.turns / o.rate, scheme = "implicit", step = 1 / o.rate / o.steps }
  local share = {} -- of the mass of an element, in quarters: a triangle mesh differs by a few per cent at the corners
  for i, x in ipairs(mesh.nodes) do
    share[i] = (math.abs(math.abs(x[1]) - w / 2) < 1e-9 and 0.5 or 1) * (math.abs(math.abs(x[2]) - h / 2) < 1e-9 and 0.5 or 1)
  end
  local function momentum(run)
    local sum = 0
    for i, x in ipairs(mesh.nodes) do
      local n = run and run:node(i)
      local v = run and { n.vx, n.vy, n.vz } or velocity(x[1], x[2], x[3])
      sum = sum + share[i] * dot(o.axis, cross(run and { n.x, n.y, n.z } or x, v))
    end
    return sum
  end
  local start = momentum()
  a:solve()
  local e = a.energy
  local first = e.kinetic + e.stored + e.dissipated + e.damping
  return a, { damping = e.damping / first, momentum = momentum(a) / start, error = e.error }
end

local z = { 0, 0, 1 }
for k, o in ipairs {
  { card = "blend", rate = 15, turns = 3, steps = 100, axis = z }, { card = "blend", rate = 15, turns = 3, steps = 100, axis = z, triangles = true },
  { card = "denim", rate = 25, turns = 3, steps = 60, axis = z, triangles = true }, { card = "muslin", rate = 10, turns = 2, steps = 100, axis = { 1, 0, 0 } },
} do
  if k % 2 == 1 and not os.getenv "FABRICSH_TEST_LONG" then goto next end
  local a, got = spin(o)
  print(o.card, o.triangles and "triangles" or "quads", #a.steps .. " steps", got.damping, got.momentum, got.error)
  fabric.expect {
    { ("%s, %s: energy that damping has taken"):format(o.card, o.triangles and "triangles" or "quads"), got.damping, 0, absolute = 0.02 },
    { "angular momentum", got.momentum, 1, relative = 0.02 }, -- what damping takes before the steps are short
    { "ledger", got.error, 0, absolute = 0.04 }, -- each time that steps become shorter it has risen by 1 %
  }
  ::next::
end

-- Elastic cloth whose steps do not damp: at sixty steps a turn they would make energy of it, and are shortened to a hundred; energy and angular momentum hold.
local own = fabric.svk { young = 80e6, poisson = 0.2, density = 450, thickness = 0.35e-3, bending = { warp = 3e-5, weft = 2e-5, twist = 1e-5 } }
for _, o in ipairs { { steps = 60 }, { steps = 60, triangles = true }, { steps = 130 }, { steps = 130, triangles = true } } do
  o.card, o.own, o.rate, o.turns, o.axis = "svk", own, 18, 4, z
  local a, got = spin(o)
  local said = false
  for _, w in ipairs(a.warnings) do said = said or w.code == "step" and w.text:find("since the cloth turns by 6 degrees", 1, true) ~= nil end
  assert(said == (o.steps == 60) and #a.steps >= 4 * math.max(o.steps, 100) - 1)
  fabric.expect {
    { ("svk, %d steps a turn: angular momentum"):format(o.steps), got.momentum, 1, relative = 2e-3 },
    { "ledger", got.error, 0, absolute = 4e-3 },
    { "damping", got.damping, 0, absolute = 4e-3 },
  }
end
