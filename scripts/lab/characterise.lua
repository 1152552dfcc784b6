-- From a folder of raw files to a card and a report.
--
--   fabricsh scripts/lab/characterise.lua [folder] [out]
--
-- The folder (default: the synthetic sample data) holds laboratory.lua and whatever there is of the files that lua/fabric/lab/folder.lua
-- describes; what no file shows is assumed, marked so, and named with the test that would tell. Writes into out (default
-- out/characterise): card.lua, a figure, its -residual.svg and, from three specimens on, its -left-out.svg for each of warp, weft, shear
-- that was tested, report.html, and the card for LS-DYNA, OpenRadioss and Abaqus, card.k, card.rad and card.inp, in mm, t, s, each with
-- what is lost in it.
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
-- warns: is unlike the others
local fabric = require "fabric"
local folder, report = require "fabric.lab.folder", require "fabric.lab.report"

local place = arg[0]:match "^(.*)scripts/" or ""
local from = arg[1] or place .. "share/data/synthetic-blend"
local out = arg[2] or "out/characterise"
if fabric.checking() then return end

local usage = "usage: fabricsh scripts/lab/characterise.lua FOLDER [OUT]"
if not arg[1] then print(("no folder given: this is the sample data in %s; yours: %s"):format(from, usage)) end
if not pcall(fabric.folder, from) then
  io.stderr:write(("%s\nthere is no folder '%s': expected one with laboratory.lua and records of tests, warp-1.csv, weft-1.csv, bias-1.csv (share/doc/howto/own-csv.md)\n"):format(usage, from))
  os.exit(2)
end

local result = folder.reduce(from)
local figures, rows = report.write(result, out)
for _, text in ipairs(report.contradictions(figures)) do print(text) end
for _, text in ipairs(result.seen) do print(text) end
for _, row in ipairs(rows) do print(("%-18s %12s  %-24s %-5s %s"):format(table.unpack(row))) end
local expected = {}
for _, name in ipairs { "warp", "weft", "shear" } do
  if figures[name] then
    print(("%s: residual of the simulated curve %.2f %% of the peak%s"):format(name, 100 * figures[name].residual,
      figures[name].whole and (", %.2f %% over the whole loop of the specimen pulled furthest"):format(100 * figures[name].whole) or ""))
    if result[name].spread then print(name .. ": " .. result[name].spread.text) end
    -- a card that misses its own measurement by a tenth is none
    expected[#expected + 1] = { name .. ": residual over the peak", figures[name].residual, 0, absolute = 0.1 }
  end
end
if result.shear and result.shear.viscous then print(result.shear.viscous.text) end
for _, further in ipairs(result.further) do print(("to settle %s: %s; %s"):format(further.field, further.test, further.now)) end
for _, target in ipairs { { "ls-dyna", "k" }, { "openradioss", "rad" }, { "abaqus", "inp" } } do
  local file = out .. "/card." .. target[2]
  local e = fabric.export.card { card = result.card, to = target[1], units = "mm-t-s", file = file }
  local most = e.losses[1]
  for _, row in ipairs(e.losses) do most = row.worst > most.worst and row or most end
  print(("%s: %s of %s, along the yarns within %.1f %%; most is lost in %s, up to %.0f %% of the peak"):format(file, e.material, target[1],
    math.max(e.lost.warp.worst, e.lost.weft.worst), most.path, most.worst))
end
print("written: " .. out .. "/report.html, " .. out .. "/card.lua")
print(("next: open %s/report.html; in a deck: local card = fabric.card '%s/card.lua'"):format(out, out))
fabric.expect(expected)
