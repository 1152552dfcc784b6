-- Frequent mistakes with patterns, seams and bodies, and their messages: each is refused before anything is computed, with the place and what was expected.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.card("blend", { bending = "estimated" })
local count = 0
local function refused(mistake, words, f, ...)
  count = count + 1
  local ok, why = pcall(f, ...)
  assert(not ok, mistake .. ": nothing is said")
  assert(tostring(why):find(words, 1, true), ("%s: expected '%s', got %s"):format(mistake, words, why))
end
local function panel(t) return fabric.mesh.panel { size = 10 * mm, outline = t } end
local function file_of(text, ending)
  local name = os.tmpname() .. ending
  local file <close> = assert(io.open(name, "w"))
  file:write(text)
  return name
end

-- --- outlines
refused("an outline that crosses itself", "piece 1 crosses or touches piece 3 near (0.06, 0.06)", panel, { { 0, 0 }, { 0.1, 0.1 }, { 0.1, 0 }, { 0, 0.15 } })
refused("an outline that is nearly closed", "open: it ends at (0, 0.002), 0.002 m from its start", panel, { { 0, 0 }, { 0.1, 0 }, { 0.1, 0.1 }, { 0, 0.002 } })
refused("an outline in millimetres", "elements", panel, { { 0, 0 }, { 300, 0 }, { 300, 400 }, { 0, 400 } })

-- --- pattern files: a square of two by two, on layer 1 of a block
local function dxf(unit, grain)
  local lines = {}
  local function put(...) for _, word in ipairs { ... } do lines[#lines + 1] = tostring(word) end end
  put(0, "SECTION", 2, "HEADER")
  if unit then put(9, "$INSUNITS", 70, unit) end
  put(0, "ENDSEC", 0, "SECTION", 2, "BLOCKS", 0, "BLOCK", 8, "1", 2, "FRONT", 70, 0, 10, 0, 20, 0)
  put(0, "POLYLINE", 8, "1", 66, 1, 70, 1)
  for _, p in ipairs { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } } do put(0, "VERTEX", 8, "1", 10, p[1], 20, p[2]) end
  put(0, "SEQEND", 8, "1")
  if grain then put(0, "LINE", 8, "7", 10, 1, 20, 0.5, 11, 1, 21, 1.5) end
  put(0, "ENDBLK", 8, "1", 0, "ENDSEC", 0, "SECTION", 2, "ENTITIES", 0, "INSERT", 8, "1", 2, "FRONT", 10, 0, 20, 0, 0, "ENDSEC", 0, "EOF")
  return file_of(table.concat(lines, "\n") .. "\n", ".dxf")
end
local inches = dxf(1, true)
assert(math.abs(fabric.mesh.panel { file = inches, size = 10 * mm }:check().area / (2 * fabric.units.inch) ^ 2 - 1) < 1e-9) -- units of inches are read
refused("a file that does not say its unit", "unit", fabric.mesh.panel, { file = dxf(nil, true), size = 10 * mm })
refused("a file without a grain line", "grain", fabric.mesh.panel, { file = dxf(4, false), size = 0.5 * mm })
refused("a drawing in pixels", "unit", fabric.mesh.panel, { size = 10 * mm, file = file_of(
  "<svg xmlns='http://www.w3.org/2000/svg' width='300' height='200'><polygon id='A' points='0,0 60,0 50,30 0,30'/><line id='grain' x1='10' y1='10' x2='10' y2='20'/></svg>", ".svg") })

-- --- seams
local function two(t)
  local low = fabric.mesh.rectangle { width = t.width or 60 * mm, height = 60 * mm, nx = 6, ny = 6 }
  local high = fabric.mesh.rectangle { width = 60 * mm, height = 60 * mm, nx = 6, ny = 6, origin = { 0, 70 * mm, 0 } }
  local m = fabric.model { bodies = { { name = "low", mesh = low, card = card, warp = 0 }, { name = "high", mesh = high, card = card, warp = 0 } } }
  m:fix("low.bottom", "x y z"):seam(t.seam)
  return fabric.dynamic { model = m, duration = 0.1 }
end
refused("an edge sewn to itself", "an edge cannot be sewn to itself", two, { seam = { "low.top", "low.top", over = 0.05 } })
refused("an edge sewn the wrong way round", "the lines between the ends cross", two, { seam = { "low.top", "high.bottom", over = 0.05, reverse = true } })
local _, drawn = pcall(two, { seam = { "low.top", "high.bottom", over = 0.05, reverse = true } })
assert(tostring(drawn):find("o%-+o.-\\.-X.-/.-o%-+o"), "the lines that cross are drawn: " .. tostring(drawn))
refused("edges of different lengths", "expected lengths that differ by at most 1 %", two, { width = 70 * mm, seam = { "low.top", "high.bottom", over = 0.05 } })
refused("edges that are apart, sewn at once", "or a time in which they are drawn together (field 'over', s)", two, { seam = { "low.top", "high.bottom" } })
refused("an edge sewn to a ring", "is a ring and the other is not", two, { seam = { "low.top", "high.boundary", over = 0.05, ease = 0.4 } })
refused("an edge that is no edge", "expected the nodes of an edge", two, { seam = { "low.all", "high.bottom", over = 0.05 } })

-- --- bodies
local function worn(t)
  local arm = fabric.rigid.limb { upper = 0.1, lower = 0.1, radii = { 30 * mm, 30 * mm, 28 * mm }, around = 24, from = { -0.1, 0, 0 }, axis = { 1, 0, 0 }, towards = { 0, 0, 1 }, name = "arm" }
  local r = t.radius or 33 * mm
  local p = fabric.mesh.panel { size = 13 * mm, grain = 90, outline = { { 0, 0 }, { 2 * math.pi * r - 8 * mm, 0 }, { 2 * math.pi * r - 8 * mm, 80 * mm, name = "right" }, { 0, 80 * mm }, { name = "left" } } }
  p:wrap { cylinder = { radius = r, axis = { 1, 0, 0 }, from = { -40 * mm, 0, t.up or 0 }, towards = { 0, 0, -1 } } }
  local m = fabric.model { mesh = p, card = card, points = 1 }
  m:seam { "left", "right", over = 0.01 }:contact { between = { arm, "all" } }
  return fabric.dynamic { model = m, duration = 0.02 }
end
refused("a piece that starts through the body", "overlap at the start", worn, { radius = 30 * mm, up = 8 * mm })
refused("a piece that starts in the body", "starts inside the arm, which bounds a solid", worn, { radius = 24 * mm })
refused("a piece that goes more than once around", "expected at most 360", function()
  fabric.mesh.panel { outline = { { 0, 0 }, { 0.4, 0 }, { 0.4, 0.1 }, { 0, 0.1 } }, size = 10 * mm }:wrap { cylinder = { radius = 60 * mm } }
end)
local a, b = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 2, ny = 2 }, fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 3, ny = 2 }
refused("a body whose facets change", "expected the same facets in every shape", fabric.rigid.motion, { meshes = { a, b }, times = { 0, 1 } })
refused("a joint that bends too sharply", "folds over", fabric.rigid.limb, { upper = 0.28, lower = 0.25, radii = { 0.05, 0.043, 0.03 }, bend = 140 })
refused("a body that has a hole and shall be solid", "closed", fabric.rigid.surface, { mesh = a, closed = true })
assert(count >= 12)
