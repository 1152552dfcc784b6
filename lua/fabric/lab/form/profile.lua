-- The part of fabric.lab.form for tools of an L or a Z profile.
--
-- The sharp corner of the die's face and wall lies at x = 0. The punch moves along z alone, so that its wall, which leans as that of the die,
-- reaches the gap between both at the end of the stroke.
local define = require "fabric.define"
local profile = {}

local function fail(field, words) define.fail(("form: field '%s': %s"):format(field, words)) end

-- Both tools are of one profile, whose angle and length are one.
function profile.check_pair(t)
  local punch, die = t.punch, t.die
  if punch.shape ~= die.shape then fail("die.shape", ("expected that of the punch, '%s', got '%s'"):format(punch.shape, die.shape)) end
  for _, name in ipairs { "angle", "size", "height" } do
    if die[name] then fail("die." .. name, ("of an %s profile it is that of the punch: expected none"):format(punch.shape)) end
  end
  if punch.shape == "Z" and t.holder then fail("holder", "the upper face of a Z punch presses where a holder would be: expected none") end
end

function profile.complete(t, gap)
  local punch, die = t.punch, t.die
  punch.angle = punch.angle or 90
  punch.height = punch.height or punch.size[1]
  die.angle, die.size, die.gap = punch.angle, punch.size, die.gap or gap
  die.height = punch.shape == "Z" and punch.height or math.max(t.stroke + 4 * die.edge, punch.height)
end

-- Between the corners of the walls along x, at the end of the stroke: walls that are `gap` apart, with the punch `over` above the die's face.
local function apart(t, gap, over)
  local angle = math.rad(t.punch.angle)
  return (gap - over * math.cos(angle)) / math.sin(angle)
end

function profile.check(t, plies, width, height)
  if t.die.gap < plies then
    fail("die.gap", ("the nip of punch and die is thinner than the plies: expected at least %.4g m, got %.4g"):format(plies, t.die.gap))
  end
  if height >= t.punch.size[2] then
    fail("punch.size", ("the blank is longer than the profile along y: expected more than {..., %.4g} m, got {..., %.4g}"):format(height, t.punch.size[2]))
  end
  local reach = apart(t, t.die.gap, plies - t.stroke) + t.punch.size[1] - t.punch.edge
  if width / 2 > reach then
    fail("punch.size", ("it does not cover the half of the blank that it presses: expected at least {%.4g, ...} m, got {%.4g, ...}"):format(t.punch.size[1] + width / 2 - reach, t.punch.size[1]))
  end
end

-- Places along x of the corners in contact, which begins off from the surface of the cloth.
function profile.die_place(t, off) return -off * math.tan(math.rad(t.die.angle) / 2) end
function profile.punch_place(t, off, top) return apart(t, t.die.gap + 2 * off, top + t.contact - t.stroke) end

-- The holder ends where the die's edge begins.
function profile.holder_place(t) return -t.die.edge * math.tan(math.rad(t.die.angle) / 2) end

function profile.flat(t)
  local ends = profile.holder_place(t)
  return function(p) return p.x < ends end
end

return profile
