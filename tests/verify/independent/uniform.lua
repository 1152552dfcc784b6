-- Uniform states of strain in sheets of squares, of distorted quadrilaterals and of triangles, at rest and in motion, turned in space; the forces that
-- hold them; tubes; halves against wholes.
--
-- In virgin woven cloth [share/doc/law.md], all strains rising: S11 = P1(E11) + c (nu12 E11 + E22), S22 = P2(E22) + c (nu21 E22 + E11), S12 = Pg(2 E12), with
-- P(E) = d0 E + d1 E^2 / 2 + ..., c = min(nu21 d0, nu12 k0) / (1 - nu12 nu21), E = (F^T F - 1) / 2. The force on an edge whose normal in the reference is N is F S N
-- times thickness and length there.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()

local function P(coefficients, x)
  local sum = 0
  for k, d in ipairs(coefficients) do sum = sum + d * x ^ k / k end
  return sum
end

-- E11, E22, E12 and S11, S22, S12 of virgin cloth under F = { { a, b }, { c, d } }, warp along x.
local function state(card, F)
  local E11 = (F[1][1] ^ 2 + F[2][1] ^ 2 - 1) / 2
  local E22 = (F[1][2] ^ 2 + F[2][2] ^ 2 - 1) / 2
  local E12 = (F[1][1] * F[1][2] + F[2][1] * F[2][2]) / 2
  local n12, n21 = card.warp.poisson, card.weft.poisson
  local c = math.min(n21 * card.warp.loading[1], n12 * card.weft.loading[1]) / (1 - n12 * n21)
  -- The shear's table is dS12 / dE12 over E12 with the tensor's S12.
  local S12 = 0
  for k, d in ipairs(card.shear.loading) do S12 = S12 + d * E12 ^ k / k end
  return { E11, E22, E12 }, { P(card.warp.loading, E11) + c * (n12 * E11 + E22), P(card.weft.loading, E22) + c * (n21 * E22 + E11), S12 }
end

local width, height, nx, ny = 0.08, 0.05, 5, 4
local function rectangle(kind)
  local mesh = fabric.mesh.rectangle { width = width, height = height, nx = nx, ny = ny, triangles = kind == "triangles" }
  if kind ~= "squares" then common.distorted(mesh, width, height, nx, ny, kind == "triangles" and 0.15 or 0.25) end
  return mesh
end

-- A rotation by an angle, degrees, about an axis: the matrix of Rodrigues.
local function rotation(angle, axis)
  local a, size = math.rad(angle), math.sqrt(axis[1] ^ 2 + axis[2] ^ 2 + axis[3] ^ 2)
  local x, y, z = axis[1] / size, axis[2] / size, axis[3] / size
  local c, s = math.cos(a), math.sin(a)
  return { { c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s }, { y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s },
    { z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c) } }
end
local function turned(R, v)
  local out = {}
  for i = 1, 3 do out[i] = R[i][1] * v[1] + R[i][2] * v[2] + R[i][3] * (v[3] or 0) end
  return out
end

local T = 1
-- A sheet whose edge is moved as F says, in time T, its inside free; R: turned in space beforehand. Returns the run.
local function strained(mesh, card, F, R, how)
  local flat = {}
  for i = 1, #mesh.nodes do flat[i] = { mesh.nodes[i][1], mesh.nodes[i][2] } end
  if R then mesh:map(function(x, y, z) return table.unpack(turned(R, { x, y, z })) end) end
  local m = fabric.model { mesh = mesh, card = card, warp = R and turned(R, { 1, 0, 0 }) or 0 }
  local frame = R and { turned(R, { 1, 0, 0 }), turned(R, { 0, 1, 0 }) } or nil
  for _, i in ipairs(mesh:set "boundary") do
    local name, X = "edge " .. i, flat[i]
    mesh:set(name, { i })
    local ux, uy = (F[1][1] - 1) * X[1] + F[1][2] * X[2], F[2][1] * X[1] + (F[2][2] - 1) * X[2]
    local x, y = fabric.ramp(ux, T), fabric.ramp(uy, T)
    if how.scheme then
      -- Smoothly, so that little swings: an explicit run of a fiftieth of a second.
      local function soft(u) return function(t) local s = math.min(t / how.duration, 1) return u * s ^ 3 * (10 - 15 * s + 6 * s * s) end end
      x, y = soft(ux), soft(uy)
    end
    m:move(name, { x = x, y = y }, frame and { frame = frame })
  end
  m:fix("all", "z rotation", frame and { frame = frame })
  if how.scheme then return fabric.dynamic { model = m, duration = how.duration, scheme = how.scheme, step = how.step }:solve() end
  return fabric.static { model = m, duration = T, step = T / 4 }:solve()
end

local blend = fabric.card "blend"
local states = {
  { "stretched and sheared", { { 1.04, 0.09 }, { 0.02, 1.015 } } },
  { "equal in both directions", { { 1.05, 0 }, { 0, 1.05 } } },
  { "simple shear", { { 1, 0.21 }, { 0, 1 } } },
}
for _, case in ipairs(states) do
  local F = case[2]
  local E, S = state(blend, F)
  for _, kind in ipairs { "squares", "distorted", "triangles" } do
    local a = strained(rectangle(kind), blend, F, nil, {})
    local worst = 0
    for k, name in ipairs { "S11", "S22", "S12" } do
      for _, s in ipairs(a:field(name)) do worst = math.max(worst, math.abs(s - S[k]) / math.max(S[1], S[2])) end
    end
    for k, name in ipairs { "E11", "E22", "E12" } do
      for _, e in ipairs(a:field(name)) do worst = math.max(worst, math.abs(e - E[k])) end
    end
    checks(("%s, %s: every element"):format(case[1], kind), worst, 0, { absolute = 1e-9 }) -- Newton's tolerance
  end
  -- The forces that hold the edges: the right one has the normal x, the upper one y. Nodes of the corners belong to both.
  local a = strained(rectangle "distorted", blend, F, nil, {})
  local up, right = { 0, 0 }, { 0, 0 }
  local t = blend.thickness
  for i = 1, 2 do
    right[i] = (F[i][1] * S[1] + F[i][2] * S[3]) * t * height
    up[i] = (F[i][1] * S[3] + F[i][2] * S[2]) * t * width
  end
  local scale = math.max(math.abs(right[1]), math.abs(up[2]))
  local x, y = a:reaction "right"
  -- On the right edge the corners also carry half an element of the upper and the lower edge, whose forces are opposite.
  checks(case[1] .. ": force on the right, x", x / scale, right[1] / scale, { absolute = 1e-8 })
  checks(case[1] .. ": force on the right, y", y / scale, right[2] / scale, { absolute = 1e-8 })
  x, y = a:reaction "top"
  checks(case[1] .. ": force on the top, x", x / scale, up[1] / scale, { absolute = 1e-8 })
  checks(case[1] .. ": force on the top, y", y / scale, up[2] / scale, { absolute = 1e-8 })

  -- Turned by 143 degrees about an oblique axis: the same strains and stresses, the forces turned with it.
  local R = rotation(143, { 1, -2, 0.5 })
  for _, kind in ipairs { "distorted", "triangles" } do
    local b = strained(rectangle(kind), blend, F, R, {})
    local worst = 0
    for k, name in ipairs { "S11", "S22", "S12" } do
      for _, s in ipairs(b:field(name)) do worst = math.max(worst, math.abs(s - S[k]) / math.max(S[1], S[2])) end
    end
    checks(("%s, %s, turned by 143 degrees: stresses"):format(case[1], kind), worst, 0, { absolute = 1e-8 })
    local wanted, got, off = turned(R, { right[1], right[2], 0 }), { b:reaction "right" }, 0
    for i = 1, 3 do off = math.max(off, math.abs(got[i] - wanted[i]) / scale) end
    checks(("%s, %s, turned by 143 degrees: forces"):format(case[1], kind), off, 0, { absolute = 1e-8 })
  end
end

-- The same in motion: implicit, and explicit slowly enough that what still swings is small.
for _, how in ipairs { { scheme = "implicit", duration = 0.05, step = 1e-3 }, { scheme = "explicit", duration = 0.05 } } do
  local _, S = state(blend, states[1][2])
  local a = strained(rectangle "distorted", blend, states[1][2], nil, how)
  for k, name in ipairs { "S11", "S22", "S12" } do checks(("in motion, %s: %s"):format(how.scheme, name), a:mean(name), S[k], { relative = 5e-3 }) end
  checks(("in motion, %s: what still moves"):format(how.scheme), a.energy.kinetic / a.energy.stored, 0, { absolute = 1e-4 })
end

-- A strip pulled at an angle to the warp between grips that let it contract and shear: a uniform uniaxial state. St. Venant-Kirchhoff of the moduli E1, E2, G and the
-- coupling n = sqrt(nu12 nu21): E11 = S11 / E1 - n S22 / sqrt(E1 E2) and so on. Under a pull S along x, which is c, s in the axes of the cloth:
--   S11 = S c^2, S22 = S s^2, S12 = -S s c;  E along the pull = E11 c^2 + E22 s^2 - 2 E12 s c.
-- The line along x stays along x, so the force is lambda S t b, lambda = sqrt(1 + 2 E).
do
  local E1, E2, G, n12, n21, angle, b = 5e6, 2e6, 0.6e6, 0.3, 0.18, 33, height
  local n, t = math.sqrt(n12 * n21), 0.5e-3
  local card = common.sheet { warp = E1, weft = E2, shear = G, poisson = { n12, n21 }, thickness = t }
  local c, s, S = math.cos(math.rad(angle)), math.sin(math.rad(angle)), 0.11e6
  local S11, S22, S12 = S * c * c, S * s * s, -S * s * c
  local e11, e22, e12 = S11 / E1 - n * S22 / math.sqrt(E1 * E2), S22 / E2 - n * S11 / math.sqrt(E1 * E2), S12 / (2 * G)
  local Exx = e11 * c * c + e22 * s * s - 2 * e12 * s * c
  local Eyy = e11 * s * s + e22 * c * c + 2 * e12 * s * c
  local Exy = (e11 - e22) * s * c + e12 * (c * c - s * s)
  local l1 = math.sqrt(1 + 2 * Exx)
  for _, kind in ipairs { "squares", "distorted", "triangles" } do
    local mesh = rectangle(kind)
    local m = fabric.model { mesh = mesh, card = card, warp = angle }
    mesh:set("corner", { common.nearest(mesh, 0, 0) })
    mesh:set("other corner", { common.nearest(mesh, width, 0) })
    local force = fabric.ramp(l1 * S * t * b, 1)
    m:fix("all", "z rotation"):fix("corner", "x y"):fix("other corner", "y")
    m:force("right", { x = force }):force("left", { x = function(time) return -force:value(time) end })
    local a = fabric.static { model = m, duration = 1, step = 0.25 }:solve()
    local worst = 0
    for k, name in ipairs { "E11", "E22", "E12" } do
      for _, e in ipairs(a:field(name)) do worst = math.max(worst, math.abs(e - ({ e11, e22, e12 })[k])) end
    end
    checks(("pull at %g degrees, %s: strains of the cloth"):format(angle, kind), worst, 0, { absolute = 1e-9 })
    local p, q = a:node(common.nearest(mesh, width, 0)), a:node(common.nearest(mesh, 0, height))
    checks(("pull at %g degrees, %s: longer"):format(angle, kind), p.x / width, l1, { relative = 1e-9 })
    checks(("pull at %g degrees, %s: how far it shears"):format(angle, kind), (q.x * l1) / height, 2 * Exy, { relative = 1e-8 })
    checks(("pull at %g degrees, %s: narrower"):format(angle, kind), (q.x / height) ^ 2 + (q.y / height) ^ 2, 1 + 2 * Eyy, { relative = 1e-9 })
  end
end

-- A tube under pressure, held in length: the hoop's force per width lambda S t carries p lambda R, so that S = p R / t. With C = E2 / (1 - nn) the hoop strain is
-- p R / (t C), and the length is held by C12 E t per width. Facets: a chord of the angle d is shorter by d^2 / 24, and takes its pressure by cos(d / 2).
do
  local R, length, E1, E2, n12, n21, t, p, around = 0.04, 0.06, 6e6, 2.5e6, 0.25, 0.15, 0.4e-3, 2200, 48
  local nn = n12 * n21
  local card = common.sheet { warp = E1, weft = E2, shear = 1e6, poisson = { n12, n21 }, thickness = t, bending = { warp = 1e-9, weft = 1e-9, twist = 1e-9 } }
  for _, scheme in ipairs { "static", "implicit" } do
    local mesh = fabric.mesh.cylinder { radius = R, length = length, around = around, along = 3 }
    local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 } }
    mesh:set("on x", function(_, y) return math.abs(y) < 1e-6 end)
    mesh:set("on y", function(x) return math.abs(x) < 1e-6 end)
    m:fix("all", "z"):fix("on x", "y"):fix("on y", "x") -- against turning and drifting
    local a
    if scheme == "static" then
      m:pressure(fabric.history { { 0, 0 }, { 1, p } })
      a = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
    else
      -- Slowly against the breathing of the tube, 1 / (2 pi R) sqrt(C / rho): 300 Hz.
      m:pressure(function(time) local s = math.min(time / 0.05, 1) return p * s * s * (3 - 2 * s) end)
      a = fabric.dynamic { model = m, duration = 0.06, scheme = "implicit", step = 1e-3 }:solve()
    end
    local hoop = p * R / t / (E2 / (1 - nn))
    assert(hoop > 0.05)
    local how = { relative = scheme == "static" and 3e-3 or 1e-2 } -- d^2 / 24 + d^2 / 8 = 0.3 % for 48 facets, of what still breathes
    checks("tube, " .. scheme .. ": hoop strain", a:mean "E22", hoop, how)
    checks("tube, " .. scheme .. ": pull along", a:mean "S11", math.sqrt(nn * E1 * E2) / (1 - nn) * hoop, how)
    local widest = 0
    for i = 1, #mesh.nodes do
      local x = a:node(i)
      widest = math.max(widest, math.sqrt(x.x ^ 2 + x.y ^ 2))
    end
    checks("tube, " .. scheme .. ": radius", widest / R, math.sqrt(1 + 2 * hoop), { relative = 1e-3 })
  end
end

-- The half of a sheet that is the same on both sides does what the whole does, at rest and in motion: a rectangle of woven cloth, unlike along and across, held at two edges
-- and loaded by its weight, and the quarter of it.
do
  local a, b = 0.12, 0.08
  local card = fabric.card "blend":with { bending = { warp = 15e-6, weft = 7e-6, twist = 4e-6 } }
  local function hung(part, scheme)
    local w, h = part == "whole" and a or a / 2, part == "quarter" and b / 2 or b
    local mesh = fabric.mesh.rectangle { width = w, height = h, nx = part == "whole" and 8 or 4, ny = part == "quarter" and 3 or 6, origin = { part == "whole" and -a / 2 or 0,
      part == "quarter" and 0 or -b / 2, 0 } }
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }
    if part ~= "whole" then m:symmetry("left", "x") end
    if part == "quarter" then m:symmetry("bottom", "y") end
    m:fix("right", "x y z")
    if part == "whole" then m:fix("left", "x y z") end
    m:gravity { 0, 0, fabric.ramp(-9.81, scheme == "static" and 1 or 1e-3) }
    local run = scheme == "static" and fabric.static { model = m, duration = 1, step = 0.05, tolerance = 1e-11 }
      or fabric.dynamic { model = m, duration = 4e-3, scheme = scheme, step = scheme == "implicit" and 1e-4 or 4e-6, tolerance = scheme == "implicit" and 1e-11 or nil }
    run:solve()
    local corner, side = run:node(common.nearest(mesh, 0, b / 2)), run:node(common.nearest(mesh, a / 4, b / 2))
    local _, _, z = run:reaction "right"
    return { corner.z, side.z, side.x, run.energy.stored, part == "quarter" and 2 * z or z }, run.energy.stored
  end
  for _, scheme in ipairs { "static", "implicit", "explicit" } do
    local whole = hung("whole", scheme)
    if scheme == "static" then checks("each of two supports carries half of the weight", whole[5], card.density * card.thickness * a * b * 9.81 / 2, { relative = 1e-8 }) end
    for _, part in ipairs { "half", "quarter" } do
      local got = hung(part, scheme)
      got[4] = got[4] * (part == "half" and 2 or 4)
      for i, name in ipairs { "middle", "place", "along", "stored", "support" } do
        checks(("%s against the whole, %s: %s"):format(part, scheme, name), got[i], whole[i], { relative = 1e-6 })
      end
    end
  end
end
checks()
