-- A bag that begins folded is blown up to the shape of the one that begins flat: in motion, then at rest, with the same gas; quadrilaterals
-- and triangles. A quarter of a pillow of two sheets, whose outer half is turned up about a line, or which is drawn too large.
-- warns: edges that are sewn were still
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local side, gap, n = 0.2, 0.004, 4
local nodes = (n + 1) * (n + 1)
local soft = fabric.svk { young = 1e6, poisson = 0.25, density = 700, thickness = 0.3e-3 }

local function bag(start, triangles)
  return check.pillow { side = side, gap = gap, n = n, card = soft, over = 0.02, start = start, triangles = triangles }
end

-- Gas flows in until there are 0.9 g of it.
local function blown(start, triangles)
  local function run(flow)
    local m = bag(start, triangles)
    local g = m:gas { inflow = { { 0, 0 }, { 0.03, 0 }, { 0.05, flow }, { 0.09, 0 } } }
    return fabric.dynamic { model = m, duration = 0.22, damping = { mass = 100 } }, g
  end
  local before, gas = run(0)
  local _, volume, mass = before:gas(gas)
  local moving, g = run((9e-4 - mass) / 0.03)
  moving:solve()
  local a = fabric.static { from = moving, duration = 1, step = 1 }:solve()
  local p, V, all = a:gas(g)
  local corner = a:node(nodes)
  return { start = volume, pressure = p, volume = V, mass = all, stored = a.energy.stored, height = a:node(1).z - a:node(1 + nodes).z,
    width = a:node(n + 1).x, ["corner x"] = corner.x, ["corner y"] = corner.y, ["stress"] = a:element(2).S11 }
end

local fold = side / 4
local starts = {
  ["turned up"] = function(x, y, z)
    local r = math.max(0, x - fold)
    return x - r + r * math.cos(1.9), y, z + r * math.sin(1.9)
  end,
  ["pulled"] = function(x, y, z) return 1.1 * x, 1.05 * y, z end,
}
local rows = {}
for _, triangles in ipairs { false, true } do
  local flat = blown(nil, triangles)
  assert(flat.pressure > 1000 and flat.volume > 10 * flat.start and flat.height > 0.1)
  for name, start in pairs(triangles and { ["turned up"] = starts["turned up"] } or starts) do
    local other = blown(start, triangles)
    assert(math.abs(other.start / flat.start - 1) > 0.1, "it begins elsewhere")
    for what, value in pairs(flat) do
      if what ~= "start" then
        rows[#rows + 1] = { ("%s, %s%s"):format(what, name, triangles and ", triangles" or ""), other[what], value, relative = 1e-4 }
      end
    end
  end
end
fabric.expect(rows)
