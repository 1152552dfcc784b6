-- Fig. 7-29 of [williams2010]: equal biaxial strain of blend, 254 mm square, 30 mm.
--
--   fabricsh scripts/thesis/fig_7_29_biaxial_blend.lua
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "biaxial.lua")("7-29", "blend", "fig_7_29")
