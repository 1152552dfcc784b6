-- A strip of which a part can move freely is refused with a message that says so, whatever holds the rest.
local fabric = require "fabric"

local function refused(what, card, hold)
  local mesh = fabric.mesh.rectangle{ width = 0.0254, height = 0.0762, nx = 3, ny = 9 }
  mesh:set("aside", { 20 })
  local m = fabric.model{ mesh = mesh, card = card, warp = 90 }
  hold(m)
  local ok, why = pcall(function() fabric.static{ model = m, duration = 1, step = 0.25 }:solve() end)
  assert(not ok and tostring(why):find("a part can move freely", 1, true), what .. ": " .. tostring(why))
end

local plate = fabric.svk{ name = "sheet", young = 8e6, poisson = 0.3, density = 500, thickness = 0.4e-3 }
for name, card in pairs{ blend = fabric.card "blend", sheet = plate } do
  refused(name .. " held along the pull alone", card,
    function(m) m:fix("bottom", "y"):move("top", { y = fabric.ramp(1e-3, 1) }) end)
  refused(name .. " held along y, pushed along x", card,
    function(m) m:fix("bottom", "y"):force("aside", { x = fabric.ramp(1e-3, 1) }) end)
  refused(name .. " held nowhere", card, function(m) m:force("top", { z = fabric.ramp(1e-5, 1) }) end)
end
-- A sheet on a hinge is held by its own pull.
local on_hinge = fabric.model{ mesh = fabric.mesh.rectangle{ width = 0.0254, height = 0.0762, nx = 3, ny = 9 }, card = plate, warp = 90 }
on_hinge:fix("bottom", "x y z"):move("top", { y = fabric.ramp(1e-3, 1) })
fabric.static{ model = on_hinge, duration = 1, step = 0.25 }:solve()
-- One clamped edge is enough.
local mesh = fabric.mesh.rectangle{ width = 0.0254, height = 0.0762, nx = 3, ny = 9 }
local m = fabric.model{ mesh = mesh, card = plate, warp = 90 }
m:fix("bottom", "x y z rotation"):force("top", { z = fabric.ramp(1e-5, 1) })
fabric.static{ model = m, duration = 1, step = 0.25 }:solve()
print "ok"
