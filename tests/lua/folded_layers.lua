-- A bag that begins folded onto itself, with contact between its layers, is blown up to the shape of the flat one; quadrilaterals and
-- triangles. A quarter of a pillow of two sheets whose outer part lies on the inner one, or stands up at 149 degrees from where it was cut.
local fabric = require "fabric"
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local side, gap, n = 0.16, 8e-4, 4
local nodes = (n + 1) * (n + 1)
local soft = fabric.svk { young = 1e6, poisson = 0.25, density = 700, thickness = 0.3e-3 }

local function bag(start, triangles)
  local m = check.pillow { side = side, gap = gap, n = n, card = soft, over = 0.01, start = start, triangles = triangles }
  return start and m:contact { self = "all", friction = 0, stiffness = 4e9 } or m
end

local function blown(start, triangles)
  local function run(flow)
    local m = bag(start, triangles)
    local g = m:gas { inflow = { { 0, 0 }, { 0.012, 0 }, { 0.025, flow }, { 0.05, 0 } } }
    return fabric.dynamic { model = m, duration = 0.08, damping = { mass = 150 } }, g
  end
  local before, gas = run(0)
  local _, volume, mass = before:gas(gas)
  local moving, g = run((4.6e-4 - mass) / 0.019)
  local touched = 0
  moving:every("step", function(a) touched = math.max(touched, a.energy.contact) end)
  moving:solve()
  assert((touched > 0) == (start ~= nil), "layers touch where they are folded, and only there")
  local a = fabric.static { from = moving, duration = 1, step = 1 }:solve()
  local p, V = a:gas(g)
  local corner = a:node(nodes)
  return { start = volume, pressure = p, volume = V, stored = a.energy.stored - a.energy.gas, height = a:node(1).z - a:node(1 + nodes).z,
    width = a:node(n + 1).x, ["corner x"] = corner.x, ["corner y"] = corner.y, stress = a:element(2).S11 }
end

local fold, above = side / 4, gap / 2 + 3e-4
local turn = 149 * math.pi / 180
local starts = {
  ["folded over"] = function(x, y, z)
    if x < fold - 1e-9 then return x, y, z end
    if x < fold + 1e-9 then return fold + (above - z) / 2, y, above end
    return 2 * fold - x, y, 2 * above - z
  end,
  -- About one line for both sheets, which so stay on their sides.
  ["turned up"] = function(x, y, z)
    local r = x - fold
    if r < -1e-9 then return x, y, z end
    if r < 1e-9 then return fold - z * math.tan(turn / 2), y, z end
    return fold + r * math.cos(turn) - z * math.sin(turn), y, r * math.sin(turn) + z * math.cos(turn)
  end,
}
local rows = {}
for _, case in ipairs { { "folded over", false }, { "turned up", true } } do
  local name, triangles = table.unpack(case)
  local flat, other = blown(nil, triangles), blown(starts[name], triangles)
  assert(flat.pressure > 1000 and flat.height > 0.08)
  for what, value in pairs(flat) do
    if what ~= "start" then rows[#rows + 1] = { ("%s, %s"):format(what, name), other[what], value, relative = 1e-4 } end
  end
end
fabric.expect(rows)
