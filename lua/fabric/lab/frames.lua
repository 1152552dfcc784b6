-- fabric.lab.picture_frame and bias_shear: shear per width from the two tests of the benchmark, and back [cao2008].
local fabric = require "fabric"
local define = require "fabric.define"

local quarter = math.pi / 4

-- Shear angle of a hinged square of side l whose diagonal has grown by d (radians).
local function angle_of(l, d) return math.pi / 2 - 2 * math.acos(1 / math.sqrt(2) + d / (2 * l)) end

-- Lists of one length, and displacements below the largest that the geometry has, where the angle would be 90 degrees.
local function check(what, t, most)
  if t.force and #t.force ~= #t.displacement then
    define.fail(("%s: field 'force': expected %d numbers, one per displacement, got %d"):format(what, #t.displacement, #t.force))
  end
  for i, d in ipairs(t.displacement) do
    if d >= most then
      define.fail(("%s: field 'displacement': expected less than %.4g m, where the yarns lie along the pull, got %g at place %d; is it in m?"):format(
        what, most, d, i))
    end
  end
end

-- From the force N along the sides, per width, to S12 over E12. The sides turn: the work per area of cloth is N cos(gamma) dgamma,
-- and with 2 E12 = sin(gamma) it is also S12 t cos(gamma) dgamma.
local function stress(out, thickness)
  out.E12, out.S12 = {}, {}
  for i, gamma in ipairs(out.radians) do
    out.E12[i] = math.sin(gamma) / 2
    out.S12[i] = out.normal_force[i] / thickness
  end
  out.angle = {}
  for i, gamma in ipairs(out.radians) do out.angle[i] = math.deg(gamma) end
  out.radians = nil
  return out
end

local function frame_curve(t)
  local out = { radians = {}, normal_force = {} }
  for i, d in ipairs(t.displacement) do
    local gamma = angle_of(t.frame, d)
    out.radians[i] = gamma
    out.normal_force[i] = t.force[i] / (2 * math.cos(quarter - gamma / 2)) * t.frame / t.cloth ^ 2
  end
  return stress(out, t.thickness)
end

-- The frame's force over its displacement that a card gives.
local function frame_force(t)
  local strains, out = {}, { force = {}, displacement = t.displacement }
  for i, d in ipairs(t.displacement) do strains[i] = math.sin(angle_of(t.frame, d)) / 2 end
  local S12 = fabric.point(t.card):path({ E12 = strains }, { "S12" }).S12
  for i, d in ipairs(t.displacement) do
    local gamma = angle_of(t.frame, d)
    local per_width = S12[i] * (t.thickness or t.card.thickness)
    out.force[i] = per_width * t.cloth ^ 2 / t.frame * 2 * math.cos(quarter - gamma / 2)
  end
  return out
end

local sides = {
  { name = "frame", kind = "number", unit = "m", above = 0, sentence = "side of the frame, between hinges" },
  { name = "cloth", kind = "number", unit = "m", above = 0, sentence = "side of the cloth without its arms" },
}

local function rows(...)
  local out = {}
  for _, list in ipairs { ... } do table.move(list, 1, #list, #out + 1, out) end
  return out
end

define {
  name = "fabric.lab.picture_frame",
  arguments = rows({
    { name = "displacement", kind = "numbers", unit = "m", sentence = "of the crosshead along the diagonal" },
    { name = "force", kind = "numbers", unit = "N", optional = true, sentence = "less that of the empty frame" },
    { name = "card", of = "card", optional = true, sentence = "instead of the force: what the frame would show" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "of the cloth; default: the card's" },
  }, sides),
  sentence = "Picture frame: angle (degrees), normal_force (N/m, normalised by frame / cloth^2), E12, S12 from force and displacement; or force from a "
    .. "card.",
  example = "local fabric = require 'fabric'\nlocal d, card = { 0.01, 0.02, 0.03 }, fabric.card 'blend'\n"
    .. "local made = fabric.lab.picture_frame{ displacement=d, card=card, frame=0.2, cloth=0.15 }\n"
    .. "local r = fabric.lab.picture_frame{ displacement=d, force=made.force, thickness=card.thickness, frame=0.2, cloth=0.15 }\n"
    .. "local s = fabric.point(card):path({ E12=r.E12 }, {'S12'}).S12[3]\nassert(math.abs(r.S12[3] - s) < 1e-9 * s)",
  run = function(t)
    if (t.card == nil) == (t.force == nil) then define.fail "picture_frame: field 'force': expected either force or card" end
    check("picture_frame", t, (2 - math.sqrt(2)) * t.frame)
    if t.card then return frame_force(t) end
    if not t.thickness then define.fail "picture_frame: field 'thickness': expected a positive number in m, got nil" end
    return frame_curve(t)
  end,
}

-- Value at x of the curve through 0 and the points so far, as a + b y of the point (last, y) that is being found: beyond the known
-- points it is interpolated towards that one.
local function between(xs, ys, x, last)
  local before_x, before_y = 0, xs[1] == 0 and ys[1] or 0
  if last == 0 then return 0, 1 end
  for i, right in ipairs(xs) do
    if right >= x and right > before_x then return before_y + (ys[i] - before_y) * (x - before_x) / (right - before_x), 0 end
    before_x, before_y = right, ys[i]
  end
  local part = (x - before_x) / (last - before_x)
  return before_y * (1 - part), part
end

-- The middle zone at gamma and the mixed zones at gamma/2 share the work of the grips [cao2008].
local function bias_curve(t)
  local out = { radians = {}, normal_force = {} }
  local w, h = t.width, t.length
  for i, d in ipairs(t.displacement) do
    local gamma = math.pi / 2 - 2 * math.acos((h - w + d) / (math.sqrt(2) * (h - w)))
    if d == 0 then gamma = 0 end -- not the last digit of pi
    local known, share = between(out.radians, out.normal_force, gamma / 2, gamma)
    local pull, mixed = (h / w - 1) * t.force[i] * (math.cos(gamma / 2) - math.sin(gamma / 2)), w * math.cos(gamma / 2)
    out.normal_force[i] = (pull - mixed * known) / ((2 * h - 3 * w) * math.cos(gamma) + mixed * share)
    out.radians[i] = gamma
  end
  return stress(out, t.thickness)
end

define {
  name = "fabric.lab.bias_shear",
  arguments = {
    { name = "displacement", kind = "numbers", unit = "m", low = 0, sentence = "of the crosshead, rising" },
    { name = "force", kind = "numbers", unit = "N", sentence = "of one length with it" },
    { name = "width", kind = "number", unit = "m", above = 0, sentence = "of the specimen" },
    { name = "length", kind = "number", unit = "m", above = 0, sentence = "between the grips, at least twice the width" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "of the cloth" },
  },
  sentence = "Bias extension without markers, yarns taken not to stretch: angle (degrees) of the middle zone, normal_force (N/m), E12, S12.",
  example = "local r = require 'fabric'.lab.bias_shear{ displacement={0.01, 0.02}, force={1, 1.5}, width=0.1, length=0.3, thickness=1e-3 }\n"
    .. "assert(r.angle[2] > r.angle[1] and r.S12[1] > 0)",
  run = function(t)
    if t.length < 2 * t.width then define.fail "bias_shear: field 'length': expected at least twice the width (else there is no middle zone)" end
    check("bias_shear", t, (math.sqrt(2) - 1) * (t.length - t.width))
    return bias_curve(t)
  end,
}
