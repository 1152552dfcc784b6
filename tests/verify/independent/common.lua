-- Shared by the decks of this folder: an integrator, a root finder, cards, single nodes as sets, the list of checks. Nothing here uses a formula
-- of the program; a deck says local common = dofile(...) "common.lua".
local fabric = require "fabric"
local common = {}

-- The classical Runge-Kutta method for y' = f(x, y), y a list, from x0 to x1 in n steps.
function common.integrate(f, x0, x1, y, n)
  local h, size = (x1 - x0) / n, #y
  local function moved(slope, part)
    local out = {}
    for i = 1, size do out[i] = y[i] + part * slope[i] end
    return out
  end
  for k = 0, n - 1 do
    local x = x0 + k * h
    local a = f(x, y)
    local b = f(x + h / 2, moved(a, h / 2))
    local c = f(x + h / 2, moved(b, h / 2))
    local d = f(x + h, moved(c, h))
    local out = {}
    for i = 1, size do out[i] = y[i] + h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) end
    y = out
  end
  return y
end

-- The zero of f between two places where its signs differ, by halving.
function common.root(f, low, high)
  local at_low = f(low) > 0
  assert(at_low ~= (f(high) > 0), "no change of sign between the two ends")
  for _ = 1, 100 do
    local middle = (low + high) / 2
    if (f(middle) > 0) == at_low then low = middle else high = middle end
  end
  return (low + high) / 2
end

-- The zero of f(x), x and f lists of the same length, by Newton's method with differences.
function common.solve(f, x, scale)
  for _ = 1, 60 do
    local r, n = f(x), #x
    local worst, K = 0, {}
    for i = 1, n do K[i], worst = {}, math.max(worst, math.abs(r[i])) end
    if worst < 1e-13 then return x end
    for j = 1, n do
      local there, h = { table.unpack(x) }, 1e-7 * scale[j]
      there[j] = there[j] + h
      local s = f(there)
      for i = 1, n do K[i][j] = (s[i] - r[i]) / h end
    end
    for i = 1, n do -- Gauss, with pivots
      local p = i
      for k = i + 1, n do
        if math.abs(K[k][i]) > math.abs(K[p][i]) then p = k end
      end
      K[i], K[p], r[i], r[p] = K[p], K[i], r[p], r[i]
      for k = i + 1, n do
        local m = K[k][i] / K[i][i]
        for l = i, n do K[k][l] = K[k][l] - m * K[i][l] end
        r[k] = r[k] - m * r[i]
      end
    end
    local d = {}
    for i = n, 1, -1 do
      local sum = r[i]
      for l = i + 1, n do sum = sum - K[i][l] * d[l] end
      d[i] = sum / K[i][i]
    end
    local share = 1
    for j = 1, n do share = math.min(share, scale[j] / math.max(math.abs(d[j]), 1e-300)) end
    for j = 1, n do x[j] = x[j] - share * d[j] end
  end
  return x
end

-- A linear (St. Venant-Kirchhoff) sheet: an isotropic one of Young's modulus E, or what `more` says.
function common.sheet(more)
  local t = { name = "sheet", density = 500, thickness = 0.4e-3, poisson = 0, through_thickness = true }
  for key, value in pairs(more) do t[key] = value end
  return fabric.svk(t)
end

-- A set of its own for every node of a mesh, so that each can be moved by itself: calls visit(name, {X, Y, Z}, number).
function common.each(mesh, visit)
  for i = 1, #mesh.nodes do
    local name = "node " .. i
    mesh:set(name, { i })
    visit(name, mesh.nodes[i], i)
  end
end

-- The number of the node nearest to a point.
function common.nearest(mesh, x, y, z)
  local best, found = math.huge, nil
  for i = 1, #mesh.nodes do
    local p = mesh.nodes[i]
    local d = (p[1] - x) ^ 2 + (p[2] - y) ^ 2 + (p[3] - (z or 0)) ^ 2
    if d < best then best, found = d, i end
  end
  return found
end

-- A mesh whose inner nodes are moved by up to `share` of the spacing, differently each, but always the same.
function common.distorted(mesh, width, height, nx, ny, share)
  return mesh:map(function(x, y, z)
    local inside = x > 1e-9 and x < width - 1e-9 and y > 1e-9 and y < height - 1e-9
    if not inside then return x, y, z end
    local i, j = x / width * nx, y / height * ny
    return x + share * width / nx * math.sin(12.9 * i + 7.3 * j), y + share * height / ny * math.sin(4.1 * i - 9.7 * j), z
  end)
end

-- Times at which a value passes zero upwards: between the steps by a straight line. period() is the mean of all.
function common.crossings()
  local times, last_time, last = {}, nil, nil
  return {
    see = function(time, value)
      if last and last < 0 and value >= 0 then times[#times + 1] = last_time - last * (time - last_time) / (value - last) end
      last_time, last = time, value
    end,
    period = function() return (times[#times] - times[1]) / (#times - 1) end,
  }
end

-- checks(name, got, want, {relative= or absolute=}) notes a row; checks() judges them.
function common.checks()
  local rows = {}
  return function(name, got, want, how)
    if name then
      rows[#rows + 1] = { name, got, want, relative = how.relative, absolute = how.absolute }
    elseif not fabric.checking() then
      fabric.expect(rows)
    end
  end
end

return common
