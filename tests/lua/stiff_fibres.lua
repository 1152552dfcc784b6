-- A cantilever of parallel fibres under its own weight: very stiff along, soft across and in shear. Its sag is that of a slender rod that does not stretch,
-- EI theta'' = -q (L - s) cos theta, here by Runge and Kutta's method; the transverse shear that is derived from the card would add 13 and 15 % to it.
local fabric = require "fabric"
local mm = fabric.units.mm

-- sag over reach, for q L^3 / B
local function slender(load)
  local function shoot(bend)
    local n, angle, x, z = 800, 0, 0, 0
    local function slope(s, a) return -load * (1 - s) * math.cos(a) end
    for i = 0, n - 1 do
      local s, h = i / n, 1 / n
      local k1, b1 = bend, slope(s, angle)
      local k2, b2 = bend + h / 2 * b1, slope(s + h / 2, angle + h / 2 * k1)
      local k3, b3 = bend + h / 2 * b2, slope(s + h / 2, angle + h / 2 * k2)
      local k4, b4 = bend + h * b3, slope(s + h, angle + h * k3)
      local middle = angle + h / 2 * k2
      local last = angle + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
      x = x + h / 6 * (math.cos(angle) + 4 * math.cos(middle) + math.cos(last))
      z = z + h / 6 * (math.sin(angle) + 4 * math.sin(middle) + math.sin(last))
      angle, bend = last, bend + h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)
    end
    return bend, z / x
  end
  local low, high = 0, load + 1
  for _ = 1, 50 do
    local middle = (low + high) / 2
    if shoot(middle) > 0 then high = middle else low = middle end
  end
  return select(2, shoot(low))
end

local checks = {}
local function sags(o)
  local t, mass = 0.25 * mm, 0.16
  local mesh = fabric.mesh.rectangle { width = o.length, height = o.length / 5, nx = o.nx, ny = o.ny, triangles = o.triangles }
  local card = fabric.svk { name = "tape", warp = 2e6 / t, weft = 120 / t, shear = o.shear / t, poisson = 0, density = mass / t, thickness = t, bending = { warp = o.B, weft = 5e-6, twist = 3e-6 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("left", "x y z rotation"):gravity { 0, 0, fabric.ramp(-9.81, 1) }
  local a = fabric.static { model = m, duration = 1, step = 0.25, method = o.method }
  a:solve()
  local far, low = 0, 0
  for i = 1, #mesh.nodes do
    local q = a:node(i)
    far, low = math.max(far, q.x), math.min(low, q.z)
  end
  local wanted = slender(mass * 9.81 * o.length ^ 3 / o.B)
  print(("B %g, L %g, %d x %d %s, %s: %.5f, slender rod %.5f"):format(o.B, o.length, o.nx, o.ny, o.triangles and "triangles" or "quads", o.method or "default", -low / far, wanted))
  checks[#checks + 1] = { ("sag, %d x %d %s"):format(o.nx, o.ny, o.method or ""), -low / far, wanted, relative = 1e-2 }
end
sags { B = 1.2e-3, length = 50 * mm, shear = 18, nx = 12, ny = 4 }
sags { B = 1.2e-3, length = 50 * mm, shear = 18, nx = 12, ny = 4, method = "relaxation" }
sags { B = 1.2e-3, length = 50 * mm, shear = 18, nx = 24, ny = 5, triangles = true }
sags { B = 4e-4, length = 80 * mm, shear = 2, nx = 16, ny = 3 }
fabric.expect(checks)
