-- The long form of scripts/contact/disc.lua: three meshes, whose error at a depth of 2 mm falls with the square of the element's size to what
-- small slopes leave out.
-- warns: real cloth has 5 to 20 uN.m
arg = { [0] = arg[0], "8", "16", "24" }
dofile((arg[0]:gsub("[^/]*$", "") .. "../../contact/disc.lua"))
