-- The page of all cards, share/doc/cards.md, from the cards themselves.
--
--   fabricsh scripts/cards.lua          compares the page with what it should be; an error when it is not up to date
--   fabricsh scripts/cards.lua write    writes it
local fabric = require "fabric"
local root = arg[0]:gsub("[^/]*$", "") .. "../"
local gravity = 9.80665

-- The first sentence of a card's file says what cloth it is.
local function heading(name)
  local file <close> = assert(io.open(root .. "share/cards/" .. name .. ".lua"))
  local words = {}
  for line in file:lines() do
    local text = line:match "^%-%- (.*)"
    if not text then break end
    words[#words + 1] = text
  end
  local text = table.concat(words, " ")
  return (text:match "^(.-)%. " or text:gsub("%.$", ""))
end

-- Force per width, N/m, at a stretch of 1 %.
local function pull(card, angle)
  local e = 0.01
  return fabric.point(card):uniaxial(angle, { e + e * e / 2 }, { "S" }).S[1] * (1 + e) * card.thickness
end

-- Initial shear stiffness, N/m: shear force per width over the shear angle, half of dS12/dE12 times the thickness.
local function shear_stiffness(card)
  local loading = card.shear.loading
  local D = type(loading[1]) == "table" and loading[2][2] / loading[2][1] or loading[1]
  return (card.shear.measure == "tensor" and D / 2 or D) * card.thickness
end

local function bending_length(B, mass) return (B / (mass * gravity)) ^ (1 / 3) end

local function short(x) return ("%.3g"):format(x):gsub("e%+0*", "e") end

-- Fields by name; a part whose every number is among them by its own name alone.
local function listed(fields)
  local text = table.concat(fields, ", ") .. ","
  for _, yarn in ipairs { "warp", "weft" } do
    text = text:gsub(("%s.loading, %s.poisson, %s.unloading,"):format(yarn, yarn, yarn), yarn .. ",")
  end
  return (text:gsub("shear.loading, shear.unloading,", "shear,"):gsub(",$", ""))
end

-- What is assumed: the fields of one rule stand together.
local function assumed(card)
  local rules, of = {}, {}
  local fields = {}
  for field in pairs(card.provenance or {}) do fields[#fields + 1] = field end
  table.sort(fields)
  for _, field in ipairs(fields) do
    local rule = card.provenance[field]:match "assumed:? (.*)"
    if rule then
      if not of[rule] then rules[#rules + 1], of[rule] = rule, {} end
      table.insert(of[rule], field)
    end
  end
  local out = {}
  for i, rule in ipairs(rules) do out[i] = ("- %s: %s"):format(listed(of[rule]), rule) end
  return out
end

-- The parts of a cloth that a card has from measurements.
local function measured(card)
  if not card.provenance or not card.provenance["warp.loading"] then return "warp, weft, shear" end
  local out = {}
  for _, part in ipairs { "warp", "weft", "shear" } do
    local words = card.provenance[part .. ".loading"]
    if not words or words:find "^measured" or words:find "^fitted" then out[#out + 1] = part end
  end
  if card.provenance.bending and card.provenance.bending:find "^measured" then out[#out + 1] = "bending" end
  return table.concat(out, ", ")
end

local function page()
  local lines = { [[
# The cards

These cards come with the program and are used by name, `fabric.card "worsted"`. (This page is generated from the cards by `scripts/cards.lua`, and a test compares
the two.) W is the areal mass, t the thickness, and B the bending rigidity along warp and weft; a card without B bends like
a solid of its thickness, which is far too stiff for cloth. 2c is the overhang of a strip at 41.5 degrees (ASTM D1388), with the bending length c, the cube root
of B/(W g). Friction in bending, which `broad` and `tropical` have according to KES 2HB, reduces this angle to 14 and 31 degrees. G is the initial shear force per width divided by the shear angle. The last columns are the force per width at a stretch of 1 %.

**Choosing a card.** Take a cloth of similar use and mass whose *measured* properties determine your result: bending and mass for hanging and draping
(all but the four cards of the thesis), warp and weft for tension and membranes, shear for bias tests and forming. The assumptions of each card are listed below, and
`card:with{...}` replaces a property by your own value. All cards unload along straight lines;
`card:with{ warp={ loop={ friction=0.3, reach=0.5, curve=0.5 } } }` makes unloading curved ([law.md](law.md)). How they break was not measured on any of them:
none has `rupture` ([tearing.md](tearing.md)).

```lua
local fabric = require "fabric"
local card = fabric.card "worsted"
print(card)                              -- each number and where it comes from
print(card:check())                      -- what it can and cannot do
local mine = card:with { bending = { warp = 7e-6, weft = 6e-6, twist = 3e-6 } }
assert(mine.bending.warp == 7e-6)
```

| card | cloth | measured | W g/m2 | t mm | B warp, weft uN.m | 2c warp, weft mm | G N/m | pull at 1 % warp, weft N/m |
|---|---|---|---|---|---|---|---|---|]] }
  local function add(text) lines[#lines + 1] = text end
  for _, name in ipairs(fabric.cards()) do
    local card = fabric.card(name)
    local mass, b = card.density * card.thickness, card.bending
    add(("| %s | %s | %s | %.4g | %.3g | %s | %s | %s | %s, %s |"):format(name, heading(name), measured(card), 1e3 * mass, 1e3 * card.thickness,
      b and short(1e6 * b.warp) .. ", " .. short(1e6 * b.weft) or "as of the thickness",
      b and ("%.0f, %.0f"):format(2e3 * bending_length(b.warp, mass), 2e3 * bending_length(b.weft, mass)) or "",
      short(shear_stiffness(card)), short(pull(card, 0)), short(pull(card, 90))))
  end
  add "\n## Sources and assumptions"
  local first = {} -- card of a list of assumptions
  for _, name in ipairs(fabric.cards()) do
    local card = fabric.card(name)
    local rules = assumed(card)
    local all = table.concat(rules, "\n")
    local as = first[all] and (" Assumed: as for `%s`."):format(first[all]) or ""
    add(("\n**%s.** %s.%s"):format(name, (card.source:gsub("%.$", "")), as))
    if #rules > 0 and not first[all] then
      first[all] = name
      add "Assumed:\n"
      for _, rule in ipairs(rules) do add(rule) end
    end
  end
  add [[

## Missing cards
There is no card with a complete KES sheet of one cloth, because the available publications contain either bending or tension, but not all properties with their loops. The
measured cloths of Wang, Ramamoorthi and O'Brien (2011) are licensed for scholarly use only and are not included. The bending rigidities of `wool`,
`nylon`, `glass`, `tarpaulin` and `aramid` follow from a rule, and warp, weft and shear of `broad`, `tropical` and the cards `cloth...` are those of
`worsted`; the latter are cards for drape, not for tension.]]
  return table.concat(lines, "\n") .. "\n"
end

-- Paragraphs and items of lists in lines of fewer than 120 characters; code, tables and headings stay.
local function wrapped(text)
  local out, words, hang, code = {}, {}, "", false
  local function flush()
    local line = nil
    for _, word in ipairs(words) do
      if line and #line + 1 + #word > 118 then
        out[#out + 1], line = line, hang .. word
      else
        line = line and line .. " " .. word or word
      end
    end
    out[#out + 1], words = line, {}
  end
  for line in text:gmatch "([^\n]*)\n" do
    local fence = line:find "^```" ~= nil
    local stays = code or fence or line == "" or line:find "^[|#]" ~= nil
    if fence then code = not code end
    if #words > 0 and (stays or line:find "^%- ") then flush() end
    if stays then
      out[#out + 1] = line
    else
      if #words == 0 then hang = line:find "^%- " and "  " or "" end
      for word in line:gmatch "%S+" do words[#words + 1] = word end
    end
  end
  if #words > 0 then flush() end
  return table.concat(out, "\n") .. "\n"
end

local path, text = "share/doc/cards.md", wrapped(page())
if arg[1] == "write" then
  local file <close> = assert(io.open(root .. path, "w"))
  file:write(text)
end
local file = io.open(root .. path)
local same = file and file:read "a" == text
if file then file:close() end
if not same then print("not up to date: " .. path .. "; run fabricsh scripts/cards.lua write") end
fabric.expect { { "pages that are not up to date", same and 0 or 1, 0, absolute = 0 } }
