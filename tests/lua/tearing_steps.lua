-- Yarns that break in static and implicit runs: the step ends where a yarn reaches its strength, and the tear goes on in balance.
local fabric = require "fabric"
local mm = fabric.units.mm
local cloth = fabric.svk { young = 1e8, poisson = 0, density = 500, thickness = 0.5 * mm }
local function breaks(strength, energy) return cloth:with { rupture = { weft = { strength = strength, energy = energy } } } end
local function drive(model, scheme, step)
  if scheme == "static" then return fabric.static { model = model, duration = 1, step = step } end
  return fabric.dynamic { model = model, duration = 1, step = step, scheme = "implicit" }
end

-- A bar of n elements with one weak joint: the largest force is its strength, what is lost is G times the width, and the rest comes back.
local width, length, strength = 20 * mm, 40 * mm, 1e3
local function bar(n, energy, pulled)
  local mesh = fabric.mesh.rectangle { width = width, height = length, nx = 2, ny = n }
  mesh:set("low", function(_, y) return y < 1.01 * length / n end)
  local m = fabric.model { mesh = mesh, card = breaks(2 * strength, energy), regions = { low = { card = breaks(strength, energy) } } }
  m:fix("all", "x z rotation"):fix("bottom", "y"):move("top", { y = fabric.ramp(pulled or 2.2 * energy / strength, 1) })
  return m:tearable "all"
end
for _, case in ipairs { { 4, "static", 0.05, 20 }, { 7, "static", 0.02, 3 }, { 4, "implicit", 0.02, 20 }, { 3, "implicit", 0.1, 3 } } do
  local n, scheme, step, energy = table.unpack(case)
  local run = drive(bar(n, energy), scheme, step)
  local peak = 0
  run:every("step", function(a) peak = math.max(peak, (select(2, a:reaction "top"))) end)
  run:advance(0.5)
  assert(run.joints.open == 3 and run.energy.fracture > 0.2 * energy * width)
  local half, middle = run:snapshot(), run:node(5).y
  run:solve()
  local top, lost = select(2, run:reaction "top"), run.energy.fracture
  assert(math.abs(peak / (strength * width) - 1) < 1e-3, peak)
  assert(math.abs(lost / (energy * width) - 1) < 1e-9 and math.abs(top) < 1e-3 * strength * width)
  assert(run.energy.error < 2e-3, run.energy.error)
  run:restore(half)
  assert(run:node(5).y == middle)
  run:solve()
  assert(run.energy.fracture == lost and select(2, run:reaction "top") == top)
end

-- A joint that stores more than it costs breaks at once: in motion the rest becomes kinetic energy, and statics loses it.
for _, scheme in ipairs { "static", "implicit" } do
  local run = drive(bar(4, 0.2, 1.2 * mm), scheme, 0.05)
  run:solve()
  assert(math.abs(run.energy.fracture / (0.2 * width) - 1) < 1e-9)
end

-- A wide strip held by its long edges, with a long cut: the tear begins to run where the energy per area times the height is G [rivlin1953].
-- From there on it runs as far as one likes, which is no balance.
local wide, high, h, energy, most = 80 * mm, 24 * mm, 2 * mm, 2, 6 * mm
local mesh = fabric.mesh.rectangle { width = wide, height = high, nx = 40, ny = 12 }
mesh:set("line", function(_, y) return math.abs(y - high / 2) < 1.01 * h end)
local card = fabric.svk { young = 1e7, poisson = 0, density = 500, thickness = 0.5 * mm }
local m = fabric.model { mesh = mesh, card = card:with { rupture = { weft = { strength = 1.2e3, energy = energy } } } }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(most, 1) }):tearable "line"
local run = fabric.static { model = m, duration = 1, step = 0.05 }
run:cut { line = { { 0, high / 2, 0 }, { 0.4 * wide, high / 2, 0 } } }
local ok, why = pcall(run.solve, run)
assert(not ok and tostring(why):find("the tear runs away", 1, true) and tostring(why):find("fabric.dynamic", 1, true), tostring(why))
local stretch = 1 + most * run.time / high
local green = (stretch ^ 2 - 1) / 2
local at = 0.5 * 1e7 * 0.5 * mm * green ^ 2 * high / energy
assert(math.abs(at - 1) < 0.03, at)

-- Along the path of equilibria (control="arc") a bar that stores more than its break costs goes back in time as it breaks, and forward again in two pieces.
-- The force per width is K E stretch in the cloth and f0 (1 - opening / (2 G / f0)) in the break.
do
  local stiff, G = 1e8 * 0.5 * mm, 0.1
  local mesh = fabric.mesh.rectangle { width = width, height = length, nx = 2, ny = 4 }
  mesh:set("low", function(_, y) return y < 1.01 * length / 4 end)
  local m = fabric.model { mesh = mesh, card = breaks(2 * strength, G), regions = { low = { card = breaks(strength, G) } } }
  m:fix("all", "x z rotation"):fix("bottom", "y"):move("top", { y = fabric.ramp(4 * mm, 1) }):tearable("all", { coarse = "keep" })
  local run = fabric.static { model = m, duration = 1, step = 0.05, control = "arc", max_iterations = 25 }
  local back, forth, f0 = 0, 0, nil
  run:every("step", function(a)
    if a.joints.open == 0 then return end
    local force = select(2, a:reaction "top") / width
    f0 = f0 or force
    local stretch = 1
    for _ = 1, 50 do -- of the cloth at this force
      local E = (stretch ^ 2 - 1) / 2
      stretch = stretch - (stiff * E * stretch - force) / (stiff * (E + stretch ^ 2))
    end
    if a.energy.fracture < 0.999 * G * width then
      local opening = 2 * G / f0 * (1 - force / f0)
      assert(math.abs(a.time * 4 * mm - length * (stretch - 1) - opening) < 1e-3 * length * (stretch - 1), a.time)
      assert(force > 0.999 * f0 or a.time < 0.19)
      back = back + 1
    else
      assert(math.abs(force) < 1e-3 * f0 and a.time > 0.0499)
      forth = forth + 1
    end
  end)
  run:solve()
  assert(back >= 5 and forth >= 5 and run.time == 1)
  assert(math.abs(run.energy.fracture / (G * width) - 1) < 1e-9 and run.energy.error < 1e-9)
end

-- The wide strip: from its first yarns on the cut needs more and more until the energy is G; there it runs, yarn after yarn, in balance.
do
  local m = fabric.model { mesh = mesh, card = card:with { rupture = { weft = { strength = 1.2e3, energy = energy } } } }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(most, 1) }):tearable "line"
  local function begun() return fabric.static { model = m, duration = 1, step = 0.05, control = "arc", max_iterations = 25 } end
  local run, rows, snapshot = begun(), {}, nil
  run:cut { line = { { 0, high / 2, 0 }, { 0.4 * wide, high / 2, 0 } } }
  run:every("step", function(a)
    local green = ((1 + most * a.time / high) ^ 2 - 1) / 2
    if rows[#rows] and rows[#rows].open == a.joints.open then return end
    rows[#rows + 1] = { share = 0.5 * 1e7 * 0.5 * mm * green ^ 2 * high / energy, open = a.joints.open, fracture = a.energy.fracture, force = select(2, a:reaction "top") }
    if a.joints.open >= 28 then a:stop "it has run far enough" end
  end)
  run:advance(0.66)
  snapshot = run:snapshot()
  run:solve()
  local last, before = rows[#rows], rows[#rows - 1]
  assert(last.open >= 28 and math.abs(last.share - 1) < 5e-3, last.share)
  assert(math.abs((last.fracture - before.fracture) / ((last.open - before.open) * h * energy) - 1) < 1e-3 and run.energy.error < 1e-3)
  local time, force = run.time, last.force
  rows = {}
  run:restore(snapshot):solve()
  assert(run.time == time and rows[#rows].force == force)
end
