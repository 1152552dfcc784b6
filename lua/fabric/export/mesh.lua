-- fabric.export.mesh: a mesh, or a run's sheet as it is now, as a file for another program.
local define = require "fabric.define"

local function run(t)
  if t.run then t.run:write(t.file) else t.mesh:write(t.file) end
  return t.file
end

define {
  name = "fabric.export.mesh",
  arguments = {
    { name = "mesh", of = "mesh", sentence = "the mesh" },
    { name = "file", kind = "text", sentence = "ends in .vtu, .msh, .obj, .ply, .stl, .inp, .k or .rad; lengths in m" },
    { name = "run", of = "analysis", optional = true, sentence = "of that mesh: nodes where they are now; default: the reference shape" },
  },
  sentence = "Writes a mesh as mesh:write does, or its deformed shape as analysis:write does. Returns the file's name.",
  example = "local path = os.tmpname()..'.obj'\n"
    .. "fabric.export.mesh{ mesh=fabric.mesh.rectangle{ width=1, height=1, nx=2, ny=2 }, file=path }\n"
    .. "assert(#fabric.mesh.read(path).nodes == 9)\nos.remove(path)",
  run = run,
}
