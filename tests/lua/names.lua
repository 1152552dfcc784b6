-- Names of sets, bodies, columns and series: what is accepted gives files that every reader takes, the rest is refused at once.
local fabric = require "fabric"

local function fails(part, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "no error: " .. part)
  assert(tostring(message):find(part, 1, true), tostring(message) .. "\nis without: " .. part)
end
local function text_of(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read "a"
  file:close()
  return text
end
local folder = os.tmpname()
os.remove(folder)

local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.1, nx = 2, ny = 1 }
local bad = { "edge \27 one", "a\0b", "two\nlines", "tab\tbed", "gr\246\223e", "half \229\184", "\239\191\191", "\127" }
for _, name in ipairs(bad) do
  local shown = name:gsub("[^ -~]", "?")
  fails(("set: expected a name in UTF-8 without control characters, got '%s'"):format(shown), mesh.set, mesh, name, { 1, 2 })
  fails("expected a name ", fabric.model, { bodies = { { name = name, mesh = mesh, card = fabric.card "blend" }, { name = "b", mesh = mesh, card = fabric.card "blend" } } })
  fails("expected a name in UTF-8", fabric.rigid.sphere, { radius = 0.1, centre = { 0, 0, 0 }, name = name })
end

-- Every character that a name may have comes back from every file that keeps sets, and the file is XML.
local good = { "left & <right>", "\"quoted\" 'twice'", "gr\195\182\195\159e", "\229\184\131", "\240\159\167\181 thread" }
for i, name in ipairs(good) do mesh:set(name, { i, i + 1 }) end
mesh:write(folder .. "/sets.vtu")
local read = fabric.mesh.read(folder .. "/sets.vtu")
for i, name in ipairs(good) do assert(table.concat(read:set(name), " ") == ("%d %d"):format(i, i + 1), name) end
local text = text_of(folder .. "/sets.vtu")
assert(utf8.len(text:match "^(.-)<AppendedData" or text:match "<PointData.-</PointData>" or ""), "no UTF-8")

-- A file from elsewhere in an older alphabet: its names are made readable.
fabric.write(folder .. "/old.msh", ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 \"gr\246\223e\27\"\n$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n")
  .. "$Elements\n2\n1 1 2 1 1 1 2\n2 3 2 0 1 1 2 3 4\n$EndElements\n")
local old = fabric.mesh.read(folder .. "/old.msh")
assert(#old:set "gr\195\182\195\159e " == 2)
old:write(folder .. "/new.vtu")
assert(#fabric.mesh.read(folder .. "/new.vtu"):set "gr\195\182\195\159e " == 2 or #fabric.mesh.read(folder .. "/new.vtu"):set "gr\195\182\195\159e" == 2)

-- Columns and series.
local model = fabric.model { mesh = mesh, card = fabric.card "blend" }:fix("all", "z rotation"):fix("left", "x y"):move("right", { x = fabric.ramp(0.001, 1), y = 0 })
local a = fabric.static { model = model, duration = 1, step = 0.5 }
for _, name in ipairs(bad) do
  fails("record: field 'columns': expected a name in UTF-8", a.record, a, folder .. "/a.csv", { columns = { [name] = function() return 1 end } })
end
fails("vtk: series: expected a name in UTF-8 without control characters, got 'dr?ape'", a.vtk, a, folder .. "/dr\27ape")
a:record(folder .. "/a.csv", { columns = { ["force, total"] = function() return 7 end, ["gr\195\182\195\159e"] = function() return 8 end } })
a:vtk(folder .. "/gr\195\182\195\159e & co")
a:solve()
local t = fabric.table { file = folder .. "/a.csv" }
assert(#t == 3 and t[2].name == "force, total" and t[2].values[1] == 7 and t[3].name == "gr\195\182\195\159e" and t[3].values[3] == 8)
-- ... of a study
for _, name in ipairs { "two\nlines", "a\0b" } do
  fails("expected a name in UTF-8", fabric.study, { parameters = { [name] = { 1 } }, folder = folder .. "/study", run = function() return {} end })
  local s = fabric.study { parameters = { a = { #name } }, folder = folder .. "/study" .. #name, run = function() return { [name] = 1 } end }
  assert(s.failed == 1 and s[1].trouble:find("expected a name in UTF-8", 1, true), s[1].trouble)
end
os.execute("rm -rf " .. folder)
