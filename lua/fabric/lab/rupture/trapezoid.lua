-- The trapezoid tear of fabric.lab.tear [astm_d5587]: clamps along the oblique sides of a trapezoid, cut on its short side.
--
--        y                clamp           The clamps are first turned about their ends at x = 0 until they are parallel: the cloth between
--        |        ____----                them is then taut at the cut and hangs in a bow that grows along x. Then they are pulled apart
--     a  |___----                         along y, and the yarns along y break one after the other.
--        |==== cut   tear ->   x
--        |---____
--                ----____ clamp
local define = require "fabric.define"
local fabric = require "fabric"
local rupture = require "fabric.lab.rupture.rupture"
local trapezoid = {}

local bow = 0.02     -- height of the bow at the long side in the reference, over the length of that side
local straight = 2   -- rows of elements beside the tear that lie along the yarns
local pace = 1e-2    -- speed over that of a wave

-- Rows of nodes from the tear to a clamp at the distance `far`: `straight` of size h, then `more` equal ones.
local function rows(h, far, more)
  local out = {}
  for j = 1, straight do out[j] = j * h end
  for j = 1, more do out[straight + j] = straight * h + (far - straight * h) * j / more end
  return out
end

local function check(t)
  local least = 2 * (straight + 0.25) * t.h
  if t.short < least then
    define.fail(("tear: field 'short': expected at least %.4g m with elements of %.3g m, got %.4g"):format(least, t.h, t.short))
  end
  if t.long <= t.short then define.fail(("tear: field 'long': expected more than the short side, %.4g m, got %.4g"):format(t.short, t.long)) end
  if t.cut >= t.width then define.fail(("tear: field 'cut': expected less than the width, %.4g m, got %.4g"):format(t.width, t.cut)) end
  local most = t.width - t.cut
  if t.tear > most * (1 + 1e-9) then
    define.fail(("tear: field 'tear': expected at most what the cut leaves of the width, %.4g m, got %.4g"):format(most, t.tear))
  end
end

-- The mesh, and the nodes of each clamp with their distances from its end at x = 0.
local function specimen(t)
  local near, slope = t.short / 2, (t.long - t.short) / 2 / t.width
  local more = math.max(2, math.floor((t.short + t.long) / 4 / (2.5 * t.h) + 0.5))
  local ny = 2 * (straight + more)
  local lines, cells = { 0 }, math.max(1, math.floor(t.cut / t.h + 0.5))
  for i = 1, cells do lines[i + 1] = t.cut * i / cells end
  cells = math.max(1, math.floor((t.width - t.cut) / t.h + 0.5))
  local h = (t.width - t.cut) / cells
  for i = 1, cells do lines[#lines + 1] = i < cells and t.cut + i * h or t.width end
  local mesh = fabric.mesh.rectangle { width = t.width, height = ny * h, ny = ny, grading = { x = lines }, origin = { 0, -ny / 2 * h } }
  mesh:map(function(x, y)
    local j, far = math.floor(math.abs(y) / h + 0.5), near + slope * x
    local to = j == 0 and 0 or rows(h, far, more)[j]
    return x, y < 0 and -to or to, bow * t.long * x / t.width * math.cos(math.pi / 2 * to / far)
  end)
  mesh:slit { from = { 0, 0, 0 }, to = { t.cut, 0, bow * t.long * t.cut / t.width } }
  return mesh, h, math.atan(slope)
end

-- Each node of a clamp turns with it through the angle, and moves along y.
local function clamps(t, mesh, model, angle, turning, apart)
  local names = { top = 1, bottom = -1 }
  for _, name in ipairs { "bottom", "top" } do
    local sign = names[name]
    for k, n in ipairs(mesh:set(name)) do
      local s, set = mesh.nodes[n][1] / math.cos(angle), name .. " " .. k
      local function left(time) return time < turning and angle * (1 + math.cos(math.pi * time / turning)) / 2 or 0 end
      mesh:set(set, { n })
      model:fix(set, "z"):move(set, {
        x = function(time) return s * (math.cos(left(time)) - math.cos(angle)) end,
        y = function(time) return sign * (s * (math.sin(left(time)) - math.sin(angle)) + apart(time) / 2) end,
      })
    end
  end
end

function trapezoid.run(t, yarn, broken)
  check(t)
  local mesh, h, angle = specimen(t)
  local small = 0.01 * h
  mesh:set("zone", function(x, y) return math.abs(y) < h + small and x > t.cut - h - small end)
  mesh:set("path", function(x, y) return math.abs(y) < small and x > t.cut - small end)
  local model = fabric.model { mesh = mesh, card = t.card, warp = t.along == "warp" and { 1, 0, 0 } or { 0, -1, 0 }, membrane = true }
  model:tearable("zone", { coarse = t.coarse, seed = t.seed, path = "path" })
  local strain, c = rupture.strain(t.card, yarn, broken.strength)
  t.speed = t.speed or pace * c
  t.damping = t.damping or 2 * t.speed / t.short
  local far = 1.1 * (t.tear * 2 * math.sin(angle) + (strain + 0.1) * t.long)
  local turning = (t.long - t.short) / t.speed
  local way = fabric.history(rupture.way(0.05 * far / t.speed, 1.05 * far / t.speed, t.speed))
  local function apart(time) return way:value(math.max(0, time - turning)) end
  clamps(t, mesh, model, angle, turning, apart)
  local duration = turning + 1.05 * far / t.speed
  local a = fabric.dynamic { model = model, duration = duration, damping = { mass = t.damping }, ledger_limit = t.ledger_limit }
  return rupture.run(t, a, apart, {
    stem = "tear", model = model, mesh = mesh, from = turning, every = duration / (t.rows or 600), more = { "torn" },
    reading = function(_, row) row.torn = row.open * h end,
    counts = function(row) return row.torn > 0 end,
    ends = function(row) return row.torn > t.tear - h / 2 end,
  })
end

return trapezoid
