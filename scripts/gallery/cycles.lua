-- A strip of denim pulled further from time to time and let go in between: it comes back along a stiff line, goes slack at its
-- residual strain, and finds its curve again.
local fabric, out = require "fabric", arg[1] or "out/gallery"
local card = fabric.card "denim"
local p, E, S = fabric.point(card), {}, {}
local function to(from, goal)
  for k = 0, 40 do
    local r = p:uniaxial("warp", from + (goal - from) * k / 40)
    E[#E + 1], S[#S + 1] = r.E, r.S
  end
end
local goals, at = { 0.1, 0.2, 0.28 }, 0
for _, goal in ipairs(goals) do
  to(at, goal)
  at = goal - S[#S] / card.warp.unloading  -- the residual strain
  to(goal, at)
end
local backbone = { E = {}, S = {} }
for k = 0, 60 do
  local e, s = 0.28 * k / 60, 0
  for i, d in ipairs(card.warp.loading) do s = s + d * e ^ i / i end
  backbone.E[k + 1], backbone.S[k + 1] = e, s
end
fabric.plot { file = out .. "/cycles.svg", xlabel = "Green-Lagrange strain E11",
              ylabel = "stress S11", yunit = "MPa",
              curves = { { x = E, y = S, label = "pulled, let go" }, { x = backbone.E, y = backbone.S, style = "dashed", label = "P(E) of the card" } } }
fabric.expect { { "it is slack at the residual strain, Pa", S[#S], 0, absolute = 1 }, { "and the peak is P(E)", S[205], backbone.S[61], relative = 1e-12 } }
