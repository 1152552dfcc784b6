-- The file of a finished case of a study: plain lines, read without executing code.
local fabric = require "fabric"

local case_file = {}

-- FNV-1a, 64 bits: distinguishes texts; not a cryptographic hash.
function case_file.hash(text)
  local h = -3750763034362895579
  for i = 1, #text do h = (h ~ text:byte(i)) * 1099511628211 end
  return ("%016x"):format(h)
end

-- The shortest text that reads back as the same number.
local function number_text(x)
  if math.type(x) == "integer" then return ("%d"):format(x) end
  if x ~= x then return "nan" end
  if x == math.huge or x == -math.huge then return x > 0 and "inf" or "-inf" end
  for digits = 15, 17 do
    local text = ("%." .. digits .. "g"):format(x)
    if tonumber(text) == x then return text:find "[.e]" and text or text .. ".0" end
  end
end

local escapes = { ["\\"] = "\\\\", ["\n"] = "\\n", ["\r"] = "\\r", ["\t"] = "\\t" }
local plain = { ["\\\\"] = "\\", ["\\n"] = "\n", ["\\r"] = "\r", ["\\t"] = "\t" }

local function line_of(word, name, value)
  local text = type(value) == "number" and number_text(value) or tostring(value)
  return table.concat({ word, (name:gsub("[\\\n\r\t]", escapes)), type(value), (text:gsub("[\\\n\r\t]", escapes)) }, "\t")
end

local numbers = { nan = 0 / 0, inf = math.huge, ["-inf"] = -math.huge }

local function value_of(kind, text)
  if kind == "number" then return numbers[text] or tonumber(text) end
  if kind == "boolean" then return text == "true" end
  return (text:gsub("\\[\\nrt]", plain))
end

local function lines_of(word, values)
  local lines = {}
  for name, value in pairs(values) do lines[#lines + 1] = line_of(word, name, value) end
  table.sort(lines)
  return table.concat(lines, "\n")
end

function case_file.key(parameters) return lines_of("parameter", parameters) end

-- "a = 1, b = 2" for messages.
function case_file.words(parameters)
  local words = {}
  for name, value in pairs(parameters) do words[#words + 1] = name .. " = " .. (type(value) == "number" and number_text(value) or tostring(value)) end
  table.sort(words)
  return table.concat(words, ", ")
end

local function path_of(folder, parameters) return folder .. "/case-" .. case_file.hash(case_file.key(parameters)) .. ".txt" end

local function unescaped(text) return (text:gsub("\\[\\nrt]", plain)) end

-- A warning as the value of a line: time, element (0: none), seriousness and text, tabs between them.
local function packed(w) return table.concat({ number_text(w.time), ("%d"):format(w.element or 0), tostring(w.serious), w.text }, "\t") end
local function unpacked(code, value)
  local time, element, serious, text = value:match "^([^\t]*)\t(%d+)\t(%a+)\t(.*)$"
  if not time then return nil end
  element = math.tointeger(tonumber(element))
  return { code = code, text = text, time = numbers[time] or tonumber(time), element = element ~= 0 and element or nil, serious = serious == "true" }
end

-- Stores either values or trouble, and warnings.
function case_file.save(folder, parameters, values, trouble, warnings)
  local lines = { "fabricsh case 1", case_file.key(parameters) }
  if trouble then lines[#lines + 1] = line_of("trouble", "", trouble) end
  if values and next(values) ~= nil then lines[#lines + 1] = lines_of("value", values) end
  for _, w in ipairs(warnings or {}) do lines[#lines + 1] = line_of("warning", w.code, packed(w)) end
  lines[#lines + 1] = "end\n"
  fabric.write(path_of(folder, parameters), table.concat(lines, "\n"))
end

-- Returns {values, warnings} or {trouble, warnings}; nil if the file does not exist, or has other parameters.
function case_file.load(folder, parameters)
  local f = io.open(path_of(folder, parameters))
  if not f then return nil end
  local text = f:read "a"
  f:close()
  local body = text:match "^fabricsh case 1\n(.*)\nend\n$"
  if not body then return nil end
  local case, own = { values = {}, warnings = {} }, {}
  for line in body:gmatch "[^\n]+" do
    local word, name, kind, value = line:match "^(%a+)\t([^\t]*)\t(%a+)\t(.*)$"
    if word == "parameter" then own[#own + 1] = line end
    if word == "trouble" then case.trouble = value_of("string", value) end
    if word == "value" then case.values[unescaped(name)] = value_of(kind, value) end
    if word == "warning" then case.warnings[#case.warnings + 1] = unpacked(unescaped(name), unescaped(value)) end
  end
  if table.concat(own, "\n") ~= case_file.key(parameters) then return nil end
  if case.trouble then case.values = nil end
  return case
end

-- A cell of a CSV table (RFC 4180).
function case_file.cell(value)
  if value == nil then return "" end
  local text = type(value) == "number" and number_text(value) or tostring(value)
  if text:find '[,"\r\n]' then text = '"' .. text:gsub('"', '""') .. '"' end
  return text
end

return case_file
