-- A compression sleeve on a round limb: the limb swells into the tube, as a leg that the sleeve was stretched over comes back to its size. A tube of
-- the tension T (force per length) presses with p = T/R on a cylinder of the radius R, and with p = T cos(a)/R on a cone whose surface is at the angle a to
-- its axis, where friction holds it. T is that of the stretch: an elastic knit of the stiffness E t, without contraction across.
--
--   fabricsh compression.lua long      elements of half the size
local fabric, form = require "fabric", arg[1] or "short"
local mm = fabric.units.mm
local fine = form == "long" and 2 or 1
local E, thickness = 1.2e6, 0.6 * mm
local card = fabric.svk { name = "elastic knit", young = E, poisson = 0, density = 500, thickness = thickness, bending = { warp = 5e-6, weft = 5e-6, twist = 3e-6 } }
local length, ease, grown = 0.07, 1 * mm, 0.025 -- of the sleeve; between sleeve and limb at first; time until the limb has its size

-- The sleeve is cut to be tighter than the limb by a share of every girth: its panel is that of a cone of the same angle, smaller all over. On the limb a ring of it is
-- stretched by the same ratio everywhere.
local function worn(R, angle, tight)
  local slope = math.tan(math.rad(angle))
  local n = 28 * fine
  local along = math.max(6, math.floor(length / (2 * math.pi * R / n) + 0.5))
  local function girth(z) return (R + slope * z) / (1 + tight) end
  local mesh = fabric.mesh.rectangle { width = 1, height = length, nx = n, ny = along }
  mesh:map(function(x, z)
    local phi, r = 2 * math.pi * x, girth(z)
    return r * math.sin(phi), -r * math.cos(phi), z
  end)
  local m = fabric.model { mesh = mesh, card = card, warp = { 0, 0, 1 }, points = 1 }
  -- Its two edges lie on each other, and are one from the start.
  m:seam { "left", "right" }
  local function limb(share) -- from slim to its full size
    local function radius(z) return (1 - share) * (girth(z) - ease) + share * (R + slope * z) end
    local over = 0.2 * length
    local _, shape = fabric.rigid.torso { sections = { { -over, radius(-over), radius(-over) }, { length + over, radius(length + over), radius(length + over) } }, around = n, size = length / along }
    return shape
  end
  local body = fabric.rigid.motion { meshes = { limb(0), limb(1) }, times = { 0, grown }, closed = true, name = "limb" }
  -- Stiff enough for the pressure to stay well above the smallest distance.
  m:contact { between = { body, "all" }, friction = 0.5, stiffness = 4e7 * fine ^ 2 }
  local a = fabric.dynamic { model = m, duration = 1.5 * grown, damping = { mass = 1000 } }
  a:solve()
  -- Means over the middle half, of the pressure per area as it is, and of what T makes of the stretch as it is.
  local p, got, want, most, count = a:field "contact_pressure", 0, 0, 0, 0
  for k = 0, along do
    local z, r, press = 0, 0, 0
    for i = 1, n do
      local at = a:node(k * (n + 1) + i)
      z, r, press = z + at.z / n, r + math.sqrt(at.x ^ 2 + at.y ^ 2) / n, press + p[k * (n + 1) + i] / n
    end
    if z > length / 4 and z < 3 * length / 4 then
      local stretch = r / girth(length * k / along)
      local T = E * thickness * stretch * (stretch ^ 2 - 1) / 2
      local closed = T * math.cos(math.rad(angle)) / r
      got, want, most, count = got + press / stretch, want + closed, math.max(most, math.abs(press / stretch / closed - 1)), count + 1
    end
  end
  print(("%s, %.0f to %.0f mm: %.0f Pa (%.1f mmHg), closed form %.0f Pa, rings differ by up to %.2f %%; ledger %.1e"):format(
    angle == 0 and "cylinder" or ("cone of %g degrees"):format(angle), R / mm, (R + slope * length) / mm, got / count, got / count / 133.322, want / count, 100 * most, a.energy.error))
  return got / count, want / count, most, a
end

local checks = {}
local function check(name, ...)
  local got, want, most, a = worn(...)
  checks[#checks + 1] = { name .. ": mean pressure, Pa", got, want, relative = 0.01 }
  checks[#checks + 1] = { name .. ": largest difference of a ring", most, 0, absolute = 0.01 }
  checks[#checks + 1] = { name .. ": ledger", a.energy.error, 0, absolute = 1e-2 }
end
check("cylinder", 45 * mm, 0, 0.15)
check("cone", 38 * mm, 15, 0.15)
if fabric.checking() then return end
fabric.expect(checks)
