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
