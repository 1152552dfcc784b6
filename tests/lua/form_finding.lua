-- Form-finding: a catenoid between two rings, a hyperbolic paraboloid with equal and unequal tensions; the shape that was found begins
-- in balance with another card.
local fabric = require "fabric"
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end

local function cosh(x) return (math.exp(x) + math.exp(-x)) / 2 end

for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  -- Rings of radius R, h apart: r = c cosh(z / c).
  local R, h, around, along = 0.6, 0.5, 24, 8
  local c = R
  for _ = 1, 100 do c = R / cosh(h / 2 / c) end
  local nodes, elements = {}, {}
  for j = 0, along do
    for i = 0, around - 1 do
      local phi = 2 * math.pi * i / around
      nodes[#nodes + 1] = { R * math.cos(phi), R * math.sin(phi), h * (j / along - 0.5) }
      if j < along then
        local a, b = j * around + i + 1, j * around + (i + 1) % around + 1
        local d, e = a + around, b + around
        if tri then
          elements[#elements + 1], elements[#elements + 2] = { a, b, e }, { a, e, d }
        else
          elements[#elements + 1] = { a, b, e, d }
        end
      end
    end
  end
  local tube = fabric.mesh { nodes = nodes, elements = elements }
  tube:set("rings", function(_, _, z) return math.abs(z) > h / 2 - 1e-9 end)
  local film = fabric.lab.form_finding { mesh = tube, prestress = { warp = 40, weft = 40 }, warp = { 0, 0, 1 }, tolerance = 2e-5,
    hold = function(m) m:fix("rings", "x y z") end }
  local x = film.mesh.nodes[along // 2 * around + 1]
  check("waist of the catenoid" .. of, math.sqrt(x[1] ^ 2 + x[2] ^ 2), c, 0.01)
  local q = film.mesh.nodes[along // 4 * around + 4]
  check("catenoid between" .. of, math.sqrt(q[1] ^ 2 + q[2] ^ 2), c * cosh(q[3] / c), 0.01)

  for name, weft in pairs { equal = 300, unequal = 700 } do
    local mesh = fabric.mesh.rectangle { width = 1.6, height = 1.6, nx = 8, ny = 8, origin = { -0.8, -0.8 }, triangles = tri }
    mesh:map(function(X, Y)
      return X, Y, math.max(math.abs(X), math.abs(Y)) > 0.8 - 1e-9 and 0.1 * X * Y or 0.02
    end)
    local found = fabric.lab.form_finding { mesh = mesh, prestress = { warp = 300, weft = weft }, tolerance = 1e-5,
      hold = function(m) m:fix("boundary", "x y z") end }
    local at = found.mesh.nodes[2 * 9 + 3]
    check("hyperbolic paraboloid, " .. name .. of, at[3], 0.1 * at[1] * at[2], 0.01)
    local m = fabric.model { mesh = found.mesh, card = fabric.card "blend", warp = 0, membrane = true, prestress = { warp = 300, weft = weft } }
    m:fix("boundary", "x y z")
    local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
    check("balance with another card, " .. name .. of, 1 + a:node(2 * 9 + 3).uz, 1, 1e-4)
  end
end
fabric.expect(checks)
