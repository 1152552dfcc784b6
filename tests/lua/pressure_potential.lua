-- Pressure inside held edges, or on a quarter between planes of symmetry, has a potential: the symmetric and the unsymmetric solver agree in shape and iterations.
local fabric = require "fabric"
local card = fabric.card("blend", { bending = "estimated" })
local function blown(linear, quarter)
  local n, side = 4, quarter and 0.05 or 0.1
  local m = fabric.model { mesh = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n }, card = card, warp = 0, points = 1 }
  if quarter then m:symmetry("left", "x"):symmetry("bottom", "y"):fix("right", "x y z"):fix("top", "x y z") else m:fix("boundary", "x y z") end
  m:pressure(fabric.ramp(2e3, 1))
  local a = fabric.static { model = m, duration = 1, step = 0.25, linear = linear }:solve()
  return a:node(quarter and 1 or 13).uz, #a.steps
end
for _, quarter in ipairs { false, true } do
  local z, steps = blown("auto", quarter)
  local Z, Steps = blown("unsymmetric", quarter)
  fabric.expect { { quarter and "a quarter: height, m" or "held: height, m", z, Z, relative = 1e-9 } }
  assert(math.abs(z) > 1e-3 and steps == Steps)
end
