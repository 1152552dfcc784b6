-- Tools of fabric.lab.form from files, most of them STL, which hold neither units nor a common list of points, and often normals of both senses.
--
-- A tool is scaled, its facets are turned to look outwards (of an open surface: towards the plies), and it is moved along z until it touches the
-- plies. Two tools are then compared at four places of the stroke, which no contact between the plies and one tool would do.
local define = require "fabric.define"
local fabric = require "fabric"
local files = {}

local longest, shortest = 5, 1e-3 -- m: of the longest side of a tool
local most_facets = 200000
local grid = 96 -- columns along the longer side, in which facets are looked for
local places = 4 -- of the stroke

files.rows = {
  { name = "file", kind = "text", optional = true, sentence = "an STL or other mesh file in the place of lengths; x and y are kept, along z it is moved to the plies" },
  { name = "units", kind = "text", choices = { "m", "cm", "mm", "inch" }, optional = true, sentence = "of that file, which says none" },
}

local function fail(field, words) define.fail(("form: field '%s': %s"):format(field, words)) end

local function box_of(nodes)
  local low, high = { math.huge, math.huge, math.huge }, { -math.huge, -math.huge, -math.huge }
  for _, p in ipairs(nodes) do
    for k = 1, 3 do low[k], high[k] = math.min(low[k], p[k]), math.max(high[k], p[k]) end
  end
  return low, high
end

-- Nodes and elements of a mesh as tables.
local function listed(mesh)
  local nodes, elements = {}, {}
  for i, p in ipairs(mesh.nodes) do nodes[i] = { p[1], p[2], p[3] } end
  for i, e in ipairs(mesh.elements) do elements[i] = table.move(e, 1, #e, 1, {}) end
  return { nodes = nodes, elements = elements }
end

local function volume(mesh)
  local sum, nodes = 0, mesh.nodes
  for _, e in ipairs(mesh.elements) do
    local a = nodes[e[1]]
    for i = 2, #e - 1 do
      local b, c = nodes[e[i]], nodes[e[i + 1]]
      sum = sum + a[1] * (b[2] * c[3] - b[3] * c[2]) + a[2] * (b[3] * c[1] - b[1] * c[3]) + a[3] * (b[1] * c[2] - b[2] * c[1])
    end
  end
  return sum / 6
end

local function turn_over(mesh)
  for _, e in ipairs(mesh.elements) do
    for k = 1, #e // 2 do e[k], e[#e + 1 - k] = e[#e + 1 - k], e[k] end
  end
end

-- Facets that look outwards, and whether they bound a solid.
local function mended(field, given, mesh, towards)
  local closed, turned = mesh:check().borders == 0
  if closed then
    turned = mesh:orient()
  else
    turned = mesh:orient { 0, 0, towards }
    fabric.warn(("form: field '%s.file': '%s' is not closed: its open side has to stay clear of the plies"):format(field, given.file))
  end
  mesh = listed(mesh)
  if closed and volume(mesh) < 0 then
    turn_over(mesh)
    turned = #mesh.elements - turned
  end
  if turned > 0 then
    fabric.warn(("form: field '%s.file': '%s': %d of %d facets looked inwards and were turned"):format(field, given.file, turned, #mesh.elements))
  end
  return mesh, closed
end

-- Reads a tool. towards: -1 for what presses from above, whose lowest place comes to z = 0, and 1 for a die, whose highest place does.
function files.load(field, given, towards)
  for _, name in ipairs { "shape", "radius", "size", "corner", "length", "waist", "angle", "height", "gap", "outer" } do
    if given[name] then fail(field .. "." .. name, "expected none beside file=, whose shape it is") end
  end
  if not given.units then fail(field .. ".units", ("expected 'm', 'cm', 'mm' or 'inch' beside file='%s', which says none"):format(given.file)) end
  local mesh = fabric.mesh.read { file = given.file, join = true, units = given.units }
  if #mesh.elements > most_facets then fail(field .. ".file", ("expected at most %d facets, got %d: a coarser export"):format(most_facets, #mesh.elements)) end
  local low, high = box_of(mesh.nodes)
  local long = math.max(high[1] - low[1], high[2] - low[2], high[3] - low[3])
  if long > longest or long < shortest then
    fail(field .. ".units", ("the tool would be %.4g m long, expected %.4g to %.4g m: is '%s' in %s?"):format(long, shortest, longest, given.file, long > longest and "mm" or "m"))
  end
  local rest = towards < 0 and low[3] or high[3]
  mesh:map(function(x, y, z) return x, y, z - rest end)
  local whole, closed = mended(field, given, mesh, towards)
  return { mesh = whole, closed = closed, height = high[3] - low[3] }
end

-- The tool as a body whose lowest or highest place is at the height z.
function files.body(tool, z, name, mass)
  local mesh = fabric.mesh(tool.mesh)
  mesh:map(function(x, y, height) return x, y, height + z end)
  return fabric.rigid.surface { mesh = mesh, closed = tool.closed, mass = mass, name = name }
end

-- --- clearance

local function triangles(mesh)
  local out, nodes = {}, mesh.nodes
  for _, e in ipairs(mesh.elements) do
    for i = 2, #e - 1 do out[#out + 1] = { nodes[e[1]], nodes[e[i]], nodes[e[i + 1]] } end
  end
  return out
end

-- Triangles by columns of x and y, each in all columns that it is nearer to than `reach`.
local function columns(list, low, size, reach)
  local all = {}
  for _, t in ipairs(list) do
    local a, b = box_of(t)
    for i = math.floor((a[1] - reach - low[1]) / size), math.floor((b[1] + reach - low[1]) / size) do
      for j = math.floor((a[2] - reach - low[2]) / size), math.floor((b[2] + reach - low[2]) / size) do
        local key = i * 65536 + j
        all[key] = all[key] or {}
        table.insert(all[key], t)
      end
    end
  end
  return function(x, y) return all[math.floor((x - low[1]) / size) * 65536 + math.floor((y - low[2]) / size)] or {} end
end

local function sub(a, b) return a[1] - b[1], a[2] - b[2], a[3] - b[3] end

-- Square of the distance from p to the segment from a to b.
local function to_segment(p, a, b)
  local ux, uy, uz = sub(b, a)
  local px, py, pz = sub(p, a)
  local s = math.max(0, math.min(1, (px * ux + py * uy + pz * uz) / math.max(ux * ux + uy * uy + uz * uz, 1e-300)))
  return (px - s * ux) ^ 2 + (py - s * uy) ^ 2 + (pz - s * uz) ^ 2
end

local function to_triangle(p, t)
  local ux, uy, uz = sub(t[2], t[1])
  local vx, vy, vz = sub(t[3], t[1])
  local px, py, pz = sub(p, t[1])
  local uu, uv, vv = ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz
  local pu, pv, det = px * ux + py * uy + pz * uz, px * vx + py * vy + pz * vz, uu * vv - uv * uv
  local s, r = (pu * vv - pv * uv) / det, (pv * uu - pu * uv) / det
  if det > 0 and s >= 0 and r >= 0 and s + r <= 1 then return (px - s * ux - r * vx) ^ 2 + (py - s * uy - r * vy) ^ 2 + (pz - s * uz - r * vz) ^ 2 end
  return math.min(to_segment(p, t[1], t[2]), to_segment(p, t[2], t[3]), to_segment(p, t[3], t[1]))
end

-- Height of a surface over x, y: its lowest (sign -1) or highest place there, nil beside it.
local function height(at, x, y, sign)
  local best
  for _, t in ipairs(at(x, y)) do
    local a, b, c = t[1], t[2], t[3]
    local det = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
    if math.abs(det) > 1e-18 then
      local s = ((x - a[1]) * (c[2] - a[2]) - (y - a[2]) * (c[1] - a[1])) / det
      local r = ((b[1] - a[1]) * (y - a[2]) - (b[2] - a[2]) * (x - a[1])) / det
      if s >= 0 and r >= 0 and s + r <= 1 then
        local z = a[3] + s * (b[3] - a[3]) + r * (c[3] - a[3])
        if not best or sign * z > sign * best then best = z end
      end
    end
  end
  return best
end

-- Corners, middles of sides and of facets.
local function samples(list)
  local out = {}
  for _, t in ipairs(list) do
    local m = { 0, 0, 0 }
    for k = 1, 3 do
      local a, b = t[k], t[k % 3 + 1]
      out[#out + 1] = a
      out[#out + 1] = { (a[1] + b[1]) / 2, (a[2] + b[2]) / 2, (a[3] + b[3]) / 2 }
      for d = 1, 3 do m[d] = m[d] + a[d] / 3 end
    end
    out[#out + 1] = m
  end
  return out
end

local function looked_up(mesh, reach)
  local list, low, high = triangles(mesh), box_of(mesh.nodes)
  local size = math.max(reach, (high[1] - low[1]) / grid, (high[2] - low[2]) / grid)
  return { list = list, at = columns(list, low, size, reach), low = low, high = high, size = size }
end

-- The least distance of two tools at four places of the stroke, at most `reach`. plies: how high the punch starts above the die. Tools that pass
-- through each other are refused.
function files.nip(punch, die, plies, stroke, reach)
  local p, d = looked_up(punch, reach), looked_up(die, reach)
  local step = math.max(p.high[1] - p.low[1], p.high[2] - p.low[2]) / grid
  for x = p.low[1] + step / 2, p.high[1], step do
    for y = p.low[2] + step / 2, p.high[2], step do
      local lower, upper = height(p.at, x, y, -1), height(d.at, x, y, 1)
      if lower and upper and lower + plies - stroke < upper - 1e-9 then
        fail("die", ("the punch goes through the die at the end of the stroke, at x = %.4g, y = %.4g m by %.4g m along z"):format(x, y, upper - lower - plies + stroke))
      end
    end
  end
  local least, where = reach ^ 2, nil
  local function scan(points, other, shift)
    for _, q in ipairs(points) do
      local near = other.at(q[1], q[2])
      local at = #near > 0 and { q[1], q[2], q[3] + shift }
      for _, t in ipairs(near) do
        local square = to_triangle(at, t)
        if square < least then least, where = square, q end
      end
    end
  end
  local of_punch, of_die = samples(p.list), samples(d.list)
  for k = 1, places do
    local z = plies - stroke * k / places
    scan(of_punch, d, z)
    scan(of_die, p, -z)
  end
  return math.sqrt(least), where
end

-- Refuses a tool that is not its own mirror image about x = 0 and y = 0 within a tolerance, m. The facets may differ.
function files.check_quarter(field, tool, tolerance)
  local of = looked_up(tool.mesh, tolerance)
  for axis, name in ipairs { "x", "y" } do
    for _, p in ipairs(samples(of.list)) do
      local q = { p[1], p[2], p[3] }
      q[axis] = -q[axis]
      local square = math.huge
      for _, t in ipairs(of.at(q[1], q[2])) do
        square = math.min(square, to_triangle(q, t))
        if square <= tolerance ^ 2 then break end
      end
      if square > tolerance ^ 2 then
        fail("quarter", ("the %s is not symmetric about %s = 0: expected the mirror image of x = %.4g, y = %.4g, z = %.4g m within %.2g m (a tenth of a ply) of it, got %s: it is moved in the file, or the whole is needed"):format(
          field, name, p[1], p[2], p[3], tolerance, square < math.huge and ("%.2g m"):format(math.sqrt(square)) or "nothing there"))
      end
    end
  end
end

-- Where the die is flat at its height: f(p) for p.x, p.y. The tolerance is for what an export rounds.
function files.flat(die)
  local d = looked_up(die, 0)
  local by = 1e-4 * math.max(d.high[1] - d.low[1], d.high[2] - d.low[2])
  return function(p)
    local z = height(d.at, p.x, p.y, 1)
    return z ~= nil and z > d.high[3] - by
  end
end

return files
