-- The shadow of a draped cloth, seen from above, and what a drape tester reads off it: area, outline, folds.
local shadow = {}

-- Triangles of the mesh' elements, a quadrilateral cut along the diagonal from its first node.
function shadow.triangles(mesh)
  local out = {}
  for i = 1, #mesh.elements do
    local n = mesh.elements[i]
    for k = 3, #n do out[#out + 1] = { n[1], n[k - 1], n[k] } end
  end
  return out
end

-- Rays stand between whole steps, where the corners of an even mesh lie: one that met a corner would be a matter of rounding.
local aside = 0.382

-- The angle of ray k of `count`, radians.
function shadow.angle(k, count) return (k - 1 + aside) * 2 * math.pi / count end

-- Where a triangle (three corners { x, y }) is met by rays from the origin, each `step` radians apart: adds { near, far } to rays[k].
local function scan(rays, step, p, q, r)
  local at = math.atan(p[2], p[1])
  local low, high = at, at
  for _, c in ipairs { q, r } do -- as seen from the first corner: a triangle spans less than half a turn
    local turn = math.atan(p[1] * c[2] - p[2] * c[1], p[1] * c[1] + p[2] * c[2])
    low, high = math.min(low, at + turn), math.max(high, at + turn)
  end
  for k = math.ceil(low / step - aside), math.floor(high / step - aside) do
    local c, s = math.cos((k + aside) * step), math.sin((k + aside) * step)
    local near, far = math.huge, -math.huge
    for _, edge in ipairs { { p, q }, { q, r }, { r, p } } do
      local a, b = edge[1], edge[2]
      local side_a, side_b = c * a[2] - s * a[1], c * b[2] - s * b[1]
      if side_a * side_b <= 0 and side_a ~= side_b then
        local part = side_a / (side_a - side_b)
        local distance = c * (a[1] + part * (b[1] - a[1])) + s * (a[2] + part * (b[2] - a[2]))
        near, far = math.min(near, distance), math.max(far, distance)
      end
    end
    if far > near then table.insert(rays[k % #rays + 1], { near, far }) end
  end
end

-- The shadow of triangles (numbers of the corners) whose nodes are at x, y, together with that of a disc of radius `support` about the
-- origin, in which no triangle may hold the origin but those that the disc hides. Returns its area (layers count once) and the outline:
-- the radius of its farthest point along each ray, counter-clockwise.
function shadow.of(x, y, triangles, support, count)
  count = count or 720
  local step, rays = 2 * math.pi / count, {}
  for k = 1, count do rays[k] = {} end
  for _, t in ipairs(triangles) do
    local hidden = true
    for _, n in ipairs(t) do hidden = hidden and x[n] ^ 2 + y[n] ^ 2 <= support ^ 2 end
    if not hidden then scan(rays, step, { x[t[1]], y[t[1]] }, { x[t[2]], y[t[2]] }, { x[t[3]], y[t[3]] }) end
  end
  local area, outline = 0, {}
  for k, list in ipairs(rays) do
    table.sort(list, function(a, b) return a[1] < b[1] end)
    local reach, sum = support, support ^ 2
    for _, part in ipairs(list) do
      if part[2] > reach then
        sum = sum + part[2] ^ 2 - math.max(reach, part[1]) ^ 2
        reach = part[2]
      end
    end
    area, outline[k] = area + sum * step / 2, reach
  end
  return area, outline
end

-- The folds of an outline: its maxima that stand out by more than `least` from the valleys beside them. Returns their number, half of the mean
-- height of maxima over valleys, and the places of the maxima.
function shadow.folds(outline, least)
  -- Turning points, maxima and minima in turn; of a flat stretch its last place.
  local turns, n = {}, #outline
  local rising
  for k = 0, 2 * n do
    local here, following = outline[k % n + 1], outline[(k + 1) % n + 1]
    if following ~= here then
      local up = following > here
      if rising ~= nil and up ~= rising and k > n then turns[#turns + 1] = { height = here, top = rising, place = k % n + 1 } end
      rising = up
    end
  end
  -- The lowest step between two neighbours goes, until each is higher than `least`.
  while #turns >= 2 do
    local lowest, at = math.huge, nil
    for i = 1, #turns do
      local height = math.abs(turns[i].height - turns[i % #turns + 1].height)
      if height < lowest then lowest, at = height, i end
    end
    if lowest > least then break end
    local other = at % #turns + 1
    table.remove(turns, math.max(at, other))
    table.remove(turns, math.min(at, other))
  end
  local tops, valleys, places = 0, 0, {}
  for _, turn in ipairs(turns) do
    if turn.top then
      tops, places[#places + 1] = tops + turn.height, turn.place
    else
      valleys = valleys + turn.height
    end
  end
  if #places == 0 then return 0, 0.0, places end
  return #places, (tops - valleys) / (2 * #places), places
end

return shadow
