-- The cost of contact, each as a ratio within one run of the program: processor time of explicit steps with contact over that without, on the
-- same sheet. Threads are compared by the clock on the wall, which says something on an idle machine alone, and by the processor time of the busiest
-- thread, which on a busy machine tells what the clock would on an idle one (start it with OMP_WAIT_POLICY=passive, so that waiting costs none).
--
--   fabricsh --threads 1 scripts/long/contact/cost.lua                    nothing near, a floor, two layers, a crumple; 100 x 100 elements
--   fabricsh --threads 1 scripts/long/contact/cost.lua near 500 300       one of them (near floor layers crumple), cells along an edge, steps
--   fabricsh --threads 1 scripts/long/contact/cost.lua crumple 100 8 0.5  a sheet that is thrown together at 8 m/s, half of its time
--   fabricsh --threads 2 scripts/long/contact/cost.lua wall 100 200       seconds on the wall and of the busiest thread; compare with --threads 1
-- warns: is turned over: it is more than 90 degrees
-- warns: turned inside out
-- warns: the guard of the directors has
local fabric = require "fabric"
local which, cells, steps = arg[1] or "all", tonumber(arg[2] or 100), tonumber(arg[3] or 200)
if fabric.checking() then cells = 4 end
local thickness = 0.4e-3
local card = fabric.svk { young = 5e6, poisson = 0.2, density = 600, thickness = thickness, name = "sheet", bending = { warp = 5e-6, weft = 5e-6, twist = 5e-6 } }
local h = 5e-3

local function wall()
  local pipe = assert(io.popen "date +%s.%N")
  local now = tonumber(pipe:read "l")
  pipe:close()
  return now
end
local function memory() -- the most that the program has held, MB
  local file = io.open "/proc/self/status"
  local kb = file and file:read("a"):match "VmHWM:%s*(%d+)"
  if file then file:close() end
  return kb and tonumber(kb) / 1024 or 0
end

-- Processor time of the busiest thread so far, from when `since` was taken, s.
local function busiest(since)
  local pipe = assert(io.popen "cat /proc/$PPID/task/*/schedstat 2>/dev/null")
  local times, most = {}, 0
  for line in pipe:lines() do
    times[#times + 1] = (tonumber(line:match "^%d+") or 0) / 1e9
    most = math.max(most, times[#times] - (since and since[#times] or 0))
  end
  pipe:close()
  return times, most
end

-- Seconds a step, of the processor, on the wall and of the busiest thread; the first steps do not count.
local function cost(model, step, count)
  local a = fabric.dynamic { model = model, duration = 1, step = step or "auto", ledger_limit = 10 }
  if fabric.checking() then return 1, 1, a, 1 end
  a:advance(10 * a.step_size)
  local clock, begin, since = os.clock(), wall(), busiest()
  a:advance((10 + count) * a.step_size)
  return (os.clock() - clock) / count, (wall() - begin) / count, a, select(2, busiest(since)) / count
end

local function flat(nx, ny, origin)
  return fabric.mesh.rectangle { width = nx * h, height = ny * h, nx = nx, ny = ny, origin = origin }
end
local wave = function(x, y) return { z = 0.2 * math.sin(40 * x) * math.cos(30 * y), x = 0.1 * math.cos(20 * y) } end

local scenes = {}
-- Nothing near: a sheet that swings, without and with contact with itself.
function scenes.near(contact)
  local m = fabric.model { mesh = flat(cells, cells), card = card }
  if contact then m:contact { self = "all", friction = 0.3 } end
  return m:velocity("all", wave)
end
-- All of it lies on a floor.
function scenes.floor(contact)
  local m = fabric.model { mesh = flat(cells, cells), card = card }
  local ground = fabric.rigid.plane { point = { 0, 0, -0.45 * thickness }, normal = { 0, 0, 1 }, name = "floor" }
  if contact then m:contact { between = { ground, "all" }, friction = 0.3 } end
  return m:gravity { 0, 0, -9.81 }
end
-- Two layers on one another, their meshes out of line.
function scenes.layers(contact)
  local m = fabric.model { bodies = { { name = "low", mesh = flat(cells, cells // 2), card = card, warp = 0 },
                                      { name = "high", mesh = flat(cells, cells // 2, { 0.3 * h, 0.4 * h, 0.95 * thickness }), card = card, warp = 0 } } }
  if contact then m:contact { between = { "low.all", "high.all" }, friction = 0.3 } end
  return m:velocity("low.all", { x = 0.1, z = 0.05 })
end

local function told(name, with, without, a)
  print(string.format("%-8s %7d elements  %.3f us a step and element, without contact %.3f: %.2f times; touching now %s; at most %.0f MB", name, #a.mesh.elements,
    1e6 * with / #a.mesh.elements, 1e6 * without / #a.mesh.elements, with / without, a.energy.contact > 0 and "yes" or "no", memory()))
  return with / without
end

local function ratio(name)
  -- Steps of the same size, and turn about, so that what else the machine does meets both.
  local with, without, a = 0, 0, nil
  local part = math.max(10, steps // 4)
  for _ = 1, 4 do
    local c, _, run = cost(scenes[name](true), nil, part)
    with, without, a = with + c / 4, without + cost(scenes[name](false), run.step_size, part) / 4, run
  end
  return told(name, with, without, a)
end

-- A sheet that is thrown together, folds up and meets itself, all of it; processor time over all steps, in which it comes to touch more and more.
local function crumple()
  local side, speed = cells * h, which == "crumple" and tonumber(arg[3]) or 8
  local function run(contact)
    local m = fabric.model { mesh = flat(cells, cells, { -side / 2, -side / 2, 0 }), card = card }
    if contact then m:contact { self = "all", friction = 0.3, thickness = 2 * thickness } end
    m:velocity("all", function(x, y)
      local u, v = 2 * x / side, 2 * y / side
      return { x = -speed * u, y = -0.2 * speed * v, z = 0.8 * speed * math.cos(2.5 * u + 0.3) * math.cos(0.5 * v) }
    end)
    local a = fabric.dynamic { model = m, duration = 0.9 * side / speed, ledger_limit = 10 }
    local clock = os.clock()
    local ok, trouble = pcall(a.advance, a, (tonumber(arg[4]) or 1) * 0.9 * side / speed)
    if not ok then print(tostring(trouble):match "[^\n]*") end
    return fabric.checking() and 1 or (os.clock() - clock) / #a.steps, a, a.energy.contact
  end
  local with, a, energy = run(true)
  local without = math.huge -- a step costs the same whatever its size
  for _ = 1, 3 do without = math.min(without, (run(false))) end
  local touching, pressure = 0, a:field "contact_pressure"
  for _, p in ipairs(pressure) do touching = touching + (p > 0 and 1 / #pressure or 0) end
  print(string.format("crumple: %d steps to %.4f s, in contact %.2e of %.2e J; %.1f %% of the nodes touch at the end", #a.steps, a.time, energy, a.energy.initial,
    100 * touching))
  return fabric.checking() and 1 or told("crumple", with, without, a)
end

if which == "wall" then
  for _, contact in ipairs { false, true } do
    local _, seconds, a, thread = cost(scenes.near(contact), nil, steps)
    print(string.format("%d elements, contact %-3s  %.3f ms a step on the wall, %.3f ms of the busiest thread", #a.mesh.elements, contact and "on" or "off",
      1e3 * seconds, 1e3 * thread))
  end
elseif which ~= "all" then
  if which == "crumple" then crumple() else ratio(which) end
else
  fabric.expect {
    { "contact on and nothing near, over off", ratio "near", 1, absolute = 0.1 },
    { "a crumple over the same without contact", crumple(), 1, absolute = 0.6 },
  }
  ratio "floor"
  ratio "layers"
end
