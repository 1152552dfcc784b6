-- Fig. 7-9 of [williams2010]: the blend's warp strip at the start, at 18 mm, and let back to zero, where it buckles.
--
--   fabricsh scripts/thesis/fig_7_09_buckling.lua
--
-- Clamped ends that don't let go, the plane free, a bow of a tenth of the thickness to begin with. Static; a viscous force that
-- takes a millionth of each step's work carries the strip over the snap. Behind the snap the strip is longer than the distance
-- of the grips by its residual strain, and as cloth bends much more easily than it shortens, its shape is the elastica between
-- clamped ends: with length L, distance d and modulus k, d / L = 2 E(k) / K(k) - 1 and rise = k L / K(k).
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local mm = fabric.units.mm
chapter.begin("7-9", "snapshots of the cyclic test, warp, blend", "fig_7_09")

local card = chapter.card "blend"
local test = fabric.lab.uniaxial { card = card, out_of_plane = "free", unilateral = false, stabilise = 1e-6, cells = { 6, 18 },
                                   steps = 120, tolerance = 1e-7, out = chapter.folder }
-- Held flat it is pushed together instead, until it becomes unstable in its plane; to 55 % of the way back, just before that.
local flat = fabric.lab.uniaxial { card = card, unilateral = false, cells = { 6, 18 }, steps = 120, path = { 1, 0.55 } }

-- Complete elliptic integrals of the modulus k by the arithmetic-geometric mean.
local function elliptic(k)
  local a, g, sum, power = 1, math.sqrt(1 - k * k), 1 - k * k / 2, 1
  for _ = 1, 40 do
    local next_a, c = (a + g) / 2, (a - g) / 2
    g, a = math.sqrt(a * g), next_a
    sum, power = sum - power * c * c, 2 * power
  end
  local K = math.pi / (2 * a)
  return K, K * sum
end
assert(math.abs(elliptic(math.sqrt(0.5)) - 1.8540746773013719) < 1e-14)

local function elastica(length, distance)
  local low, high = 0, 0.999
  for _ = 1, 80 do
    local k = (low + high) / 2
    local K, E = elliptic(k)
    if 2 * E / K - 1 > distance / length then low = k else high = k end
  end
  return low * length / elliptic(low)
end

-- Length of the strip along its middle, and how far that stands out of the plane.
local nodes, length, rise = test.mesh.nodes, 0, 0
local function middle(row) return test.analysis:node(row * 7 + 4) end
for row = 1, 18 do
  local p, q = middle(row - 1), middle(row)
  length = length + math.sqrt((q.x - p.x) ^ 2 + (q.y - p.y) ^ 2 + (q.z - p.z) ^ 2)
  rise = math.max(rise, math.abs(q.z))
end
assert(#nodes == 7 * 19)
local yarn, peak = card.warp, test.peak
local residual = peak.E - chapter.P(yarn, peak.E) / yarn.unloading
local slack = 76.2 * mm * math.sqrt(1 + 2 * residual) -- length of a strip with that strain
local hard, last = flat.curve[#flat.curve], nil
for _, row in ipairs(test.curve) do
  if row.time > 1 and row.displacement >= hard.displacement - 1e-9 then last = row end
end
if fabric.checking() then return end -- what follows needs what was computed
chapter.row("buckles when let back, plane free", "yes, fig. 7-9c", "yes")
chapter.row("rise at zero displacement, mm", nil, rise / mm)
chapter.row("rise of the elastica of that length, mm", nil, elastica(length, 76.2 * mm) / mm)
chapter.row("pull when let back to 9.9 mm, N: plane free, held flat", nil, ("%.3f, %.2f"):format(last.force, hard.force))

chapter.plot("force", "Pull rises along the backbone, falls steeply, and is nearly zero once the strip has buckled; held flat it would be pushed together.",
             { title = "blend, warp: buckling when let back", xlabel = "displacement, mm", ylabel = "force, N",
               curves = { chapter.curve(test.curve, "plane free", "line", "displacement", "force", 1, 1e3),
                          chapter.curve(flat.curve, "held flat", "dashed", "displacement", "force", 1, 1e3) } })
local frames = {}
for i, row in ipairs { test.curve[1], test.peak, test.curve[#test.curve] } do frames[i] = chapter.frame(chapter.folder .. "/strip", test, row) end
chapter.render("snapshots", "Start, 18 mm, and back at zero: one fold across the strip, ends clamped level.",
               { vtu = frames, labels = { "(a) start", "(b) 18 mm", "(c) back at 0" }, field = "E11", view = { 50, 20 }, height = 55 })
chapter.expect {
  -- 18 elements bend the fold by chords; the strip's edges keep a little of the clamped width.
  { "rise over the elastica's", rise / elastica(length, 76.2 * mm), 1, relative = 0.03 },
  -- It is not pulled and hardly pushed: its length is that of the residual strain, up to the ends' held width.
  { "length over that of the residual strain", length / slack, 1, relative = 0.01 },
  { "push, plane free over held flat", last.force / hard.force, 0, absolute = 0.01 },
}
