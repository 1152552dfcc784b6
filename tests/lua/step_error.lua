-- Implicit steps as long as the error asked for allows: a plate that swings on a hinge and a membrane that vibrates in its
-- plane, against closed forms; squares and triangles; the same bits from a snapshot.
local fabric = require "fabric"
local L, g = 0.12, 9.81

local function runs(m, o)
  local a = fabric.dynamic { model = m, duration = o.duration, scheme = "implicit", step = o.step, error = o.error }
  if o.halfway then
    local kept = a:advance(0.6 * o.duration):snapshot()
    if o.halfway == "again" then a:solve():restore(kept) end
  end
  a:solve()
  local cuts = 0
  for _, s in ipairs(a.steps) do cuts = cuts + s.cuts end
  return a, #a.steps, cuts
end

-- All mass on its free edge: a pendulum, let go where it is level, that swings for a quarter of its period.
local function swing(o)
  local card = fabric.svk { name = "plate", young = 2e8, poisson = 0, density = 400, thickness = 1e-4 }
  local mesh = fabric.mesh.rectangle { width = L, height = 0.05, nx = 1, ny = 1, triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("left", "x y z"):fix("right", "y"):gravity { 0, 0, -g }
  o.duration = 1.8540746773 * math.sqrt(L / g) -- K(1/2) of the complete elliptic integral
  local a, steps, cuts = runs(m, o)
  local node = a:node(2)
  return math.abs(node.x), steps, cuts, a
end

-- k = E A / L and half the mass on its free edge, pushed; one period and a third.
local function vibrate(o)
  local E, rho, w = 3e6, 350, 1e-4
  local card = fabric.svk { name = "soft", warp = E, weft = E, shear = E / 2, poisson = { 0, 0 }, density = rho, thickness = 5e-4 }
  local mesh = fabric.mesh.rectangle { width = L, height = 0.05, nx = 1, ny = 1, triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local omega = math.sqrt(2 * E / rho) / L
  m:fix("left", "x y z rotation"):fix("right", "y z rotation"):tie("equal", "right", "x"):velocity("right", { x = w * omega })
  o.duration = 2 * math.pi / omega * 4 / 3
  local a, steps, cuts = runs(m, o)
  return math.abs(a:node(2).ux - w * math.sin(8 * math.pi / 3)), steps, cuts, a
end

for name, case in pairs { swing = { swing, 2e-4 }, vibration = { vibrate, 2e-6 } } do
  for _, triangles in ipairs { false, true } do
    local last, fewer
    for k = 0, 2 do
      local off, steps, cuts, a = case[1] { error = case[2] / 8 ^ k, triangles = triangles }
      print(("%s, error %.3g: off by %.3g m, %d steps, %d cut"):format(name, case[2] / 8 ^ k, off, steps, cuts))
      -- Of second order: eight times less a step takes twice the steps, and leaves a quarter of the error.
      fabric.expect {
        { "energy", a.energy.error, 0, absolute = 5e-3 },
        last and { name .. ": of the error", off / last, 0.25, absolute = 0.12 },
        fewer and { name .. ": times the steps", steps / fewer, 2, absolute = 0.35 },
      }
      last, fewer = off, steps
    end
  end
end

-- A free body on a spring and a damper beside cloth at rest, pushed: x = v sin(wd t) exp(-zeta t) / wd.
local last, fewer
for k = 0, 2 do
  local card = fabric.svk { name = "still", young = 1e7, poisson = 0, density = 500, thickness = 5e-4 }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 1, ny = 1 }, card = card, warp = 0 }
  local ball = fabric.rigid.sphere { radius = 0.01, centre = { 0.3, 0.05, 0.3 }, mass = 0.02, name = "ball" }
  m:fix("all", "x y z rotation"):contact { between = { ball, "all" } }:spring(ball, { x = 8 }):damper(ball, { x = 0.08 })
  m:velocity(ball, { x = 1 }):fix(ball, "y z rotation")
  local a, steps = runs(m, { duration = 0.3, step = 0.02, error = 1e-3 / 8 ^ k })
  local zeta = 2
  local wd = math.sqrt(400 - zeta ^ 2)
  local off = math.abs(a:body(ball) - 0.3 - math.exp(-zeta * 0.3) * math.sin(wd * 0.3) / wd)
  print(("body, error %.3g: off by %.3g m, %d steps"):format(1e-3 / 8 ^ k, off, steps))
  fabric.expect {
    { "body: energy", a.energy.error, 0, absolute = 1e-9 },
    last and { "body: of the error", off / last, 0.25, absolute = 0.12 },
    fewer and { "body: times the steps", steps / fewer, 2, absolute = 0.35 },
  }
  last, fewer = off, steps
end

local _, _, _, a = swing { error = 1e-5, halfway = "once" }
local _, _, _, b = swing { error = 1e-5, halfway = "again" }
assert(#a.steps == #b.steps and a:node(2).x == b:node(2).x and a:node(2).z == b:node(2).z)

-- step= is the largest; without it, a twentieth of the duration.
local _, steps = swing { error = 0.5, step = 1e-3 }
fabric.expect { { "steps of the largest size", steps, math.ceil(1.8540746773 * math.sqrt(L / g) / 1e-3), absolute = 0 } }
_, steps = swing { error = 0.5 }
fabric.expect { { "steps without a size", steps, 20, absolute = 0 } }
