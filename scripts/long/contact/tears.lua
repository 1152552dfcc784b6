-- Random scenes with pieces that tear (scripts/contact/random.lua): 200, or as many as asked for.
--
--   fabricsh scripts/long/contact/tears.lua [scenes [first seed]]
-- warns: is far from what cloth is
-- warns: where a support holds it
arg = { [0] = arg[0], arg[1] or "200", arg[2] or "1", "tears" }
arg[0] = arg[0]:gsub("[^/]*$", "../../contact/random.lua")
dofile(arg[0])
