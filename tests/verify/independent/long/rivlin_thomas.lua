-- A long cut in a wide strip that is held by its long edges: the energy per area far before the tip, times the height, at which the cut runs on, is G
-- [rivlin1953] on elements that are small beside l = E' G / f^2, and on coarser ones with the strength lowered to sqrt(E' G / (4 h)). With its full strength
-- a coarse mesh takes more. Long: four minutes. In balance, along the path of equilibria: the cut runs at one load, place after place.
local fabric = require "fabric"
local common = dofile((arg[0]:gsub("long/[^/]*$", "common.lua")))
local checks = common.checks()
local mm = fabric.units.mm

local height, length, cut = 40 * mm, 120 * mm, 48 * mm
local stiff, energy, h = 5e4, 2.5, 2 * mm -- N/m; J/m
local cloth = fabric.svk { young = stiff / (0.5 * mm), poisson = 0, density = 500, thickness = 0.5 * mm } -- E' is the stiffness in tension

-- The largest energy and the mean of the last eight places, over G, on elements of `ratio` times l.
local function runs(ratio, coarse)
  local card = cloth:with { rupture = { weft = { strength = math.sqrt(stiff * energy * ratio / h), energy = energy } } }
  local mesh = fabric.mesh.rectangle { width = length, height = height, nx = length / h + 0.5 // 1, ny = height / h + 0.5 // 1 }
  mesh:set("middle", function(_, y) return math.abs(y - height / 2) < 1.01 * h end)
  mesh:set("line", function(_, y) return math.abs(y - height / 2) < 0.01 * h end)
  local m = fabric.model { mesh = mesh, card = card }
  m:tearable("middle", { coarse = coarse, path = "line" })
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x")
  local most = 2.2 * height * (math.sqrt(1 + 2 * math.sqrt(2 * energy / (stiff * height))) - 1)
  m:move("top", { y = fabric.ramp(most, 1) })
  local a = fabric.static { model = m, duration = 1, step = 0.05, control = "arc", max_cuts = 20, max_iterations = 25 }
  a:cut { line = { { 0, height / 2, 0 }, { cut, height / 2, 0 } } }
  local began, shares = a.joints.open, {}
  a:every("step", function(run)
    local stretch = 1 + most * run.time / height
    shares[#shares + 1] = stiff * ((stretch ^ 2 - 1) / 2) ^ 2 / 2 * height / energy
    if run.joints.open - began >= 18 then run:stop "it runs" end
  end)
  a:solve()
  local peak, mean = 0, 0
  for _, share in ipairs(shares) do peak = math.max(peak, share) end
  for i = #shares - 7, #shares do mean = mean + shares[i] / 8 end
  return peak, mean, a.energy.error
end

for _, case in ipairs { { 0.23, "keep", 0.05 }, { 0.47, "keep", 0.12 }, { 0.93, "keep" }, { 1.16, "keep" }, { 0.47, "lower", 0.05 }, { 0.93, "lower", 0.05 }, { 1.16, "lower", 0.05 } } do
  local ratio, coarse, near = table.unpack(case)
  local peak, mean, lost = runs(ratio, coarse)
  print(("element of %.2f l, %s: the cut runs at %.3f G at most, %.3f G in the mean of eight places; ledger %.1g"):format(ratio, coarse, peak, mean, lost))
  if near then
    checks(("element of %.2f l, %s: largest energy at which it runs, over G"):format(ratio, coarse), peak, 1, { absolute = near })
  else
    checks(("element of %.2f l, %s: larger by more than a third"):format(ratio, coarse), peak > 4 / 3 and 1 or 0, 1, { absolute = 0 })
  end
end
checks()
