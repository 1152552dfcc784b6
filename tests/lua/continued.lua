-- A run that goes on from one with damping takes over what that has lost: its ledger begins, and stays, in balance. A cloth that hangs and swings,
-- explicit, implicit, and one after the other; the way of the damped run in one piece.
local fabric = require "fabric"
local function model()
  local mesh = fabric.mesh.rectangle { width = 0.16, height = 0.08, nx = 4, ny = 2 }
  local card = fabric.svk { young = 1e6, poisson = 0, density = 400, thickness = 0.5e-3, name = "sheet" }
  return fabric.model { mesh = mesh, card = card, warp = 0 }:fix("left", "x y z"):gravity { 0, 0, -9.81 }
end
local damping = { mass = 20 }
local whole = fabric.dynamic { model = model(), duration = 0.09, damping = damping }:solve()
local first = fabric.dynamic { model = model(), duration = 0.05, damping = damping }:solve()
local lost = first.energy.damping
local function goes_on(from, scheme, duration, inertia)
  local run = fabric.dynamic { from = from, duration = duration, scheme = scheme, inertia = inertia, step = scheme == "implicit" and 5e-4 or nil, damping = damping }
  local begins = run.energy
  return run:solve(), begins
end
local rows = { { "something is lost before", lost > 1e-6 and 1 or 0, 1, absolute = 0 } }
local function add(what, run, begins)
  rows[#rows + 1] = { what .. ": error of the ledger at the beginning", begins.error, 0, absolute = 1e-12 }
  rows[#rows + 1] = { what .. ": at the end", run.energy.error, 0, absolute = 2e-3 }
  rows[#rows + 1] = { what .. ": more is lost", run.energy.damping > begins.damping and 1 or 0, 1, absolute = 0 }
  rows[#rows + 1] = { what .. ": z of the free edge", run:node(5).z, whole:node(5).z, relative = 5e-3 } -- the steps of 0.5 ms
end
for _, scheme in ipairs { "explicit", "implicit" } do
  local run, begins = goes_on(first, scheme, 0.04)
  rows[#rows + 1] = { scheme .. ": what was lost before", begins.damping, lost, relative = 1e-12 }
  add(scheme, run, begins)
end
local half = goes_on(first, "implicit", 0.02)
-- Directors swing in implicit steps, and inertia that is scaled up would make energy of their rates.
local back, begins = goes_on(half, "explicit", 0.02, "true")
add("implicit, then explicit", back, begins)
fabric.expect(rows)

-- Velocities that a new support takes from it are told as those of the run before.
local held = fabric.dynamic { from = first, model = model():fix("right", "x y z"), duration = 1e-3 }
held:solve()
local told
for _, w in ipairs(held.warnings) do told = told or w.code == "dropped" and w.text end
assert(told and told:find("the velocities of the run before are dropped along x y z at 3 of their nodes", 1, true), told)
