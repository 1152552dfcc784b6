-- A sheet hangs from its two upper corners, which come together: does the fold settle as the mesh is refined, and does it stay as it is where the elements are
-- turned by 45 degrees against yarns and edges?
--
--   fabricsh scripts/lab/two_corners.lua                    8 x 8 elements, straight and turned, two seeds
--   fabricsh scripts/lab/two_corners.lua "8 16 32" 3 out    meshes, seeds, pictures of the finest into out
local fabric = require "fabric"
local random = require "fabric.lab.random"
local mm = fabric.units.mm
local counts, seeds, out = arg[1] or "8", tonumber(arg[2] or 2), arg[3]
local side, closer = 0.15, 0.15 -- m, and the part of their distance by which the corners come together
local card = fabric.card "worsted"

-- Diamonds between every other point of a lattice of n x n steps, halved at the border: elements at 45 degrees. Nodes are written as a Wavefront file.
local function turned(n)
  local name = os.tmpname() .. ".obj"
  local file <close> = assert(io.open(name, "w"))
  local number, count = {}, 0
  for j = 0, n do
    for i = 0, n do
      if (i + j) % 2 == 0 then
        count = count + 1
        number[j * (n + 1) + i] = count
        file:write(("v %.17g %.17g 0\n"):format(side * i / n, side * j / n))
      end
    end
  end
  for j = 0, n do
    for i = 0, n do
      if (i + j) % 2 == 1 then
        local corners = {}
        for _, d in ipairs { { 0, -1 }, { 1, 0 }, { 0, 1 }, { -1, 0 } } do
          local a, b = i + d[1], j + d[2]
          if a >= 0 and a <= n and b >= 0 and b <= n then corners[#corners + 1] = number[b * (n + 1) + a] end
        end
        file:write("f " .. table.concat(corners, " ") .. "\n")
      end
    end
  end
  file:close()
  local mesh = fabric.mesh.read(name)
  os.remove(name)
  return mesh
end

-- The sheet stands upright, x to the right and z up; the cloth is uneven by a millimetre, in waves that the mesh has no part in.
local function hang(n, how, seed)
  local mesh = how == "turned" and turned(n) or fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n }
  local draw, waves = random(seed), {}
  for k = 1, 3 do
    waves[k] = {}
    for l = 1, 3 do waves[k][l] = draw.normal() / (k * k + l * l) end
  end
  mesh:map(function(x, y)
    local off = 2 * math.sin(math.pi * x / side) * (1 - y / side) -- which way the fold goes
    for k = 1, 3 do
      for l = 1, 3 do off = off + waves[k][l] * math.sin(k * math.pi * x / side) * math.cos(l * math.pi * y / side) end
    end
    return x, -off * 1e-3, y
  end)
  local function at(x, z) return function(a, _, c) return math.abs(a - x) < 1e-6 and math.abs(c - z) < 1e-6 end end
  mesh:set("left corner", at(0, side))
  mesh:set("right corner", at(side, side))
  local model = fabric.model { mesh = mesh, card = card, warp = function() return { 1, 0, 0 } end }
  model:fix("left corner", "x y z"):fix("right corner", "y z"):gravity { 0, 0, -9.81 }
  model:move("right corner", { x = function(t) return -closer * side * (t < 0.5 and (1 - math.cos(2 * math.pi * t)) / 2 or 1) end })
  local a = fabric.dynamic { model = model, duration = 1.6, damping = { mass = 8 } }
  a:solve()
  return a, mesh
end

-- What is compared, mm: how far the upper edge's and the lower edge's middle hang below the corners, and how far they stand out of the corners' plane.
local function numbers(a, mesh)
  local function place(x, z)
    for i, p in ipairs(mesh.nodes) do
      if math.abs(p[1] - x) < 1e-6 and math.abs(p[3] - z) < 1e-6 then return a:node(i) end
    end
  end
  local top, middle, bottom = place(side / 2, side), place(side / 2, side / 2), place(side / 2, 0)
  return { (side - top.z) / mm, (side - bottom.z) / mm, top.y / mm, middle.y / mm, bottom.y / mm }
end

local names = { "upper edge sinks", "lower edge hangs", "upper edge stands out", "middle stands out", "lower edge stands out" }
local mean, scatter, expected = {}, {}, {}
print "mesh          " 
for count in counts:gmatch "%d+" do
  local n = tonumber(count)
  for _, how in ipairs { "straight", "turned" } do
    local sum, squares, worst = { 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0 }, 0
    for seed = 1, seeds do
      local a, mesh = hang(n, how, seed)
      local v = numbers(a, mesh)
      for i, x in ipairs(v) do sum[i], squares[i] = sum[i] + x, squares[i] + x * x end
      worst = math.max(worst, a.energy.error)
      if out and seed == 1 then
        fabric.render { file = ("%s/two_corners_%d_%s.png"):format(out, n, how), run = a, field = "y", view = { 20, 20 }, width = 500, height = 450, axes = false,
          title = ("%d x %d, %s"):format(n, n, how) }
      end
      print(("%2d x %2d %-8s seed %d: %s, kinetic %.1e"):format(n, n, how, seed, table.concat(fabric.checking() and {} or { ("%.2f %.2f %.2f %.2f %.2f"):format(table.unpack(v)) }, " "), a.energy.kinetic))
    end
    local key = n .. how
    mean[key], scatter[key] = {}, {}
    for i = 1, 5 do
      mean[key][i] = sum[i] / seeds
      scatter[key][i] = seeds > 1 and math.sqrt(math.max(0, squares[i] - sum[i] ^ 2 / seeds) / (seeds - 1)) or 0
    end
    expected[#expected + 1] = { key .. ": ledger", worst, 0, absolute = 1e-3 }
  end
end
for key, m in pairs(mean) do for i = 1, 5 do print(key, names[i], m[i], scatter[key][i]) end end
fabric.expect(expected)
