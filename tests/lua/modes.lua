-- Natural frequencies of states against closed forms, on quadrilaterals and triangles: taut membranes, plates with different
-- stiffness along and across, a strip under tension, a hanging cloth, a free plate; and what is said beside the numbers.
local fabric = require "fabric"
local pi = math.pi
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end

-- A taut rectangle: f = sqrt(N / m) / 2 sqrt((i / a)^2 + (j / b)^2).
for _, tri in ipairs { false, true } do
  local a, b, h, e = 0.3, 0.2, 0.15e-3, 0.008
  local card = fabric.linear { warp = 60e6, weft = 60e6, shear = 25e6, poisson = { 0.2, 0.2 }, density = 900, thickness = h,
    bending = { warp = 2e-6, weft = 2e-6, twist = 2e-6 } }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = a, height = b, nx = 18, ny = 12, triangles = tri }, card = card }
  m:fix("boundary", "z"):fix("left", "x"):fix("bottom", "y")
  m:move("right", { x = fabric.ramp(e * a, 1) }):move("top", { y = fabric.ramp(e * b, 1) })
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local N, mu = run:mean "S11" * h, 900 * h -- the force over the width that it has now, and the mass over the area before
  local function f(i, j) return math.sqrt(N / mu) / 2 * math.sqrt((i / a) ^ 2 + (j / b) ^ 2) end
  local found = fabric.modes { from = run, count = 2 }
  local of = tri and " on triangles" or " on quadrilaterals"
  check("taut, 1 1" .. of, found[1].frequency, f(1, 1), 0.01)
  check("taut, 2 1" .. of, found[2].frequency, f(2, 1), 0.01)
  -- (8 / pi^2)^2 of the mass swings along z with the first mode, in a sine along both sides.
  check("its mass" .. of, found[1].mass.z, (8 / pi ^ 2) ^ 2 * mu * a * b, 0.02)
  check("its other masses" .. of, 1 + found[1].mass.x + found[1].mass.y, 1, 1e-9)
  local below = fabric.modes { from = run, below = 0.5 * (found[1].frequency + found[2].frequency) }
  check("modes below" .. of, #below, 1, 0)
end

-- A taut disk: f = 2.40483 sqrt(N / m) / (2 pi r).
do
  local r, h, e = 0.12, 0.2e-3, 0.01
  local card = fabric.linear { warp = 40e6, weft = 40e6, shear = 16e6, poisson = { 0.25, 0.25 }, density = 700, thickness = h,
    bending = { warp = 2e-6, weft = 2e-6, twist = 2e-6 } }
  local mesh = fabric.mesh.disk { radius = r, cells = 8 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("boundary", "z rotation")
  for i, id in ipairs(mesh:set "boundary") do
    mesh:set("rim" .. i, { id })
    local X = mesh.nodes[id]
    m:move("rim" .. i, { x = fabric.ramp(e * X[1], 1), y = fabric.ramp(e * X[2], 1) })
  end
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local N, mu = run:mean "S11" * h, 700 * h
  check("taut disk", fabric.modes { from = run, count = 1 }[1].frequency, 2.404826 * math.sqrt(N / mu) / (2 * pi * r), 0.01)
end

-- Plates whose sides do not feel each other (no Poisson's ratio in bending) swing like beams.
local h, rho, Bx, By = 1e-3, 1200, 0.12, 0.05
local plate = fabric.svk { density = rho, thickness = h, warp = 2e9, weft = 1e9, shear = 0.6e9, poisson = 0,
  bending = { warp = Bx, weft = By, twist = 0.03 } }
for _, tri in ipairs { false, true } do
  local of = tri and " of triangles" or " of quadrilaterals"
  local a, b = 0.15, 0.1
  local function model() return fabric.model { mesh = fabric.mesh.rectangle { width = a, height = b, nx = 18, ny = 12,
    triangles = tri }, card = plate, warp = 0 } end
  local function hz(B, k, l) return (k / l) ^ 2 * math.sqrt(B / (rho * h)) / (2 * pi) end
  local clamped = fabric.modes { model = model():fix("left", "x y z rotation"), count = 4 }
  check("cantilever" .. of, clamped[1].frequency, hz(Bx, 1.875104, a), 0.01)
  local nearest = math.huge -- the second bending mode, whichever number it has
  for _, one in ipairs(clamped) do
    local off = one.frequency / hz(Bx, 4.694091, a) - 1
    if math.abs(off) < math.abs(nearest) then nearest = off end
  end
  check("its second bending" .. of, 1 + nearest, 1, 0.01)
  -- Supported along its sides: pi^4 (Bx / a^4 + 4 twist / (a b)^2 + By / b^4), Leissa's orthotropic plate.
  local m = model():fix("boundary", "x y z")
  local s = pi ^ 4 * (Bx / a ^ 4 + 4 * 0.03 / (a * b) ^ 2 + By / b ^ 4)
  check("supported" .. of, fabric.modes { model = m, count = 1 }[1].frequency, math.sqrt(s / (rho * h)) / (2 * pi), 0.012)
  -- Free: six motions without stiffness, each direction with all of the mass.
  local free = fabric.modes { model = model(), count = 9 }
  local mass = { 0, 0, 0 }
  for i = 1, 6 do
    check("rigid motion " .. i .. of, 1 + free[i].frequency, 1, 0)
    for c = 1, 3 do mass[c] = mass[c] + free[i].mass[c] end
  end
  assert(free[7].frequency > 10)
  for c = 1, 3 do check("mass of rigid motions " .. c .. of, mass[c], rho * h * a * b, 1e-6) end
  nearest = math.huge
  for i = 7, 9 do
    local off = free[i].frequency / hz(Bx, 4.730041, a) - 1
    if math.abs(off) < math.abs(nearest) then nearest = off end
  end
  check("free bending" .. of, 1 + nearest, 1, 0.02)
end

-- A cloth that hangs: f = 2.404826 / 2 sqrt(g / L) / (2 pi), with Bessel's first zero.
do
  local L = 0.5
  local cloth = fabric.svk { density = 500, thickness = 0.3e-3, warp = 20e6, weft = 20e6, shear = 8e6, poisson = 0,
    bending = { warp = 1e-9, weft = 1e-9, twist = 1e-9 } }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.05, height = L, nx = 2, ny = 24 }, card = cloth, warp = 90 }
  m:fix("top", "x y z"):gravity { 0, fabric.ramp(-9.81, 1), 0 }
  local run = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  local found = fabric.modes { from = run, count = 2 }
  check("hanging, first", found[1].frequency, 2.404826 / 2 * math.sqrt(9.81 / L) / (2 * pi), 0.01)
  check("hanging, its growth", 1 + found[1].growth, 1, 0)
end

-- A strip under tension with bending of its own: f_n = n / (2 L) sqrt(N / m) sqrt(1 + n^2 pi^2 B / (N L^2)), supported.
do
  local L, b, B, N = 0.2, 0.02, 4e-4, 0.3
  local card = fabric.svk { density = 600, thickness = 0.5e-3, warp = 50e6, weft = 50e6, shear = 20e6, poisson = 0,
    bending = { warp = B, weft = B, twist = B / 2 } }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = L, height = b, nx = 24, ny = 2 }, card = card, warp = 0 }
  m:fix("left", "x y z"):fix("right", "z"):force("right", { x = fabric.ramp(N * b, 1) })
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local mu = 600 * 0.5e-3
  for n, found in ipairs(fabric.modes { from = run, count = 2 }) do
    check("strip under tension, " .. n, found.frequency,
      n / (2 * L) * math.sqrt(N / mu * (1 + n * n * pi * pi * B / (N * L * L))), 0.01)
  end
end

-- A ring of cloth that breathes against its gas: (S t / r^2 + 2 n p / r) / (density t), with the absolute pressure p.
do
  local r, t, S, n = 0.05, 0.5e-3, 8e6, 1.4
  local ring = fabric.svk { density = 500, thickness = t, warp = S, weft = S, shear = 3e6, poisson = 0,
    bending = { warp = 2e-5, weft = 2e-5, twist = 1e-5 } }
  local m = fabric.model { mesh = fabric.mesh.cylinder { radius = r, length = 0.02, around = 24, along = 1 }, card = ring,
    warp = { 0, 0, 1 } }
  m:fix("all", "z"):gas { set = "all", lids = { "bottom", "top" }, initial = 10, exponent = n }
  local want = math.sqrt((S * t / r ^ 2 + 2 * n * 101325 / r) / (500 * t)) / (2 * pi)
  local nearest = 0
  for _, one in ipairs(fabric.modes { model = m, count = 160 }) do
    if math.abs(one.frequency - want) < math.abs(nearest - want) then nearest = one.frequency end
  end
  check("ring that breathes", nearest, want, 0.005)
end

fabric.expect(checks)
