-- A rigid surface whose file names the corners of each facet anew, or a facet twice, presses as one whose facets share vertices: it pressed 1.5 and
-- 2 times the law, and such a box was not closed.
local fabric = require "fabric"
local mm = fabric.units.mm

-- A box whose top is at z = 0, of 8 x 8 squares on each side, with shared vertices, with own ones of each facet, or with facets twice.
local function box(kind)
  local nodes, elements, at = {}, {}, {}
  local function node(p)
    local key = ("%.9g %.9g %.9g"):format(p[1], p[2], p[3])
    if kind == "split" or not at[key] then
      nodes[#nodes + 1] = p
      at[key] = #nodes
    end
    return at[key]
  end
  local n, a = 8, 50 * mm
  for axis = 1, 3 do
    for side = -1, 1, 2 do
      local function corner(i, j)
        local p, u, v = {}, axis % 3 + 1, (axis + 1) % 3 + 1
        p[axis], p[u], p[v] = side * a, (2 * i / n - 1) * a, (2 * j / n - 1) * a
        p[3] = p[3] - a
        return node(p)
      end
      for i = 1, n do
        for j = 1, n do
          for _ = 1, kind == "twice" and 2 or 1 do
            local p, q = i - 1, i
            if side < 0 then p, q = q, p end -- counter-clockwise from outside
            elements[#elements + 1] = { corner(p, j - 1), corner(q, j - 1), corner(q, j) }
            elements[#elements + 1] = { corner(p, j - 1), corner(q, j), corner(p, j) }
          end
        end
      end
    end
  end
  return fabric.mesh.of { nodes = nodes, elements = elements }
end

-- The force on a held sheet that is pressed by 0.8 mm: of the law k (e - range/10) from a fifth of the range on.
local function pressed(body, moves)
  local mesh = fabric.mesh.rectangle { width = 60 * mm, height = 60 * mm, nx = 23, ny = 23 }
  mesh:map(function(x, y) return x - 30 * mm, y - 30 * mm, 2.2 * mm end)
  local m = fabric.model { mesh = mesh, card = fabric.card("blend", { bending = "estimated" }), points = 1, warp = 0 }
  m:fix("all", "x y z rotation"):contact { between = { body, "all" }, thickness = 4 * mm, stiffness = 1e6 }
  if not moves then m:move(body, { z = fabric.ramp(1 * mm, 1) }) end
  local a = fabric.static { model = m, duration = 1, step = 0.5 }
  a:solve()
  return select(3, a:reaction(body))
end

local shared = pressed(fabric.rigid.surface { mesh = box "shared", closed = true })
local rows = { { "shared vertices: the law", shared / (0.06 ^ 2 * 1e6), 0.8 * mm - 0.1 * (2 * mm - 0.2242 / 1500), relative = 0.02 } }
for _, kind in ipairs { "split", "twice" } do
  rows[#rows + 1] = { kind .. ", over shared vertices", pressed(fabric.rigid.surface { mesh = box(kind), closed = true }) / shared, 1, absolute = 1e-9 }
end

-- A body that changes its shape: vertices that stay together in all of them are one.
local raised = box("split"):map(function(x, y, z) return x, y, z + 1 * mm end)
local body = fabric.rigid.motion { meshes = { box "split", raised }, times = { 0, 1 }, closed = true }
rows[#rows + 1] = { "moving, split, over shared vertices", pressed(body, true) / shared, 1, absolute = 1e-9 }
fabric.expect(rows)
