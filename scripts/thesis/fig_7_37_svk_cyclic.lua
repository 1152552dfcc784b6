-- Fig. 7-37 of [williams2010]: SVK and the woven law in cyclic tension of the blend, and what section 7.4 says of both.
--
--   fabricsh scripts/thesis/fig_7_37_svk_cyclic.lua
--
-- Section 7.4 states by how much the present model and SVK differ from the measurement at 1, 5 and 10 % strain, without signs.
-- Each number allows two measured stresses, S / (1 + p) and S / (1 - p); both models met the same measurement, so one of the
-- first pair must be one of the second. The table takes the nearest two and says how far apart they are.
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
chapter.begin("7-37", "SVK beside the woven law, cyclic tension, blend", "fig_7_37")

local card, svk = chapter.card "blend", chapter.svk(chapter.card "blend")
local stated = { -- strain, present model, SVK
  warp = { { 0.01, 0.14, 0.67 }, { 0.05, 0.45, 0.75 }, { 0.10, 0.03, 0.94 } },
  weft = { { 0.01, 0.13, 0.33 }, { 0.05, 0.02, 0.10 }, { 0.10, 0.06, 0.42 } },
}

local function nearest(S, p, T, q)
  local best, pair = math.huge, nil
  for _, a in ipairs { S / (1 + p), S / (1 - p) } do
    for _, b in ipairs { T / (1 + q), T / (1 - q) } do
      local gap = math.abs(math.log(a / b))
      if gap < best then best, pair = gap, { a, b } end
    end
  end
  return pair[1], pair[2]
end

local checks, curves, gaps, pulled = {}, {}, {}, nil
for _, direction in ipairs { "warp", "weft" } do
  local yarn = card[direction]
  local function strip(with)
    return fabric.lab.uniaxial { card = with, direction = direction, grips = "free", displacement = direction == "warp" and 0.018 or 0.010,
                                 out = with == card and chapter.folder .. "/" .. direction or nil }
  end
  local linear, woven = strip(svk), strip(card)
  pulled = pulled or woven
  curves[#curves + 1] = chapter.curve(linear.curve, direction .. ", SVK", "dashed")
  curves[#curves + 1] = chapter.curve(woven.curve, direction .. ", woven law")
  for _, row in ipairs(stated[direction]) do
    local x, p, q = table.unpack(row)
    local a, b = nearest(chapter.P(yarn, x), p, yarn.loading[1] * x, q)
    gaps[#gaps + 1] = math.abs(a / b - 1)
    chapter.row(("%s at %g %% strain: measured stress implied by woven, by SVK"):format(direction, 100 * x), ("differs by %g %%, %g %%"):format(100 * p, 100 * q),
                ("%.3f, %.3f MPa: apart by %.0f %%"):format(a / MPa, b / MPa, 100 * gaps[#gaps]))
  end
  chapter.mesh_rows(direction .. ", free ends", fabric.lab.uniaxial { card = card, direction = direction, grips = "free", unload = false, steps = 10 }, { "S" })
  local m, last = woven.peak.E, woven.curve[#woven.curve]
  checks[#checks + 1] = { direction .. ": SVK comes back to zero strain", linear.curve[#linear.curve].E, 0, absolute = 1e-6 }
  -- The release is found to 1e-6 of the peak force; the slack strip behind it is 100 times softer than the yarn.
  checks[#checks + 1] = { direction .. ": woven keeps m - P(m) / Du", last.E, m - chapter.P(yarn, m) / yarn.unloading, absolute = 1e-3 }
end
-- The statements of the text contradict each other: no choice of signs lets one measurement stand behind both numbers.
for i, gap in ipairs(gaps) do checks[#checks + 1] = { ("statement %d: apart by 5 %% at least (1: yes)"):format(i), gap > 0.05 and 1 or 0, 1, relative = 1e-12 } end
chapter.plot("curves", "The woven law stiffens and keeps a residual strain; SVK is straight and comes back along itself.",
             { title = "blend: SVK and the woven law, pulled and let go", curves = curves, xlabel = "Green-Lagrange strain E", ylabel = "S, MPa" })
chapter.render("residual", "The woven strip when the grip lets go: the residual strain, uniform.",
               { vtu = { chapter.folder .. "/warp/strip_00000.vtu", chapter.frame(chapter.folder .. "/warp/strip", pulled, pulled.peak), chapter.frame(chapter.folder .. "/warp/strip", pulled) }, labels = { "start", "18 mm", "the grip lets go" },
                 field = "E11" })
return chapter.expect(checks)
