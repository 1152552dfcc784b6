-- The uncertainty of draw-in and work of forming: mesh, friction, and what the card assumes.
local fabric = require "fabric"
local mm = fabric.units.mm

local b = fabric.budget {
  card = fabric.card("blend", { bending = "estimated" }), mesh = { 4, 6, 8 }, assumed = { friction = { 0.1, 0.3 } }, samples = 8, shares = false, print = false, processes = 1,
  run = function(p)
    local r = fabric.lab.form { card = p.card, blank = 60 * mm, punch = { radius = 12 * mm }, die = { radius = 15 * mm, edge = 8 * mm }, holder = { force = 20 }, friction = p.assumed.friction,
                                stroke = 4 * mm, cells = p.mesh, quarter = true, speed = 8, rows = 4 }
    return { work = r.curve[#r.curve].external, drawn = r.draw_in.mean / mm }
  end,
}
for name, value in pairs(b.value) do
  local band = b.band[name]
  print(("%s %.4g, band %.4g to %.4g, %d runs"):format(name, value, band.low, band.high, b.runs))
  assert(band.low < value and value < band.high, name)
end
-- Friction is in both: more of it takes work.
assert(b.band.work.high > 1.1 * b.band.work.low)
print "formed_budget ok"
