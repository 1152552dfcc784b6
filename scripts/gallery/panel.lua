-- The front of a bodice from its outline: squares along the grain, a rim that fits, a dart in the waist; flat, and laid around a cone.
local fabric, out = require "fabric", arg[1] or "out/gallery"
local mm = fabric.units.mm
local function front()
  return fabric.mesh.panel {
    size = 14 * mm,
    grain = 90,
    outline = {
      { 0, 0 },
      { 240 * mm, 0, name = "waist" },
      { 255 * mm, 190 * mm, name = "side" },
      { spline = { { 212 * mm, 240 * mm }, { 200 * mm, 320 * mm }, { 205 * mm, 395 * mm } }, name = "armhole" },
      { 90 * mm, 430 * mm, name = "shoulder" },
      { arc = { centre = { 0, 430 * mm }, to = { 0, 340 * mm }, clockwise = true }, name = "neck" },
      { name = "centre" },
    },
    darts = { { from = { 105 * mm, 0 }, tip = { 118 * mm, 160 * mm }, to = { 130 * mm, 0 }, name = "dart" } },
    notches = { { name = "front of the sleeve", edge = "armhole", share = 0.4 } },
  }
end
local flat, around = front(), front()
around:wrap { cone = { radius = 120 * mm, angle = 8, at = { 120 * mm, 100 * mm }, towards = { 0, -1, 0 } } }
local report = flat:check()
print(report)
if fabric.checking() then return end
for name, mesh in pairs { panel = flat, panel_cone = around } do
  local file = os.tmpname() .. ".vtu"
  mesh:write(file)
  fabric.render { file = out .. "/" .. name .. ".png", vtu = file, view = name == "panel" and "above" or { 30, 20 }, width = 700, height = 930 }
  os.remove(file)
end
-- On the cone chords are shorter than arcs by the square of the angle of an element over 24: 0.117 rad there.
fabric.expect {
  { "corner of the worst element is above 25 degrees (1: yes)", report.least_angle > 25 and 1 or 0, 1, absolute = 0 },
  { "area on the cone, m2", around:check().area, report.area, relative = 0.117 ^ 2 / 24 * 1.5 },
}
