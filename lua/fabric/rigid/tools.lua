-- fabric.rigid.punch, .dome and .die: tools of forming whose shapes are given by a few lengths.
--
--          |  punch  |                The lowest point of a punch and the face of a die lie at `at`. A die has an opening, whose edge is
--          \_       _/                rounded; facing down it is a blank holder.
--            `-----'  <- at
--     -------.       .-------  at
--      die    \     /  edge
--             |     |
local define = require "fabric.define"
local fabric = require "fabric"
local loft = require "fabric.rigid.loft"
local profile = require "fabric.rigid.profile"
local lists = require "fabric.lists"
local tools = {}

local quarter = 8 -- facets of a rounded edge
local largest = 1000 -- m: of any length
local sharpest = 1e-6 -- m: least radius of an edge

-- call: the name of a function, or {name, path} where the tool is a table within its arguments.
local function fail(call, field, words)
  local name, path = call, ""
  if type(call) == "table" then name, path = table.unpack(call) end
  define.fail(("%s: field '%s%s': %s"):format(name, path, field, words))
end

-- Outlines: lists of {x, y, nx, ny}, counter-clockwise, n points outwards.

local function arc(out, cx, cy, r, from, to, n, inwards)
  for i = 0, n do
    local a = from + (to - from) * i / n
    local c, s = math.cos(a), math.sin(a)
    local k = inwards and -1 or 1
    out[#out + 1] = { cx + r * c, cy + r * s, k * c, k * s }
  end
end

local function line(out, length, size)
  local a, n = out[#out], math.ceil(length / size - 1e-9)
  local tx, ty = -a[4], a[3]
  for i = 1, n - 1 do out[#out + 1] = { a[1] + tx * length * i / n, a[2] + ty * length * i / n, a[3], a[4] } end
end

local function circle(r, around)
  local out = {}
  arc(out, 0, 0, r, 0, 2 * math.pi, around)
  out[#out] = nil
  return out
end

-- A rectangle a x b with round corners.
local function rounded(a, b, r, around)
  local out, n, size = {}, math.max(3, around // 8), 2 * (a + b) / around
  local x, y = a / 2 - r, b / 2 - r
  for k, c in ipairs { { x, y }, { -x, y }, { -x, -y }, { x, -y } } do
    arc(out, c[1], c[2], r, (k - 1) * math.pi / 2, k * math.pi / 2, n)
    line(out, 2 * (k % 2 == 1 and x or y), size)
  end
  if x == 0 or y == 0 then -- arcs meet
    local kept = {}
    for i, p in ipairs(out) do
      local q = out[i % #out + 1]
      if (p[1] - q[1]) ^ 2 + (p[2] - q[2]) ^ 2 > 1e-18 then kept[#kept + 1] = p end
    end
    return kept
  end
  return out
end

-- Two circles of the radius r, a distance apart, joined by arcs of the radius f.
local function peanut(r, apart, f, around)
  local c = apart / 2
  local h = math.sqrt((r + f) ^ 2 - c ^ 2)
  local theta, w = math.atan(h, -c), math.atan(c, h)
  local long, short = math.max(6, math.ceil(around * theta / (2 * theta + 2 * w) / 2) * 2), math.max(3, math.ceil(around * w / (2 * theta + 2 * w)))
  local out = {}
  local function add(...)
    arc(out, ...)
    out[#out] = nil
  end
  add(c, 0, r, -theta, theta, long)
  add(0, h, f, -math.pi / 2 + w, -math.pi / 2 - w, short, true)
  add(-c, 0, r, math.pi - theta, math.pi + theta, long)
  add(0, -h, f, math.pi / 2 + w, math.pi / 2 - w, short, true)
  return out
end

local function waist(call, t)
  local least = t.length / 2 - t.radius
  if t.waist <= least then
    fail(call, "waist", ("the arcs do not reach from dome to dome: expected more than %.4g m, got %.4g"):format(least, t.waist))
  end
end

local function counted(n) return n == 1 and "1 number" or n .. " numbers" end

local function sides(call, t)
  if #t.size ~= 2 then fail(call, "size", ("expected {width, height}, got %s"):format(counted(#t.size))) end
end

-- The outline of what is given; room: how far it is offset outwards.
local function outline(call, t, room)
  if t.shape == "hemisphere" then return circle(t.radius, t.around) end
  if t.shape == "double dome" then
    waist(call, t)
    if room >= t.waist then fail(call, "waist", ("expected more than the edge, %.4g m, got %.4g"):format(room, t.waist)) end
    return peanut(t.radius, t.length, t.waist, t.around)
  end
  sides(call, t)
  local a, b = table.unpack(t.size)
  if t.corner > math.min(a, b) / 2 + 1e-12 then
    fail(call, "corner", ("expected at most half of the shorter side, %.4g m, got %.4g"):format(math.min(a, b) / 2, t.corner))
  end
  return rounded(a, b, math.min(t.corner, a / 2, b / 2), t.around)
end

local function at_of(call, t)
  local p = t.at or { 0, 0, 0 }
  if #p ~= 3 then fail(call, "at", ("expected {x, y, z}, got %s"):format(counted(#p))) end
  for i = 1, 3 do
    if math.abs(p[i]) > largest then fail(call, "at", ("expected at most %d m from the origin, got %.4g at place %d"):format(largest, p[i], i)) end
  end
  return p
end

local function ring(line, at, offset, z)
  return lists.map(line, function(p) return { at[1] + p[1] + offset * p[3], at[2] + p[2] + offset * p[4], at[3] + z } end)
end

-- A box from its flat bottom up.
local function box(call, t, at)
  if t.edge > t.corner then fail(call, "edge", ("expected at most the corner, %.4g m, got %.4g"):format(t.corner, t.edge)) end
  local around, rings = outline(call, t, 0), {}
  for k = 0, quarter do
    local a = math.pi / 2 * k / quarter
    rings[#rings + 1] = ring(around, at, t.edge * (math.sin(a) - 1) + (k == 0 and 1e-9 * t.edge or 0), t.edge * (1 - math.cos(a)))
  end
  rings[#rings + 1] = ring(around, at, 0, t.height)
  return loft.mesh({ at[1], at[2], at[3] }, rings, { at[1], at[2], at[3] + t.height })
end

-- A body of revolution about a line along x, whose outline is that of two circles and the arcs between them.
local function double_dome(call, t, at)
  waist(call, t)
  local c, r, f = t.length / 2, t.radius, t.waist
  local h = math.sqrt((r + f) ^ 2 - c ^ 2)
  local touch, n = c * f / (r + f), math.max(8, t.around // 4)
  local stations = {}
  local function dome(side, from, to) -- angles from the outer end
    for i = from, to do
      local a = math.acos(-(c - touch) / r) * i / n
      stations[#stations + 1] = { side * (c + r * math.cos(a)), r * math.sin(a) }
    end
  end
  for i = 1, n do dome(-1, i, i) end
  for i = 1, n - 1 do
    local x = touch * (2 * i / n - 1)
    stations[#stations + 1] = { x, h - math.sqrt(f ^ 2 - x ^ 2) }
  end
  for i = n, 1, -1 do dome(1, i, i) end
  local rings = {}
  for k, s in ipairs(stations) do
    rings[k] = {}
    for i = 1, t.around do
      local a = 2 * math.pi * (i - 1) / t.around
      rings[k][i] = { at[1] + s[1], at[2] + s[2] * math.cos(a), at[3] + r + s[2] * math.sin(a) }
    end
  end
  return loft.mesh({ at[1] - c - r, at[2], at[3] + r }, rings, { at[1] + c + r, at[2], at[3] + r })
end

local function want(call, t, names)
  for _, name in ipairs(names) do
    if t[name] == nil then fail(call, name, ("expected a length in m for shape='%s', got none"):format(t.shape)) end
  end
end

local function surface(mesh, t) return fabric.rigid.surface { mesh = mesh, closed = true, mass = t.mass, name = t.name }, mesh end

function tools.is_profile(shape) return shape == "L" or shape == "Z" end

-- L and Z: what their lengths have to be. part: "punch" or "die".
local function check_profile(call, t, part)
  want(call, t, { "size", "edge" })
  sides(call, t)
  t.angle = t.angle or 90
  if t.shape == "Z" then want(call, t, { "height" }) end
  t.height = t.height or (part == "punch" and t.size[1] or 4 * t.edge)
  local least = profile.least_width(t)
  if t.size[1] <= least then fail(call, "size", ("expected more than {%.4g, ...} m, which the rounded edges take, got {%.4g, ...}"):format(least, t.size[1])) end
  if t.height <= least then fail(call, "height", ("expected more than %.4g m, which the rounded edge takes, got %.4g"):format(least, t.height)) end
end

-- Lengths that a shape does not have would be forgotten. part: "punch" or "die".
local own = {
  file = {},
  hemisphere = { radius = true, height = "punch" },
  box = { size = true, corner = true, edge = true, height = "punch" },
  ["double dome"] = { radius = true, length = true, waist = true },
  L = { size = true, edge = true, height = true, angle = true, gap = true },
}
own.Z = own.L
function tools.check_fields(call, t, part)
  for _, name in ipairs { "radius", "size", "corner", "length", "waist", "edge", "height", "angle", "gap" } do
    local has = own[t.shape][name]
    if t[name] and not (has == true or has == part or name == "edge" and part == "die") then
      fail(call, name, ("a %s of shape='%s' has none"):format(part, t.shape))
    end
  end
end

-- A hemisphere with its shaft, of facets, for what asks how far it is from other tools.
local function round(t, at)
  local around, rings, n = circle(1, t.around), {}, math.max(6, t.around // 4)
  for k = 1, n do
    local a = math.pi / 2 * k / n
    rings[k] = ring(around, at, t.radius * math.sin(a) - 1, t.radius * (1 - math.cos(a)))
  end
  local top = t.radius + (t.height or t.radius)
  rings[n + 1] = ring(around, at, t.radius - 1, top)
  return loft.mesh(at, rings, { at[1], at[2], at[3] + top })
end

-- A table of named lengths becomes a body and the mesh of its facets, of a hemisphere a function that makes it; also used by fabric.lab.form.
function tools.punch(t, call)
  call = call or "punch"
  local at = at_of(call, t)
  tools.check_fields(call, t, "punch")
  if tools.is_profile(t.shape) then
    check_profile(call, t, "punch")
    return surface(profile.punch(t, at), t)
  end
  if t.shape == "box" then
    want(call, t, { "size", "corner", "edge" })
    sides(call, t)
    t.height = t.height or math.min(t.size[1], t.size[2])
    if t.height <= t.edge then fail(call, "height", ("expected more than the edge, %.4g m, got %.4g"):format(t.edge, t.height)) end
    return surface(box(call, t, at), t)
  end
  want(call, t, { "radius" })
  if t.shape == "double dome" then
    want(call, t, { "length", "waist" })
    return surface(double_dome(call, t, at), t)
  end
  local z = at[3] + t.radius
  return fabric.rigid.cylinder { radius = t.radius, from = { at[1], at[2], z }, to = { at[1], at[2], z + (t.height or t.radius) }, mass = t.mass, name = t.name },
    function() return round(t, at) end
end

-- A closed ring: the rounded edge of the opening, the face, the outer side and the back.
function tools.die(t, call)
  call = call or "die"
  local at = at_of(call, t)
  tools.check_fields(call, t, "die")
  if tools.is_profile(t.shape) then
    check_profile(call, t, "die")
    local least = 2 * profile.least_width(t)
    if t.outer <= least then fail(call, "outer", ("expected more than %.4g m, which the rounded edges take, got %.4g"):format(least, t.outer)) end
    return surface(profile.die(t, at), t)
  end
  want(call, t, t.shape == "box" and { "size", "corner" } or t.shape == "double dome" and { "radius", "length", "waist" } or { "radius" })
  local inner = outline(call, t, t.edge)
  local up = t.facing == "down" and 1 or -1
  local reach = 0
  for _, p in ipairs(inner) do reach = math.max(reach, math.sqrt(p[1] ^ 2 + p[2] ^ 2)) end
  if t.outer <= reach + t.edge then
    fail(call, "outer", ("expected more than the opening with its edge, %.4g m, got %.4g"):format(reach + t.edge, t.outer))
  end
  local depth = 2 * t.edge
  local rings = { ring(inner, at, 0, up * depth) }
  for k = 0, quarter do
    local a = math.pi / 2 * k / quarter
    rings[#rings + 1] = ring(inner, at, t.edge * (1 - math.cos(a)), up * t.edge * (1 - math.sin(a)))
  end
  local face, n = rings[#rings], math.max(2, t.around // 16)
  local function out(share, z)
    local points = {}
    for i, p in ipairs(face) do
      local x, y = p[1] - at[1], p[2] - at[2]
      local k = 1 + share * (t.outer / math.sqrt(x ^ 2 + y ^ 2) - 1)
      points[i] = { at[1] + k * x, at[2] + k * y, at[3] + z }
    end
    return points
  end
  for k = 1, n do rings[#rings + 1] = out(k / n, 0) end
  rings[#rings + 1] = out(1, up * depth)
  local nodes, elements, count = {}, {}, #inner
  for _, points in ipairs(rings) do table.move(points, 1, #points, #nodes + 1, nodes) end
  local function node(k, i) return ((k - 1) % #rings) * count + (i - 1) % count + 1 end
  for k = 1, #rings do
    for i = 1, count do
      local a, b, c, d = node(k, i), node(k + 1, i), node(k + 1, i + 1), node(k, i + 1)
      elements[#elements + 1] = up < 0 and { a, b, c, d } or { a, d, c, b }
    end
  end
  return surface(fabric.mesh { nodes = nodes, elements = elements }, t)
end

local shapes = { "hemisphere", "box", "double dome", "L", "Z" }
local function length_row(name, sentence, optional, low)
  return { name = name, kind = "number", unit = "m", above = not low and 0 or nil, low = low, high = largest, optional = optional, sentence = sentence }
end
local outline_rows = {
  { name = "shape", kind = "text", choices = shapes, default = "hemisphere", sentence = "of the punch or of the opening: hemisphere (round), box, double dome; L and Z: profiles along y, whose face ends at x = 0 in a wall" },
  length_row("radius", "of a hemisphere, a dome or a round opening", true),
  { name = "size", kind = "numbers", unit = "m", above = 0, high = largest, optional = true, sentence = "{along x, along y} of a box; of L and Z the width of the lower face and the length of the profile" },
  length_row("corner", "radius of a box's corners, seen from above", true),
  length_row("length", "from centre to centre of a double dome, along x", true),
  length_row("waist", "radius of the arcs that join both domes", true),
  { name = "angle", kind = "number", unit = "degrees", low = 45, high = 90, optional = true, sentence = "of the wall of L and Z from the horizontal, default 90" },
}
local around_row = { name = "around", kind = "integer", low = 24, high = 2000, default = 64, sentence = "facets around" }
local punch_edge = length_row("edge", "radius of the lower edge of a box, of the edges of L and Z", true, sharpest)
local height_row = length_row("height", "of a box; of the shaft of a hemisphere; of the wall of L and Z; default the shorter side, the radius, the width of an L", true)
local own_rows = {
  { name = "at", kind = "numbers", optional = true, sentence = "{x, y, z}: its lowest point, or the middle of the opening in the face of a die, m; default the origin" },
  around_row,
  { name = "mass", kind = "number", unit = "kg", above = 0, high = 1e6, optional = true, sentence = "with it forces and contact move the body" },
  { name = "name", kind = "text", optional = true, sentence = "for messages and files; default the shape's" },
}
local die_height = length_row("height", "of the wall of L and Z, which is the depth of the floor of Z; default four times the edge of an L", true)

-- Rows of tools whose place is that of a test: fabric.lab.form.
tools.punch_rows = lists.joined(outline_rows, { punch_edge, height_row, around_row })
function tools.die_rows(shape, edge, outer)
  local all = lists.joined(outline_rows, { length_row("edge", edge, true, sharpest), die_height, length_row("gap", "from the wall of the punch of L and Z to that of the die, at the end of the stroke; default 1.1 times the thickness of the stack in contact", true), length_row("outer", outer, true), around_row })
  all[1] = { name = "shape", kind = "text", choices = shapes, optional = true, sentence = shape }
  return all
end

define {
  name = "fabric.rigid.punch",
  arguments = lists.joined(outline_rows, { punch_edge, height_row }, own_rows),
  sentence = "A punch for forming, its lowest point at `at`: a hemisphere with its shaft (a rod, round without facets), a box with radii, a double dome, or a block whose wall forms an L "
    .. "or, with its upper face, a Z profile along y; there `at` is the sharp corner of lower face and wall.",
  example = "local mm = fabric.units.mm\n"
    .. "local punch = fabric.rigid.punch{ radius=50*mm }\n"
    .. "local box = fabric.rigid.punch{ shape='box', size={60*mm, 40*mm}, corner=10*mm, edge=5*mm }",
  run = function(t) return (tools.punch(t)) end,
}

define {
  name = "fabric.rigid.dome",
  arguments = {
    length_row("radius", "of the dome, or of both"),
    length_row("length", "from centre to centre along x; without it a hemisphere", true),
    length_row("waist", "radius of the arcs that join both domes; default the radius", true),
    { name = "at", kind = "numbers", optional = true, sentence = "{x, y, z}: its lowest point, m; default the origin" },
    around_row,
    { name = "mass", kind = "number", unit = "kg", above = 0, high = 1e6, optional = true, sentence = "with it forces and contact move the body" },
    { name = "name", kind = "text", optional = true, sentence = "for messages and files; default the shape's" },
  },
  sentence = "A dome or a double dome as a punch: fabric.rigid.punch of these shapes.",
  example = "local mm = fabric.units.mm\nlocal dome = fabric.rigid.dome{ radius=60*mm, length=110*mm, waist=40*mm }",
  run = function(t)
    t.shape = t.length and "double dome" or "hemisphere"
    t.waist = t.length and (t.waist or t.radius)
    return (tools.punch(t, "dome"))
  end,
}

define {
  name = "fabric.rigid.die",
  arguments = lists.joined(outline_rows, {
    length_row("edge", "radius of the rounded edge of the opening", false, sharpest),
    die_height,
    length_row("outer", "radius of the round outside; of L and Z how far the face goes to -x"),
    { name = "facing", kind = "text", choices = { "up", "down" }, default = "up", sentence = "up: the cloth lies on it; down: a blank holder" },
  }, own_rows),
  sentence = "A plate with an opening for forming, its face at `at`: a die, or facing down a blank holder. shape, radius, size, corner, length and waist are those of the opening. "
    .. "For an L or Z profile a block whose wall goes down from `at`, the sharp corner of its face, of a Z to a floor.",
  example = "local mm = fabric.units.mm\nlocal die = fabric.rigid.die{ radius=55*mm, edge=6*mm, outer=150*mm }",
  run = function(t) return (tools.die(t)) end,
}

tools.outline = outline
return tools
