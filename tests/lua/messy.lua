-- Records as laboratories have them: breaks in a later cycle, holds, crosshead positions, wrong signs, lost markers and frames.
local fabric = require "fabric"
local lab = fabric.lab
local draw = require "fabric.lab.random" (3)

local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails
local function close(got, want, relative) assert(math.abs(got / want - 1) < relative, ("%g, want %g"):format(got, want)) end

-- Rows {displacement, S} of a cloth S = 8 MPa E + 400 MPa E^2, unloading at 900 MPa.
local length, area = 76.2e-3, 25.4e-3 * 0.38e-3 * 2
local function strain(u) return u / length + (u / length) ^ 2 / 2 end
local function P(u) return 8e6 * strain(u) + 4e8 * strain(u) ^ 2 end
local function back(u, from, part) return math.max(0, (part or 1) * P(from) - 9e8 * (strain(from) - strain(u))) end
local function ramp(rows, from, to, n, S)
  for i = 1, n do
    local u = from + (to - from) * i / n
    rows[#rows + 1] = { u, S(u) }
  end
end
local function record(rows, offset)
  local out = { displacement = {}, force = {} }
  for i, row in ipairs(rows) do
    out.displacement[i] = row[1] + 2e-6 * draw.normal() + (offset or 0)
    out.force[i] = row[2] * area * (1 + row[1] / length) + 0.02 * draw.normal()
  end
  return out
end
local function tensile(rows, more)
  local t = { record = rows.force and rows or record(rows), gauge_length = length, width = 25.4e-3, thickness = 0.38e-3, plies = 2 }
  for k, v in pairs(more or {}) do t[k] = v end
  return lab.tensile(t)
end

-- a break in the second cycle ends the fit
local rows = { { 0, 0 } }
ramp(rows, 0, 4e-3, 200, P)
ramp(rows, 4e-3, 3.6e-3, 40, function(u) return back(u, 4e-3) end)
ramp(rows, 3.6e-3, 4e-3, 40, function(u) return back(u, 4e-3) end)
ramp(rows, 4e-3, 7e-3, 200, P)
local top = #rows
ramp(rows, 7e-3, 10e-3, 150, function() return 0.2 * P(7e-3) end)
local broken = tensile(rows)
assert(math.abs(broken.failure - top) <= 1 and not broken.yield)
local f = lab.fit { tests = { broken } }
close(f.loading[1], 8e6, 0.02)
close(f.loading[2], 8e8, 0.02)
close(f.tested, strain(7e-3), 0.01)
close(f.unloading, 9e8, 0.1) -- three noisy points

-- a hold at the peak, in which the cloth relaxes, belongs to neither side
rows = { { 0, 0 } }
ramp(rows, 0, 5e-3, 300, P)
for i = 1, 100 do rows[#rows + 1] = { 5e-3, P(5e-3) * (1 - 0.1 * i / 100) } end
ramp(rows, 5e-3, 4.6e-3, 400, function(u) return back(u, 5e-3, 0.9) end)
close(lab.fit { tests = { tensile(rows) }, rule = "robust" }.unloading, 9e8, 0.1)

-- the grip let down on slack cloth before the pull is no unloading
rows = {}
ramp(rows, 1e-3, 0, 50, function() return 0 end)
ramp(rows, 0, 5e-3, 300, P)
f = lab.fit { tests = { tensile(rows) } }
assert(f.unloading == nil)
close(f.loading[2], 8e8, 0.02)

-- a crosshead's position and an offset of the load cell, taken off
rows = { { 0, 0 } }
ramp(rows, 0, 7e-3, 300, P)
f = lab.fit { tests = { tensile(record(rows, 0.12), { zero = true }) } }
close(f.loading[1], 8e6, 0.03)
close(f.loading[2], 8e8, 0.03)

-- signs
local wrong = record(rows)
for i, F in ipairs(wrong.force) do wrong.force[i] = -F end
fails("tensile: force runs from -", tensile, wrong)
fails("a pull counts positive", tensile, wrong)

-- a curve without an admissible polynomial is seen from contact too
local softening = { { 0, 0 } }
local function S(u)
  local E = strain(math.max(0, u - 1e-3))
  return 5e6 * (1 - math.exp(-E / 0.01)) + 1e6 * E
end
ramp(softening, 0, 8e-3, 300, S)
f = lab.fit { tests = { tensile(softening) }, find_slack = true }
assert(not f.degree and f.text:find "points of a monotone curve instead", f.text)
close(f.specimens[1].slack, 1e-3 / 0.0762, 0.05)
for _, point in ipairs(f.loading) do -- from contact on, the steepest part of the curve
  assert(math.abs(point[2] - 5e6 * (1 - math.exp(-point[1] / 0.01)) - 1e6 * point[1]) < 0.03 * 5e6)
end

-- bias: zones over the whole test, there and back, with lost markers and frames
local R, C = 13, 5
local function bias(angles, lose)
  local g = { rows = R, columns = C, frames = #angles, x = {}, y = {} }
  for k, angle in ipairs(angles) do
    local Y = 0
    for r = 1, R do
      local part = (r <= 3 or r >= 12) and 0 or (r == 4 or r == 11) and 0.5 or 1
      local half = math.rad(angle) * part / 2
      local along, across = math.sqrt(2) * math.cos(math.pi / 4 - half), math.sqrt(2) * math.sin(math.pi / 4 - half)
      if r > 1 then Y = Y + 5e-3 * along end
      for c = 1, C do
        local lost = lose and lose(k, (r - 1) * C + c)
        g.x[#g.x + 1] = lost and 0 / 0 or (c - 3) * 5e-3 * across + 1e-5 * draw.normal()
        g.y[#g.y + 1] = lost and 0 / 0 or Y + 1e-5 * draw.normal()
      end
    end
  end
  local t = { markers = g, force = {}, displacement = {}, gauge_length = 0.1, width = 0.02, thickness = 5e-4, plies = 1 }
  for i, angle in ipairs(angles) do t.force[i], t.displacement[i] = angle, 1e-3 * angle end
  return lab.shear_from_bias(t)
end
local angles = {}
for i = 0, 20 do angles[#angles + 1] = 1.5 * i end
for i = 19, 0, -1 do angles[#angles + 1] = 1.5 * i end
local function check(t, frames, count)
  local zones = { 0, 0, 0 }
  for _, z in ipairs(t.zones) do zones[z] = zones[z] + 1 end
  assert(zones[1] == 16 and zones[2] == 8 and zones[3] == 24, table.concat(zones, " "))
  assert(#t.frames == frames and #t.E == frames and #t.pull.E == frames)
  if count then close(t.E[count], math.sin(math.rad(30)) / 2, 0.03) end -- one row between the zones is sheared less
end
check(bias(angles), 41, 21)
check(bias(angles, function(k) return k == 41 end), 40, 21)
check(bias(angles, function(k) return k == 10 end), 40, 20)
check(bias(angles, function(k, m) return k > 30 and m % 3 == 0 end), 41 - 11, 21)
fails("no box of the markers is seen sheared", bias, { 0, 0, 0 }, function() return true end)

-- frames by their numbers, whatever the order of the rows
local path = os.tmpname()
local function file(text)
  local out <close> = assert(io.open(path, "w"))
  out:write(text)
end
local lines = { "frame,marker,x,y" }
for m = 1, 4 do
  for k = 1, 5 do
    if not (m == 1 and k == 3) then lines[#lines + 1] = ("%d,%d,%g,%g"):format(k, m, (m - 1) % 2, (m - 1) // 2 * (1 + 0.1 * (k - 1))) end
  end
end
file(table.concat(lines, "\n") .. "\n")
local t = lab.tracks { file = path, rows = 2, columns = 2 }
for k = 1, 5 do
  assert(t.numbers[k] == k)
  close(t.y[(k - 1) * 4 + 3], 1 + 0.1 * (k - 1), 1e-12)
end
assert(t.x[9] ~= t.x[9])
-- the sign of a tracker for a lost marker reads as one
file "frame,marker,x,y\n1,1,0,0\n1,2,1,0\n1,3,0,1\n1,4,1,1\n2,1,0,0\n2,2,nan,nan\n2,3,0,1\n2,4,,\n"
t = lab.tracks { file = path, rows = 2, columns = 2 }
assert(t.frames == 2 and t.x[6] ~= t.x[6] and t.x[8] ~= t.x[8] and t.y[7] == 1)
file "frame,marker,x,y\n1,1,0,0\n1,5,1,0\n"
fails("expected frames and markers 1 to 4 in every row, got frame 1, marker 5 in row 2", lab.tracks, { file = path, rows = 2, columns = 2 })
os.remove(path)

-- scale from a known distance
local pictures = {}
for i = 1, 2 do
  pictures[i] = os.tmpname() .. ".png"
  lab.photograph { file = pictures[i], rows = 4, columns = 4, pitch = 60, radius = 8, width = 400, height = 400, seed = i }
end
local tracked = lab.track { files = pictures, rows = 4, columns = 4, known = { from = 1, to = 4, distance = 0.03 } }
close(tracked.x[2] - tracked.x[1], 0.01, 1e-3) -- noise of the picture
for _, picture in ipairs(pictures) do os.remove(picture) end
