-- fabric.export.model: decks parsed back, by meshio too; CalculiX runs the .inp of a strip and gives our force.
local fabric = require "fabric"
local rows = {}
local function check(label, got, want, relative) rows[#rows + 1] = { label, got, want, relative = relative } end
local function near(label, got, want, absolute) rows[#rows + 1] = { label, got, want, absolute = absolute } end
local function there(command) return os.execute("command -v " .. command .. " >/dev/null 2>&1") end
local function skip(what) print(("SKIPPED, not installed: %s"):format(what)) end

local function strip() return fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 3, ny = 9 } end
local function pulled(card, free)
  local mesh = strip()
  mesh:set("corner", { 1 })
  local m = fabric.model { mesh = mesh, card = card, warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "y")
  if free then m:fix("corner", "x") else m:fix("bottom", "x"):fix("top", "x") end
  return m:move("top", { y = fabric.ramp(0.01, 1) })
end
local svk = fabric.svk { warp = 8e6, weft = 37e6, shear = 1e6, poisson = { 0.1, 0.2 }, density = 590, thickness = 0.38e-3 }

-- --- CalculiX ---
for name, free in pairs { clamped = false, free = true } do
  local file = "strip_" .. name
  local m = pulled(svk, free)
  local r = fabric.export.model { model = m, warp = 90, file = file .. ".inp" }
  assert(r.material == "ELASTIC" and r.to == "abaqus" and #r.notes == 0)
  local a = fabric.static { model = m, duration = 1, step = 0.1 }:solve()
  local _, force = a:reaction "top"
  if there "ccx" then
    assert(os.execute(("OMP_NUM_THREADS=1 ccx %s >ccx.txt 2>&1"):format(file)), "ccx")
    local dat = assert(io.open(file .. ".dat")):read "a"
    local last
    for line in dat:gmatch "total force[^\n]*\n%s*\n([^\n]*)" do last = line end
    local _, fy = last:match "(%S+)%s+(%S+)"
    check("pull of a strip, " .. name .. " ends, N: CalculiX and ours", tonumber(fy), force, 1e-4) -- within 1 % is what is promised
  else
    skip "ccx (calculix-ccx), the force of the exported strip was not compared"
  end
end

-- --- meshio reads the .inp ---
local python = "/usr/bin/python3"
if os.execute(python .. " -c 'import meshio' 2>/dev/null") then
  local script = [[import meshio, sys
m = meshio.read("strip_clamped.inp")
q = m.cells_dict["quad"]
print(len(m.points), len(q), m.points[:, 1].max(), int(q.max()), len(m.point_sets["TOP"] if "TOP" in m.point_sets else m.point_sets["top"]))]]
  fabric.write("read.py", script)
  local pipe = io.popen(python .. " read.py 2>&1")
  local said = pipe:read "a"
  pipe:close()
  local n, quads, height, last, top = said:match "(%d+) (%d+) (%S+) (%d+) (%d+)%s*$"
  assert(n, said)
  check("meshio: nodes", tonumber(n), 40, 1e-15)
  check("meshio: quadrilaterals", tonumber(quads), 27, 1e-15)
  check("meshio: height, mm", tonumber(height), 76.2, 1e-9)
  check("meshio: last node", tonumber(last), 39, 1e-15)
  check("meshio: nodes of set top", tonumber(top), 4, 1e-15)
else
  skip "python3-meshio, the .inp was not read by it"
end

-- --- .k and .rad, by readers of the formats' columns ---
local blend = fabric.card "blend"
local m = pulled(blend):gravity { 0, 0, -9.81 }:force("right", { x = 2 })
local function fields(line, width)
  local out = {}
  for i = 1, #line, width do out[#out + 1] = tonumber(line:sub(i, i + width - 1)) or line:sub(i, i + width - 1) end
  return out
end
local function blocks(text, mark, comment)
  local out, block = {}, nil
  for l in text:gmatch "[^\n]+" do
    if l:sub(1, 1) == mark then
      block = { key = l }
      out[#out + 1] = block
      out[l] = out[l] or block
    elseif l:sub(1, 1) ~= comment and block then
      block[#block + 1] = l
    end
  end
  return out
end

local r = fabric.export.model { model = m, warp = 90, file = "strip.k" }
local k = blocks(r.text, "*", "$")
assert(#k["*NODE"] == 40 and #k["*ELEMENT_SHELL"] == 27 and k["*MAT_FABRIC_TITLE"] and k[#k].key == "*END")
local function node(line) return tonumber(line:sub(1, 8)), tonumber(line:sub(9, 24)), tonumber(line:sub(25, 40)) end
local id, x, y = node(k["*NODE"][40])
check("last node of .k, mm", x, 25.4, 1e-9)
check("its height", y, 76.2, 1e-9)
local shell = fields(k["*ELEMENT_SHELL"][27], 8)
assert(id == 40 and shell[1] == 27 and shell[2] == 1 and #shell == 6)
for i = 3, 6 do assert(shell[i] == m.mesh.elements[27][i - 2]) end
check("thickness, mm", fields(k["*SECTION_SHELL"][2], 10)[1], 0.38, 1e-9)
local axis = fields(k["*MAT_FABRIC_TITLE"][5], 10)
near("warp along y: a1", axis[4], 0, 1e-12)
near("warp along y: a2", axis[5], 1, 1e-12)
check("load on a base that moves up, mm/s2", fields(k["*LOAD_BODY_Z"] and k[#k - 2][2] or "", 20)[2], 9810, 1e-9)
local share = 0
for _, l in ipairs(k["*LOAD_NODE_POINT"]) do share = share + fields(l, 10)[4] end
check("shares of the force", share, 1, 1e-7)
assert(fields(k["*LOAD_NODE_POINT"][1], 10)[4] < fields(k["*LOAD_NODE_POINT"][2], 10)[4] * 0.51) -- a corner has half an edge
local held = {}
for _, b in ipairs(k) do
  if b.key == "*BOUNDARY_SPC_SET" then held[#held + 1] = table.concat(fields(b[1], 10), " ", 3) end
end
table.sort(held)
assert(table.concat(held, ",") == "0 0 1 1 1 1,0 1 0 0 0 0,1 0 0 0 0 0,1 0 0 0 0 0", table.concat(held, ","))

r = fabric.export.model { model = m, warp = 90, file = "strip_0000.rad", units = "mm-kg-ms", histories = { ["top.y"] = { { 0, 0 }, { 1, 0.01 }, { 2, 0 } } } }
assert(#r.notes == 0)
local rad = blocks(r.text, "/", "#")
assert(#rad["/NODE"] == 40 and #rad["/SHELL/1"] == 27 and rad["/MAT/LAW58/1"] and rad["/PROP/TYPE16/1"] and rad[#rad].key == "/END")
local last = rad["/NODE"][40]
assert(tonumber(last:sub(1, 10)) == 40)
check("last node of .rad, mm", tonumber(last:sub(31, 50)), 76.2, 1e-9)
check("LAW58: duration in ms, third corner", fields(rad["/FUNCT/101"][4], 20)[1], 2000, 1e-12)
check("stroke, mm", fields(rad["/FUNCT/101"][3], 20)[2], 10, 1e-12)
assert(rad["/IMPDISP/1"][2]:sub(11, 20):match "Y" and rad["/BCS/1"][2]:sub(1, 10) == "   001 111", rad["/BCS/1"][2])
check("gravity, mm/ms2", fields(rad["/FUNCT/103"][3], 20)[2], -9.81e-3, 1e-9)
r = fabric.export.model { model = m, warp = { 0, 2, 0 }, to = "openradioss", material = "LAW19" }
assert(r.text:find("/PROP/TYPE9/1", 1, true) and r.text:find("\n      2022         0\n", 1, true))
r = fabric.export.model { model = m, warp = 90, to = "openradioss", material = "LAW158" } -- the format of 2023 is the first that has it
assert(r.material == "LAW158" and r.text:find("/MAT/LAW158/1", 1, true) and r.text:find("/PROP/TYPE16/1", 1, true) and r.text:find("\n      2023         0\n", 1, true))
r = fabric.export.model { model = m, warp = 90, to = "abaqus" }
assert(r.material == "FABRIC" and r.text:find "M3D4R" and r.text:find "%*DYNAMIC, EXPLICIT" and r.text:find "%*MEMBRANE SECTION")

-- A force is shared among its nodes as the model shares it: by area, by length or evenly. Held everywhere, each node reacts with its share.
for _, triangles in ipairs { false, true } do
  local graded = fabric.mesh.rectangle { width = 0.02, height = 0.03, nx = 3, ny = 4, triangles = triangles }
    :map(function(x, y) return x * (1 + 20 * x), y + 0.3 * x, 10 * x * y end)
  graded:set("patch", { 1, 2, 3, 5, 6, 7, 14 })
  graded:set("two", { 1, 20 })
  for _, set in ipairs { "all", "top", "patch", "two" } do
    local loaded = fabric.model { mesh = graded, card = svk, warp = { 1, 0, 0 } }:fix("all", "x y z rotation"):force(set, { x = 0.001 })
    local reaction = fabric.static({ model = loaded, duration = 1, step = 1 }):solve():field "reaction"
    local text, worst, given = fabric.export.model({ model = loaded, warp = 0, to = "abaqus", units = "SI" }).text, 0, {}
    for n, value in text:match("%*CLOAD\n(.-)\n%*"):gmatch "(%d+), 1, (%S+)" do given[tonumber(n)] = tonumber(value) end
    for n = 1, #graded.nodes do worst = math.max(worst, math.abs((given[n] or 0) + reaction[n][1])) end
    near(("shares of '%s'%s, N"):format(set, triangles and ", triangles" or ""), worst, 0, 1e-12)
  end
end

-- Names of sets that are no plain words stand in quotes wherever a deck of Abaqus names them; CalculiX finds them.
do
  local named = strip()
  named:set("left edge", { 1, 5, 9 })
  named:set("123", { 7 })
  named:set("the top", named:set "top")
  local model = fabric.model { mesh = named, card = svk, warp = 90 }
  model:fix("all", "z rotation"):fix("left edge", "x y"):fix("123", "x"):move("the top", { y = fabric.ramp(0.001, 1) })
  local text = fabric.export.model({ model = model, warp = 90, file = "names.inp" }).text
  for _, line in ipairs { '*NSET, NSET="left edge"', '"left edge", 1, 1', '"123", 1, 1', '"the top", 2, 2, 1', '*NODE PRINT, NSET="the top", TOTALS=YES', "all, 3, 3" } do
    assert(text:find("\n" .. line .. "\n", 1, true), line .. "\n" .. text:match "%*BOUNDARY.*")
  end
  if there "ccx" then
    assert(os.execute "OMP_NUM_THREADS=1 ccx names >ccx.txt 2>&1" and not io.open("ccx.txt"):read("a"):find "ERROR", "ccx")
    local last
    for line in io.open("names.dat"):read("a"):gmatch "total force[^\n]*\n%s*\n([^\n]*)" do last = line end
    local _, pull = last:match "(%S+)%s+(%S+)"
    local a = fabric.static({ model = model, duration = 1, step = 0.1 }):solve()
    check("pull of a strip with names in quotes, N: CalculiX and ours", tonumber(pull), select(2, a:reaction "the top"), 1e-3)
  else
    skip "ccx (calculix-ccx)"
  end
end

-- Units, source and losses stand once in a deck, and before the material; notes on the model too.
for _, to in ipairs { "abaqus", "ls-dyna", "openradioss" } do
  r = fabric.export.model { model = m, warp = 90, to = to }
  for _, words in ipairs { "Units: ", "Losses of this law", "its source: ", "cyclic shear" } do
    assert(select(2, r.text:gsub(words, "")) == 1, to .. ": " .. words)
  end
  assert(r.text:find("Losses of this law", 1, true) < r.text:find(({ abaqus = "\n*MATERIAL", ["ls-dyna"] = "\n*MAT_FABRIC", openradioss = "\n/MAT/" })[to], 1, true))
end

-- A drape: a square held at its corners, of triangles too.
local sheet = fabric.mesh.rectangle { width = 1, height = 1, nx = 4, ny = 4, triangles = true }
local drape = fabric.model { mesh = sheet, card = blend, warp = 0 }:fix("corners", "x y z"):gravity { 0, 0, -9.81 }
for _, file in ipairs { "drape.inp", "drape.k", "drape.rad" } do
  local text = fabric.export.model({ model = drape, warp = 0, file = file, duration = 0.5 }).text
  assert(io.open(file):read "a" == text)
end
assert(io.open("drape.inp"):read "a":find "cloth, GRAV, 9810, 0, 0, %-1")
assert(#blocks(io.open("drape.rad"):read "a", "/", "#")["/SH3N/1"] == 32)

-- --- refusals ---
local function wrong(words, t)
  local good, message = pcall(fabric.export.model, t)
  assert(not good and tostring(message):find(words, 1, true), "expected: " .. words .. "\ngot: " .. tostring(message))
end
wrong("model: field 'file': expected a name that ends in .inp, .k or .rad, or field 'to', got 'strip.dat'", { model = m, warp = 90, file = "strip.dat" })
wrong("field 'file': expected a name that ends in .k for ls-dyna, got 'strip.inp'", { model = m, warp = 90, file = "strip.inp", to = "ls-dyna" })
local turned = fabric.model { mesh = strip(), card = blend, warp = function(x) return 1000 * x end }
wrong("model: field 'warp': expected the direction of the warp, which differs from place to place in this model, got nil", { model = turned, file = "strip.inp" })
for _, warp in ipairs { { 0, 0, 0 }, { 1, 2, 3, 4 }, { 1 } } do
  wrong(("model: field 'warp': expected a direction {x, y, z} other than zero, got {%s}"):format(table.concat(warp, ", ")), { model = m, warp = warp, to = "abaqus" })
end
wrong("/proc/nowhere", { model = m, warp = 90, file = "/proc/nowhere/strip.inp" })
local sprung = pulled(blend):spring("right", { x = 10 })
wrong("model: field 'model': a spring ('right') cannot be exported; expected fix, move, force and gravity of one sheet",
  { model = sprung, warp = 90, to = "abaqus" })
wrong("model: field 'histories.top.y': expected points {t, v} with times that increase, got something else at place 2", { model = m, to = "abaqus", histories = { ["top.y"] = { { 0, 0 }, { 0, 1 } } } })
fabric.expect(rows)
