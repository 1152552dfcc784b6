-- The long form of scripts/contact/schemes.lua: every scheme with quadrilaterals and triangles, at three steps.
--
--   fabricsh scripts/long/contact/schemes.lua
arg = { [0] = arg[0], "all" }
dofile((arg[0]:gsub("[^/]*$", "") .. "../../contact/schemes.lua"))
