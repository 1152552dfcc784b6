-- Numbers that nobody gave, and meshes that are softer than cloth: said, with how much, where they show by more than 1 %.
-- warns: with a modulus of transverse shear of
-- warns: their directors splay
-- warns: the guard of the directors has
-- warns: the shape has become unstable
-- warns: folds there, and results are too stiff
-- warns: nine measured cloths in ten
-- warns: in two halves they end
local fabric = require "fabric"
local mm = fabric.units.mm

local function said(run, code)
  for _, w in ipairs(run.warnings) do if w.code == code then return w.text end end
end

-- A sheet integrated through its thickness: the share of derived transverse shear is E t^2 / (3 G_t L^2) with G_t = 5/6 G and half of the diagonal for L.
-- The deflection of a strip of that length, clamped, under its weight, with the derived shear and with ten times as much, differs by as much.
local t, E, G = 0.5 * mm, 4e9, 2e6
local function sheet(length, more)
  local fields = { warp = E, weft = E / 10, shear = G, poisson = 0, density = 400, thickness = t, through_thickness = true }
  for k, v in pairs(more or {}) do fields[k] = v end
  return fabric.svk(fields), fabric.mesh.rectangle { width = length, height = length / 5, nx = 24, ny = 4 }
end
local function deflected(length, more, triangles)
  local card, mesh = sheet(length, more)
  if triangles then mesh = fabric.mesh.rectangle { width = length, height = length / 5, nx = 24, ny = 4, triangles = true } end
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("left", "x y z rotation"):gravity { 0, 0, fabric.ramp(-0.981, 1) }
  local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  local z = 0
  for _, n in ipairs(mesh:set "right") do z = z - a:node(n).z / #mesh:set "right" end
  return z, a
end
for _, triangles in ipairs { false, true } do
  local length = 100 * mm
  local derived, run = deflected(length, nil, triangles)
  local stiff, quiet = deflected(length, { transverse = { 100 * G, 100 * G } }, triangles)
  local half = length * math.sqrt(1 + 1 / 25) / 2
  local share = 100 * E * t ^ 2 / (3 * 5 / 6 * G * half ^ 2)
  local text = said(run, "shear")
  assert(text and text:find(("bent along the warp it adds %.2g %%"):format(share), 1, true), text)
  assert(not said(quiet, "shear"))
  -- uniform load on the whole length: 4 E' / (12 G_t L^2) = share / 4 at twice the length
  fabric.expect { { "what it adds", derived / stiff - 1, share / 100 / 4 * (half / (length / 2)) ^ 2, relative = 0.15 } }
end
-- cloth of usual shear: nothing is said
local _, usual = deflected(100 * mm, { shear = E / 50 })
assert(not said(usual, "shear"))

-- Tape of parallel fibres in one row of elements, long across the fibres: the radius is 1 / 1.3 b/h B / sqrt((A + 4 G b^2/h^2) B_twist), where shear holds their bending in the plane.
local function tape(o)
  local B, twist, A, G = 2e-3, 1.5e-6, 80, 30
  local card = fabric.svk { warp = 2e6 / t, weft = A / t, shear = G / t, poisson = 0, density = 0.15 / t, thickness = t, bending = { warp = B, weft = 3e-6, twist = twist } }
  local mesh = fabric.mesh.rectangle { width = 60 * mm, height = 12 * mm, nx = o.nx, ny = o.ny, triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = o.warp or 0 }
  m:fix("left", "x y z rotation"):gravity { 0, 0, fabric.ramp(o.weight or -0.1, 1) }
  local a = fabric.static { model = m, duration = 1, step = o.weight and 0.1 or 1 }:solve()
  if o.weight then -- of the deflection of a slender cantilever
    assert(a.steps[#a.steps].stable and not said(a, "pivots"))
    return -a:node(mesh:set "right"[1]).uz / (0.15 * -o.weight * 0.06 ^ 4 / 8 / B)
  end
  return a, 6 / o.ny / (30 / o.nx), B / math.sqrt((A + 4 * G * (6 / o.ny / (30 / o.nx)) ^ 2) * twist)
end
local run, aspect, per = tape { nx = 30, ny = 1 }
local text = said(run, "splay")
assert(text and text:find(("%g times as long across the warp"):format(aspect), 1, true), text)
local radius = tonumber(text:match "less than about ([%d.e+]+) mm of radius")
fabric.expect { { "radius, mm", radius, 1e3 * aspect * per / 1.3, relative = 1e-2 } }
assert(not said((tape { nx = 30, ny = 6 }), "splay") and not said((tape { nx = 30, ny = 1, triangles = true }), "splay"))
assert(not said((tape { nx = 30, ny = 1, warp = 90 }), "splay"), "long along the fibres")
-- With its weight tape of elements 8 to 12 times as long across fell into that mode, and hung down.
for _, nx in ipairs { 40, 60 } do fabric.expect { { nx .. " elements along the tape", tape { nx = nx, ny = 1, weight = -9.81 }, 1, relative = 5e-3 } } end

-- A sheet pressed on a plane stores all its energy in contact, whose stiffness somebody has to give; where cloth hangs over a body, hardly any.
local function pressed(o)
  local card = fabric.card("denim", { bending = "estimated" })
  if o.compression then card = card:with { compression = { { 1.2 * card.thickness, 50 }, { card.thickness, 600 }, { 0.8 * card.thickness, 15000 } } } end
  local mesh = fabric.mesh.rectangle { width = 50 * mm, height = 40 * mm, nx = 3, ny = 2, origin = { 0, 0, 0.48 * card.thickness }, triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("all", "x y"):contact { between = { fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }, "all" }, stiffness = o.stiffness }
  m:pressure(fabric.ramp(-1500, 1))
  local a = o.scheme and fabric.dynamic { model = m, duration = 1, scheme = "implicit", step = 0.1 } or fabric.static { model = m, duration = 1, step = 0.25 }
  return a:solve(), mesh
end
for _, triangles in ipairs { false, true } do
  local a = pressed { triangles = triangles }
  local e, share = a.energy, said(a, "pressed")
  assert(share and share:find(("contact has %.3g %% of the stored energy"):format(100 * e.contact / e.stored), 1, true), share)
  assert(said(pressed { triangles = triangles, scheme = "implicit" }, "pressed"))
  assert(not said(pressed { triangles = triangles, stiffness = 2e8 }, "pressed") and not said(pressed { triangles = triangles, compression = true }, "pressed"))
end
do
  local card = fabric.card("muslin", { bending = "estimated" })
  local mesh = fabric.mesh.rectangle { width = 160 * mm, height = 60 * mm, nx = 12, ny = 4, origin = { -80 * mm, -30 * mm, 0 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local rod = fabric.rigid.cylinder { radius = 20 * mm, from = { 0, -50 * mm, -20.2 * mm }, to = { 0, 50 * mm, -20.2 * mm } }
  m:gravity { 0, 0, fabric.ramp(-9.81, 0.05) }:contact { between = { rod, "all" }, friction = 0.4 }
  local a = fabric.dynamic { model = m, duration = 0.2, damping = { mass = 30 } }:solve()
  assert(a.energy.contact > 0 and a.energy.contact < 0.01 * a.energy.stored and not said(a, "pressed"))
end

-- A part that turns freely, and that nothing turns, is no obstacle: the rim of a blown disc is free in its plane, and the disc about its axis.
local disc = fabric.mesh.disk { radius = 90 * mm, cells = 6 }
local film = fabric.svk { young = 60e6, poisson = 0.3, density = 900, thickness = 0.1 * mm, bending = { warp = 2e-6, weft = 2e-6, twist = 1e-6 } }
local m = fabric.model { mesh = disc, card = film, warp = 0 }
m:fix("boundary", "z"):fix("centre", "x y"):pressure(fabric.ramp(40, 1))
local blown = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
local held = fabric.model { mesh = disc, card = film, warp = 0 }
held:fix("boundary", "z"):fix("centre", "x y"):pressure(fabric.ramp(40, 1))
local best, corner = 0, 1
for _, n in ipairs(disc:set "boundary") do if disc.nodes[n][1] > best then best, corner = disc.nodes[n][1], n end end
disc:set("corner", { corner })
held:fix("corner", "y")
local centre = disc:set("centre")[1]
fabric.expect { { "free to turn, as held", blown:node(centre).z, fabric.static { model = held, duration = 1, step = 0.25 }:solve():node(centre).z, relative = 1e-3 } }
