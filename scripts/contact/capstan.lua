-- Capstan: a strip drawn over a cylinder, T2 / T1 against the closed forms of a thread and of a polygon.
--
--   fabricsh scripts/contact/capstan.lua          8 and 16 facets over a right angle
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local card = fabric.svk { young = 1e8, poisson = 0, density = 500, thickness = 0.4e-3, name = "tape" }
local mu, wrap = 0.3, 90

print("facets  T2/T1     polygon   thread")
for _, n in ipairs { 8, 16 } do
  local test = fabric.lab.capstan { card = card, around = n, friction = mu, wrap = wrap, draw = 0.004, lead = 1 }
  local d = math.rad(wrap) / n / 2
  local polygon = ((1 + mu * math.tan(d)) / (1 - mu * math.tan(d))) ^ n
  print(string.format("%6d  %.5f   %.5f   %.5f", n, test.ratio, polygon, math.exp(mu * math.rad(wrap))))
  fabric.expect { { n .. " facets", test.ratio, polygon, relative = 0.02 } }
end
