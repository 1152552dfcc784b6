-- Fig. 7-20 of [williams2010]: bias test at 45 degrees to 20 mm, blend, ends free and clamped, and what the text's numbers imply.
--
--   fabricsh scripts/thesis/fig_7_20_bias_blend.lua
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
-- warns: INSIDE the tested range
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "bias.lua")("7-20", "blend", "fig_7_20")
