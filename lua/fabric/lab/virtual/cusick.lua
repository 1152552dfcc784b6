-- fabric.lab.cusick: the drape tester: a disc of cloth is held between two smaller plates, and the shadow of what hangs down is measured [bs_5058].
--
--       ________________     plate on top
--    ---================---  cloth, level at first: z = 0
--       (______________)     pedestal: face, rounded edge
--        |            |      and side
--
-- Cloth between the plates does not move and is left out of the mesh. The weight of the cloth rises slowly from zero, along half a cosine, as
-- where a table sinks away under it. Where it comes at once, the sheet buckles into many small folds, and friction keeps them.
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local random = require "fabric.lab.random"
local shadow = require "fabric.lab.virtual.shadow"
local fabric = require "fabric"
local lists = require "fabric.lists"

local gravity = 9.80665 -- m/s^2
local rays = 720 -- of the shadow, half a degree each

-- A ring of cloth from the plate's rim out, elements nearly square in the middle of the overhang. How uneven it lies is a sum of waves around it that
-- grow from the edge to the rim, the longer the higher, of the same shape on every mesh.
local function cloth(t, draw)
  local rim, edge, inner = t.disc / 2, t.support / 2, t.held / 2
  local size = (rim - edge) / t.cells
  local around = t.around or 4 * math.max(6, math.floor(math.pi * (rim + edge) / size / 4 + 0.5))
  local across = math.max(2, math.floor((rim - inner) / size + 0.5))
  local mesh = fabric.mesh.annulus { inner = inner, outer = rim, around = around, across = across }
  local waves, sum = { { 0, 0 } }, 0
  for n = 2, 12 do
    waves[n] = { draw.normal() / n, draw.normal() / n }
    sum = sum + (waves[n][1] ^ 2 + waves[n][2] ^ 2) / 2
  end
  mesh:map(function(x, y, z)
    local r, angle, offset = math.sqrt(x * x + y * y), math.atan(y, x), 0
    if r <= edge then return x, y, z end
    for n = 2, #waves do offset = offset + waves[n][1] * math.cos(n * angle) + waves[n][2] * math.sin(n * angle) end
    return x, y, z + t.offset * offset / math.sqrt(sum) * ((r - edge) / (rim - edge)) ^ 2
  end)
  return mesh
end

-- The cloth's middle surface lies where contact with the face begins.
local function pedestal(t, model)
  local top = -kernels.free_thickness(t.card) / 2
  local disc = fabric.rigid.disc { radius = t.support / 2, centre = { 0, 0, top - t.edge }, normal = { 0, 0, 1 }, edge = t.edge, name = "pedestal" }
  model:contact { between = { disc, "all" }, friction = t.friction }
  if t.side > 0 then
    local wall = fabric.mesh.cylinder { radius = t.support / 2, length = t.side, around = 96, along = 1 }
    wall:map(function(x, y, z) return x, y, z - t.side + top - t.edge end)
    model:contact { between = { fabric.rigid.surface { mesh = wall, name = "side" }, "all" }, friction = t.friction }
  end
  if t.self then model:contact { self = "all", friction = t.friction } end
end

-- Weight over time: half a cosine wave.
local function weight(t)
  return function(time) return -gravity * (time < t.lowering and (1 - math.cos(math.pi * time / t.lowering)) / 2 or 1) end
end

-- Stops the run at rest: over `window` no place of the rim has moved by more than `still` of the overhang, and the kinetic energy is below
-- 1e-5 of what the weight has done.
local function rests(t, a, rim, from)
  local out, last = { at_rest = false }, nil
  a:every(t.window, function(run)
    local x, y, z = run:field "x", run:field "y", run:field "z"
    local moved = math.huge
    if last then
      moved = 0
      for i, n in ipairs(rim) do
        local p = last[i]
        moved = math.max(moved, (x[n] - p[1]) ^ 2 + (y[n] - p[2]) ^ 2 + (z[n] - p[3]) ^ 2)
      end
    end
    last = {}
    for i, n in ipairs(rim) do last[i] = { x[n], y[n], z[n] } end
    local e = run.energy
    out.moved = math.sqrt(moved)
    if run.time >= from + t.window and out.moved <= t.still * (t.disc - t.support) / 2 and e.kinetic <= 1e-5 * math.abs(e.external) then
      out.at_rest = true
      run:stop "at rest"
    end
  end)
  return out
end

local function points_of(outline)
  local out = {}
  for k, r in ipairs(outline) do
    local angle = shadow.angle(k, #outline)
    out[k] = { r * math.cos(angle), r * math.sin(angle) }
  end
  return out
end

-- Readings of the shadow of a shape: coefficient, nodes, amplitude, outline.
local function reading(t, mesh, x, y)
  local triangles = shadow.triangles(mesh)
  local flat_x, flat_y = {}, {}
  for i, node in ipairs(mesh.nodes) do flat_x[i], flat_y[i] = node[1], node[2] end
  local whole = shadow.of(flat_x, flat_y, triangles, t.support / 2, rays)
  local area, outline = shadow.of(x, y, triangles, t.support / 2, rays)
  local ground = math.pi * t.support ^ 2 / 4
  local corner = t.disc / 2 * (1 - math.cos(math.pi / #mesh:set "outer")) -- by which the rim's polygon stands out of its chords
  local nodes, amplitude = shadow.folds(outline, math.max(0.03 * (t.disc - t.support) / 2, 2 * corner))
  return (area - ground) / (whole - ground), nodes, amplitude, outline
end

local usual -- values of fields that are not given

-- Without contact: whether the cloth hangs where the pedestal is.
local function inside(t, x, y, z)
  for i = 1, #x do
    if z[i] < -2 * usual.edge and x[i] ^ 2 + y[i] ^ 2 < (0.995 * t.support / 2) ^ 2 then return true end
  end
  return false
end

-- In motion until it rests.
local function moved(t, model, rim, seed)
  local history, from = weight(t), t.lowering
  model:gravity { 0, 0, history }
  local a = fabric.dynamic { model = model, duration = t.duration, damping = t.damping > 0 and { mass = t.damping } or nil }
  if t.out then a:vtk(("%s/seed%d"):format(t.out, seed), { every = t.every }) end
  local rest = rests(t, a, rim, from)
  a:solve()
  return a, rest
end

-- Through equilibria under growing fractions of the weight; time is that share. The tolerance is one of the largest force, which in stiff yarns that lie across the
-- mesh is far above the weight: at 1e-4 whole shares of it are within.
local function relaxed(t, model, seed)
  model:gravity { 0, 0, fabric.ramp(-gravity, 1) }
  local a = fabric.static { model = model, duration = 1, step = 1 / t.steps, method = "relaxation", tolerance = 1e-5 }
  if t.out then a:vtk(("%s/seed%d"):format(t.out, seed)) end
  a:solve()
  return a, { at_rest = true, moved = 0 }
end

-- One disc, let down once.
local function once(t, seed)
  local draw = random(seed)
  local orientation = t.orientation or 360 * draw.uniform()
  local mesh = cloth(t, draw)
  local model = fabric.model { mesh = mesh, card = t.card, warp = orientation, points = t.card.bending and 1 or 3 }
  if t.contact then pedestal(t, model) end
  model:fix("inner", "x y z rotation")
  local a, rest
  if t.by == "relaxation" then
    a, rest = relaxed(t, model, seed)
  else
    a, rest = moved(t, model, mesh:set "outer", seed)
  end
  local one = { seed = seed, orientation = orientation, at_rest = rest.at_rest, moved = rest.moved, time = a.time, error = a.energy.error }
  one.coefficient, one.nodes, one.amplitude, one.outline = reading(t, mesh, a:field "x", a:field "y")
  one.inside = not t.contact and inside(t, a:field "x", a:field "y", a:field "z")
  return one, a, model, mesh
end

-- Seeds side by side: what goes through lists of numbers and comes back.
local head = { "seed", "orientation", "at_rest", "moved", "time", "error", "coefficient", "nodes", "amplitude", "inside" }

local function packed(one)
  local out = {}
  for i, name in ipairs(head) do
    local value = one[name]
    out[i] = type(value) == "boolean" and (value and 1 or 0) or value
  end
  return table.move(one.outline, 1, #one.outline, #head + 1, out)
end

local function unpacked(list)
  local one = { outline = {} }
  for i, name in ipairs(head) do one[name] = list[i] end
  one.at_rest, one.inside = one.at_rest == 1, one.inside == 1
  one.nodes, one.seed = math.tointeger(one.nodes), math.tointeger(one.seed)
  table.move(list, #head + 1, #list, 1, one.outline)
  return one
end

local function mean(runs, name)
  local sum, squares = 0, 0
  for _, one in ipairs(runs) do sum = sum + one[name] end
  sum = sum / #runs
  for _, one in ipairs(runs) do squares = squares + (one[name] - sum) ^ 2 end
  return sum, #runs > 1 and math.sqrt(squares / (#runs - 1)) or -(0 / 0)
end

-- The outlines over one another, as long as wide, each turned so that its warp goes to the right, with the level disc and the pedestal dashed.
local colours = { "#1f5fa8", "#d9541e", "#2f9e6e", "#8e44ad", "#b8860b", "#444444" }
local patterns = { "", "7 3", "2 2", "9 3 2 3", "12 4", "5 2 1 2 1 2", "1 4" } -- of the lines, one more than colours: no two of forty-two outlines are drawn alike
local function escaped(name) return (name:gsub("[<>&]", { ["<"] = "&lt;", [">"] = "&gt;", ["&"] = "&amp;" })) end

local function draw_contours(t, result)
  local size, line = 480, 18
  local scale, out = 0.9 * size / t.disc, {}
  local function add(form, ...) out[#out + 1] = form:format(...) end
  add('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" height="%d" font-family="sans-serif" font-size="13">', size,
    size + line * (#result.runs + 2), size, size + line * (#result.runs + 2))
  add '<rect width="100%%" height="100%%" fill="white"/>'
  add('<text x="%d" y="18" text-anchor="middle">%s, disc of %g mm on %g mm, warp to the right</text>', size // 2, escaped(t.card.name), 1e3 * t.disc, 1e3 * t.support)
  local x, y = size / 2, size / 2 + line
  for _, d in ipairs { t.disc, t.support } do add('<circle cx="%g" cy="%g" r="%.2f" fill="none" stroke="#999999" stroke-dasharray="4 4"/>', x, y, scale * d / 2) end
  for i, one in ipairs(result.runs) do
    local points, colour = {}, colours[(i - 1) % #colours + 1]
    local c, s = math.cos(math.rad(one.orientation)), math.sin(math.rad(one.orientation))
    for k, p in ipairs(one.contour) do points[k] = ("%.1f,%.1f"):format(x + scale * (c * p[1] + s * p[2]), y - scale * (c * p[2] - s * p[1])) end
    local pattern, level = patterns[(i - 1) % #patterns + 1], size + line * (i + 1)
    local stroke = ('stroke="%s" stroke-width="1.5"%s'):format(colour, pattern ~= "" and (' stroke-dasharray="%s"'):format(pattern) or "")
    add('<polygon points="%s" fill="none" %s/>', table.concat(points, " "), stroke)
    add('<line x1="24" y1="%d" x2="64" y2="%d" %s/>', level - 4, level - 4, stroke)
    add('<text x="72" y="%d">seed %d: %.1f %%, folds: %d</text>', level, one.seed, 100 * one.coefficient, one.nodes)
  end
  add "</svg>"
  fabric.write(t.file, table.concat(out, "\n") .. "\n")
end

-- Says which of the given fields do nothing in this test, so that nobody compares two discs that are the same.
local function warn_idle(t)
  local function warn(condition, names, why)
    local given = lists.collect(condition and names or {}, function(name) if t[name] ~= usual[name] then return name end end)
    if #given > 0 then fabric.warn(("cusick: %s: no effect %s"):format(table.concat(given, ", "), why)) end
  end
  warn(t.by == "relaxation", { "lowering", "damping", "still", "window", "duration", "every" }, 'with by = "relaxation", which knows no time')
  warn(t.by == "motion", { "steps" }, 'with by = "motion": they are the load steps of relaxation')
  warn(t.by == "motion" and not t.out, { "every" }, "without out, the folder of the VTK series")
  warn(not t.contact, { "edge", "side", "friction", "self" }, "with contact = false")
  warn(t.seeds == 1, { "processes" }, "with one seed")
end

local function check(t)
  local function refuse(field, expected, got) define.fail(("cusick: field '%s': expected %s, got %s"):format(field, expected, got)) end
  if t.support >= t.disc then refuse("support", ("a diameter below that of the disc, %g m"):format(t.disc), ("%g m"):format(t.support)) end
  if t.disc > 5 then refuse("disc", "a diameter in m, 5 m at most (write 300*mm)", ("%g m"):format(t.disc)) end
  if t.contact and 4 * t.edge > t.support then refuse("edge", ("at most a quarter of the support, %g m"):format(t.support / 4), ("%g m"):format(t.edge)) end
  if t.file and not t.file:find "%.svg$" then refuse("file", "a name that ends in .svg", "'" .. t.file .. "'") end
  t.held = t.held or t.support
  if t.held > t.support then refuse("held", ("at most the diameter of the support, %g m"):format(t.support), ("%g m"):format(t.held)) end
  if not t.contact and t.held < t.support then refuse("held", "the diameter of the support where contact = false holds the cloth at its edge", ("%g m"):format(t.held)) end
  if t.by == "relaxation" and not t.card.bending then
    refuse("card", 'a card with bending of its own with by = "relaxation", which creeps for hours without (fabric.card(name, { bending = "estimated" }))',
      "one that bends by its thickness")
  end
  warn_idle(t)
  t.side = t.side or t.disc / 2
  if t.by == "relaxation" then return end
  t.duration = t.duration or t.lowering + 4
  if t.duration <= t.lowering then refuse("duration", ("more than the lowering, %g s"):format(t.lowering), ("%g s"):format(t.duration)) end
end

local function run(t)
  check(t)
  local result = { runs = {} }
  if t.seeds == 1 or fabric.checking() then
    local one, a, model, mesh = once(t, t.seed)
    result.runs[1], result.analysis, result.model, result.mesh = one, a, model, mesh
  else
    for i, list in ipairs(fabric.lab.parallel { count = t.seeds, processes = t.processes, work = function(i) return packed(once(t, t.seed + i - 1)) end }) do
      if list.trouble then define.fail(("cusick: seed %d: %s"):format(t.seed + i - 1, list.trouble)) end
      result.runs[i] = unpacked(list)
    end
  end
  result.scatter, result.at_rest = {}, true
  for _, one in ipairs(result.runs) do
    one.contour = points_of(one.outline)
    result.at_rest = result.at_rest and one.at_rest
    if one.inside then fabric.warn(("cusick: seed %d: the cloth hangs where the pedestal is; contact = true would keep it out"):format(one.seed)) end
    if not one.at_rest and not fabric.checking() then
      local how = one.moved < math.huge and ("its rim still moves by %.2g mm in %g s"):format(1e3 * one.moved, t.window)
        or ("the run is shorter than the two windows of %g s that the rule of rest needs"):format(t.window)
      fabric.warn(("cusick: seed %d is not at rest after %g s: %s; a longer duration= would do"):format(one.seed, one.time, how))
    end
  end
  for _, name in ipairs { "coefficient", "nodes", "amplitude" } do result[name], result.scatter[name] = mean(result.runs, name) end
  result.contour = result.runs[1].contour
  if t.file then draw_contours(t, result) end
  return result
end

local definition = {
  name = "fabric.lab.cusick",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "disc", kind = "number", unit = "m", above = 0, default = 0.3, sentence = "diameter of the cloth: 0.24, 0.30, 0.36; JIS 0.254" },
    { name = "support", kind = "number", unit = "m", above = 0, default = 0.18, sentence = "diameter of the pedestal; JIS 0.127" },
    { name = "seeds", kind = "integer", low = 1, high = 1000, default = 1, sentence = "how many discs, each with an irregularity and an orientation of its own" },
    { name = "seed", kind = "integer", low = 0, default = 1, sentence = "of the first; the next ones follow" },
    { name = "orientation", kind = "number", unit = "degrees", optional = true, sentence = "of the warp in the mesh; default: drawn from the seed" },
    { name = "cells", kind = "integer", low = 3, default = 8, sentence = "elements from the pedestal's edge to the rim" },
    { name = "around", kind = "integer", low = 12, optional = true, sentence = "elements around; default: so that they are square in the middle of the overhang" },
    { name = "offset", kind = "number", unit = "m", low = 0, default = 2e-3, sentence = "how uneven the cloth lies: deviation of the rim from the level" },
    { name = "edge", kind = "number", unit = "m", above = 0, default = 8e-3, sentence = "radius of the pedestal's rounded edge; a smaller one lies near the held rim of a coarse mesh, and costs time" },
    { name = "held", kind = "number", unit = "m", above = 0, optional = true, sentence = "diameter of the plate on top; default: that of the pedestal" },
    { name = "side", kind = "number", unit = "m", low = 0, optional = true, sentence = "height of the pedestal's side, 0: a plate on a thin post; default: half of the disc" },
    { name = "friction", kind = "number", low = 0, default = 0.3, sentence = "of cloth on pedestal and on cloth" },
    { name = "contact", kind = "boolean", default = true, sentence = "false: the cloth touches nothing, it is held at the pedestal's rounded edge" },
    { name = "self", kind = "boolean", default = true, sentence = "the cloth may touch itself" },
    { name = "by", kind = "text", choices = { "motion", "relaxation" }, default = "motion", sentence = "how it comes to rest: relaxation goes through equilibria "
      .. "under growing fractions of the weight, in a fraction of the time where yarns are stiff; limp cloth comes to fewer and deeper folds so, and to a coefficient that is "
      .. "3 to 7 points lower" },
    { name = "steps", kind = "integer", low = 1, default = 10, sentence = "load steps of the weight, of relaxation" },
    { name = "lowering", kind = "number", unit = "s", above = 0, default = 1.5, sentence = "over which the weight comes" },
    { name = "damping", kind = "number", unit = "1/s", low = 0, default = 5, sentence = "of the masses" },
    { name = "still", kind = "number", above = 0, default = 5e-3, sentence = "rest: no place of the rim moves by more than this part of the overhang in a window" },
    { name = "window", kind = "number", unit = "s", above = 0, default = 0.1, sentence = "of that rule" },
    { name = "duration", kind = "number", unit = "s", above = 0, optional = true, sentence = "to wait for rest, at most; default: 4 s after the lowering" },
    { name = "processes", kind = "integer", low = 1, optional = true, sentence = "seeds side by side; default: the threads that the program may use" },
    { name = "every", kind = "number", unit = "s", above = 0, default = 0.1, sentence = "time between frames of the VTK series" },
    { name = "out", kind = "text", optional = true, sentence = "folder for a VTK series of each seed" },
    { name = "file", kind = "text", optional = true, sentence = "the outlines as a figure; ends in .svg" },
  },
  retired = { "shakes", "shake", "period", "least", "gravity" },
  sentence = "Drape test: a disc of cloth is let down over a pedestal, in motion or by relaxation, until it rests; once for each seed, side by side. Returns coefficient (shadow "
    .. "of the overhang over that of the level cloth, 0 to 1), nodes (folds) and amplitude (half of their height in the outline, m), means over the seeds; "
    .. "scatter (their deviations from disc to disc, nan of one), contour (points {x, y} of the first disc's outline), at_rest, runs (each disc's own, with "
    .. "seed, orientation, time and the ledger's error), and of one disc alone analysis, model and mesh.",
  example = "local stiff = fabric.svk{ name='card', young=1e7, poisson=0, density=500, thickness=0.3e-3, bending={ warp=2e-3, weft=2e-3, twist=1e-3 } }\n"
    .. "local r = fabric.lab.cusick{ card=stiff, disc=0.24, cells=3, around=24, lowering=0.1, still=0.05 }\nassert(r.coefficient > 0.99 and r.nodes == 0)",
  run = run,
}

usual = {}
for _, row in ipairs(definition.arguments) do usual[row.name] = row.default end
define(definition)
