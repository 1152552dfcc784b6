-- Mistakes that must not be taken in silence, or reported in the system's own words.
local fabric = require "fabric"

local function fails(f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "no error")
  return tostring(message)
end
local function says(message, part) assert(message:find(part, 1, true), message .. "\nis without: " .. part) end

-- a zero byte would end a name for the system, and belongs to what is written
says(fails(fabric.write, "a\0b", "x"), "write: cannot write 'a': its name has a zero byte")
assert(not io.open "a")
local name = os.tmpname()
fabric.write(name, "one\0two")
assert(io.open(name, "rb"):read "a" == "one\0two")
os.remove(name)
says(fails(fabric.card, "denim\0x"), "card: ")
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 2, ny = 2 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend" }
says(fails(m.fix, m, "left\0x", "x"), "fix: ")
says(fails(fabric.static, { model = m, duration = 1, control = "load\0x" }), "field 'control': expected 'load' or 'arc'")

-- an empty check checks nothing, and a hole ends no list
says(fails(fabric.expect, {}), "expect: expected at least one row {label, got, want, relative=}, got none")
says(fails(fabric.expect, { label = "peak", got = 1 }), "expect: expected rows { {label, got, want, relative=}, ... }, got an entry ")
says(fails(fabric.expect, { { "one", 1, 1, relative = 1e-6 }, nil, { "two", 1, 1, relative = 1e-6 } }),
  "expect: row 2: expected a table {label, got, want, relative=}, got nil")
says(fails(fabric.expect, { "peak", 1, 1 }), "expect: row 1: expected a table {label, got, want, relative=}, got peak")

-- many columns: cost grows with their number, not with its cube
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.001, 1) })
local folder = os.tmpname()
os.remove(folder)
local function seconds(n)
  local columns = {}
  for i = 1, n do columns["c" .. i] = function() return i end end
  local a = fabric.static { model = m, duration = 1, step = 0.5 }
  local from = os.clock()
  a:record(folder .. "/wide.csv", { columns = columns })
  local took = os.clock() - from
  a:solve()
  return took
end
local few = seconds(200)
local many = seconds(1600)
assert(many < 100 * math.max(few, 2e-3), ("%g s for 200 columns, %g s for 1600"):format(few, many))
local heading = io.open(folder .. "/wide.csv"):read "l"
assert(heading:find("^time %(s%),c1,c10,c100,c1000,") and select(2, heading:gsub(",", "")) == 1600)
os.execute("rm -r " .. folder)

-- an error of the system on a folder or a name is reported with that folder or name
local function said(words)
  local pipe = assert(io.popen(words .. " 2>&1"))
  local talk = pipe:read "a"
  pipe:close()
  return talk
end
local gone = "mkdir " .. folder .. " && cd " .. folder .. " && rmdir " .. folder .. " && '" .. arg[-1] .. "' --quiet -e \"%s\""
local deck = "local m = model{ mesh=mesh.rectangle{ width=1, height=1, nx=1, ny=1 }, card=card 'blend' } m:fix('all', 'x y z') "
  .. "local a = static{ model=m, duration=1 } a:record('x.csv', { columns={ x=function() return 1 end } })"
local talk = said(gone:format(deck))
says(talk, "(command line):1: record: 'x.csv': No such file or directory")
assert(not talk:find("internal error", 1, true), talk)
local long = ("x"):rep(300)
says(fails(fabric.write, long, ""), "write: ")
assert(not fails(fabric.write, long, ""):find("internal error", 1, true))

-- A cloth that waits for its load moves by rounding alone: no error of the ledger, and nothing is said of its inertia.
for _, scheme in ipairs { "explicit", "implicit" } do
  local sleeve = fabric.mesh.cylinder { radius = 0.05, length = 0.1, around = 12, along = 4 }
  local waiting = fabric.model { mesh = sleeve, card = fabric.card("muslin", { bending = "estimated" }), warp = { 0, 0, 1 } }
  waiting:fix("bottom", "x y z"):move("top", { x = fabric.history { { 0, 0 }, { 0.01, 0 }, { 0.02, 1e-3 } } })
  local run = fabric.dynamic { model = waiting, duration = 0.02, scheme = scheme, step = scheme == "implicit" and 2e-4 or nil }
  run:advance(0.0098)
  assert(run.energy.kinetic < 1e-20, scheme)
  run:solve()
  assert(run.energy.error < 0.02, scheme .. run.energy.error)
end
