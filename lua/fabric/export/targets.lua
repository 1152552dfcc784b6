-- The materials to which a card can be exported. For each: its solver, the kinds of card that it accepts, the determination of its
-- parameters, its text, its law, and a description of its losses.
local fabric = require "fabric"
local sampled = require "fabric.export.sampled"
local curves = require "fabric.export.curves"
local laws = require "fabric.export.laws"
local dyna = require "fabric.export.dyna"
local radioss = require "fabric.export.radioss"
local abaqus = require "fabric.export.abaqus"
local lists = require "fabric.lists"

local targets = {}

local function ends(card)
  local t, out = sampled.tested(card), {}
  for _, axis in ipairs(sampled.axes) do
    out[axis] = { E = t[axis], S = fabric.point(card):uniaxial(axis, t[axis]).S }
    out[axis].stretch = math.sqrt(1 + 2 * t[axis])
  end
  out.shear = { E = t.shear, S = fabric.point(card):strain({ E12 = t.shear }).S12, angle = math.asin(math.min(0.99, 2 * t.shear)) }
  return out
end

-- Linear laws agree with the card at the ends of the tested ranges.
local function secant_235(card)
  local e = ends(card)
  local function modulus(x) return x.S * x.stretch / math.log(x.stretch) end -- S = E ln(lambda)/lambda while nothing contracts across
  local G = e.shear.S / (math.cos(e.shear.angle) * e.shear.angle)
  local E1 = modulus(e.warp) + modulus(e.weft) -- twice the mean: half of the sheet is warp, half weft
  return { E1 = E1, E2 = 1e-3 * E1, G12 = G, DSCF = 1.0, THL = (90 - math.min(80, math.deg(e.shear.angle) * 1.3)) / 2 }
end

local function secant_19(card)
  if card.kind == "svk" then
    local nn = card.poisson[1] * card.poisson[2]
    return { E11 = card.warp, E22 = card.weft, NU12 = math.sqrt(nn * card.warp / card.weft), G12 = card.shear, RE = 1.0 }
  end
  local e = ends(card)
  local nn = card.warp.poisson * card.weft.poisson
  local nu12, nu21, E11, E22 = 0, 0, nil, nil
  for _ = 1, 20 do -- scales the ratio for symmetry: NU12 nu21 = the card's product
    E11 = e.warp.S * e.warp.stretch ^ (1 + nu12) / math.log(e.warp.stretch)
    E22 = e.weft.S * e.weft.stretch ^ (1 + nu21) / math.log(e.weft.stretch)
    nu12, nu21 = math.sqrt(nn * E11 / E22), math.sqrt(nn * E22 / E11)
  end
  return { E11 = E11, E22 = E22, NU12 = nu12, G12 = e.shear.S / (math.cos(e.shear.angle) * e.shear.angle), RE = 1e-3 }
end

local function elastic(card)
  local nn = card.poisson[1] * card.poisson[2]
  local through = card.transverse or { 5 / 6 * card.shear, 5 / 6 * card.shear }
  return { E11 = card.warp, E22 = card.weft, NU12 = math.sqrt(nn * card.warp / card.weft), NU21 = math.sqrt(nn * card.weft / card.warp),
    G12 = card.shear, G13 = through[1], G23 = through[2] }
end

local function curves_58(card)
  local p = curves.of(card, "nominal_degrees", "scaled")
  p.E1, p.E2, p.S1, p.S2, p.FLEX = p.warp.slope, p.weft.slope, 1e-4, 1e-4, 1e-3
  return p
end

-- Yarns that are straight from the start but for a ten thousandth: with springs of the crimp this soft they carry no compression, and the law's own
-- iteration, which stops after ten steps, still finds their balance (within 0.3 % of the peak stress in cycles of 10 %).
local function curves_158(card)
  local p = curves.of(card, "nominal_degrees", "scaled")
  local stiff = math.max(p.warp.slope, p.weft.slope)
  p.S1, p.S2, p.FLEX, p.FLEX1, p.FLEX2 = 1e-4, 1e-4, 1e-6 * stiff, 1e-6 * p.warp.slope, 1e-6 * p.weft.slope
  return p
end

local one_direction = "every shear angle counts from the unsheared state, also after a return to zero stress"

targets.list = {
  { name = "MAT_034", solver = "ls-dyna", kinds = { woven = true }, comment = dyna.comment, write = dyna.mat_034, law = laws.mat_034,
    parameters = function(card) return curves.of(card, "green", "scaled") end,
    source = "LS-DYNA Keyword User's Manual, volume II, *MAT_034 (*MAT_FABRIC), FORM = 14, CSE = 1, RL = 0",
    hysteresis = "an unloading curve, scaled to the point of turning, that ends at zero strain: no residual strain, and reloading takes the same way",
    flips = one_direction, bending = "a membrane, without bending",
    no_fail = ", and *MAT_ADD_EROSION would remove whole elements, both families at once" },
  { name = "MAT_235", solver = "ls-dyna", kinds = { woven = true }, comment = dyna.comment, write = dyna.mat_235, law = laws.mat_235,
    parameters = secant_235, source = "LS-DYNA Keyword User's Manual, volume II, *MAT_235 (*MAT_MICROMECHANICS_DRY_FABRIC), straight yarns",
    measure = "secants at the tested strains, Cauchy stress over logarithmic strain; one yarn modulus serves warp and weft: their mean",
    hysteresis = "elastic, none", flips = one_direction, bending = "that of the integration through the thickness with the yarns' moduli" },
  { name = "LAW58", solver = "openradioss", kinds = { woven = true }, comment = radioss.comment, write = radioss.law58, law = laws.law58, property = "TYPE16",
    parameters = curves_58, source = "OpenRadioss, sigeps58c.F and hm_read_mat58.F; Altair Radioss Reference Guide, /MAT/LAW58 (FABR_A)",
    hysteresis = "an unloading curve, scaled to the point of turning, that ends at zero strain: no residual strain; reloading on the scaled loading curve",
    coupling = "coupling: yarns are written practically straight (S1 = S2 = 1e-4), so crimp does not tie warp to weft",
    flips = one_direction, bending = "a membrane (N = 1), without bending", fail = "/FAIL/FABRIC" },
  { name = "LAW158", solver = "openradioss", kinds = { woven = true }, comment = radioss.comment, write = radioss.law158, law = laws.law158, property = "TYPE16", format = 2023,
    parameters = curves_158, elastic = true, source = "OpenRadioss, sigeps158c.F, hm_read_mat158.F and mat_158_fabric.cfg (format 2023), /MAT/LAW158 (FABR_NL)",
    hysteresis = "elastic, none: unloading follows the loading curve",
    coupling = "coupling: yarns are written practically straight (S1 = S2 = 1e-4), so crimp does not tie warp to weft",
    flips = one_direction, bending = "a membrane (N = 1), without bending", fail = "/FAIL/FABRIC" },
  { name = "LAW19", solver = "openradioss", kinds = { woven = true, svk = true }, comment = radioss.comment, write = radioss.law19, law = laws.law19, property = "TYPE9",
    parameters = secant_19, source = "OpenRadioss, sigeps19c.F; Altair Radioss Reference Guide, /MAT/LAW19 (FABRI)",
    measure = "secants at the tested strains, Cauchy stress over logarithmic strain",
    coupling = "coupling: one Poisson ratio, symmetric; the product of the card's two is kept",
    hysteresis = "elastic, none", flips = one_direction, bending = "a membrane (N = 1), without bending", fail = "/FAIL/ORTHSTRAIN", fails_by_itself = true },
  { name = "FABRIC", solver = "abaqus", kinds = { woven = true }, comment = abaqus.comment, write = abaqus.fabric, law = laws.fabric,
    parameters = function(card) return curves.of(card, "nominal_radians", "shifted") end,
    source = "Abaqus Analysis User's Guide, 23.4.1 (Abaqus/Explicit, *FABRIC with test data)",
    hysteresis = "the unloading curve is shifted to the point of turning, with its residual strain; slack below it carries no compression",
    flips = one_direction, bending = "membranes have none; shells integrate the curves through the thickness" },
  { name = "ELASTIC", solver = "abaqus", kinds = { svk = true }, comment = abaqus.comment, write = abaqus.elastic, law = laws.svk,
    parameters = elastic, source = "CalculiX CrunchiX User's Manual, *ELASTIC, TYPE=ENGINEERING CONSTANTS: with NLGEOM, Green's strain and second "
      .. "Piola-Kirchhoff stress", measure = "constants as they are; Abaqus itself takes them for Cauchy stress over logarithmic strain",
    hysteresis = "none", flips = "none", bending = "that of the integration through the thickness" },
}

targets.solvers = { "ls-dyna", "openradioss", "abaqus" }

-- Names of the materials of a solver.
function targets.names(solver)
  return lists.collect(targets.list, function(t) if t.solver == solver then return t.name end end)
end

-- Accepts "MAT_034", "*MAT_034", "mat_34", "LAW58", "*FABRIC", "fabric".
local function plain(name) return (name:upper():gsub("^%*", ""):gsub("^MAT_0*(%d)", "MAT_%1"):gsub("^MAT_FABRIC$", "MAT_34")) end

-- The target of a solver with this material name; without a name, the first that accepts the kind of card. nil if there is none.
function targets.find(solver, name, kind)
  for _, t in ipairs(targets.list) do
    if t.solver == solver and (name and plain(t.name) == plain(name) or not name and t.kinds[kind]) then return t end
  end
end

return targets
