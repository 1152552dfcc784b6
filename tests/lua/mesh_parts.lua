-- Sheets of files whose elements share places but no nodes.
local fabric = require "fabric"
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails

-- A strip of n x m quads, each with vertices of its own; `off` moves them about by that much of the size.
local function file(n, m, off, gap)
  local out = {}
  for j = 0, m - 1 do
    for i = 0, n - 1 do
      for k, c in ipairs { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } do
        out[#out + 1] = ("v %.9f 0.1 %.9f\n"):format(0.03 * (i + c[1]) + (off or 0) * (k - 2) + (gap and j > 0 and gap or 0), 0.02 * (j + c[2]) + (gap and j > 0 and gap or 0))
      end
    end
  end
  for e = 0, n * m - 1 do out[#out + 1] = ("f %d %d %d %d\n"):format(4 * e + 1, 4 * e + 2, 4 * e + 3, 4 * e + 4) end
  local path = os.tmpname() .. ".obj"
  fabric.write(path, table.concat(out))
  return path
end
local path = file(5, 3)
local apart = fabric.mesh.read(path)
local report = apart:check()
assert(not report.ok and report.parts == 15 and report.items[1].key == "apart", report.text)
assert(report.text:find "the sheet is in 15 parts that are not connected, though they share places %(nodes 5, 8", report.text)
local whole = fabric.mesh.read { file = path, join = true }
report = whole:check()
assert(report.ok and report.parts == 1 and #whole.nodes == 24 and #whole.elements == 15 and report.borders == 1, report.text)
assert(#whole:set "boundary" == 16 and #whole:set "all" == 24)
assert(#fabric.mesh.read(path, true).nodes == 24)
assert(#fabric.mesh.read { file = path }.nodes == 60)
fails("unknown field 'jion', did you mean 'join'?", fabric.mesh.read, { file = path, jion = true })
os.remove(path)
-- nodes apart by the rounding of single precision are one place, by more they are not
path = file(4, 2, 2e-8)
assert(#fabric.mesh.read { file = path, join = true }.nodes == 15)
os.remove(path)
path = file(4, 2, 2e-5)
assert(#fabric.mesh.read { file = path, join = true }.nodes == 32)
os.remove(path)
-- two sheets side by side share no place: no error, but the model says it
path = file(1, 2, 0, 0.001)
local two = fabric.mesh.read { file = path, join = true }
assert(two:check().ok and two:check().parts == 2)
os.remove(path)
-- a run tells the parts of a mesh that share places, from a file or not, which neither seams nor ties connect
path = file(2, 2)
local deck = ([==[
local fabric = require "fabric"
local count
local function run(mesh, join)
  local model = fabric.model { mesh = mesh, card = fabric.card "denim", warp = 0 }
  if join then join(model) end
  local run = fabric.static { model = model, duration = 1 }
  count = 0
  for _, w in ipairs(run.warnings) do count = count + (w.code == "mesh" and 1 or 0) end
end
local function want(n, mesh, join)
  run(mesh, join)
  assert(count == n, count)
end
local nodes, elements = {}, {}
for k = 0, 1 do
  for j = 0, 2 do
    for i = 0, 2 do nodes[#nodes + 1] = { 0.02 * k + 0.01 * i, 0.01 * j, 0 } end
  end
  for j = 0, 1 do
    for i = 1, 2 do
      local at = 9 * k + 3 * j + i
      elements[#elements + 1] = { at, at + 1, at + 4, at + 3 }
    end
  end
end
local function halves()
  local mesh = fabric.mesh { nodes = nodes, elements = elements }
  mesh:set("one", { 3, 6, 9 })
  mesh:set("other", { 10, 13, 16 })
  mesh:set("both", { 3, 6, 9, 10, 13, 16 })
  return mesh
end
local function square(x, z)
  local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 2, ny = 2, origin = { x, 0 } }
  if z then mesh:map(function(a, b) return a, b, z end) end
  return mesh
end
want(0, fabric.mesh.read { file = %q, join = true })
want(0, fabric.mesh { nodes = nodes, elements = elements, join = true })
want(0, halves(), function(m) m:seam { "one", "other" } end)
want(0, halves(), function(m) m:seam { "one", "other", stiffness = 1e4, strength = 10, energy = 1 } end)
want(0, halves(), function(m) m:tie("rigid", "both") end)
local cut = fabric.mesh.rectangle { width = 0.04, height = 0.02, nx = 4, ny = 2 }
cut:slit { from = { 0.02, 0 }, to = { 0.02, 0.02 } }
want(0, cut)
want(0, fabric.mesh.merge { meshes = { square(0), square(0, 4e-4) } }) -- layers
want(0, fabric.mesh.merge { meshes = { square(0), square(0.021) } }) -- side by side
print "whole"
want(1, fabric.mesh.read %q)
want(1, halves(), function(m) m:tie("equal", "both", "x") end)
want(1, fabric.mesh.merge { meshes = { square(0), square(0.02 + 2e-6) } })
local model = fabric.model { mesh = halves(), card = fabric.card "denim", warp = 0 }
model:fix("all", "z rotation")
print "modes"
fabric.modes { model = model, count = 1 }
]==]):format(path, path)
local at, told = os.tmpname(), os.tmpname()
fabric.write(at, deck)
local program = arg[-1] or "fabricsh"
assert(os.execute(("%s --quiet %s >%s 2>&1"):format(program, at, told)), io.open(told):read "a")
local words = io.open(told):read "a"
local before, after, modes = words:match "^(.-)whole\n(.*)modes\n(.*)$"
assert(before and not before:find "parts", words)
for _, one in ipairs {
  "the sheet is in 4 parts that are not connected, though they share places (nodes 5, 8, 9, 10, 13 and 2 more, the first at {0.03, 0.1, 0} m): fabric.mesh.read{ file=..., join=true } makes",
  "lists: the sheet is in 2 parts that are not connected, though they share places (nodes 10, 13, 16, the first at {0.02, 0, 0} m): fabric.mesh{ nodes=..., elements=..., join=true } makes",
  "2 parts that are not connected, though they share places (nodes 10, 13, 16, the first at {0.02, 0, 0} m): fabric.mesh.merge{ meshes=..., distance= } makes",
} do
  assert(after:find(one, 1, true), words)
end
assert(modes:find "lists: the sheet is in 2 parts", words)
for _, one in ipairs { path, at, told } do os.remove(one) end
