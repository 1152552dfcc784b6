-- Text of OpenRadioss starter decks: LAW58, LAW158 and LAW19. A line has ten fields of 10 columns; a real number takes two.
local units = require "fabric.export.units"
local lists = require "fabric.lists"
local radioss = {}

radioss.comment = require "fabric.export.comment" "#"

local function reals(...)
  local out = lists.map({ ... }, function(v) return v == "" and (" "):rep(20) or units.fixed(v, 20) end)
  return table.concat(out)
end

local function ids(...) return units.line(10, { ... }) end

-- A comment line with the names of the fields of 20 columns, to be put above their numbers.
local function head(...)
  local out = lists.map({ ... }, function(v) return ("%20s"):format(v) end)
  return "#" .. table.concat(out):sub(2)
end

local function funct(id, title, c, fx, fy)
  local out = { ("/FUNCT/%d"):format(id), title, head("X", "Y") }
  for i = 1, #c.x do out[#out + 1] = reals(c.x[i] * fx, c.y[i] * fy) end
  return table.concat(out, "\n")
end

-- The shear curve for positive and negative angles.
local function odd(c)
  local out = { x = {}, y = {} }
  for i = #c.x, 1, -1 do out.x[#out.x + 1], out.y[#out.y + 1] = -c.x[i], -c.y[i] end
  for i = 2, #c.x do out.x[#out.x + 1], out.y[#out.y + 1] = c.x[i], c.y[i] end
  return out
end

-- The first three functions of a material, each with its scale.
local function first_three(base)
  local out = lists.of(3, function(k) return ("#  FCT_ID%d                       FSCALE%d\n"):format(k, k) .. ids(base + k, "") .. reals(1.0) end)
  return table.concat(out, "\n")
end

-- /FAIL/FABRIC: nominal strains from which and at which the stress of each family is gone [OpenRadioss, hm_read_fail_fabric.F, fail_fabric_c.F]. A family
-- without them holds; an element is removed when both have failed.
local never = { 1e20, 2e20 }
local function failure(p, id)
  if not p.failure then return {} end
  local warp, weft = p.failure.warp or never, p.failure.weft or never
  return { ("/FAIL/FABRIC/%d"):format(id), head("EPSILON_F1", "EPSILON_R1", "EPSILON_F2", "EPSILON_R2"), reals(warp[1], warp[2], weft[1], weft[2]), "#   FCT_ID", ids(0) }
end

-- /FAIL/ORTHSTRAIN: nominal strains (STRDEF = 2) between which damage grows in tension along each family [OpenRadioss, fail_orthstrain.cfg (format 2021),
-- hm_read_fail_orthstrain.F, fail_orthstrain_c.F]. A family without them holds, as do shear and compression.
local function orthstrain(p, id)
  if not p.failure then return {} end
  local out = { ("/FAIL/ORTHSTRAIN/%d"):format(id), "#                                   PTHK                                            STRDEF",
    (" "):rep(20) .. reals(1.0) .. (" "):rep(50) .. ids(2), head("EPSILON_DOT_REF", "FCUT"), reals(0.0, 0.0), "# FCT_IDEL           FSCALE_EL              EI_REF", ids(0) .. reals(0.0, 0.0) }
  for _, way in ipairs { "11", "22", "33", "12", "23", "31" } do
    local strains = way == "11" and p.failure.warp or way == "22" and p.failure.weft or never
    out[#out + 1] = ("#       EPSILON_%sTF        EPSILON_%sTM FCT_ID%sT        EPSILON_%sCF        EPSILON_%sCM FCT_ID_%sC"):format(way, way, way, way, way, way)
    out[#out + 1] = reals(strains[1], strains[2]) .. ids(0) .. reals(never[1], never[2]) .. ids(0)
  end
  return out
end

-- /MAT/LAW58 [OpenRadioss, starter hm_read_mat58.F and law58_upd.F; Altair Radioss Reference Guide, /MAT/LAW58 (FABR_A)].
function radioss.law58(card, name, p, u, id)
  local s, base = u.stress, 10 * id
  local out = {
    ("/MAT/LAW58/%d"):format(id), name,
    head "RHO_I", reals(card.density * u.density),
    head("E1", "B1", "E2", "B2", "FLEX"), reals(p.E1 * s, 0.0, p.E2 * s, 0.0, p.FLEX),
    head("G0", "GT", "ALPHA_T", "GSH", "SENS_ID"), reals(p.shear.slope * math.deg(1) * s, p.shear.slope * math.deg(1) * s, 0.0, 0.0) .. (" "):rep(10) .. ids(0),
    head("DF", "DS", "GFROT", "", "ZEROSTRESS"), reals(0.0, 0.0, 0.0, "", 0.0),
    "#       N1        N2                  S1                  S2               FLEX1               FLEX2",
    ids(1, 1) .. reals(p.S1, p.S2, p.FLEX, p.FLEX),
    first_three(base),
    "#  FCT_ID4   FCT_ID5             FSCALE4             FSCALE5   FCT_ID6             FSCALE6",
    ids(base + 4, base + 5) .. reals(1.0, 1.0) .. ids(base + 6) .. reals(1.0),
  }
  local order = { "warp", "weft", "shear" }
  for k, part in ipairs(order) do
    for j, what in ipairs { "loading", "unloading" } do
      local c = p[part][what]
      out[#out + 1] = funct(base + k + 3 * (j - 1), part .. ", " .. what, part == "shear" and odd(c) or c, 1, s)
    end
  end
  table.move(failure(p, id), 1, 5, #out + 1, out)
  return table.concat(out, "\n")
end

-- /MAT/LAW158 [OpenRadioss, starter hm_read_mat158.F and law158_upd.F, columns of mat_158_fabric.cfg (format 2023)]. The engine does not apply the
-- scales of the functions, so they are 1 and the functions hold the stresses themselves.
function radioss.law158(card, name, p, u, id)
  local s, base = u.stress, 10 * id
  local out = {
    ("/MAT/LAW158/%d"):format(id), name,
    head "RHO_I", reals(card.density * u.density),
    head("S1", "S2", "FLEX", "FLEX1", "FLEX2"), reals(p.S1, p.S2, p.FLEX * s, p.FLEX1 * s, p.FLEX2 * s),
    "#         ZEROSTRESS             SENS_ID", reals(0.0) .. ids("", 0),
    first_three(base),
    "#  FCT_ID4   FCT_ID5", ids(0, 0),
  }
  for k, part in ipairs { "warp", "weft", "shear" } do
    local c = p[part].loading
    out[#out + 1] = funct(base + k, part .. ", loading", part == "shear" and odd(c) or c, 1, s)
  end
  table.move(failure(p, id), 1, 5, #out + 1, out)
  return table.concat(out, "\n")
end

-- /MAT/LAW19 [OpenRadioss, engine sigeps19c.F; Altair Radioss Reference Guide, /MAT/LAW19 (FABRI)].
function radioss.law19(card, name, p, u, id)
  local s = u.stress
  local out = {
    ("/MAT/LAW19/%d"):format(id), name,
    head "RHO_I", reals(card.density * u.density),
    head("E11", "E22", "NU12"), reals(p.E11 * s, p.E22 * s, p.NU12),
    head("G12", "G23", "G31"), reals(p.G12 * s, p.G12 * s, p.G12 * s),
    head("RE", "", "ZEROSTRESS", "FSCALE_POR") .. ("%10s"):format "SENS_ID", reals(p.RE, "", 0.0, 0.0) .. units.line(10, { 0 }),
  }
  local breaks = orthstrain(p, id)
  table.move(breaks, 1, #breaks, #out + 1, out)
  return table.concat(out, "\n")
end

return radioss
