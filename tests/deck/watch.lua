-- Loaded before a deck (fabricsh -l watch deck.lua): keeps what the deck asks fabric.plot for in the file that
-- FABRICSH_TEST_FIGURES names, a line of Lua each, so that run.lua can hold the figures against it.
local fabric = require "fabric"
local plot, kept = fabric.plot, os.getenv "FABRICSH_TEST_FIGURES"

local function axis(label, unit)
  if not unit or unit == "" then return label end
  return (label or "") == "" and unit or label .. ", " .. unit
end

local function words_of(fields)
  local words = {}
  local function add(word)
    if word and word:find "%S" then words[#words + 1] = ("%q"):format(word) end
  end
  add(fields.title)
  add(axis(fields.xlabel, fields.xunit))
  add(axis(fields.ylabel, fields.yunit))
  for _, curve in ipairs(fields.curves) do add(curve.label) end
  return table.concat(words, ", ")
end

-- A figure counts as asked for before it is drawn: one whose drawing fails is missed, whatever the deck does about it.
function fabric.plot(fields)
  if fields.file then
    local file = assert(io.open(kept, "a"))
    file:write(("figure{ file = %q, curves = %d, words = { %s } }\n"):format(fields.file, #fields.curves, words_of(fields)))
    file:close()
  end
  return plot(fields)
end
