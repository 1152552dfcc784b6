-- fabric.lab.wear: what cloth that is worn does to the body and to its wearer, from one time to another, for instance over a cycle of motion.
--
-- At equal times the pressure of the cloth on each vertex of the body is read (analysis:on_body), and where on it each node of the cloth touches.
-- In explicit motion contact chatters, so that pressures are means over `window`, and peaks also over discs of skin of the radius `patch`, as a
-- sensor that lies on the skin measures them: the pressure of a single vertex at a single time has no limit as meshes get finer.
local define = require "fabric.define"
local fabric = require "fabric"
local lists = require "fabric.lists"

-- Cloth folds before its yarns are compressed by this much. Elements that are larger than the folds are compressed instead, carry a load that
-- the cloth would not, and press with it; unless their yarns carry next to nothing then (fabric.lab.tension_field): less than this part of what
-- they carry when they are stretched as much.
-- Folds within the element (folds= of the model or card) do the same: they have taken more than this part of what it is shorter.
local folds_at, slack_below, folded_at = 0.01, 0.05, 0.5

local function fail(field, words) define.fail(("wear: field '%s': %s"):format(field, words)) end

-- --- regions and discs of skin, by numbers of the body's vertices

local function regions_of(t)
  local regions = {}
  for _, name in ipairs(t.regions or t.mesh.sets) do
    if type(name) ~= "string" then fail("regions", "expected names of sets of the body's mesh, got " .. tostring(name)) end
    if t.regions or (name ~= "all" and name ~= "boundary") then regions[#regions + 1] = { name = name, nodes = t.mesh:set(name) } end
  end
  table.insert(regions, 1, { name = "all", nodes = t.mesh:set "all" })
  return regions
end

-- Of each vertex, those nearer to it than the radius, in the body's shape at time 0, itself included.
local function discs_of(nodes, radius)
  local cells, discs = {}, {}
  local function key(p, i, j, k) return ("%d %d %d"):format(p[1] // radius + i, p[2] // radius + j, p[3] // radius + k) end
  for v, p in ipairs(nodes) do
    local cell = key(p, 0, 0, 0)
    cells[cell] = cells[cell] or {}
    table.insert(cells[cell], v)
  end
  for v, p in ipairs(nodes) do
    local disc = {}
    for i = -1, 1 do
      for j = -1, 1 do
        for k = -1, 1 do
          for _, w in ipairs(cells[key(p, i, j, k)] or {}) do
            local q = nodes[w]
            if (p[1] - q[1]) ^ 2 + (p[2] - q[2]) ^ 2 + (p[3] - q[3]) ^ 2 <= radius ^ 2 then disc[#disc + 1] = w end
          end
        end
      end
    end
    discs[v] = disc
  end
  return discs
end

-- --- what is gathered: in `state`, a plain table, which a checkpoint may keep

local function begin(state, count, regions)
  if state.samples then return end
  state.samples, state.force, state.area, state.last, state.paths, state.rows, state.energies = 0, {}, {}, {}, {}, {}, {}
  state.map = { mean = {}, largest = {}, times = 0 }
  state.regions, state.tension = {}, { warp = { value = -math.huge }, weft = { value = -math.huge } }
  state.beyond, state.compressed = { value = 0 }, { value = 0 }
  for v = 1, count do state.force[v], state.area[v], state.map.mean[v], state.map.largest[v] = 0, 0, 0, 0 end
  for _, region in ipairs(regions) do state.regions[region.name] = { mean = 0, peak = 0, sum = 0, touched = 0 } end
end

-- The way that a node slides over the skin from reading to reading, while it touches at both, in the body's shape at time 0.
local function slide(state, touch)
  local now = {}
  for i, node in ipairs(touch.node) do
    local x, y, z = touch.x[i], touch.y[i], touch.z[i]
    now[node] = { x, y, z }
    local was = state.last[node]
    if was then state.paths[node] = (state.paths[node] or 0) + math.sqrt((x - was[1]) ^ 2 + (y - was[2]) ^ 2 + (z - was[3]) ^ 2) end
  end
  state.last = now
end

local function largest(of, values, time)
  for e, value in ipairs(values) do
    if value > of.value then of.value, of.element, of.time = value, e, time end
  end
end

-- By how much the yarns of each element are shorter than in the reference, over their length there.
local function compression(run)
  local warp, weft = run:field "nominal_strain_warp", run:field "nominal_strain_weft"
  for e = 1, #warp do warp[e] = -math.min(warp[e], weft[e]) end
  return warp
end

-- The means of a window: pressure of each vertex, region and disc.
local function close_window(t, state, regions, discs, time)
  local p, row, most = {}, { time = time }, 0
  for v, f in ipairs(state.force) do
    p[v] = state.area[v] > 0 and f / state.area[v] or 0
    state.map.mean[v], state.map.largest[v] = state.map.mean[v] + p[v], math.max(state.map.largest[v], p[v])
    most = math.max(most, p[v])
  end
  local pressed = 1e-6 * most -- what is less is rounding, at the rim of a facet that the cloth ends on
  state.map.times = state.map.times + 1
  for _, region in ipairs(regions) do
    local force, area, touched, r = 0, 0, 0, state.regions[region.name]
    for _, v in ipairs(region.nodes) do
      force, area = force + state.force[v], area + state.area[v]
      if p[v] > pressed then touched = touched + state.area[v] end
    end
    local mean = area > 0 and force / area or 0
    row[region.name], r.sum, r.touched = mean, r.sum + mean, math.max(r.touched, touched / math.max(area, 1e-300))
    if mean > r.mean then r.mean, r.mean_time = mean, time end
    for _, v in ipairs(region.nodes) do
      if p[v] > pressed then
        local f, a = 0, 0
        for _, w in ipairs(discs[v]) do f, a = f + state.force[w], a + state.area[w] end
        if f / a > r.peak then r.peak, r.peak_time, r.peak_vertex = f / a, time, v end
      end
    end
  end
  for v = 1, #state.force do state.force[v], state.area[v] = 0, 0 end
  state.rows[#state.rows + 1] = row
  return row
end

local function observe(t, state, regions, discs)
  local a = t.analysis
  local first, per = t.times[1], t.samples
  local every = t.window / per
  begin(state, #t.mesh.nodes, regions)
  local number = 0
  a:every(every, function(run)
    if run.time <= first * (1 + 1e-12) or run.time > t.times[#t.times] * (1 + 1e-9) then return end
    local on = run:on_body(t.body)
    if #on.area ~= #t.mesh.nodes then fail("mesh", ("expected the mesh of the body's facets, %d nodes, got %d nodes"):format(#on.area, #t.mesh.nodes)) end
    for v, area in ipairs(on.area) do state.force[v], state.area[v] = state.force[v] + on.pressure[v] * area, state.area[v] + area end
    slide(state, on.touch)
    state.samples = state.samples + 1
    number = state.samples
    if number % per ~= 0 then return end
    largest(state.tension.warp, run:field "tension_warp", run.time)
    largest(state.tension.weft, run:field "tension_weft", run.time)
    largest(state.beyond, run:field "beyond", run.time)
    local c = state.compressed
    largest(c, compression(run), run.time)
    if c.time == run.time then c.folded = run:field "folded"[c.element] end
    close_window(t, state, regions, discs, run.time)
  end)
end

-- --- the result

local function add_regions(result, t, state, regions)
  for _, region in ipairs(regions) do
    local r = state.regions[region.name]
    local place = r.peak_vertex and t.mesh.nodes[r.peak_vertex]
    result.regions[region.name] = {
      mean = r.mean, mean_time = r.mean_time, usual = r.sum / math.max(state.map.times, 1), touched = r.touched,
      peak = r.peak, peak_time = r.peak_time, peak_at = place and { place[1], place[2], place[3] } or nil,
    }
  end
  for v = 1, #state.map.mean do
    result.map.mean[v], result.map.largest[v] = state.map.mean[v] / math.max(state.map.times, 1), state.map.largest[v]
  end
end

local function add_slip(result, state)
  local sum, count = 0, 0
  for node, path in pairs(state.paths) do
    count = count + 1
    sum = sum + path
    if path > result.slip.largest or (path == result.slip.largest and node < (result.slip.node or math.huge)) then result.slip.largest, result.slip.node = path, node end
  end
  result.slip.nodes, result.slip.mean = count, count > 0 and sum / count or 0
end

-- The dissipation of the cloth has the parts of its law; the friction of contact and the loss by impact are beside them in `dissipated`.
local of_cloth = { "dissipated_warp", "dissipated_weft", "dissipated_shear", "dissipated_bending" }
local beside = { "stored", "kinetic", "friction", "damping", "impact", "fracture" }

local function energies(a)
  return lists.copy(a.energy)
end

local function work_between(was, is)
  local row = { work = is.external - was.external, cloth = 0 }
  for _, name in ipairs(of_cloth) do row.cloth = row.cloth + is[name] - was[name] end
  for _, name in ipairs(beside) do row[name] = is[name] - was[name] end
  return row
end

-- Whether the yarns of a card give way where they are shortened.
local function gives_way(card)
  for _, yarn in ipairs { "warp", "weft" } do
    local function stress(E) return fabric.point(card):uniaxial(yarn, E).S end
    if not (-stress(-folds_at) < slack_below * stress(folds_at)) then return false end
  end
  return true
end

-- Whether the card states compression; and whether pressures depend on the mesh for it.
local function fold_words(result)
  local c = result.compressed
  local words = ("yarns are compressed by up to %.2g %%"):format(100 * c.value)
  if c.value < folds_at then return words end
  if result.gives_way then return words .. ", and carry next to nothing then: these are folds" end
  return ("yarns are compressed by up to %.2g %% (element %d, at %.4g s), where a finer mesh folds: pressures about there depend on the mesh"):format(100 * c.value, c.element,
    c.time), true
end

local function text(result)
  local lines = { ("pressure on the body, means over %.3g ms, peaks over discs of %.3g mm:"):format(1e3 * result.window, 1e3 * result.patch) }
  lines[#lines + 1] = ("%-16s %12s %12s %12s %10s"):format("region", "usual, Pa", "largest, Pa", "peak, Pa", "touched, %")
  for _, name in ipairs(result.names) do
    local r = result.regions[name]
    lines[#lines + 1] = ("%-16s %12.4g %12.4g %12.4g %10.0f"):format(name, r.usual, r.mean, r.peak, 100 * r.touched)
  end
  for k, c in ipairs(result.cycles) do
    lines[#lines + 1] = ("%g to %g s: work %.4g mJ; taken by the cloth %.4g, friction %.4g, damping %.4g, impact %.4g mJ; stored %.4g mJ more"):format(
      result.times[k], result.times[k + 1], 1e3 * c.work, 1e3 * c.cloth, 1e3 * c.friction, 1e3 * c.damping, 1e3 * c.impact, 1e3 * c.stored)
  end
  lines[#lines + 1] = ("slip on the skin: %.3g mm in the mean of %d nodes that touched, %.3g mm at most (node %s)"):format(
    1e3 * result.slip.mean, result.slip.nodes, 1e3 * result.slip.largest, result.slip.node or "-")
  lines[#lines + 1] = ("tension: warp up to %.4g N/m, weft up to %.4g N/m"):format(result.tension.warp.value, result.tension.weft.value)
  lines[#lines + 1] = result.beyond.value == 0 and "strain beyond what was tested: the card does not say what was tested, or nothing was stretched"
    or ("strain: up to %.3g of what was tested (element %d)"):format(result.beyond.value, result.beyond.element)
  lines[#lines + 1] = fold_words(result)
  lines[#lines + 1] = ("ledger %.1e, smallest gap above the floor %.3g mm"):format(result.ledger, 1e3 * result.gap)
  return table.concat(lines, "\n")
end

local function add_files(t, regions)
  local a, columns, order, units = t.analysis, {}, {}, {}
  for _, region in ipairs(regions) do
    order[#order + 1], units[region.name] = region.name, "Pa"
    columns[region.name] = function()
      local row = t.state.rows and t.state.rows[#t.state.rows]
      return row and row[region.name] or 0
    end
  end
  a:record(t.out .. "/pressure.csv", { columns = columns, order = order, every = t.window, units = units })
  a:vtk(t.out .. "/worn", { every = t.window })
end

local function check_times(t)
  local a = t.analysis
  if #t.times < 2 then fail("times", "expected where it begins and ends, two or more times, got " .. #t.times) end
  for k = 2, #t.times do
    if not (t.times[k] > t.times[k - 1]) then fail("times", ("expected ascending times, got %g s behind %g s"):format(t.times[k], t.times[k - 1])) end
  end
  if t.times[#t.times] > a.duration * (1 + 1e-12) then
    fail("times", ("expected at most the duration of the run, %g s, got %g s"):format(a.duration, t.times[#t.times]))
  end
  if a.time > t.times[1] * (1 + 1e-12) and not t.state then fail("times", ("the run is at %g s: expected times from there on, got %g s"):format(a.time, t.times[1])) end
  t.window = t.window or (t.times[#t.times] - t.times[1]) / (#t.times - 1) / 40
end

local function run(t)
  local a = t.analysis
  check_times(t)
  t.state = t.state or {}
  local regions = regions_of(t)
  observe(t, t.state, regions, discs_of(t.mesh.nodes, t.patch))
  if t.out then add_files(t, regions) end
  local result = { times = t.times, window = t.window, patch = t.patch, names = {}, regions = {}, cycles = {}, rows = t.state.rows, slip = { largest = 0, mean = 0 },
                   map = { mean = {}, largest = {} }, tension = t.state.tension, beyond = t.state.beyond,
                   compressed = t.state.compressed, gap = math.huge }
  for k = 1, #t.times do
    if a.time < t.times[k] * (1 - 1e-12) then a:advance(t.times[k]) end
    -- A run that was taken up behind this time has its energies from then in what it kept.
    t.state.energies[k] = t.state.energies[k] or energies(a)
    if k > 1 then result.cycles[k - 1] = work_between(t.state.energies[k - 1], t.state.energies[k]) end
  end
  local c = result.compressed
  result.gives_way = c.value >= folds_at and ((c.folded or 0) > folded_at or gives_way(a.model.card))
  for _, region in ipairs(regions) do result.names[#result.names + 1] = region.name end
  add_regions(result, t, t.state, regions)
  add_slip(result, t.state)
  result.gap, result.ledger = a:gap(), a.energy.error
  result.text = text(result)
  local words, unresolved = fold_words(result)
  if unresolved and not fabric.checking() then fabric.warn("wear: " .. words) end
  if t.out and not fabric.checking() then
    local file = assert(io.open(t.out .. "/worn.txt", "w"))
    file:write(result.text, "\n")
    file:close()
  end
  return result
end

define {
  name = "fabric.lab.wear",
  arguments = {
    { name = "analysis", of = "analysis", sentence = "a run of cloth on a body, as fabric.lab.dress leaves it" },
    { name = "body", of = "body", sentence = "of facets (fabric.rigid.limb, torso, surface, motion)" },
    { name = "mesh", of = "mesh", sentence = "of its facets at time 0, whose sets name its regions" },
    { name = "times", kind = "numbers", unit = "s", sentence = "{begins, ends of the cycles of motion}" },
    { name = "regions", kind = "table", optional = true, sentence = "names of sets of the mesh; default: all of its sets" },
    { name = "window", kind = "number", unit = "s", above = 0, optional = true, sentence = "over which pressures are means; default: a fortieth of a cycle" },
    { name = "samples", kind = "integer", low = 1, default = 8, sentence = "readings in a window" },
    { name = "patch", kind = "number", unit = "m", above = 0, default = 0.02, sentence = "radius of the discs of skin over which peaks are means" },
    { name = "state", kind = "table", optional = true, sentence = "an empty table to gather in, for `keep` of a:checkpoint, so that a restart goes on with it" },
    { name = "out", kind = "text", optional = true, sentence = "folder for pressure.csv, worn.pvd (cloth and body, with the pressure on it) and worn.txt" },
  },
  sentence = "Effects of worn cloth on the body and its wearer: runs through the times and returns regions (of each name, and of all: mean, Pa, the largest of its mean pressures over time, usual, their mean over time, "
    .. "peak, the largest over a disc of skin, peak_at, m, its middle on the body at time 0, touched, the largest share of its area), map (mean and largest of each vertex, Pa), rows (the mean pressures over time), "
    .. "cycles (of each: work, J, that moves the body, supports and loads did, and what became of it: cloth, what the law of the cloth dissipated, friction, damping, impact, fracture, stored, kinetic), slip (m, on the skin: largest and its node, mean, nodes), "
    .. "tension (warp, weft: value, N/m, element, time), beyond (strain over the tested strain of the card), compressed (how much shorter yarns get: value, element, time, folded: the part that folds within the element took; from 1 % on, where a finer mesh would fold, a warning says so), gives_way (whether the yarns of the card carry next to nothing then, or folds within elements took it), gap, ledger, and text, all of this in words.",
  example = "local face = fabric.mesh.rectangle{ width=0.08, height=0.08, nx=2, ny=2, origin={-0.01, -0.01, 0} }\n"
    .. "face:set('left half', function(x) return x < 0.03 end)\n"
    .. "local slab = fabric.rigid.surface{ mesh=face, name='slab' }\n"
    .. "local cloth = fabric.mesh.rectangle{ width=0.06, height=0.06, nx=2, ny=2, origin={0, 0, 4e-4} }\n"
    .. "local m = fabric.model{ mesh=cloth, card=fabric.card 'blend', warp=0 }\n"
    .. "m:contact{ between={slab, 'all'}, friction=0.3 }:gravity{0, 0, -9.81}\n"
    .. "local a = fabric.dynamic{ model=m, duration=4e-3, damping={ mass=300 } }\n"
    .. "local worn = fabric.lab.wear{ analysis=a, body=slab, mesh=face, times={ 2e-3, 4e-3 } }\n"
    .. "assert(worn.ledger < 1e-2 and #worn.cycles == 1)",
  run = run,
}
