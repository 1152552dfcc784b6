-- Fig. 7-30 of [williams2010]: equal biaxial strain of denim, 254 mm square, 30 mm.
--
--   fabricsh scripts/thesis/fig_7_30_biaxial_denim.lua
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "biaxial.lua")("7-30", "denim", "fig_7_30")
