-- Friction holds where a barrier carries what the law of contact cannot: a ball drawn through a held sheet pulls by friction times its normal force,
-- roughly whatever the stiffness; a strip over a drum has the ratio of its tensions; and static friction is held, in static steps of any size.
-- The short form has fewer stiffnesses and sizes of steps.
local fabric = require "fabric"
local mm = fabric.units.mm
local checks = {}
local long = os.getenv "FABRICSH_TEST_LONG"
local card = fabric.svk { density = 500, thickness = 0.5 * mm, warp = 40e6, weft = 25e6, shear = 9e6, poisson = { 0.25, 0.15625 }, bending = { warp = 4e-5, weft = 3e-5, twist = 2e-5 } }

-- (Fx with friction, less without) over friction times the normal force, after 1.5 and 3 mm.
local function share(scheme, stiffness, radius, triangles)
  local function forces(friction)
    local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.06, nx = 8, ny = 8, origin = { -0.03, -0.03 }, triangles = triangles }
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("boundary", "x y z")
    local ball = fabric.rigid.sphere { radius = radius, centre = { -0.002, 0, radius + 0.3 * mm } }
    m:contact { between = { ball, "all" }, friction = friction, stiffness = stiffness }
    local D = scheme == "explicit" and 0.02 or 0.1
    m:move(ball, { x = fabric.history { { 0, 0 }, { D / 2, 0 }, { D, 3 * mm } }, z = fabric.history { { 0, 0 }, { D / 2, -5 * mm }, { D, -5 * mm } } })
    local a = scheme == "static" and fabric.static { model = m, duration = D, step = D / 16 }
      or fabric.dynamic { model = m, duration = D, scheme = scheme, step = scheme == "implicit" and D / 40 or nil, slow = scheme == "implicit" or nil, damping = scheme == "explicit" and { mass = 200 } or nil }
    local out = {}
    for _, t in ipairs { 0.75, 1 } do
      a:advance(t * D)
      local x, _, z = a:reaction(ball)
      out[#out + 1], out[#out + 2] = x, z
    end
    return out
  end
  local mu = 0.3
  local with, without = forces(mu), forces(0)
  return (with[1] - without[1]) / (-mu * with[2]), (with[3] - without[3]) / (-mu * with[4])
end
-- Explicit steps carry no stiffer spring of friction than the law's; they say that the barrier acts.
local rows = { { "static", 2e7, 12 * mm, true }, { "implicit", nil, 8 * mm }, { "explicit", nil, 8 * mm } }
if long then rows[#rows + 1] = { "static", 2e8, 12 * mm } end
for _, row in ipairs(rows) do
  local half, whole = share(table.unpack(row, 1, 4))
  for i, value in ipairs { half, whole } do
    checks[#checks + 1] = { ("%s, %s Pa/m, %d"):format(row[1], row[2] or "assumed", i), value, 1, absolute = row[1] == "explicit" and 0.3 or 0.2 }
  end
end

for _, stiffness in ipairs(long and { 1e7, 3e5 } or { 3e5 }) do
  local soft = fabric.svk { young = 1e8, poisson = 0, density = 500, thickness = 0.4 * mm, bending = { warp = 1e-6, weft = 1e-6, twist = 5e-7 } }
  local r = fabric.lab.capstan { card = soft, wrap = 90, friction = 0.3, radius = 0.03, around = 16, lead = 6, draw = 0.15, step = 0.1, stiffness = stiffness, tension = 10 }
  checks[#checks + 1] = { ("capstan, %g Pa/m"):format(stiffness), r.ratio, math.exp(0.3 * math.pi / 2), relative = 0.02 }
end

-- A sheet under 0.6 N on a spring of 100 N/m: pulled by 0.4 N it slides to 2.2 mm, and the spring's 0.22 N, which kinetic friction would not hold,
-- leave it there.
for _, steps in ipairs(long and { 16, 64 } or { 16 }) do
  for _, scheme in ipairs { "static", "slow" } do
    local rigid = fabric.svk { warp = 5e8, weft = 5e8, shear = 2e8, poisson = 0, density = 500, thickness = 0.4 * mm, bending = { warp = 2e-5, weft = 2e-5, twist = 1e-5 } }
    local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.03, height = 0.02, nx = 3, ny = 2 }, card = rigid, warp = 0 }
    local floor = fabric.rigid.plane { point = { 0, 0, -0.19 * mm }, normal = { 0, 0, 1 } }
    m:contact { between = { floor, "all" }, friction = { static = 0.4, kinetic = 0.3 }, stiffness = 1e9 }
    m:force("all", { z = fabric.ramp(-0.6, 0.5) }):spring("all", { x = 100 }):fix("all", "y")
    m:force("all", { x = fabric.history { { 0, 0 }, { 0.5, 0 }, { 2, 0.4 }, { 3, 0 } } })
    local a = scheme == "static" and fabric.static { model = m, duration = 3, step = 3 / steps }
      or fabric.dynamic { model = m, duration = 3, step = 3 / steps, scheme = "implicit", slow = true }
    a:solve()
    checks[#checks + 1] = { ("%s friction holds, %d steps, mm"):format(scheme, steps), a:node(6).ux / mm, 2.2, absolute = 0.06 }
  end
end
fabric.expect(checks)
