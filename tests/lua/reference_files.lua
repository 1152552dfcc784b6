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

-- The same by other nodes at whose places the elements have no stress.
local apart = write("bag.k", (dyna:gsub("\n%*ELEMENT_SHELL", [[

      11             0.0             0.0             0.0
      12             0.1             0.0             0.0
      13             0.1            0.05             0.0
      14             0.0            0.05             0.0
      15             0.1             0.1             0.0
      16             0.0             0.1             0.0%0]]):format [[
*AIRBAG_SHELL_REFERENCE_GEOMETRY
       1       1      11      12      13      14
       2       1      14      13      15      16]]))
check("elements by other nodes, k", fabric.mesh.read { file = apart, reference = true }.nodes[5][2], 0.1)
check("placed, of these", fabric.mesh.read(apart).nodes[5][3], 0.001)
check("nodes of the mesh alone", #fabric.mesh.read(apart).nodes, 6)

local function node(n, x, y, z) return ("%10d%20s%20s%20s\n"):format(n, x, y, z) end
local function radioss(shape)
  return "#RADIOSS STARTER\n/BEGIN\nbag\n      2022         0\n" .. ("%20s%20s%20s\n"):format("kg", "mm", "ms"):rep(2) .. "/NODE\n"
    .. node(1, 0, 0, 0) .. node(2, 100, 0, 0) .. node(3, 100, 50, 0) .. node(4, 0, 50, 0) .. node(5, 100, 0, 1) .. node(6, 0, 0, 1)
    .. node(25, 100, 100, 0) .. node(26, 0, 100, 0) .. "/SHELL/1\n" .. ("%10d%10d%10d%10d%10d\n"):format(1, 1, 2, 3, 4)
    .. "/SHELL/2\n" .. ("%10d%10d%10d%10d%10d\n"):format(2, 4, 3, 5, 6) .. shape .. "/END\n"
end
-- A node that is not of the part does not count.
local nodes = "/XREF/2\nthe flat bag\n       100\n" .. node(5, 100, 100, 0) .. node(6, 0, 100, 0) .. node(1, 7, 7, 7)
local shells = "/EREF/SHELL/2\n\n" .. ("%10d%10d%10d%10d%10d\n"):format(2, 4, 3, 25, 26)
for name, text in pairs { XREF = nodes, ["XREF without steps"] = nodes:gsub(" +100\n", "", 1), EREF = shells } do
  local rad = write("bag.rad", radioss(text))
  local there, open = fabric.mesh.read(rad), fabric.mesh.read { file = rad, reference = true }
  check("place, " .. name, there.nodes[5][3], 0.001)
  check("where it is free, " .. name, open.nodes[5][2], 0.1)
  check("height there, " .. name, 1 + open.nodes[6][3], 1)
  check("where it says nothing, " .. name, open.nodes[1][1] + 1, 1)
  check("parts, " .. name, #there:set "part_2", 4)
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
fails("bag.rad: field 'reference': the file has no stress-free shape that is read", "bag.rad", radioss "/REFSTA\nbagRS0\n")
fails("/XREF: node 3 has another place before: expected one shape of all elements", "bag.rad",
  radioss("/XREF/1\n\n\n" .. node(3, 100, 50, 0) .. "/XREF/2\n\n\n" .. node(3, 90, 50, 0)))
fails("bag.rad:22: node 27 is not in the file", "bag.rad", radioss(shells:gsub("26\n", "27\n")))
local ok, message = pcall(fabric.mesh.read, { file = write("bag.rad", radioss(nodes)), units = "mm" })
assert(not ok and tostring(message):find("argument 'units': expected none, since bag.rad states its own (/BEGIN), got 'mm'", 1, true), tostring(message))

-- The remark of the mesh that is read without it.
local pipe = io.popen(("'%s' -e \"require 'fabric'.mesh.read '%s'\" 2>&1"):format(arg[-1], write("bag.k", dyna:format(shape:format("", "")))))
local talk = pipe:read "a"
pipe:close()
if not talk:find("bag.k:13: *AIRBAG_REFERENCE_GEOMETRY gives a stress-free shape, which this mesh leaves out: "
  .. "fabric.mesh.read{ file=..., reference=true } reads it, for reference= of a model", 1, true) then error("no remark: " .. talk) end
fabric.expect(checks)
