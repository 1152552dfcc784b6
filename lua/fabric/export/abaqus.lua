-- Text of Abaqus decks: *FABRIC with test data, and *ELASTIC, which CalculiX reads too.
local abaqus = {}

abaqus.comment = require "fabric.export.comment" "**"

local function data(out, c, fx, fy)
  for i = 1, #c.x do out[#out + 1] = ("%.10g, %.10g"):format(c.y[i] * fy, c.x[i] * fx) end
end

-- *FABRIC [Abaqus Analysis User's Guide, 23.4.1; Keywords Reference Guide, *FABRIC, *UNIAXIAL, *LOADING DATA, *UNLOADING DATA].
function abaqus.fabric(card, name, p, u)
  local s = u.stress
  local out = { "*MATERIAL, NAME=" .. name, "*DENSITY", ("%.10g,"):format(card.density * u.density), "*FABRIC, STRESS FREE INITIAL SLACK=NO" }
  for k, part in ipairs { "warp", "weft", "shear" } do
    out[#out + 1] = "*UNIAXIAL, COMPONENT=" .. (k == 3 and "SHEAR" or k)
    for _, direction in ipairs(k == 3 and { "TENSION", "COMPRESSION" } or { "TENSION" }) do
      out[#out + 1] = "*LOADING DATA, DIRECTION=" .. direction .. ", TYPE=PERMANENT DEFORMATION, EXTRAPOLATION=LINEAR"
      data(out, p[part].loading, 1, s)
      out[#out + 1] = "*UNLOADING DATA, DEFINITION=SHIFTED CURVE"
      data(out, p[part].unloading, 1, s)
    end
  end
  return table.concat(out, "\n")
end

-- Orthotropic elasticity for a St. Venant-Kirchhoff card, without coupling between thickness and plane.
function abaqus.elastic(card, name, p, u)
  local s = u.stress
  return table.concat({
    "*MATERIAL, NAME=" .. name, "*DENSITY", ("%.10g,"):format(card.density * u.density), "*ELASTIC, TYPE=ENGINEERING CONSTANTS",
    ("%.10g, %.10g, %.10g, %.10g, 0., 0., %.10g, %.10g,"):format(p.E11 * s, p.E22 * s, math.min(p.E11, p.E22) * s, p.NU12, p.G12 * s, p.G13 * s),
    ("%.10g, 293.15"):format(p.G23 * s),
  }, "\n")
end

return abaqus
