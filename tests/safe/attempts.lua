-- Attempts to get out of --safe, each refused. Run by tests/safe/run.sh, which lays the traps: the folders deck/ (with
-- this file and links), out/ (with links) and secret/ (which nobody may read or change), side by side.
local function text(value) return tostring(value):gsub("\n", " ") end

-- The call raises, or returns nil and a reason, with these words.
local function refused(what, words, f, ...)
  local good, first, why = pcall(f, ...)
  local said = not good and text(first) or (first == nil or first == false) and text(why) or nil
  if said == nil then error(what .. ": was let through", 2) end
  if not said:find(words, 1, true) then error(("%s: expected words '%s', got '%s'"):format(what, words, said), 2) end
end
local function gone(what, value)
  if value ~= nil then error(what .. " is still there", 2) end
end

local outside, below_out, link = "--safe allows reading only", "--safe allows writing only below", "--safe follows no symbolic link"
local fabric = require "fabric"
local here = arg[0]:gsub("[^/]*$", "")
local root = here:gsub("deck/$", "")

-- Programs, C code, binary chunks, the debug library.
refused("os.execute", "starts programs", os.execute, "touch " .. root .. "secret/made")
refused("io.popen", "starts programs", io.popen, "id")
refused("package.loadlib", "loads C code", package.loadlib, "libm.so.6", "*")
refused("require of a C module", "no C modules", require, "cmodule")
gone("a searcher of C modules", package.searchers[3])
assert(package.cpath == "")
refused("string.dump", "binary chunks", string.dump, print)
refused("dump by method", "binary chunks", function() return ("").dump(print) end)
refused("load of bytecode", "binary chunk", load, "\27Lua\x54\x00")
refused("load of bytecode that asks for it", "no binary chunk", load, "\27Lua\x54\x00", "x", "b")
refused("load of bytecode by pieces", "binary chunk", load, coroutine.wrap(function() coroutine.yield "\27L" coroutine.yield "ua" end), "x", "bt")
refused("loadfile of bytecode", "binary chunk", loadfile, here .. "chunk.luac")
refused("loadfile of bytecode that asks for it", "no binary chunk", loadfile, here .. "chunk.luac", "b")
refused("dofile of bytecode", "binary chunk", dofile, here .. "chunk.luac")
refused("require of bytecode", "binary chunk", function()
  package.path = here .. "?.luac"
  require "chunk"
end)
gone("debug", debug)
gone("debug in package.loaded", package.loaded.debug)
refused("require of debug", "not found", require, "debug")

-- Reading: .., absolute, links, /proc, folders, pipes, devices, a zero byte; by each way there is.
local secret = root .. "secret/key.csv"
local readers = {
  ["io.open"] = io.open, ["io.open rb"] = function(p) return io.open(p, "rb") end, ["io.lines"] = io.lines, ["io.input"] = io.input,
  loadfile = loadfile, dofile = dofile, ["fabric.table"] = function(p) return fabric.table { file = p } end,
  ["fabric.mesh.read"] = function(p) return fabric.mesh.read((p:gsub("csv$", "msh"))) end,
  ["fabric.card"] = function(p) return fabric.card(p:find "/" and p or "./" .. p) end,
}
for name, read in pairs(readers) do
  refused(name .. ", absolute", outside, read, secret)
  refused(name .. ", ..", outside, read, here .. "../secret/key.csv")
  refused(name .. ", .. behind a folder", outside, read, here .. "folder/../../secret/key.csv")
  refused(name .. ", .. behind the output", outside, read, root .. "out/../secret/key.csv")
  refused(name .. ", /proc root", outside, read, "/proc/self/root" .. secret)
  refused(name .. ", /proc cwd", outside, read, "/proc/self/cwd/secret/key.csv")
  refused(name .. ", a linked folder", link, read, here .. "way/key.csv")
  refused(name .. ", a linked file", link, read, here .. (name == "fabric.mesh.read" and "link.msh" or "link.csv"))
  refused(name .. ", a link in the output folder", link, read, root .. "out/way/key.csv")
end
for _, p in ipairs { "/etc/passwd", "/proc/self/environ", "/proc/self/maps", "/proc/self/mem", "/dev/zero", "/dev/tty", "/" } do
  refused("io.open " .. p, outside, io.open, p)
end
refused("a pipe", "not a regular file", io.open, here .. "pipe")
refused("a folder", "it is a folder", io.open, here .. "folder")
refused("a zero byte", "zero byte", io.open, here .. "..\0x/secret/key.csv")
refused("a name with zero byte by a binding", "zero byte", fabric.table, { file = here .. "..\0x/secret/key.csv" })
refused("an image", outside, fabric.lab.track, { files = { root .. "secret/key.png", root .. "secret/key.png" }, rows = 2, columns = 2, scale = 1 })
refused("the names in a folder", outside, fabric.folder, root .. "secret")
refused("the names in a linked folder", link, fabric.folder, here .. "way")
package.path = root .. "secret/?.lua;" .. here .. "way/?.lua;?.lua"
refused("require along package.path", "not found", require, "module")
refused("require with ..", "not found", require, "...secret.module")
refused("package.searchpath", "no file", package.searchpath, "module", root .. "secret/?.lua")

-- Writing, by each way there is.
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
local card = fabric.card "blend"
local function run()
  local m = fabric.model { mesh = mesh, card = card, warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.001, 1) })
  return fabric.static { model = m, duration = 1, step = 0.5 }
end
local columns = { columns = { force = function(a) return select(2, a:reaction "top") end } }
local writers = {
  card = function(p) return card:write(p .. ".lua") end, mesh = function(p) return mesh:write(p .. ".vtu") end,
  gmsh = function(p) return mesh:write(p .. ".msh") end, record = function(p) return run():record(p .. ".csv", columns) end,
  vtk = function(p) return run():vtk(p):solve() end,
  plot = function(p) return fabric.plot { file = p .. ".svg", curves = { { x = { 0, 1 }, y = { 0, 1 } } } } end,
  remove = os.remove, rename = function(p) return os.rename(root .. "out/mine", p) end,
  ["rename from"] = function(p) return os.rename(p, root .. "out/mine2") end, ["io.output"] = io.output,
}
for _, mode in ipairs { "w", "wb", "a", "a+", "r+", "r+b", "w+" } do
  writers["io.open " .. mode] = function(p) return io.open(p, mode) end
end
assert(io.open(root .. "out/mine", "w")):close()
for name, write in pairs(writers) do
  refused(name .. ", absolute", below_out, write, root .. "secret/new")
  refused(name .. ", ..", below_out, write, root .. "out/../secret/new")
  refused(name .. ", the deck's folder", below_out, write, here .. "new")
  refused(name .. ", the current folder", below_out, write, "new")
  refused(name .. ", /tmp", below_out, write, "/tmp/fabricsh-new")
  refused(name .. ", /proc", below_out, write, "/proc/self/cwd/secret/new")
  refused(name .. ", a linked folder", link, write, root .. "out/way/new")
end
for _, write in pairs { writers["io.open w"], writers["io.open a"], writers["io.open r+"], io.output } do
  refused("a linked file", link, write, root .. "out/link.csv")
  refused("a hard link", "hard link", write, root .. "out/hard.csv")
  refused("a pipe", "not a regular file", write, root .. "out/pipe")
end
refused("a mesh over a link", link, mesh.write, mesh, root .. "out/link.vtu")
refused("a record over a link", link, function() return run():record(root .. "out/link.csv", columns) end)
refused("an invalid mode", "invalid mode", io.open, root .. "out/x", "w,ccs=UTF-8")
refused("io.tmpfile", "outside the output folder", io.tmpfile)

-- Whether a file lies elsewhere is not told.
for _, p in ipairs { "/etc/passwd", "/etc/no-such-file", secret, root .. "secret/no-such-file" } do
  refused("a transcript to " .. p, below_out, fabric.transcript, p)
end

-- Labels of figures are text for gnuplot, never commands.
for _, label in ipairs { "`touch secret/made`", "'; system('touch secret/made') #", "x\nsystem 'touch secret/made'\n", "a\\", "@x", '"' } do
  fabric.plot { file = root .. "out/figure.svg", title = label, xlabel = label, ylabel = label, curves = { { x = { 0, 1 }, y = { 0, 1 }, label = label } } }
end
refused("a figure by another way", "expected a file name", fabric.plot, { file = root .. "out/x.svg' ; system 'id", curves = { { x = { 0 }, y = { 0 } } } })

-- The rest of os, one by one.
gone("os.getenv", os.getenv "HOME")
gone("os.getenv of a key", os.getenv "SECRET_KEY")
assert(os.getenv "SLURM_ARRAY_TASK_ID" == "7")
gone("os.setlocale", os.setlocale "de_DE.UTF-8")
assert(os.setlocale() == "C" and os.setlocale "C" == "C")
local name = os.tmpname()
assert(name:sub(1, #root + 4) == root .. "out/" and os.remove(name))
assert(os.rename(root .. "out/mine", root .. "out/yours") and os.remove(root .. "out/yours"))
assert(os.time() > 0 and os.clock() > 0 and os.date "%Y" and os.difftime(2, 1) == 1)

-- Metatables of what is not the deck's.
for _, value in ipairs { "", io.stdout, mesh, card } do assert(getmetatable(value) == false) end
refused("a field of texts", "attempt to index a string value", function() (""). x = 1 end)
refused("another string.format", "cannot be changed", function() string.format = error end)
rawset(string, "rep", error)  -- the deck's own table only
assert(("x"):rep(2) == "xx")
function string.twice(s) return s .. s end
assert(("ab"):twice() == "abab")
local before = { math.max, table.concat, ipairs, tostring }
math.max, table.concat, ipairs, tostring = error, error, error, error  -- the library has its own
fabric.lab.uniaxial { card = card, direction = "warp", grips = "free", steps = 4 }
math.max, table.concat, ipairs, tostring = table.unpack(before)

-- Finalisers and handlers of messages would run uncounted.
refused("a finaliser", "finalisers", setmetatable, {}, { __gc = print })
refused("a finaliser made later", "finalisers", setmetatable, {}, setmetatable({ __gc = true }, {}))
local sum = 0
for _ in pairs(setmetatable({}, { __pairs = function() return next, { 1 }, nil end })) do sum = sum + 1 end
assert(sum == 1 and select("#", xpcall(error, function(e) return e, 2 end, "x")) == 3)
assert((""):rep(1 << 62) == "")
refused("a long move", "too many", table.move, {}, 1, 1 << 60, 2)
print "all refused"
