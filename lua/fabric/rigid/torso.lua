-- fabric.rigid.torso: a body of elliptical cross-sections, for a trunk, hips, a head or a dress form.
local define = require "fabric.define"
local fabric = require "fabric"
local loft = require "fabric.rigid.loft"


local function fail(field, words) define.fail(("torso: field '%s': %s"):format(field, words)) end

local function read_sections(list)
  local out = {}
  for i, s in ipairs(list) do
    local field = ("sections[%d]"):format(i)
    if type(s) ~= "table" or #s ~= 3 then fail(field, "expected {height, half width, half depth} in m") end
    for k = 1, 3 do
      if type(s[k]) ~= "number" or s[k] ~= s[k] or math.abs(s[k]) == math.huge or (k > 1 and s[k] <= 0) then
        fail(field, ("expected a height and two positive lengths in m, got %s at place %d"):format(tostring(s[k]), k))
      end
    end
    if i > 1 and s[1] <= list[i - 1][1] then fail(field, ("expected heights that ascend, got %.4g m after %.4g m"):format(s[1], list[i - 1][1])) end
    out[i] = s
  end
  if #out < 2 then fail("sections", ("expected two sections or more, got %d"):format(#out)) end
  return out
end

-- Slopes of a curve through the sections that never leaves the range of its neighbours [fritsch1984], for the half axis k.
local function slopes(sections, k)
  local n, secant, out = #sections, {}, {}
  for i = 1, n - 1 do secant[i] = (sections[i + 1][k] - sections[i][k]) / (sections[i + 1][1] - sections[i][1]) end
  out[1], out[n] = secant[1], secant[n - 1]
  for i = 2, n - 1 do
    local a, b = secant[i - 1], secant[i]
    out[i] = a * b > 0 and 2 * a * b / (a + b) or 0
  end
  return out
end

local function half(sections, slope, k, z)
  local i = 1
  while i < #sections - 1 and z > sections[i + 1][1] do i = i + 1 end
  local a, b = sections[i], sections[i + 1]
  local h = b[1] - a[1]
  local u = (z - a[1]) / h
  return (1 + 2 * u) * (1 - u) ^ 2 * a[k] + u * (1 - u) ^ 2 * h * slope[i] + u ^ 2 * (3 - 2 * u) * b[k] - u ^ 2 * (1 - u) * h * slope[i + 1]
end

local function run(t)
  local sections = read_sections(t.sections)
  if t.around > 100000 then fail("around", ("expected a count from 8 to 100000, got %d"):format(t.around)) end
  t.caps = math.max(2, t.around // 4) -- rings of each end
  local frame = loft.frame(t.from or { 0, 0, 0 }, t.axis or { 0, 0, 1 }, t.towards or { 1, 0, 0 }, fail)
  local wide, deep = slopes(sections, 2), slopes(sections, 3)
  local first, last = sections[1], sections[#sections]
  local size = t.size or 2 * math.pi * math.min(first[2], first[3]) / t.around
  loft.check_facets(t.around, math.ceil((last[1] - first[1]) / size) + 2 * t.caps + 2, 1, fail, "size")
  local rings = {}
  local function ring(z, a, b)
    local points = {}
    for i = 1, t.around do
      local phi = 2 * math.pi * (i - 1) / t.around
      points[i] = loft.point(frame, a * math.cos(phi), b * math.sin(phi), z)
    end
    rings[#rings + 1] = points
  end
  -- Ends are half ellipsoids, as high as the section's smaller half axis.
  local function close(section, sign, k)
    local beta = math.pi / 2 * k / t.caps
    ring(section[1] + sign * math.min(section[2], section[3]) * math.cos(beta), section[2] * math.sin(beta), section[3] * math.sin(beta))
  end
  for k = 1, t.caps - 1 do close(first, -1, k) end
  local n = math.max(2, math.ceil((last[1] - first[1]) / size - 1e-9))
  for k = 0, n do
    local z = first[1] + (last[1] - first[1]) * k / n
    ring(z, half(sections, wide, 2, z), half(sections, deep, 3, z))
  end
  for k = t.caps - 1, 1, -1 do close(last, 1, k) end
  local mesh = loft.mesh(loft.point(frame, 0, 0, first[1] - math.min(first[2], first[3])), rings, loft.point(frame, 0, 0, last[1] + math.min(last[2], last[3])))
  return fabric.rigid.surface { mesh = mesh, closed = true, name = t.name }, mesh
end

define {
  name = "fabric.rigid.torso",
  arguments = {
    { name = "sections", kind = "table", sentence = "{ {height, half width, half depth}, ... }, m: half axes of ellipses along the axis, from the lowest on" },
    { name = "from", kind = "numbers", optional = true, sentence = "{x, y, z}: where the height is 0, m, default the origin" },
    { name = "axis", kind = "numbers", optional = true, sentence = "{x, y, z}: direction of heights, default {0, 0, 1}" },
    { name = "towards", kind = "numbers", optional = true, sentence = "{x, y, z}: direction of widths, default {1, 0, 0}" },
    { name = "around", kind = "integer", low = 8, default = 48, sentence = "facets around" },
    { name = "size", kind = "number", unit = "m", above = 0, optional = true, sentence = "of facets along the axis; default: as around the smaller half axis of the first section" },
    { name = "name", kind = "text", optional = true, sentence = "for messages and files; default the shape's" },
  },
  sentence = "A trunk, hips, a leg that stays straight or a dress form: a closed surface through elliptical sections, smooth and without bulges between them, with round ends. Returns a rigid body, "
    .. "which stands (and m:move may move it), and its mesh.",
  example = "local hips, mesh = fabric.rigid.torso{ sections={ {0, 0.17, 0.12}, {0.1, 0.16, 0.11}, {0.25, 0.13, 0.1} } }\n"
    .. "assert(mesh:check().ok)",
  run = run,
}
