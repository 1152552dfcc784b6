-- Pictures of sheets. Without a display and without Xvfb this test says so and checks the messages alone.
local fabric = require "fabric"
local folder = "out"
local test = fabric.lab.bias { card = fabric.card "blend", grips = "clamped", unload = false, steps = 4, out = folder }
local frames = { folder .. "/strip_00000.vtu", folder .. "/strip_00002.vtu", folder .. "/strip_00004.vtu" }

-- Width and height of a PNG, or nil.
local function size_of(path)
  local file = io.open(path, "rb")
  if not file then return nil end
  local head = file:read(24)
  file:close()
  if head:sub(1, 8) ~= "\137PNG\r\n\26\n" then return nil end
  return string.unpack(">I4I4", head, 17)
end

local function refused(fields, words)
  local ok, message = pcall(fabric.render, fields)
  assert(not ok and tostring(message):find(words, 1, true), ("expected '%s', got %s"):format(words, tostring(message)))
end
refused({ file = "a.jpg", vtu = frames }, "field 'file': expected a name that ends in .png")
refused({ file = "a.png" }, "field 'vtu': expected either vtu or run")
refused({ file = "a.png", vtu = frames, run = test.analysis }, "field 'vtu': expected either vtu or run")
refused({ file = "a.png", vtu = frames, field = "S99" }, "field 'field'")
refused({ file = "a.png", vtu = frames, view = { 1, 2, 3 } }, "field 'view': expected {azimuth, elevation}")
refused({ file = "a.png", vtu = frames, range = { 2, 1 } }, "field 'range': expected {low, high}")

local mm = fabric.units.mm
refused({ file = "a.png", vtu = frames, view = "front", views = { "side" } }, "field 'views': expected either view or views, got both")
refused({ file = "a.png", vtu = frames, views = {} }, "field 'views': expected a list of views, got an empty table")
refused({ file = "a.png", vtu = frames, views = { "frunt" } }, "field 'views': unknown view 'frunt', did you mean 'front'?")
refused({ file = "a.png", vtu = frames, views = { { 0, 95 } } }, "field 'views': expected {azimuth, elevation}")
refused({ file = "a.png", vtu = frames, views = { 5 } }, "field 'views': expected names of views or {azimuth, elevation}, got 5")
refused({ file = "a.png", vtu = frames[1], views = { "front", "side" }, labels = { "a", "b", "c" } }, "field 'labels': expected no more labels than panels")
refused({ file = "a.png", vtu = frames, size = { 85, 60 } }, "field 'size': expected {width, height} in m, each from 0.02 to 1")
refused({ file = "a.png", vtu = frames, size = { 85 * mm, 60 * mm }, width = 800 }, "field 'width': expected either size, on paper, or width and height in pixels")
refused({ file = "a.png", vtu = frames, dpi = 600 }, "field 'dpi': goes with size")
refused({ file = "a.png", vtu = frames, size = { 1, 1 }, dpi = 600 }, "field 'size': expected a picture of 100 to 8000 pixels either way, got 23622 x 23622")

local drawn, trouble = pcall(fabric.render, { file = folder .. "/live.png", run = test.analysis, field = "E12", width = 400, height = 500 })
if not drawn and tostring(trouble):find("no display to draw on", 1, true) then
  print("SKIPPED: nothing was drawn, " .. tostring(trouble))
  return
end
assert(drawn, trouble)
local width, height = size_of(folder .. "/live.png")
assert(width == 400 and height == 500)

fabric.render { file = folder .. "/panels.png", vtu = frames, labels = { "start", "10 mm" }, field = "S11", title = "three", view = "oblique", width = 300, height = 200 }
assert(size_of(folder .. "/panels.png") == 300)
fabric.render { file = folder .. "/point.png", vtu = frames[3], field = "uy", axes = false, edges = false, width = 200, height = 200 }
refused({ file = folder .. "/none.png", vtu = folder .. "/strip_00009.vtu" }, "no file '" .. folder .. "/strip_00009.vtu'")
fabric.mesh.rectangle({ width = 0.1, height = 0.1, nx = 2, ny = 2 }):write(folder .. "/bare.vtu")
refused({ file = folder .. "/none.png", vtu = folder .. "/bare.vtu", field = "S11" }, "has no field 'S' S11")
assert(not io.open(folder .. "/none.png"))

-- Of a file that is cut off the library's words alone are told, not where in its sources they were said.
local whole = assert(io.open(frames[2], "rb")):read "a"
fabric.write(folder .. "/cut.vtu", whole:sub(1, #whole // 2))
local ok, message = pcall(fabric.render, { file = folder .. "/none.png", vtu = folder .. "/cut.vtu", field = "S11" })
assert(not ok and tostring(message):find("render: 'out/cut.vtu' is not whole, or no .vtu file: ", 1, true), message)
assert(not tostring(message):find "0x" and not tostring(message):find "%.cxx" and not tostring(message):find "\n", message)

-- The picture shows the sheet: with another field on the same sheet other bytes, with the same field the same ones.
local function bytes(field, name)
  fabric.render { file = folder .. name, vtu = frames[3], field = field, width = 300, height = 300 }
  local file = io.open(folder .. name, "rb")
  local all = file:read "a"
  file:close()
  return all
end
local first = bytes("E12", "/1.png")
assert(first == bytes("E12", "/2.png") and first ~= bytes("E11", "/3.png"))

-- On paper: pixels by size and resolution, which the file says.
local function content(path)
  local file <close> = assert(io.open(path, "rb"))
  return file:read "a"
end
fabric.render { file = folder .. "/paper.png", vtu = frames[3], field = "E12", size = { 85 * mm, 60 * mm }, dpi = 72 }
width, height = size_of(folder .. "/paper.png")
assert(width == 241 and height == 170, width .. " x " .. height)
local per_metre = string.unpack(">I4", content(folder .. "/paper.png"), 42)
assert(per_metre == 2835) -- 72 / 0.0254

-- Several views, of one state and of several; smooth colours are others than flat ones.
fabric.render { file = folder .. "/views.png", vtu = frames[3], field = "E12", views = { "front", "side", "above", "oblique" }, width = 300, height = 200 }
fabric.render { file = folder .. "/both.png", vtu = { frames[2], frames[3] }, field = "E12", views = { "above", { 30, 40 } }, width = 300, height = 200 }
assert(content(folder .. "/views.png") ~= content(folder .. "/both.png"))
local function drawn_with(fields)
  fields.file, fields.vtu, fields.field, fields.width, fields.height = folder .. "/with.png", frames[3], "E12", 300, 300
  fabric.render(fields)
  return content(fields.file)
end
assert(drawn_with { smooth = true } ~= first)

-- Words that have no room are cut off, which is told.
fabric.render { file = folder .. "/cut.png", vtu = frames[3], width = 120, height = 200, title = ("a long title "):rep(20) }

-- Bodies are shown, clear or left out; then the picture is as large as the cloth. A tall thing needs no wide picture.
do
  local ball = fabric.rigid.sphere { radius = 0.02, centre = { 0.03, 0.03, -0.035 } }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.06, height = 0.06, nx = 3, ny = 3 }, card = fabric.card "blend", warp = 0 }
  m:contact { between = { "all", ball } }
  local a = fabric.dynamic { model = m, duration = 1e-4 }
  a:step()
  local drawn = {}
  for i, bodies in ipairs { "shown", "clear", "none" } do
    local file = ("%s/body%d.png"):format(folder, i)
    fabric.render { file = file, run = a, bodies = bodies, view = "oblique", width = 300, height = 200 }
    drawn[i] = content(file)
  end
  assert(drawn[1] ~= drawn[2] and drawn[2] ~= drawn[3] and drawn[1] ~= drawn[3])
  refused({ file = "a.png", run = a, bodies = "some" }, "field 'bodies'")
  local tall = fabric.model { mesh = fabric.mesh.rectangle { width = 0.02, height = 0.2, nx = 1, ny = 8 }, card = fabric.card "blend", warp = 0 }:fix("bottom", "x y z rotation")
  local strip = fabric.static { model = tall, duration = 1, step = 1 }:solve()
  for i, fit in ipairs { true, false } do
    fabric.render { file = folder .. "/tall.png", run = strip, fit = fit, width = 1000, height = 600 }
    local across, up = size_of(folder .. "/tall.png")
    assert(up == 600 and (i == 1 and across < 500 or i == 2 and across == 1000), across)
  end
end
