-- Fig. 7-14 of [williams2010]: strain across the pull against strain along it, blend.
--
--   fabricsh scripts/thesis/fig_7_14_lateral_blend.lua
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "lateral.lua")("7-14", "blend", "fig_7_14")
