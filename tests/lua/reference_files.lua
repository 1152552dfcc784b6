-- Stress-free shapes of .k and .inp: named where a mesh is read without them, and read with reference=true.
local fabric = require "fabric"
local checks = {}
local function check(what, got, want) checks[#checks + 1] = { what, got, want, relative = 1e-12 } end

local function write(name, text) fabric.write(name, text) return name end
local dyna = [[
*KEYWORD
*NODE
       1             0.0             0.0             0.0
       2             0.1             0.0             0.0
       3             0.1            0.05             0.0
       4             0.0            0.05             0.0
       5             0.1             0.0           0.001
       6             0.0             0.0           0.001
*ELEMENT_SHELL
       1       1       1       2       3       4
       2       1       4       3       5       6
%s
*END
]]
local shape = [[
*AIRBAG_REFERENCE_GEOMETRY%s
%s       5             0.1             0.1             0.0
       6             0.0             0.1             0.0]]
for name, text in pairs { plain = shape:format("", ""), birth = shape:format("_BIRTH", "0.001\n"),
  id = shape:format("_ID", "         7       1.0       1.0       1.0\n"),
  foam = shape:format("", ""):gsub("AIRBAG_REFERENCE", "INITIAL_FOAM_REFERENCE") } do
  local file = write("bag.k", dyna:format(text))
  local placed, free = fabric.mesh.read(file), fabric.mesh.read { file = file, reference = true }
  check("place, " .. name, placed.nodes[5][3], 0.001)
  check("where it is free, " .. name, free.nodes[5][2], 0.1)
  check("height there, " .. name, 1 + free.nodes[6][3], 1)
  check("where it says nothing, " .. name, free.nodes[3][2], 0.05)
  local m = fabric.model { mesh = placed, reference = free, card = fabric.card "muslin", warp = 0, membrane = true }
  -- The height of the fold is all that is longer.
  local E = (0.05 ^ 2 + 0.001 ^ 2) / 0.05 ^ 2 / 2 - 0.5
  check("folded with the strain of its height, " .. name, fabric.static { model = m, duration = 1, step = 1 }:element(2).E22, E)
end

local abaqus = [[
*NODE
1, 0, 0, 0
2, 0.2, 0, 0
3, 0.2, 0.1, 0
4, 0, 0.1, 0
5, 0.3, 0.05, 0
*ELEMENT, TYPE=M3D4
1, 1, 2, 3, 4
*ELEMENT, TYPE=M3D3
2, 2, 5, 3
*INITIAL CONDITIONS, TYPE=REF COORDINATE
1, 0, 0, 0, 0.19, 0, 0
0.19, 0.1, 0, 0, 0.1, 0
2, 0.19, 0, 0, 0.29, 0.05, 0
0.19, %s, 0
]]
local file = write("roof.inp", abaqus:format "0.1")
check("placed, inp", fabric.mesh.read(file).nodes[2][1], 0.2)
local free = fabric.mesh.read { file = file, reference = true }
check("free, inp", free.nodes[2][1], 0.19)
check("free, inp, of the triangle", free.nodes[5][1], 0.29)

local function fails(words, name, text)
  local ok, message = pcall(fabric.mesh.read, { file = write(name, text), reference = true })
  if ok or not tostring(message):find(words, 1, true) then error(("expected an error with '%s', got %s"):format(words, tostring(message))) end
end
fails("element 2 has node 3 at another place than an element before: expected one shape of all elements", "roof.inp", abaqus:format "0.12")
fails("the file has no stress-free shape that is read", "bag.k", dyna:format "")

-- The remark of the mesh that is read without it.
local pipe = io.popen(("'%s' -e \"require 'fabric'.mesh.read '%s'\" 2>&1"):format(arg[-1], write("bag.k", dyna:format(shape:format("", "")))))
local talk = pipe:read "a"
pipe:close()
if not talk:find("bag.k:13: *AIRBAG_REFERENCE_GEOMETRY gives a stress-free shape, which this mesh leaves out: "
  .. "fabric.mesh.read{ file=..., reference=true } reads it, for reference= of a model", 1, true) then error("no remark: " .. talk) end
fabric.expect(checks)
