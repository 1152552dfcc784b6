-- Drape from four corners [williams2010, fig. 7-31] over steps, meshes and fabrics; shear hysteresis on. Minutes.
--
--   fabricsh scripts/long/thesis/drape.lua
local here = arg[0]:gsub("[^/]*$", "") .. "../../thesis/"
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
chapter.begin("7-31", "drape: steps, meshes, fabrics", "drape_long")

local expected = {}
local function hang(what, fields, limit)
  local test = fabric.lab.drape(fields)
  local last = test.curve[#test.curve]
  chapter.row(what .. ": middle and lowest node at 0.5 s, mm; ledger's error", nil,
              ("%.1f %.1f; %.1e"):format(last.centre * 1e3, last.lowest * 1e3, last.error))
  expected[#expected + 1] = { what .. ": ledger", last.error, 0, absolute = limit or 1e-4 }
  return last.centre
end
local blend = chapter.card "blend"
local finest = hang("dt = 2e-6 s", { card = blend, step = 2e-6 })
for _, dt in ipairs { 1e-5, 2e-5, 5e-5 } do
  local centre = hang(("dt = %g s"):format(dt), { card = blend, step = dt }, dt == 1e-5 and 1e-6 or nil)
  expected[#expected + 1] = { ("middle at dt = %g s against 2e-6 s, m"):format(dt), centre, finest, absolute = 2e-3 }
end
for _, cells in ipairs { 10, 40, 80 } do hang(("%d x %d elements"):format(cells, cells), { card = blend, cells = cells }) end
for _, name in ipairs { "duck", "muslin", "denim" } do hang(name, { card = chapter.card(name), step = 1e-5 }, 1e-6) end
chapter.expect(expected)
