-- A short deck with every kind of output, for valgrind (scripts/sanitize valgrind).
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.0254, height = 0.0762, nx = 1, ny = 3 }
mesh:write "strip.vtu"
local m = fabric.model { mesh = fabric.mesh.read "strip.vtu", card = fabric.card "blend", warp = 90 }
m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.ramp(0.018, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.25 }
a:record("curve.csv", { columns = { force = function(run) return select(2, run:reaction "top") end } })
a:vtk "strip"
a:checkpoint "strip.ckpt"
a:solve()
assert(#fabric.table { file = "curve.csv" } == 2)
pcall(fabric.static, { model = m })
pcall(fabric.mesh.read, "curve.csv")
print(fabric.point(fabric.card "denim"):uniaxial("warp", 0.05).S)
