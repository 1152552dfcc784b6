-- fabric.export.mesh: the facets of a mesh, or of a deformed run, as .obj, .ply or .stl.
local fabric = require "fabric"
local define = require "fabric.define"
local fail = define.fail

local function triangles(e) return #e == 4 and { { e[1], e[2], e[3] }, { e[1], e[3], e[4] } } or { e } end

local writers = {}
function writers.obj(nodes, elements)
  local out = {}
  for _, p in ipairs(nodes) do out[#out + 1] = ("v %.9g %.9g %.9g"):format(p[1], p[2], p[3]) end
  for _, e in ipairs(elements) do out[#out + 1] = "f " .. table.concat(e, " ") end
  return out
end
function writers.ply(nodes, elements)
  local out = { "ply", "format ascii 1.0", "element vertex " .. #nodes, "property double x", "property double y", "property double z",
    "element face " .. #elements, "property list uchar int vertex_indices", "end_header" }
  for _, p in ipairs(nodes) do out[#out + 1] = ("%.9g %.9g %.9g"):format(p[1], p[2], p[3]) end
  for _, e in ipairs(elements) do
    local line = { #e }
    for k, n in ipairs(e) do line[k + 1] = n - 1 end
    out[#out + 1] = table.concat(line, " ")
  end
  return out
end
function writers.stl(nodes, elements)
  local out = { "solid cloth" }
  for _, e in ipairs(elements) do
    for _, f in ipairs(triangles(e)) do
      local a, b, c = nodes[f[1]], nodes[f[2]], nodes[f[3]]
      local u, v = { b[1] - a[1], b[2] - a[2], b[3] - a[3] }, { c[1] - a[1], c[2] - a[2], c[3] - a[3] }
      local n = { u[2] * v[3] - u[3] * v[2], u[3] * v[1] - u[1] * v[3], u[1] * v[2] - u[2] * v[1] }
      local l = math.max(math.sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2), 1e-300)
      out[#out + 1] = ("facet normal %.9g %.9g %.9g\nouter loop"):format(n[1] / l, n[2] / l, n[3] / l)
      for _, p in ipairs { a, b, c } do out[#out + 1] = ("vertex %.9g %.9g %.9g"):format(p[1], p[2], p[3]) end
      out[#out + 1] = "endloop\nendfacet"
    end
  end
  out[#out + 1] = "endsolid cloth"
  return out
end

local function run(t)
  local writer = writers[t.file:match "%.(%w+)$"]
  if not writer then fail(("mesh: field 'file': expected a name that ends in .obj, .ply or .stl, got '%s'"):format(t.file)) end
  local mesh, nodes, elements = t.mesh, {}, {}
  for i = 1, #mesh.nodes do
    local a = t.run and t.run:node(i)
    nodes[i] = a and { a.x, a.y, a.z } or mesh.nodes[i]
  end
  for i = 1, #mesh.elements do elements[i] = mesh.elements[i] end
  fabric.write(t.file, table.concat(writer(nodes, elements), "\n") .. "\n")
  return t.file
end

define {
  name = "fabric.export.mesh",
  arguments = {
    { name = "mesh", of = "mesh", sentence = "the mesh" },
    { name = "file", kind = "text", sentence = "that ends in .obj, .ply or .stl (quadrilaterals in two), lengths in m" },
    { name = "run", of = "analysis", optional = true, sentence = "of that mesh: nodes where they are now; default: the reference shape" },
  },
  sentence = "Writes a mesh, or its deformed shape, as .obj, .ply or .stl. Returns the file's name.",
  example = "local fabric = require 'fabric'\nlocal path = os.tmpname()..'.obj'\n"
    .. "fabric.export.mesh{ mesh=fabric.mesh.rectangle{ width=1, height=1, nx=2, ny=2 }, file=path }\n"
    .. "assert(#fabric.mesh.read(path).nodes == 9)\nos.remove(path)",
  run = run,
}
