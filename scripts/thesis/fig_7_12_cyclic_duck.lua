-- Fig. 7-12 of [williams2010]: duck pulled and let go along warp, weft and at 45 degrees, beside P(E) and the thesis' rules.
--
--   fabricsh scripts/thesis/fig_7_12_cyclic_duck.lua
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
-- warns: the card was tested to
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "cyclic.lua")("7-12", "duck", "fig_7_12")
