-- Several meshes in one model, and regions of another card within one: each behaves as it would alone.
local fabric = require "fabric"

local function near(got, wanted, tolerance, what)
  assert(math.abs(got - wanted) <= (tolerance or 1e-12) * math.abs(wanted),
    ("%s: %.17g, wanted %.17g"):format(what or "value", got, wanted))
end
local blend, denim = fabric.card "blend", fabric.card "denim"
local function strip(z) return fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 2, ny = 6, origin = { 0, 0, z or 0 } } end
local function pulled(m, name, by)
  local of = name and name .. "." or ""
  m:fix(of .. "all", "z rotation"):fix(of .. "bottom", "x y"):fix(of .. "top", "x")
  return m:move(of .. "top", { y = fabric.ramp(by, 1) })
end
local function fy(a, set) return (select(2, a:reaction(set))) end
local function run(m) return fabric.static { model = m, duration = 1, step = 0.25 }:solve() end

-- Two bodies side by side: the forces of each alone.
local one = run(pulled(fabric.model { mesh = strip(), card = blend, warp = 90 }, nil, 0.004))
local two = run(pulled(fabric.model { mesh = strip(0.01), card = denim, thickness = 1e-3 }, nil, 0.002))
local front, back = strip(), strip(0.01)
local m = fabric.model { bodies = {
  { name = "front", mesh = front, card = blend, warp = 90 },
  { name = "back", mesh = back, card = denim, thickness = 1e-3 },
} }
front:set("middle", function(_, y) return math.abs(y - 0.0381) < 1e-9 end) -- a set made later is seen
pulled(m, "front", 0.004)
pulled(m, "back", 0.002)
local told = m:list()
assert(told[1].kind == "body" and told[1].set == "front" and told[1].what == "card blend, 0.38 mm, warp 90 degrees"
  or error(told[1].what))
assert(told[2].kind == "body" and told[2].set == "back" and #told == 2 + 2 * 4)
assert(m.card.name == "blend" and #m.mesh.nodes == 2 * #front.nodes)
local both = run(m)
near(fy(both, "front.top"), fy(one, "top"), 1e-9, "front")
near(fy(both, "back.top"), fy(two, "top"), 1e-9, "back")
assert(fy(both, "front.middle") == 0)
near(both:mean("E11", "back.all"), two:mean("E11"), 1e-9)
near(both:mean("tension_weft", "back.all"), two:mean("tension_weft"), 1e-9)
local regions = both:field "region"
assert(regions[1] == 1 and regions[#front.elements] == 1 and regions[#front.elements + 1] == 2)

-- A region of another card; the body's warp is its warp too.
local patched = strip()
patched:set("pocket", function(_, y) return y > 0.0254 - 1e-9 and y < 0.0508 + 1e-9 end)
local function seamless(card) return fabric.model { mesh = patched, card = blend, warp = 90, regions = { pocket = { card = card } } } end
local same, other = run(pulled(seamless(blend), nil, 0.004)), run(pulled(seamless(fabric.card "duck"), nil, 0.004))
assert(fy(same, "top") == fy(one, "top"), "a region of the same card changes a bit")
assert(fy(other, "top") > 1.3 * fy(one, "top"))
assert(other.model:list()[2].kind == "region" and other.model:list()[2].set == "pocket")

-- A restart needs the same bodies.
local function motion(step)
  local mm = fabric.model { bodies = {
    { name = "a", mesh = strip(), card = blend, warp = 90 },
    { name = "b", mesh = strip(0.02), card = denim },
  } }
  mm:fix("a.top", "x y z"):fix("b.top", "x y z"):gravity { 0, 0, -9.81 }
  return fabric.dynamic { model = mm, duration = 1e-3, step = step }
end
local a = motion(2e-7)
a:advance(2e-5)
a:checkpoint("bodies.ckpt")
local half = a:node(3).z
a:advance(4e-5)
local whole = a:node(3).z
assert(half ~= whole)

-- A checkpoint is refused by what differs, with the name of its region.
local function layered(t)
  local sheet = strip()
  sheet:set("pocket", function(_, y) return y > (t.edge or 0.0381) - 1e-9 end)
  local mm = fabric.model { mesh = sheet, card = blend, warp = 90, regions = not t.whole and {
    pocket = { layers = { { card = denim, warp = t.angle or 30, thickness = t.ply or 4e-4 }, { card = t.card or blend, thickness = 3e-4 } } } } or nil }
  if t.plane then
    local plane = fabric.rigid.plane { point = { 0, 0, t.plane.height or -1 }, normal = { 0, 0, 1 } }
    mm:contact { between = { plane, t.plane.side or "all" }, friction = t.plane.friction or 0 }
    if t.plane.speed then mm:move(plane, { z = fabric.ramp(t.plane.speed, 1) }) end
  end
  return fabric.static { model = pulled(mm, nil, 1e-4), duration = 1, step = 0.5 }
end
local function refuses(path, t, words)
  local good, message = pcall(function() layered(t):restart(path) end)
  message = tostring(message)
  assert(not good and message:find("of another problem: it differs in " .. words, 1, true), message)
end
layered {}:checkpoint("layered.ckpt"):solve()
layered {}:restart "layered.ckpt"
refuses("layered.ckpt", { angle = 31 }, "the warp direction of 'pocket'")
refuses("layered.ckpt", { ply = 3.9e-4 }, "the thickness of 'pocket' (0.0007 m with 3 points in each of 2 plies there, 0.00069 m with 3 points in each of 2 plies here)")
refuses("layered.ckpt", { card = fabric.card "duck" }, "the card of 'pocket'")
refuses("layered.ckpt", { edge = 0.0254 }, "the region 'the rest' (6 elements there, 4 elements here) and the region 'pocket' (6 elements there, 8 elements here)")
refuses("layered.ckpt", { whole = true }, "the region 'the rest' (none here) and the region 'pocket' (none here)")
refuses("layered.ckpt", { plane = {} }, "the rigid body 'plane' (none there) and the contact of plane and 'all' (none there)")
layered { plane = {} }:checkpoint("plane.ckpt"):solve()
refuses("plane.ckpt", {}, "the rigid body 'plane' (none here) and the contact of plane and 'all' (none here)")
refuses("plane.ckpt", { plane = { height = -2 } }, "the rigid body 'plane' (plane through (0, 0, -1) m, normal (0, 0, 1) there, plane through (0, 0, -2) m, normal (0, 0, 1) here)")
refuses("plane.ckpt", { plane = { friction = 0.2 } }, "the contact of plane and 'all' (friction 0 there, friction 0.2 here)")
refuses("plane.ckpt", { plane = { side = "pocket" } }, "the contact of plane and 'pocket' (none there) and the contact of plane and 'all' (none here)")
refuses("plane.ckpt", { plane = { speed = -0.1 } }, "the motion of rigid body 'plane' (none there)")

-- Taking back.
local n = #m:list()
local fresh = fabric.model { mesh = strip(), card = blend }
fresh:fix("bottom", "x"):fix("top", "x y"):gravity { 0, 0, -1 }
fresh:remove(fresh:list()[1])
assert(#fresh:list() == 2 and fresh:list()[1].set == "top")
fresh:remove(2):remove { kind = "fix", set = "top" }
assert(#fresh:list() == 0)

-- Wrong calls.
local function wrong(f, words)
  local good, message = pcall(f)
  assert(not good and tostring(message):find(words, 1, true), "expected: " .. words .. "\ngot: " .. tostring(message))
end
local function bodies(list) return function() fabric.model { bodies = list } end end
wrong(bodies {}, "model: field 'bodies': expected at least one body, got an empty table")
wrong(bodies { 5 }, "model: field 'bodies': expected a list of tables {name=, mesh=, card=, ...}, got 5")
wrong(bodies { { mesh = front, card = blend } }, "model: field 'bodies[1].name': expected a string, got nil")
wrong(bodies { { name = "a.b", mesh = front, card = blend } },
  "field 'bodies[1].name': expected a name without blanks and full stops, got 'a.b'")
wrong(bodies { { name = "a", mesh = front, card = blend }, { name = "a", mesh = back, card = blend } },
  "field 'bodies[2].name': expected a name of its own, got 'a' twice")
wrong(bodies { { name = "a", mesh = front } }, "field 'bodies[1].card': expected either a card or layers={ {card=}, ... }, got neither")
wrong(bodies { { name = "a", mesh = front, card = blend, regions = { nowhere = { card = blend } } } }, "'nowhere'")
wrong(bodies { { name = "a", mesh = front, card = blend, regions = { pocket = 5 } } },
  "field 'bodies[1].regions': expected { set = {card=, ...}, ... }, got an entry 'pocket' = 5")
wrong(bodies { { name = "a", mesh = front, card = blend, regions = { bottom = { card = blend } } } }, "region 'bottom' holds no whole element")
wrong(bodies { { name = "a", mesh = front, card = blend, regions = { all = { thicknes = 1 } } } },
  "unknown field 'bodies[1].regions.all.thicknes', did you mean 'bodies[1].regions.all.thickness'?")
wrong(function() fabric.model { mesh = front, card = blend, bodies = { { name = "a", mesh = back, card = blend } } } end,
  "model: field 'mesh': expected inside each of the bodies, where 'bodies' is given")
wrong(function() fabric.model { card = blend } end, "model: field 'mesh': expected a mesh, got nil (missing, or a misspelt variable)")
wrong(function() fabric.model { bodies = { { name = "a", mesh = front, card = blend } } }:fix("left", "x") end, "'left'")
wrong(function() fabric.model { mesh = strip(), card = blend }:remove(1) end, "remove: expected something declared, the model has nothing in m:list()")
wrong(function() fabric.model { mesh = strip(), card = blend }:remove { kind = "fix", set = "top" } end,
  "remove: the model has no fix of 'top' (m:list() shows what it has)")
assert(n == 10)
wrong(function() m:remove(1) end, "remove: a body is part of the model itself and cannot be removed: make a new model")
wrong(function() m:remove(3) end, "remove: the model is in use by an analysis and can't be changed any more")
