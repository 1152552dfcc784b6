-- How tests differ beyond what a model explains, learned from the tests and applied to one that was not made (fabric.lab.pool, fabric.lab.bias_sizes).
--
-- The deviation of a test from the model, over its scale (the predicted value itself, or one that is given), is a smooth function of the abscissa x,
-- here c_1 + c_2 x + c_3 (3 x^2 - 1)/2 with x from -1 to 1 over all tests. A laboratory, a size, a direction, an angle and a specimen each have a function of
-- their own, drawn from a common distribution (random effects [kennedy2001]; of a curve, a Gaussian process with three modes):
--
--     c = X b + sum_g u_g,    var(u_g) = s^2 share_g diag(1, r_2^2, r_3^2)    for tests of one laboratory, size ... alike
--
-- X b: a function common to all tests, which is found by least squares, and what other parameters of the model would have explained. These stay as they were fitted
-- and count with their uncertainty: moved to where these modes would have them, they would leave the range in which the model is linear. s^2 has the prior 1/s^2
-- and drops out as Student's t; the shares and the roughness r_2, r_3 are averaged over a grid by their restricted likelihood [patterson1971], half widths of
-- bands in their logarithm. Effects that the tests cannot separate, such as two sizes from two laboratories, so stay open in the answer. With as many
-- parameters as the tests have modes nothing is left to learn from: `freedom` is 0.
local fabric = require "fabric"
local linear = require "fabric.lab.common.linear"
local dot = require("fabric.lists").dot
local effects = {}

local modes = 3
local roughness = { { 0.015, 0.015 }, { 0.05, 0.02 }, { 0.1, 0.1 }, { 0.2, 0.05 }, { 0.2, 0.2 }, { 0.45, 0.2 }, { 0.45, 0.45 }, { 1, 0.5 }, { 1, 1 } }
local least_share = 0.02  -- of the specimen itself, below which the others cannot explain everything
local dependent = 1e-3    -- of a column: below it the columns before it explain it
local ridge = 1e-4        -- of a mode's own square, for tests that cover only a part of x
local parts = { 8, 4, 3 } -- of the grid of shares, by their number less one

local function modes_at(state, x)
  local s = (2 * x - state.low - state.high) / (state.high - state.low)
  return { 1, s, (3 * s * s - 1) / 2 }
end

-- Coefficients of a list y along x in units of the scale, by least squares; `inverse` and `rows` are those of rows_of.
local function projected(rows, inverse, y)
  local right, out = {}, {}
  for k = 1, modes do
    right[k] = 0
    for i, row in ipairs(rows) do right[k] = right[k] + row[k] * y[i] end
  end
  for k = 1, modes do out[k] = dot(inverse[k], right) end
  return out
end

-- The modes times the scale at each point of a test, and the inverse of their normal matrix.
local function rows_of(state, x, scale)
  local rows, A = {}, linear.zeros(modes)
  for i, at in ipairs(x) do
    rows[i] = modes_at(state, at)
    for k = 1, modes do rows[i][k] = rows[i][k] * scale[i] end
    for k = 1, modes do
      for l = 1, modes do A[k][l] = A[k][l] + rows[i][k] * rows[i][l] end
    end
  end
  for k = 1, modes do A[k][k] = A[k][k] + ridge * A[1][1] end
  return rows, linear.inverse(A)
end

-- Coefficients of the columns of a test: each mode, for what all tests have in common, and the lists along x that it has.
local function columns_of(rows, inverse, test)
  local out = {}
  for k = 1, modes do
    out[k] = { 0, 0, 0 }
    out[k][k] = 1
  end
  for _, column in ipairs(test.columns or {}) do out[#out + 1] = projected(rows, inverse, column) end
  return out
end

-- Independent combinations of the tests' columns (Gram and Schmidt), each a list along all tests; how to make those of another test of its columns.
local function combinations(columns)
  local bases = {}
  for j = 1, #columns[1] do
    local column = {}
    for _, own in ipairs(columns) do table.move(own[j], 1, modes, #column + 1, column) end
    local length = math.sqrt(dot(column, column))
    for _, q in ipairs(bases) do
      q.part[j] = dot(column, q.values)
      for k, x in ipairs(q.values) do column[k] = column[k] - q.part[j] * x end
    end
    local left = math.sqrt(dot(column, column))
    if left > dependent * length and left > 0 then
      for k, x in ipairs(column) do column[k] = x / left end
      bases[#bases + 1] = { of = j, length = left, values = column, part = {} }
    end
  end
  return bases
end

-- The combinations of a new test, and whether it depends on one that is in no test.
local function combined(bases, columns)
  local out, open, next_base = {}, false, 1
  for j = 1, #columns do
    local rest = table.move(columns[j], 1, modes, 1, {})
    local length = math.sqrt(dot(rest, rest))
    for n = 1, next_base - 1 do
      for k = 1, modes do rest[k] = rest[k] - bases[n].part[j] * out[n][k] end
    end
    local base = bases[next_base]
    if base and base.of == j then
      for k = 1, modes do rest[k] = rest[k] / base.length end
      out[next_base], next_base = rest, next_base + 1
    elseif math.sqrt(dot(rest, rest)) > 0.1 * length then
      open = true
    end
  end
  return out, open
end

-- Calls visit(shares) for every division of one into the shares of the groups and of the specimen (the last).
local function divisions(count, visit)
  local steps = parts[count - 1] or 2
  local function divide(at, left, shares)
    if at == count then
      shares[at] = math.max(least_share, left / steps)
      return visit(shares)
    end
    for own = 0, left do
      shares[at] = own / steps
      divide(at + 1, left - own, shares)
    end
  end
  divide(1, count == 1 and 1 or steps, {})
end

-- Of two tests: the covariance that the groups in which they are alike give them.
local function alike(state, shares, a, b)
  local sum = 0
  for g, name in ipairs(state.groups) do
    if a[name] ~= nil and a[name] == b[name] then sum = sum + shares[g] end
  end
  return sum
end

-- C^-1 v for a list along all tests, C = A x diag(w).
local function weighted(inverse, w, v)
  local out = {}
  for i, row in ipairs(inverse) do
    for k = 1, modes do
      local sum = 0
      for j, a in ipairs(row) do sum = sum + a * v[(j - 1) * modes + k] end
      out[(i - 1) * modes + k] = sum / w[k]
    end
  end
  return out
end

-- One point of the grid: the estimates with these shares and this roughness, and their restricted likelihood.
local function with(state, shares, A, r)
  local n, q = #state.tests, #state.bases
  local out = { shares = table.move(shares, 1, #shares, 1, {}), w = { 1, r[1] ^ 2, r[2] ^ 2 }, columns = {} }
  local inverse, determinant = linear.inverse(A), modes * linear.log_determinant(A) + n * math.log(out.w[2] * out.w[3])
  out.inverse = inverse
  local M = linear.zeros(q)
  for j, base in ipairs(state.bases) do
    out.columns[j] = weighted(inverse, out.w, base.values)
    for l = 1, j do
      M[j][l] = dot(out.columns[j], state.bases[l].values)
      M[l][j] = M[j][l]
    end
  end
  out.M = linear.inverse(M)
  out.left = weighted(inverse, out.w, state.unexplained)
  out.square = math.max(dot(out.left, state.unexplained), 1e-12) / state.freedom
  out.likelihood = -0.5 * (determinant + linear.log_determinant(M) + state.freedom * math.log(out.square))
  return out
end

local function grid_of(state)
  local out, most = {}, -math.huge
  divisions(#state.groups + 1, function(shares)
    local A = linear.zeros(#state.tests)
    for i, a in ipairs(state.tests) do
      for j, b in ipairs(state.tests) do A[i][j] = alike(state, shares, a.labels, b.labels) + (i == j and shares[#shares] or 0) end
    end
    for _, r in ipairs(roughness) do
      out[#out + 1] = with(state, shares, A, r)
      most = math.max(most, out[#out].likelihood)
    end
  end)
  local sum = 0
  for _, point in ipairs(out) do
    point.weight = math.exp(point.likelihood - most)
    sum = sum + point.weight
  end
  for _, point in ipairs(out) do point.weight = point.weight / sum end
  return out
end

-- Prediction of a new test by a point of the grid: the mean of its coefficients and their covariance.
local function of_new(state, point, labels, columns)
  local n, like, mean, V = #state.tests, {}, {}, linear.zeros(modes)
  local total, D = 0, {}
  for _, share in ipairs(point.shares) do total = total + share end
  for j, test in ipairs(state.tests) do like[j] = alike(state, point.shares, labels, test.labels) end
  local known = linear.quadratic(point.inverse, like)
  for k = 1, modes do
    local function carried(list)
      local sum = 0
      for j = 1, n do sum = sum + like[j] * list[(j - 1) * modes + k] end
      return point.w[k] * sum
    end
    mean[k], D[k] = carried(point.left), {}
    for j = 1, #state.bases do
      mean[k] = mean[k] + columns[j][k] * state.moved[j]
      D[k][j] = columns[j][k] - carried(point.columns[j])
    end
    V[k][k] = point.w[k] * math.max(0, total - known)
  end
  for k = 1, modes do
    for l = 1, modes do
      for j = 1, #state.bases do V[k][l] = V[k][l] + D[k][j] * dot(point.M[j], D[l]) end
      V[k][l] = V[k][l] * point.square
    end
  end
  return mean, V
end

-- Degrees of freedom of a new test's variance: those of the parts that it has of its own [satterthwaite1946]. A laboratory, a size, a rate count as labels less one, two of them as one
-- degree: the modes of a curve do not multiply them, since all of them are of one draw. Specimens beside them count with the `modes_of` their curves; where there is one of each label, what
-- is the specimen's own cannot be told from the label's, and is as uncertain.
local function freedom_of(state, labels, modes_of)
  local spare, squares, total, least = #state.tests - 1, 0, 0, math.huge
  local function add(share, count)
    total, squares = total + share, squares + share ^ 2 / math.max(1, count)
  end
  for _, name in ipairs(state.groups) do
    spare = spare - (state.count[name] - 1)
    local known = labels[name] ~= nil and state.labels[name][labels[name]]
    if not known then
      add(state.shares[name], state.count[name] - 1)
      least = math.min(least, state.count[name] - 1)
    end
  end
  if spare <= 0 and least < math.huge then return least end
  add(state.shares.specimen, modes_of * (spare > 0 and spare or #state.tests - 1))
  return total ^ 2 / squares * state.freedom / (modes * (#state.tests - 1))
end

-- A test that was not made: what is to be added to the model's values, and half the width of its band; nil with a reason where the tests do not determine it.
local function predicted(state, new)
  if state.freedom < 1 then return nil, state.reason end
  for _, name in ipairs(state.asked) do
    local label = state.constant[name]
    if label ~= nil and new.labels[name] ~= nil and new.labels[name] ~= label then
      return nil, ("all tests have one %s, %s: how much another one differs is not in them"):format(name, tostring(label))
    end
  end
  local rows, inverse = rows_of(state, new.x, new.scale)
  local columns, open = combined(state.bases, columns_of(rows, inverse, new))
  if open then return nil, "it depends on parameters that the tests do not determine" end
  local shift, second, half, largest, mean_V = {}, {}, {}, 0, linear.zeros(modes)
  for i, s in ipairs(new.scale) do shift[i], second[i], half[i], largest = 0, 0, 0, math.max(largest, math.abs(s)) end
  for _, point in ipairs(state.grid) do
    local mean, V = of_new(state, point, new.labels, columns)
    local w = point.w
    for k = 1, modes do
      for l = 1, modes do mean_V[k][l] = mean_V[k][l] + point.weight * V[k][l] end
    end
    local count = (w[1] + w[2] + w[3]) ^ 2 / (w[1] ^ 2 + w[2] ^ 2 + w[3] ^ 2)
    local own = freedom_of(state, new.labels, count)
    local quantile = fabric.lab.student(0.5 + state.level / 2, math.max(1, math.min(state.freedom, own)))
    for i, row in ipairs(rows) do
      local m = dot(row, mean)
      shift[i], second[i] = shift[i] + point.weight * m, second[i] + point.weight * m * m
      half[i] = half[i] + point.weight * math.log(quantile * math.sqrt(math.max(1e-300, linear.quadratic(V, row))))
    end
  end
  local normal = fabric.lab.student(0.5 + state.level / 2, 3 * #state.tests)
  local deviation = {}
  for i in ipairs(new.x) do
    half[i] = math.sqrt(math.exp(2 * half[i]) + normal ^ 2 * (state.rest * largest ^ 2 + math.max(0, second[i] - shift[i] ^ 2)))
    deviation[i] = half[i] / normal
  end
  return { shift = shift, half = half, deviation = deviation, rows = rows, modes = mean_V }
end

-- Covariance of a prediction's points i and j: their deviations, and the correlation that the modes give them.
function effects.covariance(new, i, j)
  local function product(a, b)
    local sum = 0
    for k = 1, modes do sum = sum + a[k] * dot(new.modes[k], b) end
    return sum
  end
  local a, b = new.rows[i], new.rows[j]
  local square = product(a, a) * product(b, b)
  return new.deviation[i] * new.deviation[j] * (i == j and 1 or square > 0 and product(a, b) / math.sqrt(square) or 0)
end

-- The groups in which the tests differ; the others have one label.
local function sort_groups(state, groups)
  for _, name in ipairs(groups) do
    local seen, count = {}, 0
    for _, test in ipairs(state.tests) do
      local label = test.labels[name]
      if not seen[label] then seen[label], count = true, count + 1 end
    end
    state.labels[name], state.count[name] = seen, count
    if count > 1 then state.groups[#state.groups + 1] = name else state.constant[name] = state.tests[1].labels[name] end
  end
end

-- tests: { x = {}, scale = {}, rest = {} (measured less predicted), columns = { {}, ... } (derivatives of the prediction by each parameter that does not act
-- alike on all tests), labels = { group = label } }. Returns freedom, reason (why nothing is known, where it is 0), deviation (of a new
-- specimen, rms relative to that of the scale), shares (by group and `specimen`), predict(self, { x, scale, columns, labels }).
function effects.learn(tests, groups, level)
  local state = { tests = tests, asked = groups, groups = {}, constant = {}, labels = {}, count = {}, level = level, low = math.huge, high = -math.huge, seen = {}, rest = 0, predict = predicted }
  for _, test in ipairs(tests) do
    for _, x in ipairs(test.x) do state.low, state.high = math.min(state.low, x), math.max(state.high, x) end
  end
  sort_groups(state, groups)
  local columns, size = {}, { 0, 0, 0 } -- sums of the squares of the modes times the scale
  for i, test in ipairs(tests) do
    local rows, inverse = rows_of(state, test.x, test.scale)
    local c, sum, largest = projected(rows, inverse, test.rest), 0, 0
    columns[i] = columns_of(rows, inverse, test)
    table.move(c, 1, modes, #state.seen + 1, state.seen)
    for _, row in ipairs(rows) do
      for k = 1, modes do size[k] = size[k] + row[k] ^ 2 end
    end
    for k, row in ipairs(rows) do sum, largest = sum + (test.rest[k] - dot(row, c)) ^ 2, math.max(largest, math.abs(test.scale[k])) end
    state.rest = state.rest + sum / #rows / largest ^ 2 / #tests
  end
  state.bases = combinations(columns)
  state.freedom = modes * #tests - #state.bases
  state.moved, state.unexplained = {}, table.move(state.seen, 1, #state.seen, 1, {})
  for j, base in ipairs(state.bases) do
    state.moved[j] = base.of <= modes and dot(base.values, state.seen) or 0
    for k, x in ipairs(base.values) do state.unexplained[k] = state.unexplained[k] - state.moved[j] * x end
  end
  if state.freedom < 1 then
    state.reason = #tests == 1 and "a single record says nothing of others"
      or ("%d records have as many freedoms as the model that was fitted to them: nothing is left that could say how wrong it is"):format(#tests)
    return state
  end
  state.grid, state.shares, state.deviation = grid_of(state), {}, 0
  for _, point in ipairs(state.grid) do
    for g, share in ipairs(point.shares) do
      local name = state.groups[g] or "specimen"
      state.shares[name] = (state.shares[name] or 0) + point.weight * share
    end
    state.deviation = state.deviation + point.weight * math.log(point.square * dot(point.w, size) / size[1])
  end
  state.deviation = math.exp(state.deviation / 2)
  return state
end

-- The effects in words.
function effects.text(learned)
  if learned.freedom < 1 then return "bands: none, " .. learned.reason end
  local words = ("bands: a new specimen differs by %.3g %% (deviation, %d degrees of freedom)"):format(100 * learned.deviation, learned.freedom)
  for _, name in ipairs(learned.groups) do words = words .. (", %.0f %% of the variance by %s"):format(100 * learned.shares[name], name) end
  for _, name in ipairs(learned.asked) do
    if learned.constant[name] ~= nil then words = words .. (", all of one %s"):format(name) end
  end
  return words
end

return effects
