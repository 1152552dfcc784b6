-- fabric.budget: the uncertainty of any number that a deck computes, from its mesh, its steps, its card and its specimen [gum2008].
--
-- run(p) is called at the middle of everything on each mesh and with each step, and on the coarsest mesh with the longest step for cards that
-- are drawn. The variance over those is shared out by indices of first and of total order [saltelli2010]: with draws A and B of all inputs, and
-- A with input i from B, the same specimens and numbers being in each pair, so that differences are not lost in scatter.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local fail = define.fail
local assumed = require "fabric.assumed"
local random = require "fabric.lab.random"
local lists = require "fabric.lists"
local convergence = require "fabric.lab.common.convergence"
local tests_for = require "fabric.lab.card.tests_for"

local level, boots = 0.95, 400

local function quantile(list, part)
  local ascending = table.move(list, 1, #list, 1, {})
  table.sort(ascending)
  return lists.quantile(ascending, part)
end

-- --- inputs: { name, put(p, i, set) }, which puts the value of draw i of set 1 or 2 into p

-- A part of the card from its confidence band.
local function band_inputs(t, card, list)
  local draws
  for _, part in ipairs { "warp", "weft", "shear", "bending", "biaxial" } do
    if card.bands and card.bands[part] then
      draws = draws or card:sample(2 * t.samples, t.seed)
      list[#list + 1] = { name = "card." .. part, range = "its band", put = function(p, i, set)
        local from = draws[(set - 1) * t.samples + i][part]
        p.changes[#p.changes + 1] = function(c) return c:with { [part] = from, bands = { [part] = false } } end -- the band is of the fit, not of a draw
      end }
    end
  end
end

-- Assumptions of the card, and those that the deck adds. A range of factors is uniform in its logarithm.
local function assumed_inputs(t, card, list)
  local function add(input, points)
    points.n = points.n + 1
    local place = points.n
    local by_factor = input.apply and input.value == 1 and input[1] > 0
    list[#list + 1] = { name = "assumed." .. input.name, range = ("%.3g to %.3g"):format(input[1], input[2]) .. (by_factor and " times" or ""), why = input.why,
      put = function(p, i, set)
        local u = points.at(i, set, place)
        local value = by_factor and input[1] * (input[2] / input[1]) ^ u or input[1] + (input[2] - input[1]) * u
        p.assumed[input.name] = value
        if input.apply then p.changes[#p.changes + 1] = function(c) return input.apply(c, value) end end
      end }
  end
  local all, others = {}, {}
  if card then all, others = assumed.of(card) end
  local by_name = {}
  for _, input in ipairs(all) do by_name[input.name] = input end
  for name, range in pairs(t.assumed or {}) do
    if type(name) ~= "string" or type(range) ~= "table" or type(range[1]) ~= "number" or type(range[2]) ~= "number" or not (range[1] <= range[2]) then
      fail(("budget: field 'assumed.%s': expected {low, high} with low <= high"):format(tostring(name)))
    end
    if by_name[name] then
      by_name[name][1], by_name[name][2], by_name[name].why = range[1], range[2], "the deck"
    else
      all[#all + 1] = { range[1], range[2], name = name, why = "the deck" }
    end
  end
  table.sort(all, function(a, b) return a.name < b.name end)
  local points = { n = 0 }
  local numbers = #all > 0 and kernels.sobol_points(t.samples, 2 * #all, t.seed)
  function points.at(i, set, place) return numbers[(i - 1) * 2 * #all + (set - 1) * #all + place] end
  for _, input in ipairs(all) do add(input, points) end
  return others
end

-- --- runs

-- The table that run(p) gets; `used` receives the names that it reads.
local function question(card, values, used)
  return setmetatable({}, { __index = function(_, name)
    if used then used[name] = true end
    if name == "card" then return card end
    return values[name]
  end })
end

-- A run at the middle of everything: the card as it is, and of the ranges that the deck gives their middles.
local function middle(t)
  local values = { mesh = t.mesh and t.mesh[1], step = t.steps and t.steps[1], specimen = 1, changes = {}, assumed = {} }
  for name, range in pairs(t.assumed or {}) do values.assumed[name] = (range[1] + range[2]) / 2 end
  return values
end

-- The relative error of a run's stresses in the energy norm: recovered less computed, the mean over its elements by their areas.
local function error_of(analysis)
  if type(analysis) ~= "userdata" then error("budget: p.analysis: expected the run, got a " .. type(analysis), 0) end
  local mesh, sum, whole = analysis.model.mesh, 0, 0
  local nodes, elements = mesh.nodes, mesh.elements
  for e, share in ipairs(analysis:field "error") do
    local x, cross = {}, {}
    for i, n in ipairs(elements[e]) do x[i] = nodes[n] end
    for k = 1, 3 do
      local i, j, last = k % 3 + 1, (k + 1) % 3 + 1, x[4] or x[1]
      cross[k] = (x[3][i] - x[1][i]) * (last[j] - x[2][j]) - (x[3][j] - x[1][j]) * (last[i] - x[2][i])
    end
    local area = math.sqrt(cross[1] ^ 2 + cross[2] ^ 2 + cross[3] ^ 2)
    sum, whole = sum + area * share ^ 2, whole + area
  end
  return math.sqrt(sum / whole)
end

-- Numbers by name; and the error of the stresses, if run(p) has put its run into p.analysis.
local function answer(t, values, used)
  local card = t.card
  for _, change in ipairs(values.changes) do card = change(card) end
  local p = question(card, values, used)
  local result = t.run(p)
  if type(result) ~= "table" or next(result) == nil then error("budget: expected run(p) to return numbers by name, got " .. (type(result) == "table" and "none" or "a " .. type(result)), 0) end
  for name, value in pairs(result) do
    if type(name) ~= "string" or type(value) ~= "number" or value ~= value then
      error(("budget: expected run(p) to return numbers by name, got %s = %s"):format(tostring(name), tostring(value)), 0)
    end
  end
  local analysis = rawget(p, "analysis")
  return result, analysis and not fabric.checking() and error_of(analysis) or nil
end

-- All runs: at the middle on each mesh and with each step, then A, B and, for the shares, A with input i of B for each sample.
local function plan(t, inputs)
  local jobs = {}
  for i = 2, t.mesh and #t.mesh or 1 do
    local values = middle(t)
    values.mesh = t.mesh[i]
    jobs[#jobs + 1] = values
  end
  for i = 2, t.steps and #t.steps or 1 do
    local values = middle(t)
    values.step = t.steps[i]
    jobs[#jobs + 1] = values
  end
  local numerical = #jobs
  if #inputs > 0 then
    for i = 1, t.samples do
      for of_b = -1, t.shares and #inputs or 0 do -- -1: A; 0: B; k: A with input k of B
        local values = middle(t)
        for k, input in ipairs(inputs) do input.put(values, i, (of_b == 0 or of_b == k) and 2 or 1) end
        jobs[#jobs + 1] = values
      end
    end
  end
  return jobs, numerical
end

local function compute(t, jobs, names)
  local answers = fabric.lab.parallel { count = #jobs, processes = t.processes, progress = "budget", collect = true, work = function(i)
    local row, result, wrong = {}, answer(t, jobs[i])
    for k, name in ipairs(names) do
      if result[name] == nil then error(("budget: run(p) returned no '%s' this time"):format(name), 0) end
      row[k] = result[name]
    end
    row[#names + 1] = wrong or -1
    return row
  end }
  return answers
end

-- Warnings of the runs: { {code, text, runs}, ... }, texts that differ in their numbers alone counting as one, the first of which is given.
local function counted(answers)
  local list, by_key = {}, {}
  for _, answer in ipairs(answers) do
    local seen = {}
    for _, w in ipairs(answer.warnings or {}) do
      local key = w.code .. " " .. w.text:gsub("%-?%d[%d%.eE+-]*", "#")
      if not by_key[key] then
        by_key[key] = { code = w.code, text = w.text, runs = 0 }
        list[#list + 1] = by_key[key]
      end
      by_key[key].runs = by_key[key].runs + (seen[key] and 0 or 1)
      seen[key] = true
    end
  end
  return list
end

-- --- evaluation

-- Where the values of a list of meshes or steps go: elements along a side are sizes the other way round.
local function limit_of(kind, sizes, values)
  local h = lists.map(sizes, function(size) return kind == "mesh" and 1 / size or size end)
  return convergence.of(h, values)
end

-- Mean and variance of rows {A, B, AB_1, AB_2, ...}, over A and B.
local function moments(rows)
  local n, sum, variance = 2 * #rows, 0, 0
  for _, row in ipairs(rows) do sum = sum + row[1] + row[2] end
  local m = sum / n
  for _, row in ipairs(rows) do variance = variance + (row[1] - m) ^ 2 / (n - 1) + (row[2] - m) ^ 2 / (n - 1) end
  return { rows = rows, mean = m, variance = variance }
end

-- Indices of first and total order of one input from rows with their moments: [saltelli2010], (b) and (f) of table 2, of which both are
-- zero for an input without effect. With few samples a first order above the total is scatter.
local function indices(of, k)
  local rows, m, variance, first, total = of.rows, of.mean, of.variance, 0, 0
  if variance == 0 then return 0, 0 end
  local n, place = #rows, 2 + k
  for i = 1, n do
    local row = rows[i]
    local a, ab = row[1], row[place]
    first = first + (row[2] - m) * (ab - a) / n
    total = total + (a - ab) ^ 2 / (2 * n)
  end
  return math.min(first, total) / variance, total / variance
end

local function variance_of(list)
  local m, sum = lists.mean(list), 0
  for _, v in ipairs(list) do sum = sum + (v - m) ^ 2 end
  return sum / (#list - 1)
end

-- The same with 95 % bands by the bootstrap over rows; and whether inputs act together, which the sums of both orders, 1 without, must show beyond their bands.
local function indices_with_bands(rows, inputs, seed)
  local draw, out, alone, all = random(seed), {}, {}, {}
  local whole, resampled = moments(rows), {}
  for b = 1, boots do
    local list, n, uniform = {}, #rows, draw.uniform
    for i = 1, n do list[i] = rows[math.min(n, 1 + math.floor(n * uniform()))] end
    resampled[b], alone[b], all[b] = moments(list), 0, 0
  end
  for k = 1, #inputs do
    local first, total = {}, {}
    for b = 1, boots do
      first[b], total[b] = indices(resampled[b], k)
      alone[b], all[b] = alone[b] + first[b], all[b] + total[b]
    end
    local s, st = indices(whole, k)
    out[k] = { first = s, total = st, variance = whole.variance,
      first_band = { quantile(first, 0.025), quantile(first, 0.975) }, total_band = { quantile(total, 0.025), quantile(total, 0.975) } }
  end
  return out, quantile(alone, 0.975) < 1 and quantile(all, 0.025) > 1
end

-- The budget of one number. rows: of the samples, without those that failed; errors: of the stresses on the meshes, or none.
local function budget_of(t, inputs, base, numerical, rows, errors)
  local out = { contributions = {} }
  local function add(source, deviation, more)
    local c = more or {}
    c.source, c.deviation = source, deviation
    out.contributions[#out.contributions + 1] = c
    return c
  end
  local value, place, shift = base, 0, 0
  for _, kind in ipairs { "mesh", "steps" } do
    local sizes = t[kind]
    if sizes and #sizes > 1 then
      local values = { base }
      for i = 2, #sizes do values[i] = numerical[place + i - 1] end
      place = place + #sizes - 1
      local found = limit_of(kind, sizes, values)
      if kind == "mesh" and found.untold and errors[#sizes] then found.deviation = math.max(found.deviation, math.abs(found.value) * errors[#sizes]) end
      shift = shift + found.value - base
      add(kind == "steps" and "step" or kind, found.deviation, { order = found.order, values = values, untold = found.untold, limit = found.value })
    elseif kind == "mesh" and errors[1] then -- a number may be wrong by as much as the stresses
      add("mesh", math.abs(base) * errors[1], { range = "error of the stresses" })
    end
  end
  value = value + shift
  local from_numbers, variance, own = 0, 0, 0
  for _, c in ipairs(out.contributions) do from_numbers = from_numbers + c.deviation ^ 2 end
  local below, above = 0, 0
  local all = {}
  if #rows > 0 then
    for _, row in ipairs(rows) do all[#all + 1], all[#all + 2] = row[1], row[2] end
    below, above = base - quantile(all, (1 - level) / 2), quantile(all, (1 + level) / 2) - base
    local found, together = {}, false
    if t.shares then found, together = indices_with_bands(rows, inputs, t.seed) end
    for k, index in ipairs(found) do
      local part = together and math.max(index.first, 0) or index.total
      variance, own = index.variance, own + part
      index.range, index.why = inputs[k].range, inputs[k].why
      add(inputs[k].name, math.sqrt(part * variance), index)
    end
    if not t.shares then
      variance = variance_of(all)
      local only = #inputs == 1 and inputs[1] -- all of the variance is its own
      add(only and only.name or "inputs", math.sqrt(variance), { range = only and only.range or "all together", why = only and only.why })
    elseif own > 0 and (own > 1 or not together) then -- indices have errors of their own: they share the variance
      for _, c in ipairs(out.contributions) do if c.first then c.deviation = c.deviation / math.sqrt(own) end end
    elseif variance > 0 then
      add("together", math.sqrt((1 - own) * variance), { range = "interactions" })
    end
  end
  local whole = from_numbers + variance
  for _, c in ipairs(out.contributions) do c.share = whole > 0 and c.deviation ^ 2 / whole or 0 end
  table.sort(out.contributions, function(a, b) return a.deviation > b.deviation or a.deviation == b.deviation and a.source < b.source end)
  local expanded = 1.96 * math.sqrt(from_numbers)
  local function half(side) return math.sqrt(math.max(side, 0) ^ 2 + expanded ^ 2) end
  out.value, out.coarsest, out.deviation = value, base, math.sqrt(whole)
  out.band = { low = value - half(below), high = value + half(above) }
  return out
end

-- Numbers of which the meshes or steps do not tell where they go, a line each.
local function untold_of(result, names)
  local out = {}
  for _, name in ipairs(names) do
    for _, c in ipairs(result.of[name].contributions) do
      if c.untold then
        local list = lists.map(c.values, function(v) return ("%.5g"):format(v) end)
        out[#out + 1] = ("%s: the %s do not tell where it goes (%s): the value is that of the last, and the band a guess from their spread; %s"):format(name,
          c.source == "mesh" and "meshes" or "steps", table.concat(list, ", "), c.source == "mesh" and "finer ones may" or "shorter ones may")
      end
    end
  end
  return out
end

-- Tests that would narrow an interval: the assumptions that make a tenth of the variance and more, the largest first, with the test that would determine each and the width that would then be
-- left, over the present one; a line each. Inputs of the deck's own are the deck's to know.
local function narrower_of(result, names)
  local out = {}
  for _, name in ipairs(names) do
    for _, c in ipairs(result.of[name].contributions) do
      local field = c.source:match "^assumed%.(.*)"
      local test = field and c.first and c.share >= 0.1 and (tests_for[field] or field == "poisson" and tests_for["warp.poisson"])
      if test then out[#out + 1] = { name = name, field = field, test = test, width = math.sqrt(math.max(0, 1 - c.share)) } end
    end
  end
  return out
end

-- Contradictions of the card's records to its law, by the words of its provenance (found:card of fabric.lab.identify and pool).
local function contradictions_of(card)
  local out, provenance = {}, card and card.provenance or {}
  for _, field in ipairs(lists.keys(provenance)) do
    local words = provenance[field]:match "the data contradict the model.*"
    if words then out[#out + 1] = ("card.%s: %s; a test unlike those of the records may be missed by more"):format(field:match "^[^.]+", words) end
  end
  return out
end

-- The interval of a fitted field that no band of a card holds, by the words of its provenance.
local function unheld_by(card, field) return (card.provenance and card.provenance[field] or ""):match "(interval of .-); no band of a card holds it" end

-- --- words and picture

local function text_of(t, result, names)
  local lines = {}
  local function say(...) lines[#lines + 1] = (...):format(select(2, ...)) end
  for _, name in ipairs(names) do
    local b = result.of[name]
    if b.band.high > b.band.low then
      say("%s = %.5g, 95 %% between %.5g and %.5g (standard uncertainty %.2g)", name, b.value, b.band.low, b.band.high, b.deviation)
    else
      say("%s = %.5g, without an interval: %s", name, b.value, result.runs > 1 and "nothing that was varied changes it" or "nothing was varied")
    end
    say("  %-24s %11s %8s  %-22s %-22s %s", "source", "deviation", "share/%", "first order (95 %)", "total (95 %)", "range")
    for _, c in ipairs(b.contributions) do
      local function index(kind) return c[kind] and ("%5.2f (%5.2f to %.2f)"):format(c[kind], c[kind .. "_band"][1], c[kind .. "_band"][2]) or "" end
      local range = c.range or c.untold and "no order" or c.order and (#c.values == 2 and "order 1 taken" or ("order %.1f"):format(c.order)) or ""
      say("  %-24s %11.3g %8.1f  %-22s %-22s %s", c.source, c.deviation, 100 * c.share, index "first", index "total", c.why and range .. ": " .. c.why or range)
    end
  end
  if #result.mesh_errors > 0 then
    local list = lists.map(result.mesh_errors, function(v) return ("%.2g"):format(v) end)
    say("stresses on the mesh%s: recovered less computed, over the whole: %s", #list > 1 and "es" or "", table.concat(list, ", "))
  end
  local function at(kind) return t[kind] and ("%s %s"):format(kind == "steps" and "step" or kind, tostring(t[kind][1])) or nil end
  local where, there = table.concat({ at "mesh" or at "steps", at "mesh" and at "steps" or nil }, ", "), {}
  for i, name in ipairs(names) do there[i] = ("%s = %.5g"):format(name, result.of[name].coarsest) end
  if t.mesh and #t.mesh > 1 or t.steps and #t.steps > 1 then where = where .. " (the coarsest, where " .. table.concat(there, ", ") .. ")" end
  if result.runs > 0 then
    say("%d runs%s, %d samples%s", result.runs, where ~= "" and ", samples with " .. where or "", t.samples,
      result.failed > 0 and (", %d of them left out because a run of theirs failed: %s"):format(result.failed, result.trouble) or "")
  end
  for _, words in ipairs(result.untold) do say("%s", words) end
  for _, words in ipairs(result.contradictions) do say("%s", words) end
  for _, one in ipairs(result.narrower) do
    say("to narrow %s: %s by %s; with it known the interval would be about %.2g times as wide", one.name, one.field, one.test, one.width)
  end
  for _, one in ipairs(result.sample_warnings) do say("%s in %d of %d runs: %s", one.code, one.runs, result.runs - 1, one.text) end
  for _, name in ipairs(result.not_varied) do
    local kept = unheld_by(t.card, name)
    say("not varied: %s, which %s", name, kept and "no band of the card holds: " .. kept or "the card assumes")
  end
  return table.concat(lines, "\n")
end

-- A bar for each source, the largest on top, with the 95 % interval of its total order. Contributions of less than a thousandth are left out.
local function draw(result, names, file)
  local panels, most = {}, 1
  for _, name in ipairs(names) do
    local curves, sources, shown, whole = {}, {}, {}, result.of[name].deviation ^ 2
    for i, c in ipairs(result.of[name].contributions) do
      if c.share >= 1e-3 or i == 1 then shown[#shown + 1] = c end
    end
    local ends = { x = {}, y = {}, style = "points", colour = "blue", xerror = { low = {}, high = {} } }
    for i, c in ipairs(shown) do
      local place, scale = #shown + 1 - i, c.variance and whole > 0 and 100 * c.variance / whole
      sources[place] = c.source
      curves[i] = { x = { 0, 100 * c.share }, y = { place, place }, colour = "blue" }
      ends.x[i], ends.y[i] = 100 * c.share, place
      ends.xerror.low[i] = scale and math.max(0, scale * c.total_band[1]) or 0 / 0
      ends.xerror.high[i] = scale and math.min(100, scale * c.total_band[2]) or 0 / 0
    end
    curves[#curves + 1] = ends
    most = math.max(most, #shown)
    panels[#panels + 1] = { curves = curves, xlabel = ("share of the variance of %s, %%"):format(name), ynames = sources, xrange = { 0, 104 } }
  end
  return fabric.plot { panels = panels, file = file, letters = #panels > 1, layout = { #panels, 1 },
    size = { 0.12, math.min(1, #panels * (0.02 + 0.007 * most)) } }
end

-- --- the call

local function check(t)
  for _, kind in ipairs { "mesh", "steps" } do
    for i, size in ipairs(t[kind] or {}) do
      if type(size) ~= "number" or not (size > 0) or i > 1 and (size <= t[kind][i - 1]) == (kind == "mesh") then
        fail(("budget: field '%s': expected positive numbers, %s"):format(kind, kind == "mesh" and "rising: elements along a side" or "falling: times or parts of a time"))
      end
    end
  end
end

local function run(t)
  check(t)
  local before = define.log_end()
  local used, inputs = {}, {}
  if t.card then band_inputs(t, t.card, inputs) end
  local not_varied = assumed_inputs(t, t.card, inputs)
  for _, field in ipairs(lists.keys(t.card and t.card.provenance or {})) do
    if unheld_by(t.card, field) and not t.card.provenance[field]:find "^assumed" then not_varied[#not_varied + 1] = field end
  end
  local base, base_error = answer(t, middle(t), used)
  local names = lists.keys(base)
  for _, kind in ipairs { "mesh", "steps" } do
    local name = kind == "steps" and "step" or kind
    if t[kind] and not used[name] then fail(("budget: field '%s': run(p) does not use p.%s"):format(kind, name)) end
  end
  if used.specimen then
    inputs[#inputs + 1] = { name = "specimen", range = "by its seed", put = function(p, i, set) p.specimen = 1 + i + (set - 1) * t.samples end }
  end
  t.shares = t.shares and #inputs > 1
  local result = { of = {}, value = {}, band = {}, contributions = {}, not_varied = not_varied, runs = 0, failed = 0, warnings = {}, sample_warnings = {}, narrower = {}, contradictions = contradictions_of(t.card) }
  if fabric.checking() then return result end
  local jobs, numerical = plan(t, inputs)
  local answers = #jobs > 0 and compute(t, jobs, names) or {}
  result.runs, result.sample_warnings = #jobs + 1, counted(answers)
  for _, one in ipairs(result.sample_warnings) do define.say(("budget: in %d of %d runs: %s"):format(one.runs, #jobs, one.text)) end
  for i = 1, numerical do
    if answers[i].trouble then fail("budget: " .. answers[i].trouble) end
  end
  result.mesh_errors = { base_error }
  for i = 2, base_error and t.mesh and #t.mesh or 1 do result.mesh_errors[i] = answers[i - 1][#names + 1] end
  local width, whole = 2 + (t.shares and #inputs or 0), {}
  for i = 1, #inputs > 0 and t.samples or 0 do
    local trouble
    for k = 1, width do trouble = trouble or answers[numerical + (i - 1) * width + k].trouble end
    if trouble then result.failed, result.trouble = result.failed + 1, result.trouble or trouble else whole[#whole + 1] = i end
  end
  if #inputs > 0 and #whole < 0.9 * t.samples then
    fail(("budget: %d of %d samples failed: %s"):format(result.failed, t.samples, result.trouble))
  end
  for place, name in ipairs(names) do
    local rows, values = {}, {}
    for r, i in ipairs(whole) do
      rows[r] = {}
      for k = 1, width do rows[r][k] = answers[numerical + (i - 1) * width + k][place] end
    end
    for i = 1, numerical do values[i] = answers[i][place] end
    local b = budget_of(t, inputs, base[name], values, rows, result.mesh_errors)
    result.of[name], result.value[name], result.band[name], result.contributions[name] = b, b.value, b.band, b.contributions
  end
  result.untold, result.narrower = untold_of(result, names), narrower_of(result, names)
  for _, words in ipairs(result.untold) do fabric.warn("budget: " .. words) end
  result.warnings = define.warnings(before)
  result.text = text_of(t, result, names)
  if t.print then print(result.text) end
  if t.figure then result.drawn = draw(result, names, t.figure) end
  return result
end

define {
  name = "fabric.budget",
  arguments = {
    { name = "run", kind = "function", sentence = "run(p) returns numbers by name; p.card, p.mesh, p.step, p.specimen (a seed) and p.assumed.NAME are those of this run; where it puts its run into p.analysis, mesh_errors is the error of the stresses on each mesh: with one mesh its part, with more the least where these do not converge" },
    { name = "card", of = "card", optional = true, sentence = "its measured bands and what it assumes are varied" },
    { name = "mesh", kind = "table", optional = true, sentence = "for p.mesh, rising, e.g. {4, 8, 16} elements along a side" },
    { name = "steps", kind = "table", optional = true, sentence = "for p.step, falling" },
    { name = "assumed", kind = "table", optional = true, sentence = "{ name={low, high} }: other ranges of what the card assumes, and more numbers, for p.assumed.name" },
    { name = "samples", kind = "integer", low = 8, high = 100000, default = 64, sentence = "draws of all inputs; the runs are this times the inputs and 2" },
    { name = "shares", kind = "boolean", default = true, sentence = "false: the band alone, at two runs a sample, without the share of each input" },
    { name = "seed", kind = "integer", low = 1, default = 1, sentence = "of the draws" },
    { name = "processes", kind = "integer", low = 1, high = 4096, optional = true, sentence = "runs side by side; default: the threads that the program may use" },
    { name = "print", kind = "boolean", default = true, sentence = "the table" },
    { name = "figure", kind = "text", optional = true, sentence = "a file for a picture of the shares" },
  },
  sentence = "The uncertainty of what a deck computes, after the GUM: the errors of the mesh (Richardson's extrapolation, whose limit is the value) and of the steps, the card's measured bands, what it assumes, and the specimen. Returns by the name of each number value, band {low, high} (95 %) "
    .. "and contributions { {source, deviation, share, first, total, first_band, total_band, range, why}, ... }, the largest first; text, runs, failed, warnings, sample_warnings (what the samples warned of, once each: code, text, runs), not_varied, untold (lines on numbers of which the meshes or steps do not tell where they go), contradictions (lines on parts of the card whose records contradict the model), narrower (what tests would narrow an interval, { name, field, test, width }: the width left over the present one).",
  example = "local b = require 'fabric'.budget{ assumed={ a={0, 2}, b={0, 1} }, samples=256, print=false,\n"
    .. "  run=function(p) return { sum=p.assumed.a + p.assumed.b } end }\n"
    .. "assert(math.abs(b.value.sum - 1.5) < 1e-12 and b.contributions.sum[1].source == 'assumed.a')\n"
    .. "assert(math.abs(b.contributions.sum[1].share - 0.8) < 0.05)",
  run = run,
}
