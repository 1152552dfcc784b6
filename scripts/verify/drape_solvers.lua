-- A ring of cloth held at its inner edge hangs down in six folds: by Newton's method in statics, plain and stabilised, by relaxation in ten
-- shares of the weight and in one, and by damped implicit motion whose weight comes slowly or fast. The law remembers its path, so slow motion
-- ends near where statics does, and fast motion, or all of the weight at once, elsewhere. Where Newton's method has followed a path past a
-- bifurcation, its last tangent has negative pivots: that shape is an equilibrium, but not one that cloth stays in; relaxation leaves it.
--
--   fabricsh scripts/verify/drape_solvers.lua                          28 x 3 elements, statics and relaxation
--   fabricsh scripts/verify/drape_solvers.lua "28x3 36x4 54x6" slow    three meshes, also slow motion; "all": fast motion as well (an hour)
local fabric = require "fabric"
local shadow = require "fabric.lab.virtual.shadow"
local g = 9.80665
local meshes, all = arg[1] or "28x3", arg[2] == "all"
local slow = all or arg[2] == "slow"
local inner, outer = 0.09, 0.15
local card = fabric.card("blend"):with { bending = { warp = 15e-6, weft = 15e-6, twist = 7e-6 } }

local function ring(around, across)
  local mesh = fabric.mesh.annulus { inner = inner, outer = outer, around = around, across = across }
  return mesh:map(function(x, y, z) -- a perfect ring would not know where to fold
    local r = math.sqrt(x * x + y * y)
    return x, y, z + 1e-3 * ((r - inner) / (outer - inner)) ^ 2 * math.cos(6 * math.atan(y, x))
  end)
end

local function run(mesh, analysis, over, options)
  local model = fabric.model { mesh = mesh, card = card, warp = 0 }
  model:fix("inner", "x y z rotation"):gravity { 0, 0, function(t) return -g * (t < over and (1 - math.cos(math.pi * t / over)) / 2 or 1) end }
  options.model = model
  return fabric[analysis](options):solve()
end

-- Potential energy (stored, and the weight's), J; drape coefficient; folds.
local function reading(a, mesh)
  local x, y, z, X, Y = a:field "x", a:field "y", a:field "z", {}, {}
  for i, p in ipairs(mesh.nodes) do X[i], Y[i] = p[1], p[2] end
  local weight = 0
  for _, n in ipairs(shadow.triangles(mesh)) do
    local area = ((X[n[2]] - X[n[1]]) * (Y[n[3]] - Y[n[1]]) - (X[n[3]] - X[n[1]]) * (Y[n[2]] - Y[n[1]])) / 2
    weight = weight + math.abs(area) * card.density * card.thickness * g * (z[n[1]] + z[n[2]] + z[n[3]]) / 3
  end
  local whole = shadow.of(X, Y, shadow.triangles(mesh), inner)
  local area, outline = shadow.of(x, y, shadow.triangles(mesh), inner)
  local ground = math.pi * inner ^ 2
  return a.energy.stored + weight, (area - ground) / (whole - ground), (shadow.folds(outline, 0.03 * (outer - inner)))
end

local ways = {
  { "Newton", "static", 0.3, { duration = 0.3, step = 0.015, max_cuts = 16 }, may_fail = true },
  { "Newton, stabilised", "static", 0.3, { duration = 0.3, step = 0.015, max_cuts = 16, stabilise = 1e-4 } },
  { "relaxation, 10 shares", "static", 0.3, { duration = 0.3, step = 0.03, method = "relaxation", tolerance = 1e-6 } },
  { "relaxation, all at once", "static", 1e-6, { duration = 0.3, step = 0.3, method = "relaxation", tolerance = 1e-6 }, told = true },
}
if slow then
  ways[5] = { "implicit motion, weight over 2 s", "dynamic", 2, { duration = 2.5, scheme = "implicit", step = 5e-3, damping = { mass = 20 } } }
end
if all then
  ways[6] = { "implicit motion, weight over 0.3 s", "dynamic", 0.3, { duration = 1.5, scheme = "implicit", step = 2e-3, damping = { mass = 10 } }, told = true }
end

local expected = {}
print "mesh    solver                               energy/mJ   coefficient/%   folds   stable"
for around, across in meshes:gmatch "(%d+)x(%d+)" do
  local base, unstable
  for _, way in ipairs(ways) do
    local mesh = ring(tonumber(around), tonumber(across))
    local options = {}
    for k, v in pairs(way[4]) do options[k] = v end
    local ok, a = pcall(run, mesh, way[2], way[3], options)
    if not ok and not way.told and not way.may_fail then error(a, 0) end
    if not ok then
      print(("%-6s  %-35s  no answer: %s"):format(around .. "x" .. across, way[1], tostring(a):match "^[^\n]*"))
    elseif not fabric.checking() then
      local energy, coefficient, folds = reading(a, mesh)
      local pivots = way[2] == "static" and a.steps[#a.steps].negative_pivots or 0
      print(("%-6s  %-35s  %9.5f   %9.2f   %9d   %s"):format(around .. "x" .. across, way[1], 1e3 * energy, 100 * coefficient, folds, pivots > 0 and "no" or "yes"))
      -- The shape compared is the one that cloth stays in: Newton's, if its tangent is positive, or else that of relaxation.
      local own = not base and pivots == 0
      if own then base = { energy, coefficient } end
      if not way.told then
        local name = ("%sx%s, %s: "):format(around, across, way[1])
        if pivots > 0 then
          unstable = energy
        elseif not own then
          expected[#expected + 1] = { name .. "energy", energy, base[1], relative = 0.01 }
          expected[#expected + 1] = { name .. "coefficient, points", 100 * coefficient, 100 * base[2], absolute = 1.5 }
        end
        if pivots == 0 and unstable then
          expected[#expected + 1] = { name .. "energy below that of the unstable shape (1: yes)", energy < unstable and 1 or 0, 1, absolute = 0 }
        end
        expected[#expected + 1] = { name .. "six folds", folds, 6, absolute = 0 }
      end
    end
  end
end
fabric.expect(expected)
