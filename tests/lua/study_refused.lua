-- Cases that the machine did not let finish are missing and run again; a folder is computed by one program at a time; and means over a window of time.
local fabric = require "fabric"
os.execute "rm -rf refused; mkdir refused"
local program = ("'%s' --quiet"):format(arg[-1])
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local write = check.write
local function said(command)
  local code, text = check.shell(command .. " 2>&1")
  return text, code
end

-- --- no room for a table: of six cases those that write little are there, the others missing, none failed; with room all are ---
write("refused/room.lua", [[
local fabric = require "fabric"
local study = fabric.study{ parameters={ rows={ 2, 3, 300, 320, 340 }, wrong={ false, true } }, workers=1, folder="refused/room", run=function(p)
  if p.wrong and p.rows == 2 then error "no such cloth" end
  local mesh = fabric.mesh.rectangle{ width=0.02, height=0.02, nx=1, ny=1 }
  local m = fabric.model{ mesh=mesh, card=fabric.card "denim" }:fix("all", "x y z rotation")
  local a = fabric.static{ model=m, duration=p.rows, step=1 }
  a:record(("refused/t%d%s.csv"):format(p.rows, p.wrong), { columns={ one=function() return 1 / 3 end, two=function() return 2 / 3 end, three=function() return 4 / 3 end, four=function() return 5 / 3 end } })
  return { time=a:solve().time }
end }
local there = 0
for _, case in ipairs(study) do there = there + (case.values and 1 or 0) end
print(study.complete, study.missing, study.failed, there)
]])
local got = said("bash -c 'ulimit -f 12; exec " .. program:gsub("'", '"') .. " refused/room.lua'")
assert(got:find "false\t6\t1\t3", got)
got = said(program .. " refused/room.lua")
assert(got:find "true\t0\t1\t9", got)

-- --- no memory ---
write("refused/memory.lua", [[
local fabric = require "fabric"
local study = fabric.study{ parameters={ size={ 10, 150000000 } }, workers=1, folder="refused/memory", run=function(p)
  if p.size > 10 and arg[1] == "full" then local all = {} for i = 1, 9 do all[i] = ("x"):rep(p.size) .. i end return { n=#all } end
  return { n=p.size }
end }
print(study.complete, study.missing, study.failed)
]])
got = said("bash -c 'ulimit -v 900000; exec " .. program:gsub("'", '"') .. " refused/memory.lua full'")
assert(got:find "false\t1\t0", got)

-- --- two programs in one folder ---
write("refused/long.lua", [[
local fabric = require "fabric"
local study = fabric.study{ parameters={ n={ 1, 2, 3 } }, workers=1, folder="refused/two", run=function(p)
  if p.n == 2 and arg[1] == "first" then
    local pipe = io.popen(arg[2] .. " refused/long.lua second 2>&1")
    fabric.write("refused/said.txt", pipe:read "a")
    pipe:close()
  end
  return { n=p.n }
end }
print(study.complete)
]])
got = said(program .. (" refused/long.lua first \"%s\""):format(program))
assert(got:find "true", got)
local second = io.open("refused/said.txt"):read "a"
assert(second:find("study: the folder 'refused/two' is being computed by another program", 1, true) and second:find("--case", 1, true), second)
assert(said(program .. " refused/long.lua third"):find "true")

-- --- means over a window: of a parabola with teeth that cancel over it ---
local c = { time = {}, y = {} }
for i = 0, 400 do c.time[i + 1], c.y[i + 1] = i * 0.005, (i * 0.005) ^ 2 + (i % 2 == 0 and 1 or -1) end
local smooth = fabric.columns(c):window("y", 0.2)
for i = 50, 350, 30 do
  local t = c.time[i]
  assert(math.abs(smooth[i] - (t * t + 0.2 ^ 2 / 12)) < 1e-4, smooth[i])
end
assert(#smooth == 401 and not pcall(function() return fabric.columns(c):window("y", 0) end))
local rows = {}
for i = 1, #c.time do rows[i] = { time = c.time[i], displacement = c.time[i], force = c.y[i] } end
local reference = { displacement = {}, force = {} }
for i = 1, 18 do reference.displacement[i], reference.force[i] = 0.1 * i, (0.1 * i) ^ 2 + 0.2 ^ 2 / 12 end
local compared = fabric.lab.compare(reference, { curve = rows }, { window = 0.2 })
assert(compared.rms < 1e-3 and fabric.lab.compare(reference, { curve = rows }).rms > 0.05, compared.rms)
local ok, why = pcall(fabric.lab.compare, reference, reference, { window = 0.2 })
assert(not ok and tostring(why):find("field 'window'", 1, true), why)
