-- fabric.budget says which test would narrow an interval, and by how much: closed forms of independent inputs.
local fabric = require "fabric"
local duck = fabric.card "duck"
local card = duck:with { provenance = { ["shear.loading"] = "assumed: for the test", ["warp.poisson"] = "assumed: for the test", ["weft.unloading"] = "assumed: for the test" },
  ranges = { ["shear.loading"] = { 0.5, 1.5 }, ["warp.poisson"] = { 0.2, 0.3 }, ["weft.unloading"] = { 0.9, 1.3 } } }
-- Uniform inputs: the factor on shear is drawn in its logarithm, so that of the answer its logarithm is taken; the third input is not used.
local b = fabric.budget { card = card, samples = 128, print = false, processes = 1, assumed = { own = { 0, 0.1 } }, run = function(p)
  return { y = math.log(p.card.shear.loading[1] / duck.shear.loading[1]) / math.log(3) + 3 * p.card.warp.poisson + p.assumed.own }
end }
local whole = 1 + 0.3 ^ 2 + 0.1 ^ 2 -- times 1/12
assert(#b.narrower == 1, #b.narrower) -- 8 % for the ratio, 1 % of the deck's own
local one = b.narrower[1]
assert(one.name == "y" and one.field == "shear.loading" and one.test:find "^a bias pull" and math.abs(one.width - math.sqrt(1 - 1 / whole)) < 0.08, one.width)
assert(b.text:find("to narrow y: shear.loading by a bias pull, ", 1, true) and b.text:find "with it known the interval would be about 0%.%d+ times as wide", b.text)
-- nothing is said where nothing that is assumed matters
b = fabric.budget { card = card, samples = 16, print = false, processes = 1, assumed = { own = { 0, 1 } }, run = function(p) return { y = p.assumed.own } end }
assert(#b.narrower == 0 and not b.text:find("to narrow", 1, true), b.text)
