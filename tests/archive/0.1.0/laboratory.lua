-- From a load frame's file to a card and a virtual test.
local fabric = require "fabric"
local lab, mm = fabric.lab, fabric.units.mm
local truth = dofile((arg[0]:gsub("[^/]*$", "card.lua")))
local rows = { "time (s);extension (mm);load (N)" }
for i = 0, 60 do
  local u = i <= 50 and 0.3*i or 15 - 0.05*(i - 50) -- mm
  local e = u / 76.2
  local E = e + e*e/2
  local top = 15 / 76.2
  local E_top = top + top*top/2
  local S = i <= 50 and 8e6*E + 413e6*E^2 or 8e6*E_top + 413e6*E_top^2 - 864e6*(E_top - E)
  rows[#rows + 1] = ("%g;%.6f;%.6f"):format(i, u, S * (1 + e) * 25.4e-3 * 0.38e-3)
end
fabric.write("out/frame.csv", table.concat(rows, "\n") .. "\n")
if fabric.checking() then return end
local test = lab.tensile{ file="out/frame.csv", gauge_length=76.2*mm, width=25.4*mm, thickness=0.38*mm, plies=1 }
local fit = lab.fit{ tests={ test }, degree=2 }
local pull = lab.uniaxial{ card=truth, direction="warp", displacement=15*mm, grips="free", steps=20 }
fabric.expect{
  { "fitted d0, Pa", fit.loading[1], 8e6, relative=1e-3 },
  { "fitted d1, Pa", fit.loading[2], 826e6, relative=1e-3 },
  { "fitted unloading, Pa", fit.unloading, 864e6, relative=1e-2 },
  { "the virtual test meets the record, N", pull.peak.force, test.S[51] * 25.4e-3 * 0.38e-3 * (1 + 15 / 76.2), relative=1e-6 },
  { "kN/m of a modulus and a thickness", truth.warp.loading[1] * truth.thickness / 1e3, 3.04, relative=1e-12 },
}
