-- A strip sewn from two pieces of equal and of different spacing is pulled as the whole strip.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.card "muslin"

local function force(model, bodies, top)
  for _, body in ipairs(bodies) do model:fix(body .. "all", "z rotation") end
  model:fix(bodies[1] .. "bottom", "x y"):fix(top, "x"):move(top, { y = fabric.ramp(2 * mm, 1) })
  local a = fabric.static { model = model, duration = 1, step = 0.1 }
  a:solve()
  return select(2, a:reaction(top))
end

local whole = force(fabric.model { mesh = fabric.mesh.rectangle { width = 24 * mm, height = 60 * mm, nx = 6, ny = 15 }, card = card, warp = 90 }, { "" }, "top")
local function sewn(cells)
  local low = fabric.mesh.rectangle { width = 24 * mm, height = 20 * mm, nx = 6, ny = 5 }
  local high = fabric.mesh.rectangle { width = 24 * mm, height = 40 * mm, nx = cells, ny = 10, origin = { 0, 20 * mm, 0 } }
  local m = fabric.model { bodies = { { name = "low", mesh = low, card = card, warp = 90 }, { name = "high", mesh = high, card = card, warp = 90 } } }
  m:seam { "low.top", "high.bottom" }
  return force(m, { "low.", "high." }, "high.top")
end
fabric.expect {
  { "equal spacing", sewn(6), whole, relative = 1e-9 },
  { "five cells on six", sewn(5), whole, relative = 0.01 },
}
