-- Fig. 7-17 of [williams2010]: strain across the pull against strain along it, muslin.
--
--   fabricsh scripts/thesis/fig_7_17_lateral_muslin.lua
-- warns: the card was tested to
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "lateral.lua")("7-17", "muslin", "fig_7_17")
