-- A run that goes on from another one has the stiffness of its contacts, also where it was assumed: nothing jumps.
local fabric = require "fabric"
local card = fabric.card("blend", { bending = "estimated" })
local function model(stiffness, friction, more)
  local mesh = fabric.mesh.rectangle { width = 0.06, height = 0.06, nx = 6, ny = 6, origin = { -0.03, -0.03, 0 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("boundary", "x y z")
  local ball = fabric.rigid.sphere { radius = 0.02, centre = { 0, 0, -0.02 - card.thickness / 2 } }
  m:move(ball, { z = function(t) return 3e-3 * math.min(1, t) end }):contact { between = { ball, "all" }, friction = friction or 0.3, stiffness = stiffness }
  if more then m:contact { between = { fabric.rigid.plane { point = { 0, 0, -0.1 }, normal = { 0, 0, 1 } }, "all" } } end
  return m, ball
end
local function force(a, ball) return select(3, a:reaction(ball)) end
local m, ball = model()
local pressed = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
local F = force(pressed, ball)
assert(F > 0.1)

local function goes_on(name, kind, from, options)
  local o = { from = from, duration = options.duration or 2e-3 }
  for key, value in pairs(options) do o[key] = value end
  local a = fabric[kind](o)
  local first
  a:every("step", function(r)
    if first then return end
    first = true
    fabric.expect {
      { name .. ": the force", force(r, ball), force(from, ball), relative = 1e-4 }, -- with friction, whose slip turns with the surface
      { name .. ": energy stored", r.energy.stored, from.energy.stored, relative = 1e-6 },
    }
  end)
  a:advance(from.time + 1e-3)
  local there = a:snapshot()
  a:solve()
  local last = force(a, ball)
  a:restore(there):solve()
  assert(force(a, ball) == last)
  return a
end
local slow = goes_on("slow", "dynamic", pressed, { scheme = "implicit", step = 1e-3, slow = true })
fabric.expect { { "slow: stays", force(slow, ball), F, relative = 1e-4 } }
goes_on("implicit", "dynamic", pressed, { scheme = "implicit", step = 1e-3 })
local moving = goes_on("explicit", "dynamic", pressed, { damping = { mass = 50 } })
goes_on("back to statics", "static", moving, { step = 1e-3 })

-- From a motion with what its steps carry to statics.
local n
n, ball = model()
moving = fabric.dynamic { model = n, duration = 1, step = 0.05, scheme = "implicit", slow = true }:solve()
assert(math.abs(force(moving, ball) / F - 1) > 2e-3) -- the two assume other stiffnesses
goes_on("statics", "static", moving, { step = 1e-3 })

-- A deck that gives another has that; beside other contacts the one that stays goes on as it was.
m, ball = model(nil, 0) -- slips are those of the same contacts alone
pressed = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
F = force(pressed, ball)
local function first_force(changed, its)
  local a, first = fabric.dynamic { from = pressed, model = changed, duration = 2e-3, scheme = "implicit", step = 1e-3 }, nil
  a:every("step", function(r) first = first or force(r, its) end)
  a:step()
  return first / F
end
fabric.expect { { "beside a plane too", first_force(model(nil, 0, true)), 1, absolute = 1e-6 } }
assert(math.abs(first_force(model(1e8, 0)) - 1) > 0.1)
