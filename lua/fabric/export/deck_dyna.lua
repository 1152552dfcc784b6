-- A whole model as an LS-DYNA keyword deck.
local units = require "fabric.export.units"
local kernels = require "fabric.kernels"

return function(m, material, target, u)
  local out = { "*KEYWORD", "*TITLE", m.name, "*CONTROL_TERMINATION", units.line(10, { m.duration * u.time }) }
  local function add(keyword, ...)
    out[#out + 1] = keyword
    for _, l in ipairs { ... } do out[#out + 1] = l end
  end
  out[#out + 1] = kernels.deck_lines(m.mesh, "k", u.length):gsub("\n$", "")
  local ids = {}
  for k, set in ipairs(m.sets) do ids[set.name] = k end
  local t = m.thickness * u.length
  -- *MAT_034 requires ELFORM 5, the Belytschko-Tsay membrane; otherwise 2 with three points
  add("*SECTION_SHELL", units.line(10, { 1, target.name == "MAT_034" and 5 or 2, 0.833333, target.name == "MAT_034" and 1 or 3, 1.0 }),
    units.line(10, { t, t, t, t }))
  add("*PART", m.name, units.line(10, { 1, 1, 1 }))
  out[#out + 1] = material
  for _, f in ipairs(m.fixed) do
    local held = { ids[f.set], 0, 0, 0, 0, 0, 0, 0 }
    for _, k in ipairs(f.freedoms) do held[2 + k] = 1 end
    add("*BOUNDARY_SPC_SET", units.line(10, held))
  end
  local curve = 100
  local function history(value, scale)
    curve = curve + 1
    add("*DEFINE_CURVE", units.line(10, { curve }))
    for _, c in ipairs(type(value) == "table" and value or { { 0, value }, { m.duration, value } }) do
      out[#out + 1] = units.fitting(c[1] * u.time, 20) .. units.fitting(c[2] * scale, 20)
    end
    return curve
  end
  for _, one in ipairs(m.moved) do
    local id = history(one.value, u.length)
    add("*BOUNDARY_PRESCRIBED_MOTION_SET", units.line(10, { ids[one.set], one.axis, 2, id, 1.0 }))
  end
  for _, one in ipairs(m.forces) do
    local id = history(one.value, u.force)
    add "*LOAD_NODE_POINT"
    for _, n in ipairs(m.mesh:set(one.set)) do out[#out + 1] = units.line(10, { n, one.axis, id, one.share[n] }) end
  end
  for axis, letter in ipairs { "X", "Y", "Z" } do -- gravity as an upward acceleration of the base
    if m.gravity[axis] ~= 0 then
      local id = history(m.gravity[axis], -u.acceleration)
      add("*LOAD_BODY_" .. letter, units.line(10, { id, 1.0 }))
    end
  end
  out[#out + 1] = "*END"
  return table.concat(out, "\n") .. "\n"
end
