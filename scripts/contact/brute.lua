-- Does anything of a run pass through anything else? Looked at by brute force, with no help from the search or the distances of
-- contact: every edge of the cloth against every triangle of it, every triangle against every ball, every node against every plane.
--
-- A pair that was found to be s apart is looked at again before the two can have moved by s, so that no pair is ever trusted
-- further than its own distance reaches, and a look at each step of a run costs little.
local brute = {}

local huge, sqrt, floor, abs, max, min = math.huge, math.sqrt, math.floor, math.abs, math.max, math.min

-- Vectors, and the box of points.
local function sub(a, b) return { a[1] - b[1], a[2] - b[2], a[3] - b[3] } end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function cross(a, b) return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] } end

local function box(nodes)
  local low, high = { huge, huge, huge }, { -huge, -huge, -huge }
  for _, p in ipairs(nodes) do
    for k = 1, 3 do low[k], high[k] = min(low[k], p[k]), max(high[k], p[k]) end
  end
  return low, high
end
brute.sub, brute.dot, brute.cross, brute.box = sub, dot, cross, box

-- The middle of the nodes of a model, about which contact cuts its flat sheets.
function brute.middle(nodes)
  local low, high = box(nodes)
  return { (low[1] + high[1]) / 2, (low[2] + high[2]) / 2, (low[3] + high[3]) / 2 }
end

-- Whether the elements lie in the plane of the largest.
local function flat(nodes, elements)
  local used, normal, most = {}, nil, 0
  for _, id in ipairs(elements) do
    for _, n in ipairs(id) do used[#used + 1] = nodes[n] end
    local n = cross(sub(nodes[id[3]], nodes[id[1]]), sub(nodes[id[4] or id[1]], nodes[id[2]]))
    if dot(n, n) > most then normal, most = n, dot(n, n) end
  end
  local low, high = box(used)
  local thin = 1e-6 * max(high[1] - low[1], high[2] - low[2], high[3] - low[3]) * sqrt(most)
  for _, p in ipairs(used) do
    if abs(dot(sub(p, used[1]), normal)) > thin then return false end
  end
  return true
end

-- The triangles of a surface as contact cuts it: quadrilaterals along their shorter reference diagonal; of equal ones, in a flat sheet with a `centre`,
-- that which does not point there, else by the parity of the element's number in the surface.
function brute.triangles(mesh, centre)
  local list, x = {}, mesh.nodes
  local mirrors = centre and flat(x, mesh.elements)
  for e, id in ipairs(mesh.elements) do
    if #id == 3 then
      list[#list + 1] = { id[1], id[2], id[3] }
    else
      local one, two = sub(x[id[3]], x[id[1]]), sub(x[id[4]], x[id[2]])
      local first, second = sqrt(dot(one, one)), sqrt(dot(two, two))
      local along = first < second
      if abs(first - second) <= 1e-9 * (first + second) then
        along = (e - 1) % 2 == 0
        if mirrors then
          local from = {}
          for k = 1, 3 do from[k] = (x[id[1]][k] + x[id[2]][k] + x[id[3]][k] + x[id[4]][k]) / 4 - centre[k] end
          local a, b = abs(dot(from, one)), abs(dot(from, two))
          if not (abs(a - b) <= 1e-6 * (a + b)) then along = a < b end
        end
      end
      for _, t in ipairs(along and { { 1, 2, 3 }, { 1, 3, 4 } } or { { 1, 2, 4 }, { 2, 3, 4 } }) do list[#list + 1] = { id[t[1]], id[t[2]], id[t[3]] } end
    end
  end
  return list
end

-- The edges of triangles, each once, as two corners in ascending order.
function brute.edges(triangles)
  local list, known = {}, {}
  for _, t in ipairs(triangles) do
    for k = 1, 3 do
      local a, b = t[k], t[k % 3 + 1]
      if a > b then a, b = b, a end
      local key = a .. " " .. b
      if not known[key] then
        known[key] = true
        list[#list + 1] = { a, b }
      end
    end
  end
  return list
end

-- Does the edge pq go through the triangle abc [moller1997], its border counted as inside.
local function cuts(X, Y, Z, p, q, a, b, c)
  local px, py, pz, ax, ay, az = X[p], Y[p], Z[p], X[a], Y[a], Z[a]
  local lx, ly, lz = X[q] - px, Y[q] - py, Z[q] - pz
  local ux, uy, uz = X[b] - ax, Y[b] - ay, Z[b] - az
  local vx, vy, vz = X[c] - ax, Y[c] - ay, Z[c] - az
  local hx, hy, hz = ly * vz - lz * vy, lz * vx - lx * vz, lx * vy - ly * vx
  local det = ux * hx + uy * hy + uz * hz
  local size = sqrt((lx * lx + ly * ly + lz * lz) * (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz))
  if abs(det) <= 1e-15 * size then return false end -- parallel: its ends and edges are met by other pairs
  local sx, sy, sz = px - ax, py - ay, pz - az
  local wx, wy, wz = sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux
  local first = (sx * hx + sy * hy + sz * hz) / det
  local second = (lx * wx + ly * wy + lz * wz) / det
  local t = (vx * wx + vy * wy + vz * wz) / det
  return first >= 0 and second >= 0 and first + second <= 1 and t >= 0 and t <= 1
end

-- A lower bound of the distance of an edge and a triangle: the widest gap between their boxes along the axes; where those overlap, between their
-- projections onto a few directions (a separating axis).
local function apart(X, Y, Z, p, q, a, b, c)
  local x1, x2, y1, y2, z1, z2 = X[p], X[q], Y[p], Y[q], Z[p], Z[q]
  if x1 > x2 then x1, x2 = x2, x1 end
  if y1 > y2 then y1, y2 = y2, y1 end
  if z1 > z2 then z1, z2 = z2, z1 end
  local best = max(0, min(X[a], X[b], X[c]) - x2, x1 - max(X[a], X[b], X[c]), min(Y[a], Y[b], Y[c]) - y2, y1 - max(Y[a], Y[b], Y[c]),
    min(Z[a], Z[b], Z[c]) - z2, z1 - max(Z[a], Z[b], Z[c]))
  if best > 0 then return best end
  local function along(x, y, z)
    local size = sqrt(x * x + y * y + z * z)
    if not (size > 0) then return end
    local e1, e2 = x * X[p] + y * Y[p] + z * Z[p], x * X[q] + y * Y[q] + z * Z[q]
    local t1, t2, t3 = x * X[a] + y * Y[a] + z * Z[a], x * X[b] + y * Y[b] + z * Z[b], x * X[c] + y * Y[c] + z * Z[c]
    best = max(best, (min(e1, e2) - max(t1, t2, t3)) / size, (min(t1, t2, t3) - max(e1, e2)) / size)
  end
  local mx = (X[p] + X[q]) / 2 - (X[a] + X[b] + X[c]) / 3
  local my = (Y[p] + Y[q]) / 2 - (Y[a] + Y[b] + Y[c]) / 3
  local mz = (Z[p] + Z[q]) / 2 - (Z[a] + Z[b] + Z[c]) / 3
  along(mx, my, mz)
  local ux, uy, uz, vx, vy, vz = X[b] - X[a], Y[b] - Y[a], Z[b] - Z[a], X[c] - X[a], Y[c] - Y[a], Z[c] - Z[a]
  along(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
  local lx, ly, lz = X[q] - X[p], Y[q] - Y[p], Z[q] - Z[p]
  local part = (mx * lx + my * ly + mz * lz) / (lx * lx + ly * ly + lz * lz)
  along(mx - part * lx, my - part * ly, mz - part * lz)
  return best
end

-- Distance of a place and a triangle.
local function distance(X, Y, Z, x, y, z, a, b, c)
  local function to_edge(i, j)
    local lx, ly, lz = X[j] - X[i], Y[j] - Y[i], Z[j] - Z[i]
    local t = max(0, min(1, ((x - X[i]) * lx + (y - Y[i]) * ly + (z - Z[i]) * lz) / (lx * lx + ly * ly + lz * lz)))
    return sqrt((x - X[i] - t * lx) ^ 2 + (y - Y[i] - t * ly) ^ 2 + (z - Z[i] - t * lz) ^ 2)
  end
  local ux, uy, uz, vx, vy, vz = X[b] - X[a], Y[b] - Y[a], Z[b] - Z[a], X[c] - X[a], Y[c] - Y[a], Z[c] - Z[a]
  local nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
  local sx, sy, sz = x - X[a], y - Y[a], z - Z[a]
  local n2 = nx * nx + ny * ny + nz * nz
  local second = ((uy * sz - uz * sy) * nx + (uz * sx - ux * sz) * ny + (ux * sy - uy * sx) * nz) / n2
  local first = ((sy * vz - sz * vy) * nx + (sz * vx - sx * vz) * ny + (sx * vy - sy * vx) * nz) / n2
  if first >= 0 and second >= 0 and first + second <= 1 then return abs(sx * nx + sy * ny + sz * nz) / sqrt(n2) end
  return min(to_edge(a, b), to_edge(b, c), to_edge(c, a))
end

-- The same of points {x, y, z}, the border counted as outside.
local function volume(a, b, c, d)
  local ux, uy, uz, vx, vy, vz = a[1] - d[1], a[2] - d[2], a[3] - d[3], b[1] - d[1], b[2] - d[2], b[3] - d[3]
  return ux * (vy * (c[3] - d[3]) - vz * (c[2] - d[2])) + uy * (vz * (c[1] - d[1]) - vx * (c[3] - d[3])) + uz * (vx * (c[2] - d[2]) - vy * (c[1] - d[1]))
end
function brute.cuts(p, q, a, b, c)
  local vp, vq = volume(a, b, c, p), volume(a, b, c, q)
  if vp * vq >= 0 then return false end
  local function apart(u, v) return (u[1] - v[1]) ^ 2 + (u[2] - v[2]) ^ 2 + (u[3] - v[3]) ^ 2 end
  if abs(vp - vq) <= 1e-9 * sqrt(apart(p, q) * apart(a, b) * apart(a, c)) then return false end -- parallel: others meet its ends and edges
  local s, u, v = volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)
  return s * u > 0 and u * v > 0
end

-- Edges in the cells of a grid that their boxes touch; calls found(edge, facet) where boxes meet.
function brute.each_near(x, edges, y, facets, size, found)
  local cells = {}
  local function each_cell(low, high, visit)
    for i = floor(low[1] / size), floor(high[1] / size) do
      for j = floor(low[2] / size), floor(high[2] / size) do
        for k = floor(low[3] / size), floor(high[3] / size) do visit((i * 73856093) ~ (j * 19349663) ~ (k * 83492791)) end
      end
    end
  end
  local low, high = { 0, 0, 0 }, { 0, 0, 0 }
  for e, edge in ipairs(edges) do
    local p, q = x[edge[1]], x[edge[2]]
    for k = 1, 3 do low[k], high[k] = min(p[k], q[k]), max(p[k], q[k]) end
    each_cell(low, high, function(key)
      local list = cells[key]
      if list then list[#list + 1] = e else cells[key] = { e } end
    end)
  end
  for t, f in ipairs(facets) do
    local a, b, c = y[f[1]], y[f[2]], y[f[3]]
    for k = 1, 3 do low[k], high[k] = min(a[k], b[k], c[k]), max(a[k], b[k], c[k]) end
    local l1, l2, l3, h1, h2, h3 = low[1], low[2], low[3], high[1], high[2], high[3]
    local seen = {}
    each_cell(low, high, function(key)
      for _, e in ipairs(cells[key] or {}) do
        if not seen[e] then
          seen[e] = true
          local p, q = x[edges[e][1]], x[edges[e][2]]
          if max(p[1], q[1]) >= l1 and min(p[1], q[1]) <= h1 and max(p[2], q[2]) >= l2 and min(p[2], q[2]) <= h2 and max(p[3], q[3]) >= l3 and min(p[3], q[3]) <= h3 then
            found(e, t)
          end
        end
      end
    end)
  end
end

function brute.of_point(p, a, b, c) -- distance of a point and a triangle
  return distance({ a[1], b[1], c[1] }, { a[2], b[2], c[2] }, { a[3], b[3], c[3] }, p[1], p[2], p[3], 1, 2, 3)
end

local function of_segments(p, q, a, b) -- distance of two segments
  local d1, d2, r = sub(q, p), sub(b, a), sub(p, a)
  local aa, ee, f, c, bb = dot(d1, d1), dot(d2, d2), dot(d2, r), dot(d1, r), dot(d1, d2)
  local det = aa * ee - bb * bb
  local s = det > 1e-18 * aa * ee and max(0, min(1, (bb * f - c * ee) / det)) or 0
  local t = (bb * s + f) / ee
  if t < 0 then t, s = 0, max(0, min(1, -c / aa)) elseif t > 1 then t, s = 1, max(0, min(1, (bb - c) / aa)) end
  local sum = 0
  for k = 1, 3 do sum = sum + (r[k] + s * d1[k] - t * d2[k]) ^ 2 end
  return sqrt(sum)
end

function brute.of_rod(p, q, a, b, c) -- distance of a segment and a triangle
  if brute.cuts(p, q, a, b, c) then return 0 end
  return min(brute.of_point(p, a, b, c), brute.of_point(q, a, b, c), of_segments(p, q, a, b), of_segments(p, q, b, c), of_segments(p, q, c, a))
end

-- Whether a point is in a closed surface: by the solid angles of its facets.
function brute.encloses(y, facets, p)
  local sum = 0
  for _, f in ipairs(facets) do
    local r, l = {}, {}
    for k = 1, 3 do
      r[k] = sub(y[f[k]], p)
      l[k] = sqrt(dot(r[k], r[k]))
    end
    local a, b, c = r[1], r[2], r[3]
    sum = sum + 2 * math.atan(dot(a, cross(b, c)), l[1] * l[2] * l[3] + dot(a, b) * l[3] + dot(b, c) * l[1] + dot(c, a) * l[2])
  end
  return abs(sum) > 2 * math.pi
end

-- The mesh of a model with tearable zones, whose elements have nodes of their own at their corners, with `place`, which names for each node the first
-- one where it is.
function brute.apart(mesh)
  local out, known = { nodes = mesh.nodes, elements = mesh.elements, place = {} }, {}
  for n = 1, #mesh.nodes do
    local p = mesh.nodes[n]
    local key = ("%.17g %.17g %.17g"):format(p[1], p[2], p[3])
    known[key] = known[key] or n
    out.place[n] = known[key]
  end
  return out
end

-- A watch over a run: balls = { {body=, radius=}, ... }, planes = { {point=, normal=}, ... } that stand. Returns a function that looks
-- at the run as it is and returns a list of texts, one for each place where something has passed. Of a mesh of brute.apart, what was at one place lies
-- on each other and is not looked at.
function brute.watch(mesh, balls, planes)
  balls, planes = balls or {}, planes or {}
  local place = type(mesh) == "table" and mesh.place or setmetatable({}, { __index = function(_, n) return n end })
  local triangles = brute.triangles(mesh, brute.middle(mesh.nodes))
  local edges = brute.edges(triangles)
  local X, Y, Z, moved, quantum = {}, {}, {}, 0, nil
  -- Pairs are numbered (edge - 1) * n_triangles + triangle. due[k]: the pairs to be looked at when the nodes have moved by k quanta in all.
  local due = {}
  local n_edges, n_triangles = #edges, #triangles

  -- Reads the positions and adds the largest motion of a node, twice since both of a pair may move. True the first time.
  local function read(run)
    local now, most = run:field "position", 0
    local first = X[1] == nil
    if not first then
      local dx, dy, dz = 0, 0, 0 -- what all have in common moves nothing through anything
      for i, p in ipairs(now) do dx, dy, dz = dx + p[1] - X[i], dy + p[2] - Y[i], dz + p[3] - Z[i] end
      dx, dy, dz = dx / #now, dy / #now, dz / #now
      for i, p in ipairs(now) do most = max(most, (p[1] - X[i] - dx) ^ 2 + (p[2] - Y[i] - dy) ^ 2 + (p[3] - Z[i] - dz) ^ 2) end
    end
    for i, p in ipairs(now) do X[i], Y[i], Z[i] = p[1], p[2], p[3] end
    moved = moved + 2 * sqrt(most)
    return first
  end

  local function look_again_after(pair, motion)
    local key = floor((moved + motion) / quantum)
    local list = due[key]
    if not list then
      list = {}
      due[key] = list
    end
    list[#list + 1] = pair
  end

  local function begin()
    local e = edges[1]
    quantum = sqrt((X[e[1]] - X[e[2]]) ^ 2 + (Y[e[1]] - Y[e[2]]) ^ 2 + (Z[e[1]] - Z[e[2]]) ^ 2) / 100
    for i = 1, n_edges do
      local p, q = place[edges[i][1]], place[edges[i][2]]
      for k = 1, n_triangles do
        local t = triangles[k]
        local a, b, c = place[t[1]], place[t[2]], place[t[3]]
        if p ~= a and p ~= b and p ~= c and q ~= a and q ~= b and q ~= c then
          look_again_after((i - 1) * n_triangles + k, apart(X, Y, Z, edges[i][1], edges[i][2], t[1], t[2], t[3]))
        end
      end
    end
  end

  local next_key = 0
  local function look_at_pairs(found)
    local last = floor(moved / quantum)
    for key = next_key, last do
      local list = due[key]
      due[key] = nil
      for _, pair in ipairs(list or {}) do
        local i = (pair - 1) // n_triangles + 1
        local e, t = edges[i], triangles[pair - (i - 1) * n_triangles]
        local s = apart(X, Y, Z, e[1], e[2], t[1], t[2], t[3])
        if not (s > 0) and cuts(X, Y, Z, e[1], e[2], t[1], t[2], t[3]) then
          found[#found + 1] = string.format("the edge of nodes %d, %d goes through the triangle of nodes %d, %d, %d", e[1], e[2], t[1], t[2], t[3])
        end
        look_again_after(pair, s)
      end
    end
    next_key = last
  end

  local ball_due = {}
  for i = 1, #balls do ball_due[i] = { left = 0 } end
  local function look_at_balls(run, found)
    for i, ball in ipairs(balls) do
      local x, y, z = run:body(ball.body)
      local own = ball_due[i]
      local most = 0
      for k = 1, own.X and #X or 0 do most = max(most, (X[k] - own.X[k] - x + own.x) ^ 2 + (Y[k] - own.Y[k] - y + own.y) ^ 2 + (Z[k] - own.Z[k] - z + own.z) ^ 2) end
      if not own.X or sqrt(most) >= own.left then
        local least, at = huge, nil
        for _, t in ipairs(triangles) do
          local d = distance(X, Y, Z, x, y, z, t[1], t[2], t[3])
          if d < least then least, at = d, t end
        end
        own.left, own.x, own.y, own.z = least - ball.radius, x, y, z
        own.X, own.Y, own.Z = table.move(X, 1, #X, 1, {}), table.move(Y, 1, #Y, 1, {}), table.move(Z, 1, #Z, 1, {})
        if not (least > ball.radius) then
          found[#found + 1] = string.format("the triangle of nodes %d, %d, %d is %g m inside a ball", at[1], at[2], at[3], ball.radius - least)
        end
      end
    end
  end

  local function look_at_planes(found)
    for _, plane in ipairs(planes) do
      local p, n = plane.point, plane.normal
      for i = 1, #X do
        local h = (X[i] - p[1]) * n[1] + (Y[i] - p[2]) * n[2] + (Z[i] - p[3]) * n[3]
        if not (h > 0) then found[#found + 1] = string.format("node %d is %g m behind a plane", i, -h) end
      end
    end
  end

  return function(run)
    local found = {}
    if read(run) then begin() end
    look_at_pairs(found)
    look_at_balls(run, found)
    look_at_planes(found)
    return found
  end
end

return brute
