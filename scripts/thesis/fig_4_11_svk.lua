-- Fig. 4-11 of [williams2010]: St. Venant-Kirchhoff with the moduli at zero strain beside the curve that was measured, blend.
--
--   fabricsh scripts/thesis/fig_4_11_svk.lua
--
-- Under uniaxial stress SVK gives S = D(0) E, whatever the ratios.
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
chapter.begin("4-11", "SVK against the measured backbone, blend", "fig_4_11")

local card, svk = chapter.card "blend", chapter.svk(chapter.card "blend")
local checks, curves, warp = {}, {}, nil
for _, direction in ipairs { "warp", "weft" } do
  local yarn = card[direction]
  local test = fabric.lab.uniaxial { card = svk, direction = direction, grips = "free", unload = false, steps = 40,
                                     displacement = direction == "warp" and 0.018 or 0.010,
                                     out = direction == "warp" and chapter.folder or nil }
  local E = test.peak.E
  warp = warp or test
  curves[#curves + 1] = chapter.curve(test.curve, direction .. ", SVK")
  curves[#curves + 1] = chapter.line(function(x) return chapter.P(yarn, x) end, E, direction .. ", P(E)")
  for _, x in ipairs { 0.01, 0.05, 0.10 } do
    chapter.row(("%s: SVK over P(E) at E = %.2f"):format(direction, x), nil, yarn.loading[1] * x / chapter.P(yarn, x))
  end
  checks[#checks + 1] = { direction .. ": S = D(0) E", test.peak.S, yarn.loading[1] * E, relative = 1e-9 }
  checks[#checks + 1] = { direction .. ": nothing dissipated", test.analysis.energy.dissipated, 0, absolute = 1e-15 }
end
chapter.mesh_rows("SVK, warp, clamped", fabric.lab.uniaxial { card = svk, displacement = 0.018, unload = false, steps = 10 }, { "S", "E_lateral" })
chapter.plot("curves", "SVK is straight and falls short of the stiffening cloth from a few per cent of strain on.",
             { title = "blend: SVK and the measured backbone", curves = curves, xlabel = "Green-Lagrange strain E", ylabel = "S, MPa" })
chapter.render("svk", "SVK with free ends: uniform stress, uniform contraction.",
               { vtu = chapter.frame(chapter.folder .. "/strip", warp), field = "S11" })
return chapter.expect(checks)
