-- Numbers of a card for pulls and shear that nobody measured: those of the card 'worsted' in force per width, the only apparel cloth of the library that was
-- tested under the small loads of hanging cloth. How far off that may be shows on the library's six apparel cloths whose pulls and shear were measured (blend,
-- denim, duck, muslin, wool, worsted), at a stretch of 1 % and at the beginning of shear:
--
--   warp and weft  6.4 7.3 9.2 21 47 80 155 162 175 234 244 1080 N/m    worsted 7.3 and 9.2, 8.2 in the mean
--   shear          26 95 278 303 373 555 N/m                            worsted 26
local fabric = require "fabric"
local lists = require "fabric.lists"

local filled = {}

-- Ranges as factors on worsted's. The warp of wool, which hardly stretches, is left out. Shear goes down to a quarter: resistance to shear falls with the tension
-- that holds the crossings together, and hanging cloth has a fiftieth of the tension of the test.
filled.pull = { 0.8, 30, why = "eleven of twelve pulls of six apparel cloths of the library have 6.4 to 244 N/m at 1 %, 'worsted' 8.2" }
filled.shear = { 0.25, 22, why = "six apparel cloths of the library have 26 to 555 N/m, 'worsted' 26, less without the tension of the test" }
-- One yarn's pull over the other's: 0.27 0.49 0.79 1.5 12 168.
filled.other_yarn = { 0.1, 10, why = "warp over weft at 1 % is 0.27 to 12 on five of six apparel cloths of the library" }

-- The part of worsted for a cloth of this thickness, and the strain to which it was tested.
function filled.part(name, thickness)
  local worsted = fabric.card "worsted"
  local part, factor = worsted[name], worsted.thickness / thickness
  return { loading = lists.scaled(part.loading, factor), unloading = part.unloading * factor, poisson = part.poisson, measure = part.measure }, worsted.tested[name]
end

-- The words of card.provenance for a filled part, and the range of card.ranges.
local function words(what, range) return ("assumed: %s: %s"):format(what, range.why), { range[1], range[2] } end
function filled.source(name) return words("force per width as of the card 'worsted'", name == "shear" and filled.shear or filled.pull) end
function filled.source_as_other(other) return words("as the " .. other .. "'s", filled.other_yarn) end
filled.unloading_source = "assumed: over the loading as of the card 'worsted', 2 times its steepest tangent"
filled.poisson_source = "assumed: 0.4, the rule of fabric.lab.card; KES measures none"
filled.poisson, filled.poisson_range = 0.4, { 0.1, 1 }

return filled
