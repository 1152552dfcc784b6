-- The long form of scripts/contact/random.lua: 10,000 scenes, or as many as asked for.
--
--   fabricsh scripts/long/contact/random.lua [scenes [first seed]]
arg = { [0] = arg[0], arg[1] or "10000", arg[2] }
arg[0] = arg[0]:gsub("[^/]*$", "../../contact/random.lua")
dofile(arg[0])
