-- A rigid surface as other programs write it presses as one whose facets share vertices: where a file names the corners of each facet anew, rounded to six digits; a
-- facet twice, whichever way around; rows of facets that do not share their corners; facets that look inwards or have no area. These pressed up to 2 times the law, or
-- were not closed. What lies on the surface within the range of contact, so that places count twice, is told.
local fabric = require "fabric"
local mm = fabric.units.mm

-- A box whose top is at z = 0, of 8 x 8 squares on each side, with shared vertices; with own ones of each facet, exact or each rounded to six digits of a number that is
-- 1e-9 off; with facets twice; with squares twice, whichever way around; as bricks; with every third facet turned around; with needles without area along edges.
local function box(kind, height)
  local nodes, elements, at, noise = {}, {}, {}, 0
  local function node(p)
    if kind == "rounded" then
      noise = (noise + 0.618033988749895) % 1
      for k = 1, 3 do p[k] = tonumber(("%.6g"):format(p[k] * (1 + 1e-9 * (noise - 0.5)) + 3e-10 * (noise - 0.5))) end
    end
    local key = ("%.9g %.9g %.9g"):format(table.unpack(p))
    if kind == "split" or kind == "rounded" or not at[key] then
      nodes[#nodes + 1] = p
      at[key] = #nodes
    end
    return at[key]
  end
  local n, a = 8, 50 * mm
  local function add(...) -- a facet, counter-clockwise from outside
    local ids = { ... }
    if kind == "turned" and #elements % 3 == 0 then ids[1], ids[2] = ids[2], ids[1] end
    elements[#elements + 1] = ids
    if kind == "twice" then elements[#elements + 1] = ids end
    if kind == "both" then elements[#elements + 1] = { ids[4], ids[3], ids[2], ids[1] } end
  end
  for axis = 1, 3 do
    for side = -1, 1, 2 do
      local function corner(i, j)
        local p, u, v = {}, axis % 3 + 1, (axis + 1) % 3 + 1
        p[axis], p[u], p[v] = side * a, (2 * i / n - 1) * a, (2 * j / n - 1) * a
        p[3] = (p[3] - a) * (height or 2 * a) / (2 * a)
        return node(p)
      end
      for j = 1, n do
        local shift, last = kind == "bricks" and j % 2 == 0 and 0.5 or 0, 0
        while last < n do
          local p, q, r, s = last, math.min(last == 0 and 1 - shift or last + 1, n), j - 1, j
          last = q
          if side < 0 then r, s = s, r end
          if kind == "both" then
            add(corner(p, r), corner(q, r), corner(q, s), corner(p, s))
          else
            add(corner(p, r), corner(q, r), corner(q, s))
            add(corner(p, r), corner(q, s), corner(p, s))
            if kind == "needles" then
              add(corner(p, r), corner((p + q) / 2, r), corner(q, r))
            end
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
  local a, told = fabric.static { model = m, duration = 1, step = 0.5 }, nil
  a:solve()
  for _, w in ipairs(a.warnings) do told = told or w.code == "facets" and w.text end
  local on, sum = a:on_body(body), 0
  for i, p in ipairs(on.pressure) do sum = sum + p * on.area[i] end
  return select(3, a:reaction(body)), told, sum
end
local function surface(mesh, open) return fabric.rigid.surface { mesh = mesh, closed = not open, name = "block" } end

local shared, told = pressed(surface(box "shared"))
assert(not told, told)
local rows = { { "shared vertices: the law", shared / (0.06 ^ 2 * 1e6), 0.8 * mm - 0.1 * (2 * mm - 0.2242 / 1500), relative = 0.02 } }
-- Rounded ones do not lie in a plane.
for kind, near in pairs { split = 1e-9, twice = 1e-9, both = 1e-9, turned = 1e-9, needles = 1e-9, rounded = 1e-6, bricks = 1e-9 } do
  local force, more = pressed(surface(box(kind)))
  assert(not more, more)
  rows[#rows + 1] = { kind .. ", over shared vertices", force / shared, 1, absolute = near }
end

-- A body that changes its shape: vertices that stay together in all of them are one, and those that stay on an edge divide it.
for kind, near in pairs { split = 1e-9, bricks = 1e-9 } do
  local raised = box(kind):map(function(x, y, z) return x, y, z + 1 * mm end)
  local body = fabric.rigid.motion { meshes = { box(kind), raised }, times = { 0, 1 }, closed = true }
  rows[#rows + 1] = { "moving, " .. kind .. ", over shared vertices", pressed(body, true) / shared, 1, absolute = near }
end

-- Two solids that share an edge, the upper one inside out: both look outwards then, so that readings on the body have their sign.
do
  local nodes, elements, at = {}, {}, {}
  for k, one in ipairs { box "shared", box("shared", 300 * mm):map(function(x, y, z) return x + 100 * mm, y, z - 100 * mm end) } do
    local ids = {}
    for i, p in ipairs(one.nodes) do
      local key = ("%.6f %.6f %.6f"):format(table.unpack(p))
      if not at[key] then
        nodes[#nodes + 1] = p
        at[key] = #nodes
      end
      ids[i] = at[key]
    end
    for _, e in ipairs(one.elements) do
      local a, b, c = ids[e[1]], ids[e[2]], ids[e[3]]
      elements[#elements + 1] = k == 1 and { b, a, c } or { a, b, c }
    end
  end
  assert(#nodes == 2 * #box("shared").nodes - 9)
  local force, _, sum = pressed(surface(fabric.mesh.of { nodes = nodes, elements = elements }))
  rows[#rows + 1] = { "solids at an edge, over shared vertices", force / shared, 1, absolute = 1e-9 }
  rows[#rows + 1] = { "pressure on them, over the force", sum / force, 1, absolute = 0.02 }
end

-- A plate thinner than the range of contact presses with its lower side, too: that is told, and where.
local thin, words = pressed(surface(box("shared", 0.5 * mm)))
rows[#rows + 1] = { "a thin plate, over a block", thin / shared, 1.19, absolute = 0.03 }
assert(words:find("block on the cloth: 99 % of its area has another sheet of facets within 0.0005 m", 1, true), words)
assert(not select(2, pressed(surface(box("shared", 2 * mm)))))
-- So are sheets that lie on each other but cut otherwise, and edges near each other that are not joined.
local top = {}
for i = 1, 2 do
  top[i] = fabric.mesh.rectangle { width = 0.1, height = 0.1, nx = 8 + i, ny = 8, origin = { -0.05, -0.05 } }
end
words = select(2, pressed(surface(fabric.mesh.merge { meshes = top, distance = 0 }, true)))
assert(words:find("100 % of its area has another sheet of facets within 0 m", 1, true), words)
local function strip(side) return fabric.mesh.rectangle { width = 0.05 - 0.05 * mm, height = 0.1, nx = 4, ny = 8, origin = { side > 0 and 0.05 * mm or -0.05, -0.05 } } end
words = select(2, pressed(surface(fabric.mesh.merge { meshes = { strip(-1), strip(1) }, distance = 0 }, true)))
assert(words:find("0.2 m of its free edges have facets in front of them that are not joined, the nearest 0.0001 m away", 1, true), words)
fabric.expect(rows)
