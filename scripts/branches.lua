-- One experiment, several ways to go on: a strip is pulled along its warp, and from there let back a little, let back until it is
-- slack, or not at all, and pulled on. Each branch starts from one snapshot.
--
--   fabricsh scripts/branches.lua [picture.svg]
--
-- Yarns remember the farthest they were stretched and nothing else: the branches come together again on the backbone, having
-- lost the same energy.
local fabric = require "fabric"
local mm, inch, MPa = fabric.units.mm, fabric.units.inch, fabric.units.MPa
local picture = arg[1]

local blend = fabric.card "blend"
local warp = blend.warp
local first, last = 12 * mm, 14 * mm -- strokes of the first pull and of the end
local branches = {
  { name = "straight on", back = 0 },
  { name = "back a little", back = 0.6 * mm },
  { name = "back until slack", back = 2 * mm },
}

-- Time 0 to 1: the first pull. 1 to 2: back. 2 to 3: on to the end. `now` is the branch that is being run.
local now = branches[1]
local function stroke(t)
  if t <= 1 then return first * t end
  if t <= 2 then return first - now.back * (t - 1) end
  return first - now.back + (last - first + now.back) * (t - 2)
end

local mesh = fabric.mesh.rectangle { width = 1 * inch, height = 3 * inch, nx = 1, ny = 3 }
local model = fabric.model { mesh = mesh, card = blend, warp = 90 }
model:fix("all", "z rotation"):fix("bottom", "y"):fix("left", "x"):move("top", { y = stroke })
local run = fabric.static { model = model, duration = 3, step = 0.05 }

run:advance(1)
local start = run:snapshot()
for _, branch in ipairs(branches) do
  now = branch
  run:restore(start)
  branch.rows = {}
  for i = 0, 40 do
    run:advance(1 + i / 20)
    branch.rows[i + 1] = { time = run.time, stroke = stroke(run.time), E = run:mean "E11", S = run:mean "S11",
      dissipated = run.energy.dissipated }
  end
end

local head = "  time s"
for _, branch in ipairs(branches) do head = head .. ("%20s"):format(branch.name) end
print(head .. "      (S11, MPa)")
for i = 1, 41, 4 do
  local line = ("%8.1f"):format(branches[1].rows[i].time)
  for _, branch in ipairs(branches) do line = line .. ("%20.3f"):format(branch.rows[i].S / MPa) end
  print(line)
end

if picture then
  local curves = {}
  for i, branch in ipairs(branches) do curves[i] = { rows = branch.rows, x = "time", y = "S", label = branch.name } end
  fabric.plot { file = picture, xlabel = "time", xunit = "s", ylabel = "S11", yunit = "MPa", curves = curves }
end

-- Closed forms: backbone P, unloading along Du from the farthest strain m, energy lost U(m) - P(m)^2/(2 Du) per volume.
local function P(E) return warp.loading[1] * E + warp.loading[2] * E ^ 2 / 2 end
local function U(E) return warp.loading[1] * E ^ 2 / 2 + warp.loading[2] * E ^ 3 / 6 end
local function strain(u) return u / (3 * inch) + (u / (3 * inch)) ^ 2 / 2 end
local volume = 1 * inch * 3 * inch * blend.thickness
local m, top = strain(first), strain(last)
local lost = volume * (U(top) - P(top) ^ 2 / (2 * warp.unloading))
local checks = {
  { "back a little: S11", branches[2].rows[21].S, P(m) - warp.unloading * (m - strain(first - 0.6 * mm)), relative = 1e-8 },
  { "slack: S11 is no pull", math.max(0, branches[3].rows[21].S), 0, absolute = 1e-6 * MPa },
}
for _, branch in ipairs(branches) do
  checks[#checks + 1] = { branch.name .. ": S11 at its start", branch.rows[1].S, P(m), relative = 1e-8 } -- Newton: 1e-10 of the force
  checks[#checks + 1] = { branch.name .. ": S11 at its end", branch.rows[41].S, P(top), relative = 1e-8 }
  checks[#checks + 1] = { branch.name .. ": dissipated, J", branch.rows[41].dissipated, lost, relative = 1e-8 }
  checks[#checks + 1] = { branch.name .. ": start, bit for bit", branch.rows[1].S - branches[1].rows[1].S, 0, absolute = 0 }
end
fabric.expect(checks)
