-- A front and a back, laid around a solid trunk of facets: cloth of coarse elements is thicker against it by default, and seams that are drawn through it faster than
-- contact stops are said as the run is made, with the time that they need.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.card("blend", { bending = "estimated" })
local k = 0.8 -- of a grown wearer
local r, top = 0.18 * k, 0.56 * k -- m: cylinder of the pieces, height of the neck
local w = math.pi * r / 2

local function vest(size, over, duration, thickness)
  local sections = {}
  for i, at in ipairs { { -0.05, 0.165, 0.115 }, { 0.2, 0.14, 0.1 }, { 0.38, 0.165, 0.115 }, { 0.47, 0.165, 0.095 }, { 0.52, 0.11, 0.07 }, { 0.55, 0.055, 0.055 }, { 0.62, 0.05, 0.05 } } do
    sections[i] = { k * at[1], k * at[2], k * at[3] }
  end
  local trunk = fabric.rigid.torso { name = "trunk", around = 28, sections = sections }
  local function piece(neck, towards)
    return fabric.mesh.panel { size = size, grain = 90, outline = { { -w, 0 }, { w, 0 }, { w, 0.34 * k, name = "ls" }, { spline = { { 0.22 * k, 0.4 * k }, { 0.215 * k, top - 0.05 * k } } }, { 0.09 * k, top, name = "lsh" },
      { arc = { through = { 0, top - neck * k }, to = { -0.09 * k, top } } }, { -0.215 * k, top - 0.05 * k, name = "rsh" }, { spline = { { -0.22 * k, 0.4 * k }, { -w, 0.34 * k } } }, { name = "rs" } } }:wrap { cylinder = { radius = r, axis = { 0, 0, 1 }, from = { 0, 0, -0.03 * k }, towards = { 0, towards, 0 } } }
  end
  local m = fabric.model { bodies = { { name = "f", mesh = piece(0.08, -1), card = card }, { name = "b", mesh = piece(0.03, 1), card = card } }, points = 1 }
  m:seam { "f.ls", "b.rs", hinge = true }:seam { "f.rs", "b.ls", hinge = true }
  m:seam { "f.lsh", "b.rsh", over = over, hinge = true }:seam { "f.rsh", "b.lsh", over = over, hinge = true }
  m:gravity { 0, 0, -9.81 }:contact { between = { trunk, "all" }, friction = 0.4, thickness = thickness }
  return fabric.dynamic { model = m, duration = duration, damping = { mass = 30 } }
end

local function said(a)
  for _, w_ in ipairs(a.warnings) do if w_.code == "seam" then return w_.text end end
end

-- The gap at the start, when all is far away, is the range of contact with the trunk: a twentieth of the elements' sides less the floor. A thickness that is given stays.
local function range(size, thickness) return (vest(size, 0.3, 0.5, thickness):gap()) end
for _, size in ipairs { 30 * mm, 45 * mm } do
  local side = range(size) / 0.05
  print(("%g mm: range %.4g mm"):format(size / mm, range(size) / mm))
  assert(side > 0.8 * size and side < 1.1 * size)
end
assert(range(45 * mm, card.thickness) < card.thickness / 2)

-- A seam drawn through the trunk too fast is reported before the first step, with the time that would do. The time asked for is in proportion to what contact stops.
local slow, fast, thin = said(vest(45 * mm, 0.4, 0.5)), said(vest(45 * mm, 0.03, 0.5)), said(vest(45 * mm, 0.4, 0.5, card.thickness))
print(fast, thin)
assert(not slow, slow)
assert(fast:find("passes through the trunk", 1, true) and fast:find("got 0.03 s", 1, true))
assert(thin:find("got 0.4 s", 1, true))
local function asked(text) return tonumber(text:match "'over' of at least ([%d.]+) s") end
assert(asked(fast) > 0.03 and asked(fast) < 0.4 and asked(thin) > 5 * asked(fast))
