-- Numbers of a card that are assumed instead of measured, with the range in which it may lie, for fabric.budget.
--
-- The range is the one that the card states, card.ranges["warp.poisson"] = { 0.1, 0.6 }, or else the rule below. Ranges of `poisson` are
-- values, the others factors on the card's value; those of `loading` are factors on all forces of the part, unloading and friction too.
local lists = require "fabric.lists"
local assumed = {}

local rules = {
  poisson = { 0.1, 1, why = "seven of the eight of [williams2010] are 0.12 to 0.99" },
  no_poisson = { 0, 1, why = "from none to the largest of [williams2010]" },
  unloading = { 0.6, 2.5, why = "eight curves of [williams2010] unload 2.5 to 10.2 times as steeply as they load; the rule says 4" },
  shear_unloading = { 0.5, 1.3, why = "four curves of [williams2010] unload 1.5 to 3.9 times as steeply as they load; the rule says 3" },
  loading = { 0.5, 2, why = "a guess: not measured on this cloth" },
  bending = { 0.15, 4, why = "95 % of 307 cloths [feng2022] have 0.146 to 4.12 times the median of those with their mass within a quarter" },
  twist = { 0.05, 5, why = "309 cloths [feng2022] have at 45 degrees a twist of up to 5.2 times half of the mean of warp and weft (97.5 %), the stiffer three quarters 0.2 and more, an eighth none" },
}

-- How a value is put into a card.
local function poisson(part) return function(card, value) return card:with { [part] = { poisson = value } } end end
-- A woven law takes both ratios zero or neither, so that of a card whose ratios are zero both are one quantity.
local function both_poisson(card, value) return card:with { warp = { poisson = value }, weft = { poisson = value } } end
local function without_poisson(card) return card.warp.poisson == 0 and card.weft.poisson == 0 end
local function unloading(part)
  return function(card, factor) return card:with { [part] = { unloading = factor * card[part].unloading } } end
end
local function scaled(B, factor)
  return type(B) == "table" and lists.scaled(B, factor) or factor * B
end
-- Numbers of a polynomial, or points {strain, stress}.
local function stiffer(loading, factor)
  return lists.map(loading, function(v) return type(v) == "table" and { v[1], factor * v[2] } or factor * v end)
end
local function loading(part)
  return function(card, factor)
    local own, out = card[part], {}
    out.loading, out.unloading = stiffer(own.loading, factor), factor * own.unloading
    if own.friction then out.friction = { stress = factor * own.friction.stress, growth = factor * (own.friction.growth or 0) } end
    return card:with { [part] = out }
  end
end
local function bending(card, factor)
  local b = card.bending
  return card:with { bending = { warp = scaled(b.warp, factor), weft = scaled(b.weft, factor), twist = scaled(b.twist, factor) } }
end
local function twist(card, factor) return card:with { bending = { twist = scaled(card.bending.twist, factor) } } end

local known = {
  { "warp.loading", "loading", loading "warp" }, { "weft.loading", "loading", loading "weft" }, { "shear.loading", "loading", loading "shear" },
  { "warp.poisson", "poisson", poisson "warp" }, { "weft.poisson", "poisson", poisson "weft" },
  { "warp.unloading", "unloading", unloading "warp" }, { "weft.unloading", "unloading", unloading "weft" },
  { "shear.unloading", "shear_unloading", unloading "shear" },
}

-- A model refuses cards that can be written down, such as one whose loading is steeper than its unloading.
local function accepted(apply, card, value)
  local made, changed = pcall(apply, card, value)
  return made and changed:check().ok
end

-- The ends of a range at which the card is refused move halfway towards its value, five times at most.
local function usable(card, input)
  for _, side in ipairs { 1, 2 } do
    for _ = 1, 5 do
      if accepted(input.apply, card, input[side]) then break end
      input[side] = (input[side] + input.value) / 2
    end
  end
  return input
end

-- The assumed quantities of a card: a list of { name, low, high, value, apply, why }, and the names of those that nothing varies.
function assumed.of(card)
  local list, others, provenance, ranges = {}, {}, card.provenance or {}, card.ranges or {}
  local function add(name, rule, value, apply)
    local range = ranges[name] or rules[rule]
    list[#list + 1] = usable(card, { range[1], range[2], name = name, value = value, apply = apply, why = ranges[name] and "the card" or range.why })
  end
  local function is_assumed(field) return provenance[field] and provenance[field]:find "^assumed" end
  local seen, zero = { bending = true, ["bending.twist"] = true }, without_poisson(card)
  if zero and is_assumed "warp.poisson" then add("poisson", "no_poisson", 0, both_poisson) end
  for _, row in ipairs(known) do
    seen[row[1]] = true
    if is_assumed(row[1]) and not (zero and row[2] == "poisson") then
      add(row[1], row[2], row[2] == "poisson" and card[row[1]:match "^%a+"].poisson or 1, row[3])
    end
  end
  if card.bending and is_assumed "bending" then add("bending", "bending", 1, bending) end
  if card.bending and is_assumed "bending.twist" then add("bending.twist", "twist", 1, twist) end
  for name in pairs(provenance) do
    if is_assumed(name) and (not seen[name] or not card.bending and name:find "^bending") then others[#others + 1] = name end
  end
  table.sort(others)
  return list, others
end

return assumed
