-- Damping by stiffness resists the rate of strain, of which a turn has none: a free sheet keeps its angular momentum, a strip that turns about a hub pulls with
-- its centrifugal force alone, and a bar that vibrates loses by 2 pi zeta a period, in implicit and in explicit steps.
-- warns: the ledger's error is
-- warns: the velocity of set 'all' is dropped
local fabric = require "fabric"
local long = os.getenv "FABRICSH_TEST_LONG"
local omega = 2 * math.pi * 5
local function card(modulus, shear)
  return fabric.svk { warp = modulus, weft = modulus, shear = shear, poisson = 0, density = 500, thickness = 0.5e-3, bending = { warp = 1e-2, weft = 1e-2, twist = 5e-3 } }
end

-- Two turns about the normal, and about the longer side, with which the directors turn.
local function free(o)
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.02, nx = 8, ny = 2, origin = { -0.05, -0.01 }, triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = card(1e8, 4e7), warp = 0 }
  m:velocity("all", { spin = { o.along and 1800 or 0, 0, o.along and 0 or 1800 } })
  local a = fabric.dynamic { model = m, duration = 0.4, scheme = "implicit", step = 0.2 / o.steps, damping = { stiffness = o.b } }
  local function momentum()
    local sum = 0
    for i, x in ipairs(mesh.nodes) do
      local share = (math.abs(math.abs(x[1]) - 0.05) < 1e-9 and 0.5 or 1) * (math.abs(math.abs(x[2]) - 0.01) < 1e-9 and 0.5 or 1)
      local n = a:node(i)
      sum = sum + share * (o.along and n.y * n.vz - n.z * n.vy or n.x * n.vy - n.y * n.vx)
    end
    return sum
  end
  local start, kinetic = momentum(), a.energy.kinetic
  a:solve()
  local text = ("%s, %d steps a turn, b = %g s%s: "):format(o.triangles and "triangles" or "quads", o.steps, o.b, o.along and ", about its side" or "")
  print(text, momentum() / start, a.energy.damping / kinetic, a.energy.error)
  fabric.expect {
    -- With 100 steps a turn the scheme begins to damp by alpha, as it does without damping, too.
    { text .. "angular momentum", momentum() / start, 1, relative = o.steps > 100 and 1e-3 or 2e-3 },
    { text .. "damping", a.energy.damping / kinetic, 0, absolute = o.steps > 100 and 1e-3 or 4e-3 }, -- of the jerk with which it begins, unstretched
    { text .. "ledger", a.energy.error, 0, absolute = 5e-3 },
  }
end
for _, triangles in ipairs { false, true } do
  for _, b in ipairs { 1e-5, 1e-4 } do
    for _, steps in ipairs { 100, 200, 400 } do
      if long or steps == (b == 1e-5 and 200 or 100) then free { triangles = triangles, b = b, steps = steps } end
    end
  end
  free { triangles = triangles, b = 1e-4, steps = 200, along = true }
end

-- The force on the hub: density times area times omega^2 (R^2 - r^2) / 2.
do
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.02, nx = 8, ny = 2, origin = { 0.05, -0.01 } }
  local m = fabric.model { mesh = mesh, card = card(1e9, 5e8), warp = 0 }
  local free_nodes = {}
  for i, x in ipairs(mesh.nodes) do
    if x[1] > 0.05 + 1e-9 then free_nodes[#free_nodes + 1] = i end
  end
  mesh:set("free", free_nodes)
  m:fix("free", "z"):velocity("all", { spin = { 0, 0, 1800 } })
  m:turn("left", { axis = { 0, 0, 1 }, angle = function(t) return 1800 * t end, centre = { 0, 0, 0 } })
  local a = fabric.dynamic { model = m, duration = 0.1, scheme = "implicit", step = 5e-4, damping = { stiffness = 1e-5 } }
  local sum, count = 0, 0
  a:every("step", function(r)
    if r.time < 0.05 then return end
    local x, y = r:reaction "left"
    sum, count = sum - x * math.cos(omega * r.time) - y * math.sin(omega * r.time), count + 1
  end)
  a:solve()
  fabric.expect { { "force on the hub", sum / count, 500 * 0.5e-3 * 0.02 * omega ^ 2 * (0.15 ^ 2 - 0.05 ^ 2) / 2, relative = 0.02 } }
end

-- The first vibration of a bar along its length. On elements of length h with lumped masses its frequency is 2 c / h sin(k h / 2); energy falls by exp(-b w^2 t).
for _, scheme in ipairs { "implicit", "explicit" } do
  local length, h, speed = 0.1, 0.0125, math.sqrt(1e8 / 500)
  local k = math.pi / 2 / length
  local w = 2 * speed / h * math.sin(k * h / 2)
  local zeta = 0.02
  local mesh = fabric.mesh.rectangle { width = length, height = h, nx = 8, ny = 1 }
  local m = fabric.model { mesh = mesh, card = card(1e8, 4e7), warp = 0 }
  m:fix("left", "x"):fix("all", "y z"):velocity("all", function(x) return { x = 0.01 * math.sin(k * x) } end)
  local period = 2 * math.pi / w / math.sqrt(1 - zeta ^ 2)
  local a = fabric.dynamic { model = m, duration = 5 * period, scheme = scheme, step = scheme == "implicit" and period / 100 or nil, damping = { stiffness = 2 * zeta / w } }
  local start = a.energy.kinetic
  a:solve()
  local decrement = math.log(start / (a.energy.kinetic + a.energy.stored)) / 10
  print(scheme, decrement, 2 * math.pi * zeta / math.sqrt(1 - zeta ^ 2))
  fabric.expect {
    { scheme .. ": decrement", decrement, 2 * math.pi * zeta / math.sqrt(1 - zeta ^ 2), relative = 0.01 },
    { scheme .. ": ledger", a.energy.error, 0, absolute = 2e-3 },
  }
end
