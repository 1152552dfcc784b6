-- Reads an SVG as strictly as a viewer does: it is XML 1.0 that is well formed, or an error says where it is not.
local svg = {}

local entities = { amp = "&", lt = "<", gt = ">", quot = '"', apos = "'" }

local function fail(at, words) error(("at byte %d: %s"):format(at, words), 0) end

-- The characters that a text or the value of an attribute stands for.
local function plain(text, at)
  if text:find("]]>", 1, true) then fail(at, "']]>' in a text") end
  if text:gsub("&[%w#]+;", ""):find("&", 1, true) then fail(at, "a bare '&'") end
  return (text:gsub("&([%w#]+);", function(name)
    local hex, decimal = name:match "^#x(%x+)$", name:match "^#(%d+)$"
    local code = hex and tonumber(hex, 16) or tonumber(decimal)
    return code and utf8.char(code) or entities[name] or fail(at, "unknown entity '&" .. name .. ";'")
  end))
end

local function attributes(text, at)
  local found, rest = {}, text
  while rest:find "%S" do
    local name, quote, after = rest:match "^%s+([%a_:][%w_:.%-]*)%s*=%s*([\"'])(.*)$"
    if not name then fail(at, "expected name=\"value\", got '" .. rest:sub(1, 40) .. "'") end
    local value, left = after:match("^([^<" .. quote .. "]*)" .. quote .. "(.*)$")
    if not value then fail(at, "the value of '" .. name .. "' does not end") end
    if found[name] then fail(at, "attribute '" .. name .. "' twice") end
    found[name], rest = plain(value, at), left
  end
  return found
end

-- Where the markup that begins at `at` ends, if it is a comment, a CDATA section, a declaration or an instruction.
local function skipped(content, at)
  for first, last in pairs { ["<!--"] = "-->", ["<![CDATA["] = "]]>", ["<!DOCTYPE"] = ">", ["<?"] = "?>" } do
    if content:sub(at, at + #first - 1) == first then
      local _, close = content:find(last, at, true)
      return close or fail(at, "'" .. first .. "' does not end")
    end
  end
end

-- The texts of the elements <text>, in order, and how many curves gnuplot drew.
function svg.read(content)
  local good, place = utf8.len(content)
  if not good then fail(place, "not UTF-8") end
  local control = content:find "[%z\1-\8\11\12\14-\31]"
  if control then fail(control, "a control character") end
  local open, texts, curves, at, roots = {}, {}, 0, 1, 0
  while true do
    local tag = content:find("<", at, true)
    local text = content:sub(at, (tag or #content + 1) - 1)
    if #open == 0 and text:find "%S" then fail(at, "text outside of the root") end
    if open.text then open.text = open.text .. plain(text, at) end
    if not tag then break end
    local close = skipped(content, tag)
    if not close then
      close = content:find(">", tag, true) or fail(tag, "a tag does not end")
      local slash, name, rest, empty = content:sub(tag, close):match "^<(/?)([%a_:][%w_:.%-]*)(.-)(/?)>$"
      if not name then fail(tag, "'" .. content:sub(tag, tag + 20) .. "' is no tag") end
      if slash == "/" then
        if table.remove(open) ~= name then fail(tag, "'</" .. name .. ">' closes what is not open") end
        if name == "text" then texts[#texts + 1], open.text = open.text:match "^%s*(.-)%s*$", nil end
      else
        local id = attributes(rest, tag).id
        if id and id:find "^gnuplot_plot_%d+$" then curves = curves + 1 end
        if #open == 0 then roots = roots + 1 end
        if empty == "" then open[#open + 1] = name end
        if name == "text" and empty == "" then open.text = "" end
      end
    end
    at = close + 1
  end
  if #open > 0 then fail(#content, "'<" .. open[#open] .. ">' is not closed") end
  if roots ~= 1 then fail(1, "expected one root, got " .. roots) end
  return texts, curves
end

-- The first of the words that is not one of the figure's texts, or nil.
function svg.missing(texts, words)
  local there = {}
  for _, text in ipairs(texts) do there[text] = true end
  for _, word in ipairs(words) do
    if not there[word:gsub("%c", " "):match "^%s*(.-)%s*$"] then return word end
  end
end

return svg
