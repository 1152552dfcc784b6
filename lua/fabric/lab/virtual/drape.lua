-- fabric.lab.drape: a sheet held at its corners falls [williams2010, section 7.3.2, fig. 7-31].
--
--      o-----------o     o: x y z held, directors free
--      |           |     level at time 0, then gravity along -z
--      |  1 warp   |
--      o-----------o
local define = require "fabric.define"
local motion = require "fabric.lab.virtual.motion"

local function run(t)
  local mesh, model = motion.square(t)
  model:fix("corners", "x y z")
  local a = motion.analysis(t, model)
  local middle = motion.node(t.cells, t.cells // 2, t.cells // 2)
  local result = motion.run(t, a, { "centre", "lowest" }, "drape", function(r)
    return { centre = -r:node(middle).uz, lowest = -motion.lowest(r, mesh) }
  end)
  result.model, result.mesh = model, mesh
  return result
end

define {
  name = "fabric.lab.drape",
  arguments = motion.arguments,
  retired = motion.retired,
  sentence = "A square sheet, held at its corners, falls under its weight. Returns curve (a list of time, centre and lowest: how far the "
    .. "middle and the lowest node hang down, m; the energies of analysis.energy), analysis, model, mesh, and trouble where the run stopped.",
  example = "local test = fabric.lab.drape{ card=fabric.card 'blend', cells=4, duration=0.02 }\n"
    .. "assert(math.abs(test.curve[#test.curve].centre / (9.81 * 0.02^2 / 2) - 1) < 0.01)  -- still a free fall",
  run = run,
}
