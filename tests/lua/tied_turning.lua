-- Cloth tied to a rod that turns, in implicit steps: the work of the rod is that of its moment, and none of it that of its pressure on what turns with it. A
-- strip is drawn onto a rod by a quarter of a turn against a constant force; a longer one is wound up over itself.
-- warns: the ledger's error is
-- warns: the time scheme has taken
local fabric = require "fabric"
local long = os.getenv "FABRICSH_TEST_LONG"
local mm = fabric.units.mm
local card = fabric.card("blend"):with { bending = { warp = 5e-6, weft = 5e-6, twist = 2e-6 } }
local r, force = 10 * mm, 0.2
local function smooth(q)
  q = math.max(0, math.min(1, q))
  return q * q * (3 - 2 * q)
end

local function wind(o)
  local mesh = fabric.mesh.rectangle { width = o.length, height = 8 * mm, nx = o.nx, ny = 1, triangles = o.triangles }
  mesh:map(function(x, y) return x, y, r + card.thickness / 2 end)
  local m = fabric.model { mesh = mesh, card = card, warp = { 1, 0, 0 } }
  local rod = fabric.rigid.cylinder { radius = r, from = { 0, -0.03, 0 }, to = { 0, 0.04, 0 }, name = "rod" }
  m:fix("all", "y"):move(rod, { turn = { axis = { 0, 1, 0 }, angle = function(t) return -o.angle * smooth(t / o.time) end } }):tie("rigid", "left", rod)
  m:force("right", { x = fabric.history { { 0, 0 }, { 0.02, force }, { 1, force } } }):fix("right", "z")
  m:contact { between = { rod, "all" }, friction = o.friction or 0 }
  if o.angle > 180 then m:contact { self = "all", friction = o.friction } end
  local a = fabric.dynamic { model = m, duration = o.time + 0.02, scheme = "implicit", step = o.step, damping = { mass = 10 },
    slow = o.slow, spectral_radius = o.radius, ledger_limit = o.limit }
  a:solve()
  local e, passed = a.energy, force * (o.length - a:node(mesh:set "right"[1]).x)
  local made = (e.kinetic + e.stored + e.dissipated + e.damping - e.external) / passed
  local text = ("%g degrees, %s, step %g s%s%s: "):format(o.angle, o.triangles and "triangles" or "quads", o.step, o.slow and ", slow" or "", o.radius and ", radius " .. o.radius or "")
  print(text, made, a.energy.error)
  fabric.expect { { text .. "made of what passed", made, 0, absolute = o.made } }
  return a, text
end

for _, triangles in ipairs { false, true } do
  for _, step in ipairs { 0.01, 0.005 } do
    if long or step == 0.01 or not triangles then
      wind { length = 0.1, nx = 20, angle = 90, time = 0.2, step = step, slow = true, limit = 50, made = 40 * step ^ 2, triangles = triangles }
      -- Rules with a mean make energy where tension pushes on what turns: (1 - theta) times the angle of a step.
      wind { length = 0.1, nx = 20, angle = 90, time = 0.2, step = step, radius = 0.9, limit = 50, made = 4 * step, triangles = triangles }
    end
  end
end
local a, text = wind { length = 0.2, nx = 80, angle = 270, time = 0.3, step = 0.01, friction = 0.2, made = 1e-3 }
fabric.expect { { text .. "ledger", a.energy.error, 0, absolute = 1.5e-2 } }

-- What else presses the tied cloth works as before: a sleeve tied all over to a rod, and a roller pressed on it.
do
  local h = card.thickness
  local R, rr, q0 = r + 0.55 * h, 20 * mm, math.rad(70)
  local mesh = fabric.mesh.rectangle { width = 50 * mm, height = 8 * mm, nx = 40, ny = 1 }
  mesh:map(function(x, y) return R * math.sin(x / R), y, R * math.cos(x / R) end)
  local m = fabric.model { mesh = mesh, card = card, warp = function(x, _, z) return { z, 0, -x } end }
  local x0, z0 = (R + 0.55 * h + rr) * math.sin(q0), (R + 0.55 * h + rr) * math.cos(q0)
  local rod = fabric.rigid.cylinder { radius = r, from = { 0, -0.03, 0 }, to = { 0, 0.04, 0 }, name = "rod" }
  local roller = fabric.rigid.cylinder { radius = rr, from = { x0, -0.03, z0 }, to = { x0, 0.04, z0 }, mass = 0.02, name = "roller" }
  local function push(part) return fabric.history { { 0, 0 }, { 0.02, -2 * part }, { 9, -2 * part } } end
  m:fix(roller, "y rotation"):damper(roller, { x = 200, z = 200 }):spring(roller, { x = 3e4, z = 1e4 })
  m:force(roller, { x = push(math.sin(q0)), z = push(math.cos(q0)) })
  m:move(rod, { turn = { axis = { 0, 1, 0 }, angle = function(t) return 60 * smooth((t - 0.03) / 0.2) end } }):tie("rigid", "all", rod)
  m:contact { between = { rod, "all" }, stiffness = 1e9 }:contact { between = { roller, "all" }, stiffness = 1e9 }
  local a = fabric.dynamic { model = m, duration = 0.24, scheme = "implicit", step = 0.01, damping = { mass = 10 } }
  a:solve()
  fabric.expect { { "roller on a tied sleeve: ledger", a.energy.error, 0, absolute = 1e-3 } }
end

-- A run that goes over to gamma=1 keeps the forces of its contacts and ties: the strip is drawn onto the rod by more than a quarter of a turn.
do
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 8 * mm, nx = 40, ny = 1 }
  mesh:map(function(x, y) return x, y, r + card.thickness / 2 end)
  local m = fabric.model { mesh = mesh, card = card, warp = { 1, 0, 0 } }
  local rod = fabric.rigid.cylinder { radius = r, from = { 0, -0.03, 0 }, to = { 0, 0.04, 0 }, name = "rod" }
  m:fix("all", "y"):move(rod, { turn = { axis = { 0, 1, 0 }, angle = function(t) return -120 * smooth(t / 0.2) end } }):tie("rigid", "left", rod)
  m:force("right", { x = fabric.history { { 0, 0 }, { 0.02, force }, { 1, force } } }):contact { between = { rod, "all" }, friction = 0.2 }
  local a = fabric.dynamic { model = m, duration = 0.1, scheme = "implicit", step = 0.01, damping = { mass = 10 } }
  local least = math.huge
  a:every("step", function()
    if a.time > 0.04 then least = math.min(least, math.abs((a:reaction(rod)))) end
  end)
  a:solve()
  fabric.expect { { "least force of the rod", least, force, absolute = 0.05 * force }, { "with a change of the rule: ledger", a.energy.error, 0, absolute = 0.04 } }
end

-- The end of a strip that m:turn takes about a centre, against a force that keeps its direction: rules that count forces at the end of a step know its
-- work as well as others, within the order of the step.
do
  local function led(o, triangles)
    local mesh = fabric.mesh.rectangle { width = 50 * mm, height = 8 * mm, nx = 10, ny = 1, origin = { 50 * mm, 0, 0 }, triangles = triangles }
    local m = fabric.model { mesh = mesh, card = card, warp = { 1, 0, 0 } }
    m:fix("right", "y"):turn("left", { axis = { 0, 1, 0 }, angle = function(t) return -90 * smooth(t / 0.2) end, centre = { 0, 0, 0 } })
    m:force("right", { x = function(t) return force * smooth(t / 0.05) end })
    o.model, o.duration, o.scheme, o.damping, o.ledger_limit = m, 0.22, "implicit", { mass = 20 }, 1
    return fabric.dynamic(o):solve().energy.external
  end
  for _, triangles in ipairs { false, true } do
    local truth = led({ step = 1e-3, spectral_radius = 0.9 }, triangles)
    for _, step in ipairs { 0.01, 0.005 } do
      for i, o in ipairs { { slow = true }, { gamma = 1 } } do
        local theta = i == 1 and 1 or 0.75
        o.step = step
        local text = ("m:turn about a centre, %s, theta %g, step %g s: work"):format(triangles and "triangles" or "quads", theta, step)
        fabric.expect { { text, led(o, triangles), truth, relative = 24 * (theta - 0.5) * step } }
      end
    end
  end
end
