-- Critical factors of cylinders, under pressure from outside and pressed endwise, and of a deep strip that is bent, against closed forms.
local fabric = require "fabric"
local pi = math.pi
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end
local function isotropic(Et, D)
  return fabric.svk { density = 1000, thickness = 1e-3, warp = Et / 1e-3, weft = Et / 1e-3, shear = Et / 2e-3, poisson = 0,
    bending = { warp = D, weft = D, twist = D / 2 } }
end

-- The least pressure on the side of a cylinder with supported ends, by the shell theory of Sanders and Koiter: the stiffness H and
-- what a pressure of 1 Pa takes from it, G, for axial, tangential and radial waves, n of them around.
local function side_pressure(r, Et, D, length)
  local k, least = pi / length, math.huge
  for n = 2, 12 do
    local H, G = {}, {}
    for i = 1, 3 do H[i], G[i] = { 0, 0, 0 }, { 0, 0, 0 } end
    local function add(M, c, strain)
      for i = 1, 3 do for j = 1, 3 do M[i][j] = M[i][j] + c * strain[i] * strain[j] end end
    end
    local around = { 0, n / r, 1 / r }
    add(H, Et, { -k, 0, 0 })
    add(H, Et, around)
    add(H, Et / 2, { -n / r, k, 0 })
    add(H, D, { 0, 0, -k ^ 2 })
    add(H, D, { 0, -n / r ^ 2, -n ^ 2 / r ^ 2 })
    add(H, 2 * D, { -n / (4 * r ^ 2), -3 * k / (4 * r), -k * n / r })
    add(G, -r, { -n / r, 0, 0 })
    add(G, -r, around)
    add(G, -r, { 0, -1 / r, -n / r })
    -- the volume that the waves enclose
    for _, entry in ipairs { { 2, 2, 1 / r }, { 3, 3, 1 / r }, { 2, 3, n / r }, { 3, 2, n / r }, { 1, 3, -k }, { 3, 1, -k } } do
      G[entry[1]][entry[2]] = G[entry[1]][entry[2]] + entry[3]
    end
    local function left(p)
      local m = {}
      for i = 1, 3 do
        m[i] = {}
        for j = 1, 3 do m[i][j] = H[i][j] + p * G[i][j] end
      end
      return m[1][1] * (m[2][2] * m[3][3] - m[2][3] * m[3][2]) - m[1][2] * (m[2][1] * m[3][3] - m[2][3] * m[3][1])
        + m[1][3] * (m[2][1] * m[3][2] - m[2][2] * m[3][1])
    end
    local low, step = 0, 3 * D / r ^ 3 / 50
    while left(low + step) > 0 do low = low + step end
    local high = low + step
    for _ = 1, 60 do
      local middle = (low + high) / 2
      if left(middle) > 0 then low = middle else high = middle end
    end
    least = math.min(least, low)
  end
  return least
end

-- Half of the length and half around. The ends widen with the rest, and are held there: stresses are even, as in the theory.
do
  local r, Et, D, length = 0.05, 2e5, 6e-3, 0.12
  local mesh = fabric.mesh.cylinder { radius = r, length = length / 2, around = 72, along = 12, angle = 180 }
  local function of_end(z) return z > length / 2 - 1e-9 end
  mesh:set("middle", function(_, _, z) return z < 1e-9 end)
  mesh:set("end", function(_, y, z) return of_end(z) and y > 1e-9 end)
  mesh:set("corners", function(_, y, z) return of_end(z) and y < 1e-9 end)
  mesh:set("x axis", function(_, y) return y < 1e-9 end)
  mesh:set("y axis", function(x) return math.abs(x) < 1e-9 end)
  local m = fabric.model { mesh = mesh, card = isotropic(Et, D), warp = { 0, 0, 1 } }
  m:symmetry("middle", "z"):symmetry("x axis", "y"):pressure(fabric.ramp(-1, 1))
  local wide = fabric.static { model = m:copy():fix("y axis", "x"), duration = 1, step = 1 }:solve()
  m:fix("end", "x y"):fix("corners", "x")
  local run = fabric.static { from = wide, model = m, duration = 1, step = 1 }:solve()
  check("cylinder, pressure on its side", fabric.buckling { from = run }[1].factor, side_pressure(r, Et, D, length), 0.01)
end

-- Endwise, two half waves long: 2 sqrt(E t D) / r per length. Many shapes have nearly the same factor.
do
  local r, Et, D = 0.05, 1e5, 2e-3
  local length = 2 * pi * (D * r ^ 2 / Et) ^ 0.25
  local mesh = fabric.mesh.cylinder { radius = r, length = length, around = 28, along = 24, angle = 90 }
  local function ends(z) return z < 1e-9 or z > length - 1e-9 end
  mesh:set("low", function(_, _, z) return z < 1e-9 end)
  mesh:set("high", function(_, _, z) return z > length - 1e-9 end)
  mesh:set("x axis", function(_, y) return y < 1e-9 end)
  mesh:set("y axis", function(x) return x < 1e-9 end)
  mesh:set("ends", function(x, y, z) return ends(z) and x > 1e-9 and y > 1e-9 end)
  mesh:set("ends on x", function(_, y, z) return ends(z) and y < 1e-9 end)
  mesh:set("ends on y", function(x, _, z) return ends(z) and x < 1e-9 end)
  local m = fabric.model { mesh = mesh, card = isotropic(Et, D), warp = { 0, 0, 1 } }
  m:symmetry("x axis", "y"):symmetry("y axis", "x"):fix("ends", "x y"):fix("ends on x", "x"):fix("ends on y", "y")
  m:fix("low", "z"):force("high", { z = fabric.ramp(-1, 1) })
  local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
  check("cylinder, endwise", fabric.buckling { from = run }[1].factor / (pi * r / 2), 2 * math.sqrt(Et * D) / r, 0.01)
end

-- Michell's deep strip under the same moment everywhere, with ends that do not twist: pi sqrt(EI GJ) / L.
for _, tri in ipairs { false, true } do
  local length, depth, D = 0.5, 0.02, 1e-2
  local mesh = fabric.mesh.rectangle { width = length, height = depth, nx = 40, ny = 2, origin = { 0, -depth / 2, 0 }, triangles = tri }
  for name, at in pairs { ["left top"] = { 0, depth / 2 }, ["left bottom"] = { 0, -depth / 2 }, ["left middle"] = { 0, 0 },
    ["right top"] = { length, depth / 2 }, ["right bottom"] = { length, -depth / 2 }, ["right middle"] = { length, 0 } } do
    mesh:set(name, function(x, y) return math.abs(x - at[1]) < 1e-9 and math.abs(y - at[2]) < 1e-9 end)
  end
  local M = pi / length * math.sqrt(D * depth * 2 * D * depth)
  for _, part in ipairs { 0.1, 0.9 } do
    local m = fabric.model { mesh = mesh, card = isotropic(5e5, D), warp = 0 }:fix("left", "z"):fix("right", "z")
    m:fix("left middle", "x y"):fix("right middle", "y")
    local pull, push = { x = fabric.ramp(part * M / depth, 1) }, { x = fabric.ramp(-part * M / depth, 1) }
    m:force("left top", pull):force("left bottom", push):force("right top", push):force("right bottom", pull)
    local run = fabric.static { model = m, duration = 1, step = 1 }:solve()
    check(("deep strip that is bent, %g of its load%s"):format(part, tri and ", triangles" or ""),
      part * fabric.buckling { from = run }[1].factor, 1, 0.01)
  end
end

fabric.expect(checks)
