-- Limbs and trunks: their sizes against closed forms, one topology through the motion, and what is refused.
local fabric = require "fabric"
local fails = function(words, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(words, 1, true), 'expected "' .. words .. '", got ' .. tostring(why))
end
local near = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).near
local function volume(mesh)
  local sum = 0
  for _, e in ipairs(mesh.elements) do
    for k = 2, #e - 1 do
      local a, b, c = mesh.nodes[e[1]], mesh.nodes[e[k]], mesh.nodes[e[k + 1]]
      sum = sum + (a[1] * (b[2] * c[3] - b[3] * c[2]) + a[2] * (b[3] * c[1] - b[1] * c[3]) + a[3] * (b[1] * c[2] - b[2] * c[1])) / 6
    end
  end
  return sum
end
local function limb(t)
  t.upper, t.lower, t.radii = 0.3, 0.25, t.radii or { 0.04, 0.04, 0.04 }
  local body, shapes = fabric.rigid.limb(t)
  return body, shapes
end

-- Pappus: area and volume of a bent pipe are those of the straight one, pi r^2 l and 2 pi r l, and those of a ball for both ends. Facets come to it by
-- the square of their size.
local r, l = 0.04, 0.55
for _, bend in ipairs { 0, 60, -90, 110 } do
  local before
  for _, around in ipairs { 32, 64 } do
    local _, shapes = limb { bend = bend, around = around }
    local ratio = volume(shapes[1]) / (math.pi * r ^ 2 * l + 4 / 3 * math.pi * r ^ 3)
    assert(ratio < 1 and ratio > 1 - 12 / around ^ 2, ratio)
    -- The round ends have as many rings in both.
    if before then assert((1 - ratio) / (1 - before) < 0.32, bend) end
    before = ratio
    near(shapes[1]:check().area, 2 * math.pi * r * l + 4 * math.pi * r ^ 2, 12 / around ^ 2, "area")
  end
end
-- Two cones: the volume of both, with the joint's rounding.
do
  local _, shapes = limb { radii = { 0.06, 0.04, 0.03 }, around = 64 }
  local function cone(a, b, h) return math.pi * h * (a * a + a * b + b * b) / 3 end
  local want = cone(0.06, 0.04, 0.3) + cone(0.04, 0.03, 0.25) + 2 / 3 * math.pi * (0.06 ^ 3 + 0.03 ^ 3)
  near(volume(shapes[1]), want, 5e-3, "volume of cones")
end

-- The middle line keeps its length, the parts are straight; sets are regions of elements, which cover all but the ends.
do
  local _, shapes = limb { bend = function(t) return 90 * t end, duration = 1, joint = 0.1, around = 16, from = { 1, 0, 0 }, axis = { 0, 1, 0 }, towards = { 0, 0, -1 } }
  assert(#shapes == 33)
  local first = shapes[1]
  for _, mesh in ipairs(shapes) do
    assert(#mesh.nodes == #first.nodes and #mesh.elements == #first.elements and mesh:check().borders == 0)
    for e, corners in ipairs(mesh.elements) do
      for k, n in ipairs(corners) do assert(n == first.elements[e][k]) end
    end
  end
  local tip = shapes[#shapes].nodes[#first.nodes] -- of the round end
  near(tip[1], 1, 1e-12, "out of the plane")
  -- An arc of 90 degrees and 0.1 m has the radius 0.2/pi.
  near(tip[2], 0.25 + 0.2 / math.pi, 1e-12, "along the upper part")
  near(tip[3], -(0.2 / math.pi + 0.2 + 0.04), 1e-12, "along the lower part")
  local count = 0
  for _, name in ipairs { "upper", "joint", "lower" } do count = count + #first:elements(name) end
  assert(count == #first.elements - 2 * 16 * 4)
  assert(#first:elements "joint_inner" == #first:elements "joint_outer" and 2 * #first:elements "joint_inner" == #first:elements "joint")
  local low, high = math.huge, -math.huge
  for _, n in ipairs(first:set "joint_inner") do low = math.min(low, first.nodes[n][3]) end
  for _, n in ipairs(first:set "joint_outer") do high = math.max(high, first.nodes[n][3]) end
  near(low, -0.04, 1e-9, "the inner side is where it bends to")
  near(high, 0.04, 1e-9, "the outer side")
end

-- It stands, moves as one, or bends; cloth that starts inside is refused.
do
  local sheet = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 2, ny = 2, origin = { 0, 0, 0.1 } }
  local function dressed(bend, duration)
    local body = limb { bend = bend, duration = duration, name = "arm" }
    local m = fabric.model { mesh = sheet, card = fabric.card "blend", warp = 0 }
    m:contact { between = { body, "all" } }
    return fabric.dynamic { model = m, duration = 1e-3 }
  end
  fails("starts inside the arm, which bounds a solid", dressed, 30)
  fails("starts inside the arm, which bounds a solid", dressed, fabric.ramp(90, 1), 1)
  assert(tostring(limb { bend = 90, name = "arm" }):find("arm: surface", 1, true))
  assert(tostring(limb { bend = fabric.ramp(90, 1), duration = 1 }):find("moving surface", 1, true))
end

-- A smooth trunk: half axes are those of the sections, nothing bulges between, and two equal sections are a straight elliptical cylinder.
do
  local _, mesh = fabric.rigid.torso { sections = { { 0, 0.17, 0.12 }, { 0.1, 0.16, 0.11 }, { 0.25, 0.13, 0.1 }, { 0.3, 0.13, 0.1 } }, around = 40, size = 0.01 }
  local seen = 0
  for _, p in ipairs(mesh.nodes) do
    if p[3] >= 0.1 - 1e-9 and p[3] <= 0.25 + 1e-9 then
      local s = (p[1] / 0.16) ^ 2 + (p[2] / 0.11) ^ 2
      assert(s <= 1 + 1e-9)
    end
    if math.abs(p[3] - 0.1) < 1e-9 then
      near((p[1] / 0.16) ^ 2 + (p[2] / 0.11) ^ 2, 1, 1e-9, "a section")
      seen = seen + 1
    end
    if p[3] > 0.25 and p[3] < 0.3 then near((p[1] / 0.13) ^ 2 + (p[2] / 0.1) ^ 2, 1, 1e-9, "between equal sections") end
  end
  assert(seen == 40)
  local _, straight = fabric.rigid.torso { sections = { { 0, 0.1, 0.05 }, { 0.4, 0.1, 0.05 } }, around = 96 }
  near(volume(straight), math.pi * 0.1 * 0.05 * 0.4 + 4 / 3 * math.pi * 0.1 * 0.05 * 0.05, 5e-3, "volume of a trunk")
end

-- Calls that are refused.
fails("limb: field 'radii': expected three radii", limb, { radii = { 0.04, 0.03 } })
fails("limb: field 'joint': the inner side of a joint of 0.05 m folds over when it is bent by 90 degrees at a radius of 0.04 m: expected at least 0.0661 m", limb,
  { bend = 90, joint = 0.05 })
fails("limb: field 'bend': expected at most 150 degrees to either side, got 160", limb, { bend = 160 })
fails("limb: field 'joint': expected less than 0.5 m, twice the shorter part, got 0.5 m", limb, { joint = 0.5 })
fails("limb: field 'duration': expected the time over which bend= is followed, got none", limb, { bend = fabric.ramp(90, 1) })
fails("limb: field 'every': the joint turns by 18 degrees within 0.2 s: expected at most 5 from one shape to the next", limb, { bend = fabric.ramp(90, 1), duration = 1, every = 0.2 })
fails("limb: field 'bend': expected a number of degrees at t = 0 s, got nil", limb, { bend = function() end, duration = 1 })
fails("limb: field 'towards': expected a direction that is not along the axis", limb, { towards = { 0, 0, 2 } })
fails("limb: field 'axis': expected {x, y, z}, got 2 numbers", limb, { axis = { 0, 1 } })
fails("torso: field 'sections': expected two sections or more, got 1", fabric.rigid.torso, { sections = { { 0, 1, 1 } } })
fails("torso: field 'sections[2]': expected heights that ascend, got 0 m after 0 m", fabric.rigid.torso, { sections = { { 0, 1, 1 }, { 0, 1, 1 } } })
fails("torso: field 'sections[1]': expected a height and two positive lengths in m, got -1 at place 2", fabric.rigid.torso, { sections = { { 0, -1, 1 }, { 0, 1, 1 } } })
