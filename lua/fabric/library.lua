-- The part of `require "fabric"` that is written in Lua, in addition to the bindings: modules, and what they define.
local later = require "fabric.define".later
later("fabric.expect", "expect")
later("fabric.columns", "columns", "show")
later("fabric.rigid.limb", "rigid.limb")
later("fabric.rigid.torso", "rigid.torso")
later("fabric.rigid.tools", "rigid.punch", "rigid.dome", "rigid.die")
require "fabric.lab"
require "fabric.export"
later("fabric.inputs", "sobol", "latin_hypercube")
later("fabric.study", "study")
later("fabric.budget", "budget")
later("fabric.help", "help")
