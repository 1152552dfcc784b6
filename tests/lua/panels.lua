-- Panels from a deck's side: outlines, sets, the warp that a model takes, files, wrapping; a strip cut along the grain pulls
-- like the mesh of a rectangle.
-- warns: the mesh spans 60 m
local fabric = require "fabric"
local mm = fabric.units.mm

local function refused(part, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(part, 1, true), tostring(why))
end

local function near(a, b, tolerance)
  assert(math.abs(a - b) <= (tolerance or 1e-12) * math.max(1, math.abs(b)), ("%.17g for %.17g"):format(a, b))
end

-- A parallelogram with an arc of 120 degrees, a Bezier curve that is a parabola, a hole and a dart: areas in closed form.
local panel = fabric.mesh.panel {
  size = 8 * mm,
  grain = 90,
  outline = {
    { 0, 0 },
    { 300 * mm, 0, name = "hem" },
    { 300 * mm, 200 * mm, name = "right", elements = 20 },
    { bezier = { { 250 * mm, 200 * mm }, { 200 * mm, 220 * mm }, { 150 * mm, 260 * mm } }, name = "top" },
    { 0, 260 * mm },
    { name = "left" },
  },
  holes = { { circle = { 80 * mm, 150 * mm }, radius = 30 * mm, name = "vent" } },
  darts = { { from = { 180 * mm, 0 }, tip = { 190 * mm, 90 * mm }, to = { 205 * mm, 0 } } },
  notches = { { name = "balance", edge = "left", at = 100 * mm } },
}
local report = panel:check()
assert(report.ok and report.borders == 2 and report.parts == 1)
assert(#panel:set "right" == 21 and #panel:set "balance" == 1 and #panel:set "dart1_in" == #panel:set "dart1_out")
near(panel.nodes[panel:set("balance")[1]][2], 160 * mm)
local n = #panel:set "vent"
local straight = 0.3 * 0.26 - 0.5 * 0.025 * 0.09 - n / 2 * 0.03 ^ 2 * math.sin(2 * math.pi / n)
-- Above the curve from (0.3, 0.2) to (0.15, 0.26): y = 0.2 + 0.06 t^2 while x falls by 0.15, so a third of the rectangle is under it.
near(report.area, straight - 0.15 * 0.06 * (1 - 1 / 3), 1e-4)

-- The warp of the panel is that of the model; wrapping takes it along.
local function pull(mesh, warp)
  local model = fabric.model { mesh = mesh, card = fabric.card "blend", warp = warp }
  model:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(2 * mm, 1) })
  local run = fabric.static { model = model, duration = 1, step = 0.25 }:solve()
  return select(2, run:reaction "top")
end
local outline = { { 0, 0 }, { 30 * mm, 0, name = "bottom" }, { 30 * mm, 50 * mm }, { 0, 50 * mm, name = "top" } }
local strip = function(more)
  local given = { outline = outline, size = 10 * mm }
  for key, value in pairs(more) do given[key] = value end
  return fabric.mesh.panel(given)
end
local whole = fabric.mesh.rectangle { width = 30 * mm, height = 50 * mm, nx = 3, ny = 5 }
near(pull(strip { grain = 90 }), pull(whole, 90), 1e-9)
near(pull(strip {}), pull(whole, 0), 1e-9)
near(pull(strip { grain = 90 }, 0), pull(whole, 0), 1e-9)
assert(tostring(fabric.model { mesh = panel, card = fabric.card "blend" }):find "along the grain of the mesh")
local model = fabric.model { bodies = {
  { name = "a", mesh = strip { grain = 30 }, card = fabric.card "blend" },
  { name = "b", mesh = whole, card = fabric.card "blend" },
} }
assert(#model.mesh:set "a.bottom" == 4)

local sleeve = strip { grain = 90 }:wrap { cylinder = { radius = 20 * mm, axis = { 1, 0, 0 }, towards = { 0, 0, 2 }, at = { 15 * mm, 0 } } }
for _, i in ipairs(sleeve:set "all") do
  local x = sleeve.nodes[i]
  near(x[2] ^ 2 + x[3] ^ 2, (20 * mm) ^ 2)
end
fabric.model { mesh = sleeve, card = fabric.card "blend" }
local bent = fabric.mesh.rectangle { width = 1, height = 1, nx = 2, ny = 2 }
refused("not a flat generated one", fabric.model, { mesh = bent:map(function(x, y) return x, y, x end), card = fabric.card "blend" })
local cone = strip {}:wrap { cone = { radius = 50 * mm, angle = -20, from = { 0, 0, 1 } } }
near(cone.nodes[1][1], 50 * mm)
near(cone.nodes[1][3], 1)

-- A piece of a file.
local place = arg[0]:match "^(.*)tests/lua/" or ""
local file = place .. "share/data/patterns/skirt.dxf"
local front = fabric.mesh.panel { file = file, piece = "FRONT", size = 20 * mm, notches = { { name = "mine", edge = "edge4", share = 0.5 } } }
assert(front:check().ok and #front:set "notch2" == 1 and #front:set "mine" == 1)
refused("expected one of 'FRONT', 'BACK'", fabric.mesh.panel, { file = file, size = 20 * mm })
local inches = fabric.mesh.panel { file = file, piece = "BACK", size = 0.5, unit = fabric.units.inch, grain = 0 }
near(inches.nodes[1][1] / fabric.units.inch, 108)
refused("cannot read", fabric.mesh.panel, { file = "none.dxf", size = 1 })

-- Both pieces of a tunic as they were drawn, in mm, their grain lines inside.
for _, piece in ipairs { "front", "back" } do
  local report = fabric.mesh.panel { file = place .. "share/data/patterns/tunic.svg", piece = piece, size = 40 * mm }:check()
  assert(report.ok and report.area > 0.2 and report.area < 0.28)
end

-- A piece of a drawing: 0.1 mm is a unit.
local name = os.tmpname() .. ".svg"
do
  local drawing <close> = assert(io.open(name, "w"))
  drawing:write "<svg xmlns='http://www.w3.org/2000/svg' width='30cm' height='20cm' viewBox='0 0 3000 2000'>"
  drawing:write "<polygon id='A' points='0,0 600,0 500,300 0,300'/><line id='grain' x1='100' y1='100' x2='100' y2='200'/></svg>"
end
near(fabric.mesh.panel { file = name, size = 5 * mm }:check().area, 0.5 * (600 + 500) * 300 * 1e-8)
refused("expected one of 'A', got 'B'", fabric.mesh.panel, { file = name, size = 5 * mm, piece = "B" })
os.remove(name)

-- Lengths in mm with a size that could be one in m: said once the outline spans what no cloth does.
fabric.mesh.panel { outline = { { 0, 0 }, { 40, 0 }, { 40, 60 }, { 0, 60 } }, size = 1 }
