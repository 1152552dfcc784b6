-- The reference page and the stubs for editors, from the registry that checks the arguments.
--
--   fabricsh scripts/reference.lua          compares both with what they should be; an error when they are not up to date
--   fabricsh scripts/reference.lua write    writes share/doc/reference.md and share/lua-ls/fabric.lua
--
-- It runs every example, to show what comes out; some of them are coarse, and the runs say so.
-- warns: nine measured cloths in ten
-- warns: the card was tested to
-- warns: the end of the run, the ball is still in the cloth
-- warns: inertia is part of the forces
-- warns: tear: damping takes
local fabric = require "fabric"
local registry = require "fabric.define".registry
local rows = registry.rows()
local root = arg[0]:gsub("[^/]*$", "") .. "../"

-- Returned types, where they are objects or plain; anything else is `any`.
local returns = {
  ["fabric.card"] = "card", ["fabric.woven"] = "card", ["fabric.svk"] = "card", ["fabric.linear"] = "card", ["fabric.cards"] = "string[]",
  ["card:with"] = "card", ["card:sample"] = "card[]", ["card:write"] = "nil", ["fabric.lab.card"] = "card", ["fabric.lab.kes_card"] = "card", ["fabric.lab.tension_field"] = "card",
  ["fabric.lab.fast_card"] = "card", ["fabric.point"] = "point", ["point:reset"] = "nil", ["fabric.model"] = "model", ["fabric.poly"] = "number[]",
  ["fabric.history"] = "history", ["fabric.ramp"] = "history", ["history:value"] = "number", ["fabric.static"] = "analysis",
  ["fabric.dynamic"] = "analysis", ["fabric.checking"] = "boolean", ["fabric.warn"] = "nil", ["fabric.globals"] = "nil",
  ["fabric.expect"] = "nil", ["fabric.help"] = "nil", ["fabric.plot"] = "string|boolean|nil", ["fabric.render"] = "boolean", ["fabric.folder"] = "string[]",
  ["analysis:stop"] = "nil", ["model:copy"] = "model", ["shape:mesh"] = "mesh", ["shape:vtk"] = "shape", ["analysis:snapshot"] = "snapshot", ["analysis:reaction"] = "number x, number y, number z",
  ["analysis:mean"] = "number", ["analysis:field"] = "number[]", ["mesh:elements"] = "integer[]", ["mesh:orient"] = "integer",
  ["analysis:body"] = "number ...", ["analysis:gap"] = "number, string?", ["analysis.time"] = "number", ["analysis.duration"] = "number", ["analysis.stable_step"] = "number", ["analysis.step_size"] = "number",
  ["analysis.energy"] = "table<string, number>", ["analysis.steps"] = "table[]", ["analysis.stopped"] = "string|false",
  ["mesh.nodes"] = "number[][]", ["mesh.elements"] = "integer[][]", ["mesh.sets"] = "string[]", ["model.card"] = "card",
  ["model.thickness"] = "number",
}
for _, name in ipairs { "solve", "advance", "step", "every", "event", "restore", "record", "vtk", "set", "checkpoint", "restart" } do returns["analysis:" .. name] = "analysis" end
for _, row in ipairs(rows) do -- methods of a model chain, generators make meshes
  if row.owner == "model" and row.style ~= "property" then returns[row.name] = "model" end
  if row.name:find "^fabric%.mesh%." then returns[row.name] = "mesh" end
  if row.name:find "^fabric%.rigid%." then returns[row.name] = "body" end
end
for _, name in ipairs { "mesh:map", "mesh:write" } do returns[name] = "mesh" end
-- Tables with named fields, which the sentences name; lists; and what else is plain.
for _, name in ipairs { "analysis:element", "analysis:node", "point:state", "point:strain", "point:uniaxial", "point:biaxial", "point:path", "mesh:check" } do
  returns[name] = "table<string, any>"
end
for _, row in ipairs(rows) do
  if row.name:find "^fabric%.lab%." and not returns[row.name] then returns[row.name] = "table<string, any>" end
end
for _, name in ipairs { "uniaxial", "bias", "shear", "biaxial", "drape", "poke", "ball_drop", "capstan", "bias_extension" } do returns["fabric.lab." .. name] = "test" end
for _, name in ipairs { "parallel", "branches", "synthetic", "backbone", "monotone" } do returns["fabric.lab." .. name] = "table[]" end
for name, what in pairs { ["fabric.lab.unloading"] = "number", ["fabric.lab.photograph"] = "nil", ["fabric.study"] = "table", ["fabric.table"] = "table[]",
  ["fabric.transcript"] = "nil", ["fabric.who"] = "nil", ["fabric.why"] = "string", ["analysis:why"] = "string", ["fabric.write"] = "nil",
  ["card:check"] = "table[]", ["mesh:set"] = "mesh" } do returns[name] = what end

local classes = { "card", "mesh", "model", "history", "analysis", "snapshot", "shape", "point", "body" }
local about_class = {
  card = "The material of a cloth. It cannot be changed; every field of its constructor reads back in SI: `card.warp.poisson`.",
  mesh = "Nodes, elements and named sets of nodes.", model = "A mesh of a cloth with its supports and loads. Its methods return it.",
  history = "A number that depends on time.", analysis = "A run, static or in motion.", snapshot = "The whole state of a run.", shape = "How the nodes of a model move in a mode.",
  point = "One material point.",
  body = "A rigid body, made by `fabric.rigid`.",
}

-- --- what the examples show ---

-- A value as the prompt shows it, at most twelve lines of it.
local function looks(value)
  local lines = {}
  for line in (registry.show(value) .. "\n"):gmatch "(.-)\n" do
    if #lines == 12 then
      lines[13] = "..."
      break
    end
    lines[#lines + 1] = #line > 130 and line:sub(1, 127) .. "..." or line
  end
  return table.concat(lines, "\n")
end

-- The example with the last call of the method, or the last use of the property, told to `told`; nil: there is none that a text can show.
local function method_told(row)
  local name = row.name:match "[:.]([%w_]+)$"
  local forms = row.style == "property" and { "()([%a_][%w_]*%." .. name .. ")()%f[^%w_]" }
    or { "()([%a_][%w_]*:" .. name .. "%b())()", "()([%a_][%w_]*:" .. name .. "%s*%b{})()", "()([%a_][%w_]*:" .. name .. " '[^']*')()" }
  local from, call, to
  for _, form in ipairs(forms) do
    for a, text, b in row.example:gmatch(form) do
      if not from or a > from then from, call, to = a, text, b end
    end
  end
  return from and row.example:sub(1, from - 1) .. "told(" .. call .. ")" .. row.example:sub(to)
end

-- The table that holds a function, and its name there.
local function holder_of(row)
  local holder, name = fabric, row.name
  for word, rest in name:gmatch "([%w_]+)%.(.+)" do
    holder, name = word == "fabric" and fabric or holder[word], rest
  end
  for word in name:gmatch "([%w_]+)%." do holder = holder[word] end
  return holder, name:match "[%w_]+$"
end

-- The last value of the function or method in its example, or the text that it printed; nil where neither says anything, or not the same each time.
local function shown_once(row)
  local printed, value, given = {}, nil, false
  local function told(...)
    if select("#", ...) > 0 then value, given = (...), true end
    return ...
  end
  local environment = setmetatable({ told = told, print = function(...)
    local words = table.pack(...)
    for i = 1, words.n do words[i] = tostring(words[i]) end
    printed[#printed + 1] = table.concat(words, "\t")
  end }, { __index = _G })
  local text, holder, name, real = row.example, nil, nil, nil
  if row.owner ~= "" then
    text = method_told(row)
  else
    holder, name = holder_of(row)
    real = rawget(holder, name)
    if type(real) == "function" then rawset(holder, name, function(...) return told(real(...)) end) end
  end
  local chunk = text and load(text, "=example", "t", environment)
  local done = chunk and pcall(chunk)
  if holder and type(real) == "function" then rawset(holder, name, real) end
  if not done then return end
  if #printed > 0 then return table.concat(printed, "\n") end
  if not given or value == nil or type(value) == "function" then return end
  -- Where all of a list is rounding, its digits are those of one build of the solver.
  return (looks(value):gsub("(<%d+ numbers), %S+e%-1[3-9] to %S+e%-1[3-9]>", "%1, 0 but for rounding>"))
end

-- Places in memory and on the disk differ from run to run; what gnuplot draws in letters, what lies in a folder, and whether there are photographs, from system to system.
local page_now = ""
if arg[1] ~= "write" then
  local file <close> = assert(io.open(root .. "share/doc/reference.md"))
  page_now = file:read "a"
end
local silent = { ["fabric.help"] = true, ["fabric.plot"] = true, ["fabric.folder"] = true, ["fabric.lab.track"] = true, ["fabric.lab.correlate"] = true }
local function shown(row)
  if silent[row.name] or returns[row.name] == "nil" then return end
  local text = shown_once(row)
  if not text or text == "" or text:find "0x%x%x%x" or text:find("/tmp/", 1, true) then return end
  -- A text that the page shows already was the same twice.
  return (page_now:find(text, 1, true) or text == shown_once(row)) and text or nil
end

-- --- the page ---

local function cell(text) return (text:gsub("|", "\\|"):gsub("%s+", " ")) end

local function default_of(argument)
  if argument.default then return "`" .. argument.default .. "`" end
  return argument.required and "required" or "optional"
end

local function table_of(arguments, out, stem)
  for _, argument in ipairs(arguments) do
    out[#out + 1] = ("| `%s%s` | %s | %s | %s |"):format(stem, argument.name, cell(argument.expected), cell(default_of(argument)), cell(argument.sentence))
    table_of(argument.rows, out, stem .. argument.name .. ".")
  end
end

local function signature(row)
  local names = {}
  for i, argument in ipairs(row.arguments) do names[i] = argument.name .. (argument.required and "" or "?") end
  if row.style == "property" then return row.name end
  return row.name .. (row.style == "fields" and "{ %s }" or "(%s)"):format(table.concat(names, ", ")):gsub("{  }", "{}")
end

local function section(row, out)
  out[#out + 1] = "### " .. row.name
  if row.style ~= "property" then out[#out + 1] = "`" .. signature(row) .. "`\n" end
  out[#out + 1] = row.sentence .. "\n"
  if #row.arguments > 0 then
    out[#out + 1] = "| " .. (row.style == "fields" and "field" or "argument") .. " | what it may be | default | meaning |\n|---|---|---|---|"
    table_of(row.arguments, out, "")
    out[#out + 1] = ""
  end
  out[#out + 1] = "```lua\n" .. row.example:gsub("\n$", "") .. "\n```\n"
  local text = not fabric.checking() and shown(row)
  if text then out[#out + 1] = "```text\n" .. text .. "\n```\n" end
end

local function units_table(out)
  local names = {}
  for name in pairs(fabric.units) do names[#names + 1] = name end
  table.sort(names, function(a, b) return a:lower() < b:lower() or a:lower() == b:lower() and a < b end)
  for i, name in ipairs(names) do names[i] = ("`%s` = %.14g"):format(name, fabric.units[name]) end
  out[#out + 1] = "## Units\nEverything is in SI: m, N, Pa, kg, s; angles in degrees, strains are plain numbers. `fabric.units` holds multipliers, "
    .. "so that `25.4*mm` is a length: " .. table.concat(names, ", ") .. ".\n"
end

local function fields_table(out)
  out[#out + 1] = "## Fields of a run\nWhat nodes and elements have at any moment, under the same names in `a:field`, `a:mean`, `a:node`, `a:element`, columns "
    .. "of `a:record`, files of `a:vtk` and pictures of `fabric.render`. A field is asked for whole or by the name of one of its numbers. Those marked "
    .. "with a star are in a file of `a:vtk` that does not choose.\n"
  out[#out + 1] = "| field | numbers | unit | what | of | meaning |\n|---|---|---|---|---|---|"
  for _, field in ipairs(registry.fields()) do
    out[#out + 1] = ("| `%s`%s | %s | %s | %s | %s | %s |"):format(field.name, field.usual and " *" or "", table.concat(field.components, " "), field.unit,
      field.shape, field.place, cell(field.sentence))
  end
  out[#out + 1] = ""
end

local function page()
  local out = {
    "# Reference\n",
    "Every function, method and property, from the rows that the program checks its arguments by; made by "
      .. "`fabricsh scripts/reference.lua write`. `help(fabric.static)` shows the same at the prompt. A function written `f{ a, b? }` takes one "
      .. "table with named fields, one written `f(a, b?)` takes its arguments in order; `?` marks what may be left out. Every example runs as it stands.\n",
  }
  units_table(out)
  fields_table(out)
  local groups = { { "Functions", function(row) return row.owner == "" and not row.name:find "^fabric%.%w+%." end },
                   { "fabric.mesh", function(row) return row.name:find "^fabric%.mesh%." end },
                   { "fabric.rigid", function(row) return row.name:find "^fabric%.rigid%." end },
                   { "fabric.lab", function(row) return row.name:find "^fabric%.lab%." end },
                   { "fabric.export and fabric.import", function(row) return row.name:find "^fabric%.[ei][xm]port%." end } }
  for _, class in ipairs(classes) do
    groups[#groups + 1] = { "Objects: " .. class, function(row) return row.owner == class end, about_class[class] }
  end
  local written = 0
  for _, group in ipairs(groups) do
    out[#out + 1] = "## " .. group[1] .. "\n" .. (group[3] and group[3] .. "\n" or "")
    for _, row in ipairs(rows) do
      if group[2](row) then
        section(row, out)
        written = written + 1
      end
    end
  end
  assert(written == #rows, ("%d of %d rows are in a group of the page"):format(written, #rows))
  return table.concat(out, "\n"):gsub("\n+$", "") .. "\n"
end

-- --- the stubs ---

local types = { number = "number", integer = "integer", text = "string", boolean = "boolean", ["function"] = "function", numbers = "number[]",
                table = "table", any = "any" }

-- The type of a row; a table with named fields is a class of its own, called `name`.
local function type_of(argument, name)
  local words = {}
  for _, kind in ipairs(argument.kinds) do
    if kind == "text" and #argument.choices > 0 then
      for _, choice in ipairs(argument.choices) do words[#words + 1] = ("%q"):format(choice) end
    else
      words[#words + 1] = kind == "fields" and name or kind == "object" and argument.of or types[kind]
    end
  end
  return table.concat(words, "|")
end

local function remark(argument)
  local unit = argument.unit ~= "" and argument.unit .. ": " or ""
  return unit .. argument.sentence .. (argument.default and " (default " .. argument.default .. ")" or "")
end

local function class_of_fields(name, arguments, out)
  for _, argument in ipairs(arguments) do
    if #argument.rows > 0 then class_of_fields(name .. "." .. argument.name, argument.rows, out) end
  end
  out[#out + 1] = "---@class " .. name
  for _, argument in ipairs(arguments) do
    local optional = argument.required and "" or "?"
    out[#out + 1] = ("---@field %s%s %s %s"):format(argument.name, optional, type_of(argument, name .. "." .. argument.name), remark(argument))
  end
  out[#out + 1] = ""
end

local function comment(text) return "---" .. text:gsub("\n", "\n---") end

local function declare(row, out)
  local name = row.name:gsub("[:.]", "_") .. "_fields"
  if row.style == "fields" then class_of_fields(name, row.arguments, out) end
  for _, argument in ipairs(row.arguments) do
    if row.style ~= "fields" and #argument.rows > 0 then class_of_fields(name .. "." .. argument.name, argument.rows, out) end
  end
  out[#out + 1] = comment(row.sentence)
  local names = {}
  if row.style == "fields" then
    names[1] = "fields"
    out[#out + 1] = "---@param fields " .. name
  else
    for i, argument in ipairs(row.arguments) do
      names[i] = argument.name
      out[#out + 1] = ("---@param %s%s %s %s"):format(argument.name, argument.required and "" or "?",
        type_of(argument, name .. "." .. argument.name), remark(argument))
    end
  end
  local back = returns[row.name] or "any"
  if back ~= "nil" then out[#out + 1] = "---@return " .. back end
  if row.name == "mesh:set" then out[#out + 1] = "---@overload fun(self: mesh, name: string): integer[]" end
  out[#out + 1] = ("function %s(%s) end\n"):format(row.name, table.concat(names, ", "))
end

-- A class with its properties; a card's are the fields of its constructors.
local function declare_class(class, out)
  out[#out + 1] = comment(about_class[class])
  out[#out + 1] = "---@class " .. class
  for _, row in ipairs(rows) do
    if row.owner == class and row.style == "property" then
      out[#out + 1] = ("---@field %s %s %s"):format(row.name:match "%.(.+)$", returns[row.name] or "any", row.sentence)
    end
    if class == "card" and row.name == "fabric.woven" then
      for _, argument in ipairs(row.arguments) do
        out[#out + 1] = ("---@field %s %s %s"):format(argument.name, type_of(argument, "fabric_woven_fields." .. argument.name), remark(argument))
      end
    end
  end
  out[#out + 1] = "local " .. class .. " = {}\n"
end

local function stubs()
  local out = { "---@meta fabric", "-- Stubs for the Lua language server, made by fabricsh scripts/reference.lua write.\n" }
  for _, class in ipairs(classes) do declare_class(class, out) end
  out[#out + 1] = comment "The result of a virtual test; some have more." .. "\n---@class test\n---@field curve table[] its rows\n---@field analysis analysis\n"
    .. "---@field model model\n---@field mesh mesh\n---@field peak table the row of the largest displacement\n"
    .. "---@field mesh_error fun(self: test, options?: table): table what the numbers owe to the mesh\n"
  out[#out + 1] = "---@class fabric\n---@field version string\n---@field units table<string, number> multipliers to SI"
  out[#out + 1] = "local fabric = { mesh = {}, rigid = {}, lab = {}, export = {}, import = {} }\n"
  for _, row in ipairs(rows) do
    if row.style ~= "property" then declare(row, out) end
  end
  out[#out + 1] = "return fabric\n"
  return table.concat(out, "\n")
end

-- --- writing and comparing ---

local files = { ["share/doc/reference.md"] = page(), ["share/lua-ls/fabric.lua"] = stubs() }
assert(load(files["share/lua-ls/fabric.lua"], "=stubs"))()

-- Outputs of examples are compared by their words, and by their numbers to 2 %: processors round differently, and chaotic runs count other steps.
local function same_words(a, b)
  local function parts(text)
    local numbers = {}
    return text:gsub("%-?%d+%.?%d*e?[-+]?%d*", function(n) numbers[#numbers + 1] = tonumber(n) or 0 return "#" end), numbers
  end
  local words_a, numbers_a = parts(a)
  local words_b, numbers_b = parts(b)
  if words_a ~= words_b then return false end
  for i, x in ipairs(numbers_a) do
    local y = numbers_b[i]
    if math.abs(x - y) > 0.02 * math.max(math.abs(x), math.abs(y)) + 1e-9 then return false end
  end
  return true
end

-- A page without what its examples show, and that.
local function taken_apart(text)
  local shown_in = {}
  return (text:gsub("\n```text\n(.-)\n```\n", function(block)
    shown_in[#shown_in + 1] = block
    return ""
  end)), table.concat(shown_in, "\n---\n")
end

local function up_to_date(path, is, should)
  if path:find "%.md$" == nil then return is == should end
  local page_is, shown_is = taken_apart(is)
  local page_should, shown_should = taken_apart(should)
  return page_is == page_should and (fabric.checking() or same_words(shown_is, shown_should))
end

local stale = {}
for path, text in pairs(files) do
  if arg[1] == "write" then
    local file <close> = assert(io.open(root .. path, "w"))
    file:write(text)
  else
    local file = io.open(root .. path)
    if not file or not up_to_date(path, file:read "a", text) then stale[#stale + 1] = path end
    if file then file:close() end
  end
end
table.sort(stale)
if #stale > 0 then print("not up to date: " .. table.concat(stale, ", ") .. "; run fabricsh scripts/reference.lua write") end
fabric.expect { { "files that are not up to date", #stale, 0, absolute = 0 } }
