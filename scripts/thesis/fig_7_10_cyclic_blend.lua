-- Fig. 7-10 of [williams2010]: the blend pulled and let go along warp, weft and at 45 degrees, beside P(E) and the thesis' rules.
--
--   fabricsh scripts/thesis/fig_7_10_cyclic_blend.lua
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "cyclic.lua")("7-10", "blend", "fig_7_10")
