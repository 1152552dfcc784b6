-- Where the work of a tear goes: force times way is breaking, hysteresis, damping and what is stored; the mean has a band; and an energy found from a tear is that of the card.
local fabric = require "fabric"
local mm = fabric.units.mm
local function near(what, got, want, share) assert(math.abs(got / want - 1) < share, ("%s: got %.5g, want %.5g"):format(what, got, want)) end
local function torn(card, more)
  local t = { card = card, h = 3.5 * mm, width = 42 * mm, leg = 35 * mm, tear = 42 * mm }
  for name, value in pairs(more or {}) do t[name] = value end
  return fabric.lab.tear(t)
end
local function breaking(energy) return { rupture = { weft = { strength = 5e3, energy = energy }, warp = { strength = 5e3, energy = energy } } } end

-- Elastic legs: half of the energy within 4 % on so few elements, and no hysteresis.
local elastic = fabric.svk { young = 1.2e8, poisson = 0, density = 600, thickness = 0.5 * mm, through_thickness = true }:with(breaking(9))
local test = torn(elastic)
near("elastic legs", test.mean, 4.5, 0.04)
local b = test.balance
assert(b.hysteresis == 0 and test.rigid == 4.5)
near("the parts and the work", b.fracture + b.hysteresis + b.damping + b.stored + b.kinetic, b.work, 1e-3)
near("mean and what is expected of the balance", test.mean, test.expected, 0.04)
assert(test.band and test.band[1] < test.mean and test.mean < test.band[2] and test.band.blocks >= 3)
near("force times way", test.mean * b.way, b.work, 1e-12)

-- Legs that dissipate: the mean holds it, damping is below a hundredth, and what the test says of it gives the energy back.
local lossy = fabric.card("denim", { bending = "estimated" }):with(breaking(9))
test = torn(lossy)
b = test.balance
assert(test.mean > 1.03 * 4.5 and b.hysteresis > 0.04 * b.work and b.damping < 0.01 * b.work, b.damping / b.work)
near("mean and what is expected of the balance, denim", test.mean, test.expected, 0.04)
local found = fabric.lab.rupture { card = lossy, weft = { strips = { 250, 255 }, width = 50 * mm, tears = { test.mean } } }
near("energy from a tear whose legs dissipate", found.weft.energy, 9, 0.04)
assert(found.weft.legs.hysteresis > 0.04 and found.weft.words:find "legs of this card dissipate")
near("without their part", fabric.lab.rupture { card = lossy, legs = false, weft = { strips = { 250, 255 }, width = 50 * mm, tears = { test.mean } } }.weft.energy, 2 * test.mean, 1e-12)

-- A hook that only looks at each step changes nothing; one at times of its own makes steps end there, and moves the mean within the band.
local small = { h = 4 * mm, width = 24 * mm, leg = 16 * mm, tear = 24 * mm }
local function sums(prepare)
  small.prepare = prepare
  local e = torn(elastic, small).analysis.energy
  return { e.external, e.stored, e.fracture, e.kinetic, e.damping }
end
local seen, plain = 0, sums()
local looked = sums(function(a) a:every("step", function(run) seen = seen + run.energy.kinetic + #run:field "position" end) end)
for i, value in ipairs(plain) do assert(looked[i] == value, i) end
