-- The part of `require "fabric"` that is written in Lua, in addition to the bindings.
require "fabric.expect"
require "fabric.columns"
require "fabric.lab"
require "fabric.export"
require "fabric.inputs"
require "fabric.study"
require "fabric.budget"
require "fabric.help"
