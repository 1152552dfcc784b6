-- A folder of measurements: what counts as a specimen, what laboratory.lua must say; the card that comes of it.
local fabric = require "fabric"
local lab = fabric.lab
local folder = require "fabric.lab.folder"

local sample = arg[0]:gsub("tests/lua/[^/]*$", "") .. "share/data/synthetic-blend/"
local place = os.tmpname()
os.remove(place)
assert(os.execute("mkdir '" .. place .. "'"))

local function write(name, text)
  local f = assert(io.open(place .. "/" .. name, "w"))
  f:write(text)
  f:close()
end
local function remove(name) assert(os.remove(place .. "/" .. name)) end
local function text_of(name)
  local f = assert(io.open(sample .. name))
  local text = f:read "a"
  f:close()
  return text
end
local function refused(words)
  local ok, message = pcall(folder.reduce, place)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end

for _, name in ipairs(fabric.folder(sample)) do
  if name:find "%-[12][%-.]" or name == "laboratory.lua" then write(name, text_of(name)) end
end
local clean = folder.reduce(place)
assert(#clean.warp.tests == 2 and #clean.weft.tests == 2 and #clean.shear.tests == 2)

-- pictures of an earlier run and copies are no specimens
write("warp-residual.svg", "<svg/>")
write("warp-1.bak", text_of "warp-1.csv")
write("bias-1-frames.bak", "")
local again = folder.reduce(place)
assert(#again.warp.tests == 2 and #again.shear.tests == 2 and again.card.warp.loading[1] == clean.card.warp.loading[1])
write("warp-1.txt", text_of "warp-1.csv")
refused "expected one file for specimen 1, got warp-1.csv and warp-1.txt"
remove "warp-1.txt"

-- laboratory.lua
local about = text_of "laboratory.lua"
local function with(from, to)
  local text, count = about:gsub(from, to)
  assert(count == 1)
  write("laboratory.lua", text)
end
with("return {", "local about = {")
refused "laboratory.lua: expected 'return { name=, gauge_length=, ... }' at its end, got nil"
with("markers = { 4, 3 }, ", "")
refused "laboratory.lua: field 'markers': expected {rows, columns} of the grid, for "
with("mass_per_area = 0.2242, ", "")
refused "laboratory.lua: field 'density': expected density (kg/m^3) or mass_per_area (kg/m^2)"
with("gauge_length = 76.2e%-3", "gauge_lenght = 76.2e-3")
refused "laboratory.lua: unknown field 'gauge_lenght', did you mean 'gauge_length'?"
with("width = 25.4e%-3, ", "")
refused "laboratory.lua: field 'width': expected a length in m, got nil"
remove "laboratory.lua"
refused "laboratory.lua"
assert(os.execute("rm -r '" .. place .. "'"))

-- One replicate of four that only loads: the loading keeps its band, the unloading that of the three others.
local function test(scale, back)
  local E, S, n = {}, {}, 60
  for i = 0, n do E[i + 1] = i / 300; S[i + 1] = scale * (8e6 * E[i + 1] + 4e8 * E[i + 1] ^ 2) end
  local branches = { { kind = "loading", first = 1, last = n + 1 } }
  if back then
    for i = 1, 10 do E[n + 1 + i] = E[n + 1] - i * 1e-4; S[n + 1 + i] = S[n + 1] - scale * 900e6 * i * 1e-4 end
    branches[2] = { kind = "unloading", first = n + 2, last = n + 11 }
  end
  return { E = E, S = S, branches = branches }
end
local whole = lab.fit { tests = { test(1, true), test(1.02, true), test(0.97, true), test(1.01, true) }, degree = 2 }
for hole = 1, 4 do
  local tests = {}
  for i, scale in ipairs { 1, 1.02, 0.97, 1.01 } do tests[i] = test(scale, i ~= hole) end
  local part = lab.fit { tests = tests, degree = 2 }
  local points = lab.fit { tests = tests, degree = "monotone" }
  local card = lab.card { name = "mine", density = 600, thickness = 4e-4, warp = part, weft = whole, shear = points, poisson = { warp = 0.2, weft = 0.3 } }
  local bands = card.bands
  for i = 1, 2 do
    assert(bands.warp.low[i] == part.band.low[i] and bands.warp.high[i] == part.band.high[i] and bands.warp.low[i] < bands.warp.high[i])
    assert(bands.weft.low[i] == whole.band.low[i])
  end
  assert(bands.warp.low[3] == part.unloading_band.low[1] and bands.warp.low[3] < part.unloading and part.unloading < bands.warp.high[3])
  assert(bands.warp.covariance[2 * 4 + 3] == part.unloading_band.covariance[1] and bands.warp.covariance[3] == 0)
  assert(card.source == "warp: 4 specimens, polynomial of degree 2; weft: 4 specimens, polynomial of degree 2; shear: 4 specimens, monotone curve", card.source)
end
