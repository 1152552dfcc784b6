-- fabric.lab.viscous: the part of shear that relaxes, from tests at several speeds or from tests that were held.
--
-- Beside the elastic curve P the law has a spring and a dashpot in series: S = P(E) + q with dq = modulus dE - q dt / time. Along a strain that
-- goes straight from row to row q / modulus = a(t, time) is exact. For a given time the stress is linear in P (a cubic spline through zero) and
-- in the modulus, so both follow from normal equations, and what remains is a curve over one number: how well each time explains the records.
-- Its best place, and how far it stays nearly as good, are the answer; a curve that stays flat to an end of what was tried says that the records
-- do not determine the time. A specimen shows (1 + b + b' x) times what the cloth does, x going from -1 at no strain to 1 at the largest, with b of
-- deviation `scatter` and b' of half of it, so that two specimens at two speeds differ by more than noise.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local check = require "fabric.lab.common.check"
local linear = require "fabric.lab.common.linear"
local origin = require "fabric.lab.card.origin"
local bias_angle = require "fabric.lab.card.frames".bias_angle
local lists = require "fabric.lists"
local dot, fail = lists.dot, define.fail

local blocks, per_decade, rounds = 150, 12, 4
local apart, parts = 1.5, 8 -- speeds that differ by this factor are two; parts of a test's time over which its own speed is taken
local turned = 0.01 -- of the largest strain: a way back by less is noise of the reading
local usual_scatter, bent = 0.04, 0.5
local other_limits, least_rows = { 10, 20, 30 }, 12 -- degrees within which the conclusion must be the same; rows of a test that counts

-- --- a test as rows: measured = sum over zones of weight * (P(E) + modulus a(E)) ---

local function time_of(t, i, test, n)
  local field = ("tests[%d]"):format(i)
  local time = test.time
  if time == nil and test.speed ~= nil then
    if type(test.speed) ~= "number" or not (test.speed > 0 and test.speed < math.huge) then
      fail(("viscous: field '%s.speed': expected a positive number in m/s, got %s"):format(field, tostring(test.speed)))
    end
    if check.numbers("viscous", field .. ".displacement", test.displacement) ~= n then
      fail(("viscous: field '%s.displacement': expected %d numbers, one per row, got %d"):format(field, n, #test.displacement))
    end
    time = { 0 }
    for k = 2, n do time[k] = time[k - 1] + math.abs(test.displacement[k] - test.displacement[k - 1]) / test.speed end
  end
  if time == nil then fail(("viscous: field '%s.time': expected the seconds of each row (or speed= in m/s of the crosshead, with displacement)"):format(field)) end
  if check.numbers("viscous", field .. ".time", time) ~= n then
    fail(("viscous: field '%s.time': expected %d numbers, one per row, got %d"):format(field, n, #time))
  end
  for k = 2, n do
    if time[k] < time[k - 1] then fail(("viscous: field '%s.time': expected rising seconds, got %g after %g at place %d"):format(field, time[k], time[k - 1], k)) end
  end
  if not (time[n] > time[1]) then fail(("viscous: field '%s.time': expected a test that takes time, got %g s"):format(field, time[n] - time[1])) end
  return time
end

-- Grips' force of a bias pull by the kinematics of yarns that do not stretch (as in fabric.lab.bias_shear): the middle zone and the mixed ones.
local function zones_of_bias(t, test, i)
  local field, w, h = ("tests[%d]"):format(i), test.width, test.length
  if type(w) ~= "number" or type(h) ~= "number" or not (w > 0 and h >= 2 * w) then
    fail(("viscous: field '%s.length': expected a bias specimen's width and length in m, at least twice as long as wide, got %s and %s"):format(field,
      tostring(w), tostring(h)))
  end
  check.lengths("viscous", test)
  if not t.thickness then fail "viscous: field 'thickness': expected a positive number in m, since a test is a bias pull's force, got nil" end
  local whole, half = { E = {}, weight = {} }, { E = {}, weight = {} }
  local most = (math.sqrt(2) - 1) * (h - w)
  for k, d in ipairs(test.displacement) do
    if d < 0 or d >= most then
      fail(("viscous: field '%s.displacement': expected values from 0 to %.4g m, got %g at place %d"):format(field, most, d, k))
    end
    local gamma = bias_angle(test, d)
    local share = t.thickness / ((h / w - 1) * (math.cos(gamma / 2) - math.sin(gamma / 2)))
    whole.E[k], whole.weight[k] = math.sin(gamma) / 2, share * (2 * h - 3 * w) * math.cos(gamma)
    half.E[k], half.weight[k] = math.sin(gamma / 2) / 2, share * w * math.cos(gamma / 2)
  end
  return { whole, half }
end

-- The rows that count: those that pass the largest strain so far, or stay at it; not those of a way back, from where it began.
local function virgin_rows(E, stop, limit)
  local rows, largest, reach, back = {}, -math.huge, 0, false
  for k = 1, stop do reach = math.max(reach, E[k]) end
  for k = 1, stop do
    if E[k] > limit then break end
    if not back and E[k] < largest - turned * reach then
      back = true
      while #rows > 1 and E[rows[#rows]] < largest - 0.05 * turned * reach do rows[#rows] = nil end
    end
    if E[k] >= largest then back = false end
    if not back then rows[#rows + 1] = k end
    largest = math.max(largest, E[k])
  end
  return rows
end

local function prepared(t, i)
  local test, field = t.tests[i], ("tests[%d]"):format(i)
  if type(test) ~= "table" then fail(("viscous: field '%s': expected {E=, S=, time=} or {displacement=, force=, width=, length=, time=}, got %s"):format(field, tostring(test))) end
  local out = { name = test.name or ("test %d"):format(i) }
  local n, m, first, second
  if test.E ~= nil or test.S ~= nil then
    first, second = "E", "S"
  else
    first, second = "displacement", "force"
  end
  n, m = check.numbers("viscous", field .. "." .. first, test[first]), check.numbers("viscous", field .. "." .. second, test[second])
  if n ~= m or n < 3 then fail(("viscous: field '%s': expected %s and %s of one length, 3 and more, got %d and %d"):format(field, first, second, n, m)) end
  if first == "E" then
    out.zones = { { E = {}, weight = {} } }
    for k, E in ipairs(test.E) do out.zones[1].E[k], out.zones[1].weight[k] = math.abs(E), 1 end
  else
    out.zones = zones_of_bias(t, test, i)
  end
  out.measured, out.time = test[second], time_of(t, i, test, n)
  local stop = test.failure or n
  if math.type(stop) ~= "integer" or stop < 1 or stop > n then fail(("viscous: field '%s.failure': expected a row from 1 to %d, got %s"):format(field, n, tostring(stop))) end
  out.rows = virgin_rows(out.zones[1].E, stop, math.sin(math.rad(t.limit)) / 2)
  if #out.rows < 3 then fail(("viscous: field '%s': expected at least 3 rows of loading or holding within %g degrees, got %d"):format(field, t.limit, #out.rows)) end
  if first ~= "E" then check.pull("viscous", field .. ".force", test.force, out.rows) end
  out.reach, out.peak = 0, 0
  for _, k in ipairs(out.rows) do
    out.reach, out.peak = math.max(out.reach, out.zones[1].E[k]), math.max(out.peak, math.abs(out.measured[k]))
  end
  if not (out.reach > 0 and out.peak > 0) then fail(("viscous: field '%s': expected a test with shear and force"):format(field)) end
  return out
end

-- Rows that follow each other are taken together, by their means: at most so many, and never far apart in strain.
local function in_blocks(test)
  local most, E = math.ceil(#test.rows / blocks), test.zones[1].E
  test.blocks, test.of_row = {}, {}
  local block
  for _, k in ipairs(test.rows) do
    if not block or block.count >= most or math.abs(E[k] - block.E0) > test.reach / 60 then
      block = { count = 0, E0 = E[k], E = 0, y = 0 }
      test.blocks[#test.blocks + 1] = block
    end
    block.count, block.E, block.y = block.count + 1, block.E + E[k], block.y + test.measured[k]
    test.of_row[k] = #test.blocks
  end
  local before
  for _, b in ipairs(test.blocks) do
    b.E, b.y = b.E / b.count, b.y / b.count
    b.rising = not before or b.E > before + 1e-3 * test.reach
    before = math.max(before or 0, b.E)
  end
end

-- Mean speed of the strain while it rises, 1/s.
local function speed_of(test)
  local E, way, seconds = test.zones[1].E, 0, 0
  for k = 2, #test.rows do
    local a, b = test.rows[k - 1], test.rows[k]
    local dE, dt = E[b] - E[a], test.time[b] - test.time[a]
    if dE > 1e-4 * test.reach * math.max(1, 100 / #test.rows) and dt > 0 then way, seconds = way + dE, seconds + dt end
  end
  return seconds > 0 and way / seconds or nil
end

-- Whether the strain's rate changes within a test by the factor that separates speeds: over eighths of its time, in which a hold is a low rate.
-- The rest before the pull does not count.
local function turns(test)
  local E, at = test.zones[1].E, 1
  while at < #test.rows - 1 and E[test.rows[at + 1]] < 0.02 * test.reach do at = at + 1 end
  local first, last = test.rows[at], test.rows[#test.rows]
  local from, whole = test.time[first], test.time[last] - test.time[first]
  local least, most, before = math.huge, 0, E[first]
  for part = 1, parts do
    local t = from + whole * part / parts
    while at < #test.rows - 1 and test.time[test.rows[at + 1]] < t do at = at + 1 end
    local a, b = test.rows[at], test.rows[at + 1]
    local dt = test.time[b] - test.time[a]
    local here = dt > 0 and E[a] + (E[b] - E[a]) * math.min(1, (t - test.time[a]) / dt) or E[b]
    local way = math.max(0, here - before)
    least, most, before = math.min(least, way), math.max(most, way), here
  end
  return most > apart * least
end

-- Whether the tests can distinguish relaxation from the elastic curve: speeds that differ, or one that changes within a test.
local function tells_speed(state)
  local slow, fast = math.huge, 0
  for _, test in ipairs(state.tests) do
    if turns(test) then return true end
    if test.speed then slow, fast = math.min(slow, test.speed), math.max(fast, test.speed) end
  end
  return fast >= apart * slow
end

-- --- the elastic curve: cubic B-splines over equal intervals, with the value zero at zero ---

local function spline_at(x, knots, add)
  local k = math.max(0, math.min(knots - 1, math.floor(x)))
  local s = x - k
  local r = 1 - s
  local values = { r * r * r / 6, (4 - 6 * s * s + 3 * s * s * s) / 6, (4 - 6 * r * r + 3 * r * r * r) / 6, s * s * s / 6 }
  for j = 1, 4 do
    local place, v = k + j - 1, values[j] -- the first of all follows from the next two
    if place == 0 then
      add(1, -4 * v)
      add(2, -v)
    else
      add(place, v)
    end
  end
end

local function curve_at(state, E)
  local sum = 0
  spline_at(E / state.spacing, state.knots, function(j, v) sum = sum + v * state.elastic[j] end)
  return sum
end

local function basis_of(state, test)
  for _, b in ipairs(test.blocks) do
    b.basis = {}
    for j = 1, state.knots + 2 do b.basis[j] = 0.0 end
  end
  for _, zone in ipairs(test.zones) do
    for _, k in ipairs(test.rows) do
      local b = test.blocks[test.of_row[k]]
      local share = zone.weight[k] / b.count
      spline_at(zone.E[k] / state.spacing, state.knots, function(j, v) b.basis[j] = b.basis[j] + share * v end)
    end
  end
end

-- The relaxing stress in each block for a modulus of one.
local function relaxing(test, time)
  local out = {}
  for i = 1, #test.blocks do out[i] = 0.0 end
  local exp, seconds, of_row, blocks = math.exp, test.time, test.of_row, test.blocks
  for _, zone in ipairs(test.zones) do
    local q, E, weight, last, before = 0.0, zone.E, zone.weight, 0, seconds[1]
    for k = 1, test.rows[#test.rows] do
      local strain, second = E[k], seconds[k]
      local x, dE = (second - before) / time, strain - last
      last, before = strain, second
      local e = exp(-x)
      q = q * e + (x > 1e-4 and (1 - e) / x or 1 - x / 2 + x * x / 6) * dE
      local place = of_row[k]
      if place then out[place] = out[place] + weight[k] * q / blocks[place].count end
    end
  end
  return out
end

-- --- least squares with specimens that differ ---

-- A list over the noise and without what correlates the rows of a specimen: its own factor, and one that varies from end to end.
local function whitened(state, test, list)
  local out = {}
  for k, x in ipairs(list) do out[k] = x / test.sigma[k] end
  out = linear.whitened(out, test.along, state.scatter ^ 2, test.along_square)
  return linear.whitened(out, test.across, (bent * state.scatter) ^ 2, test.across_square)
end

-- Normal equations of the elastic curve, and the right side.
local function prepare(state)
  local n = state.knots + 2
  local A, b = linear.zeros(n), {}
  for j = 1, n do b[j] = 0.0 end
  state.total = 0
  for _, test in ipairs(state.tests) do
    test.sigma, test.along, test.across = {}, {}, {}
    for k, block in ipairs(test.blocks) do
      test.sigma[k] = state.level * test.peak / math.sqrt(block.count)
      test.along[k] = (test.predicted and test.predicted[k] or block.y) / test.sigma[k]
      test.across[k] = test.along[k] * (2 * block.E / (state.spacing * state.knots) - 1)
    end
    test.along_square = dot(test.along, test.along)
    test.across = linear.whitened(test.across, test.along, state.scatter ^ 2, test.along_square)
    test.across_square = dot(test.across, test.across)
    test.columns = {}
    for j = 1, n do
      local column = lists.map(test.blocks, function(block) return block.basis[j] end)
      test.columns[j] = whitened(state, test, column)
    end
    local y = {}
    for k, block in ipairs(test.blocks) do y[k] = block.y end
    test.y = whitened(state, test, y)
    state.total = state.total + dot(test.y, test.y)
    for j = 1, n do
      b[j] = b[j] + dot(test.columns[j], test.y)
      for l = j, n do A[j][l] = A[j][l] + dot(test.columns[j], test.columns[l]) end
    end
  end
  for j = 1, n do
    for l = 1, j - 1 do A[j][l] = A[l][j] end
  end
  -- Where no row lies the curve goes on straight: its bends weigh next to nothing.
  local weight = 0
  for j = 1, n do weight = weight + 1e-9 * A[j][j] / n end
  for j = 2, n - 1 do
    for x, p in pairs { [-1] = 1, [0] = -2, [1] = 1 } do
      for y, q in pairs { [-1] = 1, [0] = -2, [1] = 1 } do A[j + x][j + y] = A[j + x][j + y] + weight * p * q end
    end
  end
  state.inverse, state.right = linear.inverse(A), b
  state.without = state.total
  for j = 1, n do state.without = state.without - b[j] * dot(state.inverse[j], b) end
end

-- How well a time explains the records: the modulus, what it takes off the sum of squares, and its weight; nil where the records know nothing of it.
local known = 1e-8
local function at_time(state, time)
  local n, square, along, g = state.knots + 2, 0, 0, {}
  for j = 1, n do g[j] = 0.0 end
  for _, test in ipairs(state.tests) do
    local a = whitened(state, test, relaxing(test, time))
    square, along = square + dot(a, a), along + dot(a, test.y)
    for j = 1, n do g[j] = g[j] + dot(a, test.columns[j]) end
  end
  local rest, with = square, along
  for j = 1, n do
    local h = dot(state.inverse[j], g)
    rest, with = rest - g[j] * h, with - state.right[j] * h
  end
  if not (rest > known * square) then return { time = time, modulus = 0, gain = 0, weight = 0, sign = 0 } end
  return { time = time, modulus = with / rest, gain = with ^ 2 / rest, weight = rest, sign = with > 0 and 1 or -1 }
end

local function profile_of(state)
  local out = {}
  local n = math.ceil(per_decade * math.log(state.longest_time / state.shortest_time, 10))
  for k = 0, n do out[k + 1] = at_time(state, state.shortest_time * (state.longest_time / state.shortest_time) ^ (k / n)) end
  return out
end

-- The time of the largest gain with one sign of the modulus: the best of the profile, and the golden section around it.
local golden = (math.sqrt(5) - 1) / 2
local function best_of(state, profile, sign)
  local place
  for k, p in ipairs(profile) do
    if p.sign == sign and p.gain > 0 and (not place or p.gain > profile[place].gain) then place = k end
  end
  if not place then return end
  local function gain(log_time)
    local p = at_time(state, math.exp(log_time))
    return p.sign == sign and p.gain or 0
  end
  local low, high = math.log(profile[math.max(1, place - 1)].time), math.log(profile[math.min(#profile, place + 1)].time)
  for _ = 1, 22 do
    local a, b = high - golden * (high - low), low + golden * (high - low)
    if gain(a) >= gain(b) then high = b else low = a end
  end
  local found = at_time(state, math.exp((low + high) / 2))
  return found.gain >= profile[place].gain and found.sign == sign and found or profile[place]
end

-- The elastic curve beside a modulus at a time, what it predicts, and the residuals.
local function settle(state, found)
  local n, b = state.knots + 2, table.move(state.right, 1, state.knots + 2, 1, {})
  local parts = {}
  for i, test in ipairs(state.tests) do
    parts[i] = found and relaxing(test, found.time) or nil
    if found then
      local a = whitened(state, test, parts[i])
      for j = 1, n do b[j] = b[j] - found.modulus * dot(a, test.columns[j]) end
    end
  end
  state.elastic = {}
  for j = 1, n do state.elastic[j] = dot(state.inverse[j], b) end
  for i, test in ipairs(state.tests) do
    test.predicted, test.rest, test.relaxing = {}, {}, parts[i]
    for k, block in ipairs(test.blocks) do
      test.predicted[k] = dot(block.basis, state.elastic) + (found and found.modulus * parts[i][k] or 0)
      test.rest[k] = block.y - test.predicted[k]
    end
  end
end

-- Each specimen's own factor on the prediction, less one; of its rising blocks alone where wanted.
local function factor_of(test, rising)
  local square, along = 0, 0
  for k, block in ipairs(test.blocks) do
    if not rising or block.rising then
      local p = test.predicted[k]
      square, along = square + block.count * p * p, along + block.count * test.rest[k] * p
    end
  end
  return square > 0 and along / square or 0
end

-- A specimen's residuals, over its peak and for one row, without its own factor and that from end to end.
local function own_rest(state, test)
  local aa, ab, bb, ra, rb = 1e-300, 0, 1e-300, 0, 0
  local function across(k) return test.predicted[k] * (2 * test.blocks[k].E / (state.spacing * state.knots) - 1) end
  for k, block in ipairs(test.blocks) do
    local p, c, r = test.predicted[k], across(k), test.rest[k]
    aa, ab, bb = aa + block.count * p * p, ab + block.count * p * c, bb + block.count * c * c
    ra, rb = ra + block.count * r * p, rb + block.count * r * c
  end
  local det = aa * bb - ab * ab
  local own = det > 1e-9 * aa * bb and { (ra * bb - rb * ab) / det, (rb * aa - ra * ab) / det } or { ra / aa, 0 }
  local out = {}
  for k, block in ipairs(test.blocks) do
    out[k] = (test.rest[k] - own[1] * test.predicted[k] - own[2] * across(k)) * math.sqrt(block.count) / test.peak
  end
  return out
end

-- Differences within specimens: noise, and how much neighbours are alike.
local function noise_of(state)
  local squares, freedom, together, apart = 0, -(state.knots + 3), 0, 0
  for _, test in ipairs(state.tests) do
    local before
    freedom = freedom + #test.blocks - 2
    for _, r in ipairs(own_rest(state, test)) do
      squares = squares + r * r
      if before then together, apart = together + r * before, apart + r * r end
      before = r
    end
  end
  local likeness = math.min(0.95, math.max(0, apart > 0 and together / apart or 0))
  return math.max(1e-7, math.sqrt(squares / math.max(1, freedom))), likeness
end

-- Tests of one speed, within a fifth.
local function groups_of(state)
  local groups = {}
  for _, test in ipairs(state.tests) do
    local home
    for _, g in ipairs(groups) do
      if test.speed and g.speed and math.abs(math.log(test.speed / g.speed)) < 0.2 then home = g end
    end
    if not home then
      home = { speed = test.speed }
      groups[#groups + 1] = home
    end
    home[#home + 1] = test
  end
  return groups
end

-- How specimens of one speed differ: from themselves where there are enough, else what is usual.
local function find_scatter(state)
  if state.given then return end
  local squares, freedom = 0, 0
  for _, g in ipairs(state.groups) do
    local mean = lists.sum(g, function(test) return factor_of(test) / #g end)
    for _, test in ipairs(g) do squares = squares + (factor_of(test) - mean) ^ 2 end
    freedom = freedom + #g - 1
  end
  if freedom >= 2 then state.scatter, state.freedom = math.sqrt(squares / freedom), freedom end
end

-- The slowest and the fastest tests, where their speeds differ.
local function ends_of(state)
  local slow, fast
  for _, g in ipairs(state.groups) do
    if g.speed and (not slow or g.speed < slow.speed) then slow = g end
    if g.speed and (not fast or g.speed > fast.speed) then fast = g end
  end
  if slow and fast.speed >= apart * slow.speed then return slow, fast end
end

-- How much larger or smaller the stress of the fastest is than that of the slowest, beside one elastic curve for all: {slow, fast, ratio, low, high}.
local function speeds_of(state)
  local slow, fast = ends_of(state)
  if not slow then return end
  local function mean(g)
    local sum = lists.sum(g, function(test) return factor_of(test, true) / #g end)
    return 1 + sum
  end
  local ratio = mean(fast) / mean(slow)
  local half = state.quantile * state.scatter * math.sqrt(1 / #slow + 1 / #fast)
  local decades = math.log(fast.speed / slow.speed, 10)
  return { slow = slow.speed, fast = fast.speed, ratio = ratio - 1, low = ratio * (1 - half) - 1, high = ratio * (1 + half) - 1, decades = decades,
    slow_name = slow[1].name, fast_name = fast[1].name }
end

-- The mean stress of a group's tests between two strains over one elastic curve for all; nil where one of them has no rising rows there.
local function level_between(group, low, high)
  local sum = 0
  for _, test in ipairs(group) do
    local own, n = 0, 0
    for k, block in ipairs(test.blocks) do
      if block.rising and block.E > low and block.E <= high and test.predicted[k] ~= 0 then own, n = own + block.y / test.predicted[k], n + 1 end
    end
    if n == 0 then return end
    sum = sum + own / n / #group
  end
  return sum
end

-- The fastest over the slowest against the angle: {angle (degrees), E, ratio, low, high}; specimens differ by a factor and by one from end to end.
local bins = 10
local function ratio_of(state)
  local slow, fast = ends_of(state)
  if not slow then return end
  local out, reach = { angle = {}, E = {}, ratio = {}, low = {}, high = {} }, math.huge
  for _, group in ipairs { slow, fast } do
    for _, test in ipairs(group) do reach = math.min(reach, test.reach) end
  end
  for k = 1, bins do
    local a, b = level_between(slow, (k - 1) * reach / bins, k * reach / bins), level_between(fast, (k - 1) * reach / bins, k * reach / bins)
    if a and b and a > 0 then
      local n, E = #out.E + 1, (k - 0.5) * reach / bins
      local x = 2 * E / (state.spacing * state.knots) - 1
      local half = state.quantile * state.scatter * math.sqrt((1 + (bent * x) ^ 2) * (1 / #slow + 1 / #fast))
      out.E[n], out.angle[n], out.ratio[n] = E, math.deg(math.asin(2 * E)), b / a
      out.low[n], out.high[n] = b / a * (1 - half), b / a * (1 + half)
    end
  end
  return out
end

-- --- what is said ---

-- Ends of what the profile leaves open around its best place, of the time, the modulus, and their product.
local function bands_of(state, profile, best)
  profile = table.move(profile, 1, #profile, 1, {})
  profile[#profile + 1] = best
  table.sort(profile, function(a, b) return a.time < b.time end)
  local room = state.quantile ^ 2
  local out = { time = { math.huge, 0 }, modulus = { math.huge, 0 }, viscosity = { math.huge, 0 } }
  local function take(name, low, high) out[name] = { math.min(out[name][1], math.max(0, low)), math.max(out[name][2], high) } end
  local function one(p)
    local left = room - (best.gain - (p.sign > 0 and p.gain or 0))
    if left < 0 or p.weight == 0 then return end
    local half = math.sqrt(left / p.weight)
    take("time", p.time, p.time)
    take("modulus", p.modulus - half, p.modulus + half)
    take("viscosity", (p.modulus - half) * p.time, (p.modulus + half) * p.time)
  end
  local function inside(p) return best.gain - (p.sign > 0 and p.gain or 0) <= room end
  for k, p in ipairs(profile) do
    one(p)
    local after = profile[k + 1]
    if after and inside(p) ~= inside(after) then -- the edge lies between
      local low, high = p.time, after.time
      for _ = 1, 20 do
        local middle = math.sqrt(low * high)
        if inside(at_time(state, middle)) == inside(p) then low = middle else high = middle end
      end
      one(at_time(state, inside(p) and low or high))
    end
  end
  local informative = lists.collect(profile, function(p) return p.weight > 0 and p or nil end)
  out.open_below, out.open_above = inside(informative[1]), inside(informative[#informative])
  return out
end

local function modulus_text(x) return ("%.3g MPa"):format(x / 1e6) end

local function speed_text(s)
  return ("the faster record ('%s', %.3g /s) carries %+.1f %% of the slower one's ('%s', %.3g /s) at equal strain, %+.1f to %+.1f %%, %+.1f %% a decade"):format(
    s.fast_name, s.fast, 100 * s.ratio, s.slow_name, s.slow, 100 * s.low, 100 * s.high, 100 * s.ratio / s.decades)
end

-- The ratio at some angles, with its band where that was learned.
local function ratio_text(out)
  local r, words = out.ratio, {}
  for k = 1, #r.angle, 3 do
    words[#words + 1] = ("%.0f degrees %.2f"):format(r.angle[k], r.ratio[k]) .. (" (%.2f to %.2f)"):format(r.low[k], r.high[k])
  end
  return "the fastest over the slowest against the angle: " .. table.concat(words, ", ")
end

local function text_of(out)
  local lines = { out.reason }
  if out.speed then lines[#lines + 1] = speed_text(out.speed) end
  if out.ratio then lines[#lines + 1] = ratio_text(out) end
  if out.modulus then
    lines[#lines + 1] = ("modulus %s, %s to %s; time %.3g s, %s to %s; modulus times time %.3g MPa s, %.3g to %.3g"):format(modulus_text(out.modulus),
      modulus_text(out.low.modulus), modulus_text(out.high.modulus), out.time, out.open_below and "0" or ("%.3g"):format(out.low.time),
      out.open_above and "any" or ("%.3g s"):format(out.high.time), out.modulus * out.time / 1e6, out.low.viscosity / 1e6, out.high.viscosity / 1e6)
  end
  if out.scatter_from == "assumed" then
    lines[#lines + 1] = "The intervals hold under an assumed scatter of specimens; they are no bands of a stated confidence, since no speed was repeated often enough to show one"
  end
  lines[#lines + 1] = ("specimens of one speed differ by %.3g %% (deviation, %s), the ends of their curves by half as much beside; left over: rms %.3g %% of the peak%s"):format(100 * out.scatter, out.scatter_from,
    100 * out.rms, out.likeness > 0.5 and out.rms > 1e-3 and ", a curve rather than noise: one time is not all there is" or "")
  return table.concat(lines, "\n")
end

local function relaxation_words(out)
  return ("fitted to %d test%s: modulus %s to %s, time %.3g to %.3g s"):format(out.tests, out.tests == 1 and "" or "s", modulus_text(out.low.modulus),
    modulus_text(out.high.modulus), out.low.time, out.high.time)
end

-- Decides what the records say, and says it.
local function decide(state, out, positive, negative, fixed)
  local needed = -2 * math.log(1 - state.confidence) -- of chi^2 with two degrees of freedom: modulus and time
  local gain, against = positive and positive.gain or 0, negative and negative.gain or 0
  local softer = out.speed and out.speed.high < 0
  if not tells_speed(state) then
    out.one_speed = true
    out.reason = ("One speed and no hold cannot distinguish a stiff toe of the elastic curve from relaxation, so that nothing is concluded: tests at speeds that "
      .. "differ by a factor of %g or more would decide, or one with a hold."):format(apart)
  elseif softer then
    out.contradicts = true
    out.reason = ("The faster record is the softer one: no positive viscosity explains it. Nothing of shear relaxes in what these tests show; what else "
      .. "differs between them (specimens, slip, heat, friction that falls with the speed) is not this law's.")
  elseif against > needed and against > gain then
    out.contradicts = true
    out.reason = "The stress rises where a viscous solid's falls: no positive viscosity explains it."
  elseif gain <= needed then
    out.reason = "Nothing that relaxes is seen beside noise and how specimens differ."
  else
    local bands = bands_of(state, fixed and { positive } or state.profile, positive)
    if fixed then bands.open_below, bands.open_above = false, false end
    out.modulus, out.time = positive.modulus, positive.time
    out.low = { modulus = bands.modulus[1], time = bands.time[1], viscosity = bands.viscosity[1] }
    out.high = { modulus = bands.modulus[2], time = bands.time[2], viscosity = bands.viscosity[2] }
    out.open_below, out.open_above = bands.open_below, bands.open_above
    if out.open_above then
      out.reason = ("Something relaxes, but these tests do not determine the time constant: they end before it is over (%.3g s and more). A longer hold would decide."):format(
        out.low.time)
    elseif out.open_below then
      out.reason = ("Something relaxes, but these tests do not determine the time constant: it is %.3g s or less, and only modulus times time is told. A hold, or a "
        .. "faster test, would decide; `time` gives one."):format(out.high.time)
    else
      out.viscous = { shear = { modulus = out.modulus, time = out.time } }
      out.reason = fixed and "Shear relaxes; the time was given." or "Shear relaxes."
    end
  end
end

-- Elastic curve and unloading modulus as the shear of a card.
local function card_part(state, t, out)
  local E, S = {}, {}
  for k = 1, state.knots do E[k], S[k] = k * state.spacing, curve_at(state, k * state.spacing) end
  out.elastic = { E = E, S = S }
  local part = { loading = kernels.monotone { curves = { { E = E, S = S } }, bins = state.knots } }
  part.tested = part.loading[#part.loading][1]
  local moduli = {}
  for i, test in ipairs(t.tests) do
    for _, branch in ipairs(type(test.E) == "table" and type(test.branches) == "table" and test.branches or {}) do
      if branch.kind == "unloading" and not (test.failure and branch.first > test.failure) then
        local own = { zones = state.tests[i].zones, time = state.tests[i].time, rows = {}, of_row = {}, blocks = {} }
        for k = branch.first, branch.last do own.rows[#own.rows + 1], own.of_row[k], own.blocks[#own.blocks + 1] = k, #own.blocks + 1, { count = 1 } end
        local q = out.viscous and relaxing(own, out.time) or nil
        local Eu, Su = {}, {}
        for n, k in ipairs(own.rows) do Eu[n], Su[n] = math.abs(test.E[k]), test.S[k] - (q and out.modulus * q[n] or 0) end
        if #Eu >= 3 then moduli[#moduli + 1] = fabric.lab.unloading { E = Eu, S = Su, rule = "robust" } end
        break
      end
    end
  end
  for _, D in ipairs(moduli) do part.unloading = (part.unloading or 0) + D / #moduli end
  local beside = out.viscous and ", beside what relaxes" or ""
  origin.remember(part, { loading = ("fitted to %d tests together, monotone curve%s"):format(#t.tests, beside),
    unloading = part.unloading and ("fitted to %d of %d tests, rule 'robust'%s"):format(#moduli, #t.tests, beside) or nil })
  return part
end

local function analysed(t)
  local state = { tests = {}, knots = t.knots, scatter = t.scatter or usual_scatter, given = t.scatter ~= nil, level = 0.01, confidence = t.level,
    quantile = fabric.lab.student(0.5 + t.level / 2, 1e6) }
  local reach, longest, shortest = 0, 0, math.huge
  for i = 1, #t.tests do
    local test = prepared(t, i)
    state.tests[i] = test
    in_blocks(test)
    test.speed = speed_of(test)
    reach, longest = math.max(reach, test.reach), math.max(longest, test.time[#test.time] - test.time[1])
    shortest = math.min(shortest, (test.time[#test.time] - test.time[1]) / #test.time)
  end
  state.spacing, state.shortest_time, state.longest_time = reach / t.knots, shortest / 5, 30 * longest
  for _, test in ipairs(state.tests) do basis_of(state, test) end
  state.groups = groups_of(state)
  local positive, negative, likeness, rms
  local out = { tests = #t.tests }
  for round = 1, rounds do
    prepare(state)
    state.profile = profile_of(state)
    local fixed = t.time and at_time(state, t.time)
    positive = fixed and (fixed.sign > 0 and fixed or nil) or not t.time and best_of(state, state.profile, 1) or nil
    negative = fixed and (fixed.sign < 0 and fixed or nil) or not t.time and best_of(state, state.profile, -1) or nil
    settle(state, negative and (not positive or negative.gain > positive.gain) and negative or positive) -- what is left of either is noise
    rms, likeness = noise_of(state)
    if round < rounds then
      find_scatter(state)
      if state.freedom then state.quantile = fabric.lab.student(0.5 + t.level / 2, state.freedom) end
      -- Neighbours that are alike count as if there were fewer of them.
      state.level = rms * math.sqrt((1 + likeness) / (1 - likeness))
    end
  end
  out.scatter, out.scatter_from = state.scatter, state.freedom and ("found from %d degrees of freedom"):format(state.freedom) or state.given and "given" or "assumed"
  out.rms, out.likeness = rms, likeness
  settle(state, nil) -- one elastic curve for all, beside which speeds differ
  out.speed, out.ratio = speeds_of(state), ratio_of(state)
  decide(state, out, positive, negative, t.time ~= nil)
  if out.viscous then settle(state, positive) end
  out.shear = card_part(state, t, out)
  out.profile = { time = {}, modulus = {}, chi2 = {} }
  for k, p in ipairs(state.profile) do
    out.profile.time[k], out.profile.modulus[k], out.profile.chi2[k] = p.time, p.modulus, (positive and positive.gain or 0) - (p.sign > 0 and p.gain or 0)
  end
  return out
end

-- Whether every test has rows enough within an angle, and some beyond it (or the angle is the one that was asked for).
local function reached(t, limit)
  local beyond = limit == t.limit
  for i = 1, #t.tests do
    local zones, n = prepared(t, i).zones[1].E, 0
    for _, E in ipairs(zones) do
      if E <= math.sin(math.rad(limit)) / 2 then n = n + 1 else beyond = true end
    end
    if n < least_rows then return false end
  end
  return beyond
end

local function verdict_of(out)
  if out.modulus then return "something relaxes" end
  return out.contradicts and "the faster record is the softer one, or the stress rises where it should fall" or "nothing is seen to relax"
end

-- A conclusion that another limit of the angle would turn round is none. That less of the records shows nothing is no other conclusion.
local function withhold(t, out)
  out.by_limit = {}
  for _, limit in ipairs(other_limits) do
    if limit ~= t.limit and reached(t, limit) then
      local good, own = pcall(analysed, setmetatable({ limit = limit }, { __index = t })) -- a part without stress determines nothing
      out.by_limit[#out.by_limit + 1] = good and { limit = limit, verdict = verdict_of(own), relaxes = own.modulus ~= nil, contradicts = own.contradicts == true, speed = own.speed } or nil
    end
  end
  local own, words = verdict_of(out), {}
  for _, other in ipairs(out.by_limit) do
    local turned_round = out.modulus and (other.contradicts or not other.relaxes and other.limit > t.limit) or not out.modulus and other.relaxes
    if turned_round then words[#words + 1] = ("up to %g degrees %s"):format(other.limit, other.verdict) end
  end
  if #words == 0 then return end
  out.reason = ("Nothing is concluded, since it depends on the angles that are used: up to %g degrees %s, but %s."):format(t.limit, own, table.concat(words, ", "))
  for _, name in ipairs { "viscous", "modulus", "time", "low", "high", "contradicts", "open_below", "open_above" } do out[name] = nil end
  out.withheld = true
end

local function viscous(t)
  check.tests("viscous", t.tests)
  local out = analysed(t)
  if not out.one_speed then withhold(t, out) end
  out.text = text_of(out)
  if out.viscous then origin.remember(out, { viscous = (t.time and "fitted at a time that was typed, " or "") .. relaxation_words(out) }) end
  return out
end

define {
  name = "fabric.lab.viscous",
  arguments = {
    { name = "tests", kind = "table", sentence = "in shear, at several speeds or with holds: { {E=, S=, time=, name=}, ... } (E12, S12 in Pa, s), or bias pulls "
      .. "{displacement=, force=, width=, length=, time=} whose yarns do not stretch; speed= (m/s, of the crosshead) with displacement in place of the time" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "of the cloth, for bias pulls" },
    { name = "time", kind = "number", unit = "s", above = 0, optional = true, sentence = "known from elsewhere; default: found" },
    { name = "scatter", kind = "number", low = 0, high = 0.5, optional = true,
      sentence = "relative deviation of one specimen; default: found where three and more were tested at speeds that repeat, else 0.04" },
    { name = "knots", kind = "integer", low = 3, high = 40, default = 10, sentence = "intervals of the elastic curve" },
    { name = "limit", kind = "number", unit = "degrees", above = 0, high = 90, default = 30, sentence = "shear angle up to which rows count" },
    { name = "level", kind = "number", above = 0, high = 0.999, default = 0.95, sentence = "of confidence" },
  },
  sentence = "The part of shear that relaxes (viscous of a card) from tests at several speeds or with holds: viscous {shear {modulus, time}} or nil where the "
    .. "tests do not tell it, modulus, time, low and high {modulus, time, viscosity} (by the profile of the sum of squares), open_below, open_above (the "
    .. "time is not determined), contradicts (the faster is the softer), speed {ratio, low, high, decades}, ratio {angle, E, ratio, low, high} (the fastest over the slowest against the angle), "
    .. "withheld (the conclusion depends on the angles that are used: none is drawn), by_limit ({limit, verdict}, ...), elastic {E, S}, shear (for fabric.lab.card), "
    .. "scatter, rms, profile, reason, text.",
  example = "local E, S, time = {}, {}, {}\nfor k = 1, 200 do\n  time[k] = k / 10\n  E[k] = math.min(0.05, 0.05 * time[k])\n"
    .. "  local q = 2e6 * 3 * 0.05 * (1 - math.exp(-math.min(1, time[k]) / 3)) * math.exp(-math.max(0, time[k] - 1) / 3)\n  S[k] = 4e6 * E[k] + q\nend\n"
    .. "local v = require 'fabric'.lab.viscous{ tests={ { E=E, S=S, time=time } } }\n"
    .. "assert(math.abs(v.modulus / 2e6 - 1) < 0.01 and math.abs(v.time / 3 - 1) < 0.01)",
  run = viscous,
}
