-- Meshes from and to files from a deck's side: those that come with the program, round trips, damaged files, reports, orientation.
local fabric = require "fabric"

local function refused(part, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(part, 1, true), tostring(why))
end

local function write(name, text)
  local file = assert(io.open(name, "wb"))
  file:write(text)
  file:close()
  return name
end

-- Each mesh that comes with the program, in both forms.
for _, name in ipairs { "strip", "disc", "sleeve", "wavy" } do
  local a, b = fabric.mesh.read(name .. ".msh"), fabric.mesh.read(name .. ".vtu")
  assert(#a.nodes == #b.nodes and #a.elements == #b.elements and #a.sets == #b.sets)
  assert(a:check().ok and tostring(a):find(name .. ".msh", 1, true))
end

-- A strip from a file runs as the generated one does; the warp has to be said.
local strip = fabric.mesh.read "strip.msh"
refused("warp", fabric.model, { mesh = strip, card = fabric.card "blend" })
fabric.model { mesh = strip, card = fabric.card "blend", warp = 90 }:fix("bottom", "x y z")

-- Sets made by the deck travel with the mesh.
local disk = fabric.mesh.disk { radius = 0.05, cells = 4 }
disk:set("half", function(x) return x > 0 end)
assert(disk:write "out/disk.msh" == disk)
assert(#fabric.mesh.read "out/disk.msh":set "half" == #disk:set "half")
refused("write: cannot write 'disk.step': expected a name that ends in .msh, .vtu, .obj, .stl, .ply, .inp, .k or .rad", disk.write, disk, "disk.step")

-- Triangles load.
local obj = write("pair.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng lower\nf 1 2 3\ng upper\nf 1 4 3\n")
local pair = fabric.mesh.read(obj)
assert(#pair.elements[1] == 3 and #pair:set "lower" == 3)
local report = pair:check()
assert(not report.ok and report.triangles == 2 and report.items[1].key == "orientation")
assert(tostring(report):find("error: element 2: normal against that of the neighbours", 1, true))
assert(pair:orient { 0, 0, 1 } == 1 and pair:check().ok and pair.elements[2][2] == 3)
refused("orient: argument 'direction': expected a direction", pair.orient, pair, { 0, 0, 0 })
refused("orient: the mean normal of part 1 of the mesh is square to the direction", pair.orient, pair, { 1, 0, 0 })

-- Lengths in units that the deck says.
local inches = fabric.mesh.read { file = obj, units = "inch" }
assert(inches.nodes[3][1] == 0.0254 and inches.nodes[3][2] == 0.0254 and #inches:set "lower" == 3)

-- Errors name the file and its line.
refused("read: cannot read 'none.msh': No such file or directory", fabric.mesh.read, "none.msh")
refused("expected a name that ends in .msh, .vtu, .vtk, .obj, .stl, .ply, .inp, .k, .key or .rad", fabric.mesh.read, "mesh.igs")
refused("bad.obj:2: expected three coordinates", fabric.mesh.read, write("bad.obj", "v 0 0 0\nv 1 0\n"))
refused("bad.msh: the file is empty", fabric.mesh.read, write("bad.msh", ""))
refused("bad.vtu:1: expected <VTKFile>, got <html>", fabric.mesh.read, write("bad.vtu", "<html></html>"))
refused("bad.vtk:1: expected a .vtk file", fabric.mesh.read, write("bad.vtk", ("\0\255"):rep(1000)))

-- A mesh written as .msh is read by meshio, with the sets: the elements' group, and each set's nodes.
local meshio = [[%s -c "
import meshio
mesh = meshio.read('out/disk.msh')
cells = {kind: sum(len(block) for block in mesh.cells if block.type == kind) for kind in ('quad', 'vertex')}
print(cells['quad'], cells['vertex'], sorted(mesh.field_data))
" 2>&1]]
local has, python
for _, program in ipairs { "python3", "/usr/bin/python3" } do
  if not has then has, python = os.execute(program .. " -c 'import meshio' 2>/dev/null"), program end
end
if has then
  local of_sets = 0
  for _, name in ipairs { "all", "boundary", "centre", "core", "half" } do of_sets = of_sets + #disk:set(name) end
  local answer = io.popen(meshio:format(python)):read "a"
  local want = ("%d %d ['all', 'boundary', 'centre', 'core', 'half']"):format(#disk.elements, of_sets)
  assert(answer:find(want, 1, true), answer .. "want " .. want)
else
  print "SKIPPED: meshio is not installed (apt install python3-meshio), so that it does not read our .msh"
end

-- The content of a deck beside its mesh is data of the mesh, by statement, with the first line and how often.
do
  local stem = os.tmpname()
  local function read(ending, text)
    local name = stem .. ending
    local file <close> = assert(io.open(name, "w"))
    file:write(text)
    file:close()
    local read = fabric.mesh.read(name)
    os.remove(name)
    return read
  end
  local function listed(mesh)
    local all = {}
    for _, p in ipairs(mesh:check().passed_over) do all[#all + 1] = ("%s %d %d"):format(p.statement, p.line, p.count) end
    return table.concat(all, ", ")
  end
  local inp = "*HEADING\na patch\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n*ELEMENT, TYPE=S4\n1, 1, 2, 3, 4\n*MATERIAL, NAME=A\n*ELASTIC\n1, 0.3\n"
    .. "*Material, name=B\n*STEP\n*STATIC\n*CLOAD\n1, 1, 2\n*END STEP\n"
  local k = "*KEYWORD\n*TITLE\na patch\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n*ELEMENT_SHELL\n1,1,1,2,3,3\n*MAT_FABRIC\n1,7\n*CONTROL_TERMINATION\n1\n*MAT_FABRIC\n2,7\n*END\n"
  assert(listed(read(".inp", inp)) == "*MATERIAL 10 2, *ELASTIC 11 1, *STEP 14 1, *STATIC 15 1, *CLOAD 16 1", listed(read(".inp", inp)))
  assert(listed(read(".k", k)) == "*MAT_FABRIC 10 2, *CONTROL_TERMINATION 12 1", listed(read(".k", k)))
  local own = fabric.mesh.disk { radius = 0.1, cells = 2 }
  for _, ending in ipairs { ".inp", ".k", ".msh" } do
    own:write(stem .. ending)
    assert(listed(fabric.mesh.read(stem .. ending)) == "", "a mesh of one's own has nothing else")
    os.remove(stem .. ending)
  end
end
