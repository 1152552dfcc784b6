-- fabric.lab.tension_field: a card whose cloth folds without a force.
--
-- Cloth that is shortened folds at a force that is next to nothing. Elements larger than its folds cannot; they are compressed instead, and
-- carry what the cloth would not. In a tension field [steigmann1990] such a sheet gives way without a force: what an element then is shorter
-- stands for the folds in it (share/doc/folds.md).
local define = require "fabric.define"

define {
  name = "fabric.lab.tension_field",
  arguments = {
    { name = "card", of = "card", sentence = "a card of the woven law, or an elastic one" },
  },
  retired = { "slack" },
  sentence = "A card whose cloth folds without any force where it is shortened, in whatever direction: `folds=\"free\"`. In tension nothing changes.",
  example = "local card = fabric.lab.tension_field{ card=fabric.card 'blend' }\n"
    .. "local before, after = fabric.point(fabric.card 'blend'), fabric.point(card)\n"
    .. "assert(math.abs(after:uniaxial('warp', 0.1).S / before:uniaxial('warp', 0.1).S - 1) < 1e-6)\n"
    .. "assert(fabric.point(card):uniaxial('warp', -0.05).S > -1e3)",
  run = function(t) return t.card:with { folds = "free" } end,
}
