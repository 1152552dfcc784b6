-- The Lua face from the side of a deck: what reads back, what chains, what is caught.
local fabric = require "fabric"
local u = fabric.units

-- cards: every field reads back in SI; written and read again they are equal
local function round_trip(card)
  local path = os.tmpname() .. ".lua"
  card:write(path)
  local again = fabric.card(path)
  os.remove(path)
  assert(again == card, tostring(card))
  return again
end
for _, name in ipairs(fabric.cards()) do round_trip(fabric.card(name)) end
local blend = fabric.card "blend"
assert(blend.thickness == 0.38e-3 and blend.warp.loading[2] == 826e6 and blend.tested.warp > 0.26 and blend.law == "potential")
local rich = blend:with {
  name = 'a "quoted"\nname', law = "thesis", transverse = "follow", shear_hysteresis = false,
  warp = { loading = { { 0, 0 }, { 0.1, 1e5 }, { 0.2, 1e6 } } }, shear = { measure = "engineering", memory = "fading" },
  biaxial = { alpha = 1.568, offset = 0.1606, loading = 294 * u.MPa, unloading = 111 * u.MPa },
  bending = { warp = 1e-5, weft = 2e-5, twist = 1e-6, friction_warp = { moment = 1e-3, curvature = 20 } },
}
assert(rich ~= blend and round_trip(rich).bending.friction_warp.curvature == 20 and blend.warp.loading[1] == 8e6)
assert(rich.warp.loading[3][2] == 1e6 and rich.biaxial.alpha == 1.568 and rich.source == blend.source)
local svk = round_trip(fabric.svk { warp = 2e6, weft = 1e6, shear = 3e5, poisson = { 0.2, 0.1 }, transverse = { 1e5, 2e5 },
  density = 400, thickness = 1e-3 })
assert(svk.kind == "svk" and svk.transverse[2] == 2e5 and svk.warp == 2e6)

-- mesh views
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 3, ny = 9, origin = { 1, 2 } }
assert(#mesh.nodes == 40 and #mesh.elements == 27 and mesh.nodes[1][2] == 2 and mesh.nodes[41] == nil)
local n = 0
for _, element in ipairs(mesh.elements) do n = n + #element end
assert(n == 4 * 27)
mesh:set("mine", { 3, 1, 2, 3 })
assert(table.concat(mesh:set "mine", " ") == "1 2 3" and #mesh:elements "mine" == 0 and #mesh:elements "all" == 27)

-- a run: hooks in order, errors in hooks caught, the run goes on after
local function strip(h)
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }, card = blend, warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = h })
  return fabric.static { model = m, duration = 1, step = 0.25 }, m
end
local a, m = strip(function(t) return 0.01 * t end)
assert(m.thickness == blend.thickness and m.card == blend)
local times, angry = {}, true
a:every(0.1, function(run) times[#times + 1] = run.time end)
a:every("step", function(run)
  assert(run == a)
  if angry and run.time > 0.45 then error { mine = true } end
end)
local ok, e = pcall(a.solve, a)
assert(not ok and e.mine and a.time >= 0.45 and a.time < 1)
angry = false
a:solve()
assert(a.time == 1 and #times == 11 and math.abs(a:node(8).uy - 0.01) < 1e-15)
assert(select("#", a:reaction "top") == 3 and a.energy.stored > 0 and a.energy.internal == a.energy.stored + a.energy.dissipated)
assert(not pcall(m.fix, m, "top", "z")) -- compiled: no change any more

-- Newton converges quadratically: the last steps square the residual
local last = a.steps[#a.steps].residuals
assert(last[#last] <= 1e-10)

-- an error from a history leaves the run where it was, alive
local limit = 0.6
local b = strip(function(t)
  if t > limit then error "beyond" end
  return 0.01 * t
end)
local fine, why = pcall(b.solve, b)
assert(not fine and why:find "face.lua:%d+: beyond" and b.time <= 0.6)
local before = b.energy.stored
limit = 2
assert(b:solve().time == 1 and b.energy.stored > before)

-- snapshots
local c = strip(fabric.ramp(0.01, 1))
c:advance(0.5)
local saved, stored = c:snapshot(), c.energy.stored
c:solve():restore(saved)
assert(c.time == 0.5 and math.abs(c.energy.stored - stored) < 1e-12 * stored)

-- threads that wait for each other go to sleep soon
assert(os.getenv "GOMP_SPINCOUNT" or os.getenv "OMP_WAIT_POLICY")

-- analyses that mention themselves in their hooks are collected
local weak = setmetatable({}, { __mode = "k" })
do
  local d = strip(0.001)
  d:every("step", function() return d.time end)
  weak[d] = true
end
collectgarbage() collectgarbage()
assert(next(weak) == nil, "an analysis outlives its last mention")
print "ok"

-- A card is its text: minus zero, which the text does not tell from zero, reads back equal.
do
  local path = os.tmpname() .. ".lua"
  local card = fabric.card "blend":with { warp = { loading = { 8e6, -0.0 } } }
  card:write(path)
  assert(fabric.card(path) == card)
  os.remove(path)
end
