-- Collects the data of a model for another solver's deck: nodes, elements, sets, supports, motions and loads, all in SI units.
local define = require "fabric.define"
local tabulate = require "fabric.export.tabulate"
local lists = require "fabric.lists"
local fail = define.fail
local gather = {}

local axes = { x = 1, y = 2, z = 3 }

-- The numbers of the translations (1 to 3) and rotations (4 to 6) in a list of freedoms.
local function freedoms(held)
  local all, out = {}, {}
  for _, name in ipairs(held) do
    if axes[name] then all[axes[name]] = true
    elseif name == "rotation" then all[4], all[5], all[6] = true, true, true
    else all[3 + axes[name:sub(2)]] = true end
  end
  for i = 1, 6 do
    if all[i] then out[#out + 1] = i end
  end
  return out
end

local function along_own_axes(row) fail(("model: the %s of '%s' is along axes of its own, which cannot be exported"):format(row.kind, row.set)) end

-- The value of each axis that a declaration gives: a number, or points {t, v} from 0 s to the end of the run at least.
local function components(t, row, unit, duration, notes)
  if row.frame then along_own_axes(row) end
  local out = {}
  for axis, number in pairs(axes) do
    local history, name = row[axis], row.set .. "." .. axis
    local given, points = t.histories and t.histories[name], history and history:points()
    if history and given then
      out[number] = tabulate.check(given, "histories." .. name)
    elseif history and not points then
      local made, error = tabulate.of_function(function(time) return history:value(time) end, duration, t.error)
      out[number] = made
      notes[#notes + 1] = ("%s of %s along %s: a function of time, written as %d points from 0 to %.6g s, which differs from it by at most %.3g %s where it was compared; beyond, the solver goes on in its own way")
        :format(row.kind, row.set, axis, #made, duration, error, unit)
    elseif history then
      out[number] = #points == 1 and points[1][2] or tabulate.of_points(history, points, duration)
    end
  end
  return out
end

-- Area of an element with the corners {x, y, z}: half the cross product of two sides, or of the diagonals.
local function area(corners)
  local n = #corners
  local p, q, r, s = corners[1], n == 3 and corners[2] or corners[3], n == 3 and corners[1] or corners[2], n == 3 and corners[3] or corners[4]
  local u, v = { q[1] - p[1], q[2] - p[2], q[3] - p[3] }, { s[1] - r[1], s[2] - r[2], s[3] - r[3] }
  return math.sqrt((u[2] * v[3] - u[3] * v[2]) ^ 2 + (u[3] * v[1] - u[1] * v[3]) ^ 2 + (u[1] * v[2] - u[2] * v[1]) ^ 2) / 2
end

-- Shares of the nodes in a total force, as a model shares it: by area where all corners of an element belong to the set, else by the length of its
-- edges, else evenly.
local function shares(mesh, nodes)
  local inside, by_area, by_length, areas, lengths = {}, {}, {}, 0, 0
  for _, n in ipairs(nodes) do inside[n], by_area[n], by_length[n] = true, 0, 0 end
  local seen = {}
  for e = 1, #mesh.elements do
    local element, corners = mesh.elements[e], {}
    for k = 1, #element do
      local a, b = element[k], element[k % #element + 1]
      if inside[a] then corners[#corners + 1] = mesh.nodes[a] end
      local key = a < b and a .. " " .. b or b .. " " .. a
      if inside[a] and inside[b] and not seen[key] then
        seen[key] = true
        local p, q = mesh.nodes[a], mesh.nodes[b]
        local l = math.sqrt((p[1] - q[1]) ^ 2 + (p[2] - q[2]) ^ 2 + (p[3] - q[3]) ^ 2)
        by_length[a], by_length[b], lengths = by_length[a] + l / 2, by_length[b] + l / 2, lengths + l
      end
    end
    if #corners == #element then
      local A = area(corners)
      areas = areas + A
      for k = 1, #element do by_area[element[k]] = by_area[element[k]] + A / #element end
    end
  end
  local out = {}
  for _, n in ipairs(nodes) do out[n] = areas > 0 and by_area[n] / areas or lengths > 0 and by_length[n] / lengths or 1 / #nodes end
  return out
end

-- A direction {x, y, z} of length 1, or an error of that field.
function gather.unit(given, field)
  local l = lists.sum(given, function(x) return x * x end)
  if #given ~= 3 or l == 0 then fail(("%s: expected a direction {x, y, z} other than zero, got {%s}"):format(field, table.concat(given, ", "))) end
  l = math.sqrt(l)
  return { given[1] / l, given[2] / l, given[3] / l }
end

-- A direction whose components of rounding are none.
local function rounded(v)
  return lists.map(v, function(x) return math.abs(x) < 1e-15 and 0.0 or x end)
end

-- Direction of the warp, from an angle in degrees to x or from {x, y, z}.
local function direction(warp)
  if type(warp) == "number" then
    local angle = math.rad(warp)
    return rounded { math.cos(angle), math.sin(angle), 0.0 }
  end
  return gather.unit(#warp == 2 and { warp[1], warp[2], 0 } or warp, "model: field 'warp'")
end

-- Decks hold one sheet of one card: anything else is an error, a loss is a note.
local function check_sheet(row, out)
  if row.plies > 0 then fail(("model: field 'model': '%s' has plies, which cannot be exported; expected one sheet of one card"):format(row.set)) end
  if row.offset ~= 0 then out.notes[#out.notes + 1] = ("the sheet's reference surface lies at %.6g of half its thickness: written as its middle surface"):format(row.offset) end
  if row.rest then out.notes[#out.notes + 1] = ("the stress-free shape is left out (%s): the deck begins without stress in the shape of the mesh"):format((row.rest:gsub("; $", ""))) end
  local given = out.warp
  if not given then
    if not row.warp then fail "model: field 'warp': expected the direction of the warp, which differs from place to place in this model, got nil" end
    out.warp = rounded(row.warp)
    return
  end
  local along = row.warp and math.abs(given[1] * row.warp[1] + given[2] * row.warp[2] + given[3] * row.warp[3]) or 1
  if along < 1 - 1e-4 then
    fail(("model: field 'warp': expected the model's own direction {%.6g, %.6g, %.6g}, got {%.6g, %.6g, %.6g}"):format(row.warp[1], row.warp[2], row.warp[3], given[1], given[2], given[3]))
  end
end

-- The last time at which anything that is given by points changes; at least 1 s.
local function last_corner(t, rows)
  local last = 1
  local function look(points)
    if points and #points > 1 then last = math.max(last, points[#points][1]) end
  end
  for _, row in ipairs(rows) do
    for axis in pairs(axes) do
      local history = row[axis]
      if type(history) == "userdata" then look(history:points()) end
      if history then look(t.histories and t.histories[row.set .. "." .. axis]) end
    end
  end
  return last
end

-- t: fields of fabric.export.model. Returns mesh, sets {name, nodes}, fixed {set, freedoms}, moved and forces {set, axis, value or
-- points, share}, gravity {x, y, z: value or points}, warp, thickness, duration, notes.
function gather.model(t)
  local model, mesh, rows = t.model, t.model.mesh, t.model:declared()
  local out = { mesh = mesh, card = model.card, thickness = model.thickness, warp = t.warp and direction(t.warp), sets = {}, fixed = {},
    moved = {}, forces = {}, gravity = { 0, 0, 0 }, notes = {}, duration = t.duration or last_corner(t, rows) }
  for _, name in ipairs(mesh.sets) do out.sets[#out.sets + 1] = { name = name, nodes = mesh:set(name) } end
  local sheets = 0
  for _, row in ipairs(rows) do
    if row.kind == "sheet" then
      sheets = sheets + 1
      if sheets > 1 then fail(("model: field 'model': it has several sheets or cards ('%s'), which cannot be exported; expected one sheet of one card"):format(row.set)) end
      check_sheet(row, out)
    elseif row.kind == "fix" then
      if row.frame then along_own_axes(row) end
      out.fixed[#out.fixed + 1] = { set = row.set, freedoms = freedoms(row.held) }
    elseif row.kind == "move" and not row.body then
      for axis, value in pairs(components(t, row, "m", out.duration, out.notes)) do
        out.moved[#out.moved + 1] = { set = row.set, axis = axis, value = value }
      end
    elseif row.kind == "force" then
      for axis, value in pairs(components(t, row, "N", out.duration, out.notes)) do
        out.forces[#out.forces + 1] = { set = row.set, axis = axis, value = value, share = shares(mesh, mesh:set(row.set)) }
      end
    elseif row.kind == "gravity" then
      for axis, value in pairs(components(t, row, "m/s^2", out.duration, out.notes)) do out.gravity[axis] = value end
    else
      fail(("model: field 'model': a %s ('%s') cannot be exported; expected fix, move, force and gravity of one sheet"):format(row.kind, row.set))
    end
  end
  local function by(a, b) return a.set .. a.axis < b.set .. b.axis end
  table.sort(out.moved, by)
  table.sort(out.forces, by)
  table.sort(out.notes)
  return out
end

return gather
