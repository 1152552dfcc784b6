-- fabric.lab.form_finding: the shape in which a sheet with given tensions is in balance, as of tents, roofs and sails. A sheet that
-- stretches easily is tensioned and let go to its balance; that shape is tensioned anew, until it stays where it is: the updated
-- reference of [bletzinger1999].
local fabric = require "fabric"
local define = require "fabric.define"

local compliance = 0.1 -- strain at the tension: the softer the sheet, the further it goes in a round


-- A mesh of the same elements and sets with other nodes.
local function moved(mesh, nodes)
  local elements = {}
  for e = 1, #mesh.elements do elements[e] = mesh.elements[e] end
  local copy = fabric.mesh { nodes = nodes, elements = elements }
  for _, name in ipairs(mesh.sets) do copy:set(name, mesh:set(name)) end
  return copy
end

local function places(mesh)
  local nodes = {}
  for i = 1, #mesh.nodes do nodes[i] = mesh.nodes[i] end
  return nodes
end

local function extent(nodes)
  local low, high = { table.unpack(nodes[1]) }, { table.unpack(nodes[1]) }
  for _, x in ipairs(nodes) do
    for i = 1, 3 do low[i], high[i] = math.min(low[i], x[i]), math.max(high[i], x[i]) end
  end
  return math.sqrt((high[1] - low[1]) ^ 2 + (high[2] - low[2]) ^ 2 + (high[3] - low[3]) ^ 2)
end

local function run(t)
  local warp, weft = t.prestress.warp, t.prestress.weft
  local thickness = 1e-3
  local card = fabric.svk { name = "tension", density = 500, thickness = thickness, poisson = 0, warp = warp / compliance / thickness,
    weft = weft / compliance / thickness, shear = math.sqrt(warp * weft) / thickness }
  local given = places(t.mesh)
  local size, mesh = extent(given), moved(t.mesh, given)
  local r = { moves = {} }
  for round = 1, t.rounds do
    local m = fabric.model { mesh = mesh, card = card, warp = t.warp or 0, membrane = true, prestress = t.prestress }
    t.hold(m)
    local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
    local nodes, most = {}, 0
    for i = 1, #mesh.nodes do
      local p = a:node(i)
      nodes[i] = { p.x, p.y, p.z }
      most = math.max(most, math.sqrt(p.ux ^ 2 + p.uy ^ 2 + p.uz ^ 2))
    end
    mesh = moved(mesh, nodes)
    r.moves[round], r.analysis, r.model = most, a, m
    if most < t.tolerance * size then
      r.mesh, r.rounds = mesh, round
      return r
    end
  end
  define.fail(("form_finding: after %d rounds nodes still move by %.3g m in a round, more than %.3g m: expected more rounds, or a shape that these tensions can have"):format(
    t.rounds, r.moves[t.rounds], t.tolerance * size))
end

define {
  name = "fabric.lab.form_finding",
  arguments = {
    { name = "mesh", of = "mesh", sentence = "a shape to begin with; what is held is at its place" },
    { name = "prestress", kind = "fields",
      rows = { { name = "warp", kind = "number", unit = "N/m", above = 0, sentence = "along the warp" },
        { name = "weft", kind = "number", unit = "N/m", above = 0, sentence = "along the weft" } },
      sentence = "{ warp=N/m, weft=N/m }: the tensions of the shape that is sought; equal ones are those of a soap film" },
    { name = "hold", kind = "function", sentence = "function(model), which declares the supports, as by model:fix('boundary', 'x y z')" },
    { name = "warp", kind = "any", optional = true, sentence = "as for fabric.model, on each shape; default 0" },
    { name = "tolerance", kind = "number", above = 0, default = 1e-5, sentence = "how far nodes may still move in the last round, over the size of the mesh" },
    { name = "rounds", kind = "integer", low = 1, default = 100, sentence = "at most" },
  },
  sentence = "The shape in which a sheet with given tensions is in balance, by rounds of statics with an updated reference [bletzinger1999]. Returns mesh (the shape, with the sets of the mesh), rounds, moves "
    .. "(m, the longest way of a node in each round), analysis and model of the last round. A model of this mesh with a card and the same prestress begins in balance.",
  example = "local mesh = fabric.mesh.rectangle{ width=1, height=1, nx=4, ny=4 }\n"
    .. "mesh:map(function(x, y) return x, y, 0.4 * x * y end)\n"
    .. "local found = fabric.lab.form_finding{ mesh=mesh, prestress={ warp=100, weft=100 }, tolerance=1e-3,\n"
    .. "  hold=function(m) m:fix('boundary', 'x y z') end }\n"
    .. "assert(#found.mesh.nodes == 25)",
  run = run,
}
