-- Fig. 7-13 of [williams2010]: muslin pulled and let go along warp, weft and at 45 degrees, beside P(E) and the thesis' rules.
--
--   fabricsh scripts/thesis/fig_7_13_cyclic_muslin.lua
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
-- warns: the card was tested to
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "cyclic.lua")("7-13", "muslin", "fig_7_13")
