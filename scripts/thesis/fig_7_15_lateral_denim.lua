-- Fig. 7-15 of [williams2010]: strain across the pull against strain along it, denim.
--
--   fabricsh scripts/thesis/fig_7_15_lateral_denim.lua
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "lateral.lua")("7-15", "denim", "fig_7_15")
