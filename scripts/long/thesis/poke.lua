-- Poke [williams2010, figs. 7-33 to 7-36] of all four fabrics; shear hysteresis on. Minutes.
--
--   fabricsh scripts/long/thesis/poke.lua
-- warns: nine measured cloths in ten have 1 to 70 uN.m
-- warns: the card was tested to
-- warns: carries without folding within it
local here = arg[0]:gsub("[^/]*$", "") .. "../../thesis/"
local chapter = dofile(here .. "chapter.lua")
local ledger = dofile(here .. "ledger.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
chapter.begin("7-33..36", "poke: four fabrics", "poke_long")

local expected = {}
for _, name in ipairs { "blend", "duck", "muslin", "denim" } do
  local card = chapter.card(name)
  for label, with in pairs { fabric = card, SVK = chapter.svk(card) } do
    local test = fabric.lab.poke { card = with, duration = 1, step = 1e-5 }
    local last = test.curve[#test.curve]
    local half = chapter.at_time(test.curve, 0.5)
    chapter.row(("%s, %s: peaks of S11 (207) and S22 (271), MPa; lowest at 0.5 and 1 s, mm; ledger"):format(name, label), nil,
                ("%.3g %.3g; %.0f %.0f; %.1e"):format(ledger.largest(test.curve, "S11") / MPa, ledger.largest(test.curve, "S22") / MPa,
                half.lowest * 1e3, last.lowest * 1e3, last.error))
    expected[#expected + 1] = { name .. ", " .. label .. ": ledger", last.error, 0, absolute = 1e-4 }
  end
end
chapter.expect(expected)
