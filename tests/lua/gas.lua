-- Gas in closed volumes: a sphere of cloth that is blown up, breathes and leaks; a drum that is pressed together; flow through vents, through the
-- cloth and between two cells. Everything is compared with closed forms, on quadrilaterals and triangles.
local fabric = require "fabric"
local near = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).near

local R = 8.314462618 / 0.028965
local outside = 101325

-- A cube of n x n faces on each side, blown up to a sphere.
local function sphere(radius, n, triangles)
  local nodes, elements, known = {}, {}, {}
  local function node(i, j, k)
    local key = (i * (n + 1) + j) * (n + 1) + k
    if not known[key] then
      local x, y, z = math.tan((2 * i / n - 1) * math.pi / 4), math.tan((2 * j / n - 1) * math.pi / 4), math.tan((2 * k / n - 1) * math.pi / 4)
      local l = radius / math.sqrt(x * x + y * y + z * z)
      nodes[#nodes + 1] = { l * x, l * y, l * z }
      known[key] = #nodes
    end
    return known[key]
  end
  local function face(a, b, c, d)
    if triangles then
      elements[#elements + 1], elements[#elements + 2] = { a, b, c }, { a, c, d }
    else
      elements[#elements + 1] = { a, b, c, d }
    end
  end
  for side = 1, 3 do
    for s = 0, n, n do
      for i = 0, n - 1 do
        for j = 0, n - 1 do
          local function at(u, v)
            if side == 1 then return node(s, u, v) elseif side == 2 then return node(v, s, u) else return node(u, v, s) end
          end
          if s > 0 then
            face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
          else
            face(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j))
          end
        end
      end
    end
  end
  return fabric.mesh { nodes = nodes, elements = elements }
end

local function around(x, y, z) return math.abs(z) > 0.8 * math.sqrt(x * x + y * y + z * z) and { 1, 0, 0 } or { -y, x, 0 } end
local Y, nu, t, rho, r0 = 20e6, 0.3, 0.3e-3, 900, 0.12
local card = fabric.svk { young = Y, poisson = nu, density = rho, thickness = t }

local function ball(n, triangles)
  local mesh = sphere(r0, n, triangles)
  mesh:set("pole", function(x, y, z) return z > r0 * (1 - 1e-9) end)
  mesh:set("foot", function(x, y, z) return z < -r0 * (1 - 1e-9) end)
  mesh:set("side", function(x, y, z) return x > r0 * (1 - 1e-9) end)
  local m = fabric.model { mesh = mesh, card = card, membrane = true, warp = around }
  return m:fix("pole", "x y"):fix("foot", "x y z"):fix("side", "y")
end

-- Twice the air: p = Y t (s^2 - 1) / ((1 - nu) r0 s) balances p V = m R T at r = s r0.
local V0 = 4 / 3 * math.pi * r0 ^ 3
local low, high = 1, 2
for _ = 1, 100 do
  local s = (low + high) / 2
  local p = Y * t / (1 - nu) * (s * s - 1) / (r0 * s)
  if (p + outside) * s ^ 3 < 2 * outside then low = s else high = s end
end
local stretched = low
local rows = {}
for _, triangles in ipairs { false, true } do
  local last
  for _, n in ipairs { 2, 4, 8 } do
    local m = ball(n, triangles)
    local V = outside * V0 / (R * 293.15) -- kg
    local g = m:gas { inflow = { { 0, 0 }, { 0.5, 2 * V }, { 1, 0 } } }
    local a = fabric.static { model = m, duration = 1, step = 0.1 }
    local _, before, mass = a:gas(g)
    a:solve()
    local p, volume, more, T = a:gas(g)
    near(more, mass + V, 1e-9, "mass")
    near((p + outside) * volume, more * R * T, 1e-12, "ideal gas")
    near(T, 293.15, 1e-12, "isothermal")
    local off = math.abs((volume / before) ^ (1 / 3) - stretched)
    if last then assert(off < 0.45 * last, ("%d: %g after %g"):format(n, off, last)) end
    last = off
    assert(a.energy.error < 1e-3 and a.energy.gas > 0, a.energy.error)
    for _, s in ipairs(a.steps) do assert(s.stable == true and s.iterations < 15) end
  end
  rows[#rows + 1] = { "sphere, stretch too large or small by", last, 0, absolute = 4e-3 }
end

-- It breathes: w^2 = (2 Y t / ((1 - nu) r0^2) + 3 n p / r0) / (rho t).
for _, scheme in ipairs { "explicit", "implicit" } do
  local w = math.sqrt((2 * Y * t / ((1 - nu) * r0 ^ 2) + 3 * 1.4 * outside / r0) / (rho * t))
  local m = ball(6, scheme == "implicit")
  m:velocity("all", function(x, y, z) return { x = 0.05 * x / r0, y = 0.05 * y / r0, z = 0.05 * z / r0 } end)
  local g = m:gas { exponent = 1.4 }
  local period = 2 * math.pi / w
  local a = fabric.dynamic { model = m, scheme = scheme, duration = 1.3 * period, step = scheme == "implicit" and period / 100 or nil }
  local _, V = a:gas(g)
  local zeros, before, when = {}, 0, 0
  a:every("step", function()
    local _, now = a:gas(g)
    now = now - V
    if before * now < 0 then zeros[#zeros + 1] = when + (a.time - when) * before / (before - now) end
    before, when = now, a.time
  end)
  a:solve()
  rows[#rows + 1] = { "breathing, " .. scheme, zeros[2] - zeros[1], period / 2, relative = 0.01 }
  assert(a.energy.error < (scheme == "implicit" and 1e-3 or 1e-2), a.energy.error)
end
fabric.expect(rows)
