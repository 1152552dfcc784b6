-- slow=true is the quasi-static motion of a wearer: the path of the statics, friction loops closed, next to no inertia, and
-- the loss told.
local fabric = require "fabric"
local mm = fabric.units.mm

-- There, back, beyond and there again, in half a second.
local turns = { { 0, 0 }, { 0.1, 1 }, { 0.3, -0.6 }, { 0.5, 1 } }
local function way(most)
  local points = {}
  for i, p in ipairs(turns) do points[i] = { p[1], most * p[2] } end
  return fabric.history(points)
end
local function at(t)
  for i = 2, #turns do
    local a, b = turns[i - 1], turns[i]
    if t <= b[1] + 1e-9 then return a[2] + (b[2] - a[2]) * (t - a[1]) / (b[1] - a[1]) end
  end
end

local function compare(name, make, reading, o)
  local function run(kind, options)
    options.model, options.duration = make(), 0.5
    local a, forces, last, loop = fabric[kind](options), {}, 0, 0
    a:every(0.02, function(r)
      local force, place = reading(r), o.most * at(r.time)
      forces[#forces + 1] = force
      loop, last = loop + force * (place - last), place
    end)
    a:solve()
    return { forces = forces, energy = a.energy, loop = loop }
  end
  local reference = run("static", { step = o.step })
  local slow = run("dynamic", { step = o.step, scheme = "implicit", slow = true })
  local finer = run("dynamic", { step = o.step / 2, scheme = "implicit", slow = true })
  local most, off = 0, 0
  for i, force in ipairs(reference.forces) do
    most, off = math.max(most, math.abs(force)), math.max(off, math.abs(force - slow.forces[i]))
  end
  local e, of = slow.energy, o.account
  local lost = reference.energy[of]
  print(("%s: force off by %.3g of %.3g N; loop %.4g, %.4g J; lost %.4g, %.4g J; kinetic %.2g, damping %.2g, %.2g J"):format(
    name, off, most, reference.loop, slow.loop, lost, e[of], e.kinetic, e.damping, finer.energy.damping))
  fabric.expect {
    { name .. ": forces of the statics", off / most, 0, absolute = 2e-3 },
    { name .. ": the loop", slow.loop, reference.loop, relative = 2e-3 },
    { name .. ": what friction took", e[of], lost, relative = 2e-3 },
    { name .. ": kinetic energy, of that", e.kinetic / lost, 0, absolute = 2e-3 },
    { name .. ": ledger", e.error, 0, absolute = 1e-3 },
    -- Work by the force at the end of each step is more than the true one, by an amount that falls with the step.
    o.falls and { name .. ": the scheme's loss, of that", e.damping / lost, 0, absolute = 0.02 }
      or { name .. ": the scheme's loss with half the step", finer.energy.damping / e.damping, 0.5, absolute = 0.15 },
  }
end

-- Yarns that load, let go and reload.
for _, triangles in ipairs { false, true } do
  compare(triangles and "yarns, triangles" or "yarns, squares", function()
    local mesh = fabric.mesh.rectangle { width = 30 * mm, height = 50 * mm, nx = 2, ny = 3, triangles = triangles }
    local m = fabric.model { mesh = mesh, card = fabric.card("duck", { bending = "estimated" }), warp = triangles and 90 or 70 }
    m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "y")
    return m:move("top", { x = way(4 * mm) })
  end, function(run) return (run:reaction "top") end, { most = 4 * mm, step = 5e-3, account = "dissipated" })
end

-- A patch that falls by a hair and is dragged to and fro on a table.
compare("table", function()
  local card = fabric.card("denim", { bending = "estimated" })
  local mesh = fabric.mesh.rectangle { width = 60 * mm, height = 40 * mm, nx = 3, ny = 2, origin = { 0, 0, 0.49 * card.thickness } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local plate = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:contact { between = { plate, "all" }, friction = 0.35 }:gravity { 0, 0, -9.81 }:pressure(-40, "all")
  m:fix("left", "y rotation")
  return m:move("left", { x = way(6 * mm) })
end, function(run) return (run:reaction "left") end, { most = 6 * mm, step = 1e-2, account = "friction", falls = true })

-- A sheet without load that slides to its rest on a table: all its yarns are at their kinks, where iterations come near slowly. Its steps stay as long
-- as they were asked for.
do
  local card = fabric.card("denim", { bending = "estimated" })
  local mesh = fabric.mesh.rectangle { width = 60 * mm, height = 60 * mm, nx = 6, ny = 6 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:contact { between = { fabric.rigid.plane { point = { 0, 0, -card.thickness / 2 }, normal = { 0, 0, 1 } }, "all" }, friction = 0.3 }
  m:gravity { 0, 0, -9.81 }:velocity("all", { x = 0.3 })
  local run = fabric.dynamic { model = m, duration = 0.05, scheme = "implicit", step = 5e-3, slow = true }:solve()
  local iterations = 0
  for _, s in ipairs(run.steps) do iterations = iterations + s.iterations end
  print(("sliding sheet: %d steps, %d iterations"):format(#run.steps, iterations))
  fabric.expect { { "sliding sheet: steps, with all its yarns at their kinks", #run.steps, 10, absolute = 1 } }
end
