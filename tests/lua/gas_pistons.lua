-- A piston with a mass on a closed tube: it swings on gas and cloth, stands under its weight, and goes on after a restart. And
-- rims that are not at their bodies.
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local air, radius, long, mass, n = 101325, 0.05, 0.1, 0.2, 1.4
local rows = {}
local function row(name, got, want, within) rows[#rows + 1] = { name, got, want, relative = within.relative, absolute = within.absolute } end
local young, thickness, density, around, along = 30e6, 0.3e-3, 700, 32, 2
local card = fabric.svk { young = young, poisson = 0, density = density, thickness = thickness }
local area, perimeter = around / 2 * radius ^ 2 * math.sin(2 * math.pi / around), 2 * around * radius * math.sin(math.pi / around)

local function piston(triangles)
  local mesh = fabric.mesh.cylinder { radius = radius, length = long, around = around, along = along }
  if triangles then mesh = check.in_triangles(mesh) end
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, membrane = true }
  local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  local plate = fabric.rigid.disc { radius = 0.07, edge = 1e-3, centre = { 0, 0, long + 1e-3 }, normal = { 0, 0, 1 }, name = "plate", mass = mass }
  m:fix("all", "x y"):fix("bottom", "z"):tie("rigid", "top", plate)
  return m, plate, m:gas { lids = { floor, plate }, exponent = n }
end

-- Half a swing: gas and cloth are springs beside each other. A third of the cloth goes along.
local stiffness = n * air * area ^ 2 / (area * long) + young * thickness * perimeter / long
local heavy = mass + density * thickness * perimeter * long * 0.375 -- of two lumped rows
local swing = math.pi * math.sqrt(heavy / stiffness)
for _, triangles in ipairs { false, true } do
  for _, scheme in ipairs { "explicit", "implicit" } do
    local m, plate, g = piston(triangles)
    m:velocity(plate, { z = -0.02 })
    local a = fabric.dynamic { model = m, duration = 2 * swing, scheme = scheme, step = scheme == "implicit" and swing / 60 or nil }
    local before, back
    a:every("step", function(run)
      local z = select(3, run:body(plate)) - long - 1e-3
      if before and before[2] < 0 and z >= 0 and not back then back = before[1] - before[2] * (run.time - before[1]) / (z - before[2]) end
      before = { run.time, z }
    end)
    a:advance(swing / 2)
    local p, V = a:gas(g)
    row(scheme .. ", p V^n", (p + air) * V ^ n, air * (area * long) ^ n, { relative = 1e-10 })
    local state = a:snapshot()
    a:solve()
    row(scheme .. ", half a swing", back, swing, { relative = 1.5e-2 })
    row(scheme .. ", ledger", a.energy.error, 0, { absolute = 2e-3 })
    local ends = select(3, a:body(plate))
    a:restore(state)
    a:solve()
    row(scheme .. ", restored", select(3, a:body(plate)), ends, { absolute = 0 })
  end
end

-- It comes to rest where gas and cloth bear its weight.
do
  local m, plate, g = piston(false)
  m:gravity { 0, 0, fabric.ramp(-2000, 1) }
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local e = (long + 1e-3 - select(3, a:body(plate))) / long
  local p = air * (1 - e) ^ -n - air
  row("under its weight, pressure", (a:gas(g)), p, { relative = 1e-3 })
  local sheet = density * thickness * perimeter * long
  local top = mass * 2000 + sheet / along / 2 * 2000 -- of the last row of nodes
  row("under its weight, balance", p * area + young * (e - e ^ 2 / 2) * (1 - e) * thickness * perimeter, top, { relative = 3e-2 })
  row("under its weight, ledger", a.energy.error, 0, { absolute = 2e-2 })
end

-- Gaps, with place and size; bodies that close nothing.
do
  local function refused(words, lid, map)
    local mesh = fabric.mesh.cylinder { radius = radius, length = long, around = around, along = along }
    if map then mesh = mesh:map(map) end
    local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, membrane = true }:fix("all", "x y z")
    m:gas { lids = { "bottom", lid } }
    check.fails(words, function() fabric.static { model = m, duration = 1 } end)
  end
  refused("the plane is 0.02 m away from its node 65, at (0.05, 0, 0.1) m, expected at most 0.000980171 m", fabric.rigid.plane { point = { 0, 0, long + 0.02 }, normal = { 0, 0, -1 } })
  refused("the sphere is ", fabric.rigid.sphere { radius = 0.03, centre = { 0, 0, long } })
  refused("the surface does not close the hole at (", fabric.rigid.surface { mesh = fabric.mesh.annulus { inner = 0.03, outer = 0.07, around = 12, across = 2 }:map(function(x, y) return x, y, long end) })
  local m = fabric.model { mesh = fabric.mesh.cylinder { radius = radius, length = long, around = around, along = along }, card = card, warp = { 0, 0, 1 }, membrane = true }
  m:fix("all", "x y z"):gas { lids = { "bottom", "top", fabric.rigid.sphere { radius = 0.03, centre = { 0, 0, 1 } } } }
  check.fails("the sphere closes no hole: expected a hole of the surface whose rim lies at it", function() fabric.static { model = m, duration = 1 } end)

  -- A hole has one lid: a set and a body are two.
  local twice = fabric.model { mesh = fabric.mesh.cylinder { radius = 0.03, length = 0.07, around = 16, along = 2 }, card = card, warp = { 0, 0, 1 }, membrane = true }
  local cap = fabric.rigid.plane { point = { 0, 0, 0.07 }, normal = { 0, 0, -1 }, name = "cap" }
  twice:fix("all", "x y z"):gas { lids = { "bottom", "top", cap } }
  check.fails("set 'top' and the cap close the same hole, at (0.03, 0, 0.07)", function() fabric.static { model = twice, duration = 1 } end)
end

-- Bodies to which nodes are tied have names of their own, a node goes along with one of them, and seams of the same model stay what they are.
do
  local function tube()
    local mesh = fabric.mesh.rectangle { width = 1, height = long, nx = 10, ny = 2 }
    mesh:map(function(x, y)
      local turn = 2 * math.pi * x
      return radius * math.cos(turn), radius * math.sin(turn), y
    end)
    mesh:set("rim", function(x, _, z) return z > 0.99 * long and x < 0.99 * radius end)
    local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, membrane = true }
    return m:fix("bottom", "x y z"):seam { "left", "right" }
  end
  local function body(name, up) return fabric.rigid.disc { name = name, radius = 0.07, edge = 1e-3, centre = { 0, 0, long + up }, normal = { 0, 0, 1 } } end
  local m, lid = tube(), body("lid", 1e-3)
  m:gas { lids = { "bottom", lid }, initial = 500 }
  m:tie("rigid", "rim", lid):move(lid, { z = fabric.ramp(2e-3, 1) })
  local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  row("sewn tube, its rim", a:node(m.mesh:set("rim")[3]).uz, 2e-3, { relative = 1e-3 })
  local function refused(words, second, name)
    local n, one = tube(), body("one", 1e-3)
    local other = second(name)
    n:gas { lids = { "bottom", one } }
    n:contact { between = { other, "all" } }
    n:tie("rigid", "rim", one)
    if name ~= "one" then n:tie("rigid", "rim", other) end
    check.fails(words, function() fabric.static { model = n, duration = 1 } end)
  end
  local function above(name) return body(name, 6e-3) end
  refused("tie: 2 bodies have the name 'one': expected a body with a name of its own", above, "one")
  refused("is tied to the bodies 'one' and 'two': expected one", above, "two")
end

-- A rim that leaves its body is told.
do
  local mesh = fabric.mesh.cylinder { radius = radius, length = long, around = around, along = along }
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, membrane = true }:fix("all", "x y z")
  local lid = fabric.rigid.plane { point = { 0, 0, long }, normal = { 0, 0, -1 }, name = "lid" }
  m:gas { lids = { "bottom", lid } }
  m:move(lid, { z = fabric.ramp(0.03, 1) })
  local a = fabric.dynamic { model = m, duration = 1, scheme = "implicit", step = 0.1 }:solve()
  local told
  for _, w in ipairs(a.warnings) do told = told or (w.code == "rim" and w.text) end
  assert(told and told:find("against the lid that closes it", 1, true), told)
end
fabric.expect(rows)

-- A plate on gas that nothing keeps from turning: the run says which body, and what it may do.
do
  local m = fabric.model { mesh = fabric.mesh.cylinder { radius = radius, length = long, around = 12, along = 4 }, card = fabric.card("blend", { bending = "estimated" }), warp = { 0, 0, 1 } }
  local plate = fabric.rigid.disc { radius = 0.06, edge = 1e-3, centre = { 0, 0, long + 1e-3 }, normal = { 0, 0, 1 }, name = "plate", mass = 0.05 }
  m:fix("bottom", "x y z rotation"):gas { lids = { "bottom", plate }, initial = 500 }
  m:force(plate, { z = fabric.ramp(-1, 1) }):fix(plate, "x y")
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local words = a.warnings[1].text
  assert(a.warnings[1].code == "unstable" and words:find("nothing holds the plate that forces place, which may turn about x and turn about y: m:fix or m:spring of the body", 1, true), words)
end
