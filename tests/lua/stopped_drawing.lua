-- SIGTERM while a hook draws a picture: the hook is completed, the checkpoint written, and the restarted run goes on after it. Each picture is the same
-- to the byte whenever it is drawn.
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))

os.execute "rm -rf whole ended; mkdir whole ended"
local file = assert(io.open("deck.lua", "w"))
file:write [[
local fabric = require "fabric"
local out = arg[1]
local m = fabric.model { mesh = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 12, ny = 12 }, card = fabric.card "muslin" }
m:gravity { 0, 0, -9.81 }:fix("left", "x y z")
local a = fabric.dynamic { model = m, duration = 0.01 }
local state = {}
a:checkpoint(out .. "/run.ckpt", { minutes = 10, keep = state })
a:every(0.005, function()
  if a.time == 0 or state.drawn then return end
  if os.getenv "SIGNAL" then os.execute "(sleep 0.1; kill -TERM $PPID) &" end
  fabric.render { file = out .. "/bent.png", run = a, field = "shear_angle", view = { 20, 10 }, width = 1400, height = 1400, smooth = true }
  state.drawn = true
end)
a:solve()
print(("%.17g"):format(a:node(#m.mesh.nodes).z))
]]
file:close()
local function run(words, before) return check.shell(("%s '%s' --quiet %s 2>&1"):format(before or "", arg[-1], words)) end

local code, wanted = run "deck.lua whole"
assert(code == 0, wanted)
local stopped, talk = run("deck.lua ended", "SIGNAL=yes")
assert(stopped == 143 and talk:find("ended by SIGTERM at 0.005 s", 1, true), talk)
local again, got = run "--restart ended/run.ckpt deck.lua ended"
assert(again == 0 and got:sub(-#wanted) == wanted, got)
assert(check.contents("ended")["bent.png"] == check.contents("whole")["bent.png"], "another picture")
print "the picture that was drawn during SIGTERM is whole, and the run went on after it"
