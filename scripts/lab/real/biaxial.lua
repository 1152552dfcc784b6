-- Biaxial records of a coated glass fabric at several load ratios [uhlemann2011]: crimp that goes from one yarn to the other, fitted to all ratios but one and
-- to all; the ratio left out and a further one predicted with a band; what the law of a card with its one biaxial spring makes of the same records, and a card.
--
--   fabricsh scripts/lab/real/biaxial.lua [out] [file] [ratio]        ratio: a further one to be predicted, default 1:2
--
-- The file has the columns ratio (warp:weft), n_w, n_f (kN/m), eps_w, eps_f (%). It is not part of the program: the default is ../shared/data/biaxial beside
-- this checkout, or the deck says SKIPPED.
local fabric = require "fabric"
local lab = fabric.lab

local out = arg[1] or "out/biaxial"
local path = arg[2] or (arg[0]:match "^(.*)scripts/" or "") .. "../shared/data/biaxial/uhlemann-2011-T2.csv"
local file = io.open(path)
if not file then
  print "SKIPPED: the records are not beside this checkout, in ../shared/data"
  return
end
local asked = arg[3] or "1:2"
local share_w, share_f = asked:match "^([%d.]+):([%d.]+)$"
if not share_w then error("usage: fabricsh biaxial.lua [out] [file] [ratio such as 1:2]", 0) end
if fabric.checking() then return end

-- Loads in kN/m and strains in % of each ratio; every ratio's strains count from its first row.
local ratios, rows = {}, {}
for line in file:lines() do
  local ratio, n_w, n_f, w, f = line:match "^([%d.]+:[%d.]+),([^,]+),([^,]+),([^,]+),([^,]+)$"
  if ratio then
    if not rows[ratio] then ratios[#ratios + 1], rows[ratio] = ratio, { n_w = {}, n_f = {}, load = {}, warp = {}, weft = {} } end
    local r = rows[ratio]
    local k = #r.load + 1
    r.n_w[k], r.n_f[k], r.warp[k], r.weft[k] = tonumber(n_w), tonumber(n_f), tonumber(w), tonumber(f)
    r.load[k] = math.max(r.n_w[k], r.n_f[k])
  end
end
file:close()
if #ratios < 3 then error(("biaxial: %s: expected three load ratios at least, got %d"):format(path, #ratios), 0) end

-- Crimp interchange. Amplitudes a_w and a_f of the two waves, in units in which the crimp of the warp is a_w^2: pulling the warp straight by z lifts the weft
-- by z. Strains beside the yarns' own stretch n/E are a_w^2 - (a_w - z)^2 and b (a_f^2 - (a_f + z)^2), and z is where the work of the loads balances a
-- spring k z^2/2 of what resists (coating, bending). Yarns that flatten by y = c min(n_w (a_w - z), b n_f (a_f + z)), the force between them, lose it on both sides.
local function crimp(p, n_w, n_f)
  local z = 2 * (p.a_w * n_w - p.b * p.a_f * n_f) / (p.k + 2 * n_w + 2 * p.b * n_f)
  local y = p.c * math.min(n_w * (p.a_w - z), p.b * n_f * (p.a_f + z))
  return p.f_w * n_w + 2 * p.a_w * (z + y) - (z + y) ^ 2, p.f_f * n_f + p.b * (2 * p.a_f * (y - z) - (y - z) ^ 2)
end
local function strains(p, test)
  local w0, f0 = crimp(p, test.n_w[1], test.n_f[1])
  local list = {}
  for k, n_w in ipairs(test.n_w) do
    local w, f = crimp(p, n_w, test.n_f[k])
    list[k] = test.yarn == "warp" and w - w0 or f - f0
  end
  return list
end
local parameters = {
  { name = "f_w", start = 0.02, low = 0, high = 0.3 }, { name = "f_f", start = 0.01, low = 0, high = 0.3 }, -- % per kN/m
  { name = "a_w", start = 1.6, low = 0.3, high = 6 }, { name = "a_f", start = 1.9, low = 0.3, high = 6 },
  { name = "b", start = 1.3, low = 0.1, high = 10 }, { name = "k", start = 35, low = 0.5, high = 400 }, { name = "c", start = 3e-3, low = 0, high = 0.1 },
}

-- Two lists for each ratio. The error of the model grows from nothing at the first row as strains do, about with the root of the load.
local function scale_of(load)
  local scale = {}
  for k, n in ipairs(load) do scale[k] = math.sqrt(math.max(n - load[1], 0.01) / 30) end
  return scale
end
local tests = {}
for _, ratio in ipairs(ratios) do
  local r = rows[ratio]
  for _, yarn in ipairs { "warp", "weft" } do
    tests[#tests + 1] = { name = ratio .. " " .. yarn, ratio = ratio, yarn = yarn, measured = r[yarn], noise = 0.1, x = r.load, scale = scale_of(r.load),
      n_w = r.n_w, n_f = r.n_f }
  end
end
local pool = lab.pool { parameters = parameters, tests = tests, model = strains, groups = { "ratio" }, processes = 1, iterations = 200 }
print "crimp that goes from one yarn to the other, seven numbers; strains in %:"
print(pool.text)
local checks = {}
local function end_of(p, k, far)
  if far ~= "" then return ("%.2f, no band: %s"):format(p.predicted[k], far) end
  return p.low and ("%.2f, %.2f to %.2f"):format(p.predicted[k], p.low[k], p.high[k]) or ("%.2f, no band: %s"):format(p.predicted[k], p.reason)
end
-- The direction of the loads in degrees, 0: warp alone, 90: weft alone. Beyond those of the others nothing was pulled straight that is pulled there.
local function direction(ratio)
  local w, f = ratio:match "^([%d.]+):([%d.]+)$"
  return math.deg(math.atan(tonumber(f), tonumber(w)))
end
local function beyond(ratio)
  local low, high = math.huge, -math.huge
  for _, other in ipairs(ratios) do
    if other ~= ratio then low, high = math.min(low, direction(other)), math.max(high, direction(other)) end
  end
  local own = direction(ratio)
  return (own < low - 1e-9 or own > high + 1e-9) and "this ratio lies beyond those of the others" or ""
end
for _, held in ipairs(pool.left_out_by.ratio) do
  for _, yarn in ipairs { "warp", "weft" } do
    local own, n = held.tests[held.label .. " " .. yarn], #rows[held.label].load
    local far = beyond(held.label)
    print(("%s from the others, %s: at the end %s, measured %.2f%s"):format(held.label, yarn, end_of(own, n, far), rows[held.label][yarn][n], own.inside
      and (", %.0f %% of the points in the band%s"):format(100 * own.inside, far ~= "" and " of ratios between the others, which is not given here" or "") or ""))
  end
end

-- The further ratio, at the loads of the first, with the larger load as large.
local most = math.max(tonumber(share_w), tonumber(share_f))
local first = rows[ratios[1]]
local curves = {}
for _, yarn in ipairs { "warp", "weft" } do
  local test = { yarn = yarn, ratio = asked, x = first.load, scale = scale_of(first.load), n_w = {}, n_f = {} }
  for k, n in ipairs(first.load) do test.n_w[k], test.n_f[k] = n * share_w / most, n * share_f / most end
  local p = pool:predict(test)
  local far = beyond(asked)
  if far ~= "" then p.low, p.high = nil, nil end
  print(("%s predicted, %s: at the end %s"):format(asked, yarn, end_of(p, #first.load, far)))
  curves[#curves + 1] = { x = first.load, y = p.predicted, label = asked .. " " .. yarn .. (p.low and ", predicted, 95 % band" or ", predicted"),
    style = yarn == "weft" and "dashed" or "line", band = p.low and { low = p.low, high = p.high } or nil }
  if rows[asked] then curves[#curves + 1] = { x = rows[asked].load, y = rows[asked][yarn], label = asked .. " " .. yarn .. ", measured", style = "points" } end
end
fabric.plot { file = out .. "/predicted.svg", xlabel = "larger load, kN/m", ylabel = "strain, %", curves = curves }

-- The same records by the law of a card: loads that its strains call for (kN/m beyond the first row). Two yarns that give way to compression, coupling with nu12 nu21 < 1, and one biaxial spring:
-- a potential of E11 + alpha E22, stiff along the line on which the crimp goes from one yarn to the other. It is convex, so that it makes no energy. Loads of 30 kN/m at y = 1.5 % of
-- this sum ask for q of about 3e11 Pa on a millimetre, and a spring that starts without load never finds it: the search begins near this size.
local thickness = 1e-3
local function card_of(p, spring)
  local function yarn(d0, d1, ratio) return { loading = { 10 ^ d0, 10 ^ d1 }, unloading = 4 * (10 ^ d0 + 0.06 * 10 ^ d1), poisson = ratio } end
  local nu = 10 ^ p.nu
  return fabric.woven { name = "coated-glass", source = "[uhlemann2011], biaxial test T2, by the biaxial spring; thickness, density and shear assumed", density = 1200,
    thickness = thickness, warp = yarn(p.w0, p.w1, p.coupling * nu), weft = yarn(p.f0, p.f1, p.coupling / nu), shear = { loading = { 20e6 }, unloading = 60e6 },
    biaxial = spring and { alpha = 10 ^ p.alpha, offset = p.offset, loading = 10 ^ p.q, unloading = 0.025 * 10 ^ p.q } or nil }
end
local function loads(card, r, yarn)
  local E11, E22 = {}, {}
  for k, w in ipairs(r.warp) do
    local f = r.weft[k]
    E11[k], E22[k] = w / 100 + (w / 100) ^ 2 / 2, f / 100 + (f / 100) ^ 2 / 2
  end
  local S = fabric.point(card):path({ E11 = E11, E22 = E22 }, { yarn == "warp" and "S11" or "S22" })[yarn == "warp" and "S11" or "S22"]
  local n = {}
  for k, s in ipairs(S) do n[k] = s * thickness * (1 + r[yarn][k] / 100) / 1e3 end
  return n
end
local own = { { name = "w0", start = 8, low = 5, high = 10 }, { name = "w1", start = 10.5, low = 5, high = 12 }, { name = "f0", start = 6.5, low = 5, high = 10 },
  { name = "f1", start = 10.5, low = 5, high = 12 }, { name = "nu", start = 0, low = -0.6, high = 0.6 }, { name = "coupling", start = 0.7, low = 0.05, high = 0.97 } }
local sprung = table.move(own, 1, #own, 1, {})
for _, p in ipairs { { name = "alpha", start = -0.15, low = -1, high = 1 }, { name = "offset", start = 0, low = 0, high = 0.05 }, { name = "q", start = 11.5, low = 8, high = 13 } } do
  sprung[#sprung + 1] = p
end
local in_loads = {}
for _, ratio in ipairs(ratios) do
  local r = rows[ratio]
  for _, yarn in ipairs { "warp", "weft" } do
    local n, measured = yarn == "warp" and r.n_w or r.n_f, {}
    for k, x in ipairs(n) do measured[k] = x - n[1] end
    in_loads[#in_loads + 1] = { name = ratio .. " " .. yarn, ratio = ratio, yarn = yarn, rows = r, measured = measured, noise = 1 }
  end
end
-- The fit to all ratios but one (or to all), and the root of the mean square of the loads of a ratio (or of all).
local function fit_law(spring, without)
  local list = {}
  for _, test in ipairs(in_loads) do
    if test.ratio ~= without then
      list[#list + 1] = { name = test.name, measured = test.measured, noise = 1, predict = function(p) return loads(card_of(p, spring), test.rows, test.yarn) end }
    end
  end
  return lab.identify { parameters = spring and sprung or own, tests = list, processes = 1, iterations = spring and 300 or 60 }
end
local function rms_of(card, ratio)
  local squares, count = 0, 0
  for _, test in ipairs(in_loads) do
    if test.ratio == ratio or not ratio then
      for k, n in ipairs(loads(card, test.rows, test.yarn)) do squares, count = squares + (n - test.measured[k]) ^ 2, count + 1 end
    end
  end
  return math.sqrt(squares / count)
end
local rms = {}
for i, spring in ipairs { false, true } do
  local found = fit_law(spring)
  print(("law of a card, %s:"):format(spring and "one biaxial spring" or "no biaxial spring"))
  print(found.text)
  local card = card_of(found.parameters, spring)
  rms[i] = rms_of(card)
  local words = {}
  for _, ratio in ipairs(ratios) do words[#words + 1] = ("%s %.1f"):format(ratio, rms_of(card, ratio)) end
  print(("rms of the loads: %.2f kN/m of 30; %s"):format(rms[i], table.concat(words, ", ")))
  if spring then found:card(function(p) return card_of(p, true) end):write(out .. "/card.lua") end
end
for _, ratio in ipairs(ratios) do
  local card = card_of(fit_law(true, ratio).parameters, true)
  local far = beyond(ratio)
  print(("%s by the card of the others: rms of the loads %.1f kN/m%s"):format(ratio, rms_of(card, ratio), far ~= "" and "; " .. far or ""))
end
checks[#checks + 1] = { "all ratios by crimp interchange: rms over the deviation of 0.1 %", math.sqrt(pool.chi2), 0, absolute = 3 }
checks[#checks + 1] = { "one spring: rms of the loads, kN/m", rms[2], 0, absolute = 1.5 }
fabric.expect(checks)
