-- What of a card is assumed instead of measured, with the range in which it may lie, for fabric.budget.
--
-- The range is the one that the card's provenance states, "assumed: 0.4 (0.1 to 0.6), ...", or else the rule below. Ranges of `poisson` are
-- values, the others factors on the card's value.
local assumed = {}

local rules = {
  poisson = { 0.1, 1, why = "seven of the eight of [williams2010] are 0.12 to 0.99" },
  unloading = { 0.6, 2.5, why = "eight curves of [williams2010] unload 2.5 to 10.2 times as steeply as they load; the rule says 4" },
  shear_unloading = { 0.5, 1.3, why = "four curves of [williams2010] unload 1.5 to 3.9 times as steeply as they load; the rule says 3" },
  bending = { 0.4, 2.5, why = "a guess: not measured on this cloth" },
  twist = { 0.5, 2, why = "a guess: not measured on this cloth" },
}

-- How a value is put into a card.
local function poisson(part) return function(card, value) return card:with { [part] = { poisson = value } } end end
local function unloading(part)
  return function(card, factor) return card:with { [part] = { unloading = factor * card[part].unloading } } end
end
local function scaled(B, factor)
  if type(B) ~= "table" then return factor * B end
  local out = {}
  for i, b in ipairs(B) do out[i] = factor * b end
  return out
end
local function bending(card, factor)
  local b = card.bending
  return card:with { bending = { warp = scaled(b.warp, factor), weft = scaled(b.weft, factor), twist = scaled(b.twist, factor) } }
end
local function twist(card, factor) return card:with { bending = { twist = scaled(card.bending.twist, factor) } } end

local known = {
  { "warp.poisson", "poisson", poisson "warp" }, { "weft.poisson", "poisson", poisson "weft" },
  { "warp.unloading", "unloading", unloading "warp" }, { "weft.unloading", "unloading", unloading "weft" },
  { "shear.unloading", "shear_unloading", unloading "shear" },
}

local function stated(words)
  local low, high = words:match "%(([%d.eE+-]+) to ([%d.eE+-]+)%)"
  low, high = tonumber(low), tonumber(high)
  return low and high and low < high and { low, high, why = "the card" } or nil
end

-- The ends of a range at which the card is refused move halfway towards its value, five times at most.
local function usable(card, input)
  for _, side in ipairs { 1, 2 } do
    for _ = 1, 5 do
      if pcall(input.apply, card, input[side]) then break end
      input[side] = (input[side] + input.value) / 2
    end
  end
  return input
end

-- The assumed quantities of a card: a list of { name, low, high, value, apply, why }, and the names of those that nothing varies.
function assumed.of(card)
  local list, others, provenance = {}, {}, card.provenance or {}
  local function add(name, rule, value, apply, words)
    local range = stated(words) or rules[rule]
    list[#list + 1] = usable(card, { range[1], range[2], name = name, value = value, apply = apply, why = range.why })
  end
  local seen = {}
  for _, row in ipairs(known) do
    local words = provenance[row[1]] or ""
    seen[row[1]] = true
    if words:find "^assumed" then add(row[1], row[2], row[2] == "poisson" and card[row[1]:match "^%a+"].poisson or 1, row[3], words) end
  end
  local words = provenance.bending or ""
  if card.bending and words:find "^assumed" then add("bending", "bending", 1, bending, words) end
  if card.bending and words:find "twist" and words:find "assumed" then add("bending.twist", "twist", 1, twist, "") end
  seen.bending = card.bending ~= nil
  for name, text in pairs(provenance) do
    if not seen[name] and text:find "^assumed" then others[#others + 1] = name end
  end
  table.sort(others)
  return list, others
end

return assumed
