-- Bias pulls of yarns that stretch: what fabric.lab.bias_shear finds with yarns that do not stretch is too little, since part of the way is the yarns'. The pull is simulated with
-- the yarns' own curves and a curve in shear, which is changed until the simulated pull, evaluated as the measured one was, gives the same.
local fabric = require "fabric"
local define = require "fabric.define"

local knots, rounds, cells, steps = 8, 4, 4, 16

-- Value at x of the curve through the points, level outside.
local function at(xs, ys, x)
  if x <= xs[1] then return ys[1] end
  for i = 2, #xs do
    if x <= xs[i] then return ys[i - 1] + (ys[i] - ys[i - 1]) * (x - xs[i - 1]) / (xs[i] - xs[i - 1]) end
  end
  return ys[#ys]
end

-- The means of a curve about equally spaced strains.
local function thinned(E, S)
  local xs, ys, last = {}, {}, E[#E]
  for k = 1, knots do
    local x, sum, n = last * k / knots, 0, 0
    for i, e in ipairs(E) do
      if math.abs(e - x) <= last / knots / 4 then sum, n = sum + S[i], n + 1 end
    end
    xs[k], ys[k] = x, n > 2 and k < knots and sum / n or at(E, S, x)
  end
  return xs, ys
end

local function check(t)
  for name, partner in pairs { warp = "weft", weft = "warp" } do
    local yarn = t[name]
    if t[partner] and (not yarn or type(yarn.loading) ~= "table" or #yarn.loading == 0) then
      define.fail(("bias_shear: field '%s': expected {loading=} of the yarns, as warp or weft of a card, since %s is given, got %s"):format(name, partner,
        yarn and "a table without loading" or "nil"))
    end
  end
end

local function part(yarn) return { loading = yarn.loading, unloading = yarn.unloading, tested = yarn.tested or 0.3 } end

-- The apparent shear of a simulated pull, with stresses `S` at strains `E`.
local function simulated(t, E, S, way)
  local points, before = { { 0, 0 } }, 0
  for k, e in ipairs(E) do
    before = math.max(S[k], 1.001 * before)
    points[k + 1] = { e, before }
  end
  local ratio = {}
  for _, name in ipairs { "warp", "weft" } do
    local own = t[name].poisson
    ratio[name] = type(own) == "table" and own.value or own
  end
  local card = fabric.lab.card { name = "soft yarns", density = 500, thickness = t.thickness, warp = part(t.warp), weft = part(t.weft), shear = { loading = points, tested = 2 * E[#E] },
    poisson = ratio, assume = true }
  local pull = fabric.lab.bias_extension { card = card, width = t.width, length = t.length, displacement = way, cells = cells, steps = steps }
  local d, F = {}, {}
  for i, row in ipairs(pull.curve) do d[i], F[i] = row.displacement, row.force end
  return fabric.lab.bias_shear { displacement = d, force = F, width = t.width, length = t.length, thickness = t.thickness, limit = 90 }
end

-- t: the arguments of bias_shear; out: its result, which gets the yarns' stretch taken out where t.warp and t.weft are given.
return function(t, out)
  check(t)
  if not t.warp or #out.E12 < 3 then return out end
  local E, S = thinned(out.E12, out.S12)
  local factor, way = {}, t.displacement[out.rows[#out.rows]]
  for k = 1, knots do factor[k] = 1 end
  for _ = 1, rounds do
    local law = {}
    for k = 1, knots do law[k] = S[k] * factor[k] end
    local ok, found = pcall(simulated, t, E, law, way)
    if not ok then
      fabric.warn("bias_shear: the pull with yarns that stretch could not be simulated, and their stretch is not taken out: " .. tostring(found))
      return out
    end
    for k = 1, knots do factor[k] = math.min(3, math.max(1 / 3, factor[k] * S[k] / at(found.E12, found.S12, E[k]))) end
  end
  for i, e in ipairs(out.E12) do
    local f = at(E, factor, e)
    out.S12[i], out.normal_force[i] = f * out.S12[i], f * out.normal_force[i]
  end
  out.taken_out = factor[knots] - 1
  return out
end
