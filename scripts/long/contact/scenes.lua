-- The long form of scripts/contact/scenes.lua: 500 scenes of implicit motion, or as many as asked for.
--
--   fabricsh scripts/long/contact/scenes.lua [first [scenes [seconds of processor time for each]]]
arg[1], arg[2] = arg[1] or "1", arg[2] or "500"
arg[0] = arg[0]:gsub("[^/]*$", "../../contact/scenes.lua")
dofile(arg[0])
