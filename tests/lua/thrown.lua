-- Directors stay on their side of the sheet, within 90 degrees of the normal of the surface at their node: in the drape of chapter 7 and in violent throws,
-- whose ripples move at tens of metres per second at the start.
local fabric = require "fabric"

-- degrees: the largest angle between a director and the normal of the elements about its node, weighted by area.
local function farthest(a, mesh)
  local position, director, normals = a:field "position", a:field "director", {}
  for i = 1, #position do normals[i] = { 0, 0, 0 } end
  for k = 1, #mesh.elements do
    local e, u, v = mesh.elements[k], {}, {}
    for i = 1, 3 do
      u[i] = position[e[3]][i] - position[e[1]][i]
      v[i] = position[e[4] or e[1]][i] - position[e[2]][i]
    end
    for _, node in ipairs(e) do
      local n = normals[node]
      n[1], n[2], n[3] = n[1] + u[2] * v[3] - u[3] * v[2], n[2] + u[3] * v[1] - u[1] * v[3], n[3] + u[1] * v[2] - u[2] * v[1]
    end
  end
  local largest = 0
  for i, n in ipairs(normals) do
    local d = director[i]
    local cosine = (n[1] * d[1] + n[2] * d[2] + n[3] * d[3]) / math.sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2)
    largest = math.max(largest, math.deg(math.acos(math.max(-1, math.min(1, cosine)))))
  end
  return largest
end

-- A sheet of 2 x 2 m, pinned at its corners; thrown: it ripples at the start, m/s, and its directors turn along.
local function most(card, triangles, speed, duration)
  local mesh = fabric.mesh.rectangle { width = 2, height = 2, nx = 16, ny = 16, triangles = triangles }
  local m = fabric.model { mesh = mesh, card = fabric.card(card, { bending = "estimated" }), warp = 0 }
  m:fix("corners", "x y z"):gravity { 0, 0, -9.81 }
  if speed > 0 then
    m:velocity("all", function(x, y)
      local zx, zy = 4 * speed * math.cos(4 * x) * math.sin(6 * y), 6 * speed * math.sin(4 * x) * math.cos(6 * y)
      return { z = speed * math.sin(4 * x) * math.sin(6 * y), spin = { math.deg(zy), -math.deg(zx), 0 }, centre = { x, y, 0 } }
    end)
  end
  local a = fabric.dynamic { model = m, duration = duration }
  local largest = 0
  a:every(duration / 40, function() largest = math.max(largest, farthest(a, mesh)) end)
  a:solve()
  for _, w in ipairs(a.warnings) do assert(w.code ~= "director", w.text) end
  return largest
end

for _, case in ipairs { { "blend", false, 0, 0.5 }, { "blend", false, 16, 0.15 }, { "blend", true, 16, 0.15 }, { "muslin", false, 40, 0.06 }, { "duck", true, 40, 0.06 } } do
  local card, triangles, speed, duration = table.unpack(case)
  local largest = most(card, triangles, speed, duration)
  print(("%s, %s, %g m/s: %.1f degrees at most"):format(card, triangles and "triangles" or "quadrilaterals", speed, largest))
  assert(largest < 90, largest)
end
