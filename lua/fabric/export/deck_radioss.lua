-- A whole model as an OpenRadioss starter deck (NAME_0000.rad). The engine file, with end time and outputs, is left to the user. The format is that
-- of 2022, or the first one that has the material.
local units = require "fabric.export.units"
local kernels = require "fabric.kernels"

local names = { ["SI"] = { "kg", "m", "s" }, ["mm-t-s"] = { "Mg", "mm", "s" }, ["mm-kg-ms"] = { "kg", "mm", "ms" } }

return function(m, material, target, u)
  local function reals(...)
    local out = {}
    for i, v in ipairs { ... } do out[i] = units.fixed(v, 20) end
    return table.concat(out)
  end
  local function ints(...) return units.line(10, { ... }) end
  local words = names[u.name]
  local unit = ("%20s%20s%20s"):format(words[1], words[2], words[3])
  local out = { "#RADIOSS STARTER", "/BEGIN", m.name, ints(target.format or 2022, 0), unit, unit }
  local function add(keyword, ...)
    out[#out + 1] = keyword
    for _, l in ipairs { ... } do out[#out + 1] = l end
  end
  out[#out + 1] = material
  local t, w = m.thickness * u.length, m.warp
  local fabric = target.property == "TYPE16"
  add(("/PROP/%s/1"):format(target.property), m.name, "#   ISHELL    ISMSTR     ISH3N", ints(12, fabric and 4 or 11, 2), "#  HM HF HR DM DN", reals(0.0, 0.0, 0.0, 0.0, 0.0),
    "#        N   ISTRAIN               THICK              ASHEAR", ints(1, 1) .. reals(t, 0.0) .. ints("", 0, 0))
  if fabric then -- directions of the yarns: warp along V, weft at 90 degrees
    add("#                 VX                  VY                  VZ   SKEW_ID", reals(w[1], w[2], w[3]) .. ints(0, "", 0),
      "#                PHI               ALPHA                  TI                  ZI    MAT_ID", reals(0.0, 90.0, t, 0.0) .. ints(1))
  else
    add("#                 VX                  VY                  VZ                 PHI", reals(w[1], w[2], w[3], 0.0))
  end
  add("/PART/1", m.name, ints(1, 1, 0))
  out[#out + 1] = kernels.deck_lines(m.mesh, "rad", u.length):gsub("\n$", "")
  local ids = {}
  for k, set in ipairs(m.sets) do ids[set.name] = k end
  for k, f in ipairs(m.fixed) do
    local bits = { "0", "0", "0", "0", "0", "0" }
    for _, i in ipairs(f.freedoms) do bits[i] = "1" end
    add(("/BCS/%d"):format(k), f.set, "   " .. table.concat(bits, "", 1, 3) .. " " .. table.concat(bits, "", 4, 6) .. ints(0, ids[f.set]))
  end
  local letters, curve = { "X", "Y", "Z" }, 100
  local function history(value, scale)
    curve = curve + 1
    add(("/FUNCT/%d"):format(curve), "history")
    for _, c in ipairs(type(value) == "table" and value or { { 0, value }, { m.duration, value } }) do
      out[#out + 1] = units.fitting(c[1] * u.time, 20) .. units.fitting(c[2] * scale, 20)
    end
    return curve
  end
  for k, one in ipairs(m.moved) do
    local id = history(one.value, u.length)
    add(("/IMPDISP/%d"):format(k), one.set, ints(id) .. ("%10s"):format(letters[one.axis]) .. ints(0, 0, ids[one.set], 0, 0), reals(1.0, 1.0, 0.0, 1e30))
  end
  local loads = 0
  for _, one in ipairs(m.forces) do
    local id = history(one.value, u.force)
    for _, n in ipairs(m.mesh:set(one.set)) do
      loads = loads + 1
      add(("/GRNOD/NODE/%d"):format(1000 + loads), ("node %d"):format(n), ints(n))
      add(("/CLOAD/%d"):format(loads), one.set, ints(id) .. ("%10s"):format(letters[one.axis]) .. ints(0, 0, 1000 + loads), reals(1.0, one.share[n]))
    end
  end
  for axis = 1, 3 do
    if m.gravity[axis] ~= 0 then
      local id = history(m.gravity[axis], u.acceleration)
      add(("/GRAV/%d"):format(axis), "gravity", ints(id) .. ("%10s"):format(letters[axis]) .. ints(0, 0, ids.all), reals(1.0, 1.0))
    end
  end
  out[#out + 1] = "/END"
  return table.concat(out, "\n") .. "\n"
end
