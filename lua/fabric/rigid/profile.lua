-- Tools of L and Z profiles: sections of the plane of x and z, extruded along y, whose wall leans by an angle from the horizontal.
--
--       L:  | punch |          Z:  _______________       x = 0: the sharp corner of the die's face and its wall,
--     ____  |_______|              |     punch    |             or of the punch's lower face and its wall
--     holder ,                     |____.         |
--     ------. ========  ply            _|_________|
--      die   \                     ----. ========  ply
--             |                    die  \_________
local loft = require "fabric.rigid.loft"
local profile = {}

local quarter = 8 -- facets of a right angle of a rounded corner

-- How far the flat sides of a corner end from its sharp place: it has the inner angle and the radius r.
local function taken(r, inner) return r / math.tan(inner / 2) end

-- {x, z, r} of the section's corners, clockwise as seen from -y, so that loft closes it from -y to y with facets that look outwards.
local function rounded(corners)
  local out = {}
  for i, c in ipairs(corners) do
    local a, b, r = corners[(i - 2) % #corners + 1], corners[i % #corners + 1], c[3]
    if not r then
      out[#out + 1] = { c[1], c[2] }
    else
      local ux, uz, vx, vz = a[1] - c[1], a[2] - c[2], b[1] - c[1], b[2] - c[2]
      local u, v = math.sqrt(ux ^ 2 + uz ^ 2), math.sqrt(vx ^ 2 + vz ^ 2)
      ux, uz, vx, vz = ux / u, uz / u, vx / v, vz / v
      local inner = math.acos(ux * vx + uz * vz)
      local back = taken(r, inner)
      local n, turn = math.max(2, math.ceil(quarter * (math.pi - inner) / (math.pi / 2) - 1e-9)), math.pi - inner
      -- From the end of one side over the arc to the begin of the other, whose middle is on the bisector.
      local along, mx, mz = r / math.sin(inner / 2), (ux + vx) / (2 * math.cos(inner / 2)), (uz + vz) / (2 * math.cos(inner / 2))
      local cx, cz = c[1] + along * mx, c[2] + along * mz
      local px, pz = c[1] + back * ux - cx, c[2] + back * uz - cz
      local side = pz * ux - px * uz > 0 and 1 or -1 -- the arc starts along the first side, towards the corner
      for k = 0, n do
        local w = side * turn * k / n
        out[#out + 1] = { cx + px * math.cos(w) - pz * math.sin(w), cz + px * math.sin(w) + pz * math.cos(w) }
      end
    end
  end
  return out
end

-- The prism of a section, from y = -length/2 to length/2; `inside`: a place that sees all of the section.
local function prism(at, corners, length, inside)
  local section, rings = rounded(corners), {}
  for k, y in ipairs { -length / 2, length / 2 } do
    rings[k] = {}
    for i, p in ipairs(section) do rings[k][i] = { at[1] + p[1], at[2] + y, at[3] + p[2] } end
  end
  local function cap(y) return { at[1] + inside[1], at[2] + y, at[3] + inside[2] } end
  return loft.mesh(cap(-length / 2), rings, cap(length / 2))
end

-- Widths along x that the round corners of a punch need.
function profile.least_width(t) return taken(t.edge, math.pi - math.rad(t.angle)) + t.edge end

function profile.punch(t, at)
  local w, y, h, back = t.size[1], t.size[2], t.height, 2 * t.edge
  local lean = h / math.tan(math.rad(t.angle))
  if t.shape == "L" then
    return prism(at, { { 0, 0, t.edge }, { -lean, h }, { w, h }, { w, 0, t.edge } }, y, { w / 2, h / 2 })
  end
  return prism(at, { { 0, 0, t.edge }, { -lean, h }, { -lean - w, h, t.edge }, { -lean - w, h + back }, { w, h + back }, { w, 0, t.edge } }, y, { w / 2, h + back / 2 })
end

function profile.die(t, at)
  local w, y, h, back = t.size[1], t.size[2], t.height, 4 * t.edge
  local cot = 1 / math.tan(math.rad(t.angle))
  if t.facing == "down" then
    return prism(at, { { 0, 0, t.edge }, { -t.outer, 0, t.edge }, { -t.outer, back }, { -cot * back, back } }, y, { -t.outer / 2, back / 2 })
  elseif t.shape == "L" then
    return prism(at, { { 0, 0, t.edge }, { cot * h, -h }, { -t.outer, -h }, { -t.outer, 0 } }, y, { -t.outer / 2, -h / 2 })
  end
  local floor = h + back
  return prism(at, { { 0, 0, t.edge }, { cot * h, -h }, { cot * h + w, -h }, { cot * h + w, -floor }, { -t.outer, -floor }, { -t.outer, 0 } }, y, { -t.outer / 2, -h - back / 2 })
end

return profile
