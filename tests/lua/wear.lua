-- fabric.lab.wear and a:on_body against what is known: a sheet that lies on a slab presses with its weight, slides as far as the slab goes under it and
-- takes mu times its weight times that way; regions, discs of skin, and the same numbers after a restart.
local fabric = require "fabric"
local mm = fabric.units.mm
local function near(got, want, relative, what)
  assert(math.abs(got - want) <= relative * math.abs(want), ("%s: got %.9g, want %.9g within %g"):format(what, got, want, relative))
end
local function fails(words, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(words, 1, true), 'expected "' .. words .. '", got ' .. tostring(why))
end
local card = fabric.card("blend", { bending = "estimated" })
local side, mu, way, rest, over = 60 * mm, 0.3, 5 * mm, 0.015, 0.02
local areal = card.density * card.thickness

-- The slab begins to slide at `rest`, with its speed from the start on, and comes back as far; the cloth is held at one edge.
local function lying(triangles, kept)
  local face = fabric.mesh.rectangle { width = 100 * mm, height = 100 * mm, nx = 5, ny = 5, origin = { -20 * mm, -20 * mm, 0 } }
  face:set("left", function(x) return x < 21 * mm end)
  face:set("right", function(x) return x > 39 * mm end)
  face:set("bare", function(x) return x < -19 * mm end)
  local slab = fabric.rigid.surface { mesh = face, name = "slab" }
  local cloth = fabric.mesh.rectangle { width = side, height = side, nx = 4, ny = 4, triangles = triangles, origin = { 0, 0, card.thickness / 2 } }
  local m = fabric.model { mesh = cloth, card = card, warp = 0, points = 1 }
  m:contact { between = { slab, "all" }, friction = mu }:gravity { 0, 0, -9.81 }:fix("left", "x y")
  m:move(slab, { x = fabric.history { { 0, 0 }, { rest, 0 }, { rest + over, -way }, { rest + 2 * over, 0 } } })
  local a = fabric.dynamic { model = m, duration = rest + 2 * over, damping = { mass = 500 } }
  local state = {}
  if kept == "again" then a:restart "work/wear.ckpt" end
  if kept then a:checkpoint("work/wear.ckpt", { every = rest + over / 2, keep = state }) end
  return a, slab, face, state
end

for _, triangles in ipairs { false, true } do
  local a, slab, face, state = lying(triangles)
  local worn = fabric.lab.wear { analysis = a, body = slab, mesh = face, times = { rest, rest + over, rest + 2 * over }, state = state, patch = 15 * mm }
  local weight = areal * side ^ 2 * 9.81
  local all = worn.regions.all
  near(all.usual * (100 * mm) ^ 2, weight, 0.02, "the whole pressure is the weight")
  assert(worn.regions.bare.mean < 1e-6 * all.mean and worn.regions.bare.touched == 0 and worn.regions.bare.peak == 0)
  assert(all.touched > 0.6 and all.touched < 0.8) -- of the vertices of the slab, those of all facets that the cloth lies on
  assert(all.peak > 0.5 * areal * 9.81 and all.peak_at)
  near(worn.slip.mean, 2 * way, 0.02, "slip on the skin, there and back")
  assert(worn.slip.nodes == 25)
  for k = 1, 2 do
    local c = worn.cycles[k]
    near(c.friction, mu * weight * way, 0.05, "friction of way " .. k)
    near(c.work, c.cloth + c.friction + c.damping + c.impact + c.stored + c.kinetic, 0.02, "the shares make up the work of way " .. k)
  end
  assert(#worn.rows == 80 and worn.text:find("slip on the skin", 1, true) and worn.ledger < 1e-2)
end

-- The same numbers where the run is cut in between: what had been gathered comes from the checkpoint.
local function gathered(kept)
  local a, slab, face, state = lying(false, kept)
  local worn = fabric.lab.wear { analysis = a, body = slab, mesh = face, times = { rest, rest + over }, state = state }
  return worn, a
end
local whole = gathered(true)
local again = gathered "again"
assert(whole.text == again.text and #again.rows == #whole.rows)

-- Sets that are no surface, or no surface of that mesh.
local _, slab, face = lying(false)
do
  local ball = fabric.rigid.sphere { radius = 10 * mm, centre = { 0, 0, -11 * mm } }
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = side, height = side, nx = 2, ny = 2 }, card = card, warp = 0 }
  m:contact { between = { ball, "all" } }
  local a = fabric.dynamic { model = m, duration = 1e-4 }:solve()
  fails("has no facets", a.on_body, a, ball)
  fails("touches nothing in the model", a.on_body, a, slab)
end
do
  local a, other = lying(false)
  local small = fabric.mesh.rectangle { width = side, height = side, nx = 2, ny = 2 }
  fails("expected the mesh of the body's facets, 36 nodes, got 9 nodes", fabric.lab.wear, { analysis = a, body = other, mesh = small, times = { 1e-3, 2e-3 } })
  fails("expected ascending times", fabric.lab.wear, { analysis = a, body = other, mesh = face, times = { 0.02, 0.01 } })
end

-- Cloth that is shortened in its plane: where folds within elements take that, nothing is said of the mesh.
for _, case in ipairs { { "within elements", true }, { "resolved", false } } do
  local ground = fabric.mesh.rectangle { width = 100 * mm, height = 100 * mm, nx = 2, ny = 2, origin = { -20 * mm, -20 * mm, 0 } }
  local table_top = fabric.rigid.surface { mesh = ground, name = "top" }
  local sheet = fabric.mesh.rectangle { width = side, height = side, nx = 3, ny = 3, origin = { 0, 0, card.thickness / 2 } }
  local stiff = card:with { warp = { loading = { 20e6 }, unloading = 20e6, poisson = card.warp.poisson } }
  local m = fabric.model { mesh = sheet, card = stiff, warp = 0, folds = case[1] }
  m:contact { between = { table_top, "all" } }:gravity { 0, 0, -9.81 }:fix("all", "y z rotation"):fix("left", "x")
  m:move("right", { x = fabric.ramp(-2 * mm, 0.005) })
  local worn = fabric.lab.wear { analysis = fabric.dynamic { model = m, duration = 0.006, damping = { mass = 500 } }, body = table_top, mesh = ground, times = { 0.005, 0.006 } }
  assert(worn.compressed.value > 0.02 and worn.gives_way == case[2], ("%s: %g, %s"):format(case[1], worn.compressed.value, worn.compressed.folded))
  assert((worn.text:find("these are folds", 1, true) ~= nil) == case[2], worn.text)
end
