-- Chapter 7 of [williams2010] in one go: every figure and table, the table of all rows, and a report as one HTML file.
--
--   fabricsh scripts/thesis/all.lua [--long] [deck ...]
--
--   --long   the parts that take minutes too
--   deck     only these, such as fig_7_20_bias_blend; default: all, in the order of the chapter
--
-- Writes out/thesis/report.html. Each deck checks closed forms and derived facts; a miss is printed, stands in the report, and
-- makes this command fail in the end.
local here = arg[0]:gsub("[^/]*$", "")
local fabric = require "fabric"
local chapter = dofile(here .. "chapter.lua")
local report = dofile(here .. "report.lua")

local decks = {
  "fig_4_11_svk", "fig_7_09_buckling", "fig_7_10_cyclic_blend", "fig_7_11_cyclic_denim", "fig_7_12_cyclic_duck", "fig_7_13_cyclic_muslin",
  "table_7_4_ratios", "fig_7_14_lateral_blend", "fig_7_15_lateral_denim", "fig_7_16_lateral_duck", "fig_7_17_lateral_muslin", "fig_7_18_reload",
  "fig_7_19_bias_snapshots", "fig_7_20_bias_blend", "fig_7_21_bias_denim", "fig_7_22_bias_duck", "fig_7_23_bias_muslin",
  "fig_7_24_off_axis_blend", "fig_7_25_off_axis_denim", "fig_7_26_fields", "fig_7_27_shear_cycle", "fig_7_28_shear_reload",
  "fig_7_29_biaxial_blend", "fig_7_30_biaxial_denim", "drape", "poke", "fig_7_37_svk_cyclic", "table_7_5_kilby",
}
local long = { "../long/thesis/bias_clamped", "../long/thesis/drape", "../long/thesis/poke" }

local function readable(path)
  local file = io.open(path)
  if file then file:close() end
  return file ~= nil
end

local chosen = {}
for _, word in ipairs(arg) do
  if word == "--long" then
    table.move(long, 1, #long, #decks + 1, decks)
  else
    if not readable(here .. word .. ".lua") then
      error(("all: no deck '%s'; there are: %s"):format(word, table.concat(decks, " ")), 0)
    end
    chosen[#chosen + 1] = word
  end
end
if #chosen == 0 then chosen = decks end

-- A deck reads its arguments and place from `arg`.
local function run(name)
  local own, start = arg, os.time()
  arg = { [0] = here .. name .. ".lua", [-1] = own[-1] }
  chapter.figure, chapter.title = name, "did not begin"
  local ok, trouble = xpcall(dofile, function(e) return tostring(e) end, arg[0])
  arg = own
  return { figure = chapter.figure, title = chapter.title, deck = name, seconds = os.difftime(os.time(), start), trouble = not ok and trouble or nil }
end

local runs, failed = {}, {}
for i, name in ipairs(chosen) do
  runs[i] = run(name)
  if runs[i].trouble then
    print("FAILED " .. name .. ": " .. runs[i].trouble)
    failed[#failed + 1] = name
  end
end
if fabric.checking() then return end

print(("\n%-10s %-74s %-28s %-52s %s"):format("figure", "quantity", "thesis (quoted)", "ours", "its rules"))
for _, row in ipairs(chapter.rows) do
  print(("%-10s %-74s %-28s %-52s %s"):format(row.figure, row.quantity, row.thesis, row.ours, row.rules))
end
report.write(chapter.out .. "/report.html", chapter, runs)
print(("\nreport  %s/report.html\nThe thesis' measured curves are not public: its numbers are quoted, closed forms are checked."):format(chapter.out))
fabric.expect { { "decks that failed: " .. (#failed > 0 and table.concat(failed, " ") or "none"), #failed, 0, absolute = 0 } }
