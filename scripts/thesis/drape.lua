-- Fig. 7-31 of [williams2010]: a sheet of 2 x 2 m, pinned at its corners, falls for 0.5 s. Shear hysteresis on.
--
--   fabricsh scripts/thesis/drape.lua [card] [--rules]
--
--   card      default blend
--   --rules   the thesis' own set-up instead: law="thesis", transverse shear that follows, shear hysteresis on. It makes energy
--             until it stops.
-- Elements of 100 mm are far wider than the folds of this cloth.
--
-- Central differences with dt = 1e-5 s as in the thesis. At first every node but those near the pins falls freely: g t^2 / 2.
local here = arg[0]:gsub("[^/]*$", "")
local chapter = dofile(here .. "chapter.lua")
local ledger = dofile(here .. "ledger.lua")
local fabric = require "fabric"
local name, rules = "blend", false
for _, word in ipairs(arg) do
  if word == "--rules" then rules = true else name = word end
end
chapter.begin("7-31", "drape from four corners, " .. name .. (rules and ", the thesis' rules" or ""), "drape")

local card = chapter.card(name)
if rules then card = card:with { law = "thesis", transverse = "follow", shear_hysteresis = true } end
local test = fabric.lab.drape { card = card, step = 1e-5, every = 10e-3, out = chapter.folder, strict = not rules,
                                ledger_limit = rules and 1e9 or 0.05 }
if fabric.checking() then return end
local last = test.curve[#test.curve]
chapter.row("the middle hangs down at the end, mm", "equilibrium within 0.5 s", last.centre * 1e3)
ledger.row("drape", test.curve, "shear hysteresis off, or unstable")
ledger.plot("ledger", name .. ": drape", test.curve)
if rules then
  chapter.row("energy made, J, of an external work of", nil, ("%.3g of %.3g%s"):format(last.created, last.external,
              test.trouble and "; stopped at " .. ("%.3f s"):format(test.analysis.time) or ""))
  return chapter.expect { { "the thesis' rules make more energy than gravity gives", last.created > last.external and 1 or 0, 1, absolute = 0 } }
end
local frames, labels = {}, {}
for k = 0, 5 do
  local row = chapter.at_time(test.curve, 0.1 * k)
  frames[k + 1], labels[k + 1] = chapter.frame(chapter.folder .. "/drape", test, row), ("%.1f s"):format(row.time)
end
chapter.render("frames", "The sheet falls, is caught by its corners, and swings back; folds run from corner to corner.",
               { vtu = frames, labels = labels, field = "E12", view = { 30, 25 }, columns = 3, edges = false })
local early = chapter.at_time(test.curve, 0.05)
chapter.expect {
  { "free fall at 0.05 s", early.centre, 9.81 * early.time ^ 2 / 2, relative = 1e-3 },  -- the wave from the pins is on its way
  { "the ledger's error", last.error, 0, absolute = 1e-6 },
  { "all the work has gone somewhere", (last.kinetic + last.stored + last.dissipated) / last.external, 1, absolute = 1e-6 },
}
