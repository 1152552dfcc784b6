-- fabric.export.mesh: read back by our own reader and by meshio.
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 1, height = 2, nx = 2, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.1, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
for _, ending in ipairs { "obj", "ply", "stl" } do
  assert(fabric.export.mesh { mesh = mesh, file = "flat." .. ending } == "flat." .. ending)
  fabric.export.mesh { mesh = mesh, run = a, file = "bent." .. ending }
end
local back = fabric.mesh.read "bent.obj"
assert(#back.nodes == 12 and #back.elements == 6 and math.abs(back.nodes[12][2] - 2.1) < 1e-8)
local text = io.open("flat.stl"):read "a"
assert(select(2, text:gsub("facet normal 0 0 1\n", "")) == 12)
local python = "/usr/bin/python3"
if os.execute(python .. " -c 'import meshio' 2>/dev/null") then
  fabric.write("read.py", "import meshio\nfor e in ('obj','ply','stl'):\n  m = meshio.read('bent.' + e)\n  print(e, sum(len(c.data) for c in m.cells), round(float(m.points[:,1].max()), 6))\n")
  local said = io.popen(python .. " read.py 2>&1"):read "a"
  for line in ("obj 6 2.1\nply 6 2.1\nstl 12 2.1"):gmatch "[^\n]+" do assert(said:find(line, 1, true), said) end
else
  print "SKIPPED, not installed: python3-meshio"
end
local function wrong(words, t)
  local good, message = pcall(fabric.export.mesh, t)
  assert(not good and tostring(message):find(words, 1, true), tostring(message))
end
wrong("mesh: field 'file': expected a name that ends in .obj, .ply or .stl, got 'flat.vtu'", { mesh = mesh, file = "flat.vtu" })
wrong("/proc/nowhere", { mesh = mesh, file = "/proc/nowhere/flat.obj" })
