-- A bundle of yarns whose strengths scatter, pulled between stiff grips: those that are left share the load alike. With strengths x_1 <= ... <= x_n (N) of
-- yarns of one stiffness it carries at most max_k (n - k + 1) x_k [daniels1945]. Yarns are strips of their own here, one element wide, so that nothing passes
-- from one to the next, and each breaks in the middle.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("[^/]*$", "common.lua")))
local checks = common.checks()
local mm = fabric.units.mm

local n, wide, long, stiff, modulus, scale = 16, 1 * mm, 20 * mm, 4e4, 4, 4e3 -- stiff, scale: N/m; Weibull modulus of the strengths
local sheet = common.sheet { warp = stiff / (0.5 * mm), weft = stiff / (0.5 * mm), shear = stiff / mm, poisson = { 0, 0 }, thickness = 0.5 * mm }

-- Numbers from 0 to 1, by the method of Lehmer with the multiplier of Park and Miller.
local state = 20261
local function chance()
  state = state * 16807 % 2147483647
  return state / 2147483647
end

local function bundle(strengths)
  local nodes, elements, x, sets = {}, {}, 0, { bottom = {}, top = {}, middle = {} }
  for i = 1, n do
    for j = 0, 2 do
      for k = 0, 1 do
        nodes[#nodes + 1] = { x + k * wide, j * long / 2, 0 }
        local set = j == 0 and "bottom" or j == 2 and "top" or "middle"
        table.insert(sets[set], #nodes)
      end
    end
    local first = 6 * (i - 1)
    for j = 0, 1 do elements[#elements + 1] = { first + 2 * j + 1, first + 2 * j + 2, first + 2 * j + 4, first + 2 * j + 3 } end
    x = x + 2 * wide
  end
  local mesh = fabric.mesh { nodes = nodes, elements = elements }
  for name, ids in pairs(sets) do mesh:set(name, ids) end
  local regions = {}
  for i, f in ipairs(strengths) do
    local name = "yarn " .. i
    mesh:set(name, function(px) return px > (2 * i - 2.5) * wide and px < (2 * i - 0.5) * wide end)
    -- A break costs far less energy than the yarn stores: it breaks at once.
    regions[name] = { card = sheet:with { rupture = { warp = { strength = f, energy = 0.11 } } } }
  end
  local m = fabric.model { mesh = mesh, card = sheet, regions = regions, warp = 90, membrane = true }
  local most = 0
  for _, f in ipairs(strengths) do most = math.max(most, f) end
  m:fix("all", "x z"):fix("bottom", "y"):move("top", { y = fabric.ramp(1.05 * most / stiff * long, 1) })
  return m:tearable("all", { coarse = "keep", path = "middle" })
end

local samples, sum, squares = 10, 0, 0
for sample = 1, samples do
  local strengths, sorted = {}, {}
  for i = 1, n do
    strengths[i] = scale * (-math.log(chance())) ^ (1 / modulus)
    sorted[i] = strengths[i]
  end
  table.sort(sorted)
  local most = 0
  for k = 1, n do most = math.max(most, (n - k + 1) * sorted[k] * wide) end
  local run = fabric.static { model = bundle(strengths), duration = 1, step = 0.02, ledger_limit = 1 }
  local peak = 0
  run:every("step", function(a) peak = math.max(peak, (select(2, a:reaction "top"))) end)
  run:solve()
  checks(("bundle %d: largest force, N"):format(sample), peak, most, { relative = 2e-3 })
  sum, squares = sum + peak, squares + peak ^ 2
end

-- For many yarns the strength over n goes to x* (1 - F(x*)), its largest value, with the deviation x* sqrt(F (1 - F) / n); for few its mean is higher by
-- 0.996 n^(-2/3) b, b^3 = f(x*)^2 x*^4 / (2 f(x*) + x* f'(x*)) [smith1982]. Weibull: F = 1 - exp(-z), z = (x / scale)^modulus, and z = 1 / modulus at x*.
local z = 1 / modulus
local at, left = scale * z ^ (1 / modulus), math.exp(-z)
local f = modulus / at * z * left                  -- density at x*
local slope = f / at * (modulus - 1 - modulus * z) -- of the density
local b = (f ^ 2 * at ^ 4 / (2 * f + at * slope)) ^ (1 / 3)
local mean = at * left + 0.996 * n ^ (-2 / 3) * b
local deviation = at * math.sqrt(left * (1 - left) / n)
-- Ten bundles have a mean that is known to its own deviation, and a deviation to 1 / sqrt(18): three of each are allowed.
checks("mean of the bundles over their width, N/m", sum / samples / (n * wide), mean, { absolute = 3 * deviation / math.sqrt(samples) })
checks("their deviation, N/m", math.sqrt((squares - sum ^ 2 / samples) / (samples - 1)) / (n * wide), deviation, { relative = 3 / math.sqrt(2 * (samples - 1)) })
checks()
