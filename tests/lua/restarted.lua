-- A restarted deck goes the same way as one that was never killed, whatever it reads between the calls of its runs: it
-- writes the same files, or ends with an error that says why it cannot. The short form is killed in the last of the steps alone where the deck has one run.
local fabric = require "fabric"

local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local contents, run_program = check.contents, check.program
local function says(message, part) assert(message:find(part, 1, true), message .. "\nis without: " .. part) end
-- strip() makes a run of a strip of its own that is pulled with the given stroke; the process ends, as if killed, in the
-- step with the number KILL_AT, counted over all runs. say() adds a line to the deck's own file, with all digits.
local prelude = [[
local fabric = require "fabric"
local steps, lines = 0, {}
local function strip(stroke, more)
  local mesh = fabric.mesh.rectangle { width = 0.021, height = 0.05, nx = 1, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.history { { 0, 0 }, { 0.7, stroke }, { 1, stroke / 3 } } })
  local options = { model = m, duration = 1, step = 0.05 }
  for name, value in pairs(more or {}) do options[name] = value end
  return fabric.static(options)
end
local function watched(a, name, kept)
  a:every("step", function()
    steps = steps + 1
    if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end
  end)
  a:record("work/" .. name .. ".csv", { columns = { f = function(run) return select(2, run:reaction "top") end } })
  a:vtk("work/" .. name, { every = 0.3 })
  return a:checkpoint("work/run.ckpt", { every = 0.1, keep = kept })
end
local function text(value)
  if type(value) == "number" then return ("%.17g"):format(value) end
  if type(value) ~= "table" then return tostring(value) end
  local keys, words = {}, {}
  for key in pairs(value) do keys[#keys + 1] = key end
  table.sort(keys, function(one, other) return tostring(one) < tostring(other) end)
  for i, key in ipairs(keys) do words[i] = tostring(key) .. "=" .. text(value[key]) end
  return "{" .. table.concat(words, " ") .. "}"
end
local function say(...)
  for _, value in ipairs(table.pack(...)) do lines[#lines + 1] = text(value) end
  fabric.write("work/said.txt", table.concat(lines, "\n"))
end
]]

local function fresh()
  os.execute "rm -rf work; mkdir work"
end

-- Runs the deck undisturbed, and then killed in each of the steps and restarted, twice in a row where `again` is given.
local function goes_the_same_way(name, deck, kills, again)
  if again and not os.getenv "FABRICSH_TEST_LONG" then kills = { kills[#kills] } end
  local path = name .. ".lua"
  fabric.write(path, prelude .. deck)
  fresh()
  local code, talk = run_program(path)
  assert(code == 0, talk)
  local wanted = contents "work"
  assert(wanted["said.txt"])
  for _, kill_at in ipairs(kills) do
    fresh()
    code, talk = run_program(path, kill_at)
    assert(code == 9, ("%s, killed in step %d: %s"):format(name, kill_at, talk))
    for _, more in ipairs(again or {}) do
      code, talk = run_program("--restart work/run.ckpt " .. path, more)
      assert(code == 9, talk)
    end
    code, talk = run_program("--restart work/run.ckpt " .. path)
    assert(code == 0, ("%s, killed in step %d: %s"):format(name, kill_at, talk))
    local got = contents "work"
    for file, content in pairs(wanted) do
      if got[file] ~= content then
        error(("%s, killed in step %d: %s is not the same:\n%s\nwas\n%s"):format(name, kill_at, file, got[file] and got[file]:sub(1, 2000), content:sub(1, 2000)))
      end
    end
    for file in pairs(got) do assert(wanted[file], file) end
  end
end

-- Runs the deck killed in a step and restarted, where it ends with an error with these words.
local function ends(name, deck, kill_at, words, between)
  local path = name .. ".lua"
  fabric.write(path, prelude .. deck)
  fresh()
  local code, talk = run_program(path, kill_at)
  assert(code == 9, talk)
  if between then between() end
  code, talk = run_program("--restart work/run.ckpt " .. path)
  assert(code == 1, ("%s: exit code %s\n%s"):format(name, code, talk))
  for _, part in ipairs(words) do says(talk, part) end
end

-- a flow that hangs on why a run was stopped
goes_the_same_way("by_reason", [[
local a = watched(strip(0.006), "pull")
a:every("step", function(run)
  if run.time > 0.22 and run.time < 0.28 then run:stop "a third" end
  if run.time > 0.52 and run.time < 0.58 then run:stop "half" end
end)
a:solve()
say("first", a.stopped, a.time)
while a.stopped do
  say("goes on", a.stopped, a.stopped == "half" and a:mean "S11")
  a:solve()
end
say("end", a.stopped, a.time, #a.steps)
]], { 8, 16 }, { 4 })

-- everything that can be read of a run, in a loop that reads how far it came
goes_the_same_way("everything", [[
local a = watched(strip(0.0055), "pull")
local target = 0.17
while a.time < 0.83 do
  a:advance(math.min(target, 0.9))
  target = a.time + 0.21
  say(a.time, a.stopped, #a.steps, a.steps[#a.steps].residuals, tostring(a), a.energy, a.beyond)
  say(a:mean "E11", a:mean("S22", "all"), select(2, a:reaction "top"), a:node(5), a:element(2), a:field "S11", a:field "displacement")
  say(a:why(), a:mean "E11" > 0 and "taut" or "slack", a.duration, #a.mesh.nodes)
end
a:solve()
say(a.energy, a.time)
]], { 5, 16 }, { 5 })

-- means over windows that reach behind the checkpoint, of columns and of reactions
goes_the_same_way("windows", [[
local a = watched(strip(0.006), "pull")
a:reaction("top", { window = 0.33 })
a:record("work/means.csv", { every = 0.15, window = 0.27, columns = {
  f = function(run) return select(2, run:reaction "top") end,
  s = { "S22", window = 0.4 },
  r = { function(run) return select(2, run:reaction("top", { window = 0.33 })) end, window = 1e-6 },
  once = { function(run) return select(2, run:reaction("bottom", { window = 0.21 })) end, window = 1e-6 },
} })
a:solve()
say(select(2, a:reaction("top", { window = 0.33 })))
]], { 5, 16 }, { 5 })

-- single steps, settings and what a hook sets; a run that misses what it was to reach; an error in a hook
goes_the_same_way("settings", [[
local a = watched(strip(0.006, { max_cuts = 0 }), "pull")
local told = { n = 0 }
a:every("step", function(run)
  if run.time > 0.41 and run.time < 0.46 then run:set { step = 0.02 } end
  if run.time > 0.6 and told.n == 0 then
    told.n = 1
    error { code = 12 }
  end
end)
for _ = 1, 3 do a:step() end
a:set { step = 0.04 }
say(a.time)
local ok, e = pcall(a.advance, a, 0.62)
say(ok, ok or e.code)
a:set { max_iterations = 1 }
ok, e = pcall(a.advance, a, 0.8)
say(ok, e.kind, e.message, a:why():sub(1, 20))
a:set { max_iterations = 50 }
ok, e = pcall(a.reach, a, "E11", 3)
say(ok, e, a.time)
say(a:why():sub(1, 20), fabric.why():sub(1, 20))
]], { 11 })

-- a kept table that hooks and the deck change
goes_the_same_way("kept", [[
local a = strip(0.005)
local seen = { n = 0 }
a:every("step", function() seen.n = seen.n + 1 end)
watched(a, "pull", seen)
a:advance(0.33)
say(seen.n)
seen.n, seen.stage = 100, "second"
a:advance(0.57)
say(seen.n, seen.stage)
seen.n = seen.n * 2
a:solve()
say(seen.n, seen.stage)
]], { 10, 16 }, { 4 })

-- runs that depend on one another, one of them between two calls of the other
goes_the_same_way("runs", [[
local first = watched(strip(0.004), "first")
first:advance(0.45)
local second = watched(strip(first:node(7).uy + 0.001), "second")
say(first.time, first.energy)
second:advance(0.35)
say(first.time, second.time, second.energy.external)
local free = strip(second:node(8).uy)
free:advance(0.5)
first:solve()
say(free.time, free:mean "S11", first.energy)
second:solve()
say(first.time, second.energy, tostring(second))
]], { 14, 20, 31, 40 })

-- many runs with checkpoints in files of their own; one that was removed is computed again
local many = [[
local sum = 0
for i = 1, 5 do
  local a = strip(0.003 + 0.0007 * i + sum / 1e4)
  local seen = { n = 0 }
  a:every("step", function() seen.n = seen.n + 1 end)
  watched(a, "pull" .. i)
  a:checkpoint(("work/%d.ckpt"):format(i), { every = 0.25, keep = seen })
  sum = sum + a:solve().energy.external
  say(i, sum, seen.n, a.time)
end
]]
goes_the_same_way("many", many, { 50, 97 })
fabric.write("many.lua", prelude .. many)
local talk
for number, from in pairs { [2] = "5", [3] = "run" } do
  fresh()
  run_program "many.lua"
  local wanted = contents "work"
  fresh()
  run_program("many.lua", 97)
  os.remove(("work/%d.ckpt"):format(number))
  os.remove(("work/run.ckpt.%d"):format(number))
  local code
  code, talk = run_program(("--restart work/%s.ckpt many.lua"):format(from))
  assert(code == 0, talk)
  says(talk, ("restart: analysis %s is run again: cannot read '"):format(number))
  says(talk, "restart: analysis 1 is finished")
  for name, content in pairs(contents "work") do assert(content == wanted[name], name) end
end

-- the sheet in a file of its own
local written = [[
local a = watched(strip(0.006), "pull")
a:advance(0.4)
a:write("work/middle.vtu", { fields = { "S", "displacement" } }):write "work/middle.stl"
say(a.time)
a:solve()
]]
goes_the_same_way("written", written, { 13 })
ends("written", written, 13, { "'work/middle.stl' was written after call 1 of analysis 1, which the restart passes over, and is gone" },
  function() os.remove "work/middle.stl" end)

-- --- what cannot be repeated ends the deck
ends("late", [[
local a = strip(0.006)
a:advance(0.2)
say(a:mean "E11")
watched(a, "pull")
a:solve()
]], 9, { "late.lua:", "mean: restart: 'mean' needs the run as it was after call 1 of analysis 1, which the restart passes over",
  "Read it in a hook (a:every, a:event), which a restart does not repeat; or run the deck without --restart" })
ends("gltf", [[
local a = watched(strip(0.006), "pull")
a:advance(0.2)
fabric.export.gltf { run = a, file = "work/sheet.glb" }
a:solve()
]], 9, { "fabric.export.gltf needs the run as it was after call 1" })
ends("swallowed", [[
local a = strip(0.006)
a:advance(0.2)
pcall(function() say(a:mean "E11") end)
watched(a, "pull")
a:solve()
]], 9, { "solve: restart: 'mean' needs the run as it was after call 1" })
ends("other_way", [[
local a = watched(strip(0.006), "pull")
a:advance(io.open "work/turn" and 0.3 or 0.2)
a:advance(0.4)
a:solve()
]], 10, { "advance: restart: call 1 of analysis 1 is advance(0.3); the deck that wrote checkpoint 'work/run.ckpt' made advance(0.2) there" },
  function() fabric.write("work/turn", "") end)
ends("snapshot", [[
local a = watched(strip(0.006), "pull")
a:advance(0.2)
local s = a:snapshot()
say(tostring(s))
a:advance(0.6)
a:restore(s)
a:solve()
]], 9, { "restore: this snapshot was taken in a part of the run that the restart skips" })
