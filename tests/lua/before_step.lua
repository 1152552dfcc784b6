-- Readings of a run before its first step, and of its steps after it went back; and under --check, where there is never one.
local fabric = require "fabric"

local function strip(kind, fields)
  local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.001, 1) }):gravity { 0, -9.81, 0 }
  fields.model = m
  return fabric[kind](fields)
end
local runs = { strip("static", { duration = 1, step = 0.5 }), strip("dynamic", { duration = 1e-4 }), strip("dynamic", { duration = 1e-4, scheme = "implicit" }) }
for _, a in ipairs(runs) do
  local x, y, z = a:reaction "top"
  assert(x == 0 and y == 0 and z == 0)
  assert(a:mean "E11" == 0 and a:node(8).uy == 0 and a.energy.stored == 0 and #a:field "S11" == 3)
  local good, trouble = pcall(a.reaction, a, "nothing")
  assert(not good and trouble:find "unknown set 'nothing'")
  local begun = 0
  a:every("step", function(run) begun = begun + 1 assert(select("#", run:reaction "top") == 3) end)
  local s = a:snapshot()
  a:step()
  assert(begun == 2 and select(2, a:reaction "bottom") ~= 0)
  local steps, first = a.steps, a.steps[1].time
  a:restore(s)
  x, y, z = a:reaction "top"
  assert(x == 0 and y == 0 and z == 0)
  -- The steps of before are not those of now, and a list that a deck holds stays as it is.
  assert(#a.steps == 0)
  a:advance(first / 4):advance(first / 2)
  assert(#a.steps == 2 and a.steps[1].time == first / 4 and a.steps[2].time == first / 2 and #steps == 1 and steps[1].time == first)
  assert(a.steps ~= a.steps and a.steps[1] == a.steps[1], "rows are made once")
end

-- A deck that reads the run that --check passes over.
local deck = os.tmpname()
fabric.write(deck, [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3 }
local m = fabric.model{ mesh=mesh, card=fabric.card "blend", warp=90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y=fabric.ramp(0.018, 1) })
local a = fabric.static{ model=m, duration=1 }:solve()
local _, y = a:reaction "top"
local test = fabric.lab.uniaxial{ card=fabric.card "blend" }
assert(#test.curve == 1 and test.peak.S == 0)
print(("%g N %g"):format(y, a:mean "S11"))
]])
local pipe = io.popen(("'%s' --quiet --check '%s' 2>/dev/null"):format(arg[-1], deck))
local said = pipe:read "a"
assert(pipe:close() and said == "0 N 0\n", said)
os.remove(deck)
