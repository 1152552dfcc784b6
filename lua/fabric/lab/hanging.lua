-- A card for a cloth with measured bending and mass only. Its in-plane part is that of the card 'worsted' in force per width, the only
-- apparel cloth of the library that was tested under the small loads of hanging cloth. The card states that.
local fabric = require "fabric"
local filled = require "fabric.lab.card.filled"
local lists = require "fabric.lists"

local density = 400 -- kg/m^3, if the thickness was not measured; the four cloths of the thesis have 350 to 590
local words = "assumed: force per width as of the card 'worsted', since nothing was pulled or sheared"

-- Rigidities from cantilevers along warp, weft and at 45 degrees, N.m. For a narrow strip at 45 degrees 4/B45 = 1/B1 + 1/B2 + 1/twist.
local function of_cantilevers(B)
  return { warp = B[1], weft = B[2], twist = 1 / (4 / B[3] - 1 / B[1] - 1 / B[2]) },
    "measured: cantilevers in three directions, initial rigidity; twist from 45 degrees"
end

-- t: name, source, mass (kg/m^2); thickness (m) if measured; cantilevers (three rigidities, nN.m), or bending as in fabric.woven with
-- bending_origin, its origin, and twist_origin where the twist has another.
return function(t)
  local bending, origin = t.bending, t.bending_origin
  if t.cantilevers then bending, origin = of_cantilevers(lists.scaled(t.cantilevers, 1e-9)) end
  local thickness = t.thickness or t.mass / density
  local provenance = { bending = origin, ["bending.twist"] = t.twist_origin, thickness = t.thickness and "measured" or "assumed: the measured areal mass over 400 kg/m3",
    density = t.thickness and "measured: areal mass over the thickness" or "assumed: 400 kg/m3" }
  local parts, tested, ranges = {}, {}, {}
  for _, name in ipairs { "warp", "weft", "shear" } do
    parts[name], tested[name] = filled.part(name, thickness)
    provenance[name .. ".loading"], provenance[name .. ".unloading"] = words, words
    ranges[name .. ".loading"] = select(2, filled.source(name))
    if parts[name].poisson then provenance[name .. ".poisson"] = words end
  end
  return fabric.woven { name = t.name, source = t.source, density = t.mass / thickness, thickness = thickness, warp = parts.warp, weft = parts.weft,
    shear = parts.shear, tested = tested, bending = bending, provenance = provenance, ranges = ranges }
end
