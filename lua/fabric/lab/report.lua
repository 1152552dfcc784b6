-- The report of a characterisation: measured curves with those simulated from the card, residuals, table, HTML.
local fabric = require "fabric"
local curve = require "fabric.lab.common.curve"
local lists = require "fabric.lists"
local lab, u = fabric.lab, fabric.units
local interpolate, envelope, scaled = curve.interpolate, curve.envelope, lists.scaled

local report = {}

local names = { "warp", "weft", "shear" }

local function slack_of(part, i) return part.fit.specimens and part.fit.specimens[i] and part.fit.specimens[i].slack or 0 end

-- The specimen with the largest pull, and its largest displacement between the grips since first contact.
local function furthest(part, length, strain)
  local best, reach = 1, 0
  for i, test in ipairs(part.tests) do
    local last = test.failure or #test.E
    for k = 1, last do
      local stretch = math.sqrt(1 + 2 * strain(test)[k]) / (1 + slack_of(part, i))
      if length * (stretch - 1) > reach then best, reach = i, length * (stretch - 1) end
    end
  end
  return best, reach
end

-- Its reversals as shares of the largest displacement, up to failure.
local function path_of(part, length, strain)
  local best, reach = furthest(part, length, strain)
  local test, path = part.tests[best], {}
  for _, branch in ipairs(test.branches) do
    local last = math.min(branch.last, test.failure or branch.last)
    local stretch = math.sqrt(1 + 2 * strain(test)[last]) / (1 + slack_of(part, best))
    local place = math.max(0, length * (stretch - 1) / reach)
    if branch.kind ~= "hold" and place ~= (path[#path] or 0) then path[#path + 1] = place end
    if test.failure and branch.last >= test.failure then break end
  end
  return path, reach
end

-- The displacement of a bias test at which its middle has the largest shear of the specimens, whose own displacement includes slack.
local function bias_reach(part, test)
  local largest, E, d = 0, {}, {}
  for _, measured in ipairs(part.tests) do largest = math.max(largest, table.unpack(measured.E)) end
  local up = lists.copy(test)
  up.path = { 1 }
  for i, row in ipairs(lab.bias(up).curve) do E[i], d[i] = math.abs(row.E12_centre), row.displacement end
  return interpolate(E, d, largest) or test.displacement
end

-- Simulates the same test with the card over the measured path. For a bias test, the measured quantities: the shear in its middle and half the
-- stress along the pull.
local function simulate(result, part, direction)
  local about, E, S = result.about, {}, {}
  local shear = direction == "shear"
  local test = { card = result.card, grips = about.grips or "free", width = about.width, length = about.gauge_length, steps = 120 }
  if shear and part.without_markers then -- without zones the curve itself is the measured result
    local strains = lists.of(100, function(i) return part.fit.tested * i / 100 end)
    return strains, fabric.point(result.card):path({ E12 = strains }, { "S12" }).S12
  end
  test.path, test.displacement = path_of(part, about.gauge_length, function(measured) return shear and measured.pull.E or measured.E end)
  if shear then
    test.displacement = bias_reach(part, test)
    for i, row in ipairs(lab.bias(test).curve) do E[i], S[i] = math.abs(row.E12_centre), row.S / 2 end
    return E, S
  end
  test.direction = direction
  for i, row in ipairs(lab.uniaxial(test).curve) do E[i], S[i] = row.E, row.S end
  return E, S
end

-- The same at a point of the law, for a card with which no strip can be run.
local function at_point(result, part, direction)
  local strains = lists.of(100, function(i) return part.fit.tested * i / 100 end)
  local point = fabric.point(result.card)
  if direction == "shear" then return strains, point:path({ E12 = strains }, { "S12" }).S12 end
  return strains, point:uniaxial(direction, strains, { "S" }).S
end

-- Points of a test up to failure relative to first contact, reduced to a few hundred; all, or only those of virgin loading.
local function measured(part, i, all)
  local test, slack = part.tests[i], slack_of(part, i)
  local E, S = {}, {}
  for _, branch in ipairs(test.branches) do
    local last = math.min(branch.last, test.failure or branch.last)
    for k = branch.first, last, math.max(1, #test.E // 600) do
      if all or branch.kind == "loading" then
        E[#E + 1], S[#S + 1] = curve.from_contact(test.E[k], test.S[k], 1 + slack)
      end
    end
    if last < branch.last then break end
  end
  return E, S
end

-- Differences of measured and simulated stress in virgin loading over the largest measured stress, one curve per specimen, and their root mean
-- square.
local function residual(part, E, S)
  local sum, n, largest, curves = 0, 0, 0, {}
  E, S = envelope(E, S)
  for i = 1, #part.tests do
    local e, s = measured(part, i)
    curves[i] = { x = {}, y = {}, label = "specimen " .. i }
    for k = 1, #e do
      largest = math.max(largest, s[k])
      local model = interpolate(E, S, e[k])
      if model then
        table.insert(curves[i].x, e[k])
        table.insert(curves[i].y, s[k] - model)
        sum, n = sum + (s[k] - model) ^ 2, n + 1
      end
    end
  end
  for _, curve in ipairs(curves) do
    for k, y in ipairs(curve.y) do curve.y[k] = 100 * y / largest end
  end
  return math.sqrt(sum / n) / largest, curves
end

-- Runs of a list of strains that rise or fall throughout, each { E, S }.
local function runs_of(E, S)
  local out, way = {}, nil
  for k = 2, #E do
    local now = E[k] > E[k - 1]
    if E[k] ~= E[k - 1] then
      if now ~= way then out[#out + 1], way = { E = { E[k - 1] }, S = { S[k - 1] }, rises = now }, now end
      table.insert(out[#out].E, E[k])
      table.insert(out[#out].S, S[k])
    end
  end
  return out
end

-- The same of the whole loop: the ways back, and up again, of the specimen whose way was simulated, beside the runs of the simulated curve of the same number; rms over
-- the largest measured stress. nil if nothing comes back.
local function whole_residual(part, E, S, best)
  local simulated, test, slack = runs_of(E, S), part.tests[best], slack_of(part, best)
  if #simulated < 2 then return end
  local sum, n, largest, place, back = 0, 0, 0, 0, false
  for _, branch in ipairs(test.branches) do
    local last = math.min(branch.last, test.failure or branch.last)
    if branch.kind ~= "hold" and last > branch.first then
      local rises = test.E[last] > test.E[branch.first]
      if place == 0 or not simulated[place] or simulated[place].rises ~= rises then place = place + 1 end
      local run = simulated[place]
      if not run then break end
      local xs, ys = run.E, run.S
      if not run.rises then
        xs, ys = {}, {}
        for k = #run.E, 1, -1 do xs[#xs + 1], ys[#ys + 1] = run.E[k], run.S[k] end
      end
      for k = branch.first, last, math.max(1, #test.E // 600) do
        local e, s = curve.from_contact(test.E[k], test.S[k], 1 + slack)
        local model = interpolate(xs, ys, e)
        largest = math.max(largest, s)
        if model then sum, n, back = sum + (s - model) ^ 2, n + 1, back or not rises end
      end
    end
    if last < branch.last then break end
  end
  return back and largest > 0 and math.sqrt(sum / n) / largest or nil
end

-- The points of yield or failure of the specimens, for a figure.
local function marked(part, what)
  local points = { x = {}, y = {}, label = what, style = "points" }
  for _, test in ipairs(part.tests) do
    if test.failure and test[what] then
      points.x[#points.x + 1], points.y[#points.y + 1] = test.E[test[what]], test.S[test[what]] / u.MPa
    end
  end
  return points
end

-- The fraction of the band of the next specimens outside of which the card's curve lies; nil without a band.
local function outside_of(spread, E, S)
  if not spread then return end
  local out, n = 0, 0
  E, S = envelope(E, S)
  for k, e in ipairs(spread.E) do
    local s = interpolate(E, S, e)
    if s then
      n = n + 1
      if s < spread.next_low[k] or s > spread.next_high[k] then out = out + 1 end
    end
  end
  return n > 0 and out / n or 1
end

-- Some thirty points of each specimen: more would be one smear in a figure.
local function thinned(E, S)
  local e, s, stride = {}, {}, math.max(1, #E // 30)
  for k = 1, #E, stride do e[#e + 1], s[#s + 1] = E[k], S[k] end
  return e, s
end

-- The range of what curves show in x or y, a fiftieth wider on either side, so that no mark lies on the frame.
local function with_room(curves, axis)
  local low, high = math.huge, -math.huge
  local function look(list)
    for _, v in ipairs(list or {}) do
      if v == v then low, high = math.min(low, v), math.max(high, v) end
    end
  end
  for _, c in ipairs(curves) do
    look(c[axis])
    if axis == "y" and c.band then
      look(c.band.low)
      look(c.band.high)
    end
  end
  local room = (high - low) / 50
  if room > 0 and room < math.huge then return { low - room, high + room } end
end

local function overlay(result, name, out)
  local part = result[name]
  local run, E, S = pcall(simulate, result, part, name)
  local trouble = not run and ("The strip cannot be run with this card, the law at a point takes its place: " .. tostring(E)) or nil
  if trouble then E, S = at_point(result, part, name) end
  local curves = {}
  for i = 1, #part.tests do
    local e, s = thinned(measured(part, i, true))
    curves[i] = { x = e, y = scaled(s, 1 / u.MPa), label = "specimen " .. i, style = "points", colour = "grey" }
  end
  curves[#curves + 1] = { x = E, y = scaled(S, 1 / u.MPa), label = trouble and "card, at a point" or "card, simulated" }
  if part.spread then
    local spread = part.spread
    curves[#curves + 1] = { x = spread.E, band = { low = scaled(spread.next_low, 1 / u.MPa), high = scaled(spread.next_high, 1 / u.MPa) },
      colour = "grey", label = ("%g %% of the next specimens"):format(100 * spread.level) }
  end
  for _, mark in ipairs { "yield", "failure" } do
    local points = marked(part, mark)
    if #points.x > 0 then curves[#curves + 1] = points end
  end
  local files = {}  -- without gnuplot there are none
  local function plot(fields)
    if fabric.plot(fields) then files[#files + 1] = fields.file end
  end
  local strain = name == "shear" and "shear strain E12" or "Green-Lagrange strain E"
  plot { file = out .. "/" .. name .. ".svg", curves = curves, key = "below", xrange = with_room(curves, "x"), yrange = with_room(curves, "y"),
    xlabel = strain, ylabel = "second Piola-Kirchhoff stress, MPa", size = { 120 * u.mm, 90 * u.mm } }
  local rest, differences = residual(part, E, S)
  plot { file = out .. "/" .. name .. "-residual.svg", curves = differences, key = "below", xlabel = strain,
    ylabel = "measured less simulated, % of the peak", size = { 120 * u.mm, 90 * u.mm } }
  local left = part.spread and part.spread.least_like
  if left then -- a prediction is shown beside what was not used for it
    local shown = { { x = left.E, y = scaled(left.S, 1 / u.MPa), style = "points", label = ("specimen %d, left out"):format(left.specimen) },
      { x = left.E, band = { low = scaled(left.low, 1 / u.MPa), high = scaled(left.high, 1 / u.MPa) }, colour = "grey",
        label = ("%g %% of the next specimens, by the other %d"):format(100 * part.spread.level, #part.tests - 1) } }
    plot { file = out .. "/" .. name .. "-left-out.svg", key = "below", xlabel = strain, ylabel = "second Piola-Kirchhoff stress, MPa", size = { 120 * u.mm, 90 * u.mm },
      curves = shown, xrange = with_room(shown, "x"), yrange = with_room(shown, "y") }
  end
  local whole
  if not trouble and not part.without_markers then
    local best = furthest(part, result.about.gauge_length, function(test) return name == "shear" and test.pull.E or test.E end)
    whole = whole_residual(part, E, S, best)
  end
  return { files = files, residual = rest, whole = whole, outside = outside_of(part.spread, E, S), trouble = trouble }
end

-- Replaces the fit where there was no test.
local function assumed_fit(part)
  return { loading = part.loading, degree = type(part.loading[1]) == "number" and #part.loading or nil }
end

-- The source of the card's part: the loops, where they were asked for and seen; else the fit.
local function source_of(result, name)
  local part = result[name]
  if not part then return assumed_fit(result.card[name]) end
  local loops = result.about.loops and part.loops
  return loops and loops.curved and loops or part.fit
end

-- Low and high of a part's unloading modulus; nil without a band.
local function unloading_band(fit)
  if fit.loop then return fit.low.unloading, fit.high.unloading end
  local k, band = fit.degree and fit.degree + 1, fit.band or {}
  if k and band.low and band.low[k] then return band.low[k], band.high[k] end
end

-- A number with so many digits, without a power of ten up to a million.
local function rounded(x, digits)
  local text = ("%." .. digits .. "g"):format(x)
  return text:find "e%+" and math.abs(x) < 1e6 and ("%.0f"):format(tonumber(text)) or text
end

-- Whether a number was given, and not found from a record or by a rule: its digits are the deck's.
local function from_card(words) return words and (words:find "^typed" or words:find "^copied" or words:find "given by the deck") end

-- Stress of a part's loading at parts of the strain that was tested, with the band that its numbers have together: rows { strain, S, low, high }, Pa.
local function stresses(fit)
  local rows, band, loading = {}, fit.band or {}, fit.loading
  if not fit.tested then return rows end
  for _, share in ipairs { 0.25, 0.5, 1 } do
    local E, S, weight, n = share * fit.tested, 0, {}, band.value and #band.value
    if type(loading[1]) == "table" then
      local nearest, place = math.huge, 0
      for k, point in ipairs(loading) do
        if math.abs(point[1] - share * fit.tested) < nearest then nearest, place, E, S = math.abs(point[1] - share * fit.tested), k, point[1], point[2] end
      end
      weight[loading[1][1] == 0 and place - 1 or place] = 1
    else
      for k, d in ipairs(loading) do
        weight[k] = E ^ k / k
        S = S + d * weight[k]
      end
    end
    local row = { E, S }
    if band.low then
      local first = next(weight)
      local deviation, variance = math.sqrt(band.covariance[(first - 1) * n + first]), 0
      for k, a in pairs(weight) do
        for l, b in pairs(weight) do variance = variance + a * b * band.covariance[(k - 1) * n + l] end
      end
      local half = deviation > 0 and (band.high[first] - band.low[first]) / 2 / deviation * math.sqrt(math.max(0, variance)) or 0
      row[3], row[4] = S - half, S + half
    end
    rows[#rows + 1] = row
  end
  return rows
end

local function parameters(result)
  local rows, said = {}, {}
  local provenance = result.card.provenance or {}
  -- As many digits as the band is wide; two without one. A band of no width is none, and a value at the end of its own is said.
  -- Where many numbers of one field come from is said once.
  local function add(what, unit, value, low, high, field)
    local from, digits = provenance[field] or "", field and not from_card(provenance[field]) and 2 or 4
    local width = low and high - low or 0
    local known = low and width > 1e-9 * math.abs(value)
    if known then digits = math.max(2, math.min(4, math.ceil(math.log(math.abs(value) / width + 1, 10)) + 2)) end
    if field and from ~= "" then from, said[field] = said[field] and "likewise" or from, true end
    if known and (value - low < 0.01 * width or high - value < 0.01 * width) then from = from .. (from ~= "" and "; " or "") .. "the value is an end of its band" end
    rows[#rows + 1] = { what, rounded(value, digits), known and rounded(low, digits) .. " to " .. rounded(high, digits) or "", unit, from }
  end
  for _, name in ipairs(names) do
    local fit, ratio = source_of(result, name), result[name] and result[name].ratio
    local band, loop = fit.band or {}, result.card[name].loop
    for i, d in ipairs(fit.degree and fit.loading or {}) do
      add(("%s d%d"):format(name, i - 1), "MPa", d / u.MPa, band.low and band.low[i] / u.MPa, band.low and band.high[i] / u.MPa, name .. ".loading")
    end
    for _, row in ipairs(result[name] and stresses(fit) or {}) do
      add(("%s at E%s = %.3g"):format(name, name == "shear" and "12" or "", row[1]), "MPa", row[2] / u.MPa, row[3] and row[3] / u.MPa, row[4] and row[4] / u.MPa, name .. ".loading")
    end
    local low, high = unloading_band(fit)
    add(name .. " unloading", "MPa", result.card[name].unloading / u.MPa, low and low / u.MPa, high and high / u.MPa, name .. ".unloading")
    for _, number in ipairs(loop and { "friction", "reach", "curve" } or {}) do
      add(name .. " loop " .. number, "", loop[number], fit.loop and fit.low[number], fit.loop and fit.high[number], name .. ".loop")
    end
    if type(ratio) == "table" then
      add(name .. " ratio", "", ratio.value, ratio.low, ratio.high, name .. ".poisson")
    elseif name ~= "shear" then
      add(name .. " ratio", "", result.card[name].poisson, nil, nil, name .. ".poisson")
    end
    if fit.tested then add(name .. " tested to", "", fit.tested) end
  end
  local bending, band = result.card.bending, (result.card.bands or {}).bending
  for i, name in ipairs { "warp", "weft", "twist" } do
    if bending and type(bending[name]) == "number" then
      local field = name == "twist" and provenance["bending.twist"] and "bending.twist" or "bending"
      add("bending " .. name, "uN.m", bending[name] * 1e6, band and band.low[i] * 1e6, band and band.high[i] * 1e6, field)
    end
  end
  return rows
end

local function escaped(text) return (text:gsub("&", "&amp;"):gsub("<", "&lt;")) end

local function content(path)
  local f <close> = assert(io.open(path))
  return f:read "a"
end

-- The share of each specimen within the band of the others, when it is left out.
local function left_out(part)
  if not part.spread then return "" end
  local out = { "<table><tr><th>specimen left out<th>of its points in the band of the others</tr>" }
  for i, inside in ipairs(part.spread.left_out) do
    local file = (part.tests[i].file or ""):match "[^/]*$"
    if part.tests[i].specimen then file = file .. ", " .. part.tests[i].specimen end
    out[#out + 1] = ("<tr><td>%d %s<td>%.0f %%</tr>"):format(i, escaped(file), 100 * inside)
  end
  return table.concat(out) .. "</table>"
end

local function html(result, figures, rows, out)
  local parts = {
    "<!doctype html><meta charset=\"utf-8\"><title>" .. escaped(result.about.name) .. "</title>",
    "<meta name=\"viewport\" content=\"width=device-width\">",
    "<style>body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em;overflow-wrap:anywhere}td,th{padding:.1em .8em;text-align:left}"
      .. "pre{white-space:pre-wrap}svg{max-width:100%;height:auto}</style>",
    "<h1>" .. escaped(result.about.name) .. "</h1><p>" .. escaped(result.card.source) .. "</p>",
  }
  for _, text in ipairs(report.contradictions(figures)) do parts[#parts + 1] = "<p><b>" .. escaped(text) .. "</b></p>" end
  for _, text in ipairs(result.missed or {}) do parts[#parts + 1] = "<p>" .. escaped(text) .. "</p>" end
  for _, text in ipairs(result.seen or {}) do parts[#parts + 1] = "<p>" .. escaped(text) .. "</p>" end
  parts[#parts + 1] = "<table><tr><th>parameter<th>value<th>95 % band<th>unit<th>from</tr>"
  for _, row in ipairs(rows) do parts[#parts + 1] = "<tr><td>" .. table.concat(row, "<td>") .. "</tr>" end
  parts[#parts + 1] = "</table>"
  local viscous = result.shear and result.shear.viscous
  if viscous then parts[#parts + 1] = "<h2>Shear that relaxes</h2><pre>" .. escaped(viscous.text) .. "</pre>" end
  for _, name in ipairs { "warp", "weft" } do
    local loops = result[name] and result[name].loops
    if loops then
      local asked = loops.curved and not result.about.loops and "\nThe card goes straight: loops=true in laboratory.lua puts the curved loop into it." or ""
      parts[#parts + 1] = ("<h2>Loops of the %s</h2><pre>%s%s</pre>"):format(name, escaped(loops.text), asked)
    end
  end
  if #(result.further or {}) > 0 then
    parts[#parts + 1] = "<h2>What further tests would settle</h2><table><tr><th>at present<th>test that would determine it<th></tr>"
    for _, f in ipairs(result.further) do
      parts[#parts + 1] = ("<tr><td>%s<td>%s<td>%s</tr>"):format(f.field, escaped(f.test), escaped(f.now))
    end
    parts[#parts + 1] = "</table>"
  end
  for _, name in ipairs(names) do
    local figure, part = figures[name], result[name]
    if figure then
      parts[#parts + 1] = ("<h2>%s</h2><p>Residual of the simulated curve: %.2f %% of the peak in virgin loading%s. %s</p><pre>%s</pre>"):format(name, 100 * figure.residual,
        figure.whole and (", %.2f %% over the whole loop of the specimen pulled furthest"):format(100 * figure.whole) or "",
        part.spread and escaped(part.spread.text) or "", escaped(part.fit.text or ""))
      parts[#parts + 1] = left_out(part)
      for _, file in ipairs(figure.files) do parts[#parts + 1] = (content(file):gsub("^.-<svg", "<svg")) end
    end
  end
  parts[#parts + 1] = "<h2>Card check</h2><pre>" .. escaped(tostring(result.card:check())) .. "</pre>"
  local f <close> = assert(io.open(out .. "/report.html", "w"))
  f:write(table.concat(parts, "\n"))
end

-- A tenth of a curve may lie outside a band for 95 % of the specimens.
local tolerated = 0.1

-- Texts for the parts whose card contradicts the specimens, or cannot be run.
function report.contradictions(figures)
  local out = {}
  for _, name in ipairs(names) do
    local outside = figures[name] and figures[name].outside
    if figures[name] and figures[name].trouble then out[#out + 1] = name .. ": " .. figures[name].trouble end
    if outside and outside > tolerated then
      out[#out + 1] = ("The data contradict the card in %s: over %.0f %% of the strain its curve lies outside of the band in which the next specimen would lie.")
        :format(name, 100 * outside)
    end
  end
  return out
end

-- Writes card.lua, the figures and report.html into the folder `out`; returns the residuals by part and the table's rows.
function report.write(result, out)
  result.card:write(out .. "/card.lua")
  local figures, rows = {}, parameters(result)
  for _, name in ipairs(names) do
    if result[name] then figures[name] = overlay(result, name, out) end
  end
  html(result, figures, rows, out)
  return figures, rows
end

return report
