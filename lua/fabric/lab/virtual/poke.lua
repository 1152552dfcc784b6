-- fabric.lab.poke: the middle of a held sheet is pushed up and lowered [williams2010, section 7.3.3, figs. 7-32 to 7-36].
--
--      +-----------+     rim: x y z held
--      |    +-+    |     punch: the middle fifth, z = height (1 - cos(2 pi t / stroke)) / 2 until t = stroke, then 0;
--      |    +-+    |            its x, y and directors held
--      +-----------+     warp along x; gravity along -z
local define = require "fabric.define"
local motion = require "fabric.lab.virtual.motion"
local lists = require "fabric.lists"

local function punch(t, mesh, model)
  local n, ids = t.cells, {}
  local from, to = (2 * n) // 5, n - (2 * n) // 5
  for j = from, to do
    for i = from, to do ids[#ids + 1] = motion.node(n, i, j) end
  end
  mesh:set("punch", ids)
  model:fix("punch", "x y rotation")
  model:move("punch", { z = function(time)
    return time < t.stroke and t.height * (1 - math.cos(2 * math.pi * time / t.stroke)) / 2 or 0
  end })
end

-- The elements next but one to the punch, beside it along the warp and along the weft: 207 and 271 of the thesis.
local function watched(n)
  local from, to = (2 * n) // 5, n - (2 * n) // 5
  return (n // 2) * n + from - 1, (to + 1) * n + n // 2 + 1
end

local function run(t)
  local mesh, model = motion.square(t)
  model:fix("boundary", "x y z")
  punch(t, mesh, model)
  local a = motion.analysis(t, model)
  local along_warp, along_weft = watched(t.cells)
  local result = motion.run(t, a, { "height", "lowest", "E11", "S11", "E22", "S22" }, "poke", function(r)
    local warp, weft = r:element(along_warp), r:element(along_weft)
    return { height = r:node(motion.node(t.cells, t.cells // 2, t.cells // 2)).uz, lowest = -motion.lowest(r, mesh),
             E11 = warp.E11, S11 = warp.S11, E22 = weft.E22, S22 = weft.S22 }
  end)
  result.model, result.mesh, result.along_warp, result.along_weft = model, mesh, along_warp, along_weft
  return result
end

local arguments = lists.joined({
  { name = "height", kind = "number", unit = "m", default = 0.4, sentence = "that the punch rises to" },
  { name = "stroke", kind = "number", unit = "s", above = 0, default = 0.5, sentence = "up and down" },
}, motion.arguments)

define {
  name = "fabric.lab.poke",
  arguments = arguments,
  retired = motion.retired,
  sentence = "A square sheet, its rim held, is pushed up by a punch in its middle and let down. Returns curve (a list of time, height of the "
    .. "punch, lowest: how far the lowest node hangs down, m; E11 and S11 one element beside the punch along the warp, E22 and S22 along the "
    .. "weft; the energies of analysis.energy), analysis, model, mesh, along_warp and along_weft (the two elements), and trouble where the run "
    .. "stopped.",
  example = "local test = fabric.lab.poke{ card=fabric.card 'blend', cells=10, duration=0.05 }\n"
    .. "assert(math.abs(test.curve[#test.curve].height - 0.4 * (1 - math.cos(0.2 * math.pi)) / 2) < 1e-12)",
  run = run,
}
