-- Thin triangles bend: clamped and supported plates, orthotropic cloth of its own bending, a pinched tube, a strip in torsion, layers, on meshes of
-- triangles cut one way, both ways and of a panel's own. Errors are held beside those of the quadrilaterals that were cut.
local fabric = require "fabric"
local mm, MPa = fabric.units.mm, fabric.units.MPa
local checks = {}

-- Each quadrilateral in two, along one diagonal or along both in turn.
local function cut(mesh, how)
  if how == "whole" then return mesh end
  local nodes, elements = {}, {}
  for i = 1, #mesh.nodes do nodes[i] = mesh.nodes[i] end
  for i = 1, #mesh.elements do
    local e = mesh.elements[i]
    if how == "one way" or i % 2 == 0 then
      elements[#elements + 1] = { e[1], e[2], e[3] }
      elements[#elements + 1] = { e[1], e[3], e[4] }
    else
      elements[#elements + 1] = { e[1], e[2], e[4] }
      elements[#elements + 1] = { e[2], e[3], e[4] }
    end
  end
  return fabric.mesh.of { nodes = nodes, elements = elements }
end

-- Bending of its own has no coupling of the curvatures, and is the same in all directions with half of the rigidity for the twist.
local function isotropic(E, nu, t, own)
  local D = E * t ^ 3 / 12 / (1 - nu ^ 2)
  local fields = { warp = E, weft = E, shear = E / 2 / (1 + nu), poisson = { nu, nu }, density = 700, thickness = t }
  if own then fields.bending = { warp = D, weft = D, twist = D / 2 } else fields.through_thickness = true end
  return fabric.linear(fields), D
end

-- Deflection of the middle under a pressure so small that the sheet does not stretch.
local function middle(mesh, card, q, hold, layers)
  local m = fabric.model { mesh = mesh, card = card, layers = layers, warp = 0 }
  hold(m)
  m:pressure(fabric.ramp(q, 1))
  local a, most = fabric.static { model = m, duration = 1, step = 1 }:solve(), 0
  for _, z in ipairs(a:field "uz") do most = math.max(most, math.abs(z)) end
  return most
end
local function clamped(m) m:fix("boundary", "x y z rotation") end

-- Clamped circles of R/t = 60 and 600: at most one and a half times the error of the quadrilaterals, and one per cent.
for _, ratio in ipairs { 60, 600 } do
  for _, own in ipairs { false, true } do
    local R, nu, E = 80 * mm, 0.2, 300 * MPa
    local card, D = isotropic(E, nu, R / ratio, own)
    local q = 1e-4 * R / ratio * 64 * D / R ^ 4
    for _, how in ipairs { "one way", "both ways" } do
      local got = middle(cut(fabric.mesh.disk { radius = R, cells = 10 }, how), card, q, clamped)
      checks[#checks + 1] = { ("clamped circle, R/t = %d, %s bending, cut %s"):format(ratio, own and "own" or "solid", how), got, q * R ^ 4 / (64 * D), relative = 0.015 }
    end
  end
end

-- A circle of equilateral triangles, as a panel has them.
do
  local R, nu = 60 * mm, 0.3
  local card, D = isotropic(500 * MPa, nu, 0.2 * mm)
  local mesh = fabric.mesh.panel { outline = { { circle = { 0, 0 }, radius = R } }, size = R / 9, triangles = true }
  local q = 1e-4 * 0.2 * mm * 64 * D / R ^ 4
  checks[#checks + 1] = { "clamped circle of a panel", middle(mesh, card, q, clamped), q * R ^ 4 / (64 * D), relative = 0.02 }
end

-- Cloth ten times as stiff along the weft: against quadrilaterals on a fine mesh.
do
  local a, b = 90 * mm, 70 * mm
  local card = fabric.linear { warp = 40 * MPa, weft = 300 * MPa, shear = 3 * MPa, poisson = { 0.02, 0.15 }, density = 500, thickness = 0.5 * mm, bending = { warp = 6e-6, weft = 60e-6, twist = 5e-6 } }
  local function sheet(n) return fabric.mesh.rectangle { width = a, height = b, nx = 9 * n, ny = 7 * n } end
  local want = middle(sheet(4), card, 1e-5, clamped)
  for _, how in ipairs { "one way", "both ways" } do
    checks[#checks + 1] = { "stiff weft, clamped, cut " .. how, middle(cut(sheet(2), how), card, 1e-5, clamped), want, relative = 0.02 }
  end
end

-- Two unlike layers, and one whose reference surface is its lower face, bend about their neutral surface.
do
  local R, t = 50 * mm, 0.3 * mm
  local soft, stiff = isotropic(100 * MPa, 0.3, t), isotropic(400 * MPa, 0.3, t)
  -- B = int E' z^2 about the neutral surface, E' = E / (1 - nu^2): of two layers of thickness t, moduli E and 4 E.
  local E, f = 100 * MPa / (1 - 0.09), 1 + 4
  local z0 = (0.5 * 1 + 1.5 * 4) / f * t
  local B = E * (t ^ 3 * f / 12 + t * (0.5 * t - z0) ^ 2 + 4 * t * (1.5 * t - z0) ^ 2)
  local q = 1e-5 * t * 64 * B / R ^ 4
  local mesh = cut(fabric.mesh.disk { radius = R, cells = 8 }, "one way")
  mesh:set("pin", function(x, y) return x ^ 2 + y ^ 2 < 1e-12 end):set("hand", function(x, y) return x > 0.999 * R end)
  local got = middle(mesh, nil, q, function(m) m:fix("boundary", "z rotation"):fix("pin", "x y"):fix("hand", "y") end, { { card = soft }, { card = stiff } })
  checks[#checks + 1] = { "two layers", got, q * R ^ 4 / (64 * B), relative = 0.03 }
end

-- Torsion of a strip by ends that are moved across the sheet: E / (2 (1 + nu)) t^3 / 3 b (1 - 0.63 t / b) per twist. Linear directors had the shape already; the
-- parabolas must not soften its free edges.
do
  local L, b, t, nu = 120 * mm, 15 * mm, 0.6 * mm, 0.25
  local card = isotropic(800 * MPa, nu, t)
  local mesh = cut(fabric.mesh.rectangle { width = L, height = b, nx = 16, ny = 4, origin = { 0, -b / 2 } }, "one way")
  mesh:set("left", function(x) return x < 1e-9 end)
  local rate = math.rad(0.5) / L -- without stretching
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("left", "x y z")
  for i = 1, #mesh.nodes do
    local x, y = mesh.nodes[i][1], mesh.nodes[i][2]
    if x > L - 1e-9 then
      mesh:set("end " .. i, { i })
      m:move("end " .. i, { z = fabric.ramp(rate * L * y, 1) })
    end
  end
  local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local stiff = 800 * MPa / (2 * (1 + nu)) * b * t ^ 3 / 3 * (1 - 0.63 * t / b)
  checks[#checks + 1] = { "torsion of a strip", a.energy.stored, stiff * rate ^ 2 * L / 2, relative = 0.03 }
end

-- A supported square bends as the pressure on the arcs of its edges wants it, and that pressure's work is in the ledger: of a linear plate half of the
-- final force times the way; in motion to the error of the step. 0.00406 q a^4 / D, nu = 0.3.
do
  local a, nu, t = 100 * mm, 0.3, 0.2 * mm
  local card, D = isotropic(400 * MPa, nu, t)
  local q = 1e-4 * t / (0.00406235 * a ^ 4 / D)
  local function plate()
    local mesh = cut(fabric.mesh.rectangle { width = a, height = a, nx = 8, ny = 8 }, "one way")
    mesh:set("pin", { 1 }):set("guide", { 9 })
    local m = fabric.model { mesh = mesh, card = card, warp = 0 }
    m:fix("boundary", "z"):fix("pin", "x y"):fix("guide", "y")
    return m, 41
  end
  local m, middle_node = plate()
  m:pressure(fabric.ramp(q, 1))
  local s = fabric.static { model = m, duration = 1, step = 1 }:solve()
  checks[#checks + 1] = { "supported square: middle", s:node(middle_node).uz, 1e-4 * t, relative = 0.008 }
  checks[#checks + 1] = { "supported square: work over energy", s.energy.external / s.energy.stored, 1, absolute = 1e-6 }
  for _, scheme in ipairs { "implicit", "explicit" } do
    local moving = plate()
    moving:pressure(fabric.ramp(q, 5e-3))
    local d = fabric.dynamic { model = moving, duration = 1e-2, scheme = scheme, step = scheme == "implicit" and 1e-4 or nil }:solve()
    checks[#checks + 1] = { "supported square, " .. scheme .. ": error of the ledger", d.energy.error, 0, absolute = scheme == "implicit" and 1e-9 or 1e-6 }
  end
end
fabric.expect(checks)
