-- Contact with friction in statics, by relaxation and in implicit motion: the same bits on one and two threads, and when the process is killed
-- and the deck goes on from its checkpoint. Explicit motion: tests/lua/contact_ball.lua. With
-- FABRICSH_TEST_LONG a whole run has two threads, too, and goes on with one.
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local file = assert(io.open("scheme_bits.lua", "wb"))
file:write [[
local fabric = require "fabric"
local scheme, dies = arg[1], arg[2] == "dies"
local card = fabric.card("blend", { bending = "estimated" })
local cells = scheme == "implicit" and 24 or 30
local mesh = fabric.mesh.rectangle { width = 0.05, height = 0.05, nx = cells, ny = cells, triangles = scheme == "relaxation" }
local m = fabric.model { mesh = mesh, card = card, warp = 0, points = 1 }
m:fix("boundary", "x y z")
local ball = fabric.rigid.sphere { radius = 0.012, centre = { 0.0252, 0.0247, 0.012 + card.thickness / 2 - 1e-6 }, mass = scheme == "implicit" and 0.02 or nil }
m:contact { between = { ball, "all" }, friction = 0.3 }
local a
if scheme == "implicit" then
  m:velocity(ball, { x = 0.3, z = -1, spin = { 0, 200, 0 } })
  a = fabric.dynamic { model = m, duration = 3e-4, scheme = "implicit", step = 1e-4 }
else
  m:move(ball, { x = fabric.ramp(1e-4, 1), z = fabric.ramp(-3e-4, 1) })
  a = fabric.static { model = m, duration = 1, step = 0.34, method = scheme == "relaxation" and "relaxation" or nil }
end
local steps = 0
a:every("step", function(run)
  steps = steps + 1
  if dies and steps == 3 then os.exit(9, false) end
end)
a:checkpoint("scheme_bits.ckpt", { every = a.duration / 100 })
a:solve()
assert(a.energy.friction > 0 and a.energy.contact > 0, a.energy.friction)
for _, name in ipairs { "position", "director", "S", "contact_pressure" } do
  for _, row in ipairs(a:field(name)) do
    for _, x in ipairs(type(row) == "table" and row or { row }) do io.write(("%a "):format(x)) end
  end
end
for _, x in ipairs { a:reaction(ball) } do io.write(("%a "):format(x)) end
for _, name in ipairs { "stored", "contact", "stick", "friction", "external" } do io.write(("%a "):format(a.energy[name])) end
]]
file:close()
-- Each scheme prints more than 1e5 bytes.
check.same_bits("scheme_bits.lua", "scheme_bits.ckpt", { "static", "relaxation", "implicit" }, 1e5)
