-- fabric.lab.picture_frame and bias_shear: shear force per width from the two tests of the benchmark, and the reverse [cao2008].
local fabric = require "fabric"
local define = require "fabric.define"
local checks = require "fabric.lab.common.check"
local lists = require "fabric.lists"
local soft_yarns = require "fabric.lab.card.soft_yarns"

local quarter = math.pi / 4

-- Shear angle (rad) of a hinged square of side l whose diagonal has increased by d.
local function angle_of(l, d) return math.pi / 2 - 2 * math.acos(1 / math.sqrt(2) + d / (2 * l)) end

-- Checks lists of equal length, and displacements below the geometric limit, where the angle is 90 degrees.
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

-- Converts the force N per width along the sides to S12 over E12. The sides rotate: the work per area of cloth is N cos(gamma)
-- dgamma, and with 2 E12 = sin(gamma) it is also S12 t cos(gamma) dgamma.
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

-- Force over displacement of the frame, as predicted by a card.
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

define {
  name = "fabric.lab.picture_frame",
  arguments = lists.joined({
    { name = "displacement", kind = "numbers", unit = "m", sentence = "of the crosshead along the diagonal" },
    { name = "force", kind = "numbers", unit = "N", optional = true, sentence = "less that of the empty frame" },
    { name = "card", of = "card", optional = true, sentence = "instead of the force: what the frame would show" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "of the cloth; default: the card's" },
  }, sides),
  sentence = "Picture frame: angle (degrees), normal_force (N/m, normalised by frame / cloth^2), E12, S12 from force and displacement; or force from a "
    .. "card.",
  example = "local d, card = { 0.01, 0.02, 0.03 }, fabric.card 'blend'\n"
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

-- Value at x of the curve through 0 and the known points, in the form a + b y, where the point (last, y) is still to be found:
-- beyond the known points it is interpolated towards that one.
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

-- Angle of the middle zone for inextensible yarns.
local function bias_angle(t, d)
  if d == 0 then return 0 end -- exactly zero, without rounding error
  return math.pi / 2 - 2 * math.acos((t.length - t.width + d) / (math.sqrt(2) * (t.length - t.width)))
end

-- A decrease by more than this share of the largest displacement is a reversal; a smaller one is noise.
local turned = 0.01

-- The rows of the curve: those that exceed the largest displacement so far, up to a reversal. With cut=true the record ends at a
-- reversal or where the angle exceeds the limit; otherwise a reversal is an error.
local function rising(t)
  local rows, largest, high = {}, -math.huge, 0
  for _, d in ipairs(t.displacement) do high = math.max(high, d) end
  for i, d in ipairs(t.displacement) do
    if largest - d > turned * high then
      if t.cut then break end
      define.fail(("bias_shear: field 'displacement': expected rising values, got %g m at place %d after %g: end the record at the reversal, or give cut=true")
        :format(d, i, largest))
    end
    if t.cut and d > 0 and (d >= (math.sqrt(2) - 1) * (t.length - t.width) or bias_angle(t, d) > math.rad(t.limit)) then break end
    if d > largest and d >= 0 then rows[#rows + 1] = i end
    largest = math.max(largest, d)
  end
  return rows
end

-- Refuses a force of the wrong sign, or none, in the rows that count.
local function check_pull(what, field, t) checks.pull(what, field, t.force, rising(t)) end

-- Below zero by no more than a reversal's noise: where the specimen stood before the pull.
local function check_below_zero(t)
  local high = 0
  for _, d in ipairs(t.displacement) do high = math.max(high, d) end
  for i, d in ipairs(t.displacement) do
    if d < -turned * high then
      define.fail(("bias_shear: field 'displacement': expected numbers of at least 0 in m (noise of %g %% of the largest apart), got %g at place %d"):format(
        100 * turned, d, i))
    end
  end
end

-- A shear force below zero by more than this share of the largest is impossible for cloth.
local negative = 0.01

local function check_sign(t, out)
  local largest = 0
  for _, N in ipairs(out.normal_force) do largest = math.max(largest, math.abs(N)) end
  for i, N in ipairs(out.normal_force) do
    local row = out.rows[i]
    if N < -negative * largest and t.force[row] > 0 then
      define.fail(("bias_shear: the shear force turns negative at place %d (%g mm, %g N, %.1f degrees: %.3g N/m): yarns that do not stretch can't have sheared "
        .. "so far; give cut=true to end the record at %g degrees"):format(row, t.displacement[row] * 1e3, t.force[row], out.angle[i], N, t.limit))
    end
  end
end

-- Marks the rows within the limit, and describes the others.
local function mark_valid(t, out)
  local beyond = 0
  out.valid = {}
  for i, angle in ipairs(out.angle) do
    out.valid[i] = angle <= t.limit
    if not out.valid[i] then beyond = beyond + 1 end
  end
  if beyond > 0 then
    fabric.warn(("bias_shear: %d of %d rows are beyond %g degrees (up to %.1f), where yarns slip and stretch, and the shear is less than the displacement says: "
      .. "they are marked in `valid`; cut=true leaves them out"):format(beyond, #out.angle, t.limit, out.angle[#out.angle]))
  end
  return out
end

-- The work of the grips is done in the middle zone at gamma and in the mixed zones at gamma/2 [cao2008].
local function bias_curve(t)
  local out = { radians = {}, normal_force = {}, rows = rising(t) }
  local w, h = t.width, t.length
  for i, row in ipairs(out.rows) do
    local gamma = bias_angle(t, t.displacement[row])
    local known, share = between(out.radians, out.normal_force, gamma / 2, gamma)
    local pull, mixed = (h / w - 1) * t.force[row] * (math.cos(gamma / 2) - math.sin(gamma / 2)), w * math.cos(gamma / 2)
    out.normal_force[i] = (pull - mixed * known) / ((2 * h - 3 * w) * math.cos(gamma) + mixed * share)
    out.radians[i] = gamma
  end
  stress(out, t.thickness)
  check_sign(t, out)
  return mark_valid(t, out)
end

-- Shear stress of a card in virgin loading at several strains E12 >= 0, in any order.
local function virgin_shear(card, strains)
  local sorted, out = table.move(strains, 1, #strains, 1, {}), {}
  table.sort(sorted)
  local stress_of = {}
  for i, S in ipairs(fabric.point(card):path({ E12 = sorted }, { "S12" }).S12) do stress_of[sorted[i]] = S end
  for i, E in ipairs(strains) do out[i] = stress_of[E] end
  return out
end

-- Force over displacement of the grips for a specimen, as predicted by a card with the same kinematics.
local function bias_force(t)
  local w, h, thickness = t.width, t.length, t.thickness or t.card.thickness
  local whole, half, gammas = {}, {}, {}
  for i, d in ipairs(t.displacement) do
    gammas[i] = bias_angle(t, math.max(0, d))
    whole[i], half[i] = math.sin(gammas[i]) / 2, math.sin(gammas[i] / 2) / 2
  end
  local S, S_half = virgin_shear(t.card, whole), virgin_shear(t.card, half)
  local out = { force = {}, displacement = t.displacement, angle = {}, valid = {} }
  for i, gamma in ipairs(gammas) do
    local work = (2 * h - 3 * w) * math.cos(gamma) * S[i] + w * math.cos(gamma / 2) * S_half[i]
    out.force[i] = work * thickness / ((h / w - 1) * (math.cos(gamma / 2) - math.sin(gamma / 2)))
    out.angle[i] = math.deg(gamma)
    out.valid[i] = out.angle[i] <= t.limit
  end
  return out
end

define {
  name = "fabric.lab.bias_shear",
  arguments = {
    { name = "displacement", kind = "numbers", unit = "m",
      sentence = "of the crosshead, rising, from 0 (less by 1 % of the largest at most, as noise); rows that do not pass the largest so far are left out, a way back by more than 1 % of the largest is an error" },
    { name = "force", kind = "numbers", unit = "N", optional = true, sentence = "of one length with it" },
    { name = "card", of = "card", optional = true, sentence = "instead of the force: what the pull would show by the same kinematics" },
    { name = "width", kind = "number", unit = "m", above = 0, sentence = "of the specimen" },
    { name = "length", kind = "number", unit = "m", above = 0, sentence = "between the grips, at least twice the width" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "of the cloth; default: the card's" },
    { name = "warp", kind = "table", optional = true, sentence = "{loading=, poisson?, tested?} of yarns that stretch, a result of fabric.lab.fit or of a card: their stretch is taken out; with weft" },
    { name = "weft", kind = "table", optional = true, sentence = "likewise" },
    { name = "limit", kind = "number", unit = "degrees", above = 0, high = 90, default = 30, sentence = "angle up to which yarns are believed not to slip or stretch" },
    { name = "cut", kind = "boolean", default = false, sentence = "the record ends at the limit and at a reversal" },
  },
  sentence = "Bias extension without markers, for yarns that do not stretch, or whose stretch warp and weft take out (by simulated pulls; `taken_out`: the share by which the last S12 rises): angle (degrees) of the middle zone, normal_force (N/m), E12, S12, valid "
    .. "(true up to the limit), rows (places in the record); or the force that a card gives. An error where the shear force turns negative.",
  example = "local r = require 'fabric'.lab.bias_shear{ displacement={0.01, 0.02}, force={1, 1.5}, width=0.1, length=0.3, thickness=1e-3 }\n"
    .. "assert(r.angle[2] > r.angle[1] and r.S12[1] > 0)",
  run = function(t)
    if t.length < 2 * t.width then define.fail "bias_shear: field 'length': expected at least twice the width (else there is no middle zone)" end
    if (t.card == nil) == (t.force == nil) then define.fail "bias_shear: field 'force': expected either force or card" end
    if t.force and not t.thickness then define.fail "bias_shear: field 'thickness': expected a positive number in m, got nil" end
    checks.lengths("bias_shear", t)
    check_below_zero(t)
    if t.card then
      check("bias_shear", t, (math.sqrt(2) - 1) * (t.length - t.width))
      return bias_force(t)
    end
    check("bias_shear", t, t.cut and math.huge or (math.sqrt(2) - 1) * (t.length - t.width))
    check_pull("bias_shear", "force", t)
    return soft_yarns(t, bias_curve(t))
  end,
}

return { bias_angle = bias_angle, check_pull = check_pull }
