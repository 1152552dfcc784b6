-- From force and displacement to stress and strain, and from a bias pull to a shear modulus, where warp and weft, plies, compliance and slip all differ.
local fabric = require "fabric"
local checks = {}
local function check(name, got, want, relative) checks[#checks + 1] = { name, got, want, relative = relative or 1e-12 } end

-- Kilby [kilby1963]: the modulus at 45 degrees of a sheet whose compliance is unsymmetric, by turning the strain and the stress. Under a pull S at 45 degrees
-- S11 = S22 = S/2, S12 = -S/2; E11 = S11 / E1 - nu21 / E2 S22 and E22 = S22 / E2 - nu12 / E1 S11 by the definition of the ratios, 2 E12 = S12 / G; along the pull
-- E = (E11 + E22) / 2 - E12. As printed the ratios stand over the other moduli.
do
  local E1, E2, n12, n21, G = 8e6, 37e6, 0.25, 0.42, 1.3e6
  for _, reading in ipairs { "definition", "printed" } do
    local a, b = n21 / E2, n12 / E1
    if reading == "printed" then a, b = n21 / E1, n12 / E2 end
    local E11, E22, E12 = 0.5 / E1 - a * 0.5, 0.5 / E2 - b * 0.5, -0.5 / (2 * G)
    local bias = 1 / ((E11 + E22) / 2 - E12)
    check("Kilby, " .. reading .. ": bias", fabric.lab.kilby { warp = E1, weft = E2, nu12 = n12, nu21 = n21, shear = G, reading = reading }.bias, bias)
    check("Kilby, " .. reading .. ": shear", fabric.lab.kilby { warp = E1, weft = E2, nu12 = n12, nu21 = n21, bias = bias, reading = reading }.shear, G)
  end
end

-- A pull of two plies in a frame that gives by its compliance and in grips that slip over the largest force so far, with a displacement and a force at its start.
--   u = given - compliance P - slip max P, E = u / l + (u / l)^2 / 2, S = P / (plies w t (1 + u / l))
do
  local l, w, t, plies, soft, slip, u0, P0 = 0.0762, 0.0254, 0.38e-3, 2, 4e-5, 3e-5, 0.0031, 0.7
  local pulls = { 0, 5, 12, 20, 31, 14, 3, 9, 36 }
  local given, force, most = {}, {}, 0
  local stretch = { 0, 0.012, 0.025, 0.037, 0.049, 0.041, 0.033, 0.038, 0.056 }
  for k, P in ipairs(pulls) do
    most = math.max(most, P)
    given[k], force[k] = stretch[k] * l + soft * P + slip * most + u0, P + P0
  end
  local test = fabric.lab.tensile { record = { displacement = given, force = force }, gauge_length = l, width = w, thickness = t, plies = plies, compliance = soft, slip = slip,
    zero = true, outliers = "keep", tolerance = 1e-5 }
  for k, P in ipairs(pulls) do
    if k > 1 then
      check(("row %d: strain"):format(k), test.E[k], stretch[k] + stretch[k] ^ 2 / 2, 1e-9)
      check(("row %d: stress"):format(k), test.S[k], P / (plies * w * t * (1 + stretch[k])), 1e-9)
    end
  end
  check("area", test.area, plies * w * t)
  local kinds = {}
  for i, b in ipairs(test.branches) do kinds[i] = ("%s %d-%d"):format(b.kind, b.first, b.last) end
  local said = table.concat(kinds, ", ")
  assert(said == "loading 1-5, unloading 6-7, reloading 8-9" or said == "loading 1-5, unloading 6-7, reloading 8-8, loading 9-9", said)
end
fabric.expect(checks)
