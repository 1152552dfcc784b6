-- Fig. 7-31 of [williams2010]: a 2 x 2 m sheet of the blend, pinned at its corners, falls for half a second.
--
--   fabricsh scripts/thesis/fig_7_31_drape.lua [elements along an edge] [step in s, or auto]
--
-- 20 x 20 elements, explicit, gamma = 1/2, beta = 0; the thesis' step was 1e-5 s, `auto` is 0.7 of the stable one. The thesis had to
-- switch the shear's hysteresis off; here it is on. Its own rules make energy in closed loops; the ledger of state functions
-- shows it and stops the run.
--
-- Before anything has come from the corners the middle falls freely, by g t^2 / 2: at 5 ms a wave in the stiffest state has gone
-- 1.2 m at most, and the corners are 1.41 m away.
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local cells = math.tointeger(tonumber(arg[1] or 20))
local step = tonumber(arg[2]) or "auto"
chapter.begin("7-31", "drape from four corners, blend", "fig_7_31")

local g = 9.81
local function sheet(card, n)
  local mesh = fabric.mesh.rectangle { width = 2, height = 2, nx = n, ny = n }
  local model = fabric.model { mesh = mesh, card = card, warp = 0 }
  model:fix("corners", "x y z"):gravity { 0, 0, -g }
  return fabric.dynamic { model = model, duration = 0.5, step = step }, mesh, (n // 2) * (n + 1) + n // 2 + 1
end

-- Lowest node and the middle, m; how far the sheet is from its mirror images in x and y.
local function shape(a, n, middle)
  local low, off = 0, 0
  for j = 0, n do
    for i = 0, n do
      local z = a:node(j * (n + 1) + i + 1).uz
      low = math.min(low, z)
      off = math.max(off, math.abs(z - a:node(j * (n + 1) + n - i + 1).uz), math.abs(z - a:node((n - j) * (n + 1) + i + 1).uz))
    end
  end
  return low, a:node(middle).uz, off
end

local card = fabric.card "blend"
local a, _, middle = sheet(card, cells)
a:vtk(chapter.folder .. "/drape", { every = 0.1 })
local curve = { x = {}, y = {}, label = "middle of the sheet" }
a:every(0.005, function(run) curve.x[#curve.x + 1], curve.y[#curve.y + 1] = run.time, 1e3 * run:node(middle).uz end)
a:advance(0.005)
if fabric.checking() then return end
local fallen = a:node(middle).uz
a:advance(0.1)
local _, _, early = shape(a, cells, middle)
a:solve()
local low, centre = shape(a, cells, middle)
local e = a.energy

local rules = sheet(card:with { law = "thesis", transverse = "follow" }, cells)
local ok, why = pcall(rules.solve, rules)
local makes = ok and ("makes %.2g J of %.2g"):format(rules.energy.created, rules.energy.external)
  or ("stopped at %.3f s: ledger off by 5 %%"):format(rules.time)
if not ok then assert(tostring(why):find("ledger", 1, true), why) end

chapter.row("at 0.5 s: middle, lowest node, mm", "near equilibrium at 0.5 s", ("%.1f, %.1f"):format(1e3 * centre, 1e3 * low), makes)
chapter.row("at 0.5 s: kinetic energy over the work of gravity", nil, e.kinetic / e.external)
chapter.row("ledger: error over the work", "unstable with shear hysteresis", e.error, makes)
chapter.row("lost to warp, weft, shear, J", nil, ("%.3f %.3f %.3f"):format(e.dissipated_warp, e.dissipated_weft, e.dissipated_shear))
local frames, labels = {}, {}
for i = 0, 5 do
  frames[i + 1] = ("%s/drape_%05d.vtu"):format(chapter.folder, i)
  labels[i + 1] = ("(%s) %.1f s"):format(("abcdef"):sub(i + 1, i + 1), i / 10)
end
chapter.render("frames", "The middle falls freely, tension runs in from the corners, folds hang between them; no element-wise noise in the stretched diagonals.",
               { vtu = frames, labels = labels, columns = 3, field = "uz", view = { 25, 20 }, width = 1800, height = 1000, title = "blend, 2 x 2 m, pinned at its corners" })
chapter.render("stress", "Warp stress at 0.5 s, from above: the corners carry, along the warp's edges.",
               { run = a, field = "S11", title = "blend, drape, 0.5 s" })
chapter.plot("middle", "Height of the middle: free fall, then bounded by the corners.",
             { title = "blend, drape", xlabel = "time, s", ylabel = "height, mm", curves = { curve, { x = curve.x, y = (function()
               local y = {}
               for i, t in ipairs(curve.x) do y[i] = t <= 0.25 and -1e3 * g * t ^ 2 / 2 or 0 / 0 end
               return y
             end)(), label = "free fall", style = "dashed" } } })
chapter.expect {
  { "middle at 5 ms, free fall", fallen, -g * 0.005 ^ 2 / 2, relative = 1e-9 },
  -- Folds grow from rounding later on; at 0.1 s the mirror images still agree.
  { "mirror images at 0.1 s, over the fall", early / (g * 0.1 ^ 2 / 2), 0, absolute = 1e-6 },
  { "ledger: error over the work", e.error, 0, absolute = 1e-5 }, -- second order in the step, 5e-5 s
  { "its loss of energy never falls below zero (1: yes)", math.min(e.dissipated_warp, e.dissipated_weft, e.dissipated_shear) >= 0 and 1 or 0, 1, relative = 1e-12 },
}
