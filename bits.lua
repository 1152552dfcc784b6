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
