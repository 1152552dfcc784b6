-- Table 7.5 of [williams2010]: initial shear modulus from Kilby's equation and from the thesis' own reading of the bias test.
--
--   fabricsh scripts/thesis/table_7_5_kilby.lua
--
-- Kilby: 1 / G = 4 / E45 - 1 / E1 - 1 / E2 + (nu12 / E1 + nu21 / E2) with the definition of the ratios in section 3.3.3; printed
-- (3.4, 7.3) the two ratios stand exchanged. E45, the initial modulus at 45 degrees, is not printed: it can only be solved for.
-- The column "present" of the table is G12 at zero strain; half the first number of table 7.3 is the same to rounding for three of
-- the four cloths, which is how one sees that table 7.3 is dS12 / dE12 in the tensor strain and the engineering modulus half of it.
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
chapter.begin("Table 7.5", "initial shear moduli", "table_7_5")

local printed = { blend = { 1.08, 1.09 }, duck = { 0.87, 0.82 }, muslin = { 0.29, 0.76 }, denim = { 0.24, 0.43 } }

-- The relation with the card's initial moduli, ratios as defined or as printed; what: {bias=} or {shear=}.
local function relation(card, what, as_printed)
  what.warp, what.weft = card.warp.loading[1], card.weft.loading[1]
  what.nu12, what.nu21, what.reading = card.warp.poisson, card.weft.poisson, as_printed and "printed" or "definition"
  return fabric.lab.kilby(what)
end
local function kilby(card, E45, as_printed) return relation(card, { bias = E45 }, as_printed).shear end
local function solve_E45(card, G, as_printed) return relation(card, { shear = G }, as_printed).bias end

local checks, tensor = {}, {}
for _, name in ipairs { "blend", "duck", "muslin", "denim" } do
  local card = chapter.card(name)
  local G_kilby, G_present = table.unpack(printed[name])
  local half = card.shear.loading[1] / 2 / MPa
  local E45 = fabric.point(card):uniaxial(45, 1e-6).S / 1e-6
  chapter.row(name .. ": G12 at zero strain, MPa", ("present %.2f"):format(G_present), ("half of table 7.3: %.2f"):format(half))
  chapter.row(name .. ": E45 that its Kilby column implies, as printed and as defined, MPa", ("Kilby %.2f"):format(G_kilby),
              ("%.2f, %.2f"):format(solve_E45(card, G_kilby * MPa, true) / MPa, solve_E45(card, G_kilby * MPa) / MPa))
  chapter.row(name .. ": Kilby from the model's own E45, as printed and as defined, MPa", nil,
              ("E45 %.2f: %.2f, %.2f"):format(E45 / MPa, kilby(card, E45, true) / MPa, kilby(card, E45) / MPa))
  chapter.row(name .. ": difference of its two columns", nil, chapter.percent(math.abs(G_kilby - G_present) / math.max(G_kilby, G_present)))
  -- There and back; and the model's shear compliance at zero strain is that half.
  checks[#checks + 1] = { name .. ": Kilby of the E45 solved for", kilby(card, solve_E45(card, G_kilby * MPa)) / MPa, G_kilby, relative = 1e-12 }
  checks[#checks + 1] = { name .. ": S12 / 2E12 near zero over half of table 7.3", fabric.point(card):strain { E12 = 1e-7 }.S12 / 2e-7 / (half * MPa), 1, relative = 1e-5 } -- the curve bends: 1e-7 of it
  tensor[#tensor + 1] = math.abs(G_present - half) <= 0.5 * half and math.floor(2 * G_present + 0.5) == 2 * half
end
-- Rounded to the whole numbers of table 7.3, twice "present" is its first entry for blend, muslin and denim, and not for duck.
for i, name in ipairs { "blend", "duck", "muslin", "denim" } do
  checks[#checks + 1] = { name .. ": twice present rounds to table 7.3 (1: yes)", tensor[i] and 1 or 0, name == "duck" and 0 or 1, absolute = 1e-12 }
end
local curves = {}
for _, name in ipairs { "blend", "duck", "muslin", "denim" } do
  local card = chapter.card(name)
  local curve = { x = {}, y = {}, label = name }
  for i = 0, 60 do
    local x = 0.3 * i / 60
    local G = 0
    for k, d in ipairs(card.shear.loading) do G = G + d * x ^ (k - 1) end
    curve.x[i + 1], curve.y[i + 1] = x, G / 2 / MPa
  end
  curves[#curves + 1] = curve
end
chapter.plot("moduli", "Shear moduli fall at first and rise as the cloth locks: one initial number says little of them.",
             { title = "G12 of the four cloths", xlabel = "E12 (tensor)", ylabel = "dS12 / d(2 E12), MPa", curves = curves })
return chapter.expect(checks)
