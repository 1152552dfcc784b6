-- Supports whose speed jumps, as at both ends of a ramp: the wave that no step resolves neither stops a run nor gives energy to it.
local fabric = require "fabric"
local mm = fabric.units.mm
local V, T = 0.1, 0.06
local card = fabric.card("denim", { bending = "estimated" })

-- A strip is drawn along itself by one end. Momentum: each stretch of it takes up mass times V, at the speed V of the support, of which half
-- ends as kinetic energy; the nodes of the support themselves take half.
local nx, long, wide = 16, 64 * mm, 8 * mm
local mass = card.density * card.thickness * long * wide
local full = mass * V ^ 2 * (1 - 1 / (4 * nx))
local function strip(options, history)
  local mesh = fabric.mesh.rectangle { width = long, height = wide, nx = nx, ny = 2, triangles = options.triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("all", "z rotation"):fix("left", "y"):move("left", { x = history })
  return fabric.dynamic { model = m, duration = T, scheme = "implicit", step = options.step, hht = options.hht, gamma = options.gamma,
    spectral_radius = options.spectral_radius }
end
local function watched(run)
  local most, fell = 0, 0
  run:every("step", function(a)
    most = math.max(most, a.energy.damping)
    fell = math.max(fell, most - a.energy.damping)
  end)
  run:solve()
  return fell
end
local rows = {}
for _, o in ipairs { { step = 2.5e-4 }, { step = 1e-3 }, { step = 1e-3, triangles = true }, { step = 2e-3, hht = -0.2 }, { step = 5e-4, hht = -0.05 },
  { step = 1e-3, gamma = 0.6 }, { step = 1e-3, spectral_radius = 0.7 }, { step = 1e-3, hht = -0.33, triangles = true } } do
  local name = ("%g s%s%s"):format(o.step, o.hht and ", hht " .. o.hht or o.gamma and ", gamma " .. o.gamma
    or o.spectral_radius and ", radius " .. o.spectral_radius or "", o.triangles and ", triangles" or "")
  local goes = strip(o, fabric.ramp(V * T, T))
  local fell = watched(goes)
  -- Vibrations of the strip that are left at the end are a part of it.
  rows[#rows + 1] = { "work, " .. name, goes.energy.external / full, 1, absolute = 0.05 }
  rows[#rows + 1] = { "given back by damping, " .. name, fell / full, 0, absolute = 0.01 }
  rows[#rows + 1] = { "ledger, " .. name, goes.energy.error, 0, absolute = 0.02 }
  -- It stops in the middle: the support takes nothing back but the energy of its own nodes.
  local stops = strip(o, fabric.history { { 0, 0 }, { T / 2, V * T / 2 }, { T, V * T / 2 } })
  watched(stops)
  rows[#rows + 1] = { "work, stopped, " .. name, stops.energy.external / full, 1, absolute = 0.06 }
end
fabric.expect(rows)

-- A smooth motion has no corner, and average acceleration chosen by the deck is kept: neither takes energy.
local smooth = strip({ step = 1e-3 }, function(t) return V * T / 2 * (1 - math.cos(math.pi * t / T)) / 2 end)
local chosen = strip({ step = 1e-3, hht = 0 }, fabric.ramp(V * T, T))
smooth:advance(5e-3)
chosen:advance(5e-3)
fabric.expect { { "a smooth motion", smooth.energy.damping, 0, absolute = 0 }, { "chosen", chosen.energy.damping, 0, absolute = 0 } }

-- From a snapshot between the two steps the bits are the same.
local parts = strip({ step = 1e-3 }, fabric.ramp(V * T, T))
parts:advance(1e-3)
local between = parts:snapshot()
local function after()
  parts:advance(0.02)
  return table.concat({ parts:node(20).x, parts.energy.external, parts.energy.damping }, " ")
end
local once = after()
parts:restore(between)
assert(after() == once and parts.energy.damping > 0)
