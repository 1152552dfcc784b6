-- How sizes, laboratories and specimens differ, learned from records and carried to a specimen that was not tested: what one record cannot tell is said, closed
-- forms, bands that hold as often as they say, cards with the bands of every route. The short form makes fewer sets.
local fabric = require "fabric"
local lab = fabric.lab
local effects = require "fabric.lab.card.effects"
local draw = require "fabric.lab.random" (17)

local function close(got, want, relative, what)
  assert(math.abs(got - want) <= relative * math.abs(want), ("%s: %g, want %g"):format(what or "value", got, want))
end
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails

local x = {}
for k = 1, 10 do x[k] = k / 10 end
-- A record that differs from the model 2x by c1 + c2 s + c3 (3 s^2 - 1)/2, s from -1 to 1.
local function record(c, labels)
  local t = { x = x, scale = {}, rest = {}, labels = labels or {} }
  for k, at in ipairs(x) do
    local s = (2 * at - 1.1) / 0.9
    t.scale[k] = 2 * at
    t.rest[k] = 2 * at * (c[1] + c[2] * s + c[3] * (3 * s * s - 1) / 2)
  end
  return t
end

-- --- what cannot be known ---
local one = effects.learn({ record { 0.1, 0, 0 } }, {}, 0.95)
assert(one.freedom == 0 and select(2, one:predict(record { 0, 0, 0 })) == "a single record says nothing of others")
local same = effects.learn({ record({ 0.1, 0, 0 }, { laboratory = "A" }), record({ -0.1, 0, 0 }, { laboratory = "A" }) }, { "laboratory" }, 0.95)
assert(same:predict(record({ 0, 0, 0 }, { laboratory = "A" })))
local none, why = same:predict(record({ 0, 0, 0 }, { laboratory = "B" }))
assert(not none and why == "all tests have one laboratory, A: how much another one differs is not in them", why)
assert(effects.text(same):find("a new specimen differs by", 1, true) and effects.text(same):find(", all of one laboratory", 1, true))

-- --- bands go with the records' differences, whatever their unit and order ---
local function of(factor, order)
  local c = { { 0.05, 0.02, 0 }, { -0.03, 0.01, 0.01 }, { -0.02, -0.03, -0.01 } }
  local tests = {}
  for n, i in ipairs(order) do tests[n] = record({ factor * c[i][1], factor * c[i][2], factor * c[i][3] }) end
  local e = effects.learn(tests, {}, 0.95)
  return e:predict(record { 0, 0, 0 }).half, e
end
local half, e = of(1, { 1, 2, 3 })
assert(e.freedom == 6)
for k, h in ipairs((of(2, { 3, 1, 2 }))) do close(h, 2 * half[k], 1e-6, "twice the differences") end
for k, h in ipairs(half) do assert(h > 0.05 * x[k] and h < 0.5 * x[k]) end
-- one more of a laboratory that is known is predicted by what that one showed
local known = effects.learn({ record({ 0.1, 0, 0 }, { laboratory = "A" }), record({ 0.101, 0, 0 }, { laboratory = "A" }), record({ -0.1, 0, 0 }, { laboratory = "B" }),
  record({ -0.101, 0, 0 }, { laboratory = "B" }) }, { "laboratory" }, 0.95)
local of_A, of_C = known:predict(record({ 0, 0, 0 }, { laboratory = "A" })), known:predict(record({ 0, 0, 0 }, { laboratory = "C" }))
for k, at in ipairs(x) do
  close(of_A.shift[k], 0.1 * 2 * at, 0.05, "laboratory A")
  assert(of_A.half[k] < 0.2 * of_C.half[k] and math.abs(of_C.shift[k]) < 0.02 * at)
end

-- --- coverage: 95 % of the points of a new size, over many made sets; records differ by a factor, a tilt and a bend ---
local function coverage(n, w, trials)
  local inside = 0
  for _ = 1, trials do
    local tests = {}
    local function made() return record { 0.08 * w[1] * draw.normal(), 0.08 * w[2] * draw.normal(), 0.08 * w[3] * draw.normal() } end
    for i = 1, n do tests[i] = made() end
    local new = made()
    local p = effects.learn(tests, {}, 0.95):predict(new)
    for k, y in ipairs(new.rest) do inside = inside + (math.abs(y - p.shift[k]) <= p.half[k] and 1 or 0) end
  end
  return inside / trials / #x
end
-- two laboratories are one degree of freedom, however many modes their curves have; a third beside two records of each likewise
local pair = effects.learn({ record({ 0.1, 0.03, 0.01 }, { laboratory = "A" }), record({ -0.1, 0.02, -0.02 }, { laboratory = "B" }) }, { "laboratory" }, 0.95)
local third = pair:predict(record({ 0, 0, 0 }, { laboratory = "C" }))
for k, at in ipairs(x) do assert(third.half[k] > 12.7 * 0.1 * at, third.half[k]) end -- deviation 0.141 of a laboratory, and the mean's own
local function another(labs, each, trials)
  local inside = 0
  for _ = 1, trials do
    local tests, own = {}, {}
    for lab = 1, labs + 1 do own[lab] = { 0.1 * draw.normal(), 0.05 * draw.normal(), 0.02 * draw.normal() } end
    local function made(lab)
      local c = own[lab]
      return record({ c[1] + 0.01 * draw.normal(), c[2] + 0.005 * draw.normal(), c[3] + 0.003 * draw.normal() }, { laboratory = lab })
    end
    for lab = 1, labs do
      for _ = 1, each do tests[#tests + 1] = made(lab) end
    end
    local new = made(labs + 1)
    local p = effects.learn(tests, { "laboratory" }, 0.95):predict(new)
    for k, y in ipairs(new.rest) do inside = inside + (math.abs(y - p.shift[k]) <= p.half[k] and 1 or 0) end
  end
  return inside / trials / #x
end
local share = os.getenv "FABRICSH_TEST_LONG" and 1 or 0.4
local one_each, three_each, of_three = another(2, 1, 100 * share // 1), another(2, 3, 100 * share // 1), another(3, 2, 100 * share // 1)
assert(one_each > 0.9 and three_each > 0.87 and of_three > 0.87, ("%g %g %g"):format(one_each, three_each, of_three))

local two, four = coverage(2, { 1, 0.5, 0.25 }, 150 * share // 1), coverage(4, { 1, 0.5, 0.25 }, 150 * share // 1)
assert(two > 0.87 and two <= 1 and four > 0.9 and four < 0.99, ("%g %g"):format(two, four)) -- a set counts as about two points: +- 3 standard errors

-- --- a pool with a model of width and angle, and a specimen that was not there ---
local function force(p, t)
  local y = {}
  for k, at in ipairs(t.x) do y[k] = t.width * (p.a * at + p.b * at * at) end
  return y
end
local tests, parameters = {}, { { name = "a", start = 1, low = 0, high = 10 }, { name = "b", start = 1, low = 0, high = 10 } }
for i, s in ipairs { { 1, "A", 1.05 }, { 2, "A", 1.02 }, { 1, "B", 0.97 }, { 3, "B", 0.95 }, { 2, "C", 1.01 } } do
  tests[i] = { name = "pull " .. i, width = s[1], laboratory = s[2], x = x, noise = 0.02, measured = {} }
  for k, y in ipairs(force({ a = 2, b = 3 }, tests[i])) do tests[i].measured[k] = (s[3] + 0.02 * (-1) ^ i * x[k]) * y end
end
local function pool(more)
  local t = { parameters = parameters, tests = tests, model = force, groups = { "laboratory", "width" }, processes = 1 }
  for k, v in pairs(more or {}) do t[k] = v end
  return lab.pool(t)
end
local f = pool()
assert(#f.left_out_by.laboratory == 3 and #f.left_out_by.width == 3 and f.left_out_by.width[1].points == 20)
for _, held in ipairs(f.left_out_by.laboratory) do assert(held.inside > 0.8 and held.rms < 0.1, f.text) end
local p = f:predict { x = x, width = 5, laboratory = "D" }
for k, y in ipairs(force({ a = 2, b = 3 }, { x = x, width = 5 })) do
  assert(p.band == "learned" and p.low[k] < y and y < p.high[k] and p.high[k] < 1.5 * y)
end
assert(f.text:find "laboratory A from the others: rms" and f.text:find "bands: a new specimen differs by")
local single = pool { tests = { tests[1] } }
p = single:predict { x = x, width = 5, laboratory = "A" }
assert(not p.low and not p.band and p.reason:find "what|nothing|one" or p.reason, p.reason)
assert(single.text:find "unknown from so few; these bands are of the noise of the records alone")
fails("pool: predict: expected { x={numbers}, ... }", f.predict, f, { width = 5 })
fails("pool: field 'tests[1].thread': expected a name or a number, since specimens are grouped by it, got nil", pool, { groups = { "thread" } })
fails("pool: field 'groups[1]': expected the name of a field of the tests, got 5", pool, { groups = { 5 } })
tests[1].scale = { 1, 2 }
fails("pool: field 'tests[1].scale': expected 10 numbers, one per measured one, got 2", pool)
tests[1].scale = nil

-- --- cards with bands from every route, drawn from ---
local yarn = { loading = { 50e6 }, unloading = 60e6 }
local function cards_of(shear)
  return lab.card { name = "c", density = 500, thickness = 1e-3, warp = yarn, weft = yarn, shear = shear, poisson = { warp = 0, weft = 0 }, assume = true }:sample(200)
end
local function deviation(list, value)
  local sum, squares = 0, 0
  for _, c in ipairs(list) do sum, squares = sum + value(c) / #list, squares + value(c) ^ 2 / #list end
  return math.sqrt(squares - sum ^ 2) / sum
end
-- replicates of a monotone curve, which differ by 5 %: of the mean of four, 5 %/2 times Student's quantile over the normal one
local replicates = {}
for i, factor in ipairs { 1.05, 0.95, 1.05, 0.95 } do
  replicates[i] = { E = {}, S = {}, branches = { { kind = "loading", first = 1, last = 60 } } }
  for k = 1, 60 do replicates[i].E[k], replicates[i].S[k] = k / 300, factor * (1e6 * k / 300 + 3e7 * (k / 300) ^ 3) end
end
local fit = lab.fit { tests = replicates, degree = "monotone" }
assert(#fit.band.low == #fit.loading - 1 and fit.band.low[5] < fit.loading[6][2] and fit.loading[6][2] < fit.band.high[5])
local spread = 0.05 * math.sqrt(4 / 3) / 2 * lab.student(0.975, 3) / 1.96
close(deviation(cards_of(fit), function(c) return c.shear.loading[8][2] end), spread, 0.2, "drawn stresses of points")
-- bias pulls of several sizes
local function pull(w, h, factor)
  local s = { displacement = {}, force = {}, width = w, length = h }
  for i = 1, 40 do s.displacement[i] = 0.16 * (h - w) * i / 40 end
  s.force = lab.bias_shear({ displacement = s.displacement, card = fabric.card "blend", width = w, length = h, limit = 60 }).force
  for i, F in ipairs(s.force) do s.force[i] = factor * F end
  return s
end
local sizes = lab.bias_sizes { specimens = { pull(0.05, 0.15, 1.04), pull(0.06, 0.18, 0.97), pull(0.1, 0.3, 0.99) }, thickness = 1e-3, limit = 15 }
local drawn = deviation(cards_of(sizes.shear), function(c) return c.shear.loading[6][2] end)
assert(drawn > 0.02 and drawn < 0.2, drawn)
assert(not lab.bias_sizes({ specimens = { pull(0.05, 0.15, 1) }, thickness = 1e-3, limit = 15 }).shear.band)
-- identify and pool: S = G E measured with a deviation that is known; the card's G has it
local function S(q) return { q.G, 2 * q.G, 3 * q.G } end
local own = { { name = "G", start = 5, low = 1, high = 20 } }
local function card_of(q)
  return fabric.woven { name = "g", density = 500, thickness = 1e-3, warp = { loading = { 50e6 }, unloading = 60e6, poisson = 0 },
    weft = { loading = { 50e6 }, unloading = 60e6, poisson = 0 }, shear = { loading = { q.G * 1e6 }, unloading = 50e6 } }
end
local found = lab.identify { parameters = own, tests = { { name = "t", measured = { 10.2, 19.9, 30.3 }, noise = 0.5, predict = S } }, processes = 1 }
local card = found:card(card_of)
close(card.bands.shear.high[1] - card.shear.loading[1], 1e6 * 1.96 * found.deviation[1], 1e-3, "the band of G")
assert(not card.bands.warp and card.bands.shear.low[2] == 50e6 and #card:sample(3) == 3)
close(deviation(card:sample(400), function(c) return c.shear.loading[1] end), found.deviation[1] / found.parameters.G, 0.1, "drawn moduli")
fails("identify: card: expected a function of the parameters that returns a woven card", found.card, found, function() return 5 end)
fails("identify: card: expected a function of the parameters that returns a card, got nil", found.card, found)
local pooled = {}
for i, factor in ipairs { 0.95, 1, 1.05 } do pooled[i] = { name = "t" .. i, measured = { 10 * factor, 20 * factor }, noise = 1e-3, predict = function(q) return { q.G, 2 * q.G } end } end
f = lab.pool { parameters = own, tests = pooled, processes = 1 }
close(f:card(card_of).bands.shear.high[1], 1e6 * f.high.G, 1e-3, "the band of the pool")
for i, test in ipairs(pooled) do test.pull = i end
f = lab.pool { parameters = own, tests = pooled, groups = { "pull" }, processes = 1 } -- the place in the list is the abscissa
for _, held in ipairs(f.left_out_by.pull) do assert(held.inside and held.points == 2, held.reason) end
