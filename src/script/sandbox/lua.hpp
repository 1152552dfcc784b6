// The part of the sandbox that is written in Lua; run once before any deck, with all of Lua available.
#pragma once

namespace fabricsh::script {

inline constexpr const char* sandbox_lua = R"lua(
local native, text_metatable = ...
local G = _G
local error, type, pcall, next, load = error, type, pcall, next, load
local find, gsub, gmatch, rep, move = string.find, string.gsub, string.gmatch, string.rep, table.move
local io_input, io_output, io_lines, setlocale = io.input, io.output, io.lines, os.setlocale
local getenv = os.getenv

local function copy(t)
  local c = {}
  for k, v in next, t do c[k] = v end
  return c
end

local function refused(name, why)
  return function() error(name .. ": not available under --safe: " .. why, 2) end
end

-- Chunks: text only, files through the gate.
function G.load(chunk, name, mode, ...)
  if mode ~= nil and not find(mode, "t", 1, true) then return nil, "load: --safe loads text, no binary chunk" end
  return load(chunk, name, "t", ...)
end
function G.loadfile(path, mode, ...)
  if path == nil then error("loadfile: expected the name of a file, as --safe requires", 2) end
  if mode ~= nil and not find(mode, "t", 1, true) then return nil, "loadfile: --safe loads text, no binary chunk" end
  return native.loadfile(path, ...)
end
function G.dofile(path)
  local chunk, why = G.loadfile(path)
  if not chunk then error(why, 0) end
  return chunk()
end
string.dump = refused("string.dump", "it makes binary chunks")

-- A handler of messages would run inside the hook that counts, uncounted; so it runs behind it.
local function handled(handler, good, ...)
  if good then return true, ... end
  return false, handler(...)
end
function G.xpcall(f, handler, ...) return handled(handler, pcall(f, ...)) end

G.getmetatable, G.setmetatable = native.getmetatable, native.setmetatable
coroutine.create, coroutine.wrap = native.paid(coroutine.create), native.paid(coroutine.wrap)

-- Loops in C that no instruction counts.
function string.rep(s, n, separator)
  if s == "" and (separator == nil or separator == "") then return "" end
  return rep(s, n, separator)
end
function table.move(a, first, last, to, b)
  if type(first) == "number" and type(last) == "number" and last - first > 1e9 then error("table.move: too many elements", 2) end
  return move(a, first, last, to, b)
end

-- Files.
io.open = native.open
io.popen = refused("io.popen", "it starts programs")
io.tmpfile = refused("io.tmpfile", "its file lies outside the output folder")
local function opened(path, mode)
  local file, why = native.open(path, mode)
  if not file then error(why, 3) end
  return file
end
function io.input(file)
  if type(file) == "string" then file = opened(file, "r") end
  return io_input(file)
end
function io.output(file)
  if type(file) == "string" then file = opened(file, "w") end
  return io_output(file)
end
local function closing(file, first, ...)
  if first == nil then file:close() end
  return first, ...
end
function io.lines(path, ...)
  if path == nil then return io_lines(path, ...) end
  local file = opened(path, "r")
  local step = file:lines(...)
  return function() return closing(file, step()) end, nil, nil, file
end

os.execute = refused("os.execute", "it starts programs")
os.remove, os.rename, os.tmpname = native.remove, native.rename, native.tmpname
-- The environment holds names and keys of the user's; of it a deck sees which share of an array job it is.
function os.getenv(name)
  if find(name, "^SLURM_ARRAY_[A-Z_]+$") then return getenv(name) end
end
function os.setlocale(locale, category)
  if locale == nil then return setlocale(nil, category) end
  return (locale == "C" or locale == "POSIX") and setlocale(nil, category) or nil
end

-- Modules: Lua files through the gate. Those of the program see the environment `own`.
local own = copy(G)
local function place_of(name, path, separator, replacement)
  local tried = ""
  if separator ~= "" then name = gsub(name, "%" .. (separator or "."), function() return replacement or "/" end) end
  for template in gmatch(path, "[^;]+") do
    local file = gsub(template, "%?", function() return name end)
    if native.exists(file) then return file end
    tried = tried .. "\n\tno file '" .. file .. "'"
  end
  return nil, tried
end
local function search(name)
  local file, tried = place_of(name, type(package.path) == "string" and package.path or "")
  if not file then return tried .. "\n\t--safe loads no C modules" end
  local chunk, why
  if native.library_file(file) then chunk, why = native.loadfile(file, own) else chunk, why = native.loadfile(file) end
  if not chunk then error("error loading module '" .. name .. "' from file '" .. file .. "':\n\t" .. why, 0) end
  return chunk, file
end
package.cpath = ""
package.loadlib = refused("package.loadlib", "it loads C code")
function package.searchpath(name, path, ...) return place_of(name, path, ...) end
local searchers = package.searchers
for i = #searchers, 2, -1 do searchers[i] = nil end
searchers[2] = search
G.debug, package.loaded.debug = nil, nil

-- A deck cannot change the library's functions: it has tables of its own, and so have the methods of texts.
local strings, added = copy(string), {}
for _, name in next, { "coroutine", "io", "math", "os", "string", "table", "utf8" } do own[name] = copy(G[name]) end
own._G, own.debug, own.package = own, nil, package
text_metatable.__index = setmetatable(strings, { __index = added })
local function guarded(_, name, value)
  if strings[name] ~= nil and added[name] == nil then error("string." .. tostring(name) .. " cannot be changed under --safe", 2) end
  added[name] = value
end
local shown = setmetatable({}, { __index = strings, __newindex = guarded, __metatable = false,
  __pairs = function()
    local all = copy(strings)
    for k, v in next, added do all[k] = v end
    return next, all, nil
  end })
G.string, package.loaded.string = shown, shown
require "fabric"
)lua";

}  // namespace fabricsh::script
