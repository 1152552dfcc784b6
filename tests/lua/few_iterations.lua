-- Implicit motion of a cloth whose yarns let go a hundred times as stiffly as they load: few iterations a
-- step, and the motion of the explicit scheme; squares and triangles, with friction and without.
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.card("blend", { bending = "estimated" })

local function drape(o)
  local mesh = fabric.mesh.rectangle { width = 0.24, height = 0.18, nx = 8, ny = 6, origin = { -0.12, -0.09, 0 },
                                       triangles = o.triangles }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  local ball = fabric.rigid.sphere { radius = 40 * mm, centre = { 5 * mm, 0, -40.3 * mm } }
  m:gravity { 0, 0, -9.81 }:contact { between = { ball, "all" }, friction = o.friction }
  local a = fabric.dynamic { model = m, duration = 0.12, scheme = o.scheme, step = o.step, damping = { mass = 10 } }
  a:solve()
  local iterations = 0
  for _, s in ipairs(a.steps) do iterations = iterations + (s.iterations or 0) end
  return a:node(1), iterations / #a.steps, a
end

for _, o in ipairs { { friction = 0.3 }, { friction = 0 }, { friction = 0.4, triangles = true } } do
  local name = o.triangles and "triangles" or "squares, friction " .. o.friction
  local reference = drape { scheme = "explicit", friction = o.friction, triangles = o.triangles }
  for step, most in pairs { [1e-3] = 7, [4e-3] = 10 } do
    local corner, mean, a = drape { scheme = "implicit", step = step, friction = o.friction, triangles = o.triangles }
    print(("%s, %g s: %.2f iterations a step, corner %.2f, %.2f mm"):format(name, step, mean, corner.z / mm, reference.z / mm))
    fabric.expect {
      { ("%s, %g s: iterations a step, at most %d"):format(name, step, most), math.max(mean, most), most, absolute = 0 },
      { name .. ": corner, m", corner.z, reference.z, absolute = 2 * mm },
      { name .. ": error of the ledger", a.energy.error, 0, absolute = 5e-3 },
    }
  end
end
