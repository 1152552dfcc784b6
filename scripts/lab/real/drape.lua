-- Two cloths whose bending, mass and drape were measured [matsudaira2015]: a card from the sheet, the disc let down, coefficient and folds beside the measured
-- ones (JIS: 254 mm on 127 mm).
--
--   fabricsh scripts/lab/real/drape.lua [discs] [elements over the overhang] [folder]      1 3; with a folder the outlines as figures
--   fabricsh scripts/long/lab_real_drape.lua                                               three discs of 8 elements: the comparison
--
-- The table is not part of the program: it lies in ../shared/data beside this checkout, or the deck says SKIPPED.
local fabric = require "fabric"
local hanging = require "fabric.lab.hanging"
local gf, cm = 9.80665e-3, 1e-2

local place = (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/kes-drape/matsudaira-2015-a.csv"
local discs, cells, out = tonumber(arg[1] or 1), tonumber(arg[2] or 3), arg[3]
local file = io.open(place)
if not file then
  print "SKIPPED: the table is not beside this checkout, in ../shared/data"
  return
end
local cloths = {}
for line in file:lines() do
  local name, B, HB, W, T, DC, nodes = line:match "^(%a[^,]*),([%d.]+),([%d.]+),([%d.]+),([%d.]+),([%d.]+),(%d+)$"
  if name then cloths[#cloths + 1] = { name = name, B = B * gf * cm, HB = HB * gf, mass = W * 1e-2, thickness = T * 1e-3, DC = DC + 0, nodes = nodes + 0 } end
end
file:close()
if fabric.checking() then return end

-- What the table does not have: B and 2HB are one number each, taken for warp and weft; twist half of B; friction builds up over 10 1/m; pulls as of the card
-- 'worsted'. Its shear was measured under a tension of 5 gf/cm (49 N/m) along the bias, and a cloth's resistance to shear falls with the tension that holds its
-- crossings together; a draped disc has 1 N/m of its own weight at most. `part` is what is left of it there: 1 as measured, and a quarter.
local function card_of(cloth, part)
  local friction = { moment = cloth.HB / 2, curvature = 10 }
  local card = hanging { name = cloth.name, mass = cloth.mass, thickness = cloth.thickness, source = "[matsudaira2015], table 1",
    bending = { warp = cloth.B, weft = cloth.B, twist = cloth.B / 2, friction_warp = friction, friction_weft = friction },
    bending_told = "measured: B, 2HB, one number for both directions; assumed: twist half of B, friction builds up over 10 1/m" }
  local shear, loading = card.shear, {}
  for i, v in ipairs(shear.loading) do loading[i] = part * v end
  return card:with { shear = { loading = loading, unloading = part * shear.unloading, measure = shear.measure } }
end

local expected, computed = {}, {}
print "cloth                 shear   coefficient %         folds            amplitude mm   measured"
for _, cloth in ipairs(cloths) do
  for _, part in ipairs(cells < 8 and { 1 } or { 1, 0.25 }) do
    local r = fabric.lab.cusick { card = card_of(cloth, part), disc = 0.254, support = 0.127, seeds = discs, cells = cells, still = cells < 8 and 0.02 or nil,
      file = out and ("%s/%s_%g.svg"):format(out, cloth.name:gsub(" ", "_"), part) or nil }
    print(("%-20s  %-5g   %5.1f +- %-4.1f         %4.1f +- %-4.1f     %4.1f          %.1f %%, %d folds"):format(cloth.name, part, 100 * r.coefficient,
      100 * r.scatter.coefficient, r.nodes, r.scatter.nodes, 1e3 * r.amplitude, cloth.DC, cloth.nodes))
    for _, one in ipairs(r.runs) do
      expected[#expected + 1] = { ("%s, shear %g, disc %d: ledger"):format(cloth.name, part, one.seed), one.error, 0, absolute = 1e-3 }
    end
    expected[#expected + 1] = { ("%s, shear %g: at rest"):format(cloth.name, part), r.at_rest and 1 or 0, 1, absolute = 0 }
    computed[part] = computed[part] or {}
    computed[part][cloth.name] = r
    if cells >= 8 then
      -- The broad comes out as measured; the tropical 10 to 17 points too stiff (share/doc/drape.md), which is told and not hidden in a tolerance.
      if part == 1 and cloth.name == "cotton broad" then
        expected[#expected + 1] = { cloth.name .. ": coefficient, as measured", 100 * r.coefficient, cloth.DC, absolute = 5 }
      end
      expected[#expected + 1] = { ("%s, shear %g: folds, as measured"):format(cloth.name, part), r.nodes, cloth.nodes, absolute = 2 }
    end
  end
end
for part, by_name in pairs(computed) do -- friction in bending is what tells them apart: their bending lengths are 21 and 19 mm
  expected[#expected + 1] = { ("shear %g: the broad stands 10 points and more above the tropical (1: yes)"):format(part),
    by_name["cotton broad"].coefficient - by_name["polyester tropical"].coefficient > 0.1 and 1 or 0, 1, absolute = 0 }
end
fabric.expect(expected)
