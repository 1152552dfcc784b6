-- Checkpoints from the side of a deck: what is continued, what is kept along, what is refused, and what a disk that is full
-- or a folder that is gone does.
local fabric = require "fabric"

local function text_of(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read "a"
  file:close()
  return text
end
local function write(path, text)
  local file = assert(io.open(path, "wb"))
  file:write(text)
  file:close()
end
local function fails(f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "no error")
  return tostring(message)
end
local function says(message, part) assert(message:find(part, 1, true), message .. "\nis without: " .. part) end
local shell = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).shell
local function run_program(words) return shell(("env --default-signal=HUP '%s' %s 2>&1"):format(arg[-1], words)) end
os.execute "rm -rf out whole part gone; mkdir out whole part"

local function make(t)
  t = t or {}
  local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = t.nx or 1, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card(t.card or "blend"), warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(t.stroke or 0.018, 1) })
  if t.dynamic then return fabric.dynamic { model = m, duration = 0.001 } end
  return fabric.static { model = m, duration = t.duration or 1, step = 0.05 }
end
local function outputs(a, folder, seen)
  a:every("step", function(run) seen[#seen + 1] = run.time end)
  a:record(folder .. "/pull.csv", { columns = { force = function(run) return select(2, run:reaction "top") end } })
  a:vtk(folder .. "/pull", { every = 0.2 })
  return a:checkpoint(folder .. "/run.ckpt", { every = 0.3, keep = seen })
end
local function same_files(one, other, names)
  for _, name in ipairs(names) do assert(text_of(one .. "/" .. name) == text_of(other .. "/" .. name), name) end
end
local pull = { "pull.csv", "pull.pvd", "pull_00000.vtu", "pull_00003.vtu", "pull_00005.vtu" }

-- --- the same bits, whoever does the second half ---
local whole, part = {}, {}
local a = outputs(make(), "whole", whole):solve()
outputs(make(), "part", part):advance(0.73)
local b = make():restart "part/run.ckpt"
assert(b.time == part[13])
part = {}
outputs(b, "part", part)
assert(#part == 13 and part[13] == b.time)
b:solve()
same_files("whole", "part", pull)
assert(#whole == 21 and table.concat(whole, " ") == table.concat(part, " "))
for name, value in pairs(a.energy) do assert(b.energy[name] == value, name) end
collectgarbage() -- the run that was left holds its outputs until then
assert(#fabric.folder "part" == #fabric.folder "whole")

-- outputs come after it
says(fails(function() outputs(make(), "out", {}):restart "part/run.ckpt" end), "expected to be called before 'record', 'vtk' and 'checkpoint'")

-- --- kept tables: shared ones, circles, and in their places ---
local inner = { 1, 2.5, "x", true }
local kept = { own = { 1, 2.5, "x", true }, inner = inner, again = inner, [2] = -0.0, [2.5] = math.huge, deep = { { {} } } }
kept.self = kept
make():checkpoint("out/t.ckpt", { every = "step", keep = kept }):step()
local mine = { own = { "old", "older", 3, 4, 5 }, gone = 1 }
local held = mine.own
make():restart("out/t.ckpt"):checkpoint("out/t.ckpt", { keep = mine })
assert(mine.self == mine and mine.own == held and mine.again == mine.inner and #mine.inner == 4 and mine.gone == nil and #held == 4)
assert(held[2] == 2.5 and held[3] == "x" and held[4] == true and math.type(held[1]) == "integer")
assert(1 / mine[2] == -math.huge and mine[2.5] == math.huge and next(mine.deep[1][1]) == nil)
says(fails(function() make():checkpoint("out/u.ckpt", { keep = { a = setmetatable({}, {}) } }) end), "field 'keep.a': expected a plain table, got one with a metatable")

-- --- refused, with what differs ---
says(fails(function() make { nx = 2 }:restart "part/run.ckpt" end), "it differs in the mesh (8 nodes and 3 elements there, 12 nodes and 6 elements here)")
says(fails(function() make { stroke = 0.017 }:restart "part/run.ckpt" end), "of another problem: it differs in the motions")
says(fails(function() make { card = "denim" }:restart "part/run.ckpt" end), "the card (blend there, denim here)")
says(fails(function() make { duration = 2 }:restart "part/run.ckpt" end), "the duration (1 s there, 2 s here)")
says(fails(function() make { dynamic = true }:restart "part/run.ckpt" end), "it differs in the method (static")
local bytes = text_of "part/run.ckpt"
local function refused(text, part)
  write("out/bad.ckpt", text)
  says(fails(function() make():restart "out/bad.ckpt" end), "checkpoint 'out/bad.ckpt': " .. part)
end
refused("", "it is cut short")
refused(bytes:sub(1, 30), "it is cut short")
refused(bytes:sub(1, -2), "it is cut short: ")
refused(bytes .. "x", "it is damaged: its checksum does not fit")
refused(bytes:sub(1, 500) .. string.char(bytes:byte(501) ~ 1) .. bytes:sub(502), "it is damaged: its checksum does not fit")
refused("time,force\n", "it is no checkpoint of fabricsh")
refused(bytes:gsub("checkpoint 2", "checkpoint 3", 1), "its format has version 3, this program reads version 2")
refused(bytes:gsub("checkpoint 2", "checkpoint 1", 1),
  "its format has version 1, this program reads version 2: it was written by an earlier fabricsh, which can still go on from it")

-- --- settings under way ---
local s = make():advance(0.5):set { tolerance = 1e-4, step = 0.5 }:solve()
assert(s.steps[#s.steps].step == 0.5)
says(fails(function() make { dynamic = true }:set { tolerance = 1e-4 } end), "unknown for scheme=\"explicit\"")

-- --- a folder that goes away, and comes back: the run is alive, nothing is lost ---
os.execute "rm -rf part; mkdir part"
part = {}
local gone = false
a = make()
a:every("step", function(run)
  if gone or run.time < 0.5 then return end
  gone = true
  assert(os.rename("part", "gone"))
end)
outputs(a, "part", part)
local message = fails(a.solve, a)
says(message, "cannot write 'part/pull.csv': No such file or directory")
assert(a.time >= 0.5 and a.time < 1 and not pcall(a.solve, a))
assert(os.rename("gone", "part"))
a:solve()
same_files("whole", "part", pull)
assert(table.concat(whole, " ") == table.concat(part, " "))

-- a table that was removed is written again
os.execute "rm -rf part; mkdir part"
a = outputs(make(), "part", {})
a:every("step", function(run)
  if math.abs(run.time - 0.5) < 0.01 then os.remove "part/pull.csv" end
end)
a:solve()
same_files("whole", "part", pull)

-- --- a run that failed, was helped and went on: the restarted deck goes the same way ---
write("helped.lua", [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.history { { 0, 0 }, { 0.5, 0.01 }, { 1, 0.004 } } })
local a = fabric.static { model = m, duration = 1, step = 0.1, max_cuts = 0 }
local seen = { n = 0 }
a:record("out/helped.csv", { columns = { f = function(run) return select(2, run:reaction "top") end } })
a:every("step", function(run)
  seen.n = seen.n + 1
  if run.time > 0.7 and arg[1] == "dies" then os.exit(9, false) end
end)
a:checkpoint("out/helped.ckpt", { every = "step", keep = seen })
a:advance(0.3)
local before = a:snapshot()
a:set { max_iterations = 1 }
local ok, e = pcall(a.solve, a)
assert(not ok and e.kind == "numerical")
a:set { max_iterations = 50 }
a:advance(0.5)
a:restore(before)
a:step()
a:step()
a:solve()
print(seen.n, a.time, #a.steps, a.energy.external)
]])
local code, wanted = run_program "--quiet helped.lua lives"
assert(code == 0, wanted)
local table_of_whole = text_of "out/helped.csv"
code = run_program "--quiet helped.lua dies"
assert(code == 9)
local _, got = run_program "--quiet --threads 1 --restart out/helped.ckpt helped.lua lives"
says(got, "the deck or its arguments are not those that wrote 'out/helped.ckpt'")
assert(got:match "[^\n]*\n$" == wanted:match "[^\n]*\n$", got .. wanted)
assert(text_of "out/helped.csv" == table_of_whole)
code, got = run_program "--restart out/helped.ckpt -e 'x = 1'"
assert(code == 1)
says(got, "was written by analysis 1 of its deck; this one makes 0")

-- --- a deck of several stages: those that are finished are taken as finished, and their outputs go on ---
write("stages.lua", [[
local fabric = require "fabric"
local folder = arg[1]
local function stage(name, stroke, steps)
  local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(stroke, 1) })
  local a = fabric.static { model = m, duration = 1, step = 1 / steps, max_cuts = 0 }
  local seen = { n = 0 }
  a:every("step", function(run)
    seen.n = seen.n + 1
    io.stdout:write(name, " ")
    if name == "third" and run.time > 0.5 and arg[2] == "dies" then os.exit(9, false) end
  end)
  a:record(folder .. "/" .. name .. ".csv", { columns = { f = function(run) return select(2, run:reaction "top") end } })
  a:vtk(folder .. "/" .. name, { every = 0.25 })
  a:checkpoint(folder .. "/run.ckpt", { every = "step", keep = seen })
  return a, seen
end
local first, one = stage("first", 0.004, 8)
first:solve()
local aside = stage("aside", 0.002, 4)
aside:advance(0.5)
local second, two = stage("second", first:node(7).uy, 8)
second:set { max_iterations = 1 }
local ok, e = pcall(second.solve, second)
assert(not ok and e.kind == "numerical")
second:set { max_iterations = 50 }
second:solve()
aside:solve()
local third, three = stage("third", second:node(7).uy + aside:node(7).uy, 8)
third:solve()
print()
print(one.n, two.n, three.n, third.time, first.energy.external, second.energy.external, third.energy.external, #second.steps)
]])
os.execute "rm -rf stages again; mkdir stages again"
code, wanted = run_program "--quiet stages.lua stages lives"
assert(code == 0, wanted)
code = run_program "--quiet stages.lua again dies"
assert(code == 9)
code, got = run_program "--restart again/run.ckpt stages.lua again lives"
assert(code == 0, got)
says(got, "restart: analysis 1 is finished, from 'again/run.ckpt' at time 1 s")
says(got, "restart: analysis 3 is finished, from 'again/run.ckpt' at time 1 s")
assert(not got:find "first " and not got:find "aside " and not got:find "second " and select(2, got:gsub("third ", "")) < 6, got)
assert(got:match "[^\n]*\n$" == wanted:match "[^\n]*\n$", got .. wanted)
for _, name in ipairs { "first", "aside", "second", "third" } do
  same_files("stages", "again", { name .. ".csv", name .. ".pvd", name .. "_00000.vtu", name .. "_00004.vtu" })
end
-- ... restarted from the end of all, nothing is computed; a stage that has become another is done anew
code, got = run_program "--restart again/run.ckpt stages.lua again lives"
assert(code == 0 and not got:find "third " and got:match "[^\n]*\n$" == wanted:match "[^\n]*\n$", got)
write("changed.lua", (text_of "stages.lua":gsub('stage%("first", 0.004, 8%)', 'stage("first", 0.0041, 8)')))
code, got = run_program "--restart again/run.ckpt changed.lua again lives"
says(got, "restart: analysis 1 is run again: it differs from the finished one in 'again/run.ckpt' in the motions")
assert(select(2, got:gsub("first ", "")) == 9, got)

-- --- frames: one that is not as it was written is refused, one that was deleted is told and passed over ---
os.execute "rm -rf part; mkdir part"
outputs(make(), "part", {}):advance(0.73)
local frame = text_of "part/pull_00002.vtu"
local function goes_on()
  local run = make():restart "part/run.ckpt"
  return outputs(run, "part", {})
end
for _, damaged in ipairs { "", frame:sub(1, -2), frame:sub(1, 300) .. "x" .. frame:sub(302) } do
  write("part/pull_00002.vtu", damaged)
  says(fails(goes_on), ("its frame 'part/pull_00002.vtu' is not as it was written (%d bytes, %d were written)"):format(#damaged, #frame))
end
write("part/pull_00002.vtu", frame)
write("gone.lua", [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.018, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.05 }
a:vtk("gone/pull", { every = 0.2 })
a:checkpoint("gone/run.ckpt", { every = 0.3 })
if arg[1] then a:advance(0.73) else a:solve() end
]])
os.execute "rm -rf gone; mkdir gone"
assert(run_program "--quiet gone.lua half" == 0)
assert(os.remove "gone/pull_00002.vtu")
code, got = run_program "--restart gone/run.ckpt gone.lua"
assert(code == 0, got)
says(got, "warning: restart: 'gone/pull_00002.vtu' is gone, the series goes on without it")
local index = text_of "gone/pull.pvd"
for i, there in pairs { [0] = true, true, false, true, true, true } do
  local name = ("pull_%05d.vtu"):format(i)
  assert((index:find(name, 1, true) ~= nil) == there, index)
  assert((io.open("gone/" .. name) ~= nil) == there, name)
end

-- --- run.json lists all runs in its folder ---
local json = text_of "out/run.json"
assert(select(2, json:gsub('"number": ', "")) == 1 and json:find('"status": "done"', 1, true))
for i = 1, 2 do make():record("out/" .. i .. ".csv", { columns = { x = function() return 0 end } }):solve() end
json = text_of "out/run.json"
assert(select(2, json:gsub('"number": ', "")) >= 2 and json:find("out/1.csv", 1, true) and json:find("out/2.csv", 1, true))

-- --- a table that is gone is told by what it was ---
code = run_program "--quiet helped.lua dies"
assert(code == 9)
assert(os.remove "out/helped.csv")
code, got = run_program "--quiet --threads 1 --restart out/helped.ckpt helped.lua lives"
assert(code == 1)
says(got, "cannot go on with 'out/helped.csv': the table that the run left is gone; put it back, or run the deck without --restart")

-- --- a full disk ---
write("full.lua", [[
local folder = arg[1]
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.018, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.05 }
local full
a:every("step", function(run)
  if full ~= nil or run.time < 0.5 or arg[2] ~= "fill" then return end
  full = true
  local file = io.open(folder .. "/filler", "wb")
  file:setvbuf "no"
  while file:write(("x"):rep(512)) do end
  file:close()
end)
a:record(folder .. "/pull.csv", { columns = { force = function(run) return select(2, run:reaction "top") end } })
a:vtk(folder .. "/pull", { every = "step" })
a:checkpoint(folder .. "/run.ckpt", { every = "step" })
local ok, message = pcall(a.solve, a)
if arg[2] == "fill" then
  assert(not ok and tostring(message):find("No space left on device", 1, true), message)
  for _, name in ipairs(fabric.folder(folder)) do assert(not name:find "part$", name) end
  local b = fabric.static { model = m, duration = 1, step = 0.05 }:restart(folder .. "/run.ckpt")
  assert(b.time > 0.4 and b.time < a.time + 1e-9)
  os.remove(folder .. "/filler")
  a:solve()
end
assert(a.time == 1)
os.execute(("cat %s/pull.csv %s/pull.pvd %s/*.vtu > %s"):format(folder, folder, folder, arg[3]))
]])
local private = "unshare -rm sh -c 'mkdir -p disk && mount -t tmpfs -o size=1m tmpfs disk && exec \"$0\" \"$@\"' "
if not os.execute(private .. "true 2>/dev/null") then
  io.stderr:write "SKIPPED: a full disk; this machine allows no file system of one's own (unshare -rm)\n"
else
  assert(os.execute(private .. ("'%s' --quiet full.lua disk no plain.out"):format(arg[-1])))
  assert(os.execute(private .. ("'%s' --quiet full.lua disk fill full.out"):format(arg[-1])))
  assert(text_of "plain.out" == text_of "full.out")
end

-- --- a checkpoint is not for decks from elsewhere ---
write("safe.lua", "local fabric = require 'fabric'\n")
code, got = run_program "--safe --output out --restart part/run.ckpt safe.lua"
assert(code == 1)
says(got, "not read under --safe")

-- --- a call that a hook or an event stopped is over, also where the checkpoint was written at the stop ---
write("stopped.lua", [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.006, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.05 }
a:checkpoint("out/stopped.ckpt", { every = "step" })
a:record("out/stopped.csv", { columns = { f = function(run) return select(2, run:reaction "top") end } })
a:vtk("out/stopped", { every = 0.2 })
local function die(call)
  if arg[2] == call then os.exit(9, false) end
end
if arg[1] == "event" then
  a:event { value = function(run) return run.time - 0.63 end, action = function(run) run:stop "there" end }
else
  a:every("step", function(run)
    if run.time > 0.62 and run.time < 0.66 then run:stop "there" end
  end)
end
a:solve()
print("stopped", a)
die "stopped"
a:set { tolerance = 1e-3, step = 0.02 }
a:step()
print("step", a)
die "step"
a:solve()
print("done", a, a.energy.external)
]])
for _, kind in ipairs { "hook", "event" } do
  local _, undisturbed = run_program("--quiet stopped.lua " .. kind)
  local rows, series = text_of "out/stopped.csv", text_of "out/stopped.pvd"
  says(undisturbed, kind == "hook" and "t = 0.65 of" or "t = 0.63 of")
  for _, place in ipairs { "stopped", "step" } do
    assert(run_program(("--quiet stopped.lua %s %s"):format(kind, place)) == 9)
    local end_code, again = run_program("--quiet --restart out/stopped.ckpt stopped.lua " .. kind)
    assert(end_code == 0, again)
    assert(again:match "step\t.*" == undisturbed:match "step\t.*" and again:find("done\t", 1, true), again .. undisturbed)
    assert(text_of "out/stopped.csv" == rows and text_of "out/stopped.pvd" == series)
  end
end

-- --- another folder of outputs; two kept tables; an error of a hook's, as it was raised; a column that is put right ---
write("moved.lua", [[
local fabric = require "fabric"
local folder, dies = arg[1], arg[2] == "dies"
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.006, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.1 }
local one, two, raised = { n = 0 }, { n = 0 }, { n = 0 }
a:checkpoint(folder .. "/run.ckpt", { every = "step", keep = one })
a:checkpoint(folder .. "/more.ckpt", { every = "step", keep = two })
local column = function(run) return run.tim end
local function record(f)
  if arg[3] == "none" then return end
  a:record(folder .. "/pull.csv", { columns = { f = f } })
end
record(column)
if arg[3] == "more" then a:record(folder .. "/more.csv", { columns = { f = column } }) end
a:vtk(folder .. "/pull", { every = 0.5 })
a:every("step", function(run)
  one.n, two.n = one.n + 1, two.n + 2
  if dies and run.time > 0.75 then os.exit(9, false) end
  if run.time > 0.35 and raised.n == 0 and one.n < 6 then
    raised.n = 1
    error { code = 7, list = { "x" } }
  end
end)
local ok = pcall(a.solve, a)
assert(not ok)
record(function(run) return run.time end)
local _, e = pcall(a.advance, a, 0.5)
print("raised", e.code, e.list[1])
a:solve()
print("done", a, one.n, two.n)
]])
os.execute "rm -rf one two; mkdir one two"
code, wanted = run_program "moved.lua one"
assert(code == 0, wanted)
says(wanted, "one/pull.csv' lacks a row or frame: solve() tries it again; a:record of the same path puts a new one in its place")
says(wanted, "raised\t7\tx")
assert(select(2, text_of("one/pull.csv"):gsub("\n", "")) == 12)
assert(run_program "--quiet moved.lua part dies" == 9)
os.execute "rm -rf two; cp -r part two"
code, got = run_program "--quiet --restart two/run.ckpt moved.lua two"
assert(code == 0, got)
assert(got:match "raised.*" == wanted:match "raised.*", got .. wanted)
same_files("one", "two", { "pull.csv", "pull.pvd", "pull_00002.vtu" })
code, got = run_program "--quiet --restart part/run.ckpt moved.lua part lives none"
assert(code == 1)
says(got, "checkpoint 'part/run.ckpt': it has the table 'part/pull.csv', which this run does not continue: repeat the call that wrote it, after the restart")
code, got = run_program "--quiet --restart part/run.ckpt moved.lua part lives more"
assert(code == 1)
says(got, "checkpoint 'part/run.ckpt': the run that wrote it had no table 'part/more.csv'")

-- --- SIGTERM and SIGHUP: as Ctrl-C, and no other run is begun ---
write("term.lua", [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.006, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.1 }
a:checkpoint("out/term.ckpt")
a:record("out/term.csv", { columns = { f = function(run) return run.time end } })
a:every("step", function(run)
  if run.time > 0.45 and run.time < 0.55 then for signal in (arg[1] or ""):gmatch "%u+" do io.popen("kill -" .. signal .. " $PPID"):close() end end
end)
local ok = pcall(a.solve, a)
if not ok then a:solve() end
print(a)
]])
for signal, wanted_code in pairs { TERM = 143, HUP = 129 } do
  os.execute "rm -f out/run.json out/term.ckpt"
  code, got = run_program("--quiet term.lua " .. signal .. "," .. signal)
  assert(code == wanted_code, code)
  says(got, "ended by SIG" .. signal)
  says(text_of "out/run.json", '"status": "interrupted"')
  code, got = run_program "--quiet --restart out/term.ckpt term.lua"
  assert(code == 0, code)
  says(got, "restart: from 'out/term.ckpt' at time 0.5 s")
  says(got, "t = 1 of 1 s, 10 steps, done")
end
-- A deck may catch Ctrl-C as any error, but no run goes on after it, and how the deck ends tells of it.
code, got = run_program "--quiet term.lua INT"
assert(code == 130, code)
says(got, "solve: interrupted before this run continued")
