-- Closed forms of contact through the program's own runs: what share/doc/contact.md has in its table, in the forms that take seconds.
-- Finer meshes are in scripts/contact and scripts/long/contact.
local fabric = require "fabric"
local thickness, density, g = 0.4e-3, 600, 9.81
local sigma = density * thickness
local function sheet_card(young, bending)
  return fabric.svk { young = young, poisson = 0, density = density, thickness = thickness, name = "sheet",
                      bending = bending and { warp = bending, weft = bending, twist = bending }, through_thickness = not bending }
end

local function near(name, got, want, relative)
  print(string.format("%-66s %.9g, closed form %.9g, %+.1e", name, got, want, got / want - 1))
  assert(math.abs(got - want) <= relative * math.abs(want), string.format("%s: expected %.9g, got %.9g", name, want, got))
end

-- Law of a sheet on a body, and of two: from a gap to a floor; stiffness comes up over a fifth of the way.
local function onset_of(gap, floor_) return 0.2 * (gap - floor_) end
local function depth_at(pressure, kappa, onset)
  local depth = math.sqrt(2 * onset * pressure / kappa)
  return depth <= onset and depth or pressure / kappa + onset / 2
end

-- A sheet falls flat on a plane with the speed v. With w = sqrt(kappa/sigma), and the onset s over which stiffness comes up, it goes s/2 +
-- sqrt(v^2/w^2 - s^2/12) deep, and is in contact for (pi - 2 asin(s/2A))/w below the onset, A the root, and for the integral of ds/speed in
-- it. Without an onset these are v/w and pi/w. Triangles, whose nodes have the same share of the mass and of the area: it stays flat.
do
  local kappa, wide = 1e9, 4e-3 -- the thickness as contact sees it
  local gap, floor_ = wide / 2, sigma / 1500 / 2
  local s, w = onset_of(gap, floor_), math.sqrt(kappa / sigma)
  local v = w * 0.65 * (gap - floor_)
  local function fall(step)
    local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 3, ny = 3, triangles = true, origin = { 0, 0, gap + 1e-5 } }
    local m = fabric.model { mesh = mesh, card = sheet_card(1e7), warp = 0 }
    m:contact { between = { fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }, "all" }, stiffness = kappa, thickness = wide, restitution = 1 }
    m:velocity("all", { z = -v })
    local a = fabric.dynamic { model = m, step = step, duration = 2e-5 / v + 1.3 * math.pi / w }
    local deepest, into, out, last = 0, nil, nil, { time = 0, z = gap + 1e-5 }
    a:every("step", function(r)
      local now = { time = r.time, z = r:node(6).z }
      local function crossing() return last.time + (now.time - last.time) * (last.z - gap) / (last.z - now.z) end
      deepest = math.max(deepest, gap - now.z)
      if not into and now.z < gap then into = crossing() end
      if into and not out and now.z > gap then out = crossing() end
      last = now
    end)
    a:solve()
    assert(a.energy.guard == 0 and a.energy.error < 1e-6, a.energy.error)
    return deepest, out - into
  end
  local amplitude = math.sqrt(v ^ 2 / w ^ 2 - s ^ 2 / 12)
  local in_onset, parts = 0, 1000 -- Simpson
  for i = 0, parts do
    local x = s * i / parts
    local weight = (i == 0 or i == parts) and 1 or i % 2 == 1 and 4 or 2
    in_onset = in_onset + weight * s / parts / 3 / math.sqrt(v ^ 2 - w ^ 2 * x ^ 3 / (3 * s))
  end
  local deepest, time = fall(2e-7)
  near("sheet falling flat: deepest, m", deepest, s / 2 + amplitude, 1e-5)
  near("sheet falling flat: in contact, s", time, 2 * in_onset + (math.pi - 2 * math.asin(s / 2 / amplitude)) / w, 1e-5)
  near("sheet falling flat: deepest less half of the onset, over v/w", (deepest - s / 2) / (v / w), 1, 1e-2)
end

-- N layers at rest over a plane: the gap below layer i carries the weight of all from it upwards, p_i = (N - i + 1) sigma g, i from 1.
for _, triangles in ipairs { true, false } do
  local n, kappa, z = 5, 1e9, 0
  local floor_, bodies, names = sigma / 1500, {}, {}
  for i = 1, n do
    z = z + (i == 1 and thickness / 2 or thickness) - 1e-6
    bodies[i] = { name = "layer" .. i, card = sheet_card(1e7), warp = 0,
                  mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 4, ny = 4, triangles = triangles, origin = { 0, 0, z } } }
    names[i] = bodies[i].name .. ".all"
  end
  local m = fabric.model { bodies = bodies }
  local ground = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 }, name = "ground" }
  m:contact { between = { ground, "all" }, stiffness = kappa }:contact { between = names, stiffness = kappa }
  m:fix("all", "x y"):gravity { 0, 0, fabric.history { { 0, 0 }, { 1, -g } } }
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local kind = triangles and "triangles" or "quadrilaterals"
  near(n .. " layers of " .. kind .. ": on the ground, N", select(3, a:reaction(ground)), n * sigma * g * 4e-4, 1e-8)
  local heights, nodes, below = a:field "z", #bodies[1].mesh.nodes, 0
  for i = 1, n do
    local mean = 0
    for k = (i - 1) * nodes + 1, i * nodes do mean = mean + heights[k] / nodes end
    local gap = i == 1 and thickness / 2 or thickness
    local s = onset_of(gap, i == 1 and floor_ / 2 or floor_)
    -- Quadrilaterals: the nodes' shares of mass and of area are not alike, and the layers not quite flat.
    near(string.format("%d layers of %s: gap below layer %d, m", n, kind, i), mean - below, gap - depth_at((n - i + 1) * sigma * g, kappa, s),
         triangles and 1e-9 or 1e-4)
    -- contact_pressure is what pushes a layer up and what pushes it down, added.
    if triangles then near("the pressure on both faces of a layer, Pa", a:node(nodes * (i - 1) + 7).contact_pressure, (2 * (n - i) + 1) * sigma * g, 1e-6) end
    below = mean
  end
end

-- A sheet that starts pressed onto a plane has its energy from the start, in statics, and the plane that is moved does the rest.
do
  local kappa, gap, floor_, side = 1e9, thickness / 2, sigma / 1500 / 2, 0.02
  local s, range = onset_of(gap, floor_), gap - floor_
  local function energy(y) return side ^ 2 * kappa * ((y - s / 2) ^ 2 / 2 + s ^ 2 / 24) end -- J, pressed by y, deeper than the onset
  local y0, y1 = 0.4 * range, 0.6 * range
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = 4, ny = 4, origin = { 0, 0, gap - y0 } }
  local m = fabric.model { mesh = mesh, card = sheet_card(1e7), warp = 0 }
  local ground = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:contact { between = { ground, "all" }, stiffness = kappa }:fix("all", "x y z rotation")
  m:move(ground, { z = fabric.ramp(y1 - y0, 1) })
  local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
  local e = a.energy
  near("pressed at the start: energy of contact then, J", e.initial, energy(y0), 1e-9)
  near("pressed at the start: energy of contact at the end, J", e.contact, energy(y1), 1e-9)
  near("pressed at the start: work of the plane, J", e.external, energy(y1) - energy(y0), 1e-9)
  near("pressed at the start: 1 plus the ledger's error", 1 + e.error, 1, 1e-9)
end

-- A tape about half a cylinder, drawn tight without friction: p = T/R, and the second order of the facets.
do
  local tension, radius, width, kappa, young = 10, 0.03, 0.01, 1e10, 1e8
  local last
  for _, n in ipairs { 8, 16, 32 } do
    local test = fabric.lab.capstan { card = sheet_card(young, 1e-5), around = n, friction = 0, wrap = 180, draw = 1e-4, lead = n // 4,
                                      stiffness = kappa, tension = tension, radius = radius, width = width, step = 0.25 }
    local a, area = test.analysis, {}
    local p = a:field "contact_pressure"
    for _, e in ipairs(test.mesh.elements) do
      for _, i in ipairs(e) do area[i] = (area[i] or 0) + 1 / 4 end -- of an element's area
    end
    near(n .. " facets: the ends without friction, T2/T1", test.ratio, 1, 2e-5)
    near(n .. " facets: on the cylinder, N", select(3, a:reaction(test.drum)), 2 * tension * width, 2e-5)
    -- The two nodes in the middle of the wrap, per reference area of one element; the tape is longer by T/(E t).
    local k = n // 2 + n // 4 + 1
    local q = p[k] * area[k] + p[k + n + 2 * (n // 4) + 1] * area[k + n + 2 * (n // 4) + 1]
    local want = tension / (radius + thickness / 2) * (1 + tension / (young * thickness))
    local off = q / want - 1
    print(string.format("tape of %2d facets: p R/T off by %+.4f %%", n, 100 * off))
    assert(math.abs(off) < 2.6 / n ^ 2, off)
    assert(not last or math.abs(last / off) > 3.5, off) -- 4 where all of it is of second order
    last = off
  end
end

-- A sheet drawn from between two that are pressed together: F = 2 mu N. With one point through the thickness their shear
-- holds them flat.
for _, mu in ipairs { 0.1, 0.6 } do
  local touch, pressure, card = 1e-6, 1000, sheet_card(1e8)
  local function at(k, x, width, nx) return fabric.mesh.rectangle { width = width, height = 0.01, nx = nx, ny = 2, origin = { x, 0, k * (thickness - touch) } } end
  local m = fabric.model { bodies = { { name = "low", mesh = at(0, 0, 0.02, 4), card = card, points = 1, warp = 0 },
                                      { name = "middle", mesh = at(1, -0.0075, 0.035, 7), card = card, points = 1, warp = 0 },
                                      { name = "high", mesh = at(2, 0, 0.02, 4), card = card, points = 1, warp = 0 } } }
  for _, pair in ipairs { { "low.all", "middle.all" }, { "middle.all", "high.all" } } do m:contact { between = pair, friction = mu, stiffness = 1e10 } end
  m:fix("low.all", "x y z rotation"):fix("middle.all", "y rotation"):fix("high.all", "x y rotation")
  m:pressure(fabric.history { { 0, 0 }, { 1, -pressure } }, "high.all")
  m:move("middle.right", { x = fabric.history { { 0, 0 }, { 1, 0 }, { 2, 2e-5 } } })
  local a = fabric.static { model = m, duration = 2, step = 0.1 }:solve()
  local normal = pressure * 0.02 * 0.01
  near("drawn from between two: what the lower one carries, N", select(3, a:reaction "low.all"), normal, 1e-9)
  near(string.format("drawn from between two: F, N, friction %.1f", mu), (a:reaction "middle.right"), 2 * mu * normal, 1e-5)
end

-- Sheets of different thickness that touch themselves all: each two have the mean of their own thicknesses.
do
  local thin, thick, kappa = 0.2e-3, 0.6e-3, 1e9
  local function card_of(t) return fabric.svk { young = 1e7, poisson = 0, density = 240, thickness = t, name = "sheet" } end
  local function pressed(apart, first, second)
    local function at(z) return fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 4, ny = 4, triangles = true, origin = { 0, 0, z } } end
    local m = fabric.model { bodies = { { name = "low", mesh = at(0), card = card_of(first), warp = 0 }, { name = "high", mesh = at(apart), card = card_of(second), warp = 0 } } }
    m:contact { self = "all", stiffness = kappa }:fix("all", "x y z rotation")
    local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
    return a.energy.contact
  end
  for _, pair in ipairs { { thin, thick }, { thick, thin } } do
    local gap, floor_ = (thin + thick) / 2, 240 * (thin + thick) / 2 / 1500
    local s, y = onset_of(gap, floor_), 0.5 * (gap - floor_)
    assert(pressed(gap + 1e-9, pair[1], pair[2]) == 0, "apart by more than the mean of their thicknesses they do not press")
    near(string.format("sheets of %.1f and %.1f mm that touch themselves: energy, J", 1e3 * pair[1], 1e3 * pair[2]), pressed(gap - y, pair[1], pair[2]),
         4e-4 * kappa * ((y - s / 2) ^ 2 / 2 + s ^ 2 / 24), 1e-9)
  end
end
