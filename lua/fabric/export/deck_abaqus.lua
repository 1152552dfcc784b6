-- A whole model as an Abaqus deck; with an *ELASTIC material it also runs in CalculiX. Cloth by *FABRIC, which Abaqus has for membranes in explicit
-- dynamics only, becomes membrane elements without rotations; other materials become shells in a static step.

local units = require "fabric.export.units"
local kernels = require "fabric.kernels"

-- A history as a table of time and value; ft and scale turn s and the value into the deck's units.
local function amplitude(out, name, corners, ft, scale)
  out[#out + 1] = "*AMPLITUDE, NAME=" .. name
  for _, c in ipairs(corners) do out[#out + 1] = units.exact(c[1] * ft) .. ", " .. units.exact(c[2] * scale) end
end

-- The name of a set as the mesh writes it: one that is no plain word stands in quotes.
local function called(name) return name:find "^%a[%w_.-]*$" and name or '"' .. name .. '"' end

-- Gravity: what is constant as one load, what varies as one for each axis.
local function gravity(out, given, u)
  local g = {}
  for axis, value in ipairs(given) do
    g[axis] = type(value) == "number" and value or 0
    if type(value) == "table" then
      out[#out + 1] = "*DLOAD, AMPLITUDE=gravity_" .. axis
      out[#out + 1] = ("cloth, GRAV, 1, %d, %d, %d"):format(axis == 1 and 1 or 0, axis == 2 and 1 or 0, axis == 3 and 1 or 0)
    end
  end
  local size = math.sqrt(g[1] ^ 2 + g[2] ^ 2 + g[3] ^ 2)
  if size > 0 then
    out[#out + 1] = "*DLOAD"
    out[#out + 1] = ("cloth, GRAV, %.10g, %.10g, %.10g, %.10g"):format(size * u.acceleration, g[1] / size, g[2] / size, g[3] / size)
  end
end

-- m: the model as export/gather.lua collects it; material: the lines of the material; target: the row of export/targets.lua; u: factors from SI to
-- the deck's units. Returns the text of the deck.
return function(m, material, target, u)
  local membrane = target.name == "FABRIC"
  local out = { (kernels.deck_lines(m.mesh, "inp", u.length, membrane, "cloth"):gsub("\n$", "")) }
  local w = m.warp
  local across = math.abs(w[3]) < 0.9 and { -w[2], w[1], 0.0 } or { 0.0, w[3], -w[2] }
  out[#out + 1] = "*ORIENTATION, NAME=warp"
  out[#out + 1] = ("%.10g, %.10g, %.10g, %.10g, %.10g, %.10g"):format(w[1], w[2], w[3], across[1], across[2], across[3])
  out[#out + 1] = material
  out[#out + 1] = ("*%s SECTION, ELSET=cloth, MATERIAL=%s, ORIENTATION=warp"):format(membrane and "MEMBRANE" or "SHELL", m.name)
  out[#out + 1] = ("%.10g"):format(m.thickness * u.length)
  for i, one in ipairs(m.moved) do
    if type(one.value) == "table" then amplitude(out, "motion_" .. i, one.value, u.time, u.length) end
  end
  for i, one in ipairs(m.forces) do
    if type(one.value) == "table" then amplitude(out, "force_" .. i, one.value, u.time, u.force) end
  end
  for axis, value in ipairs(m.gravity) do
    if type(value) == "table" then amplitude(out, "gravity_" .. axis, value, u.time, u.acceleration) end
  end
  if #m.fixed > 0 then out[#out + 1] = "*BOUNDARY" end
  for _, f in ipairs(m.fixed) do
    for _, k in ipairs(f.freedoms) do
      if not (membrane and k > 3) then out[#out + 1] = ("%s, %d, %d"):format(called(f.set), k, k) end
    end
  end
  local T = m.duration * u.time
  out[#out + 1] = "*STEP, NLGEOM" .. (membrane and "" or ", INC=1000")
  out[#out + 1] = membrane and "*DYNAMIC, EXPLICIT" or "*STATIC"
  out[#out + 1] = membrane and (", %.10g"):format(T) or ("%.10g, %.10g, %.10g, %.10g"):format(T / 10, T, T * 1e-6, T / 10)
  for i, one in ipairs(m.moved) do
    local varies = type(one.value) == "table"
    out[#out + 1] = "*BOUNDARY" .. (varies and ", AMPLITUDE=motion_" .. i or "")
    out[#out + 1] = ("%s, %d, %d, %.10g"):format(called(one.set), one.axis, one.axis, varies and 1 or one.value * u.length)
  end
  for i, one in ipairs(m.forces) do
    local varies = type(one.value) == "table"
    out[#out + 1] = "*CLOAD" .. (varies and ", AMPLITUDE=force_" .. i or "")
    for _, n in ipairs(m.mesh:set(one.set)) do
      out[#out + 1] = ("%d, %d, %.10g"):format(n, one.axis, one.share[n] * (varies and 1 or one.value * u.force))
    end
  end
  gravity(out, m.gravity, u)
  local printed = {} -- sets whose reactions are asked for
  for _, one in ipairs(m.moved) do
    if not printed[one.set] and not membrane then
      printed[one.set] = true
      out[#out + 1] = ("*NODE PRINT, NSET=%s, TOTALS=YES"):format(called(one.set))
      out[#out + 1] = "RF"
    end
  end
  out[#out + 1] = "*END STEP"
  return table.concat(out, "\n") .. "\n"
end
