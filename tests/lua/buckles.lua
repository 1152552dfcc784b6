-- Static runs leave shapes that are not stable, with bending of the card's own and through the thickness, whatever the steps; and each step says whether it is stable.
-- The short form has fewer sizes and steps.
-- warns: the shape has become unstable
local fabric = require "fabric"
local checks = {}

local elliptic = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).elliptic
-- How far the end of a column that is held at its foot goes aside, over its length, at a load over Euler's [timoshenko1961].
local function aside(load)
  if load <= 1 then return 0 end
  local low, high = 0, 1 - 1e-9
  for _ = 1, 60 do
    local k = (low + high) / 2
    if (2 * elliptic(k) / math.pi) ^ 2 < load then low = k else high = k end
  end
  return 2 * low / elliptic(low)
end

local L, w, B = 0.15, 0.03, 1.2e-5
local euler = math.pi ^ 2 * B * w / 4 / L ^ 2
local cards = {
  svk = fabric.svk { density = 400, thickness = 0.4e-3, warp = 2e7, weft = 2e7, shear = 8e6, poisson = 0, bending = { warp = B, weft = B, twist = B / 2 } },
  woven = fabric.woven {
    density = 400, thickness = 0.4e-3, bending = { warp = B, weft = B, twist = B / 2 },
    warp = { loading = { 2e7 }, unloading = 2.5e7, poisson = 0 }, weft = { loading = { 2e7 }, unloading = 2.5e7, poisson = 0 },
    shear = { loading = { 6e6 }, unloading = 7e6 }, tested = { warp = 0.3, weft = 0.3, shear = 0.3 },
  },
  through = fabric.svk { density = 400, thickness = (12 * B / 2e7) ^ (1 / 3), warp = 2e7, weft = 2e7, shear = 1e7, poisson = 0 },
}
local function all_stable(a)
  for _, step in ipairs(a.steps) do
    if step.stable ~= true then return false end
  end
  return true
end
local function column(name, load, step, ny, triangles, method)
  local mesh = fabric.mesh.rectangle { width = L, height = w, nx = 20, ny = ny, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = cards[name], warp = 0 }
  m:fix("left", "x y z rotation"):force("right", { x = fabric.ramp(-load * euler, 1) })
  local a = fabric.static { model = m, duration = 1, step = step, method = method }:solve()
  local top, count = 0, 0
  for _, z in ipairs(a:field "uz") do top = math.max(top, math.abs(z)) end
  for _, s in ipairs(a.steps) do count = count + s.iterations end
  local what = ("%s, %g of Euler's load, steps of %g, %d wide%s %s: "):format(name, load, step, ny, triangles and ", triangles" or "", method or "")
  if load < 1 then
    checks[#checks + 1] = { what .. "straight, m", top, 0, absolute = 1e-9 }
    checks[#checks + 1] = { what .. "factorisations a step at most 6", math.max(count / #a.steps, 6), 6, absolute = 0 }
  else
    checks[#checks + 1] = { what .. "aside over length", top / L, aside(load), absolute = 0.012 }
  end
  assert(all_stable(a), what .. "not stable")
end
local long = os.getenv "FABRICSH_TEST_LONG"
for name in pairs(cards) do
  if long or name == "through" then
    column(name, 0.95, 0.2, 2, false)
    column(name, 1.25, 1, 1, false)
    column(name, 1.25, 0.1, 3, true)
  end
  if long or name == "woven" then column(name, 2.2, 0.5, 3, false) end
end
column("svk", 1.04, 0.02, 1, false)
column("woven", 1.6, 0.25, 2, false, "relaxation")
column("svk", 1.6, 0.25, 2, true, "either")

-- A strip on edge under a force at its end leaves its plane as one that is pushed aside a little.
local function on_edge(load, step, side)
  local mesh = fabric.mesh.rectangle { width = 0.3, height = 0.02, nx = 24, ny = 2 }
  mesh:set("tip", function(x, y) return x > 0.3 - 1e-9 and math.abs(y - 0.01) < 1e-9 end)
  local bending = { warp = 2e-5, weft = 2e-5, twist = 8e-6 }
  local card = fabric.svk { density = 400, thickness = 0.4e-3, warp = 1e8, weft = 1e8, shear = 5e7, poisson = 0, bending = bending }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local critical = 4.0126 * 0.02 * math.sqrt(2e-5 * 4 * 8e-6) / 0.3 ^ 2
  m:fix("left", "x y z rotation"):force("tip", { y = fabric.ramp(-load * critical, 1), z = side and fabric.ramp(side * critical, 1) })
  local a = fabric.static { model = m, duration = 1, step = step }:solve()
  assert(all_stable(a))
  return math.abs(a:node(mesh:set("tip")[1]).uz) / 0.3
end
for _, load in ipairs { 1.4, 2.5 } do
  local pushed = on_edge(load, 0.25, 1e-4)
  for _, step in ipairs(long and { 1, 0.2 } or { load < 2 and 1 or 0.2 }) do
    checks[#checks + 1] = { ("on edge at %g, steps of %g: aside over length"):format(load, step), on_edge(load, step), pushed, relative = 0.01 }
  end
end

-- Limp strips that stand and fall over come to the same place from any step: no step is halved towards the bifurcation for ever.
for _, name in ipairs { "wool", "muslin" } do
  local tops = {}
  for _, step in ipairs(long and { 1, 0.25, 0.05 } or { 1, 0.25 }) do
    local mesh = fabric.mesh.rectangle { width = 0.025, height = 0.055, nx = 2, ny = 11 }
    local m = fabric.model { mesh = mesh, card = fabric.card(name, { bending = "estimated" }), warp = 90 }
    m:fix("bottom", "x y z rotation"):gravity { 0, fabric.ramp(-9.81, 1), 0 }
    local a = fabric.static { model = m, duration = 1, step = step }:solve()
    assert(all_stable(a))
    local top = 0
    for _, z in ipairs(a:field "uz") do top = math.max(top, math.abs(z)) end
    tops[#tops + 1] = top
    checks[#checks + 1] = { ("%s stands and falls, steps of %g: aside, m"):format(name, step), top, tops[1], relative = 5e-3 }
  end
end

-- Loads without a potential leave stability open, and that is said: moments about fixed axes, pressure that follows an open edge. Pressure on a rim that is held has one.
local function said(load)
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.05, nx = 6, ny = 3 }
  local m = fabric.model { mesh = mesh, card = cards.svk, warp = 0 }
  load(m)
  local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  return a.steps[#a.steps].stable
end
assert(said(function(m) m:fix("left", "x y z rotation"):moment("right", { y = fabric.ramp(1e-5, 1) }) end) == "unchecked")
assert(said(function(m) m:fix("left", "x y z rotation"):pressure(fabric.ramp(0.02, 1)) end) == "unchecked")
assert(said(function(m) m:fix("boundary", "x y z"):pressure(fabric.ramp(20, 1)) end) == true)
assert(said(function(m) m:fix("left", "x y z rotation"):gravity { 0, 0, fabric.ramp(-1, 1) } end) == true)
fabric.expect(checks)
