-- Text of LS-DYNA keyword decks: *MAT_034 and *MAT_235. Fields of 10 columns, eight to a line; curves in two fields of 20.
local units = require "fabric.export.units"
local dyna = {}

dyna.comment = require "fabric.export.comment" "$"

local function line(names, values)
  local head = {}
  for i, name in ipairs(names) do head[i] = ("%10s"):format(name) end
  return "$" .. table.concat(head):sub(2) .. "\n" .. units.line(10, values)
end

local function curve(id, title, c, fx, fy)
  local out = { "*DEFINE_CURVE_TITLE", title, line({ "LCID", "SIDR", "SFA", "SFO", "OFFA", "OFFO" }, { id, 0, 1.0, 1.0, 0.0, 0.0 }) }
  for i = 1, #c.x do out[#out + 1] = units.fixed(c.x[i] * fx, 20) .. units.fixed(c.y[i] * fy, 20) end
  return table.concat(out, "\n")
end

-- *MAT_FABRIC with curves [LS-DYNA Keyword User's Manual, volume II, *MAT_034: card 6 with FORM = 14].
function dyna.mat_034(card, name, p, u, id)
  local s, base = u.stress, 10 * id
  local out = {
    "*MAT_FABRIC_TITLE", name,
    line({ "MID", "RO", "EA", "EB", "", "PRBA", "PRAB" },
      { id, card.density * u.density, p.warp.slope * s, p.weft.slope * s, "", 0.0, 0.0 }),
    line({ "GAB", "", "", "CSE", "EL", "PRL", "LRATIO", "DAMP" }, { p.shear.slope * s, "", "", 1.0, 0.0, 0.0, 0.0, 0.05 }),
    line({ "AOPT", "FLC", "FAC", "ELA", "LNRC", "FORM", "FVOPT", "TSRFAC" }, { 2.0, 0.0, 0.0, 0.0, 0.0, 14, 0, 0.0 }),
    line({ "", "RGBRTH", "A0REF", "A1", "A2", "A3", "X0", "X1" }, { "", 0.0, 0.0, p.axis[1], p.axis[2], p.axis[3], 0.0, 0.0 }),
    line({ "V1", "V2", "V3", "", "", "", "BETA", "ISREFG" }, { 0.0, 0.0, 0.0, "", "", "", 0.0, 0 }),
    line({ "LCA", "LCB", "LCAB", "LCUA", "LCUB", "LCUAB", "RL" }, { base + 1, base + 2, base + 3, base + 4, base + 5, base + 6, 0.0 }),
  }
  local order = { "warp", "weft", "shear" }
  for k, part in ipairs(order) do out[#out + 1] = curve(base + k, part .. ", loading", p[part].loading, 1, s) end
  for k, part in ipairs(order) do out[#out + 1] = curve(base + 3 + k, part .. ", unloading", p[part].unloading, 1, s) end
  return table.concat(out, "\n")
end

-- *MAT_MICROMECHANICS_DRY_FABRIC [the same, *MAT_235].
function dyna.mat_235(card, name, p, u, id)
  local s = u.stress
  return table.concat({
    "*MAT_MICROMECHANICS_DRY_FABRIC_TITLE", name,
    line({ "MID", "RO", "E1", "E2", "G12", "G23", "V12", "V23" },
      { id, card.density * u.density, p.E1 * s, p.E2 * s, p.G12 * s, p.G12 * s, 0.0, 0.0 }),
    line({ "XT", "THI", "THL", "BFI", "BWI", "DSCF", "CNST", "ATLR" }, { 0.0, 45.0, p.THL, 0.0, 0.0, p.DSCF, 0.0, 0.0 }),
    line({ "VME", "VMS", "TRS", "FFLG", "AOPT" }, { 0.0, 0.0, p.G12 * s, 0.0, 2.0 }),
    line({ "", "", "", "A1", "A2", "A3" }, { "", "", "", p.axis[1], p.axis[2], p.axis[3] }),
    line({ "V1", "V2", "V3", "D1", "D2", "D3" }, { 0.0, 0.0, 0.0, -p.axis[2], p.axis[1], 0.0 }),
  }, "\n")
end

return dyna
