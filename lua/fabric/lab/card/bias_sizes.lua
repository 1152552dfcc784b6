-- fabric.lab.bias_sizes: one shear curve from bias tests of several sizes, with the effect of free edges as an additional length.
--
--      |  fixed  |      The yarns of the middle zone (sheared by gamma) and of the mixed zones (gamma/2) end at the free edges, the middle
--      |\ mixed /|<-- w zone over h - 2w of each side, the mixed ones over w above and below. There they slip and pull out, so that
--      | \     / |      a strip of width e bears no load. The work of the grips is then done on areas without that strip,
--      | middle  |
--      | /     \ |      F (h/w - 1)(cos g/2 - sin g/2) = ((2h - 3w) - 4e (h - 2w)/w) cos g N(g) + (w - 4e) cos g/2 N(g/2),
--
-- which for e = 0 is the rule of [cao2008] in fabric.lab.bias_shear. In long specimens the middle zone has longer edges than in short ones
-- (none for h = 2w), so two sizes determine e. A negative e means that the edges bear more than their part.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local linear = require "fabric.lab.common.linear"
local origin = require "fabric.lab.card.origin"
local check = require "fabric.lab.common.check"
local effects = require "fabric.lab.card.effects"
local frames = require "fabric.lab.card.frames"
local lists = require "fabric.lists"
local dot = lists.dot
local angle_of = frames.bias_angle
local fail = define.fail

local believed = 2     -- standard deviations above which the edge is significant
local most_edge = 0.2  -- of the smallest width: the mixed zones must still carry load
local usual = 0.04     -- relative deviation of specimens for judging the edge where no data determine it
local groups = { "size", "laboratory", "direction" }
local stiff = 1e-3     -- of the diagonal; regularises second differences, because gamma and gamma/2 together permit oscillations

-- The factors of N at gamma and at gamma/2 in the force of the grips, for an edge e.
local function shares(size, gamma, e)
  local w, h = size.width, size.length
  local arm = (h / w - 1) * (math.cos(gamma / 2) - math.sin(gamma / 2))
  return ((2 * h - 3 * w) - 4 * e * (h - 2 * w) / w) * math.cos(gamma) / arm, (w - 4 * e) * math.cos(gamma / 2) / arm
end

-- Adds `factor` times the curve's value at gamma to a row of coefficients of the knots. The first knot is at zero shear and need not be zero,
-- because friction acts from the beginning.
local function add(row, spacing, gamma, factor)
  local place = gamma / spacing
  local k = math.min(math.floor(place), #row - 2)
  row[k + 1] = row[k + 1] + factor * (k + 1 - place)
  row[k + 2] = row[k + 2] + factor * (place - k)
end

local function row_of(size, gamma, e, spacing, knots)
  local row = lists.of(knots + 1, function() return 0.0 end)
  local whole, half = shares(size, gamma, e)
  add(row, spacing, gamma, whole)
  add(row, spacing, gamma / 2, half)
  return row
end

-- The least-squares knots of the curve for a given edge, every size relative to its own peak; and the sum of squares.
local function curve_for(state, e)
  local n = state.knots + 1
  local A, b, sum = linear.zeros(n), {}, 0
  for k = 1, n do b[k] = 0.0 end
  for _, size in ipairs(state.sizes) do
    local weight = 1 / (size.peak ^ 2 * #size.gamma)
    for i, gamma in ipairs(size.gamma) do
      local row, F = row_of(size, gamma, e, state.spacing, state.knots), size.scale * size.force[i]
      for j = 1, n do
        b[j] = b[j] + weight * row[j] * F
        if row[j] ~= 0 then
          for k = 1, n do A[j][k] = A[j][k] + weight * row[j] * row[k] end
        end
      end
    end
  end
  local diagonal = 0
  for k = 1, n do diagonal = diagonal + A[k][k] / n end
  for k = 2, n - 1 do
    local second = { [k - 1] = 1, [k] = -2, [k + 1] = 1 }
    for i, x in pairs(second) do
      for j, y in pairs(second) do A[i][j] = A[i][j] + stiff * diagonal * x * y end
    end
  end
  local N = linear.solve(A, b)
  for _, size in ipairs(state.sizes) do
    for i, gamma in ipairs(size.gamma) do
      sum = sum + (dot(row_of(size, gamma, e, state.spacing, state.knots), N) - size.scale * size.force[i]) ^ 2 / (size.peak ^ 2 * #size.gamma)
    end
  end
  return N, sum
end

-- The edge with the least sum of squares: the best of forty trials, then golden section search.
local tries, golden = 40, (math.sqrt(5) - 1) / 2
local function edge_of(state, most)
  local best, least = 0, math.huge
  for i = -tries // 2, tries // 2 do
    local _, sum = curve_for(state, 2 * most * i / tries)
    if sum < least then best, least = 2 * most * i / tries, sum end
  end
  local low, high = math.max(-most, best - 2 * most / tries), math.min(most, best + 2 * most / tries)
  for _ = 1, 25 do
    local a, b = high - golden * (high - low), low + golden * (high - low)
    local _, at_a = curve_for(state, a)
    local _, at_b = curve_for(state, b)
    if at_a <= at_b then high = b else low = a end
  end
  return (low + high) / 2
end

-- Edge and curves, and those for data in which one size after the other is raised by the scatter of the specimens.
local function solve(state, most, scatter, edges)
  local function once()
    local e = edges and edge_of(state, most) or 0
    return { edge = e, N = curve_for(state, e) }
  end
  local found, moved = once(), {}
  for i, size in ipairs(state.sizes) do
    size.scale = 1 + scatter
    moved[i] = once()
    size.scale = 1
  end
  return found, moved
end

-- Angles, forces by the common curve, and their derivative by the edge, of a size.
local function model_of(state, answer, size, displacement)
  local out = { x = {}, scale = {}, columns = answer.found.edge ~= 0 and { {} } or nil, labels = size.labels }
  local step = 1e-3 * size.width
  for i, d in ipairs(displacement) do
    local gamma = angle_of(size, d)
    local function at(e) return dot(row_of(size, gamma, e, state.spacing, state.knots), answer.found.N) end
    out.x[i], out.scale[i] = gamma, at(answer.found.edge)
    if out.columns then out.columns[1][i] = (at(answer.found.edge + step) - at(answer.found.edge - step)) / (2 * step) end
  end
  return out
end

-- How sizes, laboratories, directions and specimens differ beside the common curve.
local function learn(state, answer)
  local tests = {}
  for i, size in ipairs(state.sizes) do
    local test = model_of(state, answer, size, size.displacement)
    test.rest = {}
    for k, F in ipairs(size.force) do test.rest[k] = F - test.scale[k] end
    tests[i] = test
  end
  return effects.learn(tests, state.groups, 0.95)
end

-- Deviations of a prediction by a scatter of specimens that was given.
local function given_deviation(state, answer, size, predicted)
  local out = {}
  for i, gamma in ipairs(predicted.x) do
    local variance = (state.scatter * predicted.scale[i]) ^ 2
    for _, moved in ipairs(answer.moved) do
      variance = variance + (dot(row_of(size, gamma, moved.edge, state.spacing, state.knots), moved.N) - predicted.scale[i]) ^ 2
    end
    out[i] = math.sqrt(variance)
  end
  return out
end

-- Force of a size at given displacements, with the 95 % band of a specimen where the records determine one, and the angle. A scatter given by the caller is the
-- least that specimens differ by; alone it makes a band that says that it was given. common: the curve of all, without what is known of this size.
local function force_of(state, answer, size, displacement, common)
  local model = model_of(state, answer, size, displacement)
  local out = { displacement = displacement, force = table.move(model.scale, 1, #model.scale, 1, {}), angle = {} }
  for i, gamma in ipairs(model.x) do out.angle[i] = math.deg(gamma) end
  local learned, reason = answer.effects:predict(model)
  local given = state.given and given_deviation(state, answer, size, model)
  out.band, out.reason = learned and "learned" or given and "given" or nil, reason
  if not out.band then return out end
  out.deviation, out.low, out.high = {}, {}, {}
  for i, F in ipairs(out.force) do
    local own, half = given and given[i] or 0, 1.96 * (given and given[i] or 0)
    if learned then F, own, half = F + (common and 0 or learned.shift[i]), math.max(own, learned.deviation[i]), math.max(half, learned.half[i]) end
    out.force[i], out.deviation[i], out.low[i], out.high[i] = F, own, F - half, F + half
  end
  return out
end

-- Angle and force in the rows of a specimen that are within the limit.
local function prepared(t, i, s)
  for _, name in ipairs { "displacement", "force" } do check.numbers("bias_sizes", ("specimens[%d].%s"):format(i, name), s[name]) end
  for _, name in ipairs { "width", "length" } do
    if type(s[name]) ~= "number" then fail(("bias_sizes: field 'specimens[%d].%s': expected a length in m, got %s"):format(i, name, tostring(s[name]))) end
  end
  frames.check_pull("bias_sizes", ("specimens[%d].force"):format(i), { displacement = s.displacement, force = s.force, width = s.width, length = s.length,
    limit = t.limit, cut = true })
  local shear = fabric.lab.bias_shear { displacement = s.displacement, force = s.force, width = s.width, length = s.length, thickness = t.thickness,
    limit = t.limit, cut = true }
  local out = { width = s.width, length = s.length, name = s.name or ("%g x %g mm"):format(s.width * 1e3, s.length * 1e3), gamma = {}, force = {},
    displacement = {}, peak = 0, scale = 1, labels = { size = ("%g x %g mm"):format(s.width * 1e3, s.length * 1e3), laboratory = s.laboratory, direction = s.direction } }
  for k, row in ipairs(shear.rows) do
    out.gamma[k], out.force[k], out.displacement[k] = math.rad(shear.angle[k]), s.force[row], s.displacement[row]
    out.peak = math.max(out.peak, s.force[row])
  end
  if #out.gamma < 3 then fail(("bias_sizes: field 'specimens[%d]': expected at least 3 rows within %g degrees, got %d"):format(i, t.limit, #out.gamma)) end
  if not (out.gamma[#out.gamma] > 1e-6) then
    fail(("bias_sizes: field 'specimens[%d].length': expected a specimen that its displacement shears, got %g m"):format(i, s.length))
  end
  return out
end

-- reach: the largest angle considered; common: as of force_of.
local function misfit(state, answer, size, reach, common)
  local n = 0
  while n < #size.gamma and size.gamma[n + 1] <= (reach or math.huge) do n = n + 1 end
  local predicted, sum, inside = force_of(state, answer, size, table.move(size.displacement, 1, n, 1, {}), common), 0, 0
  for i, F in ipairs(predicted.force) do
    sum = sum + (F - size.force[i]) ^ 2
    if predicted.band and predicted.low[i] <= size.force[i] and size.force[i] <= predicted.high[i] then inside = inside + 1 end
  end
  return { rms = math.sqrt(sum / n) / size.peak, at_end = predicted.force[n] / size.force[n] - 1, predicted = predicted, points = n,
    inside = predicted.band and inside / n or nil }
end

-- Lengths over widths that differ less than this do not determine the edges, whose effect is proportional to (h - 2w) / (2h - 3w).
local function determines_edges(sizes)
  local low, high = math.huge, -math.huge
  for _, s in ipairs(sizes) do
    local loss = (4 * (s.length - 2 * s.width) / s.width + 4) / (2 * s.length - 2 * s.width) -- of all that carries load, per length of e
    low, high = math.min(low, loss), math.max(high, loss)
  end
  return high > 1.05 * low
end

-- The common curve at its knots, and its deviation as that of a specimen of another size: learned, or by the scatter that was given; nil where neither is known.
local function curve_out(state, answer, thickness)
  local out = { angle = {}, normal_force = {}, E12 = {}, S12 = {} }
  local x, unmoved = {}, {} -- the edge does not change the curve itself
  for k, N in ipairs(answer.found.N) do
    x[k], unmoved[k] = (k - 1) * state.spacing, 0.0
    out.angle[k], out.normal_force[k] = math.deg(x[k]), N
    out.E12[k], out.S12[k] = math.sin(x[k]) / 2, N / thickness
  end
  local learned = answer.effects:predict { x = x, scale = answer.found.N, columns = answer.found.edge ~= 0 and { unmoved } or nil, labels = {} }
  out.deviation, out.learned = learned and learned.deviation, learned
  if not state.given then return out end
  out.deviation = out.deviation or {}
  for k, N in ipairs(answer.found.N) do
    local variance = lists.sum(answer.moved, function(moved) return (moved.N[k] - N) ^ 2 end)
    out.deviation[k] = math.max(out.deviation[k] or 0, math.sqrt(variance + (state.scatter * N) ^ 2))
  end
  return out
end

-- Half widths and covariance of the stresses of a card's points, of those of the curve at its knots.
local function band_of(curve, points, thickness)
  if not curve.deviation then return end
  local out, places = { value = {}, low = {}, high = {}, covariance = {} }, {}
  local function nearest(E)
    local best = 1
    for k, at in ipairs(curve.E12) do
      if math.abs(at - E) < math.abs(curve.E12[best] - E) then best = k end
    end
    return best
  end
  for _, point in ipairs(points) do
    if point[1] > 0 then
      local n = #places + 1
      places[n] = nearest(point[1])
      local half = 1.96 * curve.deviation[places[n]] / thickness
      out.value[n], out.low[n], out.high[n] = point[2], point[2] - half, point[2] + half
    end
  end
  for i, a in ipairs(places) do
    for j, b in ipairs(places) do
      local own = curve.deviation[a] * curve.deviation[b]
      if curve.learned then own = effects.covariance(curve.learned, a, b) * own / (curve.learned.deviation[a] * curve.learned.deviation[b]) end
      out.covariance[(i - 1) * #places + j] = own / thickness ^ 2
    end
  end
  return out
end

-- The curve as the shear part of a card, made increasing.
local function card_part(t, state, out)
  local points = kernels.monotone { curves = { { E = table.move(out.curve.E12, 2, #out.curve.E12, 1, {}), S = table.move(out.curve.S12, 2, #out.curve.S12, 1, {}) } },
    bins = math.max(2, state.knots) }
  local part = { loading = points, tested = points[#points][1], band = band_of(out.curve, points, t.thickness), level = 0.95 }
  origin.remember(part, { loading = ("fitted to %d bias pulls of %s together, monotone curve up to %g degrees%s"):format(#t.specimens, out.names, t.limit,
    out.edges and (", edges of %.3g mm that bear no load"):format(out.edge * 1e3) or "") })
  return part
end

local function left_out_text(held)
  return ("; left out: rms %.2f %%, at the end %+.1f %%, %s"):format(100 * held.rms, 100 * held.at_end, held.inside
    and ("%.0f %% of %d points in the band of the others"):format(100 * held.inside, held.points) or "no band: " .. held.predicted.reason)
end

local function text_of(out)
  local lines = {}
  if out.edge_deviation then
    lines[1] = ("edges (slip of edge yarns, pull-out): %+.3g mm on either side bear no load, deviation %.2g%s"):format(out.edge * 1e3, out.edge_deviation * 1e3,
      out.scatter_assumed and (" with an assumed scatter of specimens of %g %%"):format(100 * out.scatter_assumed) or "")
      .. (out.edges and "" or out.edge_on_bound and ": at the bound, a fifth of the width, which does not explain how these sizes differ; taken as none" or ": these sizes cannot separate them from the scatter of specimens and laboratories; taken as none")
  else
    lines[1] = "edges: specimens of such similar shape cannot separate them from the curve; taken as none"
  end
  for i, s in ipairs(out.specimens) do
    lines[#lines + 1] = ("%s: rms %.2f %% of the peak with edges, %.2f %% without; at the end %+.1f %%, %+.1f %%%s"):format(s.name, 100 * s.rms,
      100 * s.without.rms, 100 * s.at_end, 100 * s.without.at_end, out.left_out[i]
      and left_out_text(out.left_out[i]) or "")
  end
  for _, name in ipairs(groups) do
    for _, held in ipairs(out.left_out_by[name] or {}) do
      lines[#lines + 1] = ("%s %s from the others%s"):format(name, held.label, left_out_text(held))
    end
  end
  lines[#lines + 1] = out.effects_text
  return table.concat(lines, "\n")
end

-- Curve and edge of some sizes, with their prediction for others.
local function answered(state, most, edges)
  local answer = {}
  answer.found, answer.moved = solve(state, most, state.scatter, edges)
  answer.effects = learn(state, answer)
  return answer
end

-- Predicts size i from those of another label (of `group`), up to their shear; with edges if all sizes together determined them.
local function left_out(state, i, group, most, edges)
  local held, others, reach = state.sizes[i], {}, 0
  for _, s in ipairs(state.sizes) do
    if s.labels[group] ~= held.labels[group] then others[#others + 1], reach = s, math.max(reach, s.gamma[#s.gamma]) end
  end
  if #others == 0 or held.gamma[1] > reach then return end
  local part = { sizes = others, knots = state.knots, spacing = reach / state.knots, scatter = state.scatter, given = state.given, groups = state.groups }
  local out = misfit(part, answered(part, most, edges and determines_edges(others)), held, reach)
  out.label = ("%s (%s)"):format(held.labels[group], held.name)
  return out
end

-- Groups that the specimens name; all of them or none.
local function groups_of(t)
  local out = { "size" }
  for _, name in ipairs { "laboratory", "direction" } do
    local named = 0
    for i = 1, #t.specimens do
      if t.specimens[i][name] ~= nil then named = named + 1 end
    end
    if named > 0 and named < #t.specimens then
      fail(("bias_sizes: field 'specimens': expected a %s of every specimen or of none, got %d of %d"):format(name, named, #t.specimens))
    end
    if named > 0 then out[#out + 1] = name end
  end
  return out
end

local function bias_sizes(t)
  local state, largest, narrow, names, seen = { sizes = {}, knots = t.knots, scatter = t.scatter or usual, given = t.scatter ~= nil }, 0, math.huge, {}, {}
  if #t.specimens == 0 then fail "bias_sizes: field 'specimens': expected at least one, got none" end
  for i = 1, #t.specimens do
    if type(t.specimens[i]) ~= "table" then
      fail(("bias_sizes: field 'specimens[%d]': expected {displacement=, force=, width=, length=}, got %s"):format(i, tostring(t.specimens[i])))
    end
    local size = prepared(t, i, t.specimens[i])
    state.sizes[i] = size
    largest, narrow = math.max(largest, size.gamma[#size.gamma]), math.min(narrow, size.width)
    if not seen[size.name] then names[#names + 1], seen[size.name] = size.name, true end
  end
  state.spacing, state.groups = largest / t.knots, groups_of(t)
  local most, edges_identified = most_edge * narrow, t.edges and determines_edges(state.sizes)
  local plain = answered(state, most, false)
  local answer = edges_identified and answered(state, most, true) or plain
  local out = { edge = answer.found.edge, edges = false, scatter_assumed = not state.given and usual or nil, specimens = {}, names = table.concat(names, ", ") }
  if edges_identified then
    local variance = lists.sum(answer.moved, function(moved) return (moved.edge - out.edge) ^ 2 end)
    out.edge_deviation = math.sqrt(variance)
    out.edge_on_bound = math.abs(out.edge) > 0.99 * most
    out.edges = not out.edge_on_bound and math.abs(out.edge) > believed * out.edge_deviation
  end
  if not out.edges then answer = plain end
  out.left_out, out.left_out_by, out.curve = {}, {}, curve_out(state, answer, t.thickness)
  out.effects, out.effects_text = answer.effects, effects.text(answer.effects) .. (state.given and ("; %g %% between specimens, given"):format(100 * state.scatter) or "")
  for _, name in ipairs(state.groups) do
    local list = {}
    for i in ipairs(state.sizes) do list[i] = left_out(state, i, name, most, out.edges) or nil end
    if name == "size" then out.left_out = list else out.left_out_by[name] = list end
  end
  for i, size in ipairs(state.sizes) do
    out.specimens[i] = misfit(state, answer, size, nil, true)
    out.specimens[i].name, out.specimens[i].without = size.name, misfit(state, plain, size, nil, true)
  end
  out.shear = card_part(t, state, out)
  out.predict = function(_, size)
    if type(size) ~= "table" or type(size.displacement) ~= "table" or type(size.width) ~= "number" or type(size.length) ~= "number" then
      fail "bias_sizes: predict: expected { displacement={...}, width=, length= } in m"
    end
    local reach = largest * (1 + 1e-9)
    for i, d in ipairs(size.displacement) do
      local gamma = type(d) == "number" and angle_of(size, d)
      if not gamma or not (gamma >= 0 and gamma <= reach) then
        fail(("bias_sizes: predict: expected displacements up to %.4g m, the angle of %.3g degrees that was measured, got %s at place %d"):format(
          (math.sqrt(2) * math.cos(math.pi / 4 - largest / 2) - 1) * (size.length - size.width), math.deg(largest), tostring(d), i))
      end
    end
    local asked = { width = size.width, length = size.length, labels = { laboratory = size.laboratory, direction = size.direction,
      size = ("%g x %g mm"):format(size.width * 1e3, size.length * 1e3) } }
    return force_of(state, size.edges == false and plain or answer, asked, size.displacement)
  end
  out.text = text_of(out)
  return out
end

define {
  name = "fabric.lab.bias_sizes",
  arguments = {
    { name = "specimens", kind = "table", sentence = "bias pulls: { {displacement=, force=, width=, length=, name=, laboratory=, direction=}, ... }, m and N, of one size or several; laboratory and direction: names, of all or of none" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "of the cloth" },
    { name = "limit", kind = "number", unit = "degrees", above = 0, high = 60, default = 30, sentence = "angle up to which rows count" },
    { name = "knots", kind = "integer", low = 3, high = 40, default = 10, sentence = "of the curve, at equal angles, straight between them" },
    { name = "edges", kind = "boolean", default = true, sentence = "the free edges are accounted for, if the sizes determine them" },
    { name = "scatter", kind = "number", low = 0, high = 0.5, optional = true,
      sentence = "relative deviation of one specimen, known from elsewhere: the least that bands hold; default: only what the records show (0.04 for the deviation of the edge)" },
  },
  sentence = "One shear curve from bias pulls of several sizes, and the width of the free edges that bear no load (slip of edge yarns, pull-out): edge (m), "
    .. "edge_deviation, edges (true if it exceeds twice its deviation and is below its bound, a fifth of the width; else the edges are taken as none), curve {angle, normal_force (N/m), deviation, E12, S12}, shear (for fabric.lab.card), specimens {name, rms, at_end, without = "
    .. "{rms, at_end}, predicted}, left_out (each size from the others: rms, at_end, points, inside), left_out_by (the same by laboratory and direction), "
    .. "predict(self, {displacement, width, length, laboratory, direction, edges=false}) -> {force, angle, band, low, high}: the 95 % band of a "
    .. "specimen, band 'learned' from how sizes, laboratories, directions and specimens differ, 'given' where only `scatter` is known, nil with a reason where it cannot be determined; text.",
  example = "local lab, d = require 'fabric'.lab, {}\nfor i = 1, 20 do d[i] = 1e-3 * i end\nlocal sizes = { {0.1, 0.3}, {0.08, 0.16} }\n"
    .. "local specimens, card = {}, require 'fabric'.card 'blend'\nfor i, s in ipairs(sizes) do\n"
    .. "  specimens[i] = { displacement=d, width=s[1], length=s[2], force=lab.bias_shear{ displacement=d, card=card, width=s[1], length=s[2], limit=60 }.force }\n"
    .. "end\nlocal b = lab.bias_sizes{ specimens=specimens, thickness=card.thickness, limit=15 }\n"
    .. "assert(not b.edges and b.specimens[2].rms < 0.01)",
  run = bias_sizes,
}
