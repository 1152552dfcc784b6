-- What a time scheme takes of a fall or an impact is said at the end of the run; near equilibrium it takes little, and nothing is said.
local fabric = require "fabric"
local card = fabric.card("blend", { bending = "estimated" })

local function said(a)
  for _, w in ipairs(a.warnings) do
    if w.code == "damped" then
      assert(not w.serious and w.text:find("(energy.damping)", 1, true), w.text)
      return tonumber(w.text:match "has taken ([%d.]+) %%")
    end
  end
end
local function run(m, duration, options)
  local o = { model = m, duration = duration, scheme = "implicit" }
  for key, value in pairs(options) do o[key] = value end
  return fabric.dynamic(o):solve()
end

-- A ball of 20 g comes at 5 m/s on a held sheet.
local function impact(options)
  local mesh = fabric.mesh.rectangle { width = 0.2, height = 0.2, nx = 8, ny = 8, origin = { -0.1, -0.1, 0 } }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }:fix("boundary", "x y z")
  local ball = fabric.rigid.sphere { radius = 0.02, centre = { 3e-3, 2e-3, 0.03 }, mass = 0.02 }
  m:velocity(ball, { z = -5 }):contact { between = { ball, "all" }, friction = 0.3 }
  local a = run(m, 0.05, options)
  local share, whole = said(a), 0.02 * 5 ^ 2 / 2
  fabric.expect { { "share told, of what there was", share and share / 100 or 0, share and a.energy.damping / whole or 0, relative = 1e-3 } }
  assert((share ~= nil) == (a.energy.damping > 0.1 * whole))
  return share
end
assert(impact { step = 5e-3, slow = true } > 40)

-- A sheet is let go and rests: by damping of the deck, or by the scheme.
local function falls(options)
  local mesh = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 4, ny = 4 }
  local m = fabric.model { mesh = mesh, card = card, warp = 90 }:fix("boundary", "x y z"):gravity { 0, 0, -9.81 }
  return run(m, 1, options)
end
local a = falls { step = 5e-3, slow = true, until_rest = { calm = 0.01, window = 0.1 } }
assert(a.stopped == "at rest" and said(a) > 30)
assert(not said(falls { step = 2e-3, damping = { mass = 30 } }))

-- Supports that go slowly: what their work is too much in a few steps is no loss of a motion.
for _, steps in ipairs { 5, 50 } do
  local mesh = fabric.mesh.rectangle { width = 0.025, height = 0.076, nx = 2, ny = 6 }
  local m = fabric.model { mesh = mesh, card = card, warp = 90 }:fix("all", "z rotation"):fix("bottom", "x y"):move("top", { x = fabric.ramp(0.02, 1), y = 0 })
  assert(not said(run(m, 1, { step = 1 / steps, slow = true })))
end
