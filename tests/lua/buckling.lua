-- Critical factors of loads against closed forms: a column, a plate in compression and in shear, a ring under pressure, a deep
-- strip that turns over; and the shape as the imperfection of a next run.
local fabric = require "fabric"
local pi = math.pi
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end

-- Euler's column, clamped at one end and free at the other, far below and just below its load, with two laws.
local L, b, B = 0.16, 0.024, 3e-5
local svk = fabric.svk { density = 500, thickness = 0.5e-3, warp = 9e6, weft = 9e6, shear = 3e6, poisson = 0,
  bending = { warp = B, weft = B, twist = B / 2 } }
local woven = fabric.woven { density = 500, thickness = 0.5e-3, warp = { loading = { 9e6 }, unloading = 9.5e6, poisson = 0 },
  weft = { loading = { 9e6 }, unloading = 9.5e6, poisson = 0 }, shear = { loading = { 6e6 }, unloading = 7e6 },
  tested = { warp = 0.3, weft = 0.3, shear = 0.3 }, bending = { warp = B, weft = B, twist = B / 2 } }
local euler = pi ^ 2 * B * b / 4 / L ^ 2
local function column(card, tri, part, mesh)
  mesh = mesh or fabric.mesh.rectangle { width = L, height = b, nx = 20, ny = 3, triangles = tri }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("left", "x y z rotation"):force("right", { x = fabric.ramp(-part * euler, 1) })
  return fabric.static { model = m, duration = 1, step = 1 }:solve()
end
for name, card in pairs { svk = svk, woven = woven } do
  for _, tri in ipairs { false, true } do
    for _, part in ipairs { 0.2, 0.95 } do
      local found = fabric.buckling { from = column(card, tri, part), count = 2 }
      local of = (" of %s%s, %g of the load"):format(name, tri and ", triangles" or "", part)
      check("column" .. of, part * found[1].factor, 1, 0.01)
      check("its second shape" .. of, part * found[2].factor, 9, 0.01)
    end
  end
end

-- Its shape as an imperfection: beyond its load the column bends to the side of the shape, and says so at once.
do
  local shape = fabric.buckling { from = column(svk, false, 0.5) }[1].shape
  for _, side in ipairs { 1, -1 } do
    local bent = shape:mesh(side * L / 1000)
    local run = column(svk, false, 0.5, bent)
    local tip = bent:set("right")[1]
    -- An imperfection grows by about 1 / (1 - part).
    check("bent to side " .. side, run:node(tip).z / (side * L / 1000), 2, 0.06)
  end
end

-- A supported square plate in compression, 4 pi^2 B / a^2 with H = B, and in shear, 9.34 pi^2 B / a^2 (Timoshenko).
do
  local a, D, h = 0.1, 1e-2, 1e-3
  local card = fabric.svk { density = 1000, thickness = h, warp = 5e8, weft = 5e8, shear = 2.5e8, poisson = 0,
    bending = { warp = D, weft = D, twist = D / 2 } }
  local function plate(n)
    return fabric.model { mesh = fabric.mesh.rectangle { width = a, height = a, nx = n, ny = n }, card = card, warp = 0 }
  end
  local m = plate(12):fix("boundary", "z"):fix("left", "x"):fix("bottom", "y")
  m:move("right", { x = fabric.ramp(-1e-6, 1) })
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local N = -run:mean "S11" * h
  check("plate in compression", fabric.buckling { from = run }[1].factor * N, 4 * pi ^ 2 * D / a ^ 2, 0.02)
  m = plate(24):fix("boundary", "z")
  m:fix("bottom", "x y"):fix("top", "y"):move("top", { x = fabric.ramp(1e-6, 1) })
  local mesh = m.mesh
  for i, id in ipairs(mesh:set "boundary") do -- the same shear at both sides
    local y = mesh.nodes[id][2]
    if y > 1e-9 and y < a - 1e-9 then
      mesh:set("side" .. i, { id })
      m:move("side" .. i, { x = fabric.ramp(1e-6 * y / a, 1), y = 0 })
    end
  end
  run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  check("plate in shear", fabric.buckling { from = run }[1].factor * run:mean "S12" * h, 9.34 * pi ^ 2 * D / a ^ 2, 0.02)
end

-- A ring under pressure that follows it: 3 B / r^3.
do
  local r, width, D = 0.05, 0.01, 1e-3
  local card = fabric.svk { density = 1000, thickness = 1e-3, warp = 5e7, weft = 5e7, shear = 2.5e7, poisson = 0,
    bending = { warp = D, weft = D, twist = D / 2 } }
  local mesh = fabric.mesh.cylinder { radius = r, length = width, around = 64, along = 1 }
  mesh:set("x axis", function(_, y) return math.abs(y) < 1e-9 end)
  mesh:set("y axis", function(x) return math.abs(x) < 1e-9 end)
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 } }
  m:fix("all", "z"):fix("x axis", "y"):fix("y axis", "x"):pressure(fabric.ramp(-1, 1))
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  check("ring", fabric.buckling { from = run }[1].factor, 3 * D / r ^ 3, 0.01)
end

-- Prandtl's deep strip, clamped, with a force at its tip: 4.0126 sqrt(EI GJ) / L^2; its clamped end warps less than in theory.
do
  local length, depth, D = 0.5, 0.02, 1e-2
  local card = fabric.svk { density = 1000, thickness = 1e-3, warp = 5e8, weft = 5e8, shear = 2.5e8, poisson = 0,
    bending = { warp = D, weft = D, twist = D / 2 } }
  local mesh = fabric.mesh.rectangle { width = length, height = depth, nx = 40, ny = 2, origin = { 0, -depth / 2, 0 } }
  mesh:set("tip", function(x, y) return x > length - 1e-9 and math.abs(y) < 1e-9 end)
  local P = 4.0126 * math.sqrt(D * depth * 2 * D * depth) / length ^ 2
  for _, part in ipairs { 0.1, 0.9 } do
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("left", "x y z rotation")
    m:force("tip", { y = fabric.ramp(-part * P, 1) })
    local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
    check(("deep strip, %g of its load"):format(part), part * fabric.buckling { from = run }[1].factor, 1, 0.03)
  end
end

fabric.expect(checks)
