-- Loaded before a deck (fabricsh -l watch deck.lua): keeps what the deck asks fabric.plot for in the file that
-- FABRICSH_TEST_FIGURES names, a line of Lua each, so that run.lua can hold the figures against it.
local fabric = require "fabric"
local plot, kept = fabric.plot, os.getenv "FABRICSH_TEST_FIGURES"

local function axis(label, unit)
  if not unit or unit == "" then return label end
  return (label or "") == "" and unit or label .. ", " .. unit
end

-- Fields that a panel does not give are taken from the call; a table of rows labels the axes with its fields' names.
local function words_of(fields)
  local words = {}
  local function add(word)
    if word and word:find "%S" then words[#words + 1] = ("%q"):format(word) end
  end
  local panels = fields.panels or { fields }
  for place, panel in ipairs(panels) do
    local function of(name)
      if panel[name] ~= nil then return panel[name] end
      return fields[name]
    end
    local title = of "title" or ""
    if #panels > 1 and fields.letters ~= false then title = ("(%s) %s"):format(("abcdefghijklmnopqrstuvwxyz"):sub(place, place), title) end
    add(title)
    add(axis(of "xlabel" or panel.rows and panel.x, of "xunit"))
    add(axis(of "ylabel" or panel.rows and type(panel.y) == "string" and panel.y or nil, of "yunit"))
    for _, curve in ipairs(of "key" ~= "none" and panel.curves or {}) do add(curve.label) end
    for _, name in ipairs(of "key" ~= "none" and panel.rows and type(panel.y) == "table" and panel.y or {}) do add(name) end
  end
  return table.concat(words, ", ")
end

local function curves_of(fields)
  local count = 0
  for _, panel in ipairs(fields.panels or { fields }) do
    count = count + (panel.curves and #panel.curves or type(panel.y) == "table" and #panel.y or 1)
  end
  return count
end

-- A figure counts as asked for before it is drawn: one whose drawing fails is missed, whatever the deck does about it.
function fabric.plot(fields, x, y, more)
  if x ~= nil then
    local named = { rows = fields, x = x, y = y }
    for name, value in pairs(more or {}) do named[name] = value end
    fields = named
  end
  if fields.file then
    local file = assert(io.open(kept, "a"))
    file:write(("figure{ file = %q, curves = %d, words = { %s } }\n"):format(fields.file, curves_of(fields), words_of(fields)))
    file:close()
  end
  return plot(fields)
end
