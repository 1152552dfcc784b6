-- A sheet hangs from its two upper corners, which come together: does the fold settle as the mesh is refined, and does it stay as it is where the elements are
-- turned by 45 degrees against yarns and edges?
--
--   fabricsh scripts/lab/two_corners.lua                    8 x 8 elements, straight and turned, four seeds
--   fabricsh scripts/lab/two_corners.lua "8 16 32" 3 out    meshes, seeds, pictures of the finest into out
-- warns: locks where yarns are pulled
-- warns: the guard of the directors has
local fabric = require "fabric"
local random = require "fabric.lab.random"
local mm = fabric.units.mm
local counts, seeds, out_folder = arg[1] or "8", math.max(2, tonumber(arg[2] or 4)), arg[3]
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

-- The numbers compared, mm: how far the upper edge's and the lower edge's middle hang below the corners, and how far they stand out of the corners' plane.
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
print "mesh, sheet: upper edge sinks, lower edge hangs; upper edge, middle, lower edge stand out; mm"
local expected, last = {}, nil

-- Means and deviations over the sheets.
local function sheets(n, how)
  local values, out = {}, { mean = {}, scatter = {} }
  for seed = 1, seeds do
    local a, mesh = hang(n, how, seed)
    if fabric.checking() then return end
    values[seed] = numbers(a, mesh)
    print(("%2d x %2d %-8s %d: %7.2f %7.2f %7.2f %7.2f %7.2f"):format(n, n, how, seed, table.unpack(values[seed])))
    expected[#expected + 1] = { ("%d x %d, %s, sheet %d: ledger"):format(n, n, how, seed), a.energy.error, 0, absolute = 1e-3 }
    if out_folder and seed == 1 then
      fabric.render { file = ("%s/two_corners_%d_%s.png"):format(out_folder, n, how), run = a, field = "y", view = { 20, 20 }, width = 500, height = 450, axes = false,
        title = ("%d x %d, %s"):format(n, n, how) }
    end
  end
  for i = 1, #names do
    local sum, squares = 0, 0
    for _, v in ipairs(values) do sum = sum + v[i] / seeds end
    for _, v in ipairs(values) do squares = squares + (v[i] - sum) ^ 2 end
    out.mean[i], out.scatter[i] = sum, math.sqrt(squares / (seeds - 1))
  end
  return out
end

for count in counts:gmatch "%d+" do
  local n = tonumber(count)
  local straight, other = sheets(n, "straight"), sheets(n, "turned")
  for i, name in ipairs(straight and names or {}) do
    local scatter = math.sqrt((straight.scatter[i] ^ 2 + other.scatter[i] ^ 2) / seeds)
    expected[#expected + 1] = { ("%d x %d: %s, turned against straight, mm, within twice the scatter"):format(n, n, name), other.mean[i], straight.mean[i],
      absolute = 2 * scatter }
    -- From 16 to 32 elements the fold has settled to two hundredths of the side, beside the scatter.
    if last and n >= 32 then
      local both = math.sqrt((straight.scatter[i] ^ 2 + last.scatter[i] ^ 2) / seeds)
      expected[#expected + 1] = { ("%d x %d: %s, against the coarser mesh, mm"):format(n, n, name), straight.mean[i], last.mean[i],
        absolute = 0.02 * side / mm + 2 * both }
    end
  end
  last = straight
end
fabric.expect(expected)
