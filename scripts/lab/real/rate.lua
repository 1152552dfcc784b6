-- Evidence of a viscous part in the speed of a bias pull: plain-weave glass/PP, 18 to 23 % less force at 500 than at 10 mm/min [cao2008, fig. 40].
--
--   fabricsh scripts/lab/real/rate.lua [file mm/min file mm/min ...]
--
-- Files are displacement and force (mm and N, where headings say nothing else) of pulls whose size stands in the name (150x450), each followed by its speed.
-- The records are not part of the program: they lie in ../shared/data beside this checkout, or the deck says SKIPPED. Curves at two speeds are read
-- from bias-extension-150x450-10mm-min.csv and -500mm-min.csv where these are there; else the curve of 150 x 450 mm stands for the slow one, and
-- the same with the printed part less force for the fast one, which is told.
local fabric = require "fabric"
local lab, mm = fabric.lab, fabric.units.mm

local place = (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/cao-2008/bias-extension-150x450"
local function there(name)
  local f = io.open(name)
  if f then f:close() end
  return f ~= nil
end
if #arg == 0 and not there(place .. ".csv") then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
if fabric.checking() then return end

local speeds = { 10 * mm / 60, 500 * mm / 60 } -- m/s
local function pull(file, speed, part)
  local headings = fabric.table({ file = file, lenient = true }).header
  local record = lab.read { file = file, columns = not headings and { displacement = 1, force = 2 } or nil, default_units = { displacement = "mm", force = "N" } }
  local width, length = file:match "(%d+%.?%d*)x(%d+%.?%d*)[^/]*$"
  if not width then error(file .. ": expected the size in the file's name, such as 150x450 (width and length in mm)", 0) end
  local t = { displacement = {}, force = {}, width = width * mm, length = length * mm, speed = speed, name = ("%g mm/min"):format(speed / mm * 60) }
  local largest = 0
  for k, d in ipairs(record.displacement) do -- read off a print: what goes back is the reading's noise
    if d > largest then
      t.displacement[#t.displacement + 1], t.force[#t.force + 1], largest = d, record.force[k] * (1 - (part or 0)), d
    end
  end
  return t
end

local function say(tests, words)
  local v = lab.viscous { tests = tests, thickness = 1 * mm }
  print(words .. ":\n" .. v.text .. "\n")
  return v
end
if #arg > 0 then
  local pulls = {}
  for i = 1, #arg, 2 do
    local speed = tonumber(arg[i + 1])
    if not speed or speed <= 0 then error(("usage: fabricsh rate.lua file mm/min ...; expected the speed of '%s', got %s"):format(arg[i], tostring(arg[i + 1])), 0) end
    pulls[#pulls + 1] = pull(arg[i], speed * mm / 60)
  end
  local v = say(pulls, "as given")
  fabric.expect { { "a viscosity, or a reason why there is none (1: yes)", (v.viscous or v.reason) and 1 or 0, 1, absolute = 0 } }
  return
end
local rows = {}
local slow, fast = place .. "-10mm-min.csv", place .. "-500mm-min.csv"
if there(slow) and there(fast) then
  local v = say({ pull(slow, speeds[1]), pull(fast, speeds[2]) }, "measured at 10 and 500 mm/min")
  rows[1] = { "the fast record is the softer one", v.contradicts and 1 or 0, 1, absolute = 0 }
else
  print "the curves of fig. 40 are not there: made of the curve of 150 x 450 mm and the printed percentages\n"
  for _, less in ipairs { 0.18, 0.23 } do
    local v = say({ pull(place .. ".csv", speeds[1]), pull(place .. ".csv", speeds[2], less) }, ("%g %% less at 500 mm/min"):format(100 * less))
    rows[#rows + 1] = { ("%g %% less: no viscosity is found"):format(100 * less), v.viscous and 1 or 0, 0, absolute = 0 }
    rows[#rows + 1] = { ("%g %% less: it is said to be the softer one"):format(100 * less), v.contradicts and 1 or 0, 1, absolute = 0 }
    rows[#rows + 1] = { ("%g %% less: what is told"):format(100 * less), v.speed.ratio, -less, absolute = 1e-3 }
  end
end
-- The other way round, the fast one stiffer by as much, one factor over the whole curve is no relaxing solid either: it would have to be the
-- stiffer one most of all at the start. The part found there is reported with the rest that it leaves.
say({ pull(place .. ".csv", speeds[1], 0.205), pull(place .. ".csv", speeds[2]) }, "the other way round, 26 % more at 500 mm/min")
fabric.expect(rows)
