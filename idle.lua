local fabric = require "fabric"
local card = fabric.svk { name = "sheet", young = 5e6, poisson = 0, density = 500, thickness = 0.3e-3, bending = { warp = 4e-3, weft = 4e-3, twist = 2e-3 } }
local model = fabric.model{ mesh=fabric.mesh.rectangle{ width=0.02, height=0.02, nx=1, ny=1 }, card=card, warp=0 }:fix('bottom', 'x y z rotation')
fabric.static{ model=model, duration=1, step=1, max_iterations=9 }:solve() print 'done'