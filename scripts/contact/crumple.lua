-- The halves of a folded sheet are thrown at each other: self-contact without friction and then with it. Energy is kept, nothing passes.
--
--   fabricsh scripts/contact/crumple.lua               8 x 8 elements
--   fabricsh scripts/contact/crumple.lua 40 out        40 x 40, with a series for ParaView in out
local fabric = require "fabric"
local cells, out = tonumber(arg[1] or 8), arg[2]
local side, speed = 0.06, 5
local card = fabric.svk { young = 5e6, poisson = 0.2, density = 600, thickness = 0.4e-3, name = "sheet" }

local function crumple(friction)
  local mesh = fabric.mesh.rectangle { width = side, height = side, nx = cells, ny = cells, origin = { -side / 2, -side / 2, 0 } }
  -- A fold to begin with: its two halves stand up and fly at each other.
  local lean = math.rad(70)
  mesh:map(function(x, y)
    local r = 4e-3
    local arc = math.min(math.abs(x), r * lean)
    local beyond, angle = math.abs(x) - arc, arc / r
    local out_, up = r * math.sin(angle) + beyond * math.cos(lean), r * (1 - math.cos(angle)) + beyond * math.sin(lean)
    return x < 0 and -out_ or out_, y, up
  end)
  local m = fabric.model { mesh = mesh, card = card, warp = function(x) return { math.cos(lean), 0, x < 0 and -math.sin(lean) or math.sin(lean) } end }
  m:contact { self = "all", friction = friction }
  m:velocity("all", function(x, _, z) return { x = -speed * (x < 0 and -1 or 1) * math.min(1, z / 0.01) } end)
  local a = fabric.dynamic { model = m, duration = 5e-3 }
  local gap = math.huge
  a:every(2e-4, function(run) gap = math.min(gap, (run:gap())) end)
  if out and friction > 0 then a:vtk(out .. "/crumple", { every = 2e-4 }) end
  a:solve()
  return a, gap
end

for _, friction in ipairs { 0, 0.3 } do
  local a, gap = crumple(friction)
  local e = a.energy
  print(string.format("friction %.1f: kinetic %.3e of %.3e J, stored %.3e, in contact %.3e, friction took %.3e, ledger %.1e, smallest gap %.3g mm",
                      friction, e.kinetic, e.initial, e.stored, e.contact, e.friction, e.error, 1e3 * gap))
  fabric.expect {
    { "the gap stays open", gap > 0 and 1 or 0, 1 , absolute = 0 },
    { "the ledger is closed", e.error, 0, absolute = 1e-2 },
    { "friction took", e.friction > 0 and 1 or 0, friction > 0 and 1 or 0, absolute = 0 },
  }
end
