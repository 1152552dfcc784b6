-- fabric.help: information on functions and topics, from the rows of the registry.
local define = require "fabric.define"
local lists = require "fabric.lists"
local registry = define.registry

local width = 100

-- Rooms of the overview, in the order of typical use: a title, and patterns of names.
local rooms = {
  { "cloth", "^fabric%.woven$", "^fabric%.svk$", "^fabric%.linear$", "^fabric%.cards?$", "^card[:.]" },
  { "one point of cloth", "^fabric%.point$", "^point[:.]" },
  { "meshes", "^fabric%.mesh%.", "^mesh[:.]" },
  { "rigid bodies that cloth touches", "^fabric%.rigid%." },
  { "models", "^fabric%.model$", "^model[:.]", "^fabric%.history$", "^fabric%.ramp$", "^history[:.]" },
  { "runs", "^fabric%.static$", "^fabric%.dynamic$", "^analysis[:.]" },
  { "virtual tests", "^fabric%.lab%.uniaxial$", "^fabric%.lab%.bias", "^fabric%.lab%.shear$", "^fabric%.lab%.biaxial$",
    "^fabric%.lab%.drape$", "^fabric%.lab%.poke$", "^fabric%.lab%.mesh_error$", "^fabric%.lab%.ball_drop$", "^fabric%.lab%.capstan$", "^fabric%.lab%.cusick$",
    "^fabric%.lab%.cantilever$", "^fabric%.lab%.heart_loop$" },
  { "laboratory: from measurement to card", "^fabric%.lab%." },
  { "pictures, tables and files", "^fabric%.plot$", "^fabric%.render$", "^fabric%.table$", "^fabric%.folder$", "^fabric%.columns$", "^fabric%.show$", "^fabric%.write$" },
  { "to and from other programs", "^fabric%.export%.", "^fabric%.import%." },
  { "the rest", "" },
}

local function room_of(name)
  for place, room in ipairs(rooms) do
    for i = 2, #room do
      if name:find(room[i]) then return place end
    end
  end
end

-- Text wrapped at blanks, each line after `indent`.
local function wrapped(text, indent)
  local lines, line = {}, indent
  for word in text:gmatch "%S+" do
    if #line + #word + 1 > width and line ~= indent then
      lines[#lines + 1], line = line, indent
    end
    line = line .. (line == indent and "" or " ") .. word
  end
  lines[#lines + 1] = line
  return table.concat(lines, "\n")
end

local function first_sentence(text)
  local first = text:match "^(.-%l%l%l%)?)%. %u" or text:match "^(.-[%d%)%]])%. %u" or text:gsub("%.$", "")
  return #first > 110 and first:sub(1, 107) .. "..." or first
end

-- The form of a call: fabric.static{ model, duration, [step], ... }
local function signature(row)
  local names = lists.map(row.arguments, function(argument) return argument.required and argument.name or "[" .. argument.name .. "]" end)
  if row.style == "property" then return row.name end
  if row.style == "fields" then return row.name .. "{ " .. table.concat(names, ", ") .. " }" end
  return row.name .. "(" .. table.concat(names, ", ") .. ")"
end

local function argument_lines(arguments, indent, lines)
  for _, argument in ipairs(arguments) do
    local note = argument.default and "default " .. argument.default or not argument.required and "optional" or "required"
    lines[#lines + 1] = ("%s%s: %s; %s"):format(indent, argument.name, argument.expected, note)
    lines[#lines + 1] = wrapped(argument.sentence, indent .. "    ")
    if #argument.rows > 0 then argument_lines(argument.rows, indent .. "    " .. "  ", lines) end
  end
end

local function about_row(row)
  local lines = { wrapped(signature(row), ""), wrapped(row.sentence, "  ") }
  if #row.arguments > 0 then lines[#lines + 1] = "" end
  argument_lines(row.arguments, "  ", lines)
  lines[#lines + 1] = "\n  example"
  lines[#lines + 1] = "    " .. row.example:gsub("\n$", ""):gsub("\n", "\n    ")
  return lines
end

local function list(rows, lines)
  for _, row in ipairs(rows) do
    lines[#lines + 1] = ("  %-28s %s"):format(row.name, first_sentence(row.sentence))
  end
end

-- Groups the rows under the titles of their rooms.
local function grouped(rows, lines)
  local by_room = {}
  for _, row in ipairs(rows) do
    local place = room_of(row.name)
    by_room[place] = by_room[place] or {}
    table.insert(by_room[place], row)
  end
  for place, room in ipairs(rooms) do
    if by_room[place] then
      lines[#lines + 1] = room[1]
      list(by_room[place], lines)
    end
  end
end

local function overview()
  local lines = { "fabricsh: the mechanics of woven cloth. Lengths in m, forces in N, moduli in Pa; 25.4*mm, 8*MPa.", "" }
  local by_room = {}
  for _, row in ipairs(registry.rows()) do
    local place = room_of(row.name)
    if row.owner == "" then
      by_room[place] = by_room[place] or {}
      table.insert(by_room[place], (row.name:gsub("^fabric%.", "")))
    end
  end
  for place, room in ipairs(rooms) do
    if by_room[place] then
      lines[#lines + 1] = room[1]
      lines[#lines + 1] = wrapped(table.concat(by_room[place], "  "), "    ")
    end
  end
  for _, line in ipairs {
    "",
    "help(fabric.static)     what a function takes, with an example",
    "help(mesh)              what an object is, holds and can do",
    "help \"mesh:set\"         a method by its name",
    "help \"shear\"            all entries with a word that begins so",
    "The tutorial is share/doc/tutorial.md, all functions are in share/doc/reference.md.",
  } do lines[#lines + 1] = line end
  return lines
end

-- Lists the fields of a card, which are those of its constructor.
local function card_fields(card, lines)
  lines[#lines + 1] = "fields (in SI; card:with{...} makes a copy with others)"
  for _, row in ipairs(registry.rows()) do
    if row.name == "fabric." .. card.kind then
      for _, argument in ipairs(row.arguments) do
        local value = card[argument.name]
        if value ~= nil then
          lines[#lines + 1] = ("  %-28s %s"):format(argument.name, argument.sentence)
          lines[#lines + 1] = "      = " .. registry.show(value)
        end
      end
    end
  end
end

-- Describes an object: its printed form, its properties with their values, its methods.
local function about_object(object, class)
  local lines, properties, methods = { tostring(object) }, {}, {}
  for _, row in ipairs(registry.rows()) do
    if row.owner == class then table.insert(row.style == "property" and properties or methods, row) end
  end
  if class == "card" then card_fields(object, lines) end
  if #properties > 0 then lines[#lines + 1] = "properties" end
  for _, row in ipairs(properties) do
    local known, value = pcall(function() return object[row.name:match "%.([%w_]+)$"] end)
    lines[#lines + 1] = ("  %-28s %s"):format(row.name, first_sentence(row.sentence))
    if known then lines[#lines + 1] = "      = " .. registry.show(value):gsub("\n", "\n        ") end
  end
  if #methods > 0 then lines[#lines + 1] = "methods" end
  list(methods, lines)
  return lines
end

local function named(rows, word)
  for _, name in ipairs { word, "fabric." .. word } do
    for _, row in ipairs(rows) do
      if row.name == name then return row end
    end
  end
end

-- The rows of a class ("mesh") or of a table of functions ("fabric.lab").
local function below(rows, word)
  local found, stem = {}, word:gsub("^fabric%.", "")
  for _, row in ipairs(rows) do
    if row.owner == word or row.name:sub(1, #stem + 8) == "fabric." .. stem .. "." then found[#found + 1] = row end
  end
  return found
end

-- Whether a text contains the word where one of its words begins, or anywhere.
local function holds(text, word, anywhere)
  local place = text:lower():find(word, 1, true)
  while place and place > 1 and not anywhere and word:find "^%w" and text:find("^%w", place - 1) do place = text:lower():find(word, place + 1, true) end
  return place ~= nil
end

local function speaks_of(row, word, anywhere)
  local function any(arguments)
    for _, argument in ipairs(arguments) do
      if holds(argument.name, word, anywhere) or holds(argument.sentence, word, anywhere) or any(argument.rows) then return true end
    end
  end
  return holds(row.name, word, anywhere) or holds(row.sentence, word, anywhere) or any(row.arguments)
end

local function nothing(rows, word)
  local names = {}
  for _, row in ipairs(rows) do
    names[#names + 1] = row.name
    names[#names + 1] = row.name:match "^fabric%.(.+)$"
    names[#names + 1] = row.name:match "[^.:]+$"
  end
  local near = registry.nearest(word, names)
  return { ("no entry contains '%s'%s"):format(word, near and ", did you mean '" .. near .. "'?" or "; help() shows what there is") }
end

-- The pages of the manual whose name or description in the list of pages holds each of the words.
local function pages(words, anywhere)
  local home = debug and debug.getinfo(1, "S").source:match "^@(.*)lua/fabric/help%.lua$"
  local readable, file = pcall(io.open, (home or "") .. "share/doc/README.md")
  local lines = {}
  if not home or not readable or not file then return lines end
  for line in file:lines() do
    local name, about = line:match "^| %[[^%]]*%]%(([^)]+)%) | (.-) |$"
    local all = name ~= nil
    for word in words:gmatch "%S+" do all = all and holds(name .. " " .. about, word, anywhere) end
    if all then lines[#lines + 1] = ("  %-38s %s"):format("share/doc/" .. name, about) end
  end
  file:close()
  if #lines > 0 then table.insert(lines, 1, "pages of the manual") end
  return lines
end

-- Fields of a run with this name (a blank or a stroke between its words), or with a single value of this name.
local function result_fields(words)
  local lines, word = {}, words:gsub("%s+", "_")
  for _, field in ipairs(registry.fields()) do
    local numbers = table.concat(field.components, " ")
    if field.name == word or (" " .. numbers .. " "):find(" " .. word .. " ", 1, true) then
      lines[#lines + 1] = ("%s: a field of a run, %s of every %s%s%s"):format(field.name, field.shape, field.place, field.unit ~= "" and ", " .. field.unit or "",
        field.shape ~= "number" and numbers ~= "" and ": " .. numbers or "")
      lines[#lines + 1] = "  " .. field.sentence
    end
  end
  return lines
end

-- A unit of fabric.units by its name, or all of them.
local function units(word)
  local known = require("fabric").units
  if type(known[word]) == "number" then return { ("%s: a unit, %.10g in SI; fabric.units.%s"):format(word, known[word], word) } end
  if word ~= "unit" and word ~= "units" then return {} end
  local names = {}
  for name, size in pairs(known) do
    if type(name) == "string" and type(size) == "number" then names[#names + 1] = name end
  end
  table.sort(names)
  return { "fabric.units: " .. table.concat(names, " "), "  Numbers to multiply by: 25.4*mm is a length in m." }
end

-- Rows that contain the words as a phrase, or otherwise each of the words.
local function speaking(rows, words, anywhere)
  local found = lists.collect(rows, function(row) if speaks_of(row, words, anywhere) then return row end end)
  if #found > 0 or not words:find "%s" then return found end
  for _, row in ipairs(rows) do
    local all = true
    for word in words:gmatch "%S+" do all = all and speaks_of(row, word, anywhere) end
    if all then found[#found + 1] = row end
  end
  return found
end

-- Further meanings of words that are asked for.
local elsewhere = {
  [{ "movie", "video", "mp4", "gif", "ffmpeg", "animation" }] = "fabric.render draws a frame, ffmpeg joins frames: share/doc/howto/plot.md; fabric.export.gltf writes a series that moves in a browser",
  [{ "wind", "blow", "inflate", "air" }] = "model:pressure acts along the normal of the sheet as it moves, model:gas fills a closed volume; the flow of air around cloth is not computed",
  [{ "sew", "seam", "stitch", "glue" }] = "model:tie makes nodes move together; fabric.mesh.merge makes one mesh of several, joined where their nodes coincide",
  [{ "cut", "tear", "rip", "slit" }] = "cloth does not tear in a run; fabric.mesh.annulus has a slit, fabric.mesh{ nodes=, elements= } makes any cut sheet",
}

local function pointed(word)
  for words, where in pairs(elsewhere) do
    for _, other in ipairs(words) do
      if other == word then return { word .. ": " .. wrapped(where, "  "):sub(3) } end
    end
  end
  return {}
end

local function search(word)
  local rows = registry.rows()
  local row = named(rows, word)
  if row then return about_row(row) end
  local lines, found = {}, below(rows, word)
  if #found == 0 then found = speaking(rows, word:lower()) end
  local fields, manual = result_fields(word), pages(word:lower())
  if #found + #manual == 0 then found, manual = speaking(rows, word:lower(), true), pages(word:lower(), true) end
  for _, more in ipairs { pointed(word:lower()), units(word), fields } do table.move(more, 1, #more, #lines + 1, lines) end
  if #found == 0 and #lines == 0 and #manual == 0 then return nothing(rows, word) end
  grouped(found, lines)
  table.move(manual, 1, #manual, #lines + 1, lines)
  return lines
end

-- The name of a table of functions such as fabric.lab.
local function module_named(topic)
  local fabric = require "fabric"
  if topic == fabric then return "fabric" end
  for name, value in pairs(fabric) do
    if rawequal(value, topic) then return name end
  end
end

local function about(topic)
  if topic == nil then return overview() end
  if type(topic) == "string" then return search(topic) end
  local name = registry.name_of(topic)
  if name then return search(name) end
  local class = registry.class_of(topic)
  if class then return about_object(topic, class) end
  local module = module_named(topic)
  if module == "fabric" then return overview() end
  if module and #below(registry.rows(), module) > 0 then return search(module) end
  local curve = type(topic) == "table" and require("fabric.columns").about(topic)
  if curve then return curve end
  return { registry.show(topic), "this is a plain " .. type(topic) .. " of Lua" }
end

define {
  name = "fabric.help",
  positional = true,
  arguments = { { name = "topic", kind = "any", optional = true, sentence = "a function, an object, a name, or words to look for; nothing: an overview" } },
  sentence = "Prints the arguments of a function, the contents and methods of an object, or all entries and pages that contain the given words.",
  example = "fabric.help(fabric.ramp)\nfabric.help 'shear'",
  run = function(...)
    local missing = select("#", ...) > 0 and (...) == nil
    print(missing and "nil: nothing has that name, or nothing yet; help() shows what there is" or table.concat(about(...), "\n"))
  end,
}
