-- Collects the data of a model for another solver's deck: nodes, elements, sets, supports, motions and loads, all in SI units.
local define = require "fabric.define"
local fail = define.fail
local gather = {}

local axes = { x = 1, y = 2, z = 3 }

-- The numbers of the translations (1 to 3) and rotations (4 to 6) in words like "x y z rotation".
local function freedoms(words)
  local held = {}
  for word in words:gmatch "%S+" do
    if axes[word] then held[axes[word]] = true
    elseif word == "rotation" then held[4], held[5], held[6] = true, true, true
    else held[3 + axes[word:sub(2)]] = true end
  end
  local out = {}
  for i = 1, 6 do
    if held[i] then out[#out + 1] = i end
  end
  return out
end

-- The corners {t, v} for each axis in words like "x 0 to 0.1 m at 1 s, y 0.2 m" (numbers, or a ramp as shown by m:list()).
local function components(row, unit, histories, notes)
  local out = {}
  local words = row.what
  if words:find " along {" then fail(("model: the %s of '%s' is along axes of its own, which cannot be exported"):format(row.kind, row.set)) end
  for axis, rest in (words .. ", "):gmatch "([xyz]) (.-), " do
    local given = histories and histories[row.set .. "." .. axis]
    local a, b, t = rest:match "^(%S+) to (%S+) .- at (%S+) s$"
    if given then
      out[axes[axis]] = given
    elseif a then
      out[axes[axis]] = { { 0, tonumber(a) }, { tonumber(t), tonumber(b) } }
      notes[#notes + 1] = ("%s of %s along %s: written straight from %s at 0 s to %s %s at %s s; histories={ ['%s.%s']={{t, v}, ...} } gives points between")
        :format(row.kind, row.set, axis, a, b, unit, t, row.set, axis)
    elseif rest:find "function of time" then
      fail(("model: the %s of '%s' along %s is a function; expected histories={ ['%s.%s']={{t, v}, ...} } with its points"):format(row.kind, row.set, axis,
        row.set, axis))
    else
      out[axes[axis]] = tonumber(rest:match "^%S+")
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
  local l = 0
  for _, x in ipairs(given) do l = l + x * x end
  if #given ~= 3 or l == 0 then fail(("%s: expected a direction {x, y, z} other than zero, got {%s}"):format(field, table.concat(given, ", "))) end
  l = math.sqrt(l)
  return { given[1] / l, given[2] / l, given[3] / l }
end

-- Direction of the warp, from an angle in degrees to x or from {x, y, z}.
local function direction(warp)
  if type(warp) == "number" then
    local angle = math.rad(warp)
    local function round(v) return math.abs(v) < 1e-15 and 0.0 or v end
    return { round(math.cos(angle)), round(math.sin(angle)), 0.0 }
  end
  return gather.unit(#warp == 2 and { warp[1], warp[2], 0 } or warp, "model: field 'warp'")
end

-- t: fields of fabric.export.model. Returns mesh, sets {name, nodes}, fixed {set, freedoms}, moved and forces {set, axis, value or
-- corners, share}, gravity {x, y, z}, pressures, warp, thickness, notes.
function gather.model(t)
  local model, mesh = t.model, t.model.mesh
  local out = { mesh = mesh, card = model.card, thickness = model.thickness, warp = direction(t.warp), sets = {}, fixed = {},
    moved = {}, forces = {}, gravity = { 0, 0, 0 }, pressures = {}, notes = {}, duration = t.duration }
  for _, name in ipairs(mesh.sets) do out.sets[#out.sets + 1] = { name = name, nodes = mesh:set(name) } end
  for _, row in ipairs(model:list()) do
    if row.kind == "fix" then
      if row.what:find " along {" then fail(("model: the fix of '%s' is along axes of its own, which cannot be exported"):format(row.set)) end
      out.fixed[#out.fixed + 1] = { set = row.set, freedoms = freedoms(row.what) }
    elseif row.kind == "move" then
      for axis, value in pairs(components(row, "m", t.histories, out.notes)) do
        out.moved[#out.moved + 1] = { set = row.set, axis = axis, value = value }
      end
    elseif row.kind == "force" then
      for axis, value in pairs(components(row, "N", t.histories, out.notes)) do
        out.forces[#out.forces + 1] = { set = row.set, axis = axis, value = value, share = shares(mesh, mesh:set(row.set)) }
      end
    elseif row.kind == "gravity" then
      for axis, value in pairs(components(row, "m/s^2", t.histories, out.notes)) do
        if type(value) ~= "number" then fail "model: gravity that changes with time cannot be exported" end
        out.gravity[axis] = value
      end
    else
      fail(("model: field 'model': a %s ('%s') cannot be exported; expected fix, move, force and gravity of one sheet"):format(row.kind, row.set))
    end
  end
  local function by(a, b) return a.set .. a.axis < b.set .. b.axis end
  table.sort(out.moved, by)
  table.sort(out.forces, by)
  if not out.duration then
    out.duration = 1
    for _, list in ipairs { out.moved, out.forces } do
      for _, one in ipairs(list) do
        if type(one.value) == "table" then out.duration = math.max(out.duration, one.value[#one.value][1]) end
      end
    end
  end
  return out
end

return gather
