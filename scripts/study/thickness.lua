-- A parameter study: how force and waste of a cyclic pull depend on the cloth's thickness and on its Poisson ratio.
--
--   fabricsh scripts/study/thickness.lua [folder]     here, cases side by side; stopped and started again it goes on
--   sbatch scripts/study/thickness.sbatch             on a cluster, as tasks of an array job
local fabric = require "fabric"
local mm = fabric.units.mm

local study = fabric.study {
  parameters = { thickness = { 0.19 * mm, 0.38 * mm, 0.76 * mm }, poisson = { 0.10, 0.25 } },
  folder = arg[1] or "out/study/thickness",
  run = function(p)
    local card = fabric.card "blend":with { thickness = p.thickness, warp = { poisson = p.poisson } }
    local test = fabric.lab.uniaxial { card = card, grips = "free", steps = 40 }
    local peak = 0
    for _, row in ipairs(test.curve) do peak = math.max(peak, row.force) end
    return { peak = peak, dissipated = test.analysis.energy.dissipated }
  end,
}
if not study.complete then
  print(("%d of %d cases are still missing"):format(study.missing, #study))
  return
end

print(("%12s %10s %12s %14s"):format("thickness mm", "poisson", "peak N", "dissipated J"))
for _, case in ipairs(study) do
  print(("%12.4g %10.4g %12.6g %14.6g"):format(case.parameters.thickness / mm, case.parameters.poisson, case.values.peak, case.values.dissipated))
end

-- With free ends the stress is P(E) whatever the ratio: force and energy go with the thickness alone.
local function of(i, name) return study[i].values[name] end
fabric.expect {
  { "cases", #study, 6, absolute = 0 },
  { "peak force, twice the thickness", of(2, "peak") / of(1, "peak"), 2, relative = 1e-9 },  -- Newton's tolerance
  { "peak force, four times the thickness", of(3, "peak") / of(1, "peak"), 4, relative = 1e-9 },
  { "energy, twice the thickness", of(2, "dissipated") / of(1, "dissipated"), 2, relative = 1e-9 },
  { "peak force, another ratio", of(4, "peak") / of(1, "peak"), 1, relative = 1e-9 },
}
