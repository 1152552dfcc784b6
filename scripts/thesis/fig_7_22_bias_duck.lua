-- Fig. 7-22 of [williams2010]: bias test at 45 degrees to 20 mm, duck, ends free and clamped, and what the text's numbers imply.
--
--   fabricsh scripts/thesis/fig_7_22_bias_duck.lua
--
-- Some elements go beyond the tested strain, as the warning says:
-- warns: the card was tested to
-- warns: tangent NOT positive definite
-- warns: breaks the printed law
local here = arg[0]:gsub("[^/]*$", "")
dofile(here .. "chapter.lua")
return dofile(here .. "bias.lua")("7-22", "duck", "fig_7_22")
