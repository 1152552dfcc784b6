-- A static run, an implicit one and an explicit one with all outputs on, for tests that kill the program.
-- Argument: the folder of the outputs.
local fabric = require "fabric"
local out = arg[1]

local function sheet(n)
  local mesh = fabric.mesh.rectangle { width = 0.3, height = 0.3, nx = n, ny = n }
  return fabric.model { mesh = mesh, card = fabric.card "blend" }
end

local function outputs(a, name, every, seen, middle)
  a:every("step", function(run)
    seen.steps = seen.steps + 1
    if seen.steps % 10 == 0 then seen.times[#seen.times + 1] = run.time end
  end)
  a:event { value = function(run) return run:node(middle).uz + 0.001 end, tolerance = 1e-3, action = function(run) seen.event = run.time end }
  a:record(out .. "/" .. name .. ".csv", { columns = {
    z = function(run) return run:node(middle).uz end,
    external = function(run) return run.energy.external end } })
  a:vtk(out .. "/" .. name, { every = every })
  a:checkpoint(out .. "/run.ckpt", { every = every, keep = seen })
end

local function result(a, name, seen)
  local e = a.energy
  local file = assert(io.open(out .. "/" .. name .. ".txt", "w"))
  for _, k in ipairs { "kinetic", "stored", "dissipated", "external", "damping", "error" } do
    file:write(("%s %a\n"):format(k, e[k]))
  end
  file:write(("%d steps, %d seen, event %s, %s\n"):format(#a.steps, seen.steps, seen.event and ("%a"):format(seen.event),
    table.concat(seen.times, " ")))
  file:close()
end

local strip = sheet(4)
strip:fix("all", "z rotation"):fix("bottom", "x y")
strip:move("top", { y = fabric.history { { 0, 0 }, { 0.6, 0.02 }, { 1, 0.005 } } })
local seen = { steps = 0, times = {} }
local a = fabric.static { model = strip, duration = 1, step = 0.02, stabilise = true }
outputs(a, "static", 0.1, seen, 13)
a:solve()
result(a, "static", seen)

local sail = sheet(4)
sail:fix("top", "x y z"):gravity { 0, 0, -9.81 }
seen = { steps = 0, times = {} }
a = fabric.dynamic { model = sail, duration = 0.2, step = 0.004, scheme = "implicit", hht = -0.1, damping = { mass = 2 } }
outputs(a, "implicit", 0.02, seen, 13)
for i = 1, 5 do a:step() end
a:advance(a.time + 0.1)
a:solve()
result(a, "implicit", seen)

local drape = sheet(6)
drape:fix("corners", "x y z"):gravity { 0, 0, -9.81 }
seen = { steps = 0, times = {} }
a = fabric.dynamic { model = drape, duration = 0.08, damping = { stiffness = 1e-6 } }
outputs(a, "explicit", 0.005, seen, 25)
a:solve()
result(a, "explicit", seen)
