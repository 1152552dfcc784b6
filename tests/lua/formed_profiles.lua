-- Forming of L and Z profiles: walls at 90 degrees and leaning, where the ply lies at the end, whole blanks of squares and triangles.
local fabric = require "fabric"
local mm = fabric.units.mm

local function near(name, got, want, by) assert(math.abs(got - want) <= by, string.format("%s: expected %.6g to %.2g, got %.6g", name, want, by, got)) end

local function form(more)
  local t = { card = fabric.card("blend", { bending = "estimated" }), blank = { 48 * mm, 12 * mm }, stroke = 16 * mm, cells = 24, speed = 5, rows = 8, holder = { force = 15 },
              punch = { shape = "L", size = { 32 * mm, 30 * mm }, edge = 5 * mm } }
  for k, v in pairs(more) do t[k] = v end
  if t.punch.shape == "Z" then t.holder = nil end
  local r = fabric.lab.form(t)
  assert(not r.trouble and r.curve[#r.curve].error < 1e-3 and math.abs(r.stroke - t.stroke) < 1e-9)
  return r
end
local half = 0.19 * mm -- of the thickness of the ply

-- An L of 90 degrees: the upper flange on the face, the other on the wall.
local upright = form {}
local on_wall = 0
for _, row in ipairs(upright.angles) do
  if row.X < -8 * mm then near("flange on the face", row.z, 0, 0.15 * mm) end
  if row.z < -6 * mm and row.z > -11 * mm then
    near("flange on the wall", row.x, half, 0.25 * mm)
    on_wall = on_wall + 1
  end
end
assert(on_wall >= 12 and upright.draw_in.right > 9 * mm and upright.wrinkles.height < 0.4 * mm)

-- A wall of 60 degrees, triangles, plies at 0 and 45 degrees: the flange lies along it.
local leaning = form { punch = { shape = "L", size = { 32 * mm, 30 * mm }, edge = 5 * mm, angle = 60 }, triangles = true, cells = 16, stack = { 0, 45 } }
local sum, count, slope = 0, 0, math.rad(60)
for _, row in ipairs(leaning.angles) do
  if row.ply == 1 and row.z < -6 * mm and row.z > -12 * mm then
    sum, count = sum + row.x * math.sin(slope) + row.z * math.cos(slope), count + 1
  end
end
assert(count > 8)
near("distance from a leaning wall", sum / count, half, 0.5 * mm)

-- A Z: the upper flange stays at 0, the lower one is as deep as the wall; a blank that lay in the middle keeps its length.
local z = form { punch = { shape = "Z", size = { 32 * mm, 30 * mm }, edge = 5 * mm, height = 12 * mm }, stroke = 12 * mm }
local left, right = math.huge, -math.huge
for _, row in ipairs(z.angles) do
  if row.x < -8 * mm then near("upper flange", row.z, 0, 0.15 * mm) end
  if row.x > 8 * mm then near("lower flange", row.z, -12 * mm, 0.15 * mm) end
  left, right = math.min(left, row.x), math.max(right, row.x)
end
assert(right - left < 46 * mm - 5 * mm and right > 15 * mm and left < -15 * mm)

-- Tools alone, closed, so that they can have a mass; at its least and largest angle.
for _, shape in ipairs { "L", "Z" } do
  for _, angle in ipairs { 45, 90 } do
    local t = { shape = shape, size = { 30 * mm, 20 * mm }, edge = 3 * mm, height = 12 * mm, angle = angle, mass = 0.2 }
    assert(fabric.rigid.punch(t))
    t.outer = 40 * mm
    for _, facing in ipairs { "up", "down" } do
      t.facing = facing
      assert(fabric.rigid.die(t))
    end
  end
end
print "formed_profiles ok"
