-- The origin of a card's numbers: fitted, copied from a card, typed in, or assumed. The results of a fit are remembered with
-- the table that it returned, so that a number put into that table later does not count as fitted.
local registry = require "fabric.define".registry
local origin = {}

local found = setmetatable({}, { __mode = "k" }) -- result -> field -> { value, words }

local function copy(value)
  if type(value) ~= "table" then return value end
  local out = {}
  for k, v in pairs(value) do out[k] = copy(v) end
  return out
end

local function same(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a == b end
  for k, v in pairs(a) do
    if not same(v, b[k]) then return false end
  end
  for k in pairs(b) do
    if a[k] == nil then return false end
  end
  return true
end

-- Records that the fields of a result have fitted values: words = { field = "fitted to 3 specimens" }.
function origin.remember(result, words)
  found[result] = {}
  for field, text in pairs(words) do found[result][field] = { value = copy(result[field]), words = text } end
end

-- Whether the field of a result still has the fitted value.
function origin.fitted(result, field)
  local kept = type(result) == "table" and found[result] and found[result][field]
  return kept and same(kept.value, result[field]) and kept.words or nil
end

-- The card from which a table, or the list in one of its fields, was read, if its value is still that of the card.
local function card_of(part, field, name)
  local card = registry.card_of(part) or type(part[field]) == "table" and registry.card_of(part[field])
  if not card then return end
  local their = card[name]
  if type(their) == "table" and same(their[field], part[field]) then return card end
end

-- The origin in words of part[field], a part of a card with this `name` ("warp", "weft", "shear").
function origin.words(part, field, name)
  local fitted = origin.fitted(part, field)
  if fitted then return fitted end
  for _, place in ipairs { name, "warp", "weft", "shear" } do
    local card = card_of(part, field, place)
    if card then
      local before = (card.provenance or {})[place .. "." .. field]
      return ("copied from the card '%s'%s%s"):format(card.name, place ~= name and ", its " .. place or "", before and " (there " .. before .. ")" or "")
    end
  end
  return "typed"
end

return origin
