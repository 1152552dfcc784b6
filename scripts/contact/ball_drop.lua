-- A ball falls onto a clamped square, for the four fabrics: deflection and force against time, cloth and ball for ParaView.
--
--   fabricsh scripts/contact/ball_drop.lua                      on screen: the largest of each fabric
--   fabricsh scripts/contact/ball_drop.lua 0.1 0.2 40 out       0.1 kg from 0.2 m, 40 x 40 elements, curves and series into out/NAME
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local mass, height, cells = tonumber(arg[1] or 0.1), tonumber(arg[2] or 0.1), tonumber(arg[3] or 8)
local out, friction = arg[4], 0.2
local g = 9.81

print("fabric     deflection/mm  force/N  at/ms  smallest gap/mm  ledger")
for _, name in ipairs { "blend", "denim", "duck", "muslin" } do
  local test = fabric.lab.ball_drop { card = fabric.card(name), mass = mass, height = height, cells = cells, friction = friction,
                                      duration = out and 0.04 or 0.008, out = out and out .. "/" .. name }
  local deepest, strongest = test.curve[1], test.curve[1]
  for _, row in ipairs(test.curve) do
    if row.deflection > deepest.deflection then deepest = row end
    if row.force > strongest.force then strongest = row end
  end
  local e, last = test.analysis.energy, test.curve[#test.curve]
  print(string.format("%-10s %10.3f %12.3f %6.2f %14.4f %11.1e", name, 1e3 * deepest.deflection, strongest.force, 1e3 * deepest.time, 1e3 * test.gap, e.error))
  fabric.expect {
    { name .. ": the ball begins with the speed of its fall", test.curve[1].speed, math.sqrt(2 * g * (height - 1e-4)), relative = 1e-12 },
    { name .. ": the gap stays open", test.gap > 0 and 1 or 0, 1, absolute = 0 },
    { name .. ": the ledger is closed", e.error, 0, absolute = 1e-2 },
    { name .. ": the guard was not needed", e.guard, 0, absolute = 0 },
    { name .. ": the sheet slows the ball", last.speed < test.curve[1].speed + g * last.time and 1 or 0, 1, absolute = 0 },
  }
end
