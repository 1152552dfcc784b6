-- fabric.export.mesh: read back by our own reader, by meshio and by assimp.
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

-- Every ending, as deformed and as it was; what can be read comes back with its sets.
for _, ending in ipairs { "vtu", "msh", "inp", "k", "stl", "obj" } do
  a:write("now." .. ending)
  a:write("then." .. ending, { points = "reference" })
  local now, before = fabric.mesh.read("now." .. ending), fabric.mesh.read("then." .. ending)
  assert(#now.nodes == 12 and #before.nodes == 12 and #now.elements == (ending == "stl" and 12 or 6))
  for i = 1, 12 do
    local node, where = a:node(i), ending == "stl" and 0 or i
    for k = 1, 12 do -- an .stl has an order of its own
      local p = now.nodes[k]
      if where == 0 and math.abs(p[1] - node.x) + math.abs(p[2] - node.y) < 1e-12 then where = k end
    end
    local p, q = now.nodes[where], before.nodes[where]
    assert(math.abs(p[1] - node.x) < 1e-8 and math.abs(p[2] - node.y) < 1e-8, ending)
    assert(math.abs(q[1] - node.X) < 1e-8 and math.abs(q[2] - node.Y) < 1e-8, ending)
  end
  local sets = ending ~= "stl" and ending ~= "obj"
  assert((not sets or #now:set "top" == 3) and sets == pcall(now.set, now, "top"))
end
a:write "now.rad"
assert(io.open("now.rad"):read "a":find("/SHELL/1\n         1         1         2         5         4\n", 1, true))

-- assimp: triangles, and the box of the deformed sheet.
if os.execute "command -v assimp >/dev/null 2>&1" then
  for _, ending in ipairs { "obj", "ply", "stl" } do
    local pipe <close> = assert(io.popen("assimp info bent." .. ending .. " 2>&1"))
    local said = pipe:read "a"
    assert(tonumber(said:match "Faces:%s+(%d+)") == 12, said)
    local low, high = tonumber(said:match "Minimum point%s+%([-%d.]+ ([-%d.]+)"), tonumber(said:match "Maximum point%s+%([-%d.]+ ([-%d.]+)")
    assert(math.abs(low) < 1e-6 and math.abs(high - 2.1) < 1e-6, said)
  end
else
  print "SKIPPED, not installed: assimp (assimp-utils)"
end

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
wrong("cannot write 'flat.step': expected a name that ends in .msh, .vtu, .obj, .stl, .ply, .inp, .k or .rad", { mesh = mesh, file = "flat.step" })
local good, message = pcall(a.write, a, "now.stl", { averaged = true })
assert(not good and tostring(message):find("write: field 'options.averaged': expected a file that ends in .vtu, which holds fields, got 'now.stl'", 1, true), message)
good, message = pcall(a.write, a, "now.vtu", { fields = { "S99" } })
assert(not good and tostring(message):find("field 'fields': unknown field 'S99'", 1, true), message)
wrong("/proc/nowhere", { mesh = mesh, file = "/proc/nowhere/flat.obj" })
