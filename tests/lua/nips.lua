-- Tools that are held or driven, and press the cloth between them from the start: said before the run with the gap, the thickness, the pressure of the
-- law, and what to do. Nothing is said of a gap that fits, and of a tool that a force places.
-- warns: whose places are given
local fabric = require "fabric"
local mm = fabric.units.mm

-- Plies between a floor and a plate that are `gap` apart, mm, with contact of 0.4 mm a ply and 1e9 Pa/m.
local function told(arguments)
  local gap, plies = arguments.gap * mm, arguments.plies or 1
  local card, bodies, sets = fabric.card("blend", { bending = "estimated" }), {}, {}
  for i = 1, plies do
    local mesh = fabric.mesh.rectangle { width = 40 * mm, height = 30 * mm, nx = 4, ny = 3, triangles = arguments.triangles }
    mesh:map(function(x, y) return x, y, gap * (i - 0.5) / plies end)
    bodies[i] = { name = "ply" .. i, mesh = mesh, card = card, warp = 0 }
    sets[i] = "ply" .. i .. ".all"
  end
  local m = fabric.model { bodies = bodies }
  local floor = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 }, name = "floor" }
  local plate = fabric.rigid.disc { centre = { 0.02, 0.015, gap + 1 * mm }, normal = { 0, 0, 1 }, radius = 0.05, edge = 1 * mm, mass = arguments.free and 0.01, name = "plate" }
  local law = { thickness = 0.4 * mm, stiffness = 1e9, settle = 1e-3 }
  local function meet(between)
    m:contact { between = between, thickness = law.thickness, stiffness = law.stiffness, settle = law.settle }
  end
  meet { floor, sets[1] }
  meet { plate, sets[plies] }
  if plies > 1 then meet(sets) end
  if arguments.free then m:fix(plate, "x y rotation"):force(plate, { z = -1 }) end
  local scheme = arguments.scheme
  local a = scheme == "static" and fabric.static { model = m, duration = 1 } or fabric.dynamic { model = m, duration = 1e-2, scheme = scheme }
  local words = {}
  for _, w in ipairs(a.warnings) do
    if w.code == "nip" then words[#words + 1] = (w.serious and "serious: " or "") .. w.text end
  end
  return table.concat(words, "\n")
end
local function words(kind, node, gap, plies, thickness, what)
  return ("%s: at node %d the floor and the plate, whose places are given, are %s m apart, and %s %s m in contact: %s; a gap of at least %s m, or m:force on one of them in place of a gap, does not do that"):format(kind, node, gap, plies, thickness, what, thickness)
end
-- 1e9 Pa/m times the depth of 50 um less a tenth of the range of 125.3 um.
local of_one, law = "the cloth between them needs", "by the law of contact the pressure is %s Pa from the start"
local squares = told { gap = 0.3 }
for _, case in ipairs {
  { squares, words("dynamic", 14, "0.0003", of_one, "0.0004", law:format "3.7e+04") },
  { told { gap = 0.3, triangles = true, scheme = "implicit" }, squares },
  { told { gap = 0.3, scheme = "static" }, (squares:gsub("dynamic", "static")) },
  { told { gap = 0.5, plies = 2 }, words("dynamic", 24, "0.0005", "2 plies between them need", "0.0008", law:format "8.4e+04" .. ", of which 8.1e+04 Pa are carried before its barrier") },
  { told { gap = 0.96, plies = 3 }, words("dynamic", 44, "0.00096", "3 plies between them need", "0.0012", law:format "4.1e+04") },
  { told { gap = 0.02 }, "serious: " .. words("dynamic", 19, "2e-05", of_one, "0.0004", "less than the 0.000149 m that contact allows at least, so that no pressure holds it there") },
  { told { gap = 0.4 }, "" },
  { told { gap = 0.3, free = true }, "" },
} do
  assert(case[1] == case[2], case[1] .. "\nexpected\n" .. case[2])
end
print "nips ok"
