-- The effect of a break on the yarns beside it, and a yarn that is struck: against equations of this deck's own.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()

-- Shear lag: a sheet whose points move along the yarns (y) alone, pulled by a strain e, r neighbouring lines of yarns broken at mid-height.
-- With the bilinear shape functions N of rectangles a x b the forces of an element on its corners are t (E int N,y N,y + G int N,x N,x) v;
-- the first integral is the product of those of linear functions along the edges, (2, 1; 1, 2) / 6 and (1, -1; -1, 1); in-plane shear is that
-- of the middle, so that (1, 1; 1, 1) / 4 stands for (2, 1; 1, 2) / 6. By symmetry the upper half is enough: at mid-height broken yarns are
-- free, the others held.
local function lag(nx, ny, a, b, E, G, t, e, broken)
  local across, K = nx + 1, {}
  local mass, stiff = { { 2 / 6, 1 / 6 }, { 1 / 6, 2 / 6 } }, { { 1, -1 }, { -1, 1 } }
  local corner = { { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 } } -- along x, along y
  for p = 1, 4 do
    K[p] = {}
    for q = 1, 4 do
      local i, j, k, l = corner[p][1], corner[p][2], corner[q][1], corner[q][2]
      K[p][q] = t * (E * a / b * mass[i][k] * stiff[j][l] + G * b / a * stiff[i][k] / 4)
    end
  end
  local function forces(v)
    local f = {}
    for n = 1, across * (ny + 1) do f[n] = 0 end
    for j = 0, ny - 1 do
      for i = 0, nx - 1 do
        local n = j * across + i + 1
        local ids = { n, n + 1, n + 1 + across, n + across }
        for p = 1, 4 do
          local sum = 0
          for q = 1, 4 do sum = sum + K[p][q] * v[ids[q]] end
          f[ids[p]] = f[ids[p]] + sum
        end
      end
    end
    return f
  end
  local v, free = {}, {}
  for j = 0, ny do
    for i = 0, nx do
      local n = j * across + i + 1
      v[n] = e * j * b
      free[n] = j < ny and (j > 0 or broken[i] or false)
    end
  end
  -- Conjugate gradients over the free points.
  local r, d, rr = forces(v), {}, 0
  for n = 1, #v do
    r[n] = free[n] and -r[n] or 0
    d[n], rr = r[n], rr + r[n] ^ 2
  end
  local first = rr
  for _ = 1, 5000 do
    if rr < 1e-26 * first then break end
    local q, dq = forces(d), 0
    for n = 1, #v do
      q[n] = free[n] and q[n] or 0
      dq = dq + d[n] * q[n]
    end
    local alpha, new = rr / dq, 0
    for n = 1, #v do
      v[n], r[n] = v[n] + alpha * d[n], r[n] - alpha * q[n]
      new = new + r[n] ^ 2
    end
    for n = 1, #v do d[n] = r[n] + new / rr * d[n] end
    rr = new
  end
  local f = forces(v)
  return function(i) return -f[i + 1] / (E * t * a * e) end -- of the line i, over that far away
end

for r = 1, 4 do
  local nx, ny, a, b, t, e, E = 24, 9, 1.3e-3, 0.9e-3, 0.4e-3, 1e-7, 2e8
  local G = 3e6 / r
  local strength, first = 1e3, 11
  local mesh = fabric.mesh.rectangle { width = nx * a, height = 2 * ny * b, nx = nx, ny = 2 * ny }
  local card = common.sheet { warp = E, weft = E, shear = G, poisson = { 0, 0 }, thickness = t }:with { rupture = { warp = { strength = strength, energy = 1e4 } } }
  local m = fabric.model { mesh = mesh, card = card, warp = 90 }
  m:fix("all", "x z rotation"):fix("bottom", "y"):move("top", { y = fabric.ramp(2 * ny * b * e, 1) }):tearable "all"
  local run = fabric.static { model = m, duration = 1, step = 1, tolerance = 1e-13 }
  run:cut { line = { { (first - 1) * a, ny * b, 0 }, { (first + r) * a, ny * b, 0 } } }
  run:solve()
  local broken = {}
  for i = first, first + r - 1 do broken[i] = true end
  local own = lag(nx, ny, a, b, E, G, t, e, broken)
  -- The element above mid-height whose left lower corner is the first whole line: it shows the largest share of its corners. That joint stands
  -- for half a spacing, up to the end of the cut.
  local shares = run:field "rupture_warp"
  local tip = first + r
  checks(("%d broken: force of the next line over that far away"):format(r), shares[ny * nx + tip + 1] * strength / (2 * E * t * e), own(tip), { relative = 1e-6 })
end

-- A yarn struck crosswise with a speed V: with the wave speed c = sqrt(E / rho) and the strain e behind the wave that runs along it,
--   V = c sqrt(2 e sqrt(e (1 + e)) - e^2),   and the kink runs outwards in space with c (sqrt(e (1 + e)) - e)     [smith1958].
-- That is for a tension in proportion to the strain; here it is E e (1 + 3 e / 2) to first order, 0.6 % more.
do
  local E, rho, l, n, e = 1e9, 1000, 0.3, 600, 0.004
  local c = math.sqrt(E / rho)
  local V, kink = c * math.sqrt(2 * e * math.sqrt(e * (1 + e)) - e ^ 2), c * (math.sqrt(e * (1 + e)) - e)
  local mesh = fabric.mesh.rectangle { width = l, height = 1e-3, nx = n, ny = 1 }
  local m = fabric.model { mesh = mesh, card = common.sheet { young = E, density = rho, thickness = 0.2e-3 }, warp = 0, membrane = true }
  local T = 0.9 * l / c
  m:fix("all", "y"):fix("left", "x"):fix("right", "x z"):move("left", { z = function(time) return V * time end })
  local a = fabric.dynamic { model = m, duration = T, ledger_limit = 1 }
  a:solve()
  -- Between the striker and the kink the yarn is straight, and slopes by V / kink.
  local sx, sz, sxx, sxz, count, strain = 0, 0, 0, 0, 0, 0
  local strains = a:field "nominal_strain_warp"
  for i = 1, n do
    local p = a:node(i)
    if p.x > 0.15 * kink * T and p.x < 0.75 * kink * T then
      sx, sz, sxx, sxz, count, strain = sx + p.x, sz + p.z, sxx + p.x ^ 2, sxz + p.x * p.z, count + 1, strain + strains[i]
    end
  end
  checks("struck yarn: speed of the kink, m/s", -V * (count * sxx - sx ^ 2) / (count * sxz - sx * sz), kink, { relative = 0.02 })
  checks("struck yarn: strain", strain / count, e, { relative = 0.02 })
end

checks()
