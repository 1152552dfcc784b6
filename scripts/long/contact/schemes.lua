-- The long form of scripts/contact/schemes.lua: every scheme with quadrilaterals and triangles, at three steps.
-- warns: is at full value at time 0
--
--   fabricsh scripts/long/contact/schemes.lua
arg = { [0] = arg[0], "all" }
dofile((arg[0]:gsub("[^/]*$", "") .. "../../contact/schemes.lua"))
