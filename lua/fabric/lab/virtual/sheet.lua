-- Shared by the virtual tests: the driven path, the curve and its files, and stress in a direction.
local curves = require "fabric.columns"
local fabric = require "fabric"
local sheet = {}

-- {0.75, 0.7, 1} times an amplitude as a history with one second per leg, from 0 at time 0; and its end time.
function sheet.history(path, amplitude)
  local points = { { 0, 0 } }
  for i, part in ipairs(path) do points[i + 1] = { i, part * amplitude } end
  return points, #path
end

-- Value at time t of such a list of points; constant after its end.
function sheet.value(points, t)
  for i = 2, #points do
    local a, b = points[i - 1], points[i]
    if t <= b[1] then return a[2] + (b[2] - a[2]) * (t - a[1]) / (b[1] - a[1]) end
  end
  return points[#points][2]
end

-- Numbers of the elements nearest to the centre of the mesh: one, two or four.
function sheet.centre(mesh)
  local middle, list, best = { 0, 0 }, {}, math.huge
  local place = {}
  for i = 1, #mesh.elements do
    local p, nodes = { 0, 0 }, mesh.elements[i]
    for _, n in ipairs(nodes) do
      for k = 1, 2 do p[k] = p[k] + mesh.nodes[n][k] / #nodes end
    end
    place[i] = p
    for k = 1, 2 do middle[k] = middle[k] + p[k] / #mesh.elements end
  end
  for i, p in ipairs(place) do
    local r = math.sqrt((p[1] - middle[1]) ^ 2 + (p[2] - middle[2]) ^ 2)
    if r < best * (1 - 1e-6) then best, list = r, {} end
    if r <= best * (1 + 1e-6) then list[#list + 1] = i end
  end
  return list, place
end

-- Mean over some elements (all without a list) of the components 11, 22, 12 of "E" or "S", material axes.
function sheet.mean(a, letter, elements)
  local names, out = { "11", "22", "12" }, {}
  for k, name in ipairs(names) do
    if elements then
      local values, sum = a:field(letter .. name), 0
      for _, i in ipairs(elements) do sum = sum + values[i] end
      out[k] = sum / #elements
    else
      out[k] = a:mean(letter .. name)
    end
  end
  return out
end

-- Components of a symmetric tensor {11, 22, 12}, given in material axes, along the direction at `angle` degrees from the
-- warp, and across it.
function sheet.along(tensor, angle)
  local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
  if angle == 90 then c, s = 0, 1 end
  local t11, t22, t12 = table.unpack(tensor)
  return t11 * c * c + t22 * s * s + 2 * t12 * s * c, t11 * s * s + t22 * c * c - 2 * t12 * s * c
end

-- Units of the columns by the letters that their names begin with; strains have none.
local units = { { "displacement", "m" }, { "centre", "m" }, { "lowest", "m" }, { "height", "m" }, { "force", "N" }, { "S", "Pa" },
                { "kinetic", "J" }, { "stored", "J" }, { "dissipated", "J" }, { "damping", "J" }, { "external", "J" }, { "created", "J" } }
local function unit_of(name)
  for _, u in ipairs(units) do
    if name:find("^" .. u[1]) then return u[2] end
  end
end

-- Records reading(a) at every step, or at intervals of so many seconds; with a folder, also in curve.csv and a VTK series
-- named `stem`. state: a table that a checkpoint may keep, which gets the rows. Returns the curve, and a function that completes it with the rows of that table in a
-- run that was taken up.
function sheet.observe(a, names, out, stem, reading, every, state)
  local curve, latest = curves.made(), nil
  local function complete()
    local kept = state and state.curve or {}
    for i = #curve + 1, #kept do curve[i] = kept[i] end
  end
  local function now()
    if not latest or latest.time ~= a.time then
      latest = reading(a)
      latest.time = a.time
    end
    return latest
  end
  a:every(every or "step", function()
    complete()
    curve[#curve + 1] = now()
    if state then
      state.curve = state.curve or {}
      state.curve[#curve] = curve[#curve]
    end
  end)
  if fabric.checking() then curve[1] = now() end -- a first row, so that the deck can be checked
  if not out then return curve, complete end
  local columns, headings = {}, {}
  for _, name in ipairs(names) do
    columns[name] = function() return now()[name] end
    headings[name] = unit_of(name)
  end
  a:record(out .. "/curve.csv", { columns = columns, order = names, every = every, units = headings })
  a:vtk(out .. "/" .. stem, { every = every })
  return curve, complete
end

-- Whether the curve has the rows of the whole run: a warning says where it does not, since the run was taken up from a checkpoint that has not kept them.
function sheet.is_whole(a, curve, every, stem)
  local first = curve[1] and curve[1].time or a.time
  if first <= 1.5 * every or fabric.checking() then return true end
  fabric.warn(("%s: the run was taken up from a checkpoint, and the curve lacks the rows before %.4g s: peaks and means of the whole are not known; "
    .. "with state={}, a table that a:checkpoint keeps, a restart has these rows"):format(stem, first))
  return false
end

-- The row of a curve in which a column has its largest absolute value.
function sheet.peak(curve, name)
  local best = curve[1]
  for _, row in ipairs(curve) do
    if math.abs(row[name]) > math.abs(best[name]) then best = row end
  end
  return best
end

return sheet
