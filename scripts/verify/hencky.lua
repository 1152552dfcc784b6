-- A flat circular membrane, clamped at its rim, blown up by a pressure: against Hencky's series (H. Hencky, Zeitschrift
-- fuer Mathematik und Physik 63 (1915) 311-317), summed here from its own recursion, for nu = 0.3. The series is that of
-- small slopes (Foeppl); p a / (E t) = 1e-6 keeps slopes near 1 % and the bending of a thin sheet out of the way.
--
--   fabricsh scripts/verify/hencky.lua [cells ...]      elements along the core of the disk, usually 8
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local problem = dofile((arg[0]:gsub("[^/]*$", "problem.lua")))
local nu, a, thickness, young = 0.3, 1.0, 1e-4, 1e9
local p = 1e-6 * young * thickness / a

-- With r = rho a, N_r = (p^2 a^2 E t)^(1/3) / 4 * B(rho^2) and w' = -2 rho / B * (p a / (E t))^(1/3): equilibrium and
-- compatibility give (rho^3 B')' / rho^3 * B^2 = -8, B = sum b_k x^k, x = rho^2. The rim: u = 0, that is
-- rho B' + (1 - nu) B = 0.
local function series(b0)
  local b, terms = { [0] = b0 }, 60
  -- 4 x B'' + 8 B' = -8 / B^2 with derivatives in x; q = 1 / B^2 by its own series.
  local inverse, q = { [0] = 1 / b0 }, {}
  for k = 0, terms do
    if k > 0 then
      local sum = 0
      for j = 1, k do sum = sum + b[j] * inverse[k - j] end
      inverse[k] = -sum / b0
    end
    local square = 0
    for j = 0, k do square = square + inverse[j] * inverse[k - j] end
    q[k] = square
    b[k + 1] = -8 * q[k] / (4 * (k + 1) * (k + 2))
  end
  local rim, slope, deflection = 0, 0, 0
  for k = 0, terms do
    rim, slope = rim + b[k], slope + 2 * k * b[k]
    deflection = deflection + inverse[k] / (k + 1) -- the integral of 2 rho / B from 0 to 1
  end
  return slope + (1 - nu) * rim, deflection
end
local low, high = 1.2, 3
for _ = 1, 100 do
  local middle = (low + high) / 2
  if series(middle) < 0 then low = middle else high = middle end
end
local b0 = low
local _, W = series(b0)
local w0 = W * a * (p * a / (young * thickness)) ^ (1 / 3)
local N0 = b0 / 4 * (p ^ 2 * a ^ 2 * young * thickness) ^ (1 / 3)
print(("Hencky, nu = %g: b0 %.6f, w = %.6f a (p a / (E t))^(1/3), N = %.6f (p^2 a^2 E t)^(1/3) in the middle"):format(nu, b0, W, b0 / 4))

local function membrane(cells)
  local mesh = fabric.mesh.disk { radius = a, cells = cells }
  local card = problem.plate(young, nu, thickness, { bending = { warp = 1e-7, weft = 1e-7, twist = 1e-7 } })
  local m = fabric.model { mesh = mesh, card = card, points = 1 }
  -- Without tension a flat membrane does not resist: the rim is drawn outwards first and let back under the pressure.
  local taut = 1e-4
  for i, node in ipairs(mesh:set "boundary") do
    local X, name = mesh.nodes[node], "rim " .. i
    mesh:set(name, { node })
    local function draw(x) return fabric.history { { 0, 0 }, { 0.1, taut * x }, { 0.5, taut * x }, { 1, 0 } } end
    m:move(name, { x = draw(X[1]), y = draw(X[2]) })
  end
  m:fix("boundary", "z"):pressure(fabric.history { { 0, 0 }, { 0.1, 0 }, { 0.5, p } })
  local run = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
  local centre = mesh:set "centre"
  mesh:set("middle", function(x, y) return x * x + y * y < (0.2 * a) ^ 2 end)
  local steps, iterations = problem.work(run)
  return run:node(centre[1]).uz, run:mean("S11", "middle") * thickness, steps, iterations
end

print "     cells        w / w0    error        N / N0    error  steps  iterations"
local last
for _, cells in ipairs(problem.sizes { 8 }) do
  local w, N, steps, iterations = membrane(cells)
  last = w
  print(("  %8d %13.7f %8.1e %13.7f %8.1e %6d %11d"):format(cells, w / w0, w / w0 - 1, N / N0, N / N0 - 1, steps, iterations))
end
fabric.expect {
  { "b0 (published: 1.7244 for nu = 0.3)", b0, 1.7244, absolute = 1e-4 },
  { "w / w0 on the finest mesh", last / w0, 1, absolute = 3e-3 },
}
