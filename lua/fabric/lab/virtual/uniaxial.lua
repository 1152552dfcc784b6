-- fabric.lab.uniaxial: a strip pulled along warp, weft or any direction, to the end of the card's tested range.
local define = require "fabric.define"
local strip = require "fabric.lab.virtual.strip"

local function angle_of(direction)
  if direction == "warp" then return 0 end
  if direction == "weft" then return 90 end
  return direction
end

-- Displacement at the end of the card's tested range in the direction; an error if the card states none.
local function tested_displacement(t)
  local axis = t.angle == 0 and "warp" or t.angle == 90 and "weft"
  local strain = axis and t.card.tested and t.card.tested[axis] or 0
  if strain == 0 then
    define.fail("uniaxial: field 'displacement': expected a positive number in m (the card states no tested strain here), got nil")
  end
  return strip.displacement(t.length, strain)
end

local function run(t)
  t.test, t.angle = "uniaxial", angle_of(t.direction)
  t.displacement = t.displacement or tested_displacement(t)
  return strip.run(t)
end

local arguments = {
  { name = "card", of = "card", sentence = "the fabric" },
  { name = "direction", kind = "number|text", unit = "degrees", choices = { "warp", "weft" }, default = "warp",
    sentence = "of the pull: warp, weft, or its angle from the warp" },
  { name = "displacement", kind = "number", unit = "m", above = 0, optional = true,
    sentence = "largest displacement; default: up to where the card was tested" },
}
table.move(strip.arguments, 1, #strip.arguments, #arguments + 1, arguments)

define {
  name = "fabric.lab.uniaxial",
  arguments = arguments,
  retired = { "most_steps", "release" },
  sentence = "A strip pulled and let go. " .. strip.returns,
  example = "local test = fabric.lab.uniaxial{ card=fabric.card 'denim', grips='free', steps=8 }\n"
    .. "assert(test.analysis.stopped == 'the grip lets go')",
  run = run,
}
