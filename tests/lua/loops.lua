-- Yarns that unload along curves: the card, a point, static and dynamic runs with their ledger, a checkpoint, the fit from records, what is refused.
local fabric = require "fabric"
local lab, MPa = fabric.lab, fabric.units.MPa
local draw = require "fabric.lab.random" (5)
os.execute "rm -rf out; mkdir out"
local checks = {}
local function check(name, got, want, relative) checks[#checks + 1] = { name, got, want, relative = relative } end
local function says(act, words)
  local ok, message = pcall(act)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end

-- --- the card ---
local reference = { friction = 0.3, reach = 0.5, curve = 0.6 }
local straight = fabric.card("blend"):with { warp = { unloading = 300 * MPa } }
local card = straight:with { warp = { loop = reference } }
assert(card.warp.loop.friction == 0.3 and card.weft.loop == nil and straight.warp.loop == nil)
assert(tostring(card):find("friction 0.3, over 0.5 of the way, curve 0.6", 1, true), tostring(card))
card:write "out/card.lua"
assert(fabric.card "out/card.lua" == card and fabric.card("out/card.lua").warp.loop.curve == 0.6)
local rounder = card:with { warp = { loop = { curve = 0.2 } } }
assert(rounder.warp.loop.curve == 0.2 and rounder.warp.loop.friction == 0.3 and rounder ~= card)
assert(straight:with({ warp = { loop = { friction = 0.2 } } }).warp.loop.reach == 0.5)
local report = card:check()
assert(tostring(report):find("loop.warp", 1, true), tostring(report))

-- --- a point ---
local function P(E) return card.warp.loading[1] * E + card.warp.loading[2] * E ^ 2 / 2 end
local function way(m, x) return m - (1 - x) * P(m) / (300 * MPa) end
local p = fabric.point(card)
check("the measured curve", p:uniaxial("warp", 0.1).S, P(0.1), 1e-13)
-- At a third of the reach from the peak strands end: friction (1 - (1 - 1/3)^2) is lost.
local x = 1 - reference.reach / 3
check("on the way back", p:uniaxial("warp", way(0.1, x)).S,
  P(0.1) * ((1 - reference.friction) * (1 - reference.curve + reference.curve * x) * x + reference.friction * 4 / 9), 1e-11)
check("residual strain", p:state().residual1, way(0.1, 0), 1e-13)

-- --- static: a strip pulled, let go, pulled again ---
local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 1, ny = 1 }
local function pulled(of, history)
  return fabric.model { mesh = mesh, card = of }:fix("all", "z rotation"):fix("left", "x"):fix("bottom", "y"):move("right", { x = history })
end
local function stretched(E) return 0.1 * (math.sqrt(1 + 2 * E) - 1) end
local turns = { 0.1, way(0.1, 0.3), way(0.1, 0.7), way(0.1, 0.5), 0.1, 0.11 }
local history, rows = { { 0, 0 } }, {}
for k, E in ipairs(turns) do history[k + 1] = { k, stretched(E) } end
local function run(of, step) return fabric.static { model = pulled(of, fabric.history(history)), duration = #turns, step = step or 0.05 } end
local a = run(card)
rows = fabric.point(card):uniaxial("warp", turns)
for k in ipairs(turns) do
  a:advance(k)
  check(("static, at turn %d"):format(k), a:mean "S11", rows[k].S, 1e-7)
end
-- Work within what the forces at both ends of the steps allow is what the cloth took up.
local function gap(of) local e = of.energy return math.abs(e.external - e.internal) / math.abs(e.external) end
local coarse, fine = gap(a), gap(run(card, 0.0125):solve())
assert(coarse < 1e-9 and fine < 1e-9, ("%g %g"):format(coarse, fine))
local volume = 0.01 * card.thickness
check("dissipated in the warp, as at a point", a.energy.dissipated_warp, rows[#turns].dissipated_warp * volume, 1e-6)

-- --- a checkpoint within a loop: the rest of the run is the same to the last bit ---
local whole = run(card):solve()
run(card):checkpoint("out/half.ckpt", { every = "step" }):advance(3.5)
local again = run(card):restart "out/half.ckpt"
assert(math.abs(again.time - 3.5) < 1e-9 and again:mean "S11" ~= whole:mean "S11")
again:solve()
assert(again:reaction "right" == whole:reaction "right")
for _, name in ipairs { "S11", "E11", "dissipated" } do
  local one, two = whole:field(name), again:field(name)
  for i = 1, #one do assert(one[i] == two[i], name) end
end
says(function() run(straight):restart "out/half.ckpt" end, "card")

-- --- motion: both schemes; the ledger closes ---
for _, scheme in ipairs { "implicit", "explicit" } do
  local quick = { { 0, 0 } }
  for k, E in ipairs(turns) do quick[k + 1] = { 2e-3 * k, stretched(E) } end
  local d = fabric.dynamic { model = pulled(card, fabric.history(quick)), duration = 2e-3 * #turns, scheme = scheme,
    step = scheme == "implicit" and 5e-5 or nil, damping = { mass = 2000 } }:solve()
  assert(d.energy.error < 3e-3, ("%s: %g"):format(scheme, d.energy.error))
  assert(d.energy.dissipated_warp > 0.9 * a.energy.dissipated_warp)
end
-- The explicit step goes by the steepest slope, Du ((1 - friction)(1 + curve) + 11 friction/(6 reach)).
local stiff = straight:with { warp = { unloading = 3000 * MPa, loop = { friction = 0.6, reach = 0.1, curve = 0.5 } } }
for _, item in ipairs(stiff:check().items) do
  if item.key == "loop.warp" then
    check("the first slope", item.numbers.first, 3000 * MPa * (0.4 * 1.5 + 11 * 0.6 / 0.6), 1e-12)
    check("the last slope", item.numbers.last, 3000 * MPa * 0.4 * 0.5, 1e-12)
    check("what a whole loop loses of the way down", item.numbers.lost, 0.6 * (1 - 0.1 * 73 / 108) / (0.4 * (0.5 - 0.5 / 6) + 0.6 * 0.1 * 73 / 216), 1e-12)
  elseif item.key == "step" then
    local nu12, nu21 = card.warp.poisson, card.weft.poisson
    local c = math.min(nu21 * card.warp.loading[1], nu12 * card.weft.loading[1]) / (1 - nu12 * nu21)
    local one, two = 3000 * MPa * 11.6 + c * nu12, card.weft.unloading + c * nu21
    check("stiffest tangent", item.numbers.stiffest, (one + two) / 2 + math.sqrt((one - two) ^ 2 / 4 + c * c), 1e-12)
  end
end

-- --- from records ---
local function tests_of(of, n, noise)
  local out = {}
  for i = 1, n do
    local E, S, branches = {}, {}, {}
    local corners, kinds = { 0, 0.12, way(0.12, 0.1), way(0.12, 0.7), way(0.12, 0.05), 0.12, 0.13 }, { "loading", "unloading", "reloading", "unloading", "reloading", "loading" }
    for k, kind in ipairs(kinds) do
      local first = #E + 1
      for j = 1, 60 do E[#E + 1] = corners[k] + (corners[k + 1] - corners[k]) * j / 60 end
      branches[k] = { kind = kind, first = first, last = #E }
    end
    for j, r in ipairs(fabric.point(of):uniaxial("warp", E)) do S[j] = r.S + noise * P(0.13) * draw.normal() end
    out[i] = { E = E, S = S, branches = branches }
  end
  return out
end
local exact = lab.loops { tests = tests_of(card, 1, 0) }
for name, want in pairs(reference) do check("without noise: " .. name, exact.loop[name], want, 2e-3) end
check("without noise: unloading", exact.unloading, 300 * MPa, 2e-3)
assert(exact.rms.curved.all < 1e-3 and exact.rms.straight.unloading > 0.05 and exact.text:find("the straight law misses it by rms", 1, true), exact.text)
local plain = lab.loops { tests = tests_of(straight, 1, 0.004) }
assert(not plain.curved and plain.loop == nil and plain.text:find("The straight law is good enough", 1, true), plain.text)
-- Bands of single specimens hold the true value as often as they say.
local inside, all = 0, 0
for _ = 1, 12 do
  local l = lab.loops { tests = tests_of(card, 1, 0.005) }
  for name, want in pairs(reference) do
    all = all + 1
    if l.low[name] <= want and want <= l.high[name] then inside = inside + 1 end
  end
end
assert(inside >= 0.8 * all, ("%d of %d"):format(inside, all))
local three = lab.loops { tests = tests_of(card, 3, 0.005) }
assert(three.band == nil or #three.band.value == three.degree + 1)
local made = lab.card { name = "mine", density = 590, thickness = 4e-4, warp = three, poisson = { warp = 0.25 }, assume = true }
assert(made.warp.loop.friction == three.loop.friction and made.provenance["warp.loop"]:find "^fitted to 3 specimens: friction")
assert(made.provenance["weft.loop"]:find "^assumed")
-- ... of one specimen the card has no band, and says so where it is printed
local alone = lab.card { name = "one", warp = lab.loops { tests = tests_of(card, 1, 0.005) }, weft = lab.loops { tests = tests_of(card, 1, 0.005) },
  shear = { loading = { 1e6 }, unloading = 3e6, tested = 0.2 }, poisson = { warp = 0.2, weft = 0.2 }, density = 500, thickness = 4e-4 }
local says_so = "the card has no band of it: one specimen does not show how others differ"
assert(tostring(alone):find(says_so, 1, true) and not tostring(made):find(says_so, 1, true), tostring(alone))
assert(made:with({ warp = { loop = { reach = 0.9 } } }).provenance["warp.loop"] == "typed: changed by card:with")

-- --- a folder: the misfit is told; the card goes along curves where it is asked for ---
local folder, write_report = require "fabric.lab.folder", require "fabric.lab.report".write
local function lay(loops)
  os.execute "mkdir -p out/folder"
  local gauge, width, thickness = 0.2, 0.05, card.thickness
  for i, test in ipairs(tests_of(card, 2, 0.002)) do
    local f <close> = assert(io.open(("out/folder/warp-%d.csv"):format(i), "w"))
    f:write "Displacement (mm),Force (N)\n0,0\n"
    for k, E in ipairs(test.E) do
      local stretch = math.sqrt(1 + 2 * E)
      f:write(("%.6f,%.6f\n"):format(1e3 * gauge * (stretch - 1), test.S[k] * stretch * width * thickness))
    end
  end
  local f <close> = assert(io.open("out/folder/laboratory.lua", "w"))
  f:write(("return { name='mine', gauge_length=%g, width=%g, thickness=%.12g, density=500, plies=1, loops=%s }"):format(gauge, width, thickness, loops))
end
for _, asked in ipairs { "false", "true" } do
  lay(asked)
  local found = folder.reduce "out/folder"
  assert(found.warp.loops.curved and (found.card.warp.loop ~= nil) == (asked == "true"))
  local _, rows = write_report(found, "out/report")
  local told = 0
  for _, row in ipairs(rows) do -- the band holds the value, of the loop too
    local low, high = row[3]:match "^(%S+) to (%S+)$"
    if row[1]:find "^warp loop" or row[1] == "warp unloading" and asked == "true" then
      told = told + 1
      assert(tonumber(low) <= tonumber(row[2]) and tonumber(row[2]) <= tonumber(high), table.concat(row, " | "))
    end
  end
  assert(told == (asked == "true" and 4 or 0), told)
  local f <close> = assert(io.open "out/report/report.html")
  local text = f:read "a"
  assert(text:find("Loops of the warp", 1, true) and text:find("the straight law misses it by rms", 1, true))
  assert((text:find("loops=true in laboratory.lua", 1, true) ~= nil) == (asked == "false"))
  if asked == "true" then check("friction from a folder", found.card.warp.loop.friction, reference.friction, 3e-2) end
end
lay "5"
says(function() folder.reduce "out/folder" end, "laboratory.lua: field 'loops': expected true or false, got 5")

-- --- refused ---
says(function() fabric.point(card:with { law = "thesis" }) end, "field 'warp.loop': expected law = \"potential\"")
says(function() straight:with { warp = { loop = { reach = 0.5 } } } end, "field 'warp.loop.friction'")
says(function() straight:with { warp = { loop = { friction = 1 } } } end, "expected a number from 0 to below 1, got 1")
says(function() straight:with { weft = { loop = { friction = 0.1, width = 2 } } } end, "unknown field 'weft.loop.width', did you mean 'weft.loop.reach'?")
says(function() fabric.point(straight:with { warp = { loop = { friction = 0.5, curve = 1 } } }) end, "expected a tail (1 - friction) (1 - curve) unloading of at least")
says(function() lab.loops { tests = { { E = { 0, 0.01, 0.02, 0.03 }, S = { 0, 1e5, 2e5, 4e5 }, branches = { { kind = "loading", first = 1, last = 4 } } } } } end,
  "loops: field 'tests': expected a test that lets go of at least 5 % of its peak stress, got 1 of loading alone")
local pushed = tests_of(card, 1, 0)[1]
for k, S in ipairs(pushed.S) do pushed.S[k] = -S end
says(function() lab.loops { tests = { pushed } } end, "loops: field 'tests[1].S': stress runs from -")
for k in ipairs(pushed.S) do pushed.S[k] = 0 end
says(function() lab.loops { tests = { pushed } } end, "loops: field 'tests[1].S': stress runs from 0 to 0 Pa: expected a pull")
says(function() lab.loops { tests = tests_of(card, 1, 0), fit = { loading = { { 0.1, 1e6 } }, tested = 0.1 } } end,
  "loops: field 'fit.loading': expected moduli, or two points {strain, stress} and more, got 1")
fabric.expect(checks)
