-- A card of a deck's own takes the estimate of its bending from its areal mass, by the way that the warning names.
local fabric = require "fabric"
local MPa, mm = fabric.units.MPa, fabric.units.mm
local function own(thickness)
  return fabric.woven {
    name = "own", density = 400, thickness = thickness,
    warp = { loading = { 40 * MPa, 300 * MPa }, unloading = 120 * MPa, poisson = 0 },
    weft = { loading = { 20 * MPa, 200 * MPa }, unloading = 80 * MPa, poisson = 0 },
    shear = { loading = { 0.2 * MPa, 4 * MPa }, unloading = 1 * MPa },
  }
end
local card = own(0.5 * mm) -- 200 g/m2
local bent = fabric.card(card, { bending = "estimated" })
local heavy = fabric.card(own(1 * mm), { bending = "estimated" })
local measured = card:with { bending = { warp = 5e-6, weft = 4e-6, twist = 2e-6 } }
local feather, why = pcall(fabric.card, own(0.03 * mm), { bending = "estimated" })
-- A horizontal strip of 20 mm under its own weight: the cantilever of small slopes, w L^4 / (8 B).
local strip = fabric.mesh.rectangle { width = 20 * mm, height = 10 * mm, nx = 8, ny = 4 }
local m = fabric.model { mesh = strip, card = bent, warp = 0 }:fix("left", "x y z rotation"):gravity { 0, 0, -0.981 }
local a = fabric.static { model = m, duration = 1, step = 1 }
a:solve()
local function first(B) return type(B) == "table" and B[1] or B end
fabric.expect {
  { "warp at 200 g/m2", first(bent.bending.warp), 15.1e-6, relative = 1e-9 },
  { "twist is 45 degrees less a quarter of both", bent.bending.twist, 11.9e-6 - (15.1e-6 + 9.75e-6) / 4, relative = 1e-9 },
  { "twice the mass", first(heavy.bending.weft), 9.75e-6 * 2 ^ 1.12, relative = 1e-9 },
  { "the estimate is kept", first(bent.estimate.bending.warp), 15.1e-6, relative = 1e-9 },
  { "where it comes from", bent.provenance.bending:find("assumed: estimated, X. Feng", 1, true) and 1 or 0, 1, absolute = 0 },
  { "own bending stays", first(fabric.card(measured, { bending = "estimated" }).bending.warp), 5e-6, relative = 1e-12 },
  { "a film is refused", not feather and tostring(why):find(
    "field 'bending': expected an areal mass (density times thickness) of 0.015 to 0.87 kg/m2, as the cloths have from which bending is estimated, got 0.012", 1, true) and 1 or 0, 1, absolute = 0 },
  { "sag of the tip", -a:node(9).uz, 400 * 0.5e-3 * 0.981 * 0.02 ^ 4 / (8 * 15.1e-6), relative = 0.03 },
}
