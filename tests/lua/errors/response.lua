-- Wrong calls and their messages: fabric.lab.frequency_response. Read by tests/lua/errors.lua.
local function response(fields, without)
  local all = { "model=held:copy{ without='fix' }:fix('left', 'x y z rotation')", "base={ z=1e-3 }", "damping=0.1", "node=8", "lowest=1", "highest=20" }
  local kept = {}
  for _, field in ipairs(all) do
    local name = field:match "^%w+"
    if name ~= without and not (", " .. fields):find("[, ]" .. name .. "=") then kept[#kept + 1] = field end
  end
  return "fabric.lab.frequency_response{ " .. table.concat(kept, ", ") .. (fields == "" and "" or ", " .. fields) .. " }"
end
local function refused(fields, message, without)
  wrong("fabric.lab.frequency_response", response(fields, without), "deck.lua:1: frequency_response: " .. message)
end
local missing = ", got nil (missing, or a misspelt variable)"
refused("from=held", "field 'from': expected an analysis, got a model")
refused("from=run", "field 'from': expected an analysis, or in its place model=, got both")
refused("", "field 'from': expected an analysis, or in its place model=, got neither", "model")
refused("model=mesh", "field 'model': expected a model, got a mesh")
refused("base=0.1", "field 'base': expected a table {x, y, z}, got 0.1")
refused("base={}", "field 'base': expected x=, y= or z= in m other than zero, got none")
refused("base={ z='1' }", "field 'base.z': expected a number in m, got '1'")
refused("base={ Z=1 }", "unknown field 'base.Z', did you mean 'base.z'?")
refused("force={ set='right', z=1 }", "field 'base': expected { x=, y=, z= } in m, or in its place force=, got both")
refused("", "field 'base': expected { x=, y=, z= } in m, or in its place force=, got neither", "base")
refused("force=1", "field 'force': expected a table {set, x, y, z}, got 1", "base")
refused("force={ z=1 }", "field 'force.set': expected an integer of at least 1 or a string" .. missing, "base")
refused("force={ set=99, z=1 }", "field 'force.set': expected a node from 1 to 8, got 99", "base")
wrong("fabric.lab.frequency_response", response("force={ set='rigth', z=1 }", "base"),
  "deck.lua:1: set: unknown set 'rigth', did you mean 'right'? known sets: all, bottom, boundary, corners, left, right, top")
refused("force={ set='right' }", "field 'force': expected x=, y= or z= in N other than zero, got none", "base")
refused("damping='0.1'", "field 'damping': expected a number above 0 to 0.999, got '0.1'")
refused("damping=1", "field 'damping': expected a number above 0 to 0.999, got 1")
refused("", "field 'damping': expected a number above 0 to 0.999" .. missing, "damping")
refused("node='8'", "field 'node': expected an integer of at least 1, got '8'")
refused("node=0", "field 'node': expected an integer of at least 1, got 0")
refused("node=9", "field 'node': expected a node from 1 to 8, got 9")
refused("", "field 'node': expected an integer of at least 1" .. missing, "node")
refused("along=3", "field 'along': expected 'x' or 'y' or 'z', got 3")
refused("along='w'", "field 'along': expected 'x' or 'y' or 'z', got 'w'")
refused("lowest='1'", "field 'lowest': expected a positive number in Hz, got '1'")
refused("lowest=0", "field 'lowest': expected a positive number in Hz, got 0")
refused("", "field 'lowest': expected a positive number in Hz" .. missing, "lowest")
refused("highest='1'", "field 'highest': expected a positive number in Hz, got '1'")
refused("highest=0", "field 'highest': expected a positive number in Hz, got 0")
refused("highest=0.5", "field 'highest': expected more than lowest=1 Hz, got 0.5")
refused("", "field 'highest': expected a positive number in Hz" .. missing, "highest")
refused("points='3'", "field 'points': expected an integer of at least 2, got '3'")
refused("points=1", "field 'points': expected an integer of at least 2, got 1")
refused("count='3'", "field 'count': expected an integer from 1 to 400, got '3'")
refused("count=0", "field 'count': expected an integer from 1 to 400, got 0")
refused("modes=3", "unknown field 'modes', did you mean 'model'?")
