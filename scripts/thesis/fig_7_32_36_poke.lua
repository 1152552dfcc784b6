-- Figs. 7-32 to 7-36 of [williams2010]: the middle 16 elements of a 2 x 2 m sheet of the blend are driven 0.40 m up and back in half a
-- second, rim held; woven law and SVK; stress against strain in the elements 207 and 271.
--
--   fabricsh scripts/thesis/fig_7_32_36_poke.lua [step in s, or auto]
--
-- The thesis states no ramp, gravity or rotations of the punch; here z = 0.40 (1 - cos 4 pi t) / 2, gravity on, the punch's nodes
-- held in x, y and rotation. Elements are numbered along x from the corner: 207 is one element from the punch along the warp,
-- 271 along the weft.
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
local step = tonumber(arg[1]) or "auto"
chapter.begin("7-32 ... 7-36", "poke, woven law and SVK", "fig_7_32_36")

local function poke(card, name)
  local mesh = fabric.mesh.rectangle { width = 2, height = 2, nx = 20, ny = 20 }
  mesh:set("punch", function(x, y) return math.abs(x - 1) < 0.201 and math.abs(y - 1) < 0.201 end)
  local model = fabric.model { mesh = mesh, card = card, warp = 0 }
  model:fix("boundary", "x y z rotation"):fix("punch", "x y rotation"):gravity { 0, 0, -9.81 }
  model:move("punch", { z = function(t) return 0.40 * (1 - math.cos(4 * math.pi * t)) / 2 end })
  local a = fabric.dynamic { model = model, duration = 0.5, step = step }
  local at = { [207] = {}, [271] = {} }
  a:every(0.0025, function(run)
    for number, rows in pairs(at) do rows[#rows + 1] = run:element(number) end
  end)
  a:vtk(("%s/%s"):format(chapter.folder, name), { every = 0.05 })
  a:solve()
  local low = 0
  for i = 1, #mesh.nodes do low = math.min(low, a:node(i).uz) end
  return { run = a, at = at, low = low }
end

local function peak(rows, name)
  local best = rows[1]
  for _, row in ipairs(rows) do
    if row[name] > best[name] then best = row end
  end
  return best
end

local card = fabric.card "blend"
local woven, svk = poke(card, "woven"), poke(chapter.svk(card), "svk")
if fabric.checking() then return end
local warp, weft = peak(woven.at[207], "S11"), peak(woven.at[271], "S22")
local svk_warp, svk_weft = peak(svk.at[207], "S11"), peak(svk.at[271], "S22")
chapter.row("element 207: peak S11, MPa, and E11; SVK", "woven higher than SVK", ("%.2f at %.4f; %.2f"):format(warp.S11 / MPa, warp.E11, svk_warp.S11 / MPa))
chapter.row("element 271: peak S22, MPa, and E22; SVK", "woven higher than SVK", ("%.2f at %.4f; %.2f"):format(weft.S22 / MPa, weft.E22, svk_weft.S22 / MPa))
chapter.row("sag when the punch is back, mm: woven, SVK", "woven keeps its stretch and wrinkles, SVK recovers", ("%.0f, %.0f"):format(-1e3 * woven.low, -1e3 * svk.low))
local e, f = woven.run.energy, svk.run.energy
chapter.row("lost, J: woven, SVK", nil, ("%.1f, %.1g"):format(e.dissipated, f.dissipated))
chapter.row("ledger: error over the work, woven, SVK", nil, ("%.1e, %.1e"):format(e.error, f.error))

for name, words in pairs { woven = "The stretched cloth doesn't come back: it hangs through and folds round the punch.",
                           svk = "SVK comes back to its plane but for the swing of the sheet." } do
  local frames, labels = {}, {}
  for i, k in ipairs { 0, 3, 5, 7, 10 } do
    frames[i] = ("%s/%s_%05d.vtu"):format(chapter.folder, name, k)
    labels[i] = ("(%s) %.2f s"):format(("abcde"):sub(i, i), k / 20)
  end
  chapter.render(name, words, { vtu = frames, labels = labels, columns = 3, field = "uz", view = { 25, 20 }, width = 1800, height = 1000, title = "blend, poke, " .. name })
end
local function curves(number, E, S, yarn)
  return { chapter.curve(woven.at[number], "woven law", "line_points", E, S), chapter.curve(svk.at[number], "SVK", "points", E, S),
           chapter.line(function(x) return chapter.P(yarn, x) end, number == 207 and warp.E11 or weft.E22, "P(E)") }
end
chapter.plot("element_207", "Nonlinear loading above SVK, steep unloading to a residual strain, then slack.",
             { title = "poke, element 207", xlabel = "E11", ylabel = "S11, MPa", curves = curves(207, "E11", "S11", card.warp) })
chapter.plot("element_271", "The same along the weft.",
             { title = "poke, element 271", xlabel = "E22", ylabel = "S22, MPa", curves = curves(271, "E22", "S22", card.weft) })
local nu12, nu21 = card.warp.poisson, card.weft.poisson
local c = math.min(nu21 * card.warp.loading[1], nu12 * card.weft.loading[1]) / (1 - nu12 * nu21)
chapter.expect {
  -- Averages over an element in which the strain varies by a tenth: P of the mean is not the mean of P.
  { "207: S11 = P(E11) + c (nu12 E11 + E22)", warp.S11, chapter.P(card.warp, warp.E11) + c * (nu12 * warp.E11 + warp.E22), relative = 0.05 },
  { "271: S22 = P(E22) + c (nu21 E22 + E11)", weft.S22, chapter.P(card.weft, weft.E22) + c * (nu21 * weft.E22 + weft.E11), relative = 0.05 },
  { "ledger, woven: error over the work", e.error, 0, absolute = 1e-5 }, -- second order in the step
  { "ledger, SVK", f.error, 0, absolute = 1e-3 },                        -- nothing damps its ringing
  { "SVK loses nothing, J", f.dissipated, 0, absolute = 1e-12 },
  { "woven loses, stores and moves what the punch gave", (e.kinetic + e.stored + e.dissipated) / e.external, 1, relative = 1e-5 },
}
