-- Cards with faults: lines, numbers and signs of the shipped ones mixed at random, each loaded as a deck would. Whatever
-- comes is a card or an error, never a crash. Not led by coverage: that would need the whole program under libFuzzer.
--   fabricsh --safe tests/fuzz/cards.lua [seconds] [seed]
local fabric = require "fabric"
local seconds, seed = tonumber(arg[1] or 60), tonumber(arg[2] or 1)
math.randomseed(seed)

local texts = {}
for i, name in ipairs(fabric.cards()) do
  local here = arg[0]:gsub("tests/fuzz/[^/]*$", "share/cards/" .. name .. ".lua")
  local f = io.open(here) or io.open("share/cards/" .. name .. ".lua")
  texts[i] = assert(f, "no card " .. name):read "a"
  f:close()
end
local odd = { "0", "-1", "1e308", "1e-308", "-0.0", "0/0", "1/0", "{}", "{1,2,3,4,5,6,7,8,9}", "nil", "true", "''", "{{}}", "function() end", "1e9", "9007199254740993",
  "math.mininteger", "setmetatable({}, {__index=function() error 'x' end})", "setmetatable({}, {__len=function() return 1e9 end})", "('x'):rep(1e5)" }

local mutations = {
  function(s) return (s:gsub("%d[%d%.e]*", function() if math.random() < 0.1 then return odd[math.random(#odd)] end end)) end,
  function(s)
    local i = math.random(#s)
    return s:sub(1, i) .. string.char(math.random(0, 255)) .. s:sub(i + 1)
  end,
  function(s)
    local i = math.random(#s)
    return s:sub(1, i) .. s:sub(i + math.random(20))
  end,
  function(s)
    local other = texts[math.random(#texts)]
    return s:sub(1, math.random(#s)) .. other:sub(math.random(#other))
  end,
  function(s) return (s:gsub("(%a+) = ([^,\n]+),", function(name, value) if math.random() < 0.1 then return name .. " = " .. odd[math.random(#odd)] .. "," end end)) end,
}

local path = os.tmpname()
local card_path, tried, loaded, from = path .. ".lua", 0, 0, os.clock()
while os.clock() - from < seconds do
  local text = texts[math.random(#texts)]
  for _ = 1, math.random(3) do text = mutations[math.random(#mutations)](text) end
  fabric.write(card_path, text)
  local good, card = pcall(fabric.card, card_path)
  tried = tried + 1
  if good then
    loaded = loaded + 1
    pcall(card.check, card)
    pcall(function() return fabric.point(card):uniaxial("warp", 0.02) end)
    assert(tostring(card))
    card:write(card_path)
    assert(fabric.card(card_path) == card, "a card that does not read back")
  end
end
os.remove(path)
os.remove(card_path)
print(("%d cards tried, %d were cards"):format(tried, loaded))
