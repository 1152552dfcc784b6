-- A strip pulled and let back: mesh, model, supports, histories, a static run, hooks, records, series, fields.
local fabric = require "fabric"
local mm, MPa = fabric.units.mm, fabric.units.MPa
local card = fabric.woven{ name="archived", source="this file", density=350, thickness=1.12*mm,
  warp={ loading=fabric.poly({7, 3, -200, 1810}, MPa), unloading=385*MPa, poisson=0.12 },
  weft={ loading=fabric.poly({15, -184, 6240, 3040}, MPa), unloading=402*MPa, poisson=0.22 },
  shear={ loading=fabric.poly({1, -4, 33, -53}, MPa), unloading=2*MPa, measure="tensor" },
  tested={ warp=0.2969, weft=0.1251, shear=0.3 } }
local mesh = fabric.mesh.rectangle{ width=25.4*mm, height=76.2*mm, nx=3, ny=9 }
mesh:set("middle", function(x, y) return math.abs(y - 38.1*mm) < 5*mm end)
local model = fabric.model{ mesh=mesh, card=card, warp=90 }
model:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x")
model:move("top", { y=fabric.history{ {0, 0}, {1, 10*mm}, {1.2, 9.8*mm} } })
local run = fabric.static{ model=model, duration=1.2, step=0.1 }
local seen, peak = 0, 0
run:every("step", function(a)
  seen = seen + 1
  peak = math.max(peak, (select(2, a:reaction "top")))
end)
run:record("out/strip.csv", { order={ "displacement", "force" }, columns={
  displacement=function(a) return a:node(40).uy end,
  force=function(a) return select(2, a:reaction "top") end } })
run:vtk("out/strip", { every=0.5 })
run:solve()
if fabric.checking() then return end
local record = fabric.table{ file="out/strip.csv" }
fabric.expect{
  { "steps and the start", seen, 13, absolute=0 },
  { "nodes in the middle", #mesh:set "middle", 8, absolute=0 },
  { "peak, N", peak, 32.2327639, relative=1e-8 },
  { "let back, N", (select(2, run:reaction "top")), 0.01272, absolute=1e-4 },
  { "mean S11, Pa", run:mean "S11", 396.2, absolute=1 },
  { "columns of the record", #record, 3, absolute=0 },
  { "its last displacement, m", record[2].values[13], 9.8*mm, relative=1e-12 },
}
