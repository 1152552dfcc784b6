-- Histories in decks of other solvers: every point with its digits, functions of time within the error that the notes state. The decks are read back.
local fabric = require "fabric"
local mm = fabric.units.mm

local mesh = fabric.mesh.rectangle { width = 21 * mm, height = 33 * mm, nx = 2, ny = 3 }
local stroke = { { 0.1, 0 }, { 0.3, 2 * mm / 3 }, { 0.45, -1 * mm / 7 }, { 0.8, 4.1 * mm }, { 1.7, 1 * mm / 9 }, { 2.9, 5 * mm } }
local pull = { { 0, 0.25 }, { 0.5, 7 / 3 }, { 1.1, -1e-7 / 3 } }
local function model(history)
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y")
  return m:move("top", { y = history or fabric.history(stroke), x = 1.5 * mm }):force("left", { x = fabric.history(pull) })
end

-- Tables of time and value in a deck, as lists of points in SI units; ft, fl, ff: SI over the deck's units.
local function numbers(line)
  local out = {}
  for word in line:gmatch "[^%s,]+" do out[#out + 1] = assert(tonumber(word), line) end
  return out
end
local function tables(text, begins, skipped)
  local out, left, now = {}, 0, nil
  for line in text:gmatch "[^\n]+" do
    if line:find(begins) then
      now, left = {}, skipped
      out[#out + 1] = now
    elseif left > 0 then
      left = left - 1
    elseif line:find "^[*/]" then
      now = nil
    elseif now and not line:find "^[#$]" then
      now[#now + 1] = numbers(line)
    end
  end
  return out
end
local readers = {
  abaqus = function(text) return tables(text, "^%*AMPLITUDE", 0) end,
  ["ls-dyna"] = function(text) return tables(text, "^%*DEFINE_CURVE$", 1) end,
  openradioss = function(text) return tables(text, "^/FUNCT/1%d%d$", 1) end,
}
local function same(got, points, scale, share, last)
  local want = {}
  if points[1][1] > 0 then want[1] = { 0, points[1][2] } end
  for _, p in ipairs(points) do want[#want + 1] = p end
  if want[#want][1] < last then want[#want + 1] = { last, want[#want][2] } end
  if #got ~= #want then return false end
  for i, p in ipairs(want) do
    if math.abs(got[i][1] - p[1]) > share * math.abs(p[1]) or math.abs(got[i][2] - p[2] * scale) > share * math.abs(p[2] * scale) then return false end
  end
  return true
end
local function found(all, ...)
  for _, got in ipairs(all) do
    if same(got, ...) then return true end
  end
  return false
end

for _, case in ipairs { { "abaqus", 1e-15 }, { "ls-dyna", 1e-12 }, { "openradioss", 1e-12 } } do
  local to, share = table.unpack(case)
  local r = fabric.export.model { model = model(), warp = 90, to = to, units = "SI", duration = 3.5 }
  assert(#r.notes == 0, r.notes[1])
  local all = readers[to](r.text)
  assert(found(all, stroke, 1, share, 3.5), to .. ": the stroke is not in the deck")
  assert(found(all, pull, 1, share, 3.5), to .. ": the force is not in the deck")
end

-- The direction of the warp is the model's; another one is refused, and so is one that nobody knows.
local m = model()
assert(fabric.export.model { model = m, to = "ls-dyna" }.text == fabric.export.model { model = m, warp = { 0, 3, 0 }, to = "ls-dyna" }.text)
local ok, why = pcall(fabric.export.model, { model = m, warp = 80, to = "ls-dyna" })
assert(not ok and tostring(why):find("field 'warp': expected the model's own direction {", 1, true), why)

-- A function of time: the written points hold the stated error everywhere, a jump and a fast part too, and fewer points do where it is straight.
local shapes = {
  swing = function(t) return 3 * mm * math.sin(9 * t) * math.exp(-t) end,
  step = function(t) return t < 0.731 and 0 or 2 * mm end,
  line = function(t) return 1 * mm * t end,
}
for name, shape in pairs(shapes) do
  for _, error in ipairs { 1e-2, 1e-4 } do
    local r = fabric.export.model { model = model(shape), to = "abaqus", units = "SI", duration = 2, error = error }
    assert(#r.notes == 1 and r.notes[1]:find "^move of top along y: a function of time, written as %d+ points" and r.text:find("a function of time", 1, true), r.notes[1])
    local points
    for _, got in ipairs(readers.abaqus(r.text)) do
      if got[#got][1] == 2 and #got > 5 then points = got end
    end
    local low, high, worst, wide = math.huge, -math.huge, 0, 0
    for i = 2, #points do
      local a, b = points[i - 1], points[i]
      for k = 0, 10 do
        local t = a[1] + (b[1] - a[1]) * k / 10
        local v = shape(t)
        low, high = math.min(low, v), math.max(high, v)
        local off = math.abs(a[2] + (b[2] - a[2]) * k / 10 - v)
        if off > worst then worst, wide = off, b[1] - a[1] end
      end
    end
    -- a jump is as narrow as it was cut
    assert(worst <= 1.3 * error * (high - low) or wide < 1e-6, ("%s: %g of %g over %g s"):format(name, worst, high - low, wide))
    assert(name ~= "line" or #points == 33, #points)
  end
end

-- Data of every kind of declaration, as it was given.
local all = fabric.model { mesh = fabric.mesh.rectangle { width = 1, height = 1, nx = 2, ny = 2 }, card = fabric.card "denim", warp = 30, membrane = true }
all:spring("left", { x = 10, z = 3 }):pressure(fabric.ramp(5, 2)):gravity { 0, 0, function(t) return -9.81 * t end }
all:force("top", { y = 2 }, { frame = { { 0, 1, 0 }, { -1, 0, 0 } } }):velocity("bottom", { z = 1, spin = { 0, 0, 90 } })
local rows = {}
for _, row in ipairs(all:declared()) do rows[row.kind] = row end
assert(rows.sheet.membrane and rows.sheet.points == 3 and math.abs(rows.sheet.warp[1] - math.cos(math.rad(30))) < 1e-12)
assert(rows.spring.x == 10 and rows.spring.y == nil and rows.spring.z == 3)
assert(rows.pressure.value:points()[2][1] == 2 and rows.pressure.value:points()[2][2] == 5)
assert(rows.gravity.z:points() == nil and rows.gravity.z:value(2) == -19.62 and rows.gravity.x:points()[1][2] == 0)
assert(tostring(rows.gravity.z) == "<history, a function of time>")
assert(rows.force.frame[1][2] == 1 and rows.force.y:points()[1][2] == 2)
assert(rows.velocity.linear[3] == 1 and math.abs(rows.velocity.spin[3] - 90) < 1e-12)

-- Gravity that varies is written, too.
local falling = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }:fix("bottom", "x y z"):gravity { 0, 1, fabric.history { { 0, 0 }, { 1, -9.81 }, { 2, -3 } } }
for to, reader in pairs(readers) do
  local r = fabric.export.model { model = falling, to = to, units = "SI" }
  assert(found(reader(r.text), { { 0, 0 }, { 1, -9.81 }, { 2, -3 } }, to == "ls-dyna" and -1 or 1, 1e-12, 2), r.text)
end
