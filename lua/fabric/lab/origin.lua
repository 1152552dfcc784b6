-- Where the numbers of a card come from: fitted, copied off a card, typed in, or assumed. What a fit finds is remembered with
-- the table that it returns, so that a number that was put into that table later is not taken for a fitted one.
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

-- Remembers that the fields of a result hold what was fitted: words = { field = "fitted to 3 specimens" }.
function origin.remember(result, words)
  found[result] = {}
  for field, text in pairs(words) do found[result][field] = { value = copy(result[field]), words = text } end
end

-- Whether the field of a result is still what was fitted.
function origin.fitted(result, field)
  local kept = type(result) == "table" and found[result] and found[result][field]
  return kept and same(kept.value, result[field]) and kept.words or nil
end

-- The card that a table, or the list in one of its fields, was read off, if its value is still that card's.
local function card_of(part, field, name)
  local card = registry.card_of(part) or type(part[field]) == "table" and registry.card_of(part[field])
  if not card then return end
  local their = card[name]
  if type(their) == "table" and same(their[field], part[field]) then return card end
end

-- In words: where part[field] comes from, a part of a card that is called `name` there ("warp", "weft", "shear").
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
