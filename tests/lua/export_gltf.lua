-- fabric.export.gltf: the file taken apart here, number by number, and read by assimp and by VTK.
local fabric = require "fabric"

-- A reader of JSON for what the program writes.
local function json(text)
  local at = 1
  local function skip() at = text:find("%S", at) or #text + 1 end
  local value
  local function word(c) skip() assert(text:sub(at, at) == c, ("expected %s at %d"):format(c, at)) at = at + 1 end
  local function peek() skip() return text:sub(at, at) end
  local function items(close, item)
    if peek() == close then at = at + 1 return end
    while true do
      item()
      if peek() == close then at = at + 1 return end
      word ","
    end
  end
  local function string()
    word '"'
    local from = at
    at = text:find('"', at, true) + 1
    local s = text:sub(from, at - 2)
    assert(not s:find("\\", 1, true))
    return s
  end
  function value()
    local c, out = peek(), {}
    if c == "{" then
      word "{"
      items("}", function()
        local name = string()
        word ":"
        out[name] = value()
      end)
      return out
    elseif c == "[" then
      word "["
      items("]", function() out[#out + 1] = value() end)
      return out
    elseif c == '"' then return string()
    end
    local from, to = text:find("^[%w+%-.]+", at)
    local s = text:sub(from, to)
    at = to + 1
    if s == "true" then return true elseif s == "false" then return false end
    return (assert(tonumber(s), s))
  end
  local out = value()
  skip()
  assert(at > #text, "something behind the JSON")
  return out
end

-- The file as a table, with gltf.read(accessor) -> a list of numbers or triples. The demands of the format are checked on the way.
local function open(path)
  local file <close> = assert(io.open(path, "rb"))
  local bytes = file:read "a"
  local magic, version, length, size, kind = string.unpack("<c4I4I4I4c4", bytes)
  assert(magic == "glTF" and version == 2 and length == #bytes and kind == "JSON" and size % 4 == 0)
  local g = json(bytes:sub(21, 20 + size))
  local count, binary = string.unpack("<I4c4", bytes, 21 + size)
  assert(binary == "BIN\0" and 28 + size + count == #bytes and count % 4 == 0 and g.buffers[1].byteLength == count)
  local start, used = 28 + size, 0
  for _, view in ipairs(g.bufferViews) do
    assert(view.buffer == 0 and view.byteOffset == used and view.byteOffset % 4 == 0)
    used = used + view.byteLength
  end
  assert(used == count and #g.accessors == #g.bufferViews and g.asset.version == "2.0")
  function g.read(index)
    local a = g.accessors[index + 1]
    local view, wide = g.bufferViews[a.bufferView + 1], a.type == "VEC3" and 3 or 1
    assert(view.byteLength == 4 * wide * a.count and (a.componentType == 5126 or a.componentType == 5125))
    local out, at, low, high = {}, start + view.byteOffset + 1, { 1 / 0, 1 / 0, 1 / 0 }, { -1 / 0, -1 / 0, -1 / 0 }
    for i = 1, a.count do
      local item = { string.unpack(a.componentType == 5126 and "<" .. ("f"):rep(wide) or "<I4", bytes, at) }
      at = at + 4 * wide
      for k = 1, wide do low[k], high[k] = math.min(low[k], item[k]), math.max(high[k], item[k]) end
      out[i] = wide == 1 and item[1] or item
    end
    for k = 1, a.min and wide or 0 do assert(a.min[k] == low[k] and a.max[k] == high[k], "bounds") end
    return out
  end
  return g
end
local function near(a, b, size) assert(math.abs(a - b) <= 2e-7 * size, ("%.9g %.9g"):format(a, b)) end
local function sum(a, b) return { a[1] + b[1], a[2] + b[2], a[3] + b[3] } end

-- --- a strip, pulled: the frames are the nodes of the run, the colours those of a field on the nodes ---
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.03, nx = 2, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(5e-3, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.25 }
a:vtk("pull", { points = "reference" })
local seen = {}
local function look()
  local frame = {}
  for i = 1, #mesh.nodes do frame[i] = a:node(i) end
  seen[#seen + 1] = frame
end
look()
a:every("step", look):solve()
if #seen == 6 then table.remove(seen, 1) end
local r = fabric.export.gltf { series = "pull.pvd", file = "pull.glb", field = "uy", duration = 3, shapes = "morph" }
assert(r.frames == 5 and r.low == 0 and math.abs(r.high - 5e-3) < 1e-15 and r.duration == 3)
local g = open "pull.glb"
local p = g.meshes[1].primitives[1]
assert(#g.meshes == 1 and #p.targets == 4 and #g.meshes[1].weights == 4 and g.materials[1].doubleSided == true)
local base, colours = g.read(p.attributes.POSITION), g.read(p.attributes.COLOR_0)
for f = 1, 5 do
  local moved = f > 1 and g.read(p.targets[f - 1].POSITION)
  local shade = f > 1 and g.read(p.targets[f - 1].COLOR_0)
  local across = f > 1 and g.read(p.targets[f - 1].NORMAL) or g.read(p.attributes.NORMAL)
  for i = 1, #mesh.nodes do
    local x = moved and sum(base[i], moved[i]) or base[i]
    near(x[1], seen[f][i].x, 0.03)
    near(x[2], seen[f][i].y, 0.03)
    local n = f > 1 and across[i] or sum(across[i], { 0, 0, -1 })
    assert(math.abs(n[1]) + math.abs(n[2]) + math.abs(n[3]) < 1e-6)
    local c = shade and sum(colours[i], shade[i]) or colours[i]
    for k = 1, 3 do assert(c[k] > -1e-6 and c[k] < 1 + 1e-6) end
    -- viridis from dark blue (68, 1, 84) to yellow (253, 231, 37), as light
    local light = function(s) s = s / 255 return s <= 0.04045 and s / 12.92 or ((s + 0.055) / 1.055) ^ 2.4 end
    local last = seen[f][i].uy == 0 and { 68, 1, 84 } or f == 5 and i > 9 and { 253, 231, 37 }
    for k = 1, last and 3 or 0 do near(c[k], light(last[k]), 1) end
  end
end
local ids = g.read(p.indices)
assert(#ids == 3 * 12)
for t = 1, #ids, 3 do -- counter-clockwise as the shell's normal is
  local q, s, u = base[ids[t] + 1], base[ids[t + 1] + 1], base[ids[t + 2] + 1]
  assert((s[1] - q[1]) * (u[2] - q[2]) - (s[2] - q[2]) * (u[1] - q[1]) > 0)
end
local animation = g.animations[1]
local times, weights = g.read(animation.samplers[1].input), g.read(animation.samplers[1].output)
assert(#times == 5 and times[1] == 0 and times[2] == 0.75 and times[5] == 3 and #weights == 20)
for f = 1, 5 do
  for k = 1, 4 do assert(weights[4 * (f - 1) + k] == (k == f - 1 and 1 or 0)) end
end
assert(animation.channels[1].target.path == "weights" and g.nodes[animation.channels[1].target.node + 1].mesh == 0)

-- --- fields of elements, fewer frames, given ends of the scale; a run as it stands ---
r = fabric.export.gltf { series = "pull.pvd", file = "few.glb", field = "S11", every = 0.5, range = { 0, 1e6 } }
assert(r.frames == 3 and r.high == 1e6)
r = fabric.export.gltf { run = a, file = "one.glb", field = "E12" }
assert(r.frames == 1)
g = open "one.glb"
assert(g.animations == nil and g.meshes[1].primitives[1].targets == nil and g.meshes[1].weights == nil)
assert(fabric.export.gltf({ run = a, file = "plain.glb" }).low == nil)
assert(open "plain.glb".meshes[1].primitives[1].attributes.COLOR_0 == nil)

-- --- a mesh for each frame, shown by turns: the same shapes and colours ---
r = fabric.export.gltf { series = "pull.pvd", file = "turns.glb", field = "uy", duration = 3 }
local turns = open "turns.glb"
g = open "pull.glb"
assert(#turns.meshes == 5 and #turns.nodes == 6 and #turns.nodes[1].children == 5 and #turns.materials == 1)
assert(turns.nodes[2].scale == nil and turns.nodes[3].scale[1] == 0)
for f = 1, 5 do
  local q = turns.meshes[f].primitives[1]
  assert(q.targets == nil and turns.meshes[f].weights == nil)
  local x, c = turns.read(q.attributes.POSITION), turns.read(q.attributes.COLOR_0)
  local shade = f > 1 and g.read(p.targets[f - 1].COLOR_0)
  for i = 1, #x do
    near(x[i][2], seen[f][i].y, 0.03)
    for k = 1, 3 do near(c[i][k], colours[i][k] + (shade and shade[i][k] or 0), 1) end
  end
  local channel = turns.animations[1].channels[f]
  local sampler = turns.animations[1].samplers[channel.sampler + 1]
  local scale = turns.read(sampler.output)
  assert(channel.target.node == f and channel.target.path == "scale" and sampler.interpolation == "STEP" and turns.read(sampler.input)[5] == 3)
  for k = 1, 5 do assert(scale[k][1] == (k == f and 1 or 0) and scale[k][3] == scale[k][1]) end
end

-- --- a ball on the sheet is there too, and both move ---
local sheet = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 4, ny = 4, origin = { -0.05, -0.05, 0 } }
local ball = fabric.rigid.sphere { radius = 0.02, centre = { 0, 0, 0.022 } }
m = fabric.model { mesh = sheet, card = fabric.card "blend", warp = 0 }
m:fix("boundary", "x y z"):contact { between = { ball, "all" } }
m:move(ball, { z = fabric.ramp(-5e-3, 5e-3) })
local b = fabric.dynamic { model = m, duration = 5e-3 }
b:vtk("ball", { every = 1e-3 })
b:solve()
fabric.export.gltf { series = "ball.pvd", file = "turns2.glb", field = "uz", shapes = "frames", every = 2e-3 }
assert(#open "turns2.glb".meshes == 8 and #open "turns2.glb".animations[1].channels == 8 and #open "turns2.glb".materials == 2)
r = fabric.export.gltf { series = "ball.pvd", file = "ball.glb", field = "displacement", duration = 2, shapes = "morph" }
g = open "ball.glb"
assert(r.frames == 6 and #g.meshes == 2 and g.nodes[1].rotation and #g.nodes[1].children == 2 and #g.animations[1].channels == 2)
local body = g.meshes[2].primitives[1]
local down = g.read(body.targets[5].POSITION)
for i = 1, #down do near(down[i][3], -5e-3, 0.02) end
fabric.export.gltf { run = b, file = "now.glb", up = "y" }
assert(#open "now.glb".meshes == 2 and open "now.glb".nodes[1].rotation == nil)

-- --- other programs ---
local function said(command)
  local pipe = io.popen(command .. " 2>&1")
  local text = pipe:read "a"
  return pipe:close(), text
end
if os.execute "command -v assimp >/dev/null 2>&1" then
  local good, text = said "assimp info turns.glb"
  assert(good and text:find "Animations:%s+1\n" and text:find "Animation Channels:%s+5\n" and text:find "Meshes:%s+5\n", text)
  good, text = said "assimp info ball.glb"
  assert(good, text)
  assert(text:find "Animations:%s+1\n" and text:find "Materials:%s+2\n" and text:find "'run'" and text:find "cloth %(mesh 0%)", text)
  assert(text:find "sphere %(mesh 1", text) -- the triangles at its poles have no area, which it takes for lines: a mesh of their own
  assert(tonumber(text:match "Vertices:%s+(%d+)") >= 25 and tonumber(text:match "Faces:%s+(%d+)") >= 32, text)
else
  print "SKIPPED, not installed: assimp (assimp-utils), the .glb was not read by it"
end
local python = "/usr/bin/python3"
if os.execute(python .. " -c 'import vtk' 2>/dev/null") then
  fabric.write("read.py", [[
import vtk
r = vtk.vtkGLTFReader()
r.SetFileName("pull.glb")
r.Update()
out = r.GetOutput()
it = out.NewIterator()
data = it.GetCurrentDataObject()
print(data.GetNumberOfPoints(), data.GetNumberOfCells(), data.GetPointData().GetArray("COLOR_0").GetNumberOfComponents(), r.GetNumberOfAnimations(), r.GetAnimationDuration(0))
]])
  local good, text = said(python .. " read.py")
  assert(good and text:find("12 12 3 1 3.0", 1, true), text)
else
  print "SKIPPED, not installed: python3-vtk9, the .glb was not read by it"
end

-- --- what can't be ---
local function wrong(words, t)
  local good, message = pcall(fabric.export.gltf, t)
  assert(not good and tostring(message):find(words, 1, true), tostring(message))
end
wrong("gltf: field 'series': expected either series or run, got neither", { file = "x.glb" })
wrong("gltf: field 'series': expected either series or run, got both", { file = "x.glb", series = "pull.pvd", run = a })
wrong("gltf: field 'file': expected a name that ends in .glb, got 'x.obj'", { file = "x.obj", run = a })
wrong("gltf: field 'range': expected {low, high}, low below high", { file = "x.glb", run = a, field = "uy", range = { 1, 0 } })
wrong("gltf: field 'range': expected a field, whose range it is", { file = "x.glb", run = a, range = { 0, 1 } })
wrong("gltf: pull_00000.vtu has no field 'tension_warp'; arrays: displacement", { file = "x.glb", series = "pull.pvd", field = "tension_warp" })
wrong("cannot read 'none.pvd'", { file = "x.glb", series = "none.pvd" })
fabric.write("bad.pvd", "<VTKFile type=\"Collection\"><Collection>\n<DataSet timestep=\"x\" file=\"a\"/></Collection></VTKFile>")
wrong("bad.pvd:2: <DataSet>: expected timestep=\"a number\" and file=\"a name\"", { file = "x.glb", series = "bad.pvd" })
fabric.write("empty.pvd", "<VTKFile type=\"Collection\"><Collection></Collection></VTKFile>")
wrong("gltf: 'empty.pvd' holds no frame", { file = "x.glb", series = "empty.pvd" })
wrong("pull_00000.vtu:2: expected a .pvd file", { file = "x.glb", series = "pull_00000.vtu" })
