-- A loop over cases needs the memory of one of them, whatever the collector of Lua sees of it; where memory is limited, it
-- collects and tries again, and an error names the limit that was reached.
local fabric = require "fabric"
local shell = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).shell
-- limit: of the memory of the process, kB.
local function run_program(limit, words) return shell(("ulimit -d %d; OMP_NUM_THREADS=1 '%s' --quiet %s 2>&1"):format(limit, arg[-1], words)) end
local function says(message, part) assert(message:find(part, 1, true), message .. "\nis without: " .. part) end

if run_program(400000, "-e 'x = 1'") ~= 0 then
  io.stderr:write "SKIPPED: limited memory; the address sanitizer has the memory of the process for itself\n"
  return
end

-- Eight cases of some 20 MB. Where the deck has stopped the collector, only the failed allocation brings it about.
fabric.write("loop.lua", [[
local fabric = require "fabric"
if arg[1] == "stopped" then collectgarbage "stop" end
for i = 1, 8 do
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.21, nx = 70, ny = 90 }
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "thickness" }) }
  m:fix("corners", "x y z"):gravity { 0, 0, -9.81 }
  fabric.dynamic { model = m, duration = 1e-4 }:step()
end
print "done"
]])
for _, how in ipairs { "", "stopped" } do
  local code, talk = run_program(150000, "loop.lua " .. how)
  assert(code == 0 and talk == "done\n", talk)
end

-- a static run whose matrix does not fit is no run that does not converge
fabric.write("matrix.lua", [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.21, nx = 70, ny = 90 }
local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "thickness" }) }
m:fix("bottom", "x y z"):fix("top", "x z"):move("top", { y = fabric.ramp(1e-4, 1) })
fabric.static { model = m, duration = 1, step = 1 }:solve()
]])
local code, talk = run_program(100000, "matrix.lua")
assert(code == 1, talk)
says(talk, "solve: memory limit of 97 MB for the whole process is reached (ulimit -d)")

code, talk = run_program(300000, "-e 'fabric.mesh.rectangle{ width=1, height=1, nx=9000, ny=9000 }'")
assert(code == 1, talk)
says(talk, "rectangle: memory limit of 292 MB for the whole process is reached (ulimit -d)")
