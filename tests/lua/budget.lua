-- fabric.budget, fabric.sobol and fabric.latin_hypercube against closed forms.
local fabric = require "fabric"
local function near(got, want, allowed, what)
  if not (math.abs(got - want) <= allowed) then error(("%s: got %.6g, expected %.6g within %.2g"):format(what, got, want, allowed), 2) end
end
local function refused(words, call, ...)
  local good, message = pcall(call, ...)
  assert(not good, "accepted")
  assert(tostring(message):find(words, 1, true), tostring(message) .. "\nis without: " .. words)
end
local function by_source(list)
  local out = {}
  for _, c in ipairs(list) do out[c.source] = c end
  return out
end
local function budget(t)
  t.print = false
  return fabric.budget(t)
end

-- --- shares of inputs: a uniform on 0 to 2, b on 0 to 1. Variance of a + b: 1/3 + 1/12. Of a b: 4/9 - 1/4, of which each alone has 1/12.
local b = budget { assumed = { a = { 0, 2 }, b = { 0, 1 } }, samples = 512, run = function(p) return { sum = p.assumed.a + p.assumed.b, product = p.assumed.a * p.assumed.b } end }
local sum, product = by_source(b.contributions.sum), by_source(b.contributions.product)
near(b.value.sum, 1.5, 1e-12, "sum")
near(sum["assumed.a"].share, 0.8, 0.02, "share of a in the sum")
near(sum["assumed.b"].share, 0.2, 0.02, "share of b in the sum")
near(b.of.sum.deviation, math.sqrt(5 / 12), 0.01, "deviation of the sum")
local whole = 4 / 9 - 1 / 4
for _, name in ipairs { "assumed.a", "assumed.b" } do
  near(product[name].first, 1 / 12 / whole, 0.03, "first order of " .. name)
  near(product[name].total, (whole - 1 / 12) / whole, 0.03, "total of " .. name)
  local band = product[name].first_band
  assert(band[1] < 1 / 12 / whole and 1 / 12 / whole < band[2], "first order outside of its band")
end
near(product.together.share, 1 - 2 / 12 / whole, 0.05, "interactions")
-- 95 % of the sum lie between the points where a corner of the rectangle of area 0.025 * 2 is cut off: x^2 / 2 = 0.05.
near(b.band.sum.low, math.sqrt(0.1), 0.04, "low end")
near(b.band.sum.high, 3 - math.sqrt(0.1), 0.04, "high end")

-- One input has all of the variance, with few samples too.
b = budget { assumed = { x = { 0, 2 } }, samples = 16, run = function(p) return { square = p.assumed.x ^ 2 } end }
assert(b.runs == 33 and #b.contributions.square == 1)
near(by_source(b.contributions.square)["assumed.x"].share, 1, 1e-9, "share of the only input")

-- --- mesh and steps: 1 + 1/n^2 + 3 dt; what is extrapolated is the value.
b = budget { mesh = { 4, 8, 16 }, steps = { 0.04, 0.02, 0.01 }, run = function(p) return { f = 1 + 1 / p.mesh ^ 2 + 3 * p.step } end }
local f = by_source(b.contributions.f)
near(f.mesh.order, 2, 1e-9, "order of the mesh")
near(f.step.order, 1, 1e-9, "order of the step")
near(b.value.f, 1, 1e-12, "the limit of meshes and steps")
near(f.mesh.limit, 1 + 3 * 0.04, 1e-12, "the limit of the meshes with the longest step")
assert(f.mesh.deviation > 0.1 / 256 and f.mesh.deviation < 1 / 256 and f.step.deviation > 0.1 * 0.03 and f.step.deviation < 0.6 * 0.03)
assert(b.band.f.low < 1 and b.band.f.high > 1 and b.runs == 5 and #b.untold == 0)
-- sizes in any ratio
for _, mesh in ipairs { { 3, 7, 9 }, { 6, 15, 18 }, { 5, 6, 20 }, { 2, 5, 11, 13 } } do
  for _, p in ipairs { 0.7, 1, 1.6, 2, 3.3 } do
    b = budget { mesh = mesh, run = function(q) return { f = 2 - 0.8 / q.mesh ^ p } end }
    near(by_source(b.contributions.f).mesh.order, p, 1e-6, "order")
    near(b.value.f, 2, 1e-9, "limit")
  end
end
-- orders that act together: the true limit lies in the band, nine times in ten at least and of what has an order as of what has none
local convergence, uniform = require "fabric.lab.common.convergence", require "fabric.lab.random"(11).uniform
for _, mesh in ipairs { { 4, 12, 16 }, { 5, 16, 20 }, { 8, 20, 24 }, { 7, 13, 29 } } do
  local seen, inside = { [true] = 0, [false] = 0 }, { [true] = 0, [false] = 0 }
  for _ = 1, 400 do
    local c, h, v = { 2 * uniform() - 1, 6 * uniform() - 3, 12 * uniform() - 6 }, {}, {}
    for i, n in ipairs(mesh) do h[i], v[i] = 1 / n, c[1] / n + c[2] / n ^ 2 + c[3] / n ^ 3 end
    local found = convergence.of(h, v)
    local told = not found.untold
    seen[told], inside[told] = seen[told] + 1, inside[told] + (math.abs(found.value) <= 1.96 * found.deviation and 1 or 0)
  end
  for told, n in pairs(seen) do assert(inside[told] >= 0.9 * n, ("%s: %d of %d"):format(table.concat(mesh, ", "), inside[told], n)) end
end
-- Two meshes: the order is taken as one, the error three times as large.
b = budget { mesh = { 4, 8 }, run = function(p) return { f = 1 / p.mesh } end }
near(by_source(b.contributions.f).mesh.deviation, 3 / 8 / 2, 1e-12, "error from two meshes")
assert(b.text:find("order 1 taken", 1, true))
-- No convergence: the last value, the spread, and a line that says so.
b = budget { mesh = { 4, 8, 16 }, run = function(p) return { f = p.mesh == 8 and 2 or 1 } end }
assert(b.value.f == 1 and by_source(b.contributions.f).mesh.deviation > 0.7 and by_source(b.contributions.f).mesh.untold)
assert(b.untold[1]:find "^f: the meshes do not tell where it goes %(1, 2, 1%): the value is that of the last" and b.text:find(b.untold[1], 1, true))
assert(#b.warnings == 1 and b.warnings[1].text:find("the meshes do not tell", 1, true))

-- --- the card: a band of the warp's parameters, of which nu is read; its deviation is half the band over 1.96.
local card = fabric.card("blend"):with { bands = { warp = { low = { 7e6, 800e6, 850e6, 0.2 }, high = { 9e6, 852e6, 878e6, 0.3 },
  covariance = { 2.6e11, 0, 0, 0, 0, 1.8e14, 0, 0, 0, 0, 5.1e13, 0, 0, 0, 0, 6.5e-4 } } } }
b = budget { card = card, samples = 64, run = function(p)
  assert(not p.card:check().text:find("does not hold", 1, true)) -- a drawn card leaves the middle of its fit's band
  return { nu = p.card.warp.poisson, same = p.card.shear.unloading }
end }
near(b.of.nu.deviation, 0.05 / 1.96, 0.003, "deviation by the band")
near(by_source(b.contributions.nu)["card.warp"].share, 1, 1e-9, "share of the band")
assert(b.of.same.deviation == 0 and b.value.same == 12e6)

-- A model takes every card at both ends of what it assumes; aramid's unloading may not fall below its steepest tangent, and glass, of
-- yarns without lateral contraction, gets both Poisson ratios or none.
for _, name in ipairs(fabric.cards()) do
  local card = fabric.card(name)
  for _, input in ipairs((require "fabric.assumed".of(card))) do
    for side = 1, 2 do
      local changed = input.apply(card, input[side])
      assert(changed:check().ok, ("%s: %s = %g: %s"):format(name, input.name, input[side], changed:check().text))
    end
    assert(input[1] <= input.value and input.value <= input[2], name .. ": " .. input.name)
  end
end

-- --- what a card assumes: wool's Poisson ratios and unloading are, its curves are not; thickness is, and is not varied.
local wool = fabric.card "wool"
b = budget { card = wool, samples = 32, assumed = { ["warp.poisson"] = { 0.3, 0.5 } }, run = function(p)
  return { nu = p.card.warp.poisson, weft = p.card.weft.poisson, unloading = p.card.warp.unloading / wool.warp.unloading, loading = #p.card.warp.loading,
    twist = p.card.bending.twist / p.card.bending.warp }
end }
assert(b.band.nu.low > 0.3 and b.band.nu.high < 0.5 and b.value.nu == 0.4)
assert(b.band.weft.low > 0.1 and b.band.weft.low < 0.16 and b.band.unloading.high > 2.2)
assert(b.of.loading.deviation == 0)
near(by_source(b.contributions.twist)["assumed.bending.twist"].share, 1, 1e-6, "twist over bending")
assert(#b.not_varied == 1 and b.not_varied[1] == "thickness")
assert(b.text:find("not varied: thickness", 1, true))

-- --- the specimen: a seed that run() reads; and the same numbers for any number of processes.
local function drawn(processes)
  return budget { samples = 64, processes = processes, assumed = { a = { -1, 1 } }, run = function(p)
    return { v = p.assumed.a + require "fabric.lab.random"(p.specimen).normal() }
  end }
end
b = drawn(1)
local again = drawn(2)
assert(again.text == b.text and again.band.v.low == b.band.v.low)
near(by_source(b.contributions.v).specimen.share, 0.75, 0.12, "share of the specimen")

-- --- the band alone: of 2 a, a uniform on 0 to 3, the deviation is 6 / sqrt(12)
b = budget { assumed = { a = { 0, 3 }, c = { 0, 1 } }, samples = 128, shares = false, run = function(p) return { v = 2 * p.assumed.a } end }
assert(b.runs == 2 * 128 + 1 and #b.contributions.v == 1 and b.contributions.v[1].source == "inputs" and b.contributions.v[1].share == 1)
near(b.of.v.deviation, 6 / math.sqrt(12), 0.01, "deviation without shares")
near(b.band.v.low, 0.15, 0.05, "low end without shares")
near(b.band.v.high, 5.85, 0.05, "high end without shares")

-- --- warnings of the samples: half of the points of A and of B lie above the middle; each text that differs in numbers alone once
for _, processes in ipairs { 1, 2 } do
  b = budget { assumed = { a = { 0, 1 } }, samples = 16, processes = processes, run = function(p)
    if p.assumed.a > 0.5 then fabric.warn(("a is %.3f"):format(p.assumed.a)) end
    fabric.warn "said in every run"
    return { v = p.assumed.a }
  end }
  assert(#b.sample_warnings == 2 and #b.warnings == 1 + 16, #b.sample_warnings .. " " .. #b.warnings)
  local always, above = b.sample_warnings[1], b.sample_warnings[2]
  if always.runs ~= 32 then always, above = above, always end
  assert(always.runs == 32 and above.runs == 16 and above.code == "deck" and above.text:find "a is 0%.%d%d%d$", above.runs)
  assert(b.text:find("deck in 16 of 32 runs: ", 1, true), b.text)
end
local answers = fabric.lab.parallel { count = 2, collect = true, processes = 1, work = function(i)
  if i == 2 then fabric.warn "the second" end
  return { i }
end }
assert(#answers[1].warnings == 0 and #answers[2].warnings == 1 and answers[2].warnings[1].text:find "the second$" and answers[2][1] == 2)

-- --- the range of an assumed pull: forces of the part, up and down, by a factor; the middle of the logarithm is the card's own where the range is even
local alone = fabric.lab.kes_card { name = "alone", T = 0.5, W = 14, bending = { warp = { B = 0.11 }, weft = { B = 0.07 } } }
b = budget { card = alone, samples = 64, shares = false, assumed = { ["shear.loading"] = { 0.5, 2 } }, run = function(p)
  return { shear = math.log(p.card.shear.loading[1] / alone.shear.loading[1], 2), pull = math.log(p.card.warp.loading[1] / alone.warp.loading[1]),
    way = p.card.shear.unloading / p.card.shear.loading[1] * alone.shear.loading[1] / alone.shear.unloading }
end }
near(b.of.shear.deviation, 2 / math.sqrt(12), 0.02, "deviation of the logarithm of an assumed shear")
near(b.of.pull.deviation, math.log(30 / 0.8) / math.sqrt(12), 0.05, "deviation of the logarithm of an assumed pull")
assert(b.band.way.high < 1.31 and b.band.way.low > 0.49, b.band.way.low)

-- --- words
refused("'mesh': run(p) does not use p.mesh", budget, { mesh = { 2, 4 }, run = function() return { v = 1 } end })
refused("expected run(p) to return numbers by name, got none", budget, { run = function() return {} end })
refused("'steps': expected positive numbers, falling", budget, { steps = { 0.1, 0.2 }, run = function(p) return { v = p.step } end })
refused("'assumed.a': expected {low, high}", budget, { assumed = { a = { 2, 1 } }, run = function(p) return { v = p.assumed.a } end })
refused("of 64 samples failed: no card", budget, { assumed = { a = { 0, 1 } }, run = function(p)
  if p.assumed.a > 0.6 then error("no card", 0) end
  return { v = p.assumed.a }
end })
b = budget { assumed = { a = { 0, 1 } }, run = function(p)
  if p.assumed.a > 0.985 then error("no card", 0) end
  return { v = p.assumed.a }
end }
assert(b.failed > 0 and b.failed < 7 and b.text:find("left out because a run of theirs failed: no card", 1, true))

-- --- cases
local cases = fabric.sobol { x = { 1, 3 }, y = { mean = 5, deviation = 2 }, n = 256 }
local mean, square = 0, 0
for _, c in ipairs(cases) do
  assert(c.x > 1 and c.x < 3)
  mean, square = mean + c.y / #cases, square + (c.y - 5) ^ 2 / #cases
end
near(mean, 5, 0.04, "mean of a normal input") -- a third of what random cases give
near(math.sqrt(square), 2, 0.05, "its deviation")
assert(fabric.sobol { x = { 0, 1 }, n = 2, seed = 7 }[1].x ~= fabric.sobol { x = { 0, 1 }, n = 2, seed = 8 }[1].x)
local hypercube = fabric.latin_hypercube { x = { 0, 1 }, y = { 0, 1 }, n = 50 }
for _, name in ipairs { "x", "y" } do
  local seen = {}
  for _, c in ipairs(hypercube) do seen[math.floor(50 * c[name])] = true end
  for i = 0, 49 do assert(seen[i], "an empty part") end
end
refused("sobol: field 'x': expected {low, high}", fabric.sobol, { x = { 3, 1 }, n = 4 })
refused("sobol: field 'n': expected a whole number", fabric.sobol, { x = { 1, 3 } })
refused("latin_hypercube: expected at least one input", fabric.latin_hypercube, { n = 4 })

-- --- the error of the stresses, where run(p) shows its run: a sheet held at an end and pulled, whose stresses jump at the corners
local function pulled(p)
  local mesh = fabric.mesh.rectangle { width = 0.03, height = 0.05, nx = p.mesh, ny = 2 * p.mesh }
  local m = fabric.model { mesh = mesh, card = fabric.card "denim", warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.005, 1) })
  local a = fabric.static { model = m, duration = 1, step = 0.5 }:solve()
  p.analysis = a
  local parts = a:field "error"
  local sum = 0
  for _, share in ipairs(parts) do sum = sum + share ^ 2 / #parts end -- elements of one size
  return { force = select(2, a:reaction "top"), wrong = math.sqrt(sum) }
end
b = budget { mesh = { 3 }, run = pulled }
near(b.mesh_errors[1], b.value.wrong, 1e-9, "the error of the stresses")
near(by_source(b.contributions.force).mesh.deviation, b.value.force * b.mesh_errors[1], 1e-9 * b.value.force, "one mesh: its share of the value")
assert(b.text:find("error of the stresses", 1, true) and b.text:find("stresses on the mesh: recovered less computed, over the whole: 0.0", 1, true))
b = budget { mesh = { 3, 6, 12 }, run = pulled }
assert(#b.mesh_errors == 3 and b.mesh_errors[3] < 0.6 * b.mesh_errors[1] and by_source(b.contributions.force).mesh.order)
b = budget { mesh = { 3, 4, 5 }, run = function(p)
  pulled(p)
  return { flips = p.mesh == 4 and 1 or 1.0001 }
end }
assert(b.of.flips.deviation > 0.9 * b.mesh_errors[3] and #b.untold == 1)
refused("p.analysis: expected the run, got a number", budget, { mesh = { 3 }, run = function(p)
  p.analysis = 7
  return { f = p.mesh }
end })
