-- The loading of fabric.lab.fit where first contact is uncertain: curves averaged over laws and over places of contact (kernels.averaged), as a polynomial or points of a card with the
-- band that follows from both, from the noise and from the differences of specimens.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local linear = require "fabric.lab.common.linear"
local loading = require "fabric.lab.common.loading"
local lists = require "fabric.lists"
local fail = define.fail

local strains = 40
local close = 0.3    -- of half the band: a polynomial of a card that is nearer to the averaged curve takes its place
local small = 0.004  -- of the largest stress, likewise
local ends = 20      -- points of a curve that no polynomial describes
local nothing = 2e-4 -- of the length: slack that is none
local differ = 0.05  -- relative deviation of specimens, where there is one: a guess

local averaged = {}

local function column(a, i) return a.specimens[i].S end

local function mean_of(a)
  local out = {}
  for g = 1, #a.E do
    out[g] = 0
    for _, s in ipairs(a.specimens) do out[g] = out[g] + s.S[g] / #a.specimens end
  end
  return out
end

-- Half the width of the band of the mean curve at each strain.
local function half_widths(a, mean, level)
  local n, half, G = #a.specimens, {}, #a.E
  local normal = fabric.lab.normal((1 + level) / 2)
  for g = 1, G do
    local place = (g - 1) * G + g
    if n == 1 then
      half[g] = normal * math.sqrt(a.within[place] + (differ * mean[g]) ^ 2)
    else
      local sum = 0
      for i = 1, n do sum = sum + (column(a, i)[g] - mean[g]) ^ 2 end
      half[g] = math.sqrt(fabric.lab.student((1 + level) / 2, n - 1) ^ 2 * sum / (n - 1) / n + normal ^ 2 * a.common[place])
    end
  end
  return half
end

-- Half widths by which a polynomial is measured: of two or three specimens the band is wide for want of knowledge of their differences, which is no leave to miss their mean.
local function near_widths(half, n, level)
  local part = (1 + level) / 2
  local least = n > 1 and math.min(1, fabric.lab.student(part, 3) / fabric.lab.student(part, n - 1)) or 1
  return lists.map(half, function(h) return least * h end)
end

-- The operator that takes stresses at the strains to the coefficients of a polynomial through zero, by least squares weighted by `deviation`.
local function polynomial_operator(E, deviation, degree)
  local top, A, rows = E[#E], linear.zeros(degree), {}
  for g, e in ipairs(E) do
    rows[g] = {}
    for k = 1, degree do rows[g][k] = (e / top) ^ k end
    for k = 1, degree do
      for l = 1, degree do A[k][l] = A[k][l] + rows[g][k] * rows[g][l] / deviation[g] ^ 2 end
    end
  end
  local inverse, out = linear.inverse(A), {}
  for k = 1, degree do
    out[k] = {}
    for g = 1, #E do
      local sum = 0
      for l = 1, degree do sum = sum + inverse[k][l] * rows[g][l] end
      out[k][g] = sum / deviation[g] ^ 2 * k / top ^ k
    end
  end
  return out
end

-- The same for points: the stresses at some of the strains.
local function points_operator(E)
  local out, places = {}, {}
  for k = 1, ends do
    local place = math.floor(k * #E / ends + 0.5)
    places[k], out[k] = place, {}
    for g = 1, #E do out[k][g] = g == place and 1 or 0 end
  end
  return out, places
end

local function applied(operator, values)
  local out = {}
  for k, row in ipairs(operator) do
    out[k] = 0
    for g, w in ipairs(row) do out[k] = out[k] + w * values[g] end
  end
  return out
end

-- operator C operator^T, flat.
local function carried(operator, C, G)
  local n, half, out = #operator, {}, {}
  for k = 1, n do
    half[k] = {}
    for g = 1, G do
      local sum = 0
      for j = 1, G do sum = sum + operator[k][j] * C[(j - 1) * G + g] end
      half[k][g] = sum
    end
  end
  for k = 1, n do
    for l = 1, n do
      local sum = 0
      for g = 1, G do sum = sum + half[k][g] * operator[l][g] end
      out[(k - 1) * n + l] = sum
    end
  end
  return out
end

-- Whether a polynomial stays near the averaged curve and rises all the way.
local function describes(d, E, mean, half)
  local peak, top = mean[#mean], E[#E]
  for g, e in ipairs(E) do
    if math.abs(loading.stress(d, e) - mean[g]) > math.max(close * half[g], small * peak * math.min(1, 4 * e / top)) then return false end
  end
  for i = 0, 100 do
    if not (loading.tangent(d, top * i / 100) > 0) then return false end
  end
  return true
end

local function rising(values)
  for k = 2, #values do
    if values[k] <= values[k - 1] then return false end
  end
  return values[1] > 0
end

-- Means of neighbouring points that fall, each a little above the one before [barlow1972].
local function made_to_rise(values)
  local blocks = {}
  for _, v in ipairs(values) do
    blocks[#blocks + 1] = { sum = v, n = 1 }
    while #blocks > 1 and blocks[#blocks - 1].sum / blocks[#blocks - 1].n >= blocks[#blocks].sum / blocks[#blocks].n do
      local b = table.remove(blocks)
      blocks[#blocks].sum, blocks[#blocks].n = blocks[#blocks].sum + b.sum, blocks[#blocks].n + b.n
    end
  end
  local out, step = {}, 1e-4 * math.abs(values[#values]) / #values
  for _, b in ipairs(blocks) do
    for _ = 1, b.n do out[#out + 1] = math.max(b.sum / b.n, (out[#out] or 0) + step) end
  end
  return out
end

-- How far a polynomial that was asked for misses the averaged curve, in words; nil if it describes it.
local function missed(d, E, mean, half)
  if describes(d, E, mean, half) then return end
  local worst, place = 0, 1
  for g, e in ipairs(E) do
    local apart = math.abs(loading.stress(d, e) - mean[g])
    if apart > worst then worst, place = apart, g end
  end
  return ("the polynomial of degree %d that was asked for does not describe the mean: it misses it by up to %.2g %% of the largest stress, at E = %.3g"):format(#d,
    100 * worst / mean[#mean], E[place])
end

-- Adds to the covariance of a polynomial's coefficients what its misfit leaves open: other misfits of this size along the curve, of one sign or of another at either end,
-- would have moved them so.
local function with_misfit(more, operator, E, mean)
  local d, n = applied(operator, mean), #operator
  local all, half = {}, {}
  for g, e in ipairs(E) do
    all[g] = math.abs(mean[g] - loading.stress(d, e))
    half[g] = (2 * g < #E and 1 or -1) * all[g]
  end
  for _, rest in ipairs { all, half } do
    local v = applied(operator, rest)
    for k = 1, n do
      for l = 1, n do more[(k - 1) * n + l] = more[(k - 1) * n + l] + v[k] * v[l] end
    end
  end
  return more
end

-- The form of the card's loading: degree (nil: points), operator, places. Where the band reaches below zero, points are chosen: most polynomials that are drawn from it would fall somewhere,
-- while points that are drawn can be made to rise.
local function form_of(t, a, mean, half, band)
  if t.degree == "auto" then
    for g = 1, #mean do
      if band[g] >= mean[g] then return nil, points_operator(a.E) end
    end
  end
  local deviation, peak = {}, mean[#mean]
  for g in ipairs(a.E) do deviation[g] = math.sqrt(half[g] ^ 2 + (0.002 * peak) ^ 2) end
  for _, degree in ipairs(type(t.degree) == "number" and { t.degree } or t.degree == "auto" and { 2, 4, 6 } or {}) do
    local operator = polynomial_operator(a.E, deviation, degree)
    if t.degree == degree or describes(applied(operator, mean), a.E, mean, half) then return degree, operator end
  end
  return nil, points_operator(a.E)
end

local function flat(n) return fabric.lab.band { specimens = { n }, level = 0.95 } end

-- {value, low, high, covariance} of lists of parameters, whose first ones have the further covariance of the records.
local function band_of(t, parameters, more, common)
  local n, m, size = #parameters, #parameters[1], math.floor(math.sqrt(#more) + 0.5)
  local normal = fabric.lab.normal((1 + t.level) / 2)
  local band, quantile
  if n == 1 then
    band, quantile = flat(parameters[1]), normal
    band.covariance, band.low, band.high = {}, {}, {}
    for i = 1, m do
      for j = 1, m do band.covariance[(i - 1) * m + j] = (differ ^ 2 + t.common ^ 2) * band.value[i] * band.value[j] end
    end
  else
    band, quantile = fabric.lab.band { specimens = parameters, level = t.level, seed = t.seed, draws = t.draws, common = common }, fabric.lab.student((1 + t.level) / 2, n - 1)
  end
  for i = 1, size do
    for j = 1, size do
      band.covariance[(i - 1) * m + j] = band.covariance[(i - 1) * m + j] + more[(i - 1) * size + j] * (normal / quantile) ^ 2
    end
  end
  for i = 1, m do
    local half = quantile * math.sqrt(math.max(0, band.covariance[(i - 1) * m + i]))
    band.low[i], band.high[i] = band.value[i] - half, band.value[i] + half
  end
  return band
end

local function percent(x) return ("%.3g"):format(100 * x) end

-- Which laws, and where contact begins, in words.
local function words_of(a, t)
  local laws, lines = {}, {}
  for i, law in ipairs(a.laws) do
    if i <= 5 and law.weight > 0.01 then laws[#laws + 1] = ("%s %.0f %%"):format(law.name, 100 * law.weight) end
  end
  lines[1] = "laws of the loading and their weights: " .. table.concat(laws, ", ")
  local none = 0
  for i, s in ipairs(a.specimens) do
    none = none + s.none / #a.specimens
    lines[#lines + 1] = ("specimen %d: contact after %s %% of the length, %s to %s"):format(i, percent(s.slack), percent(s.slack_low), percent(s.slack_high))
  end
  local sure, tight, before = true, true, true
  for _, s in ipairs(a.specimens) do
    sure, before = sure and s.slack_low > nothing and s.none < 0.1, before and s.slack_high < -nothing
    tight = tight and (s.none > 0.9 or math.max(math.abs(s.slack_low), math.abs(s.slack_high)) <= nothing)
  end
  lines[#lines + 1] = before and "the records begin under load, after contact" or sure and "there was slack" or tight and "there was none"
    or ("slack or none, the data do not decide which is right (none: %.0f %%), the band holds both"):format(100 * none)
  if a.correlation > 0.5 then lines[#lines + 1] = ("neighbouring residuals are alike (correlation %.2f): no law describes the records to their noise, and their points count as fewer"):format(a.correlation) end
  return table.concat(lines, "\n")
end

-- The loading of the curves {E, S}: nil where no law rises; else { text, degree, tested, specimens, complete(unloading_of) -> loading, band }.
function averaged.of(t, curves, earliest)
  local a = kernels.averaged { curves = curves, none = t.find_slack == "either" and 0.1 or 0, earliest = earliest, strains = strains }
  if #a.E == 0 then
    if type(t.degree) == "number" then fail "fit: expected a positive tangent from zero to the end of the test" end
    return
  end
  local mean = mean_of(a)
  local half = half_widths(a, mean, t.level)
  local near = near_widths(half, #a.specimens, t.level)
  local degree, operator, places = form_of(t, a, mean, near, half)
  local out = { degree = degree, tested = a.E[#a.E], text = words_of(a, t), specimens = {}, E = a.E, S = mean, half = half }
  if not degree then out.text = out.text .. ("\nno polynomial of degree 2, 4 or 6 describes the mean and its band: %d points of a monotone curve instead"):format(ends) end
  local miss = type(t.degree) == "number" and missed(applied(operator, mean), a.E, mean, near)
  if miss then out.text = out.text .. "\n" .. miss end
  local parameters = {}
  for i, s in ipairs(a.specimens) do
    parameters[i] = applied(operator, s.S)
    out.specimens[i] = { loading = degree and table.move(parameters[i], 1, #parameters[i], 1, {}) or nil, slack = s.slack, slack_low = s.slack_low, slack_high = s.slack_high, reach = s.reach, residual = s.residual }
  end
  function out.complete(unloading)
    local common = {}
    for i, list in ipairs(parameters) do list[#operator + 1] = unloading[i] end
    for i = 1, #parameters[1] do common[i] = t.common end
    local more = carried(operator, #curves == 1 and a.within or a.common, #a.E)
    local band = band_of(t, parameters, degree and with_misfit(more, operator, a.E, mean) or more, common)
    local loading = table.move(band.value, 1, #operator, 1, {})
    if not degree then
      if not rising(loading) then loading = made_to_rise(loading) end
      for k, S in ipairs(loading) do
        local moved = S - band.value[k]
        band.value[k], band.low[k], band.high[k] = S, band.low[k] + moved, band.high[k] + moved
      end
      local points = { { 0.0, 0.0 } }
      for k, S in ipairs(loading) do points[k + 1] = { a.E[places[k]], S } end
      loading = points
    end
    return loading, band
  end
  return out
end

return averaged
