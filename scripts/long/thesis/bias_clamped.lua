-- The clamped bias test of the four fabrics on finer meshes than the figures use: does the limit that Richardson takes from 3 x 9,
-- 6 x 18 and 12 x 36 elements hold?
--
--   fabricsh scripts/long/thesis/bias_clamped.lua
-- warns: the card was tested to
local here = arg[0]:gsub("[^/]*$", ""):gsub("long/thesis/$", "thesis/")
local chapter = dofile(here .. "chapter.lua")
local fabric = require "fabric"
local MPa = fabric.units.MPa
chapter.begin("7-20 fine", "clamped bias test on finer meshes", "bias_clamped")

local checks = {}
for _, name in ipairs { "blend", "denim", "duck", "muslin" } do
  local function S(n)
    return fabric.lab.bias({ card = chapter.card(name), grips = "clamped", unload = false, steps = 20, cells = { 3 * n, 9 * n } }).peak.S
  end
  local values = {}
  for i, n in ipairs { 1, 2, 4, 8 } do values[i] = S(n) end
  local function limit(first)
    local k = 0
    return fabric.lab.mesh_error({ print = false, run = function() k = k + 1 return { S = values[first + k - 1] } end }).S
  end
  local coarse, fine = limit(1), limit(2)
  local words = {}
  for i, v in ipairs(values) do words[i] = ("%.4f"):format(v / MPa) end
  chapter.row(name .. ", clamped, 20 mm: S on 3x9 to 24x72, MPa", nil, table.concat(words, " "))
  chapter.row(name .. ": limit from the three coarse, from the three fine meshes", nil, ("%.4f, %.4f"):format(coarse.limit / MPa, fine.limit / MPa))
  -- Yarns oblique to quadrilaterals do not lock on the coarsest, which is therefore not always the stiffest.
  checks[#checks + 1] = { name .. ": falls with every refinement from 6x18 on (1: yes)", (values[2] > values[3] and values[3] > values[4]) and 1 or 0, 1, relative = 1e-12 }
  for i = 1, 3 do
    checks[#checks + 1] = { ("%s: %dx%d over the fine limit"):format(name, 3 * 2 ^ (i - 1), 9 * 2 ^ (i - 1)), values[i] / fine.limit, 1, absolute = 0.04 }
  end
  -- Corners of the clamps are singular: the order is near one and wanders; the coarse limit is good to 1 %.
  checks[#checks + 1] = { name .. ": the coarse limit over the fine one", coarse.limit / fine.limit, 1, absolute = 0.02 }
end
chapter.expect(checks)
