-- The drape tester: shadows and folds of shapes that are known, a disc that hardly bends against a plate's closed form, a limp one, seeds.
local fabric = require "fabric"
local shadow = require "fabric.lab.virtual.shadow"
local checks = {}
local function check(name, got, want, more) checks[#checks + 1] = { name, got, want, relative = more == nil and 1e-12 or more.relative, absolute = more and more.absolute } end

-- --- shadow: a ring whose rim is at r(angle), from the circle of `inner` out, in `across` bands
local function ring(inner, r, around, across)
  local x, y, triangles = {}, {}, {}
  for j = 0, across do
    for i = 0, around - 1 do
      local angle = 2 * math.pi * i / around
      local radius = inner + (r(angle) - inner) * j / across
      x[#x + 1], y[#y + 1] = radius * math.cos(angle), radius * math.sin(angle)
    end
  end
  for j = 0, across - 1 do
    for i = 0, around - 1 do
      local a, b = j * around + i + 1, j * around + (i + 1) % around + 1
      triangles[#triangles + 1] = { a, b, b + around }
      triangles[#triangles + 1] = { a, b + around, a + around }
    end
  end
  return x, y, triangles
end

-- Chords of 1/7200 of a turn miss 1.3e-7 of a circle's area and 1e-8 of a radius.
for _, case in ipairs { { 0, 0, "a circle" }, { 0.01, 5, "five waves" }, { 0.02, 2, "two waves" } } do
  local a, b, n = 0.1, case[1], case[2]
  local x, y, triangles = ring(0.06, function(angle) return a + b * math.cos(n * angle) end, 7200, 1)
  local area, outline = shadow.of(x, y, triangles, 0.06)
  check(case[3] .. ": area", area, math.pi * (a * a + b * b / 2), { relative = 1e-6 })
  local nodes, amplitude, places = shadow.folds(outline, 0.002)
  check(case[3] .. ": nodes", nodes, n, { absolute = 0 })
  check(case[3] .. ": amplitude", amplitude, b, { absolute = b * (n * math.pi / 720) ^ 2 / 2 + 1e-8 }) -- a top lies up to half a step from a ray
  for i, place in ipairs(places) do
    local off = math.deg(shadow.angle(place, 720)) * n / 360 % 1
    check(case[3] .. ": place of top " .. i, math.min(off, 1 - off), 0, { absolute = 0.5 * n / 360 })
  end
end

-- A coarse polygon, rays in between: r of a chord, whose area is that of the polygon.
do
  local n = 24
  local x, y, triangles = ring(0.05, function() return 0.1 end, n, 2)
  check("a polygon's area", shadow.of(x, y, triangles, 0.05, 7200), n / 2 * 0.01 * math.sin(2 * math.pi / n), { relative = 1e-5 })
end

-- A flap folded back over the cloth is no more shadow, one that sticks out past a gap is.
do
  local x, y, triangles = ring(0.05, function() return 0.1 end, 360, 2)
  local plain = shadow.of(x, y, triangles, 0.05)
  local function with(corners)
    local first, all = #x, table.move(triangles, 1, #triangles, 1, {})
    local u, v = table.move(x, 1, #x, 1, {}), table.move(y, 1, #y, 1, {})
    for i, p in ipairs(corners) do u[first + i], v[first + i] = p[1], p[2] end
    all[#all + 1] = { first + 1, first + 2, first + 3 }
    return shadow.of(u, v, all, 0.05, 7200)
  end
  check("a flap folded back", with { { 0.08, -0.01 }, { 0.09, 0.01 }, { 0.06, 0.01 } }, plain, { relative = 2e-5 })
  check("a triangle beyond a gap", with { { 0.12, -0.01 }, { 0.14, 0 }, { 0.12, 0.01 } } - plain, 2e-4, { relative = 2e-3 })
end

-- --- folds: what is lower than the least does not count
do
  local outline = {}
  for k = 1, 720 do
    local angle = math.rad(k / 2)
    outline[k] = 0.1 + 0.01 * math.cos(4 * angle) + 0.0005 * math.cos(31 * angle)
  end
  check("four folds under ripples", (shadow.folds(outline, 0.002)), 4, { absolute = 0 })
  check("with the ripples", (shadow.folds(outline, 1e-6)) > 4 and 1 or 0, 1, { absolute = 0 })
  local flat = {}
  for k = 1, 720 do flat[k] = k <= 360 and 0.1 or 0.11 end
  local nodes, amplitude = shadow.folds(flat, 0.002)
  check("one step up and down", nodes, 1, { absolute = 0 })
  check("its amplitude", amplitude, 0.005, { absolute = 1e-12 })
end

-- --- a disc that hardly bends: its rim sinks as that of a plate, clamped inside and free outside, does; the shadow is all there
local function plate(q, D, a, b)
  local c4 = -q * b * b / (8 * D)
  -- C2 and C3 from w'(a) = 0 and w''(b) = 0 (no contraction across); C1 from w(a) = 0.
  local r1 = -(q * a ^ 3 / (16 * D) + c4 * (2 * a * math.log(a) + a))
  local r2 = -(3 * q * b * b / (16 * D) + c4 * (2 * math.log(b) + 3))
  local determinant = 2 / a + 2 * a / b ^ 2
  local c2, c3 = (2 * r1 - 2 * a * r2) / determinant, (r2 / a + r1 / b ^ 2) / determinant
  local function w(r) return q * r ^ 4 / (64 * D) + c2 * math.log(r) + c3 * r * r + c4 * r * r * math.log(r) end
  return w(b) - w(a)
end

local function sheet(B, stretch)
  return fabric.svk { name = "sheet", young = stretch or 5e6, poisson = 0, density = 500, thickness = 0.3e-3, bending = { warp = B, weft = B, twist = B / 2 } }
end

do
  local r = fabric.lab.cusick { card = sheet(4e-3), disc = 0.254, support = 0.127, cells = 8, offset = 1e-6, lowering = 0.2, damping = 20 }
  check("a stiff disc: coefficient", r.coefficient, 1, { absolute = 1e-3 })
  check("a stiff disc: folds", r.nodes, 0, { absolute = 0 })
  check("a stiff disc: at rest", r.at_rest and 1 or 0, 1, { absolute = 0 })
  local sunk, rim = 0, r.mesh:set "outer"
  for _, n in ipairs(rim) do sunk = sunk - r.analysis:node(n).uz / #rim end
  -- 1 %: elements of an eighth of the overhang
  check("a stiff disc: its rim sinks as a plate's", sunk, plate(500 * 0.3e-3 * 9.80665, 4e-3, 0.0635, 0.127), { relative = 0.01 })
end

-- By relaxation: the plate's closed form in one step, and a softer disc is where slow motion brings it, whatever the shares of the weight.
do
  local r = fabric.lab.cusick { card = sheet(4e-3), disc = 0.254, support = 0.127, cells = 8, offset = 1e-6, by = "relaxation", steps = 1, contact = false }
  local sunk, rim = 0, r.mesh:set "outer"
  for _, n in ipairs(rim) do sunk = sunk - r.analysis:node(n).uz / #rim end
  check("a stiff disc, relaxed: its rim sinks as a plate's", sunk, plate(500 * 0.3e-3 * 9.80665, 4e-3, 0.0635, 0.127), { relative = 0.01 })
  local t = { card = sheet(1e-4, 1e5), disc = 0.24, support = 0.12, cells = 3, around = 36, contact = false, damping = 10, lowering = 1.5 }
  local moved = fabric.lab.cusick(t)
  t.by, t.damping, t.lowering = "relaxation", nil, nil
  local relaxed = fabric.lab.cusick(t)
  check("a softer disc bends", relaxed.coefficient < 0.97 and 1 or 0, 1, { absolute = 0 })
  check("relaxed as moved: coefficient", relaxed.coefficient, moved.coefficient, { absolute = 2e-3 })
  check("relaxed as moved: folds", relaxed.nodes, moved.nodes, { absolute = 0 })
  t.steps = 3
  check("shares of the weight do not matter to elastic cloth", fabric.lab.cusick(t).coefficient, relaxed.coefficient, { absolute = 1e-4 })
end

do -- what would give a wrong number, or none for hours
  local function refused(words, t)
    t.disc, t.support = 0.3, 0.18
    local ok, message = pcall(fabric.lab.cusick, t)
    assert(not ok and tostring(message):find(words, 1, true), message)
  end
  refused("field 'held': expected the diameter of the support", { card = sheet(2e-6), contact = false, held = 0.1 })
  refused("field 'card': expected a card with bending of its own", { card = fabric.card "blend", by = "relaxation" })
end

-- --- a limp disc hangs down in folds, and two seeds side by side are what each is alone, to the last bit
do
  local t = { card = sheet(2e-6, 1e6), disc = 0.24, support = 0.18, cells = 3, around = 36, lowering = 0.05, duration = 0.15, window = 0.05, still = 1,
    damping = 20 }
  local one = fabric.lab.cusick(t)
  check("a limp disc: less shadow", one.coefficient < 0.9 and one.coefficient > 0 and 1 or 0, 1, { absolute = 0 })
  check("the scatter of one disc is not known", one.scatter.coefficient ~= one.scatter.coefficient and 1 or 0, 1, { absolute = 0 })
  check("nothing passes", one.analysis:gap() > 0 and 1 or 0, 1, { absolute = 0 })
  check("the ledger is closed", one.runs[1].error, 0, { absolute = 1e-3 })
  check("its contour", #one.contour, 720, { absolute = 0 })
  t.seeds, t.processes, t.file = 2, 2, "two.svg"
  local two = fabric.lab.cusick(t)
  check("the first of two", two.runs[1].coefficient, one.coefficient, { absolute = 0 })
  check("mean of two", two.coefficient, (two.runs[1].coefficient + two.runs[2].coefficient) / 2)
  check("scatter of two", two.scatter.coefficient, math.abs(two.runs[1].coefficient - two.runs[2].coefficient) / math.sqrt(2), { relative = 1e-9 })
  local picture = io.open("two.svg"):read "a"
  local _, outlines = picture:gsub("<polygon", "")
  check("outlines", outlines, 2, { absolute = 0 })
  check("the second is told from the first by its pattern too, and so is its line in the legend", select(2, picture:gsub('stroke%-dasharray="7 3"', "")), 2, { absolute = 0 })
  check("they differ", two.runs[1].coefficient ~= two.runs[2].coefficient and 1 or 0, 1, { absolute = 0 })
end

fabric.expect(checks)
