-- fabric.lab.bias: a strip cut at an angle to the yarns, pulled 20 mm, unloaded [williams2010, sections 3.3.4 and 7.2.2].
--
-- With free ends the strain of the whole strip is uniform. Clamped ends cause three zones (fig. 3-52): hardly any shear next
-- to the grips, where both yarns end in the same grip; the most in the middle, where no yarn ends in a grip.
local fabric = require "fabric"
local define = require "fabric.define"
local strip = require "fabric.lab.virtual.strip"
local lists = require "fabric.lists"

local function run(t)
  t.test = "bias"
  if t.angle <= 0 or t.angle >= 90 then
    define.fail(("bias: field 'angle': expected degrees between 0 and 90 (fabric.lab.uniaxial pulls along yarns), got %g"):format(t.angle))
  end
  local result = strip.run(t)
  result.zone_mean = function(_, name)
    local values, out = result.analysis:field(name), {}
    for zone, elements in ipairs(result.zones) do
      local sum = lists.sum(elements, function(i) return values[i] end)
      out[zone] = #elements > 0 and sum / #elements or 0 / 0
    end
    return table.unpack(out)
  end
  return result
end

local arguments = lists.joined({
  { name = "card", of = "card", sentence = "the fabric" },
  { name = "angle", kind = "number", unit = "degrees", low = 0, high = 90, default = 45, sentence = "of the pull from the warp" },
  { name = "displacement", kind = "number", unit = "m", above = 0, default = 20 * fabric.units.mm, sentence = "largest displacement" },
}, lists.map(strip.arguments, function(row) return row.name == "grips" and lists.copy(row, { default = "free" }) or row end))

define {
  name = "fabric.lab.bias",
  arguments = arguments,
  retired = { "most_steps", "release" },
  sentence = "A strip pulled off the yarns' axes and let go. " .. strip.returns
    .. " And zone_mean(name): the means of a field in zones 1, 2, 3 at the present time.",
  example = "local test = fabric.lab.bias{ card=fabric.card 'blend', grips='clamped', unload=false, steps=8 }\n"
    .. "local near, between, middle = test:zone_mean 'E12'\nassert(near < between and between < middle)",
  run = run,
}
