-- A formed ply for the next program: its nodes, its elements, and the directions of its yarns element by element, lengths in m.
local fabric = require "fabric"
local kernels = require "fabric.kernels"
local units = require "fabric.export.units"

local yarns = {}

local function vector(v) return ("%.9g, %.9g, %.9g"):format(v[1], v[2], v[3]) end

-- The part of b across a, a unit vector: an orientation is of two axes at right angles.
local function across(a, b)
  local along = a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
  local c = { b[1] - along * a[1], b[2] - along * a[2], b[3] - along * a[3] }
  local size = math.sqrt(c[1] ^ 2 + c[2] ^ 2 + c[3] ^ 2)
  return { c[1] / size, c[2] / size, c[3] / size }
end

-- Abaqus and CalculiX: a distribution of orientations, whose first axis is the warp. A section names it.
local function inp(name, mesh, rows)
  local out = { "** " .. name .. ", formed; lengths in m. A section takes the warp of each element: *SHELL SECTION, ELSET=" .. name .. ", MATERIAL=..., ORIENTATION=yarns_" .. name,
                (kernels.deck_lines(mesh, "inp", 1, false, name):gsub("\n$", "")),
                "*DISTRIBUTION TABLE, NAME=axes_" .. name, "COORD3D, COORD3D",
                ("*DISTRIBUTION, NAME=warp_%s, LOCATION=ELEMENT, TABLE=axes_%s"):format(name, name), ", 1, 0, 0, 0, 1, 0" }
  for i, row in ipairs(rows) do out[#out + 1] = ("%d, %s, %s"):format(i, vector(row.warp), vector(across(row.warp, row.weft))) end
  out[#out + 1] = ("*ORIENTATION, NAME=yarns_%s, SYSTEM=RECTANGULAR\nwarp_%s\n"):format(name, name)
  return table.concat(out, "\n")
end

-- OpenRadioss: the warp as the reference vector of each shell, and the angle from it to the weft, which /PROP/TYPE16 takes.
local function rad(name, mesh, rows)
  local out = { "# " .. name .. ", formed; lengths in m. Part 1 with /PROP/TYPE16 (of one integration point) takes the yarns of each element", (kernels.deck_lines(mesh, "rad", 1):gsub("\n$", "")) }
  for corners, keyword in pairs { [3] = "/INISH3/ORTHO", [4] = "/INISHE/ORTHO" } do
    local lines = {}
    for i, row in ipairs(rows) do
      if #mesh.elements[i] == corners then
        local cosine = row.warp[1] * row.weft[1] + row.warp[2] * row.weft[2] + row.warp[3] * row.weft[3]
        lines[#lines + 1] = units.line(10, { i, 1, 16, "" }) .. units.fixed(row.warp[1], 20) .. units.fixed(row.warp[2], 20) .. units.fixed(row.warp[3], 20)
        lines[#lines + 1] = units.fixed(0.0, 20) .. units.fixed(math.deg(math.acos(math.max(-1, math.min(1, cosine)))), 20)
      end
    end
    if #lines > 0 then out[#out + 1] = keyword .. "\n" .. table.concat(lines, "\n") end
  end
  return table.concat(out, "\n") .. "\n"
end

-- name: of the ply; flat: its mesh before; places: {x, y, z} of its nodes; rows: warp and weft of its elements. Returns the names of the files.
function yarns.write(folder, name, flat, places, rows)
  local elements = {}
  for i, nodes in ipairs(flat.elements) do elements[i] = { table.unpack(nodes) } end
  local mesh = fabric.mesh { nodes = places, elements = elements }
  local files = { folder .. "/" .. name .. ".inp", folder .. "/" .. name .. ".rad" }
  fabric.write(files[1], inp(name, mesh, rows))
  fabric.write(files[2], rad(name, mesh, rows))
  return files
end

return yarns
