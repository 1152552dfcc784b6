-- A step ended by a signal, a full disk or an error leaves no trace in kept tables: rows that are made again are counted once, hooks that had not run are run, and
-- values that events were asked for in a step that was taken back do not count.
local fabric = require "fabric"
local program = ("'%s' --quiet"):format(arg[-1])
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local write = check.write
local function said(command)
  local code, text = check.shell(command .. " 2>&1")
  return text, code
end

-- A column, a hook before it and one behind it, and the action of an event count; the signal comes between two rows and after a row.
write("counted.lua", [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.05, nx = 1, ny = 2, triangles = true }
local m = fabric.model { mesh = mesh, card = fabric.card "denim", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.004, 2) })
local a = fabric.static { model = m, duration = 2, step = 0.1 }
local kept, sent = { before = 0, column = 0, behind = 0, event = 0, seen = {} }, false
a:checkpoint("traces/k.ckpt", { every = 0.7, keep = kept })
a:every("step", function() kept.before = kept.before + 1 end)
a:record("traces/k.csv", { every = 0.4, columns = { s = function(r) kept.column = kept.column + 1 kept.seen[#kept.seen + 1] = r.time return r:mean "S11" end } })
a:every("step", function(r)
  kept.behind = kept.behind + 1
  local at, signal = tonumber(arg[1]), arg[2]
  if at and not sent and r.time > at - 1e-9 then
    sent = true
    io.popen("kill -" .. signal .. " $PPID; sleep 0.1"):close()
  end
end)
if arg[1] ~= "none" then
  a:event { value = function(r) return r:mean "E11" - 0.03 end, action = function() kept.event = kept.event + 1 end }
end
a:solve()
print(kept.before, kept.column, kept.behind, kept.event, #kept.seen, table.concat(kept.seen, " "))
]])
os.execute "rm -rf traces"
local wanted = said(program .. " counted.lua")
assert(wanted:find "^22\t6\t22\t1\t6\t0.0 0.4", wanted)
for _, at in ipairs { 0.5, 0.8, 1.3 } do
  for _, signal in ipairs { "TERM", "INT", "HUP" } do
    os.execute "rm -rf traces"
    local _, code = said(("%s counted.lua %g %s"):format(program, at, signal))
    assert(code == ({ TERM = 143, INT = 130, HUP = 129 })[signal], code)
    local got = said(program .. " --restart traces/k.ckpt counted.lua")
    assert(got:find(wanted, 1, true), ("%s at %g s:\n%s\nwanted %s"):format(signal, at, got, wanted))
  end
end

-- In one program: an error in the function of a column, after it has counted, and a run that goes on.
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.05, nx = 1, ny = 2 }
local m = fabric.model { mesh = mesh, card = fabric.card "denim", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.004, 2) })
local a = fabric.static { model = m, duration = 2, step = 0.25 }
local kept, fails = { rows = 0, behind = 0 }, true
a:checkpoint("traces/one.ckpt", { every = "step", keep = kept })
a:record("traces/one.csv", { columns = { x = function(r)
  kept.rows = kept.rows + 1
  if r.time == 1 and fails then error "no value" end
  return r.time
end } })
a:every("step", function() kept.behind = kept.behind + 1 end)
assert(not pcall(a.solve, a))
assert(kept.rows == 4 and kept.behind == 4, kept.rows .. " " .. kept.behind)
fails = false
a:solve()
assert(kept.rows == 9 and kept.behind == 9, kept.rows .. " " .. kept.behind)

-- A restart where a hook had stopped the run says that its call is over.
write("halts.lua", [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.05, nx = 1, ny = 2 }
local m = fabric.model { mesh = mesh, card = fabric.card "denim", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.004, 2) })
local a = fabric.static { model = m, duration = 2, step = 0.25 }
a:checkpoint "traces/halts.ckpt"
a:every("step", function(r) if r.time == 1.25 then r:stop "far enough" end end)
a:solve()
]])
said(program .. " halts.lua")
local got = said(("'%s' --restart traces/halts.ckpt halts.lua"):format(arg[-1]))
assert(got:find("restart: from 'traces/halts.ckpt' at time 1.25 s, where the run was stopped (far enough): that call is over, and only a further solve() of the deck makes steps", 1, true), got)

-- A full disk: the row, the frames and the checkpoint fail; the deck is run again from the checkpoint before.
write("full_disk.lua", [[
local fabric = require "fabric"
local folder = arg[1]
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.05, nx = 1, ny = 2 }
local m = fabric.model { mesh = mesh, card = fabric.card "denim", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.004, 2) })
local a = fabric.static { model = m, duration = 2, step = 0.1 }
local kept = { rows = 0, before = 0, behind = 0 }
local full
a:checkpoint(folder .. "/k.ckpt", { every = 0.5, keep = kept })
a:every("step", function(r)
  kept.before = kept.before + 1
  if arg[2] ~= "fill" or full or r.time < 0.85 then return end
  full = true
  local file = io.open(folder .. "/filler", "wb")
  file:setvbuf "no"
  while file:write(("x"):rep(512)) do end
  file:close()
end)
a:record(folder .. "/k.csv", { columns = { s = function(r) kept.rows = kept.rows + 1 return r:mean "S11" end, t = function() return 0.5 end } })
a:vtk(folder .. "/k", { every = "step" })
a:every("step", function() kept.behind = kept.behind + 1 end)
if arg[2] == "fill" then
  assert(not pcall(a.solve, a))
  os.remove(folder .. "/filler")
  if arg[3] == "on" then a:solve() else os.exit(7, false) end
else
  a:solve()
end
print(kept.rows, kept.before, kept.behind)
]])
local private = "unshare -rm sh -c 'mkdir -p disk && mount -t tmpfs -o size=1m tmpfs disk && "
if not os.execute(private .. "true' 2>/dev/null") then
  io.stderr:write "SKIPPED: a full disk; this machine allows no file system of one's own (unshare -rm)\n"
else
  local plain = said(private .. ("%s full_disk.lua disk'"):format(program:gsub("'", '"')))
  assert(plain:find "21\t21\t21", plain)
  local on = said(private .. ("%s full_disk.lua disk fill on'"):format(program:gsub("'", '"')))
  assert(on:find "21\t21\t21", on)
  local again = said(private .. ("%s full_disk.lua disk fill; %s --restart disk/k.ckpt full_disk.lua disk'"):format(program:gsub("'", '"'), program:gsub("'", '"')))
  assert(again:find "21\t21\t21", again)
end
