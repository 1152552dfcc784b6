-- fabric.rigid.limb: an arm, a leg or a finger, two tapered parts whose joint bends.
--
--        from                    upper                  lower
--         |                        |                      |
--    (----+------------------------+----------------------+--)      s, along the middle line: 0 .. upper .. upper + lower
--      radii[1]       | joint  radii[2] joint |        radii[3]
--
-- The middle line is straight but for a length `joint` about the joint, which is an arc of a circle of the angle bend/joint per length.
-- Cross-sections are circles at right angles to it, so that by Pappus' theorem bending changes neither area nor volume where the radius is constant.
local define = require "fabric.define"
local fabric = require "fabric"
local loft = require "fabric.rigid.loft"

local farthest = 150   -- degrees
local crowding = 0.95  -- largest curvature of the middle line times radius: from 1 on the cross-sections of the inner side meet
local most_shapes = 100000
local turn, most = 3, 5 -- degrees from shape to shape: by default at most, and the largest accepted

local function fail(field, words) define.fail(("limb: field '%s': %s"):format(field, words)) end

-- s of the rings, and the numbers of those at which the joint begins and ends.
local function stations(t)
  local begins, ends, all = t.upper - t.joint / 2, t.upper + t.joint / 2, {}
  local function part(from, to)
    local n = math.max(2, math.ceil((to - from) / t.size - 1e-9))
    for k = 0, n - 1 do all[#all + 1] = from + (to - from) * k / n end
    return #all + 1
  end
  local first = part(0, begins)
  local second = part(begins, ends)
  part(ends, t.upper + t.lower)
  all[#all + 1] = t.upper + t.lower
  return all, first, second
end

-- Linear in both parts; the slope changes evenly over the joint.
local function radius(t, s)
  local r, begins = t.radii, t.upper - t.joint / 2
  local m1, m2 = (r[2] - r[1]) / t.upper, (r[3] - r[2]) / t.lower
  if s >= t.upper + t.joint / 2 then return r[2] + m2 * (s - t.upper) end
  local inside = math.max(0, s - begins)
  return r[1] + m1 * s + (m2 - m1) * inside ^ 2 / (2 * t.joint)
end

-- The middle line at s where the joint is bent by `angle`, rad: place towards the bend and along the axis, and the direction's angle.
local function middle(t, angle, s)
  local begins = t.upper - t.joint / 2
  local inside, beyond = math.max(0, math.min(t.joint, s - begins)), math.max(0, s - begins - t.joint)
  local psi = angle * inside / t.joint
  -- A chord of an arc of the length l and the angle psi is l sin(psi/2)/(psi/2) long.
  local chord = psi == 0 and inside or inside * math.sin(psi / 2) / (psi / 2)
  return chord * math.sin(psi / 2) + beyond * math.sin(psi), math.min(s, begins) + chord * math.cos(psi / 2) + beyond * math.cos(psi), psi
end

local function shape(t, frame, rows, angle)
  local function point(s, out, r, phi) -- `out` along the middle line beyond s
    local a, c, psi = middle(t, angle, s)
    local aside = r * math.cos(phi)
    return loft.point(frame, a + out * math.sin(psi) + aside * math.cos(psi), r * math.sin(phi), c + out * math.cos(psi) - aside * math.sin(psi))
  end
  local rings = {}
  local function ring(s, out, r)
    local points = {}
    for i = 1, t.around do points[i] = point(s, out, r, 2 * math.pi * (i - 1) / t.around) end
    rings[#rings + 1] = points
  end
  local length, first, last = t.upper + t.lower, t.radii[1], t.radii[3]
  for k = 1, t.caps - 1 do
    local beta = math.pi / 2 * k / t.caps
    ring(0, -first * math.cos(beta), first * math.sin(beta))
  end
  for _, s in ipairs(rows) do ring(s, 0, radius(t, s)) end
  for k = t.caps - 1, 1, -1 do
    local beta = math.pi / 2 * k / t.caps
    ring(length, last * math.cos(beta), last * math.sin(beta))
  end
  return loft.mesh(point(0, -first, 0, 0), rings, point(length, last, 0, 0))
end

local function name_regions(t, mesh, rows, first, second)
  local n, k = t.around, t.caps - 1
  mesh:set("upper", loft.nodes(n, k + 1, k + first))
  mesh:set("joint", loft.nodes(n, k + first, k + second))
  mesh:set("lower", loft.nodes(n, k + second, k + #rows))
  mesh:set("joint_inner", loft.nodes(n, k + first, k + second, function(i) return math.cos(2 * math.pi * (i - 1) / n) > -1e-9 end))
  mesh:set("joint_outer", loft.nodes(n, k + first, k + second, function(i) return math.cos(2 * math.pi * (i - 1) / n) < 1e-9 end))
end

-- The angles, degrees, at equal times from 0 to the duration, by which neighbours differ by no more than `turn`, or as many as `every` makes.
local function angles(t)
  local function at(time)
    local bend = t.bend
    local value
    if type(bend) == "function" then value = bend(time) else value = bend:value(time) end
    if type(value) ~= "number" or value ~= value then fail("bend", ("expected a number of degrees at t = %g s, got %s"):format(time, tostring(value))) end
    return value
  end
  local function sampled(n)
    local all, times, largest = {}, {}, 0
    for k = 0, n do
      times[k + 1] = t.duration * k / n
      all[k + 1] = at(times[k + 1])
      largest = math.max(largest, k > 0 and math.abs(all[k + 1] - all[k]) or 0)
    end
    return all, times, largest
  end
  local n = t.every and math.max(1, math.ceil(t.duration / t.every - 1e-9)) or 16
  if n > most_shapes then fail("every", ("expected at most %d shapes, got %.10g s / %.10g s"):format(most_shapes, t.duration, t.every)) end
  local all, times, largest = sampled(n)
  while not t.every and largest > turn and n < 4096 do
    n = 2 * n
    all, times, largest = sampled(n)
  end
  if largest > most then
    fail(t.every and "every" or "bend", ("the joint turns by %.3g degrees within %.3g s: expected at most %g from one shape to the next"):format(largest, t.duration / n, most))
  end
  return all, times
end

local function check_bends(t, all)
  local widest, largest = 0, 0
  for k = 0, 32 do widest = math.max(widest, radius(t, t.upper + t.joint * (k / 32 - 0.5))) end
  for _, angle in ipairs(all) do largest = math.max(largest, math.abs(angle)) end
  if largest > farthest then fail("bend", ("expected at most %g degrees to either side, got %.4g"):format(farthest, largest)) end
  local least = math.rad(largest) * widest / crowding
  if t.joint < least then
    fail("joint", ("the inner side of a joint of %.3g m folds over when it is bent by %.4g degrees at a radius of %.3g m: expected at least %.3g m"):format(t.joint, largest, widest, least))
  end
end

local function check_sizes(t)
  if #t.radii ~= 3 then fail("radii", ("expected three radii, at the beginning, the joint and the end, got %d numbers"):format(#t.radii)) end
  t.joint = t.joint or 2.2 * t.radii[2]
  if t.around > 100000 then fail("around", ("expected a count from 8 to 100000, got %d"):format(t.around)) end
  t.around = 4 * math.ceil(t.around / 4)
  t.caps = t.around // 4 -- rings of each end
  t.size = t.size or 2 * math.pi * t.radii[2] / t.around
  local room = 2 * math.min(t.upper, t.lower)
  if t.joint >= room then fail("joint", ("expected less than %.3g m, twice the shorter part, got %.3g m"):format(room, t.joint)) end
end

local function run(t)
  check_sizes(t)
  local rings = (t.upper + t.lower) / t.size + 2 * t.caps + 6
  loft.check_facets(t.around, math.ceil(rings), 1, fail, "size")
  local frame = loft.frame(t.from or { 0, 0, 0 }, t.axis or { 0, 0, 1 }, t.towards or { 1, 0, 0 }, fail)
  local bend, times = { t.bend }, nil
  if type(t.bend) ~= "number" then
    if not t.duration then fail("duration", "expected the time over which bend= is followed, got none") end
    bend, times = angles(t)
  end
  loft.check_facets(t.around, math.ceil(rings), #bend, fail, #bend > 1 and "every" or "size")
  check_bends(t, bend)
  local rows, first, second = stations(t)
  local meshes = {}
  for k, angle in ipairs(bend) do
    meshes[k] = shape(t, frame, rows, math.rad(angle))
    name_regions(t, meshes[k], rows, first, second)
  end
  if times then return fabric.rigid.motion { meshes = meshes, times = times, closed = true, name = t.name }, meshes end
  return fabric.rigid.surface { mesh = meshes[1], closed = true, name = t.name }, meshes
end

define {
  name = "fabric.rigid.limb",
  arguments = {
    { name = "upper", kind = "number", unit = "m", above = 0, sentence = "length of the first part, up to the middle of the joint" },
    { name = "lower", kind = "number", unit = "m", above = 0, sentence = "length of the second part" },
    { name = "radii", kind = "numbers", unit = "m", above = 0, sentence = "{beginning, joint, end}" },
    { name = "bend", kind = "number|function", of = "history", unit = "degrees", default = 0, sentence = "of the joint, up to 150: a number, or a history or function(t), which is followed" },
    { name = "duration", kind = "number", unit = "s", above = 0, optional = true, sentence = "over which bend= is followed; afterwards it stays" },
    { name = "every", kind = "number", unit = "s", above = 0, optional = true, sentence = "time between two shapes, between which points go straight; default: what turns by 3 degrees" },
    { name = "joint", kind = "number", unit = "m", above = 0, optional = true, sentence = "length of the middle line that bends, to an arc; default 2.2 of its radius, enough for 119 degrees" },
    { name = "from", kind = "numbers", optional = true, sentence = "{x, y, z}: where the middle line begins, m, default the origin" },
    { name = "axis", kind = "numbers", optional = true, sentence = "{x, y, z}: direction of the first part, default {0, 0, 1}" },
    { name = "towards", kind = "numbers", optional = true, sentence = "{x, y, z}: where the second part bends to, default {1, 0, 0}" },
    { name = "around", kind = "integer", low = 8, default = 32, sentence = "facets around, a multiple of 4" },
    { name = "size", kind = "number", unit = "m", above = 0, optional = true, sentence = "of facets along the limb; default: as around the joint" },
    { name = "name", kind = "text", optional = true, sentence = "for messages and files; default the shape's" },
  },
  sentence = "An arm, a leg or a finger: two tapered round parts with a joint that bends, closed, with round ends. Returns a rigid body, which stands (and m:move may move it) where bend is a number, "
    .. "and the list of the meshes of its shapes, whose sets are upper, joint, lower, joint_inner and joint_outer.",
  example = "local arm, shapes = fabric.rigid.limb{ upper=0.28, lower=0.25, radii={0.05, 0.042, 0.03}, bend=fabric.ramp(90, 0.5), duration=0.5 }\n"
    .. "assert(#shapes == 33 and #shapes[1]:set 'joint' > 0)",
  run = run,
}
