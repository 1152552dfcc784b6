-- Creases: lines along which a sheet rests at an angle. A free sheet folds to it and stores nothing; one that is placed folded has no
-- stress; pleats; a crease that is held flat has the moment of the elements beside it.
local fabric = require "fabric"
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end
local rad = math.pi / 180

local B = 4e-5
local card = fabric.svk { density = 500, thickness = 0.3e-3, warp = 20e6, weft = 20e6, shear = 8e6, poisson = 0,
  bending = { warp = B, weft = B, twist = B / 2 } }
local length, width = 0.12, 0.03
local function strip(tri) return fabric.mesh.rectangle { width = length, height = width, nx = 12, ny = 2, triangles = tri } end
local function last(mesh)
  for i = 1, #mesh.nodes do
    local x = mesh.nodes[i]
    if x[1] > length - 1e-9 and x[2] < 1e-9 then return i end
  end
end
local function line(x) return { { x, 0, 0 }, { x, width, 0 } } end

for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  for _, angle in ipairs { 40, -75 } do
    local m = fabric.model { mesh = strip(tri), card = card }
    m:fix("left", "x y z rotation"):crease { line = line(0.05), angle = angle }
    local a = fabric.static { model = m, duration = 1, step = 0.5 }
    local began = a.energy.stored
    a:solve()
    local tip = a:node(last(m.mesh))
    check("folds to " .. angle .. of, tip.z, 0.07 * math.sin(angle * rad), 1e-6)
    check("and stores nothing" .. of, 1 + a.energy.stored / began, 1, 1e-8)
    check("the panel stays flat" .. of, tip.x, 0.05 + 0.07 * math.cos(angle * rad), 1e-6)
  end

  -- Pleats of 50 degrees and back, along the nodes of sets, in the place where they are at rest.
  local flat = strip(tri)
  local function pleat(x, y)
    local c, s = math.cos(50 * rad), math.sin(50 * rad)
    if x < 0.04 - 1e-9 then return x, y, 0 end
    if x < 0.08 - 1e-9 then return 0.04 + c * (x - 0.04), y, s * (x - 0.04) end
    return 0.04 + 0.04 * c + (x - 0.08), y, 0.04 * s
  end
  local nodes, elements, up, down = {}, {}, {}, {}
  for e = 1, #flat.elements do elements[e] = flat.elements[e] end
  for i = 1, #flat.nodes do
    local x = flat.nodes[i]
    nodes[i] = { pleat(x[1], x[2]) }
    if math.abs(x[1] - 0.04) < 1e-9 then up[#up + 1] = i elseif math.abs(x[1] - 0.08) < 1e-9 then down[#down + 1] = i end
  end
  local start = fabric.mesh { nodes = nodes, elements = elements }
  start:set("up", up)
  start:set("down", down)
  local pleated = fabric.model { mesh = start, card = card, reference = flat }
  pleated:crease { set = "up", angle = 50 }:crease { set = "down", angle = -50 }
  local p = fabric.static { model = pleated, duration = 1, step = 1 }
  check("pleats at rest" .. of, 1 + 1e4 * p.energy.stored, 1, 1e-9)
end
fabric.expect(checks)
