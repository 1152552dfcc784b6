-- The table of what a card of the thesis loses on export, in share/doc/exchange.md.
--
--   fabricsh scripts/losses.lua          computes it anew and compares: an error where the page says another number
--   fabricsh scripts/losses.lua write    writes it into the page
local fabric = require "fabric"
if fabric.checking() then return end
local page = arg[0]:gsub("[^/]*$", "") .. "../share/doc/exchange.md"
local materials = { { "ls-dyna", "MAT_034" }, { "ls-dyna", "MAT_235" },
  { "openradioss", "LAW58" }, { "openradioss", "LAW158" }, { "openradioss", "LAW19" }, { "abaqus", "FABRIC" } }
local paths = { "warp", "weft", "biaxial", "bias", "cyclic warp", "cyclic weft", "cyclic shear" }

local table_lines = { "| card | material | " .. table.concat(paths, " | ") .. " |", "|---|---|" .. ("---|"):rep(#paths) }
for _, name in ipairs { "blend" } do
  for _, m in ipairs(materials) do
    local lost = fabric.export.card({ card = fabric.card(name), to = m[1], material = m[2] }).lost
    local cells = { name, m[2] }
    for _, path in ipairs(paths) do cells[#cells + 1] = ("%.1f / %+.0f"):format(lost[path].worst, lost[path].work) end
    table_lines[#table_lines + 1] = "| " .. table.concat(cells, " | ") .. " |"
  end
end

local file = assert(io.open(page))
local text = file:read "a"
file:close()
local before, between, after = text:match "^(.-%[losses begin%]: #\n\n)(.-)(%[losses end%]: #\n.*)$"
assert(before, "the page has no place for the table")
local made = table.concat(table_lines, "\n") .. "\n\n"
if arg[1] == "write" then
  fabric.write(page, before .. made .. after)
  return print("written: " .. page)
end

-- The words are the same, and the numbers but for their last digit.
local function numbers(t)
  local out = {}
  for n in t:gmatch "[ ]([+-]?%d+%.?%d*)" do out[#out + 1] = tonumber(n) end
  return out
end
local function words(t) return (t:gsub(" [+-]?%d+%.?%d*", "#")) end
local a, b = numbers(made), numbers(between)
assert(#a == #b and words(made) == words(between), "the page's table is another one: fabricsh scripts/losses.lua write")
local worst = 0 -- as a share of what rounding leaves open
for i = 1, #a do worst = math.max(worst, math.abs(a[i] - b[i]) / (1 + 0.01 * math.abs(a[i]))) end
fabric.expect { { "largest difference from share/doc/exchange.md", worst, 0, absolute = 1 }, { "numbers in its table", #b, 6 * 14, absolute = 0 } }
