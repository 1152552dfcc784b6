-- A ball falls onto a clamped square: nothing passes at any step, the ledger is closed, implicit and explicit runs agree on two meshes, and
-- the program gives the same bits with 1, 2 and 4 threads and when it is killed and goes on from its checkpoint. The short form has one mesh, is killed
-- with two threads and goes on with four.
local fabric = require "fabric"
local brute = dofile((arg[0]:gsub("[^/]*$", "../../scripts/contact/brute.lua")))
local card = fabric.card("blend", { bending = "estimated" })
local long = os.getenv "FABRICSH_TEST_LONG"

-- --- nothing passes; implicit and explicit ---
local function drop(cells, scheme, step)
  local test = fabric.lab.ball_drop { card = card, mass = 0.05, height = 0.1, cells = cells, duration = 0.018, scheme = scheme, step = step, every = 2.5e-4 }
  local e = test.analysis.energy
  print(string.format("%2d x %2d %-8s  deflection %.4f mm, force %.3f N, smallest gap above the floor %.4f mm, friction took %.2e J, ledger %.0e", cells, cells,
    scheme, 1e3 * test.deflection, test.force, 1e3 * test.gap, e.friction, e.error))
  assert(test.gap > 0 and e.friction > 0 and e.error < 1e-3)
  return test.deflection
end
for _, cells in ipairs(long and { 6, 8 } or { 6 }) do
  local explicit, implicit = drop(cells, "explicit"), drop(cells, "implicit", 5e-5)
  print(string.format("%2d x %2d implicit over explicit %.5f", cells, cells, implicit / explicit))
  assert(math.abs(implicit / explicit - 1) < 2e-3)
end

-- The nearest facet at every step, by brute force: not nearer to the ball's surface than the floor of contact.
do
  local radius, floor_ = 0.03, math.min(card.density * card.thickness / 1500, 0.75 * card.thickness) / 2
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 8, ny = 8 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0, points = 1 }
  m:fix("boundary", "x y z rotation"):gravity { 0, 0, -9.81 }
  local ball = fabric.rigid.sphere { radius = radius, centre = { 0.1, 0.1, radius + card.thickness / 2 + 1e-4 }, mass = 0.05 }
  m:contact { between = { ball, "all" }, friction = 0.2 }
  m:velocity(ball, { z = -1.4 })
  local a = fabric.dynamic { model = m, duration = 0.016 }
  local look, steps = brute.watch(mesh, { { body = ball, radius = radius + floor_ } }), 0
  a:every("step", function(run)
    steps = steps + 1
    local found = look(run)
    assert(#found == 0, string.format("at %g s %s", run.time, found[1]))
  end)
  a:solve()
  print(steps .. " steps, at none is a facet within the floor of the ball; ledger " .. string.format("%.0e", a.energy.error))
  assert(steps > 100 and a.energy.error < 1e-3)
end

-- --- the same bits ---
local file = assert(io.open("bits.lua", "wb"))
file:write [[
local fabric = require "fabric"
local card = fabric.card("blend", { bending = "estimated" })
local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 68, ny = 68 } -- above the size from which threads share the loops of contact
local m = fabric.model { mesh = mesh, card = card, warp = 0, points = 1 }
m:fix("boundary", "x y z rotation"):gravity { 0, 0, -9.81 }
local ball = fabric.rigid.sphere { radius = 0.008, centre = { 0.1013, 0.0991, 0.008 + card.thickness / 2 + 1e-6 }, mass = 0.05 }
m:contact { between = { ball, "all" }, friction = 0.3 }:contact { self = "all", friction = 0.3 }
m:velocity(ball, { x = 0.5, z = -6, spin = { 0, 2000, 0 } })
local a = fabric.dynamic { model = m, duration = 1.2e-4 }
a:every(4e-5, function(run)
  if run.time > 7e-5 and arg[1] == "dies" then os.exit(9, false) end
end)
a:checkpoint("bits.ckpt", { every = 1e-5 })
a:solve()
assert(a.energy.friction > 0 and a.energy.error < 1e-3)
for _, name in ipairs { "position", "velocity", "director", "S", "gap", "contact_pressure" } do
  for _, row in ipairs(a:field(name)) do
    for _, x in ipairs(type(row) == "table" and row or { row }) do io.write(("%a "):format(x)) end
  end
end
for _, x in ipairs { a:body(ball) } do io.write(("%a "):format(x)) end
for _, name in ipairs { "kinetic", "rigid", "stored", "contact", "friction", "external" } do io.write(("%a "):format(a.energy[name])) end
]]
file:close()
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local function program(words) return check.shell(("'%s' --quiet %s 2>bits.log"):format(arg[-1], words)) end
local code, first = program "--threads 1 bits.lua lives"
assert(code == 0 and #first > 1e5, code)
for _, threads in ipairs(long and { 2, 4 } or {}) do
  local _, out = program("--threads " .. threads .. " bits.lua lives")
  assert(out == first, threads .. " threads")
end
code = program "--threads 2 bits.lua dies"
assert(code == 9, code)
local _, again = program(("--threads %d --restart bits.ckpt bits.lua lives"):format(long and 1 or 4))
assert(again == first, "after a restart")
print(("the same %d bytes with 1, 2 and 4 threads and after a restart"):format(#first))
