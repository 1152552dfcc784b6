-- Fig. 7-16 of [williams2010]: strain across the pull against strain along it, duck.
--
--   fabricsh scripts/thesis/fig_7_16_lateral_duck.lua
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "lateral.lua")("7-16", "duck", "fig_7_16")
