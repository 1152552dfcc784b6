-- Wrong input, and the exact words that it gets. Each case runs in a pcall here, then all are typed into an interactive
-- session, which must survive every one.
local setup = [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3 }
local function strip(card)
  return fabric.model{ mesh=mesh, card=card or fabric.card "blend", warp=90 }
end
local function pulled(h)
  return fabric.static{ model=strip():fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", {y=h}), duration=1 }
end
]]

local cases = {
  -- sizes and counts
  { "fabric.mesh.rectangle{ width=-1, height=1, nx=3, ny=9 }", "rectangle: field 'width': expected a positive number in m, got -1" },
  { "fabric.mesh.rectangle{ width=1, height=1, nx=0, ny=9 }", "rectangle: field 'nx': expected an integer of at least 1, got 0" },
  { "fabric.mesh.rectangle{ width=1, height=1, nx=2.5, ny=9 }", "rectangle: field 'nx': expected an integer of at least 1, got 2.5" },
  { "fabric.mesh.rectangle{ width=0/0, height=1, nx=3, ny=9 }", "rectangle: field 'width': expected a positive number in m, got nan" },
  { "fabric.mesh.rectangle{ width=1/0, height=1, nx=3, ny=9 }", "rectangle: field 'width': expected a positive number in m, got inf" },
  -- fields
  { "fabric.mesh.rectangle{ width=1, heigth=1, nx=3, ny=9 }", "rectangle: unknown field 'heigth', did you mean 'height'?" },
  { "fabric.mesh.rectangle{ width=1, height=hieght, nx=3, ny=9 }",
    "rectangle: field 'height': expected a positive number in m, got nil (missing, or a misspelt variable)" },
  { "fabric.mesh.rectangle{ width='1', height=1, nx=3, ny=9 }", "rectangle: field 'width': expected a positive number in m, got '1'" },
  { "fabric.mesh.rectangle(1, 1, 3, 9)", "rectangle: expected one table with named fields, got 4 values" },
  { "fabric.mesh.rectangle()", "rectangle: expected a table with named fields, got nil" },
  { "fabric.mesh.rectangle{ 1, 1 }", "rectangle: expected named fields, got an entry without a name at 1" },
  { "fabric.mesh.rectangel{}", "fabric.mesh: unknown field 'rectangel', did you mean 'rectangle'?" },
  { "fabric.crad 'blend'", "fabric: unknown field 'crad', did you mean 'card'?" },
  -- names
  { "mesh:set 'lft'", "set: unknown set 'lft', did you mean 'left'?" },
  { "strip():fix('botom', 'x')", "fix: unknown set 'botom', did you mean 'bottom'?" },
  { "strip():fix('bottom', 'x w')", "fix: " },
  { "fabric.card 'denm'", "card: unknown fabric 'denm', did you mean 'denim'?" },
  { "fabric.card './no-such-card.lua'", "card: cannot read './no-such-card.lua': No such file or directory" },
  { "mesh.nods = 3", "mesh: field 'nods' cannot be assigned" },
  { "return mesh.nods", "mesh: unknown field 'nods', did you mean 'nodes'?" },
  { "return fabric.card 'blend'.warpp", "card: unknown field 'warpp', did you mean 'warp'?" },
  { "fabric.card 'blend':with{ warp={poison=1} }", "with: unknown field 'warp.poison', did you mean 'warp.poisson'?" },
  { "mesh.set('x')", "set: called without its mesh (write x:set(...), with a colon), got 'x'" },
  { "mesh:set('s', {0})", "set: argument 'nodes': expected node numbers from 1 to 8, got 0" },
  { "mesh:set('s', function() error 'inside' end)", "inside" },
  { "mesh:map(function(x, y) return x, y end)", "map: argument 'f': expected the function to return x, y, z in m, got nil in place 3" },
  -- objects
  { "fabric.model{ mesh=mesh, card='blend' }", "model: field 'card': expected a card, got 'blend'" },
  { "fabric.static{ model=mesh, duration=1 }", "static: field 'model': expected a model, got a mesh" },
  { "fabric.static{ model=strip() }",
    "static: field 'duration': expected a positive number in s, got nil (missing, or a misspelt variable)" },
  { "fabric.point()", "point: argument 'card': expected a card, got nil (missing, or a misspelt variable)" },
  -- cards
  { "strip(fabric.card 'blend':with{ warp={loading={-8e6, 826e6}} })",
    "model: card 'blend': field 'warp.loading': expected a positive modulus D up to the tested E11 = 0.2641, got D = -8 MPa at E11 = 0",
    line = 4 },
  { "strip(fabric.card 'blend':with{ warp={poisson=3} })", "model: card 'blend': field 'warp.poisson': expected nu12 nu21 < 1, got 3 x 0.42 = 1.26",
    line = 4 },
  { "fabric.card 'blend':with{ warp={poisson=-0.1} }", "with: field 'warp.poisson': expected a number of at least 0, got -0.1" },
  { "fabric.card 'blend':with{ warp={loading={}} }", "with: field 'warp.loading': expected a table of numbers in Pa, got an empty table" },
  { "fabric.card 'blend':with{ shear={measure='tenser'} }",
    "with: field 'shear.measure': expected 'tensor' or 'engineering', got 'tenser'" },
  -- histories
  { "fabric.history{ {0, 1}, {0, 2} }", "history: row 2: expected a time later than 0, got 0" },
  { "fabric.history{ {0, 1, 2} }", "history: argument 'points[1]': expected {time, value}, got 3 numbers" },
  { "fabric.ramp(1)", "ramp: argument 'duration': expected a positive number in s, got nil (missing, or a misspelt variable)" },
  { "pulled(function(t) return t > 0.4 and 0/0 or t*1e-3 end):solve()", "solve: " },
  { "pulled(function(t) return t > 0.4 and 'x' or t*1e-3 end):solve()",
    "solve: move: field 'y': expected the history to return a number at t = 0.4" },
  { "pulled(function(t) error 'in the history' end):solve()", "in the history" },
  -- models
  { "fabric.static{ duration=1, model=strip():fix('top', 'y'):move('top', {y=0.01}) }", "static: " },
  { "strip():move('top', {})", "move: " },
  { "strip():move('top', {w=1})", "move: unknown field 'components.w'" },
  -- hooks and outputs
  { "local a = pulled(0.001) a:every('step', function() error 'in the hook' end) a:solve()", "in the hook" },
  { "local a = pulled(0.001) a:every('step', function() local x = nil + 1 end) a:solve()", "attempt to perform arithmetic on a nil value" },
  { "pulled(0.001):every('steps', print)", "every: argument 'interval': expected a positive number in s or 'step', got 'steps'" },
  { "pulled(0.001):record('/dev/null/x.csv', { columns={ t=function(a) return a.time end } })", "record: " },
  { "pulled(0.001):vtk '/dev/null/x'", "vtk: " },
  { "fabric.card 'blend':write '/dev/null/x.lua'", "write: " },
  { "pulled(0.001):mean 'S1'", "mean: argument 'name': expected 'E11'" },
  { "pulled(0.001):node(99)", "node: " },
  { "pulled(0.001):reaction 'tpo'", "reaction: unknown set 'tpo', did you mean 'top'?" },
  { "fabric.expect{ {'x', 1, 2, relative=1e-3} }", "expect: 1 of 1 missed: 'x'" },
  { "fabric.expect{ {'x', nil, 2, relative=1e-3} }", "expect: row 'x': expected two numbers (got, want), got nil and 2" },
  { "fabric.lab.uniaxial{ card=fabric.card 'blend', grips='glued' }",
    "uniaxial: field 'grips': expected a table or 'clamped' or 'free', got 'glued'" },
}

local missed = 0
local function miss(...)
  missed = missed + 1
  io.stderr:write(string.format(...), "\n")
end

local _, lines = setup:gsub("\n", "")
for _, case in ipairs(cases) do
  local chunk, want = table.unpack(case)
  local ok, message = pcall(assert(load(setup .. chunk, "=deck.lua")))
  message = tostring(message)
  if ok then
    miss("no error from: %s", chunk)
  elseif not message:find(("deck.lua:%d: %s"):format(case.line or lines + 1, want), 1, true) then
    miss("%s\n  got:  %s\n  want: deck.lua:%d: %s", chunk, message, case.line or lines + 1, want)
  end
end

-- The same, typed at the prompt.
local path = os.tmpname()
local file = assert(io.open(path, "w"))
file:write((setup:gsub("local (%w+) =", "%1 ="):gsub("local function", "function")), "\n")
for _, case in ipairs(cases) do file:write(case[1], "\n") end
file:write("'still alive'\n")
file:close()
local pipe = assert(io.popen(("'%s' < '%s' 2>&1"):format(arg[-1], path)))
local talk = pipe:read "a"
local ok, _, code = pipe:close()
os.remove(path)
if not (ok and code == 0 and talk:find("still alive", 1, true)) then miss("the session did not survive:\n%s", talk) end
for _, case in ipairs(cases) do
  if not talk:find(case[2], 1, true) then miss("at the prompt: no '%s'", case[2]) end
end

assert(missed == 0, missed .. " cases missed")
print(#cases .. " cases")
