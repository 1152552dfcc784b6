-- Shear that relaxes in time: a point, a static run, motion, a checkpoint, what is refused.
local fabric = require "fabric"
local MPa = fabric.units.MPa
os.execute "rm -rf out; mkdir out"
local checks = {}
local function check(name, got, want, relative) checks[#checks + 1] = { name, got, want, relative = relative } end

-- 6 MPa of S12 over E12, so 3 MPa over 2 E12; 0.7 s.
local G, tau = 3 * MPa, 0.7
local elastic = fabric.card "blend"
local card = elastic:with { viscous = { shear = { modulus = 2 * G, time = tau } } }
assert(card.viscous.shear.time == tau and elastic.viscous == nil)
assert(tostring(card):find("shear 6 MPa, over 0.7 s", 1, true), tostring(card))

-- --- a point: a step of strain, then rest; a ramp; rows with their seconds and columns ---
local p, e = fabric.point(card), fabric.point(elastic)
local S0 = e:strain { E12 = 0.05 }.S12
check("at once", p:strain { E12 = 0.05 }.S12, S0 + G * 0.1, 1e-12)
local rest = p:strain { over = 1.4 }
check("after 1.4 s of rest", rest.S12, S0 + G * 0.1 * math.exp(-2), 1e-12)
check("the time of it", rest.time, 1.4, 1e-15)
check("what is lost is not stored", rest.dissipated_shear - e:state().dissipated_shear, G * 0.1 ^ 2 / 2 * (1 - math.exp(-4)), 1e-12)
p:reset()
local rows = p:path { { 0, 0, 0.01, 0.3 }, { 0, 0, 0.02, 0.3 }, { 0, 0, 0.02 } }
local columns = fabric.point(card):path({ E12 = { 0.01, 0.02, 0.02 }, over = { 0.3, 0.3, 0 } }, { "S12", "time" })
local ramp = fabric.point(elastic):strain { E12 = 0.02 }.S12 + G * tau * (0.04 / 0.6) * (1 - math.exp(-0.6 / tau))
check("a ramp in two steps", rows[2].S12, ramp, 1e-12)
check("at rest for no time", rows[3].S12, ramp, 1e-12)
check("the same in columns", columns.S12[3], ramp, 1e-12)
check("time in columns", columns.time[3], 0.6, 1e-15)
local slow, fast = fabric.point(card):uniaxial(45, { 0.01, 0.02 }, { "S" }, 100), fabric.point(card):uniaxial(45, { 0.01, 0.02 }, { "S" })
assert(slow.S[2] < fast.S[2] and slow.S[2] > fabric.point(elastic):uniaxial(45, 0.02).S)

-- --- static: a square in simple shear, held ---
local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 1, ny = 1 }
local gamma = 0.04
local function sheared(of, history)
  return fabric.model { mesh = mesh, card = of }:fix("all", "y z rotation"):fix("bottom", "x"):move("top", { x = history })
end
local function held(of, method, step)
  local history = fabric.history { { 0, 0 }, { 0.1, 0.1 * gamma }, { 2, 0.1 * gamma } }
  return fabric.static { model = sheared(of, history), duration = 2, step = step or 0.05, method = method }
end
-- E12 = gamma / 2 and E22 = gamma^2 / 2 everywhere: what relaxes is S12 alone, whose force along the top is S12 t width.
local function closed(t)
  local rise = 0.1
  local q = G * tau * gamma / rise * (1 - math.exp(-math.min(t, rise) / tau))
  return t > rise and q * math.exp(-(t - rise) / tau) or q
end
for _, method in ipairs { "newton", "relaxation" } do
  local a, b = held(card, method):advance(0.1), held(elastic, method):advance(0.1)
  for _, t in ipairs { 0.1, 0.5, 2 } do
    a:advance(t)
    b:advance(t)
    local more = a:reaction "top" - b:reaction "top"
    check(("%s, %g s: force of what relaxes"):format(method, t), more, closed(t) * card.thickness * 0.1, method == "newton" and 1e-9 or 1e-6)
    check(("%s, %g s: the stress that is read"):format(method, t), a:mean "S12" - b:mean "S12", closed(t), method == "newton" and 1e-9 or 1e-6)
  end
  -- The force falls behind the trapezium's: the work is what the cloth took up.
  local function gap(of) local e = of.energy return math.abs(e.external - e.internal) / math.abs(e.external) end
  local coarse, finer = gap(a), gap(held(card, method, 0.0125):solve())
  assert(coarse < 1e-9 and finer < 1e-9, finer)
end

-- --- motion: the same square, both schemes, slowly; the ledger closes ---
for _, scheme in ipairs { "implicit", "explicit" } do
  local history = fabric.history { { 0, 0 }, { 5e-3, 0.1 * gamma }, { 2e-2, 0.1 * gamma } }
  local quick = elastic:with { viscous = { shear = { modulus = 2 * G, time = 5e-3 } } }
  local a = fabric.dynamic { model = sheared(quick, history), duration = 2e-2, scheme = scheme, step = scheme == "implicit" and 1e-4 or nil,
    damping = { mass = 2000 } }:solve()
  local b = fabric.dynamic { model = sheared(elastic, history), duration = 2e-2, scheme = scheme, step = scheme == "implicit" and 1e-4 or nil,
    damping = { mass = 2000 } }:solve()
  local q = G * 5e-3 * gamma / 5e-3 * (1 - math.exp(-1)) * math.exp(-3)
  check(scheme .. ": stress of what relaxes after 3 times of rest", a:mean "S12" - b:mean "S12", q, 2e-2) -- the square still swings a little
  assert(a.energy.error < 1e-3, a.energy.error)
  assert(a.energy.dissipated_shear > b.energy.dissipated_shear)
end

-- --- a checkpoint in the middle of relaxing: the rest of the run is the same to the last bit ---
local whole = held(card):solve()
held(card):checkpoint("out/run.ckpt", { every = "step" }):advance(0.5)
local again = held(card):restart "out/run.ckpt"
assert(math.abs(again.time - 0.5) < 1e-9 and again:reaction "top" ~= whole:reaction "top")
again:solve()
assert(again:reaction "top" == whole:reaction "top")
for _, name in ipairs { "S12", "E12", "dissipated" } do
  local x, y = whole:field(name), again:field(name)
  for i = 1, #x do assert(x[i] == y[i], name) end
end

-- --- refused ---
local function says(act, words)
  local ok, message = pcall(act)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end
says(function() fabric.point(card:with { law = "thesis" }) end, "field 'viscous': expected law = \"potential\"")
says(function() elastic:with { viscous = { shear = { modulus = 1e6 } } } end, "field 'viscous.shear.time'")
says(function() elastic:with { viscous = { shear = { modulus = 1e6, time = -1 } } } end, "expected a positive number in s, got -1")
says(function() fabric.static { model = sheared(card, 0), duration = 1, control = "arc" } end, "field 'control': \"arc\" follows the path of the loads")
says(function() fabric.point(card):strain { E12 = 0.1, over = -1 } end, "'over'")
says(function() fabric.point(card):path { { 0, 0, 0.1, -1 } } end, "argument 'strains.1.4': expected 0 s or more")
fabric.expect(checks)
