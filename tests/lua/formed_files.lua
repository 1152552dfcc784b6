-- Forming with tools from STL files: normals of both senses, units, the same answer as tools of lengths, a stranger's V block, and what is refused.
local fabric = require "fabric"
local mm = fabric.units.mm

local function near(name, got, want, relative) assert(math.abs(got - want) <= relative * math.abs(want), string.format("%s: expected %.6g, got %.6g", name, want, got)) end
local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))

-- Facets as text, every third of the wrong sense; lengths times `scale`.
local function stl(name, facets, scale)
  local lines = { "solid " .. name }
  for i, f in ipairs(facets) do
    lines[#lines + 1] = "facet normal 0 0 0\nouter loop"
    for k = 1, 3 do
      local p = f[i % 3 == 0 and 4 - k or k]
      lines[#lines + 1] = ("vertex %.9g %.9g %.9g"):format(scale * p[1], scale * p[2], scale * p[3])
    end
    lines[#lines + 1] = "endloop\nendfacet"
  end
  lines[#lines + 1] = "endsolid " .. name .. "\n"
  return fabric.write(folder .. "/" .. name .. ".stl", table.concat(lines, "\n")) or folder .. "/" .. name .. ".stl"
end

-- Turned about z: {r, z} from the axis, or once around a section of a ring.
local function turned(rz, n, closed)
  local facets = {}
  local function at(k, i)
    local a, p = 2 * math.pi * i / n, rz[(k - 1) % #rz + 1]
    return { p[1] * math.cos(a), p[1] * math.sin(a), p[2] }
  end
  for k = 1, closed and #rz or #rz - 1 do
    for i = 1, n do
      local a, b, c, d = at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i)
      if rz[k][1] > 0 then facets[#facets + 1] = { a, b, c } end
      if rz[k % #rz + 1][1] > 0 then facets[#facets + 1] = { a, c, d } end
    end
  end
  return facets
end

local round, opening = {}, {}
for k = 0, 12 do
  local a = math.pi / 2 * k / 12
  round[#round + 1] = { k == 0 and 0 or 12 * math.sin(a), 40 - 12 * math.cos(a) }
end
round[#round + 1] = { 12, 52 }
round[#round + 1] = { 0, 52 }
opening[1] = { 15, -10 }
for k = 0, 8 do
  local a = math.pi / 2 * k / 8
  opening[#opening + 1] = { 15 + 5 * (1 - math.cos(a)), -5 * (1 - math.sin(a)) }
end
opening[#opening + 1] = { 65, 0 }
opening[#opening + 1] = { 65, -10 }
local plate = { { 20, 3 }, { 65, 3 }, { 65, 6 }, { 20, 6 } }

local punch, die = stl("punch", turned(round, 48), 1), stl("die", turned(opening, 48, true), 1)
local holder = stl("holder", turned(plate, 48, true), 1 / 25.4)

local function form(more)
  local t = { card = fabric.card("blend", { bending = "estimated" }), blank = 60 * mm, punch = { file = punch, units = "mm" }, die = { file = die, units = "mm", edge = 5 * mm },
              holder = { file = holder, units = "inch", force = 20 }, stroke = 4 * mm, cells = 12, speed = 8, rows = 8 }
  for k, v in pairs(more or {}) do t[k] = v end
  return fabric.lab.form(t)
end

-- Files and lengths tell the same tools; those from files are not set off by what contact is thicker than the ply.
local filed, quarter = form(), form { quarter = true, cells = 6 }
local told = form { quarter = true, cells = 6, punch = { radius = 12 * mm }, die = { radius = 15 * mm, edge = 5 * mm }, holder = { force = 20 }, contact = filed.contact }
assert(not filed.trouble and filed.curve[#filed.curve].error < 1e-2)
near("shear with tools from files", quarter.angles.max, told.angles.max, 0.1)
near("draw-in with tools from files", quarter.draw_in.max, told.draw_in.max, 0.15)
near("work with tools from files", quarter.curve[#quarter.curve].external, told.curve[#told.curve].external, 0.15)
assert(filed.wrinkles.height < 0.2 * mm)

-- A quarter of it, since the tools are symmetric.
near("shear of a quarter", quarter.angles.max, filed.angles.max, 0.02)
near("draw-in of a quarter", quarter.draw_in.max, filed.draw_in.max, 0.03)
near("work of a quarter", quarter.curve[#quarter.curve].external, filed.curve[#filed.curve].external, 0.01)

-- A punch from a file in a die of lengths, and the other way round.
local mixed = form { die = { radius = 15 * mm, edge = 5 * mm }, holder = { force = 20 }, stroke = 1 * mm }
local other = form { punch = { radius = 12 * mm }, stroke = 1 * mm }
near("work of mixed tools", mixed.curve[#mixed.curve].external, other.curve[#other.curve].external, 0.3)
assert(math.abs(mixed.draw_in.max - other.draw_in.max) < 1e-3 * mm) -- some 0.05 um: the rim has hardly moved yet

-- A stranger's V block and its punch, faces alone, in cm: the ply comes to the sides, which fall by 45 degrees, and follows the round nose.
local function face(points)
  local facets = {}
  for i = 1, #points - 1 do
    local a, b = points[i], points[i + 1]
    local corners = { { a[1], -3, a[2] }, { b[1], -3, b[2] }, { b[1], 3, b[2] }, { a[1], 3, a[2] } }
    facets[#facets + 1] = { corners[1], corners[2], corners[3] }
    facets[#facets + 1] = { corners[1], corners[3], corners[4] }
  end
  return facets
end
do
  local r, nose, block = 0.5, {}, { { -4, 0 } }
  for k = 0, 6 do
    local a = math.pi / 4 * k / 6
    block[#block + 1] = { -2.2 + r * math.sin(a), -r * (1 - math.cos(a)) }
  end
  local last = block[#block]
  block[#block + 1] = { 0, last[1] + last[2] }
  for i = #block - 1, 1, -1 do block[#block + 1] = { -block[i][1], block[i][2] } end
  for k = -6, 6 do nose[#nose + 1] = { r * math.sin(math.pi / 4 * k / 6), r * (1 - math.cos(math.pi / 4 * k / 6)) } end
  local side = nose[#nose]
  table.insert(nose, { side[1] + 2, side[2] + 2 })
  table.insert(nose, 1, { -side[1] - 2, side[2] + 2 })
  local t = { blank = { 60 * mm, 12 * mm }, punch = { file = stl("nose", face(nose), 1), units = "cm" }, die = { file = stl("block", face(block), 1), units = "cm", edge = 5 * mm },
              stroke = 15 * mm, cells = 16, speed = 4, card = fabric.card("blend", { bending = "estimated" }), rows = 4 }
  local v = fabric.lab.form(t)
  assert(not v.trouble and v.report:find("nose.stl", 1, true) and v.curve[#v.curve].error < 1e-3)
  local lowest = 0
  for _, row in ipairs(v.angles) do lowest = math.min(lowest, row.z) end
  near("depth of the ply under the nose", lowest, -15 * mm, 0.06)
  t.stroke = 18 * mm
  local ok, why = pcall(fabric.lab.form, t)
  assert(not ok and tostring(why):find("thinner than the plies", 1, true), tostring(why))
end

local function refused(words, more)
  local ok, why = pcall(form, more)
  assert(not ok and tostring(why):find(words, 1, true), tostring(why))
end
refused("form: field 'punch.units': expected 'm', 'cm', 'mm' or 'inch' beside file='" .. punch .. "', which says none", { punch = { file = punch } })
refused("form: field 'punch.units': expected 'm' or 'cm' or 'mm' or 'inch', got 'feet'", { punch = { file = punch, units = "feet" } })
refused("form: field 'die.units': the tool would be 130 m long, expected 0.001 to 5 m: is '" .. die .. "' in mm?", { die = { file = die, units = "m" } })
refused("form: field 'punch.radius': expected none beside file=, whose shape it is", { punch = { file = punch, units = "mm", radius = 0.01 } })
refused("form: field 'holder.file': expected a file, as the die is one", { holder = { force = 10 } })
local beside = {}
for i, f in ipairs(turned(round, 48)) do
  beside[i] = {}
  for k, q in ipairs(f) do beside[i][k] = { q[1], q[2] + 0.4, q[3] } end
end
refused("form: field 'quarter': the punch is not symmetric about y = 0: expected the mirror image of x = ", { quarter = true, punch = { file = stl("beside", beside, 1), units = "mm" } })
refused("none.stl", { punch = { file = folder .. "/none.stl", units = "mm" } })
refused("form: field 'die': the punch goes through the die at the end of the stroke, at x = ", { punch = { file = stl("wide", turned({ { 0, 0 }, { 17, 0 }, { 17, 30 }, { 0, 30 } }, 48), 1), units = "mm" } })
refused("form: field 'die': the nip of punch and die is thinner than the plies: expected 0.00038 m, got 0.0001",
  { punch = { file = stl("tight", turned({ { 0, 0 }, { 14.8, 0 }, { 14.8, 30 }, { 0, 30 } }, 48), 1), units = "mm" }, stroke = 12 * mm })
refused("form: field 'die.shape': an L or Z profile goes with another of its own: expected a file, too", { die = { shape = "L", edge = 5 * mm } })
refused("form: field 'stroke': expected at most the height of the punch, 0.024 m, got 0.03", { stroke = 30 * mm })
refused("form: field 'holder.units': expected with file= alone: other lengths are in m", { die = { radius = 15 * mm, edge = 5 * mm }, holder = { units = "mm", force = 10 } })
os.execute("rm -r " .. folder)
print "formed_files ok"
