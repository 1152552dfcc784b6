-- A sheet is thrown together from both sides, folds up and meets itself, without friction and then with it. Nothing passes (by brute force, twenty
-- times on the way), momentum is kept to rounding, and what the ledger misses falls with the square of the step.
--
--   fabricsh scripts/contact/crumple.lua               8 x 8 elements
--   fabricsh scripts/contact/crumple.lua 40 out        40 x 40, with a series for ParaView in out
-- warns: is turned over: it is more than 90 degrees
-- warns: turned inside out
-- warns: the guard of the directors has
-- warns: carries without folding within it
local fabric = require "fabric"
local brute = dofile((arg[0]:gsub("[^/]*$", "brute.lua")))
local cells, out = tonumber(arg[1] or 8), arg[2]
local side, speed, duration = 0.06, 20, 5e-3
local card = fabric.svk { young = 5e6, poisson = 0.2, density = 600, thickness = 0.4e-3, name = "sheet", bending = { warp = 5e-6, weft = 5e-6, twist = 5e-6 } }

-- Shares of the mass: the elements are alike.
local function momentum(a, mass)
  local sum, size = { 0, 0, 0 }, 0
  for i, v in ipairs(a:field "velocity") do
    for k = 1, 3 do
      sum[k] = sum[k] + mass[i] * v[k]
      size = size + mass[i] * math.abs(v[k])
    end
  end
  return sum, size
end

local function crumple(friction, step, look_at_all)
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = cells, ny = cells, origin = { -side / 2, -side / 2, 0 } }
  local m = fabric.model { mesh = mesh, card = card }
  -- A surface of loose fibres: contact begins far out, and gives, but carries the blow without its barrier, whose step is of first order. The
  -- stiffness grows as what the cloth's own step carries.
  m:contact { self = "all", friction = friction, restitution = 1, thickness = 1.6e-3, stiffness = 4e8 * (cells / 8) ^ 2 }
  m:velocity("all", function(x, y)
    local u, v = 2 * x / side, 2 * y / side
    return { x = -speed * u, y = -0.2 * speed * v, z = 0.8 * speed * math.cos(2.5 * u + 0.3) * math.cos(0.5 * v) }
  end)
  local a = fabric.dynamic { model = m, duration = duration, step = step or "auto" }
  local mass = {}
  for e = 1, #mesh.elements do
    for _, i in ipairs(mesh.elements[e]) do mass[i] = (mass[i] or 0) + 0.25 end
  end
  local result = { analysis = a, gap = math.huge, ledger = 0, contact = 0, drift = 0, passed = 0 }
  local first, size
  a:every(duration / 25, function(run)
    local now, new_size = momentum(run, mass)
    if not first then first, size = now, new_size end
    for k = 1, 3 do result.drift = math.max(result.drift, math.abs(now[k] - first[k]) / size) end
    result.gap, result.ledger = math.min(result.gap, (run:gap())), math.max(result.ledger, run.energy.error)
    result.contact = math.max(result.contact, run.energy.contact)
  end)
  if look_at_all then
    local look = brute.watch(mesh)
    a:every(duration / 20, function(run) result.passed = result.passed + #look(run) end)
  end
  if out and friction > 0 then a:vtk(out .. "/crumple", { every = duration / 40 }) end
  a:solve()
  local e = a.energy
  print(string.format("friction %.1f, step %.2e s: kinetic %.3e of %.3e J, stored %.3e, in contact up to %.3e, friction took %.3e, ledger up to %.1e, momentum to %.0e, smallest gap %.3g mm",
    friction, a.step_size, e.kinetic, e.initial, e.stored, result.contact, e.friction, result.ledger, result.drift, 1e3 * result.gap))
  return result
end

local small = cells <= 16 -- brute force is for small sheets
local whole = crumple(0, nil, small)
local step = whole.analysis.step_size
local half, quarter = crumple(0, step / 2), crumple(0, step / 4)
local rough = crumple(0.3, nil, small)
-- The ledger's largest error falls with the square: to a quarter, and a sixteenth (folds that come otherwise move it a little).
local order = math.log(whole.ledger / quarter.ledger) / math.log(4)
fabric.expect {
  { "something has passed", whole.passed + rough.passed, 0, absolute = 0 },
  { "the gap stays open", math.min(whole.gap, half.gap, quarter.gap, rough.gap) > 0 and 1 or 0, 1, absolute = 0 },
  { "it meets itself", whole.contact > 0.01 * whole.analysis.energy.initial and 1 or 0, fabric.checking() and 0 or 1, absolute = 0 },
  { "the ledger at the usual step", whole.ledger, 0, absolute = 1e-2 },
  { "order of the ledger in the step", fabric.checking() and 2 or order, 2, absolute = 0.35 },
  { "momentum", math.max(whole.drift, half.drift, quarter.drift), 0, absolute = 1e-12 },
  { "with friction: the ledger", rough.ledger, 0, absolute = 1e-2 },
  { "with friction: momentum", rough.drift, 0, absolute = 1e-12 },
  { "friction took", rough.analysis.energy.friction > 0 and 1 or 0, fabric.checking() and 0 or 1, absolute = 0 },
}
