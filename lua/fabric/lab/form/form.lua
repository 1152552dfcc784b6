-- fabric.lab.form: plies on a die are pressed through its opening by a punch, under a blank holder.
--
--               | punch |
--     holder    |       |    holder         z = 0: middle of the lowest ply at the start
--     -------.  \_     _/ .-------          the punch moves down, the die stands
--     ===========`---'============  plies
--     -------.           .-------
--      die    \         /   edge
--
-- Tools given by their lengths are set off so that the surface of real cloth follows the shape asked for, although contact begins at a
-- distance of its own, which is longer: on a rounded edge it carries the pressure of tight yarns without shortening the steps.
-- Tools from files keep their shape; form_files mends and compares them.
-- An L and a Z profile have a wall in place of the opening; form_profile has what is their own.
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local fabric = require "fabric"
local files = require "fabric.lab.form.files"
local profile = require "fabric.lab.form.profile"
local sheet = require "fabric.lab.virtual.sheet"
local tools = require "fabric.rigid.tools"
local yarns = require "fabric.lab.form.yarns"
local lists = require "fabric.lists"
local mm = fabric.units.mm

local largest = 5         -- m: longer tools, blanks and strokes are in mm
local settles = 0.08      -- of the duration: the holder closes
local edge_share = 0.2    -- distance of contact over the radius of the die's edge
local bears = 6e6        -- Pa, that contact carries before its barrier begins
local heavy = 4           -- mass of a holder over that of the plies
local rim_share = { hemisphere = 1 / 6, ["double dome"] = 1 / 6, box = 1 / 3 } -- default radius of the die's edge over that of the punch
local rim_plies = 10      -- and over the thickness of a ply, at least
local wider = 1.1         -- default gap of punch and die over the thickness of the stack in contact
local nip_share = 1 / 25   -- of the punch's radius, at least
local mirrored = 0.1      -- of a ply: how far a tool from a file may be from its mirror image in a quarter
local most_plies = 50
local most_elements = 4e6
local slow = 0.05         -- kinetic energy over the work of the punch, above which a run is too fast

local in_punch, in_die = { "form", "punch." }, { "form", "die." }

local function fail(field, words) define.fail(("form: field '%s': %s"):format(field, words)) end

local function check_length(field, value)
  if value > largest then fail(field, ("expected lengths in m, got %.4g m: is it in mm? (write 50*mm)"):format(value)) end
end

local function check_tool(field, given)
  for name, value in pairs(given) do
    if type(value) == "number" and name ~= "around" and name ~= "angle" then check_length(field .. "." .. name, value) end
    if name == "size" then for _, v in ipairs(value) do check_length(field .. ".size", v) end end
  end
end

local function blank_of(t)
  if type(t.blank) == "number" then t.blank = { t.blank, t.blank } end
  if #t.blank ~= 2 then fail("blank", ("expected a side or {width, height} in m, got %s"):format(#t.blank == 1 and "1 number" or #t.blank .. " numbers")) end
  for _, side in ipairs(t.blank) do
    check_length("blank", side)
    if side <= 0 then fail("blank", ("expected positive lengths in m, got %.4g"):format(side)) end
  end
  return t.blank[1], t.blank[2]
end

-- A tool that is set off inwards (a punch: off > 0) or outwards (an opening) by what contact keeps more than cloth is thick.
local function set_off(given, off)
  local out = lists.copy(given)
  local function add(name, by) if out[name] then out[name] = out[name] + by end end
  add("radius", off)
  add("corner", off)
  add("waist", -off)
  if out.size then out.size = { out.size[1] + 2 * off, out.size[2] + 2 * off } end
  return out
end

local function set_off_edge(given, by, field, least)
  if not given.edge then return end
  given.edge = given.edge + by
  if given.edge <= least then
    fail(field .. ".edge", ("expected more than %.4g m, by which contact is thicker than the plies, got %.4g"):format(least - by, given.edge - by))
  end
end

-- Polar radius of an outline at an angle.
local function polar(points)
  local list = lists.map(points, function(p) return { math.atan(p[2], p[1]), math.sqrt(p[1] ^ 2 + p[2] ^ 2) } end)
  table.sort(list, function(a, b) return a[1] < b[1] end)
  return function(angle)
    for i = 1, #list do
      local a, b = list[i], list[i % #list + 1]
      local to, x = b[1] + (i == #list and 2 * math.pi or 0), angle
      if i == #list and angle < list[1][1] then x = angle + 2 * math.pi end
      if x >= a[1] and x <= to then return a[2] + (b[2] - a[2]) * (x - a[1]) / math.max(to - a[1], 1e-12) end
    end
    return list[1][2]
  end
end

-- The plies that fit between punch and die, checked where the tools are given by their lengths.
local function check_gap(t, plies)
  local inner, at_die = tools.outline(in_punch, t.punch, 0), polar(tools.outline(in_die, t.die, 0))
  local least, where = math.huge, nil
  for _, p in ipairs(inner) do
    local angle, r = math.atan(p[2], p[1]), math.sqrt(p[1] ^ 2 + p[2] ^ 2)
    local gap = at_die(angle) - r
    if gap < least - 1e-9 then least, where = gap, math.deg(angle) end
  end
  if least <= 0 then
    fail("die", ("the punch goes through the die: its outline is %.4g m outside of the opening at %.0f degrees from x"):format(-least, where))
  end
  if least < plies then
    fail("die", ("the nip of punch and die is thinner than the plies: expected an opening at least %.4g m wider on each side, got %.4g m at %.0f degrees from x"):format(plies, least, where))
  end
end

local function check_cover(t, width, height)
  local reach = { 0, 0 }
  for _, p in ipairs(tools.outline(in_die, t.die, t.die.edge)) do
    for i = 1, 2 do reach[i] = math.max(reach[i], math.abs(p[i] + t.die.edge * p[i + 2])) end
  end
  if width / 2 <= reach[1] or height / 2 <= reach[2] then
    fail("blank", ("it does not cover the opening of the die with its edge: expected more than {%.4g, %.4g} m, got {%.4g, %.4g}"):format(2 * reach[1], 2 * reach[2], width, height))
  end
end

-- Plies lie on the highest face of a die from a file.
local function check_lies(t, width, height)
  if not t.die.file then return check_cover(t, width, height) end
  t.flat = files.flat(t.die.tool.mesh)
  for i = -20, 20 do
    for j = -20, 20 do
      if t.flat { x = 0.0249 * i * width, y = 0.0249 * j * height } then return end
    end
  end
  fail("blank", ("no part of it lies on the highest face of the die: expected the blank, {%.4g, %.4g} m about the origin of x and y, over it"):format(width, height))
end

local function check_holder(holder)
  if not holder then return end
  if (holder.force and 1 or 0) + (holder.springs and 1 or 0) + (holder.gap and 1 or 0) ~= 1 then
    fail("holder", "expected one of force= (N), springs= (N/m) and gap= (m), got " .. ((holder.force or holder.springs) and "several" or holder.gap and "several" or "none"))
  end
  if holder.gap then check_length("holder.gap", holder.gap) end
end

local function lengths_of(shape)
  if shape == "file" then return {} end
  if tools.is_profile(shape) then return shape == "Z" and { "size", "height" } or { "size" } end
  return shape == "box" and { "size", "corner" } or shape == "double dome" and { "radius", "length", "waist" } or { "radius" }
end

local function want(field, given, names)
  for _, name in ipairs(names) do
    if given[name] == nil then fail(field .. "." .. name, ("expected a length in m for shape='%s', got none"):format(given.shape)) end
    if name == "size" and #given.size ~= 2 then
      fail(field .. ".size", ("expected {along x, along y}, got %s"):format(#given.size == 1 and "1 number" or #given.size .. " numbers"))
    end
  end
end

-- Facets of a tool as it is, before it is set off.
local function mesh_of(given, make, call)
  if given.tool then return given.tool.mesh end
  local plain = lists.copy(given)
  plain.facing, plain.outer = "up", plain.outer or given.reach
  local mesh = select(2, make(plain, call))
  return type(mesh) == "function" and mesh() or mesh
end

-- Completes a die: the edge first, on which the distance of contact depends, and then the opening, which depends on that.
local function complete(t, thick)
  local punch, die = t.punch, t.die
  if punch.shape == "file" or die.shape == "file" then
    die.edge = die.edge or rim_plies * thick
    local most = t.contact or math.max(thick, edge_share * die.edge)
    local nip, at = files.nip(mesh_of(punch, tools.punch, in_punch), mesh_of(die, tools.die, in_die), #t.stack * thick, t.stroke, 1.05 * #t.stack * most)
    if nip < #t.stack * thick then
      fail("die", ("the nip of punch and die is thinner than the plies: expected %.4g m, got %.4g m at x = %.4g, y = %.4g m"):format(#t.stack * thick, nip, at[1], at[2]))
    end
    t.contact = t.contact or math.max(thick, math.min(most, nip / (1.05 * #t.stack)))
    return
  end
  local function contact_of_edge() t.contact = t.contact or math.max(thick, edge_share * die.edge) end
  if tools.is_profile(punch.shape) then
    die.edge = die.edge or math.max(punch.edge, rim_plies * thick, (t.contact or 0) / edge_share)
    contact_of_edge()
    profile.complete(t, wider * (thick + (#t.stack - 1) * t.contact))
    return
  end
  local radius = punch.shape == "box" and math.min(punch.size[1], punch.size[2]) / 2 or punch.radius
  die.edge = die.edge or math.max(rim_share[punch.shape] * radius, rim_plies * thick, (t.contact or 0) / edge_share)
  contact_of_edge()
  if die.shape ~= punch.shape then return end
  local facets = punch.shape == "box" and 0 or radius * (1 - math.cos(math.pi / die.around)) -- the punch is round between them
  local nip = math.max(wider * (thick + (#t.stack - 1) * t.contact), nip_share * radius)
  local opening = set_off(punch, nip + facets)
  for _, name in ipairs(lengths_of(die.shape)) do die[name] = die[name] or opening[name] end
end

-- Everything about sizes, before anything is made.
local function prepare(t)
  local width, height = blank_of(t)
  t.stack = t.stack or { 0 }
  if #t.stack > most_plies then fail("stack", ("expected at most %d plies, got %d"):format(most_plies, #t.stack)) end
  local elements = t.cells ^ 2 * math.min(width, height) / math.max(width, height) * #t.stack * (t.triangles and 2 or 1)
  if elements > most_elements then
    fail("cells", ("expected at most %.2g elements in all plies, got %.3g: fewer cells along the longer side, or fewer plies"):format(most_elements, elements))
  end
  t.punch, t.die = lists.copy(t.punch), lists.copy(t.die or {})
  check_holder(t.holder)
  if t.weft_friction and not (t.friction > 0 and (t.ply_friction or t.friction) > 0) then
    fail("weft_friction", ("expected with friction and ply_friction above 0, got %.4g and %.4g"):format(t.friction, t.ply_friction or t.friction))
  end
  check_length("stroke", t.stroke)
  if t.contact then check_length("contact", t.contact) end
  check_tool("punch", t.punch)
  check_tool("die", t.die)
  if t.die.file and t.holder and not t.holder.file then fail("holder.file", "expected a file, as the die is one") end
  t.holder = t.holder and lists.copy(t.holder)
  for _, field in ipairs { "punch", "die", "holder" } do
    local given = t[field]
    if given and given.file then given.tool, given.shape = files.load(field, given, field == "die" and 1 or -1), "file" end
    if given and given.units and not given.file then fail(field .. ".units", "expected with file= alone: other lengths are in m") end
  end
  t.punch.shape = t.punch.shape or "hemisphere"
  t.die.shape = t.die.shape or (t.punch.file and "hemisphere" or t.punch.shape)
  t.die.reach = 0.75 * math.sqrt(width ^ 2 + height ^ 2)
  if (t.punch.file and tools.is_profile(t.die.shape)) or (t.die.file and tools.is_profile(t.punch.shape)) then
    fail(t.punch.file and "die.shape" or "punch.shape", "an L or Z profile goes with another of its own: expected a file, too")
  end
  t.punch.around, t.die.around = t.punch.around or 64, t.die.around or 64
  local names = lengths_of(t.punch.shape)
  if t.punch.shape == "box" or tools.is_profile(t.punch.shape) then names[#names + 1] = "edge" end
  want("punch", t.punch, names)
  if tools.is_profile(t.punch.shape) or tools.is_profile(t.die.shape) then profile.check_pair(t) end
  local thick = kernels.free_thickness(t.card)
  if t.punch.file then want("die", t.die, lengths_of(t.die.shape)) end
  complete(t, thick)
  want("die", t.die, lengths_of(t.die.shape))
  tools.check_fields(in_punch, t.punch, "punch")
  tools.check_fields(in_die, t.die, "die")
  if t.contact < thick then
    fail("contact", ("the plies would start inside each other: expected at least their thickness, %.4g m, got %.4g"):format(thick, t.contact))
  end
  local off = (t.contact - thick) / 2
  if t.punch.radius and t.punch.radius <= off then
    fail("punch.radius", ("expected more than %.4g m, by which contact is thicker than the plies, got %.4g"):format(off, t.punch.radius))
  end
  if t.punch.file or t.die.file then
    check_lies(t, width, height)
  elseif tools.is_profile(t.punch.shape) then
    profile.check(t, #t.stack * thick, width, height)
  else
    check_gap(t, #t.stack * thick)
    check_cover(t, width, height)
  end
  local deepest = t.punch.file and t.punch.tool.height or tools.is_profile(t.punch.shape) and t.punch.height or t.punch.shape == "box" and (t.punch.height or math.min(t.punch.size[1], t.punch.size[2])) or t.punch.shape == "double dome" and t.punch.radius
      or t.punch.radius + (t.punch.height or t.punch.radius)
  if t.stroke > deepest then fail("stroke", ("expected at most the height of the punch, %.4g m, got %.4g"):format(deepest, t.stroke)) end
  if t.holder and t.holder.gap and t.holder.gap < #t.stack * thick / 2 then
    fail("holder.gap", ("the plies, %.4g m thick, would be pressed to less than half: expected more than %.4g m, got %.4g"):format(#t.stack * thick, #t.stack * thick / 2, t.holder.gap))
  end
  if t.quarter then
    if tools.is_profile(t.punch.shape) then fail("quarter", ("an %s profile is not symmetric about x = 0: expected the whole"):format(t.punch.shape)) end
    for _, field in ipairs { "punch", "die", "holder" } do
      if t[field] and t[field].tool then files.check_quarter(field, t[field].tool, mirrored * thick) end
    end
    for _, angle in ipairs(t.stack) do
      if angle % 90 ~= 0 then fail("quarter", ("a quarter stands for the whole where yarns run along x and y: expected angles of 0 and 90 degrees, got %.4g"):format(angle)) end
    end
  end
  return width, height, thick
end

local function name_of(t, ply) return #t.stack == 1 and "all" or "ply" .. ply end

-- Cuts the cells of a rectangle in two, along the diagonal that goes around the origin: from the first node of both triangles to another.
-- Over the die's rim and in front of it a ply bends about lines that go around the punch, and its cells become longer away from it. So they
-- fold along a side and keep their shape, where triangles with a side away from the punch resist that with their yarns.
local function cut_around(mesh)
  local nodes, elements = {}, {}
  for i, p in ipairs(mesh.nodes) do nodes[i] = { p[1], p[2], p[3] } end
  for _, e in ipairs(mesh.elements) do
    local p, q = nodes[e[1]], nodes[e[3]]
    local from = (p[1] + q[1]) * (p[2] + q[2]) > 0 and 2 or 1
    local a, b, c, d = e[from], e[from + 1], e[(from + 1) % 4 + 1], e[(from + 2) % 4 + 1]
    elements[#elements + 1] = { a, b, c }
    elements[#elements + 1] = { a, c, d }
  end
  local cut = fabric.mesh { nodes = nodes, elements = elements }
  for _, side in ipairs { "left", "right", "bottom", "top" } do cut:set(side, mesh:set(side)) end
  return cut
end

local function plies_of(t, width, height)
  local nx = math.max(2, math.floor(t.cells * width / math.max(width, height) + 0.5))
  local ny = math.max(2, math.floor(t.cells * height / math.max(width, height) + 0.5))
  local bodies = {}
  for k, angle in ipairs(t.stack) do
    local share = t.quarter and 0.5 or 1
    local mesh = fabric.mesh.rectangle { width = width * share, height = height * share, nx = nx, ny = ny,
                                         origin = t.quarter and { 0, 0, 0 } or { -width / 2, -height / 2, 0 } }
    if t.triangles then mesh = cut_around(mesh) end
    mesh:map(function(x, y) return x, y, (k - 1) * t.contact end)
    bodies[k] = { name = "ply" .. k, mesh = mesh, card = t.card, warp = angle }
  end
  local h = width / nx * (t.quarter and 0.5 or 1)
  if h > 1.5 * t.die.edge then
    fabric.warn(("form: elements of %.3g mm on an edge of %.3g mm follow it roughly: punch force and draw-in go up and down by the element (cells=%.0f would follow it)"):format(
      h / mm, t.die.edge / mm, math.ceil(t.cells * h / (1.5 * t.die.edge))))
  end
  return bodies
end

-- Holder over the plies; its force and its mass are those of the part in the model.
local function add_holder(t, m, top, ramp, mass, share)
  local h = t.holder
  if not h then return end
  local given = lists.copy(t.die_body)
  given.facing, given.name = "down", "holder"
  local thick = kernels.free_thickness(t.card)
  local z = top + t.contact / 2 + (h.gap and h.gap - #t.stack * thick or 0)
  given.at = { tools.is_profile(t.punch.shape) and profile.holder_place(t) or 0, 0, z }
  if not h.gap then given.mass = (h.mass or heavy * mass / share) * share end
  local body = h.file and files.body(h.tool, z, "holder", given.mass) or tools.die(given, in_die)
  if h.gap then return body end
  m:fix(body, "x y rotation"):damper(body, { z = 2000 * given.mass })
  if h.force then
    m:force(body, { z = function(time) return -h.force * share * ramp(time) end })
  else
    m:spring(body, { z = h.springs * share })
  end
  return body
end

local function setup(t)
  local width, height, thick = prepare(t)
  local share = t.quarter and 0.25 or 1
  local off = (t.contact - thick) / 2
  local bodies = plies_of(t, width, height)
  local m = #bodies == 1 and fabric.model { mesh = bodies[1].mesh, card = t.card, warp = t.stack[1], points = t.points } or fabric.model { bodies = bodies }
  local top = (#bodies - 1) * t.contact
  t.speed = t.speed or 2
  local duration = 1.5 * t.stroke / t.speed / (1 - settles)
  local closes = settles * duration
  local function ramp(time)
    local s = math.min(1, time / closes)
    return s * s * (3 - 2 * s)
  end
  local function way(time)
    local s = math.max(0, time - closes) / (duration - closes)
    return t.stroke * s * s * (3 - 2 * s)
  end
  local punch, die = set_off(t.punch, -off), set_off(t.die, off)
  set_off_edge(punch, -off, "punch", 0)
  if not t.die.file then set_off_edge(die, -off, "die", 0) end
  punch.name, die.name, die.facing = "punch", "die", "up"
  punch.at, die.at = { 0, 0, top + t.contact / 2 }, { 0, 0, -t.contact / 2 }
  die.outer = die.outer or t.die.reach
  if tools.is_profile(t.punch.shape) then
    die.at[1] = profile.die_place(t, off)
    punch.at[1] = die.at[1] + profile.punch_place(t, off, top)
  end
  t.die_body = die
  punch = t.punch.file and files.body(t.punch.tool, punch.at[3], "punch") or tools.punch(punch, in_punch)
  die = t.die.file and files.body(t.die.tool, die.at[3], "die") or tools.die(die, in_die)
  m:move(punch, { z = function(time) return -way(time) end })
  local mass = width * height * share * t.card.density * t.card.thickness * #bodies
  local holder = add_holder(t, m, top, ramp, mass, share)
  local function touch(a, b, friction, settle)
    local by_direction = t.weft_friction and { warp = friction, weft = t.weft_friction }
    m:contact { between = { a, b }, friction = by_direction or friction, film = t.film, thickness = t.contact, settle = settle, stiffness = t.stiffness or 2 * bears / t.contact }
  end
  touch(die, name_of(t, 1), t.friction)
  touch(punch, name_of(t, #bodies), t.friction)
  if holder then touch(holder, name_of(t, #bodies), t.friction, t.holder.gap and t.holder.gap < #bodies * thick and closes or nil) end
  for k = 2, #bodies do touch("ply" .. k - 1, "ply" .. k, t.ply_friction or t.friction) end
  if t.quarter then
    for k = 1, #bodies do
      local prefix = #bodies == 1 and "" or "ply" .. k .. "."
      m:symmetry(prefix .. "left", "x"):symmetry(prefix .. "bottom", "y")
    end
  end
  return { model = m, bodies = bodies, punch = punch, die = die, holder = holder, duration = duration, way = way, closes = closes, share = share, thick = thick, width = width, height = height }
end

-- --- results

-- Numbers of the first node and element of each ply.
local function offsets(s)
  local out, node, element = {}, 0, 0
  for k, body in ipairs(s.bodies) do
    out[k] = { node = node, element = element, mesh = body.mesh }
    node, element = node + #body.mesh.nodes, element + #body.mesh.elements
  end
  return out
end

-- The two triangles of a cell have its sides along the yarns, and shear as it does, so that their angles are those at its middle.
local function places_of(t, nodes, i)
  if not t.triangles then return nodes end
  return { nodes[1], nodes[i % 2 == 1 and 3 or 2] }
end

local function angles(t, s, a)
  local field, list, most = a:field "shear_angle", { max = 0 }, 0
  local warp, weft = a:field "warp", a:field "weft"
  for k, o in ipairs(offsets(s)) do
    for i, nodes in ipairs(o.mesh.elements) do
      local row = { ply = k, X = 0, Y = 0, x = 0, y = 0, z = 0, angle = field[o.element + i], warp = warp[o.element + i], weft = weft[o.element + i] }
      local around = places_of(t, nodes, i)
      for _, n in ipairs(around) do
        local p, X = a:node(o.node + n), o.mesh.nodes[n]
        row.X, row.Y = row.X + X[1] / #around, row.Y + X[2] / #around
        row.x, row.y, row.z = row.x + p.x / #around, row.y + p.y / #around, row.z + p.z / #around
      end
      list[#list + 1] = row
      if math.abs(row.angle) > most then most, list.max, list.place = math.abs(row.angle), math.abs(row.angle), row end
    end
  end
  return list
end

-- Writes each formed ply with its yarns for the next program.
local function write_plies(t, s, a, list)
  local files, first = {}, 0
  for k, o in ipairs(offsets(s)) do
    local places, rows = {}, {}
    for i = 1, #o.mesh.nodes do
      local p = a:node(o.node + i)
      places[i] = { p.x, p.y, p.z }
    end
    table.move(list, first + 1, first + #o.mesh.elements, 1, rows)
    first = first + #rows
    for _, file in ipairs(yarns.write(t.out, "ply" .. k, o.mesh, places, rows)) do files[#files + 1] = file end
  end
  return files
end

local edges = { left = { 1, 1 }, right = { 1, -1 }, bottom = { 2, 1 }, top = { 2, -1 } }

-- How far the nodes of each free edge have come inwards, across the edge.
local function draw_in(t, s, a)
  local list = { max = 0, mean = 0 }
  for k, o in ipairs(offsets(s)) do
    for name, how in pairs(edges) do
      if not (t.quarter and (name == "left" or name == "bottom")) then
        local sum, nodes = 0, o.mesh:set(name)
        for _, n in ipairs(nodes) do
          local p = a:node(o.node + n)
          local moved = how[2] * (how[1] == 1 and p.ux or p.uy)
          list[#list + 1] = { ply = k, edge = name, X = p.X, Y = p.Y, draw_in = moved }
          sum, list.max = sum + moved / #nodes, math.max(list.max, moved)
        end
        list[name] = list[name] or sum
      end
    end
  end
  table.sort(list, function(p, q)
    if p.ply ~= q.ply then return p.ply < q.ply end
    if p.edge ~= q.edge then return p.edge < q.edge end
    return p.X + p.Y < q.X + q.Y
  end)
  local sum, count = 0, 0
  for name in pairs(edges) do if list[name] then sum, count = sum + list[name], count + 1 end end
  list.mean = sum / count
  return list
end

local function beyond_opening(t)
  local reach = 0
  for _, p in ipairs(tools.outline(in_die, t.die, t.die.edge)) do
    reach = math.max(reach, math.sqrt((p[1] + t.die.edge * p[3]) ^ 2 + (p[2] + t.die.edge * p[4]) ^ 2))
  end
  return function(p) return p.x ^ 2 + p.y ^ 2 > reach ^ 2 end
end

-- How far plies rise from the die where it is flat.
local function wrinkles(t, s, a)
  local flat = t.flat or tools.is_profile(t.punch.shape) and profile.flat(t) or beyond_opening(t)
  local out = { height = 0 }
  for k, o in ipairs(offsets(s)) do
    for i = 1, #o.mesh.nodes do
      local p = a:node(o.node + i)
      local height = p.z - (k - 1) * t.contact
      if flat(p) and height > out.height then out.height, out.x, out.y, out.ply = height, p.x, p.y, k end
    end
  end
  return out
end

local function report_of(r, t)
  local last = r.curve[#r.curve]
  local lines = {
    ("forming of %d %s of %s, %s, stroke %.4g mm, friction %.3g"):format(#t.stack, #t.stack == 1 and "ply" or "plies", t.card.name, t.punch.file or t.punch.shape, last.stroke / mm, t.friction),
    ("  punch force     %.4g N at the end, %.4g N at most"):format(last.force, r.peak),
    ("  shear angle     %.3g degrees at most"):format(r.angles.max),
    ("  draw-in         %.3g mm in the mean of the edges, %.3g mm at most"):format(r.draw_in.mean / mm, r.draw_in.max / mm),
    ("  wrinkles        %.3g mm above the die"):format(r.wrinkles.height / mm),
    ("  work            %.4g J: stored %.3g, lost by yarns %.3g, friction %.3g, damping and impact %.3g, kinetic %.2g"):format(
      last.external, last.stored, last.dissipated - last.friction - last.impact, last.friction, last.damping + last.impact, last.kinetic),
  }
  return table.concat(lines, "\n")
end

local function run(t)
  local s = setup(t)
  local rate = t.damping or 3 / s.duration
  local a = fabric.dynamic { model = s.model, duration = s.duration, damping = { mass = rate }, ledger_limit = t.ledger_limit }
  local every = s.duration / t.rows
  local names = { "stroke", "force", "holder", "die", "kinetic", "stored", "dissipated", "friction", "impact", "damping", "external", "error" }
  local function reading(run)
    local function up(body) return body and select(3, run:reaction(body)) / s.share or 0 end
    local e = run.energy
    local row = { stroke = s.way(run.time), force = -up(s.punch), holder = -up(s.holder), die = up(s.die), error = e.error }
    for _, name in ipairs { "kinetic", "stored", "dissipated", "friction", "impact", "damping", "external" } do row[name] = e[name] / s.share end
    return row
  end
  local curve, complete = sheet.observe(a, names, t.out, "form", reading, every, t.state)
  if t.prepare then t.prepare(a) end
  local done, trouble = pcall(a.solve, a)
  if not done and not (type(trouble) == "table" and trouble.kind == "numerical") then error(trouble, 0) end
  local r = { curve = curve, analysis = a, model = s.model, punch = s.punch, die = s.die, holder = s.holder, peak = 0, trouble = not done and trouble or nil,
              contact = t.contact, series = t.out and t.out .. "/form.pvd" or nil }
  complete()
  if #curve == 0 then curve[1] = reading(a) end -- a finished run that was taken up
  sheet.is_whole(a, curve, every, "form")
  for _, row in ipairs(curve) do r.peak = math.max(r.peak, row.force) end
  r.angles, r.draw_in, r.wrinkles = angles(t, s, a), draw_in(t, s, a), wrinkles(t, s, a)
  local last = curve[#curve]
  r.stroke = last.stroke
  r.report = report_of(r, t)
  if not done then fabric.warn(("form: the run ended at %.3g of %.3g mm: %s"):format(last.stroke / mm, t.stroke / mm, tostring(trouble))) end
  local fastest = 0
  for _, row in ipairs(curve) do if row.stroke > 0.2 * t.stroke then fastest = math.max(fastest, row.kinetic / math.max(row.external, 1e-12)) end end
  if fastest > slow then
    fabric.warn(("form: the kinetic energy is up to %.2g of the work: inertia is part of the forces (speed=%.3g m/s; a slower punch has less of it)"):format(fastest, t.speed))
  end
  if t.out then
    r.files = write_plies(t, s, a, r.angles)
    fabric.plot { file = t.out .. "/force.svg", rows = curve, x = "stroke", y = "force" }
  end
  return r
end

local function with_file(rows) return lists.joined(rows, files.rows) end

define {
  name = "fabric.lab.form",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric of all plies" },
    { name = "stack", kind = "numbers", unit = "degrees", optional = true, sentence = "{lowest, ..., upmost}: warp of each ply from x, default {0}" },
    { name = "blank", kind = "number|numbers", unit = "m", above = 0, sentence = "side of a square, or {along x, along y}" },
    { name = "punch", kind = "fields", rows = with_file(tools.punch_rows), sentence = "the arguments of fabric.rigid.punch: { radius= }, { shape='box', size=, corner=, edge= }, { shape='double dome', radius=, length=, waist= }, { shape='L', size=, edge= }, { shape='Z', size=, edge=, height= }; or { file=, units= }" },
    { name = "die", kind = "fields", optional = true, sentence = "of fabric.rigid.die: { radius=, edge= }, ...; lengths of the opening that are left out: those of a punch of the same shape, wider on each side by 1.1 times the thickness of the stack in contact, at least a twenty-fifth of the punch's radius; of L and Z { edge=, gap= }; or { file=, units=, edge= }, edge being the least radius of its rim",
      rows = with_file(tools.die_rows("of the opening; default that of the punch",
        "radius of the rounded edge of the opening; default the larger of a sixth of the punch's radius (of a box: a sixth of the shorter side; of L and Z the edge of the punch) and ten times the thickness of a ply; where contact= is given, at least five times that",
        "radius of the round outside of die and holder; default 0.75 times the diagonal of the blank")) },
    { name = "holder", kind = "fields", optional = true, sentence = "{ force=N }, { springs=N/m } or { gap=m }, with file= and units= where the die is a file; without it none",
      rows = with_file {
        { name = "force", kind = "number", unit = "N", above = 0, high = 1e7, optional = true, sentence = "that presses it on the plies" },
        { name = "springs", kind = "number", unit = "N/m", above = 0, high = 1e10, optional = true, sentence = "stiffness of all springs that hold it down" },
        { name = "gap", kind = "number", unit = "m", above = 0, optional = true, sentence = "from die to holder, which stands" },
        { name = "mass", kind = "number", unit = "kg", low = 1e-6, high = 1e6, optional = true, sentence = "of the plate; default four times that of the plies" },
      } },
    { name = "friction", kind = "number", low = 0, default = 0.2, sentence = "of tools and plies" },
    { name = "ply_friction", kind = "number", low = 0, optional = true, sentence = "of plies on each other; default that of the tools" },
    { name = "weft_friction", kind = "number", above = 0, optional = true, sentence = "friction across the warp, that along it being friction and ply_friction; of two plies the warp is that of the lower one" },
    { name = "film", kind = "fields", optional = true, rows = {
      { name = "viscosity", kind = "number", unit = "Pa s", above = 0, sentence = "of what is between plies, and between them and the tools: a hot matrix" },
      { name = "thickness", kind = "number", unit = "m", above = 0, high = 1, sentence = "of it" },
      { name = "speed", kind = "number", unit = "m/s", above = 0, optional = true, sentence = "of sliding from which the viscosity falls; default: it stays" },
      { name = "exponent", kind = "number", above = 0, high = 1, optional = true, sentence = "of the speed in the traction far above that" },
    }, sentence = "resists sliding beside friction, as film of model:contact: give the viscosity times the real speed of the punch over that of the run, and the speed over that" },
    { name = "stroke", kind = "number", unit = "m", above = 0, sentence = "way of the punch from first contact" },
    { name = "cells", kind = "integer", low = 4, high = 1000, default = 32, sentence = "elements along the longer side (of a quarter: of its own)" },
    { name = "triangles", kind = "boolean", default = false, sentence = "elements of three nodes, cells of the blank cut along the diagonal that goes around the punch" },
    { name = "quarter", kind = "boolean", default = false, sentence = "only x > 0, y > 0, between planes of symmetry; forces and energies are those of the whole" },
    { name = "speed", kind = "number", unit = "m/s", above = 0, optional = true, sentence = "largest speed of the punch, default 2" },
    { name = "contact", kind = "number", unit = "m", above = 0, optional = true, sentence = "thickness of a ply in contact; default a fifth of the die's edge, or that of the card" },
    { name = "stiffness", kind = "number", unit = "Pa/m", above = 0, optional = true, sentence = "of contact; default what carries 6 MPa, which tight yarns press on the die's edge" },
    { name = "points", kind = "integer", low = 1, high = 9, default = 1, sentence = "through the thickness of a single ply" },
    { name = "damping", kind = "number", unit = "1/s", low = 0, optional = true, sentence = "of motion, as damping.mass of fabric.dynamic; default 3 over the duration" },
    { name = "rows", kind = "integer", low = 2, high = 10000, default = 50, sentence = "of the curve" },
    { name = "out", kind = "text", optional = true, sentence = "folder for curve.csv, force.svg, the VTK series, whose fields warp and weft are the directions of the yarns, and the formed plies with their yarns for Abaqus and CalculiX (ply1.inp) and OpenRadioss (ply1.rad)" },
    { name = "ledger_limit", kind = "number", above = 0, default = 0.05, sentence = "as for fabric.dynamic" },
    { name = "prepare", kind = "function", optional = true, sentence = "prepare(analysis), called before it runs" },
    { name = "state", kind = "table", optional = true,
      sentence = "an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it" },
  },
  sentence = "Plies are pressed through the opening of a die by a punch, under a blank holder. Returns curve (a list of stroke, force of punch, holder and die, N, and energies), "
    .. "angles (of each element ply, X, Y flat, x, y, z formed, its shear angle, degrees, and the unit vectors warp and weft; max and place), draw_in (of each node of the edges ply, edge, X, Y, draw_in, m; "
    .. "max, mean, left, right, bottom, top), wrinkles (height above the flat of the die, m, x, y, ply), report (text), peak (N), stroke (m, reached), series (VTK) and files (of the formed plies) with out=, analysis, model, punch, die, holder, "
    .. "and trouble where the run stopped.",
  example = "local mm = fabric.units.mm\n"
    .. "local test = fabric.lab.form{ card=fabric.card('blend', { bending='estimated' }), blank=60*mm, punch={ radius=12*mm }, die={ radius=15*mm, edge=5*mm },\n"
    .. "  holder={ force=20 }, stroke=3*mm, cells=12, speed=10, rows=10 }\nassert(test.peak > 0 and #test.angles == 144)",
  run = run,
}
