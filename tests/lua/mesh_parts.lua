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
assert(report.text:find "the sheet is in 15 parts that are not connected; nodes 5, 8", report.text)
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
-- the model tells the parts of a mesh from a file, and not those of one of its own
path = file(2, 2)
fabric.warn = nil
local deck = ([==[
local fabric = require "fabric"
local function model(mesh) fabric.model { mesh = mesh, card = fabric.card "denim", warp = 0 } end
model(fabric.mesh.read { file = %q, join = true })
model(fabric.mesh.rectangle { width = 1, height = 1, nx = 2, ny = 2 })
print "whole"
model(fabric.mesh.read %q)
]==]):format(path, path)
local at, told = os.tmpname(), os.tmpname()
fabric.write(at, deck)
local program = arg[-1] or "fabricsh"
os.execute(("%s --quiet %s >%s 2>&1"):format(program, at, told))
local words = io.open(told):read "a"
assert(words:find("whole\n", 1, true), words)
local before, after = words:match "(.-)whole\n(.*)"
assert(not before:find "parts" and after:find "the sheet is in 4 parts that are not connected, though they share places: fabric.mesh.read{ file=..., join=true }", words)
for _, one in ipairs { path, at, told } do os.remove(one) end
