-- A static run that comes to the limit of friction says first that cloth slides, with the force and where: a sheet on a plane that is drawn by a
-- growing force, and a tape over a rod that is drawn over it.
local fabric = require "fabric"
local mm = fabric.units.mm
local function ends(m, duration, step)
  local run = fabric.static { model = m, duration = duration, step = step, method = "newton" }
  local ok, words = pcall(run.solve, run)
  assert(not ok, "the run came to its end")
  words = tostring(words)
  local force, where = words:match "no step beyond time %S+ s: friction is at its limit and cloth slides: pairs with (%S+) N of it slide, most of all ([^;]+);"
  assert(force, words)
  assert(words:find("Try: motion, fabric.dynamic with damping, a support that holds what slides, or more friction.", 1, true), words)
  assert(not words:find "switching", words)
  return tonumber(force), where, run
end

for _, triangles in ipairs { false, true } do
  local mu, pressure, side = 0.35, 2e3, 30 * mm
  local card = fabric.svk { young = 4e7, poisson = 0.2, density = 400, thickness = 0.5 * mm, bending = { warp = 2e-6, weft = 2e-6, twist = 1e-6 } }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = side, height = side, nx = 3, ny = 3, triangles = triangles, origin = { 0, 0, 0.25 * mm - 1e-7 } }, card = card, warp = 0 }
  local plane = fabric.rigid.plane { point = { 0, 0, 0 }, normal = { 0, 0, 1 } }
  m:contact { between = { plane, "all" }, friction = mu }:fix("all", "y rotation"):pressure(fabric.ramp(-pressure, 1))
  local limit = mu * pressure * side ^ 2
  m:force("right", { x = fabric.history { { 0, 0 }, { 1, 0 }, { 2, 1.5 * limit } } })
  local force, where, run = ends(m, 2, 0.1)
  assert(force > 0.8 * limit and force < 1.001 * limit, ("%g N for %g"):format(force, limit)) -- the last pairs still stick
  assert(where:find "plane", where)
  assert(math.abs((run.time - 1) * 1.5 - 1) < 0.03, run.time)
end

-- The capstan: 0.5 N on one side, and a force that grows on the other.
local mu, R, t, hold = 0.2, 15 * mm, 0.4 * mm, 0.5
local card = fabric.svk { young = 1e8, poisson = 0, density = 600, thickness = t, bending = { warp = 1e-6, weft = 1e-6, twist = 1e-6 } }
local r = R + t / 2
local mesh = fabric.mesh.rectangle { width = 160 * mm, height = 15 * mm, nx = 64, ny = 1 }
mesh:map(function(x, y)
  local s, half = x - 80 * mm, math.pi * r / 2
  if s < -half then return -r, y, s + half end
  if s > half then return r, y, half - s end
  return r * math.sin(s / r), y, r * math.cos(s / r)
end)
local m = fabric.model { mesh = mesh, card = card, warp = function(x, _, z)
  local angle = z >= 0 and math.atan(x, z) or (x < 0 and -math.pi / 2 or math.pi / 2)
  return { math.cos(angle), 0, -math.sin(angle) }
end }
m:contact { between = { fabric.rigid.cylinder { radius = R, from = { 0, -30 * mm, 0 }, to = { 0, 45 * mm, 0 } }, "all" }, friction = mu }
m:fix("all", "y"):fix("left", "x"):fix("right", "x")
m:force("left", { z = fabric.ramp(-hold, 0.5) }):force("right", { z = fabric.history { { 0, 0 }, { 0.5, -hold }, { 2.5, -3 * hold } } })
local _, where, run = ends(m, 2.5, 0.05)
assert(where:find "cylinder", where)
local drawn = hold * (1 + (run.time - 0.5))
assert(math.abs(drawn / (hold * math.exp(mu * math.pi)) - 1) < 0.01, drawn)
