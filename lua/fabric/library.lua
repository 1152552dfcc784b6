-- What `require "fabric"` adds to the bindings: the part of the library that is written in Lua.
require "fabric.expect"
require "fabric.columns"
require "fabric.lab"
require "fabric.export"
require "fabric.study"
require "fabric.help"
