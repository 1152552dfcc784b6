-- window=: means over a window of time in records and reactions, from the run's own steps; the same bits after a restart.
local fabric = require "fabric"
local mm = fabric.units.mm
local name = os.tmpname()
os.remove(name)
local card = fabric.svk { young = 5e6, poisson = 0.2, density = 600, thickness = 0.4 * mm }

-- Steps are not regular: a hook ends some; the force goes up and down.
local function made(stem)
  local mesh = fabric.mesh.rectangle { width = 100 * mm, height = 30 * mm, nx = 3, ny = 2 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("all", "z rotation"):fix("left", "x y"):move("right", { x = function(t) return 0.5 * mm * (t + 0.3 * math.sin(9 * t)) end })
  local a = fabric.static { model = m, duration = 2, step = 0.11 }
  local own = {}
  a:every("step", function(run) own[#own + 1] = { run.time, (run:reaction "right") } end)
  a:every(0.37, function() end)
  if stem then
    a:record(stem .. "/means.csv", { every = 0.4, order = { "now", "mean", "wide", "stress", "plain" }, columns = {
      now = function(run) return (run:reaction "right") end,
      mean = { function(run) return (run:reaction "right") end, window = 0.5 },
      wide = { function(run) return (run:reaction "right") end, window = 50 },
      stress = { "S11", window = 0.5 },
      plain = "S11",
    } })
  end
  return a, own
end
-- The mean of a line through the points over the last `width` seconds.
local function mean(points, width)
  local finish = points[#points][1]
  local start, sum = math.max(points[1][1], finish - width), 0
  if finish == start then return points[#points][2] end
  for i = 2, #points do
    local a, b = points[i - 1], points[i]
    local from = math.max(a[1], start)
    if b[1] > from then
      local y = a[2] + (b[2] - a[2]) * (from - a[1]) / (b[1] - a[1])
      sum = sum + (b[1] - from) * (y + b[2]) / 2
    end
  end
  return sum / (finish - start)
end

local a, own = made()
local x = a:reaction("right", { window = 0.5 }) -- before the run: from now on
assert(x == 0)
for _, to in ipairs { 0.3, 0.8, 1.7, 2 } do
  a:advance(to)
  fabric.expect { { ("reaction at %g s"):format(to), (a:reaction("right", { window = 0.5 })), mean(own, 0.5), relative = 1e-12 } }
end
local ok, message = pcall(a.reaction, a, "right", { window = 0.7 })
assert(not ok and message:find("field 'options.window': expected to be asked for once before the first step", 1, true), message)
assert(message:find("write a:reaction('right', { window=0.7 }) before a:solve() too", 1, true), message)

-- records: each row is a mean over what is behind it
local b, steps = made(name)
local seen = {}
b:every(0.4, function() seen[#seen + 1] = { mean(steps, 0.5), mean(steps, 50) } end)
b:solve()
local function rows(file)
  local out = {}
  for line in io.lines(file) do
    local row = {}
    for cell in line:gmatch "[^,]+" do row[#row + 1] = tonumber(cell) end
    out[#out + 1] = row
  end
  return out
end
local table_of = rows(name .. "/means.csv")
assert(#table_of == #seen + 1)
for i = 2, #seen do
  fabric.expect {
    { "mean", table_of[i + 1][3], seen[i][1], relative = 1e-12 },
    { "wide", table_of[i + 1][4], seen[i][2], relative = 1e-12 },
  }
  assert(table_of[i + 1][3] ~= table_of[i + 1][2] and table_of[i + 1][5] ~= table_of[i + 1][6])
end

-- back to a snapshot, and on: the same bits, also where the window reaches behind it
local c = made(name .. "2")
c:reaction("right", { window = 0.9 })
c:advance(1.1)
local there = c:snapshot()
c:solve()
local last, file = c:reaction("right", { window = 0.9 }), io.open(name .. "2/means.csv"):read "a"
c:restore(there)
c:solve()
assert(c:reaction("right", { window = 0.9 }) == last and io.open(name .. "2/means.csv"):read "a" == file)

for _, folder in ipairs { name, name .. "2" } do
  os.remove(folder .. "/means.csv") os.remove(folder .. "/run.json") os.remove(folder)
end
