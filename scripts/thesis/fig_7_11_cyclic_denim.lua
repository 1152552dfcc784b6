-- Fig. 7-11 of [williams2010]: denim pulled and let go along warp, weft and at 45 degrees, beside P(E) and the thesis' rules.
--
--   fabricsh scripts/thesis/fig_7_11_cyclic_denim.lua
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "cyclic.lua")("7-11", "denim", "fig_7_11")
