-- Bending of some 300 cloths from cantilevers along warp, weft and 45 degrees [feng2022]: the twisting rigidity of each, what warp and weft tell of 45
-- degrees, with a band that the cloths left out are held against, and one cloth hung again in simulation.
--
--   fabricsh scripts/lab/real/bending.lua [out] [table] [another table of other cloths]
--
-- A table has the columns `areal density (kg/m2)` and `B warp`, `B weft`, `B 45 degrees (nN m)`. Where another is given its cloths are predicted from the
-- first one's, else every second cloth from the rest. The table is not part of the program: the default is ../shared/data/bending/feng-2022-a.csv
-- beside this checkout, or the deck says SKIPPED.
local fabric = require "fabric"
local hanging = require "fabric.lab.hanging"
local lab = fabric.lab

local place = arg[2] or (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/bending/feng-2022-a.csv"
local out = arg[1] or "out/bending"
if not arg[2] and not io.open(place) then
  print "SKIPPED: the table is not beside this checkout, in ../shared/data"
  return
end
if fabric.checking() then return end

-- Cloths {mass, warp, weft, bias} in kg/m^2 and N.m; those with a number missing or not positive are left out, which is told.
local names = { { "mass", "density" }, { "warp", "^b warp" }, { "weft", "^b weft" }, { "bias", "^b 45" } }
local function cloths(path)
  local columns, list, dropped = {}, {}, 0
  for _, column in ipairs(fabric.table { file = path, lenient = true }) do
    for _, name in ipairs(names) do
      if column.name:lower():find(name[2]) and not columns[name[1]] then columns[name[1]] = column end
    end
  end
  for _, name in ipairs(names) do
    local column = columns[name[1]]
    if not column then error(("bending: %s: expected columns 'areal density', 'B warp', 'B weft', 'B 45 degrees', there is none for %s"):format(path, name[1]), 0) end
    local unit = column.unit:gsub("[%s.]", "")
    local known = name[1] == "mass" and { ["kg/m2"] = 1, ["g/m2"] = 1e-3, [""] = 1 } or { nNm = 1e-9, uNm = 1e-6, Nm = 1, [""] = 1e-9 }
    if not known[unit] then error(("bending: %s: column '%s': expected %s, got '%s'"):format(path, column.name, name[1] == "mass" and "kg/m2 or g/m2"
      or "nN m, uN m or N m", column.unit), 0) end
    columns[name[1]] = { values = column.values, factor = known[unit] }
  end
  for i = 1, #columns.mass.values do
    local cloth, good = {}, true
    for name, column in pairs(columns) do
      cloth[name] = (column.values[i] or 0 / 0) * column.factor
      good = good and cloth[name] > 0 and cloth[name] < math.huge
    end
    if good then list[#list + 1] = cloth else dropped = dropped + 1 end
  end
  print(("%s: %d cloths%s"):format(path:match "[^/]*$", #list, dropped > 0 and (", %d rows without four positive numbers left out"):format(dropped) or ""))
  if #list < 40 then error(("bending: %s: expected 40 cloths and more, for a band of 95 %%, got %d"):format(path, #list), 0) end
  return list
end

-- The rigidity at 45 degrees over the geometric mean of warp and weft; its 2.5, 50 and 97.5 % quantiles over the cloths (places (n + 1) p of the ordered list).
local function ratio(cloth) return cloth.bias / math.sqrt(cloth.warp * cloth.weft) end
local function quantiles(list)
  local ratios, found = {}, {}
  for i, cloth in ipairs(list) do ratios[i] = ratio(cloth) end
  table.sort(ratios)
  for i, p in ipairs { 0.025, 0.5, 0.975 } do
    local at = math.max(1, math.min(#ratios, (#ratios + 1) * p))
    local k = math.min(#ratios - 1, math.floor(at))
    found[i] = ratios[k] + (at - k) * (ratios[k + 1] - ratios[k])
  end
  return found
end
local function held(list, band)
  local inside = 0
  for _, cloth in ipairs(list) do
    local r = ratio(cloth)
    if band[1] <= r and r <= band[3] then inside = inside + 1 end
  end
  return inside
end

local all, rows = cloths(place), {}
local without, guess = 0, 0
for _, cloth in ipairs(all) do
  if not lab.twist({ warp = cloth.warp, weft = cloth.weft, bias = cloth.bias }).reached then without = without + 1 end
  if math.abs(((cloth.warp + cloth.weft) / 4 + math.sqrt(cloth.warp * cloth.weft) / 2) / cloth.bias - 1) > 0.2 then guess = guess + 1 end
end
print(("%.0f %% show less at 45 degrees than any positive twist permits; with twist = sqrt(warp weft)/2 the bias is missed by more than 20 %% for %.0f %%"):format(
  100 * without / #all, 100 * guess / #all))
local band = quantiles(all)
print(("45 degrees shows %.2f times the geometric mean of warp and weft, 95 %% of the cloths %.2f to %.2f"):format(band[2], band[1], band[3]))

local inside, of
if arg[3] then
  local others = cloths(arg[3])
  inside, of = held(others, band), #others
else
  local halves = { {}, {} }
  for i, cloth in ipairs(all) do table.insert(halves[i % 2 + 1], cloth) end
  inside, of = held(halves[1], quantiles(halves[2])) + held(halves[2], quantiles(halves[1])), #all
end
print(("left out: %d of %d cloths (%.1f %%) lie in the band of the others"):format(inside, of, 100 * inside / of))
-- A count of `of` cloths, and quantiles from as many: three deviations.
rows[1] = { "cloths left out, in the band of the others", inside / of, 0.95, absolute = 3 * math.sqrt(0.05 * 0.95 * (1 / of + 1 / #all)) }

-- The cloth of the middle mass: a card with the twist that its strip needs, hung again.
table.sort(all, function(a, b) return a.mass < b.mass end)
local cloth = all[(#all + 1) // 2]
local twist = lab.twist { warp = cloth.warp, weft = cloth.weft, bias = cloth.bias, simulate = true }
local card = hanging { name = "bending", source = "[feng2022], the cloth of the middle mass", mass = cloth.mass, bending = twist.bending,
  bending_origin = "measured: cantilevers along warp and weft; twist from 45 degrees" }
print(("%.4f kg/m2: %s"):format(cloth.mass, twist.words or "the twist that the strip at 45 degrees needs"))
for _, side in ipairs { { "warp", 0 }, { "weft", 90 }, { "bias", 45 } } do
  local shown = lab.cantilever { card = card, direction = side[2], cells = 20 }
  local measured = cloth[side[1]]
  print(("%-5s measured %.3g, simulated %.3g uN.m (%+.1f %%), overhang %.1f mm"):format(side[1], 1e6 * measured, 1e6 * shown.rigidity,
    100 * (shown.rigidity / measured - 1), 1e3 * shown.overhang))
  rows[#rows + 1] = { side[1] .. ": rigidity of the simulated cantilever", shown.rigidity, measured, relative = side[1] == "bias" and twist.reached == false and 1 or 0.03 }
end
card:write(out .. "/card.lua")
print(card)
fabric.expect(rows)
