-- A virtual test whose run was taken up from a checkpoint: with a state that it keeps, the results are those of a run that was never cut, to the bit; without one the
-- rows before it are gone, which is told, and means and peaks, which were nil, 0 or those of the rest, are nil.
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))

check.write("torn.lua", [[
local fabric = require "fabric"
local mm = fabric.units.mm
local card = fabric.svk { warp = 1e8, weft = 6e7, shear = 3e7, poisson = { 0, 0 }, density = 500, thickness = 0.5 * mm, through_thickness = true }
card = card:with { rupture = { warp = { strength = 4e3, energy = 3 }, weft = { strength = 15e3, energy = 20 } } }
local state = arg[1] ~= "none" and {} or nil
local function prepare(a)
  a:checkpoint("work/run.ckpt", { every = "step", keep = state })
  local steps = 0
  a:every("step", function() steps = steps + 1 if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end end)
end
local test
if arg[2] == "tear" then
  test = fabric.lab.tear { card = card, h = 4 * mm, width = 24 * mm, leg = 12 * mm, tear = 16 * mm, speed = 4, prepare = prepare, state = state }
else
  test = fabric.lab.strip_rupture { card = card, width = 12 * mm, length = 12 * mm, h = 6 * mm, rows = 40, prepare = prepare, state = state }
end
local function text(x) return x and ("%.17g"):format(x) or "nil" end
print(#test.curve, text(test.mean), text(test.mean_of_peaks), text(test.peak), text(test.expected), text(test.strength), text(test.fracture))
for _, w in ipairs(test.analysis.warnings) do print(w.code, w.text) end
]])
local function run(words, kill_at)
  local code, text = check.program(words, kill_at)
  return code, (text:gsub("restart: from [^\n]*\n", ""))
end
for _, kind in ipairs(os.getenv "FABRICSH_TEST_LONG" and { "tear", "strip" } or { "strip" }) do
  os.execute "rm -rf work"
  local code, wanted = run("torn.lua keep " .. kind)
  assert(code == 0, wanted)
  local finished
  code, finished = run("--restart work/run.ckpt torn.lua keep " .. kind)
  assert(code == 0 and finished == wanted, finished .. "\nwanted\n" .. wanted)
  os.execute "rm -rf work"
  assert(run("torn.lua keep " .. kind, 300) == 9)
  code, finished = run("--restart work/run.ckpt torn.lua keep " .. kind)
  assert(code == 0 and finished == wanted, finished .. "\nwanted\n" .. wanted)
  os.execute "rm -rf work"
  assert(run("torn.lua none " .. kind, 300) == 9)
  code, finished = run("--restart work/run.ckpt torn.lua none " .. kind)
  assert(code == 0 and finished:find("\tnil\tnil\tnil\tnil\tnil\t", 1, true) and finished:find("the curve lacks the rows before", 1, true), finished)
end
